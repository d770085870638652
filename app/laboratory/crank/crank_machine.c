#include "laboratory/crank/crank_machine.h"

#include <math.h>

#include "result/crank.h"

/* The main parameters come first. */
static const MachineLooks all_looks[] = {
    {"drive.frequency", "How fast it turns", "rpm", 60, 0, 0, 5, 25, 0, 0, false, true},
    {"joint.clearance", "Gap in the joint", "mm", 1e3, 0, 2, 0, 0.5e-3, 0, 0, false, true},
    {"joint.stiffness", "Contact stiffness", "MN/m", 1e-6, 0.01, 10, 0, 0, 0.1, 3, true, true},
    {"joint.damping", "Contact damping", NULL, 1, 0, 4, 0, 1000, 0, 3, false, true},
    {"joint.friction", "Friction", "", 1, 0, 0, 0, 0.3, 0, 0, false, true},
    {"coupler.length", "Coupler's length", "mm", 1e3, 0.9, 1.1, 0, 0, 0.95, 1.05, false, true},
    {"slider.mass", "Slider's mass", "g", 1e3, 0, 2, 0, 0.3, 0.5, 1.5, false, true},
    {"joint.release", "Contact release", NULL, 1, 0, 0, 0, 1, 0, 0, false, false},
    {"coupler.diameter", "Diameter", "mm", 1e3, 0.5, 2, 0, 0, 0, 0, false, false},
    {"coupler.modes", "Bending modes", NULL, 1, 0, 0, 0, 6, 0, 0, false, false},
    {"coupler.axial", "Axial modes", NULL, 1, 0, 0, 0, 1, 0, 0, false, false},
    {"coupler.damping_ratio", "How soon it dies away", "%", 100, 0, 3, 0, 0.1, 0, 0, false, false},
    {"coupler.end_mass", "Mass of the ball end", "g", 1e3, 0, 3, 0, 0.1, 0, 0, false, false},
    {"slider.damping", "Damping of the guide", NULL, 1, 0, 3, 0, 10, 0, 0, false, false},
    {"crank.radius", "Radius", "mm", 1e3, 0.5, 1.5, 0, 0, 0, 0, false, false},
    {"crank.offset_y", "Beside the guide", "mm", 1e3, 0, 1.5, 0, 0, 0, 0, false, false},
    {"crank.offset_z", "Over the guide", "mm", 1e3, 0, 1.5, 0, 0, 0, 0, false, false},
    {"crank.tilt", "Tilt", NULL, 1, 0, 0, -45, 45, 0, 0, false, false},
    {"support.mass", "Mass of the block", NULL, 1, 0.3, 3, 0, 0, 0, 0, false, false},
    {"support.stiffness_x", "Stiffness, along", "MN/m", 1e-6, 0.1, 10, 0, 0, 0, 0, true, false},
    {"support.stiffness_y", "Stiffness, across", "MN/m", 1e-6, 0.1, 10, 0, 0, 0, 0, true, false},
    {"support.stiffness_z", "Stiffness, upright", "MN/m", 1e-6, 0.1, 10, 0, 0, 0, 0, true, false},
    {"support.damping_ratio", "Damping", "%", 100, 0, 3, 0, 0.1, 0, 0, false, false},
    {"gravity.acceleration", "Acceleration", NULL, 1, 0, 0, 0, 20, 0, 0, false, false},
    {"run.transient_cycles", "Skipped revolutions", NULL, 1, 0, 0, 0, 500, 0, 0, false, false},
    {"run.cycles", "Recorded revolutions", NULL, 1, 0, 0, 10, 200, 0, 0, false, false},
};

/* Chosen for what their forces do; the window names a type only once it has determined it. */
static const MachinePreset presets[] = {
    {"500 rpm",
     "a small clearance, 0.02 mm: forces change little with the design",
     {{"drive.frequency", 500 / 60., false}, {"joint.clearance", 0.02e-3, false}}},
    {"600 rpm",
     "a middle clearance, 0.1 mm: periodic, but forces change steeply with the design",
     {{"drive.frequency", 10, false}, {"joint.clearance", 0.1e-3, false}}},
    {"700 rpm",
     "a large clearance, 0.25 mm: the ball rattles without a period",
     {{"drive.frequency", 700 / 60., false}, {"joint.clearance", 0.25e-3, false}}},
};

static const char *const groups[] = {"Drive", "Joint", "Coupler", "Slider", "Crank", "Support", "Gravity", "Run"};

