#include "lesson/names.h"

#include <string.h>

#include "experiment/beam_experiment.h"
#include "experiment/crank_experiment.h"
#include "lesson/difference.h"

enum { NAMES_MOST = 64 };

bool names_open_experiment(Experiment *experiment, const Lesson *lesson, const char *const *settings, size_t count,
                           Fault *fault) {
    if (lesson->laboratory == LESSON_BEAM) {
        if (!beam_experiment_open(experiment, lesson->file, settings, count, fault))
            return false;
        beam_experiment_be_thorough(experiment, BEAM_EXPERIMENT_LANES, BEAM_EXPERIMENT_CYCLES);
        return true;
    }
    if (!crank_experiment_open(experiment, lesson->file, settings, count, fault))
        return false;
    crank_experiment_be_thorough(experiment, 0, 0); /* what is asked in a lesson does not wait for a confirmation */
    return true;
}

void names_close_experiment(Experiment *experiment, const Lesson *lesson) {
    if (lesson->laboratory == LESSON_BEAM)
        beam_experiment_close(experiment);
    else
        crank_experiment_close(experiment);
}

bool names_open(Names *checker, const Lesson *lesson, const char *const *settings, size_t count, Fault *fault) {
    *checker = (Names){.experiment = {.kind = NULL}};
    return lesson->laboratory == LESSON_HOUSE
               ? plan_read(&checker->plan, lesson->file, settings, count, fault)
               : names_open_experiment(&checker->experiment, lesson, settings, count, fault);
}

void names_close(Names *checker, const Lesson *lesson) {
    plan_free(&checker->plan);
    if (checker->experiment.kind)
        names_close_experiment(&checker->experiment, lesson);
}

static bool is_number(const Parameter *row) {
    return row && (row->kind == PARAMETER_NUMBER || row->kind == PARAMETER_WHOLE);
}

size_t names_find_observable(const Experiment *experiment, const char *name) {
    size_t o = 0;
    while (o < experiment->observable_count && strcmp(experiment->observables[o].name, name) != 0)
        o++;
    return o;
}

/* Returns the unit of a number of the plan, "door.d3.width"; NULL: there is none of that name. */
static const char *plan_unit(const Plan *plan, const char *name) {
    Fault unused = {0};
    const void *object;
    const Parameter *row = strchr(name, '.') ? plan_parameter(plan, name, &object, "", &unused) : NULL;
    fault_clear(&unused);
    return is_number(row) ? row->unit : NULL;
}

static const char *house_unit(const Names *checker, Condition *condition, const JsonNode *node, Fault *fault) {
    const char *name = condition->measure_name, *names[NAMES_MOST];
    const char *unit = strcmp(name, NAMES_SHAKES_OUT) == 0 ? "1" : difference_unit(name);
    unit = unit ? unit : plan_unit(&checker->plan, name);
    if (unit)
        return unit;
    size_t count;
    const char *const *differences = difference_names(&count);
    memcpy(names, differences, count * sizeof *names);
    names[count++] = NAMES_SHAKES_OUT;
    return condition_find(condition, names, count, node, fault) ? condition->measure->unit : NULL;
}

const char *names_unit(const Names *checker, const Lesson *lesson, Condition *condition, const JsonNode *node,
                       Fault *fault) {
    if (lesson->laboratory == LESSON_HOUSE)
        return house_unit(checker, condition, node, fault);
    const Experiment *experiment = &checker->experiment;
    size_t o = names_find_observable(experiment, condition->measure_name);
    if (o < experiment->observable_count)
        return experiment->observables[o].unit;
    const Parameter *row = experiment->parameter(experiment->given, condition->measure_name);
    if (is_number(row))
        return row->unit;
    JsonNode name = json_member(node, "measure");
    json_fault(&name, fault,
               "unknown measure \"%.40s\", must be one of regular, period, peak_min, peak_max, "
               "peak_mean, lyapunov, or a number of the file",
               condition->measure_name);
    return NULL;
}
