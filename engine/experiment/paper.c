#include "experiment/paper.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/parallel.h"
#include "base/stop.h"
#include "base/text.h"
#include "beam/beam_cycle.h"
#include "experiment/beam_experiment.h"

/* Figures of the paper, as far as legible. */
#define PERIODIC_FREQUENCY 190.0 /* Hz */
#define CHAOTIC_FREQUENCY 300.0
#define NOMINAL_FREQUENCY 290.0
#define LONGER (284.0 / 281.2) /* of the length */
#define CHAOS_LEAST 300.0      /* N */
#define CHAOS_MOST 850.0
#define NOMINAL_PEAK 700.0
#define LONGER_PEAK 905.0
#define SWEEP_PEAK 1000.0
#define TIP_SPEED 0.6         /* m/s */
#define LONG_TRANSIENT 1000.0 /* cycles, half-life of chaos that a measurement would call chaotic */
#define BAD_FROM 160.0        /* Hz, of type III */
#define BAD_TO 300.0
#define QUIET_BELOW 130.0 /* Hz */

/* Largest relative difference of figures that agree: the paper's are read off pictures, or have lost digits. */
#define AGREES 0.10

/* Sizes of the studies. */
enum { SWEEP_STEPS = 301, LENGTH_STEPS = 61, MAP_FREQUENCIES = 111, MAP_CLEARANCES = 40 };
#define SWEEP_FROM 20.0 /* Hz */
#define SWEEP_TO 320.0
#define LENGTH_FROM 0.98 /* of the length */
#define LENGTH_TO 1.04
#define MAP_FROM 100.0      /* Hz */
#define CLEARANCE_FROM 0.05 /* of the clearance */
#define CLEARANCE_TO 2.0    /* the joint could be set to +-.25 mm */
#define PLANE_FROM 110.0    /* Hz, of the types over figure 9 */
#define PLANE_STEP 20.0
#define CURVE_STEPS 24  /* clearances of a curve of folds or flips */
#define SMOOTH 0.1      /* 1, largest change of a peak that grows smoothly, from one hertz to the next */
#define TYPES_FROM 40.0 /* Hz */
#define TYPES_STEP 20.0

/* Runs ------------------------------------------------------------------------------------------------------------ */

static void tell(const PaperOptions *options, const char *what) {
    if (options->progress)
        options->progress(options->context, what);
}

static bool stopped(const PaperOptions *options) {
    return stop_requested(options->stop);
}

typedef struct RunTask {
    Paper *paper;
    Rig rigs[PAPER_RUNS];
    const PaperOptions *options;
} RunTask;

static void make_run(void *context, size_t i) {
    RunTask *task = context;
    beam_cycle_respond(&task->paper->responses[i], &task->rigs[i], &task->paper->beams[i], NULL, task->options->stop);
}

static bool make_runs(Paper *paper, const PaperOptions *options, Fault *fault) {
    static const double frequencies[] = {PERIODIC_FREQUENCY, CHAOTIC_FREQUENCY, NOMINAL_FREQUENCY, NOMINAL_FREQUENCY};
    RunTask task = {.paper = paper, .options = options};
    size_t built = 0;
    tell(options, "runs at 190, 290 and 300 Hz");
    for (; built < PAPER_RUNS; built++) {
        Beam *beam = &paper->beams[built];
        *beam = paper->beam;
        beam->frequency = frequencies[built];
        beam->length *= built == PAPER_LONGER ? LONGER : 1;
        if (!rig_build(&task.rigs[built], beam, options->path, fault))
            break;
    }
    if (built == PAPER_RUNS)
        parallel_for(options->jobs, PAPER_RUNS, make_run, &task);
    if (built == PAPER_RUNS)
        tell(options, "whether chaos lasts");
    for (size_t i = 0; i < built && built == PAPER_RUNS; i++)
        response_confirm(&paper->responses[i], beam_cycle_of(&task.rigs[i]),
                         &(SurvivalTask){SURVIVAL_LANES, SURVIVAL_CYCLES, options->jobs, options->stop});
    for (size_t i = 0; i < built; i++)
        rig_clear(&task.rigs[i]);
    return built == PAPER_RUNS;
}

/* Studies --------------------------------------------------------------------------------------------------------- */