static const char *const sweeps[MACHINE_SWEEPS] = {"from the start", "upwards and downwards"};

static const char *const over[] = {"drive.frequency", "joint.clearance", "coupler.length",
                                   "slider.mass",     "joint.stiffness", "joint.damping"};
static const char *const over_words[] = {
    "speed", "gap", "coupler's length", "slider's mass", "contact stiffness", "contact damping"};

static const char *const over_titles[] = {"speed",         "gap (clearance)",   "coupler's length",
                                          "slider's mass", "contact stiffness", "contact damping"};

/* Runs a crank from its start, where `task` is given with a confirmation of what is not periodic, and tells the facts.
 */
static bool respond(const Crank *crank, MachineFacts *facts, const SurvivalTask *task, const Stop *stop) {
    Tree tree = tree_of(crank);
    Response response;
    response_run(&response, crank_cycle_of(&tree), crank->transient_cycles, crank->cycles, NULL, stop);
    if (task)
        response_confirm(&response, crank_cycle_of(&tree), task);
    Text words = {0};
    result_crank_say(&words, crank, &tree, &response);
    *facts = (MachineFacts){response.verdict,
                            response.orbit.period,
                            response.peaks,
                            response.exponent,
                            result_crank_motion(crank, &response),
                            result_crank_forces(&tree, &response, crank_cycle_ideal_force(crank, stop)),
                            response_is_quick(&response),
                            words.text};
    response_clear(&response);
    return facts->verdict != RESPONSE_INTERRUPTED;
}

static bool decide(const Machine *machine, MachineFacts *facts, const Stop *stop) {
    return respond(&machine->crank, facts, NULL, stop);
}

static bool confirm(const Machine *machine, MachineFacts *facts, int jobs, const Stop *stop) {
    SurvivalTask task = survival_task(&crank_cycle, SURVIVAL_USUAL, jobs, stop);
    return respond(&machine->crank, facts, &task, stop) && !facts->quick;
}

static void be_thorough(Experiment *experiment) {
    crank_experiment_be_thorough(experiment, CRANK_LANES, CRANK_LANE_CYCLES);
}

static int cycles_of(const Machine *machine) {
    return machine->crank.transient_cycles + machine->crank.cycles;
}

static bool open_experiment(Experiment *experiment, const Machine *machine, Fault *fault) {
    (void)fault;
    crank_experiment_of(experiment, &machine->crank);
    return true;
}

static void run_on(const Experiment *experiment, const char *name, Trial *trials, size_t count, MachineCarry *carry,
                   const Stop *stop) {
    crank_experiment_run_on(experiment, name, trials, count, &carry->crank, stop);
}

static void clear_carry(MachineCarry *carry) {
    carry->crank.states = 0;
}

const MachineKind crank_machine = {
    .word = "crank",
    .cycle = "revolution",
    .from = "From its start",
    .hit = "push",
    .hits = "pushes",
    .peak = "hardest push (peak force)",
    .drive = "how fast it turns (speed of the crank)",
    .provenances = offsetof(Crank, provenance),
    .table = crank_table,
    .looks = all_looks,
    .look_count = sizeof all_looks / sizeof *all_looks,
    .groups = groups,
    .group_count = sizeof groups / sizeof *groups,
    .presets = presets,
    .preset_count = sizeof presets / sizeof *presets,
    .sweeps = sweeps,
    .sweeps_meaning =
        "the start of each value of \"All rhythms at a glance\" (orbit diagram): that of the file, or where "
        "the neighbouring value ended",
    .over = over,
    .over_words = over_words,
    .over_titles = over_titles,
    .over_count = sizeof over / sizeof *over,
    .steps = 121,
    .coarse = 8,
    .carried_steps = 61,
    .together = 1,
    .before_type = 31,
    .map = {{"drive.frequency", "speed", 5, 25, 13}, {"joint.clearance", "clearance", 0.02e-3, 0.5e-3, 9}},
    .window = crank_experiment_window,
    .window_count = CRANK_EXPERIMENT_WINDOW,
    .decide = decide,
    .confirm = confirm,
    .cycles = cycles_of,
    .lanes = CRANK_LANES,
    .open_experiment = open_experiment,
    .close_experiment = crank_experiment_close,
    .be_thorough = be_thorough,
    .run_on = run_on,
    .clear_carry = clear_carry,
};
