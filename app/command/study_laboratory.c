#include "command/study_laboratory.h"

#include <string.h>

#include "beam/beam_cycle.h"
#include "command/house_file.h"
#include "crank/crank_cycle.h"
#include "cycle/survival.h"
#include "experiment/beam_experiment.h"
#include "experiment/crank_experiment.h"
#include "experiment/house_experiment.h"
#include "laboratory/shipped.h"
#include "report/report_lines.h"
#include "result/census.h"
#include "result/source_line.h"

/* Adds an error when the command line has an option for houses only. */
static bool refuse_foreign(const Options *options, const char *what, Fault *fault) {
    const char *foreign = options->route                      ? "--route"
                          : options->driving >= 0             ? "--driving"
                          : options->study.shakes             ? "--shake"
                          : options->drivers                  ? "--drivers"
                          : options_given(options, "--until") ? "--until"
                                                              : NULL;
    if (foreign)
        fault_add(fault, "clearance: %s is for houses, %s is a %s", foreign, options->files[0], what);
    return foreign != NULL;
}

static bool open_beam(Experiment *experiment, const Options *options, Fault *fault) {
    if (refuse_foreign(options, "beam", fault) ||
        !beam_experiment_open(experiment, options->files[0], options->settings, options->setting_count, fault))
        return false;
    SurvivalTask watch = survival_task(&beam_cycle, options->lanes, 1, NULL);
    if (options->thorough)
        beam_experiment_be_thorough(experiment, watch.lanes, watch.cycles);
    return true;
}

static bool open_crank(Experiment *experiment, const Options *options, Fault *fault) {
    if (refuse_foreign(options, "crank", fault) ||
        !crank_experiment_open(experiment, options->files[0], options->settings, options->setting_count, fault))
        return false;
    SurvivalTask watch = survival_task(&crank_cycle, options->lanes, 1, NULL);
    if (options->thorough)
        crank_experiment_be_thorough(experiment, watch.lanes, watch.cycles);
    return true;
}

/* True if the runs of a point are of one house: a shake or a spread makes each run another one, whose grade costs more
 * than the run. Types tell runs by their times. */
static bool has_grades(const Options *options) {
    return !options->study.shakes && !options->study.spread_count && !options->types;
}

static bool open_house(Experiment *experiment, const Options *options, Fault *fault) {
    if (options->thorough) {
        fault_add(fault, "clearance: --thorough is for beams and cranks, %s is a house", options->files[0]);
        return false;
    }
    HouseOptions house_options = {.profiles = shipped_places()->profiles,
                                  .settings = options->settings,
                                  .setting_count = options->setting_count,
                                  .seed = options->seed,
                                  .driving = options->driving,
                                  .shake = options->study.shakes > 0};
    if (!house_experiment_open(experiment, options->files[0], &house_options, options->route, fault))
        return false;
    const Plan *plan = &house_experiment_house(experiment)->plan;
    bool driven = options->drivers || (plan->drivers.count && !options->study.runs && !options->study.shakes);
    Population population = {0};
    bool good = !driven || house_file_population(&population, options, plan, fault);
    if (good && driven)
        house_experiment_drive(experiment, &population);
    else if (!good)
        house_experiment_close(experiment);
    population_free(&population);
    if (good && has_grades(options))
        house_experiment_grade(experiment, CENSUS_FEW);
    return good;
}

static void type_beam(Experiment *experiment) {
    beam_experiment_be_thorough(experiment, BEAM_EXPERIMENT_LANES, BEAM_EXPERIMENT_CYCLES);
}

static void type_crank(Experiment *experiment) {
    crank_experiment_be_thorough(experiment, CRANK_LANES, CRANK_LANE_CYCLES);
}

/* Reads the file once more, for the sources of its numbers. */
static bool read_beam(Beam *beam, const Options *options) {
    Fault fault = {0};
    *beam = (Beam){.name = NULL};
    bool good = beam_read(beam, options->files[0], options->settings, options->setting_count, &fault);
    fault_clear(&fault);
    return good;
}

static bool read_crank(Crank *crank, const Options *options) {
    Fault fault = {0};
    *crank = (Crank){.name = NULL};
    bool good = crank_read(crank, options->files[0], options->settings, options->setting_count, &fault);
    fault_clear(&fault);
    return good;
}

static void add_beam_numbers(Document *document, const void *options) {
    Beam beam;
    if (!read_beam(&beam, options))
        return;
    report_lines_add_numbers(document, beam_table(), &beam, beam.provenance);
    beam_free(&beam);
}

static void add_crank_numbers(Document *document, const void *options) {
    Crank crank;
    if (!read_crank(&crank, options))
        return;
    report_lines_add_numbers(document, crank_table(), &crank, crank.provenance);
    crank_free(&crank);
}

static const char *beam_source(const Options *options, const Experiment *experiment, Arena *arena) {
    (void)experiment;
    Beam beam;
    if (!read_beam(&beam, options))
        return NULL;
    const char *line = source_line_beam(&beam, arena);
    beam_free(&beam);
    return line;
}

static const char *crank_source(const Options *options, const Experiment *experiment, Arena *arena) {
    (void)experiment;
    Crank crank;
    if (!read_crank(&crank, options))
        return NULL;
    const char *line = source_line_crank(&crank, arena);
    crank_free(&crank);
    return line;
}

static const char *house_source(const Options *options, const Experiment *experiment, Arena *arena) {
    (void)options;
    return source_line_house(&house_experiment_house(experiment)->plan, arena);
}

static const StudyLaboratory laboratories[] = {
    {beam_is_file, open_beam, beam_experiment_close, add_beam_numbers, beam_source, type_beam},
    {crank_is_file, open_crank, crank_experiment_close, add_crank_numbers, crank_source, type_crank},
    {NULL, open_house, house_experiment_close, NULL, house_source, NULL},
};

size_t study_laboratory_drivers(const Options *options, const Experiment *experiment) {
    bool driven = experiment->chance && strcmp(experiment->chance, "drivers") == 0;
    return driven ? house_file_drivers(options, &house_experiment_house(experiment)->plan) : 0;
}

const StudyLaboratory *study_laboratory_open(Experiment *experiment, const Options *options, Fault *fault) {
    const StudyLaboratory *laboratory = laboratories;
    while (laboratory->is_file && !laboratory->is_file(options->files[0]))
        laboratory++;
    return laboratory->open(experiment, options, fault) ? laboratory : NULL;
}