static void ask(Paper *paper, PaperStudy which, const Study *asked) {
    Study *study = &paper->studies[which];
    *study = *asked;
    study->experiment = &paper->experiments[which];
    study->runs = 1;
}

static void ask_all(Paper *paper) {
    const Beam *beam = &paper->beam;
    ask(paper, PAPER_FREQUENCIES,
        &(Study){.axes = {{"drive.frequency", SWEEP_FROM, SWEEP_TO, SWEEP_STEPS}},
                 .axis_count = 1,
                 .passes = {STUDY_RESET, STUDY_UP, STUDY_DOWN},
                 .pass_count = 3});
    ask(paper, PAPER_LENGTHS,
        &(Study){.axes = {{"beam.length", LENGTH_FROM * beam->length, LENGTH_TO * beam->length, LENGTH_STEPS}},
                 .axis_count = 1,
                 .passes = {STUDY_RESET, STUDY_UP},
                 .pass_count = 2});
    ask(paper, PAPER_MAP,
        &(Study){.axes = {{"drive.frequency", MAP_FROM, SWEEP_TO, MAP_FREQUENCIES},
                          {"joint.clearance", CLEARANCE_FROM * beam->clearance, CLEARANCE_TO * beam->clearance,
                           MAP_CLEARANCES}},
                 .axis_count = 2,
                 .passes = {STUDY_RESET},
                 .pass_count = 1});
}

static bool make_studies(Paper *paper, const PaperOptions *options, Fault *fault) {
    static const char *const names[] = {"peaks against frequency", "peaks against length",
                                        "map over frequency and clearance"};
    bool good = true;
    for (size_t i = 0; i < PAPER_STUDIES && good; i++)
        good =
            beam_experiment_of(&paper->experiments[i], i == PAPER_LENGTHS ? &paper->beams[PAPER_NOMINAL] : &paper->beam,
                               options->path, fault);
    if (!good)
        return false;
    ask_all(paper);
    for (size_t i = 0; i < PAPER_STUDIES && good; i++) {
        tell(options, names[i]);
        good = study_check(&paper->studies[i], fault);
        if (good) {
            study_begin(&paper->studies[i]);
            study_run(&paper->studies[i], &(StudyOptions){.jobs = options->jobs, .stop = options->stop});
        }
    }
    return good;
}

/* Classifies a variant of the beam. */
static bool make_type(Types *types, const Beam *beam, bool window_only, const PaperOptions *options, Fault *fault) {
    Experiment quick, thorough;
    if (!beam_experiment_of(&quick, beam, options->path, fault))
        return false;
    bool good = beam_experiment_of(&thorough, beam, options->path, fault);
    if (good) {
        beam_experiment_be_thorough(&thorough, BEAM_EXPERIMENT_LANES, BEAM_EXPERIMENT_CYCLES);
        good = types_classify(types,
                              &(TypesTask){.experiment = &quick,
                                           .thorough = &thorough,
                                           .names = beam_experiment_window,
                                           .name_count = BEAM_EXPERIMENT_WINDOW,
                                           .window_only = window_only,
                                           .jobs = options->jobs,
                                           .stop = options->stop},
                              fault);
        beam_experiment_close(&thorough);
    }
    beam_experiment_close(&quick);
    return good;
}

static bool make_types(Paper *paper, const PaperOptions *options, Fault *fault) {
    bool good = true;
    for (size_t i = 0; i < PAPER_TYPES && good && !stopped(options); i++) {
        Beam beam = paper->beam;
        paper->frequency[i] = beam.frequency = TYPES_FROM + TYPES_STEP * (double)i;
        tell(options, text_in_arena(&paper->arena, "types at %.0f Hz", beam.frequency));
        good = make_type(&paper->types[i], &beam, false, options, fault);
    }
    for (size_t i = 0; i < PAPER_LENGTH_TYPES && good && !stopped(options); i++) {
        Beam beam = paper->beams[PAPER_NOMINAL];
        double part = (double)i / (PAPER_LENGTH_TYPES - 1);
        paper->length[i] = beam.length *= LENGTH_FROM + (LENGTH_TO - LENGTH_FROM) * part;
        tell(options, text_in_arena(&paper->arena, "types at %.1f mm", 1000 * beam.length));
        good = make_type(&paper->length_types[i], &beam, true, options, fault);
    }
    return good;
}

