#include "lesson/names.h"

#include <string.h>

#include "base/text.h"
#include "experiment/beam_experiment.h"
#include "experiment/crank_experiment.h"
#include "lesson/difference.h"
#include "space/outline.h"

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

/* Things ----------------------------------------------------------------------------------------------------------- */

enum { PARTS = 3, LISTS = 8, THING_NAME = 128 /* bytes */ };
static const char *const parts_of_window[PARTS] = {"answer", "timeline", "plots"};
static const char *const lists_of_house[LISTS] = {"walls", "doors",  "furniture", "rooms",
                                                  "exits", "people", "crowds",    "routes"};
static const char *const elements_of_house[LISTS] = {"wall", "door",   "furniture", "room",
                                                     "exit", "person", "crowd",     "route"};

/* Adds a fault if the name is none of the known ones (count). */
static void check_known(const char *name, const char *const *known, size_t count, const char *what,
                        const JsonNode *node, Fault *fault) {
    for (size_t i = 0; i < count; i++)
        if (strcmp(known[i], name) == 0)
            return;
    const char *nearest = text_nearest(name, known, count);
    if (nearest)
        json_fault(node, fault, "%s \"%.40s\", did you mean \"%s\"?", what, name, nearest);
    else
        json_fault(node, fault, "%s \"%.40s\"", what, name);
}

static const char *furniture_name(const Plan *plan, size_t piece, Arena *arena) {
    char name[THING_NAME];
    outline_name(plan, OWNER_FURNITURE, (int)piece, name, sizeof name);
    return arena_text(arena, name);
}

/* Lists the names of a house's things in the arena; returns how many. */
static size_t list_things(const Plan *plan, const char **names, Arena *arena) {
    size_t count = 0;
    for (size_t i = 0; i < plan->person_count; i++)
        names[count++] = text_in_arena(arena, "person %s", plan->people[i].id);
    for (size_t i = 0; i < plan->door_count; i++)
        names[count++] = text_in_arena(arena, "door %s", plan->doors[i].id);
    for (size_t i = 0; i < plan->furniture_count; i++)
        names[count++] = furniture_name(plan, i, arena);
    for (size_t i = 0; i < plan->wall_count; i++)
        names[count++] = text_in_arena(arena, "wall %s", plan->walls[i].id);
    for (size_t i = 0; i < plan->exit_count; i++)
        names[count++] = text_in_arena(arena, "exit %s", plan->exits[i].id);
    return count;
}

void names_check_thing(const Names *checker, const Lesson *lesson, const char *name, bool parts, const JsonNode *node,
                       Fault *fault) {
    const Plan *plan = &checker->plan;
    Arena arena = {0};
    bool house = lesson->laboratory == LESSON_HOUSE;
    size_t things =
        house ? plan->person_count + plan->door_count + plan->furniture_count + plan->wall_count + plan->exit_count : 0;
    const char **names = arena_allocate(&arena, (things + PARTS) * sizeof *names);
    size_t count = house ? list_things(plan, names, &arena) : 0;
    for (size_t p = 0; parts && p < PARTS; p++)
        names[count++] = parts_of_window[p];
    check_known(name, names, count, "nothing in the view is called", node, fault);
    arena_clear(&arena);
}

void names_check_lock(const Names *checker, const Lesson *lesson, const char *name, const JsonNode *node,
                      Fault *fault) {
    if (lesson->laboratory == LESSON_HOUSE)
        check_known(name, lists_of_house, LISTS, "a house has no list", node, fault);
    else if (!is_number(checker->experiment.parameter(checker->experiment.given, name)))
        json_fault(node, fault, "the machine has no number \"%.40s\"", name);
}

/* True if the setting changes a number of a list of the house. */
static bool is_of_list(const char *list, const char *setting) {
    size_t l = 0, length = strcspn(setting, ".");
    while (l < LISTS && strcmp(lists_of_house[l], list) != 0)
        l++;
    return l < LISTS && strncmp(elements_of_house[l], setting, length) == 0 && !elements_of_house[l][length];
}

const char *names_locked(const Lesson *lesson, const char *setting) {
    size_t length = strcspn(setting, "=");
    for (size_t l = 0; l < lesson->lock.count; l++) {
        const char *name = lesson->lock.at[l];
        bool same = strncmp(name, setting, length) == 0 && !name[length];
        if (lesson->laboratory == LESSON_HOUSE ? is_of_list(name, setting) : same)
            return name;
    }
    return NULL;
}
