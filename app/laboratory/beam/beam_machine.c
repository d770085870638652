#include "laboratory/beam/beam_machine.h"

#include "beam/beam_cycle.h"
#include "experiment/beam_experiment.h"
#include "laboratory/beam/lines.h"
#include "laboratory/machine/verdict.h"
#include "result/beam.h"

/* The main parameters come first. The orbit diagram over the frequency covers the published one, figure 8, and the
 * range below it. */
static const MachineLooks all_looks[] = {
    {"drive.frequency", "How fast to shake", NULL, 1, 0, 0, 20, 400, 1 / 15., 16 / 15., false, true},
    {"drive.force", "How hard", NULL, 1, 0, 2, 0, 0, 0.1, 2, false, true},
    {"joint.clearance", "Gap in the joint", "mm", 1e3, 0, 2, 0, 0.25e-3, 0, 2, false, true},
    {"beam.length", "Length of the beam", "mm", 1e3, 0.9, 1.1, 0, 0, 0.95, 1.05, false, true},
    {"joint.stiffness", "Contact stiffness", "MN/m", 1e-6, 0.01, 100, 0, 0, 0.1, 3, true, true},
    {"joint.damping", "Contact damping", NULL, 1, 0, 4, 0, 1000, 0, 3, false, true},
    {"joint.release", "Contact release", NULL, 1, 0, 0, 0, 1, 0, 0, false, true},
    {"beam.width", "Width", "mm", 1e3, 0.5, 2, 0, 0, 0, 0, false, false},
    {"beam.thickness", "Thickness", "mm", 1e3, 0.8, 1.25, 0, 0, 0, 0, false, false},
    {"beam.youngs_modulus", "Young's modulus", "GPa", 1e-9, 0.5, 2, 0, 0, 0, 0, false, false},
    {"beam.density", "Density", NULL, 1, 0.5, 2, 0, 0, 0, 0, false, false},
    {"beam.damping_ratio", "How soon it dies away", "%", 100, 0, 3, 0, 0.1, 0, 0, false, false},
    {"beam.modes", "Natural modes", NULL, 1, 0, 0, 1, 24, 0, 0, false, false},
    {"beam.elements", "Finite elements", NULL, 1, 0, 0, 8, 60, 0, 0, false, false},
    {"beam.tip_mass", "Mass at the tip", "g", 1e3, 0, 3, 0, 0.2, 0, 0, false, false},
    {"pivot.position", "Place", "mm", 1e3, 0, 0, 0, 0.1, 0, 0, false, false},
    {"pivot.translational_stiffness", "Stiffness", "MN/m", 1e-6, 0.1, 10, 0, 0, 0, 0, true, false},
    {"pivot.rotational_stiffness", "Rotational stiffness", NULL, 1, 0, 3, 0, 100, 0, 0, false, false},
    {"shaker.position", "Place", "mm", 1e3, 0.5, 1.5, 0, 0, 0, 0, false, false},
    {"shaker.moving_mass", "Moving mass", "g", 1e3, 0, 3, 0, 0.1, 0, 0, false, false},
    {"shaker.stiffness", "Stiffness", "kN/m", 1e-3, 0, 3, 0, 1e5, 0, 0, false, false},
    {"shaker.damping", "Damping", NULL, 1, 0, 3, 0, 50, 0, 0, false, false},
    {"run.transient_cycles", "Skipped cycles", NULL, 1, 0, 0, 0, 2000, 0, 0, false, false},
    {"run.cycles", "Recorded cycles", NULL, 1, 0, 0, 10, 1000, 0, 0, false, false},
};

/* The published cases; the type is added to a preset's name once it is determined. */
static const MachinePreset presets[] = {
    {"160 Hz", "the lower end of the published sweeps", {{"drive.frequency", 160, false}}},
    {"190 Hz", "the published periodic case", {{"drive.frequency", 190, false}}},
    {"245 Hz", "near the resonance, where forces change fast", {{"drive.frequency", 245, false}}},
    {"290 Hz", "the case of the published longer beam, before it is made longer", {{"drive.frequency", 290, false}}},
    {"300 Hz", "the published chaotic case", {{"drive.frequency", 300, false}}},
    {"290 Hz, 1 % longer",
     "the beam is made 1 % longer at 290 Hz",
     {{"drive.frequency", 290, false}, {"beam.length", 1.01, true}}},
};

static const char *const groups[] = {"Drive", "Joint", "Beam", "Pivot", "Shaker", "Run"};