/* Tells types over the plane of frequency and clearance by quick runs: a motion that is not periodic within its cycles
 * makes it type III. */
static bool make_plane(Paper *paper, const PaperOptions *options, Fault *fault) {
    static const double shares[PAPER_PLANE_CLEARANCES] = {0.5, 1, 1.5, 1.9};
    bool good = true;
    for (size_t c = 0; c < PAPER_PLANE_CLEARANCES && good; c++) {
        Experiment quick;
        Beam beam = paper->beam;
        paper->plane_clearance[c] = beam.clearance *= shares[c];
        tell(options, text_in_arena(&paper->arena, "types at a clearance of %.3f mm", 1000 * beam.clearance));
        for (size_t i = 0; i < PAPER_PLANE_FREQUENCIES && good && !stopped(options); i++) {
            Types types;
            paper->plane_frequency[i] = beam.frequency = PLANE_FROM + PLANE_STEP * (double)i;
            good = beam_experiment_of(&quick, &beam, options->path, fault);
            if (!good)
                break;
            good = types_classify(&types,
                                  &(TypesTask){.experiment = &quick,
                                               .names = beam_experiment_window,
                                               .name_count = BEAM_EXPERIMENT_WINDOW,
                                               .window_only = true,
                                               .jobs = options->jobs,
                                               .stop = options->stop},
                                  fault);
            paper->plane[c][i] = types.kind;
            beam_experiment_close(&quick);
        }
    }
    return good;
}

/* Returns the first run of the beam of the file that ends on a stable orbit, or PAPER_RUNS. */
static PaperRun find_orbit(const Paper *paper) {
    for (PaperRun i = PAPER_PERIODIC; i <= PAPER_NOMINAL; i++)
        if (paper->responses[i].orbit.period)
            return i;
    return PAPER_RUNS;
}

/* Follows the orbit of a run over the frequencies of the map, and its folds and flips over the clearances. */
static bool make_follow(Paper *paper, const PaperOptions *options, Fault *fault) {
    const BeamPlane plane = {"joint.clearance", CLEARANCE_FROM * paper->beam.clearance,
                             CLEARANCE_TO * paper->beam.clearance, CURVE_STEPS};
    BeamFamily family;
    paper->followed = find_orbit(paper);
    if (paper->followed == PAPER_RUNS || stopped(options))
        return true;
    const Orbit *orbit = &paper->responses[paper->followed].orbit;
    tell(options, "folds and flips");
    if (!beam_family_open(&family, &paper->beams[paper->followed], "drive.frequency", MAP_FROM, SWEEP_TO, options->path,
                          fault))
        return false;
    if (beam_follow_run(&paper->follow, &family, orbit->point, orbit->period, options->stop))
        beam_follow_curves(&paper->follow, &family, &plane, options->jobs, options->stop);
    beam_family_close(&family);
    return true;
}

/* Checks that the map's range applies: it is in fractions of the clearance. */
static bool check_beam(const Paper *paper, Fault *fault) {
    if (paper->beam.clearance <= 0)
        fault_add(fault, "%s: joint.clearance is 0: the paper's map needs a positive clearance", paper->path);
    return paper->beam.clearance > 0;
}

PaperAnswer paper_make(Paper *paper, const PaperOptions *options, Fault *fault) {
    *paper = (Paper){.path = options->path};
    bool good = beam_read(&paper->beam, options->path, options->settings, options->setting_count, fault) &&
                check_beam(paper, fault) && make_runs(paper, options, fault) && make_studies(paper, options, fault) &&
                make_types(paper, options, fault) && make_plane(paper, options, fault) &&
                make_follow(paper, options, fault);
    bool whole = good && !stopped(options);
    if (!whole)
        paper_clear(paper);
    return whole ? PAPER_MADE : good ? PAPER_INTERRUPTED : PAPER_FAULTY;
}

void paper_clear(Paper *paper) {
    for (size_t i = 0; i < PAPER_RUNS; i++)
        response_clear(&paper->responses[i]);
    for (size_t i = 0; i < PAPER_STUDIES; i++) {
        study_clear(&paper->studies[i]);
        if (paper->experiments[i].given)
            beam_experiment_close(&paper->experiments[i]);
    }
    beam_follow_clear(&paper->follow);
    beam_free(&paper->beam);
    arena_clear(&paper->arena);
    *paper = (Paper){.path = NULL};
}

/* Claims ---------------------------------------------------------------------------------------------------------- */

const char *paper_met_name(PaperMet met) {
    static const char *const names[] = {"met", "not met", "not told"};
    return names[met];
}

static bool agrees(double ours, double theirs) {
    return fabs(ours / theirs - 1) <= AGREES;
}

static PaperMet met_if(bool met) {
    return met ? PAPER_MET : PAPER_NOT_MET;
}

/* Return the largest peak of the orbit that a response is on or settles into, NAN without one, and its period. */
static double end_peak(const Response *response) {
    bool watched = response->survival.attractor_count > 0;
    if (response->verdict == RESPONSE_TRANSIENT)
        return watched ? response->survival.attractors[0].peak : (double)NAN;
    return response->verdict == RESPONSE_PERIODIC ? response->peaks.max : (double)NAN;
}

static size_t end_period(const Response *response) {
    return response->survival.attractor_count ? response->survival.attractors[0].period : response->orbit.period;
}

/* True if a motion is chaotic for as long as a measurement may take. */
static bool is_chaotic_long(const Response *response) {
    return response->verdict == RESPONSE_CHAOTIC ||
           (response->verdict == RESPONSE_TRANSIENT && response->survival.half_life.value > LONG_TRANSIENT);
}

static const char *say_response(Paper *paper, const Response *response) {
    switch (response->verdict) {
    case RESPONSE_PERIODIC:
        return text_in_arena(&paper->arena, "periodic, period %zu, %.0f N", response->orbit.period,
                             response->peaks.max);
    case RESPONSE_CHAOTIC:
        return text_in_arena(&paper->arena, "chaotic, exponent %+.2f a cycle, %.0f to %.0f N", response->exponent.value,
                             response->peaks.min, response->peaks.max);
    case RESPONSE_TRANSIENT:
        return text_in_arena(&paper->arena, "%.0f to %.0f N; transient, half-life %.0f cycles, then period %zu, %.0f N",
                             response->peaks.min, response->peaks.max, response->survival.half_life.value,
                             end_period(response), end_peak(response));
    default:
        return text_in_arena(&paper->arena, "%s, %.0f to %.0f N", response_verdict_name(response->verdict),
                             response->peaks.min, response->peaks.max);
    }
}

/* Compares a verdict with the claim; an undetermined verdict stays undetermined. */
static PaperMet met_verdict(const Response *response, ResponseVerdict verdict) {
    return !response_is_told(response->verdict) ? PAPER_NOT_TOLD : met_if(response->verdict == verdict);
}

static double tip_speed(const Response *response) {
    double most = 0;
    for (size_t row = 0; row < response->trace.rows; row++)
        most = fmax(most, fabs(trace_row(&response->trace, row)[BEAM_VELOCITY]));
    return most;
}

/* Returns the largest peak from rest over all frequencies, and its frequency. */
static double sweep_peak(const Paper *paper, double *frequency) {
    const Study *study = &paper->studies[PAPER_FREQUENCIES];
    double most = 0;
    for (size_t i = 0; i < study->axes[0].steps; i++) {
        double peak = study_trial(study, 0, 0, 0, i)->observed[BEAM_PEAK_MAX];
        if (peak > most) {
            most = peak;
            *frequency = study_value(&study->axes[0], i);
        }
    }
    return most;
}

/* Counts the irregular frequencies from rest below `below`, and all of them. */
static size_t count_irregular(const Paper *paper, double below, size_t *of) {
    const Study *study = &paper->studies[PAPER_FREQUENCIES];
    size_t count = 0;
    *of = 0;
    for (size_t i = 0; i < study->axes[0].steps && study_value(&study->axes[0], i) < below; i++, ++*of)
        count += study_trial(study, 0, 0, 0, i)->observed[BEAM_REGULAR] == 0;
    return count;
}

/* Returns text such as "III at 180, 200 Hz" for the frequencies that the paper calls type III, and the counts of
 * agreement. */