static const char *const sweeps[MACHINE_SWEEPS] = {"from rest", "upwards and downwards"};

static const char *const over[] = {"drive.frequency", "drive.force",     "joint.clearance",
                                   "beam.length",     "joint.stiffness", "joint.damping"};
static const char *const over_words[] = {"shaker frequency", "shaker force",      "gap",
                                         "length",           "contact stiffness", "contact damping"};

static const char *const over_titles[] = {"shaker (excitation frequency)",
                                          "shaker force",
                                          "gap (clearance)",
                                          "length",
                                          "contact stiffness",
                                          "contact damping"};

/* Runs a beam from rest, where `task` is given with a confirmation of what is not periodic, and tells the facts. */
static bool respond(const Beam *beam, MachineFacts *facts, const SurvivalTask *task, const Stop *stop) {
    Rig rig;
    Fault fault = {0};
    if (!rig_build(&rig, beam, beam->name, &fault)) {
        fault_clear(&fault);
        return false;
    }
    Response response;
    beam_cycle_respond(&response, &rig, beam, NULL, stop);
    if (task)
        response_confirm(&response, beam_cycle_of(&rig), task);
    *facts = (MachineFacts){response.verdict,
                            response.orbit.period,
                            response.peaks,
                            response.exponent,
                            result_beam_motion(beam, &response),
                            result_beam_forces(&rig, &response),
                            response_is_quick(&response),
                            NULL};
    response_clear(&response);
    rig_clear(&rig);
    return facts->verdict != RESPONSE_INTERRUPTED;
}

static bool decide(const Machine *machine, MachineFacts *facts, const Stop *stop) {
    return respond(&machine->beam, facts, NULL, stop);
}

static bool confirm(const Machine *machine, MachineFacts *facts, int jobs, const Stop *stop) {
    SurvivalTask task = {SURVIVAL_LANES, SURVIVAL_CYCLES, jobs, stop};
    return respond(&machine->beam, facts, &task, stop) && !facts->quick;
}

static void be_thorough(Experiment *experiment) {
    beam_experiment_be_thorough(experiment, BEAM_EXPERIMENT_LANES, BEAM_EXPERIMENT_CYCLES);
}

static int cycles_of(const Machine *machine) {
    return machine->beam.transient_cycles + machine->beam.cycles;
}

static bool open_experiment(Experiment *experiment, const Machine *machine, Fault *fault) {
    return beam_experiment_of(experiment, &machine->beam, machine->beam.name, fault);
}

static void run_on(const Experiment *experiment, const char *name, Trial *trials, size_t count, MachineCarry *carry,
                   const Stop *stop) {
    beam_experiment_run_on(experiment, name, trials, count, &carry->beam, stop);
}

static void clear_carry(MachineCarry *carry) {
    beam_carry_clear(&carry->beam);
}

const MachineKind beam_machine = {
    .word = "beam",
    .cycle = "cycle",
    .from = "From rest",
    .hit = "hit",
    .hits = "hits",
    .peak = "hardest hit (peak force)",
    .drive = "how fast it is shaken (excitation)",
    .provenances = offsetof(Beam, provenance),
    .table = beam_table,
    .looks = all_looks,
    .look_count = sizeof all_looks / sizeof *all_looks,
    .groups = groups,
    .group_count = sizeof groups / sizeof *groups,
    .presets = presets,
    .preset_count = sizeof presets / sizeof *presets,
    .sweeps = sweeps,
    .sweeps_meaning = "the start of each value of \"All rhythms at a glance\" (orbit diagram): at rest, or where the "
                      "neighbouring value ended",
    .over = over,
    .over_words = over_words,
    .over_titles = over_titles,
    .over_count = sizeof over / sizeof *over,
    .steps = BEAM_SWEEP_STEPS,
    .coarse = BEAM_SWEEP_COARSE,
    .carried_steps = BEAM_SWEEP_CARRIED_STEPS,
    .together = 16,
    .before_type = 121,
    .window = beam_experiment_window,
    .window_count = BEAM_EXPERIMENT_WINDOW,
    .decide = decide,
    .confirm = confirm,
    .cycles = cycles_of,
    .lanes = SURVIVAL_LANES,
    .open_experiment = open_experiment,
    .close_experiment = beam_experiment_close,
    .be_thorough = be_thorough,
    .run_on = run_on,
    .clear_carry = clear_carry,
    .follow = beam_lines_follow,
    .bands = MACHINE_BANDS_MOST,
};