static const char *say_types(Paper *paper, size_t *met, size_t *all) {
    char text[256] = "";
    size_t used = 0;
    *met = *all = 0;
    for (size_t i = 0; i < PAPER_TYPES; i++) {
        if (paper->frequency[i] < BAD_FROM || paper->frequency[i] > BAD_TO)
            continue;
        ++*all;
        *met += paper->types[i].kind == TYPES_III;
        used += (size_t)snprintf(text + used, sizeof text - used, "%s%.0f Hz %s", used ? ", " : "", paper->frequency[i],
                                 types_kind_name(paper->types[i].kind));
    }
    return arena_text(&paper->arena, text);
}

/* Returns the share of the map's cells that are not periodic among those of one quadrant. */
static double wild_share(const Paper *paper, bool high_frequency, bool large_clearance) {
    const Study *study = &paper->studies[PAPER_MAP];
    size_t wild = 0, all = 0, columns = study->axes[0].steps, rows = study->axes[1].steps;
    for (size_t r = 0; r < rows; r++)
        for (size_t c = 0; c < columns; c++) {
            double regular = study_trial(study, 0, 0, r, c)->observed[BEAM_REGULAR];
            if ((2 * c >= columns) != high_frequency || (2 * r >= rows) != large_clearance || isnan(regular))
                continue;
            wild += regular == 0;
            all++;
        }
    return all ? (double)wild / (double)all : 0;
}

/* Returns the largest relative change of the peak from one frequency of the sweep to the next, within 1 % of where the
 * type is I, and counts the types I and II. */
static double largest_step(const Paper *paper, size_t *first, size_t *second) {
    const Study *study = &paper->studies[PAPER_FREQUENCIES];
    double most = 0;
    *first = *second = 0;
    for (size_t t = 0; t < PAPER_TYPES; t++) {
        *first += paper->types[t].kind == TYPES_I;
        *second += paper->types[t].kind == TYPES_II;
        for (size_t i = 0; i + 1 < study->axes[0].steps && paper->types[t].kind == TYPES_I; i++) {
            double low = study_value(&study->axes[0], i), high = study_value(&study->axes[0], i + 1);
            double from = study_trial(study, 0, 0, 0, i)->observed[BEAM_PEAK_MAX],
                   to = study_trial(study, 0, 0, 0, i + 1)->observed[BEAM_PEAK_MAX];
            if (low >= 0.99 * paper->frequency[t] && high <= 1.01 * paper->frequency[t] && from > 0 && to > 0)
                most = fmax(most, fabs(to / from - 1));
        }
    }
    return most;
}

void paper_claims(Paper *paper, PaperClaim claims[PAPER_CLAIMS]) {
    const Response *periodic = &paper->responses[PAPER_PERIODIC], *chaotic = &paper->responses[PAPER_CHAOTIC];
    const Response *nominal = &paper->responses[PAPER_NOMINAL], *longer = &paper->responses[PAPER_LONGER];
    const char *near = text_in_arena(&paper->arena, "within %.0f %%", 100 * AGREES);
    double ratio = chaotic->peaks.min > 0 ? chaotic->peaks.max / chaotic->peaks.min : (double)NAN, frequency = 0;
    double rise = longer->peaks.max / end_peak(nominal) - 1, speed = tip_speed(chaotic);
    double most = sweep_peak(paper, &frequency);
    size_t met_types, all_types, quiet_all, loud = count_irregular(paper, QUIET_BELOW, &quiet_all);
    const char *types = say_types(paper, &met_types, &all_types);
    size_t first, second;
    double step = largest_step(paper, &first, &second), corner = wild_share(paper, true, true);
    double others[] = {wild_share(paper, false, false), wild_share(paper, false, true), wild_share(paper, true, false)};
    double least = fmin(others[0], fmin(others[1], others[2])), greatest = fmax(others[0], fmax(others[1], others[2]));
    const PaperClaim made[PAPER_CLAIMS] = {
        {"periodic", "figure 2", "at 190 Hz the motion is periodic", "periodic", say_response(paper, periodic),
         met_verdict(periodic, RESPONSE_PERIODIC), "a stable orbit is certified"},
        {"chaotic", "figures 3 to 6", "at 300 Hz it is chaotic", "chaotic", say_response(paper, chaotic),
         met_verdict(chaotic, RESPONSE_CHAOTIC),
         "exponent above 0 by three errors, K above 0.8, and no settling in 64 x 20,000 cycles"},
        {"chaos-peaks", "text", "peaks in chaos at 300 Hz",
         text_in_arena(&paper->arena, "%.0f to %.0f N", CHAOS_LEAST, CHAOS_MOST),
         text_in_arena(&paper->arena, "%.0f to %.0f N in %d cycles", chaotic->peaks.min, chaotic->peaks.max,
                       paper->beam.cycles),
         met_if(agrees(chaotic->peaks.min, CHAOS_LEAST) && agrees(chaotic->peaks.max, CHAOS_MOST)), near},
        {"chaos-ratio", "text", "the largest is two or three times the smallest", "2 to 3",
         isfinite(ratio) ? text_in_arena(&paper->arena, "%.1f", ratio) : "no contact",
         met_if(ratio >= 2 - AGREES && ratio <= 3 + AGREES), "between them, to a tenth"},
        {"tip-speed", "figure 3", "largest speed of the tip at 300 Hz",
         text_in_arena(&paper->arena, "about %.1f m/s", TIP_SPEED), text_in_arena(&paper->arena, "%.2f m/s", speed),
         met_if(agrees(speed, TIP_SPEED)), near},
        {"nominal", "figure 10", "at 290 Hz, 281.2 mm long: periodic",
         text_in_arena(&paper->arena, "periodic, %.0f N", NOMINAL_PEAK), say_response(paper, nominal),
         met_if(agrees(end_peak(nominal), NOMINAL_PEAK)),
         text_in_arena(&paper->arena, "settles on an orbit, and %s", near)},
        {"longer", "figure 10", "1 % longer, 284 mm: chaotic, peaks a third higher",
         text_in_arena(&paper->arena, "chaotic, at most %.0f N, %+.0f %%", LONGER_PEAK,
                       100 * (LONGER_PEAK / NOMINAL_PEAK - 1)),
         isfinite(rise) ? text_in_arena(&paper->arena, "%s, %+.0f %%", say_response(paper, longer), 100 * rise)
                        : say_response(paper, longer),
         met_if(is_chaotic_long(longer) && agrees(longer->peaks.max, LONGER_PEAK) &&
                agrees(1 + rise, LONGER_PEAK / NOMINAL_PEAK)),
         text_in_arena(&paper->arena, "chaotic for %.0f cycles or more; peak and rise (as a ratio) %s", LONG_TRANSIENT,
                       near)},
        {"sweep-peak", "figure 8", "largest peak over the frequencies",
         text_in_arena(&paper->arena, "about %.0f N", SWEEP_PEAK),
         text_in_arena(&paper->arena, "%.0f N at %.0f Hz", most, frequency), met_if(agrees(most, SWEEP_PEAK)), near},
        {"quiet", "figure 8", "below 130 Hz no chaos is spoken of", "periodic",
         text_in_arena(&paper->arena, "not periodic at %zu of %zu frequencies", loud, quiet_all), met_if(loud == 0),
         "all periodic"},
        {"types", "figure 9", "type III from 160 to 300 Hz", "III throughout", types, met_if(met_types == all_types),
         "all of them"},
        {"corner", "figure 9", "a large clearance and a high frequency tend to chaos", "more chaos in that corner",
         text_in_arena(&paper->arena, "not periodic: %.0f %% there, %.0f to %.0f %% in the other quarters of the map",
                       100 * corner, 100 * least, 100 * greatest),
         met_if(corner > greatest), "more than in each other quarter"},
        {"smooth", "figures 7 to 9", "where the type is I, the peaks grow smoothly", "smoothly",
         first ? text_in_arena(&paper->arena,
                               "type I at %zu of %d frequencies, at most %.1f %% from one hertz to the "
                               "next",
                               first, PAPER_TYPES, 100 * step)
               : "no frequency of type I",
         first ? met_if(step <= SMOOTH) : PAPER_NOT_TOLD,
         text_in_arena(&paper->arena, "at most %.0f %% a hertz", 100 * SMOOTH)},
        {"type-two", "figure 9", "between them is type II: periodic, but it changes steeply", "II at some frequencies",
         text_in_arena(&paper->arena, "II at %zu of %d frequencies", second, PAPER_TYPES), met_if(second > 0),
         "at one frequency or more"},
    };
    memcpy(claims, made, sizeof made);
}
