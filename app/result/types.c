#include "result/types.h"

#include <string.h>

#include "base/text.h"
#include "result/advice.h"

static const char *reason_name(TypesReason reason) {
    static const char *const names[] = {
        [TYPES_ALL_WELL] = "one answer",     [TYPES_STEEP_ANSWER] = "steep", [TYPES_SEVERAL] = "several answers",
        [TYPES_NOT_REGULAR] = "not regular", [TYPES_FLIPS] = "flips",        [TYPES_UNDECIDED] = "cannot be told",
        [TYPES_INTERRUPTED] = "interrupted"};
    return names[reason];
}

ResultTable result_types_kind(const Types *types) {
    ResultTable table = {.numbers = RESULT_SHORTEST};
    const char *kind = types_kind_name(types->kind);
    bool interrupted = types->kind == TYPES_KIND_INTERRUPTED;
    result_add(&table, (ResultRow){.key = "type", .text = kind});
    result_add(&table, (ResultRow){.label = "type", .text = types->kind == TYPES_UNRESOLVED ? "undecided" : kind});
    result_add(&table, (ResultRow){.key = "reason", .text = reason_name(types->reason)});
    result_add(
        &table,
        (ResultRow){.key = "worst", .kind = RESULT_COUNT, .number = (double)types->worst, .omitted = interrupted});
    result_add(&table, (ResultRow){.key = "answers",
                                   .label = "most answers at a point",
                                   .kind = RESULT_COUNT,
                                   .number = (double)types->answers,
                                   .omitted = interrupted});
    result_add(
        &table,
        (ResultRow){.key = "starts", .label = "starts at each point", .kind = RESULT_COUNT, .number = TYPES_STARTS});
    result_end(&table);
    return table;
}

/* Parameters ------------------------------------------------------------------------------------------------------ */

/* Lengths below this are read in mm. */
static const double SMALL_LENGTH = 0.5; /* m */

static const char *quantity(Arena *arena, const char *unit, double value) {
    if (strcmp(unit, "rpm") == 0)
        return text_in_arena(arena, "%.4g rpm (%.4g Hz)", EXPERIMENT_RPM * value, value);
    bool small = strcmp(unit, "m") == 0 && fabs(value) < SMALL_LENGTH;
    if (strcmp(unit, "1") == 0)
        return text_in_arena(arena, "%.4g", value);
    return small ? text_in_arena(arena, "%.4g mm", 1000 * value) : text_in_arena(arena, "%.4g %s", value, unit);
}

/* Returns the unit in which people read a parameter: of the speed of a shaft rpm, though its values are in Hz. */
static const char *read_in(const Experiment *experiment, const char *name) {
    return experiment_turns(experiment, name) ? "rpm" : experiment->parameter(experiment->given, name)->unit;
}

/* Adds the value at which things change on one side of a parameter, and as a share how far that is away. */
static void add_side(ResultTable *table, const Neighbour *side, const char *unit, bool above) {
    Arena *arena = &table->arena;
    const char *at = "interrupted";
    bool found = side->answer == NEIGHBOUR_FOUND;
    switch (side->answer) {
    case NEIGHBOUR_FOUND:
        at = text_in_arena(arena, "%s (%+.3g %%)", quantity(arena, unit, side->value), 100 * side->share);
        break;
    case NEIGHBOUR_NONE:
        at = text_in_arena(arena, "none within %.3g %%", 100 * side->reached);
        break;
    case NEIGHBOUR_INTERRUPTED:
        break;
    }
    result_add(table, (ResultRow){.key = above ? "above.at" : "below.at",
                                  .label = above ? "change above" : "change below",
                                  .kind = RESULT_NUMBER,
                                  .number = found ? side->value : NAN,
                                  .text = at});
    result_add(table, (ResultRow){.key = above ? "above.away" : "below.away",
                                  .kind = RESULT_NUMBER,
                                  .number = found ? side->share : NAN});
    result_add(
        table,
        (ResultRow){.key = above ? "above.looked" : "below.looked", .kind = RESULT_NUMBER, .number = side->reached});
}

static void add_parameter(ResultTable *table, const TypesParameter *parameter, const Experiment *experiment,
                          bool interrupted) {
    const char *unit = read_in(experiment, parameter->name);
    bool jumps = isinf(parameter->sensitivity);
    result_add(table, (ResultRow){.key = "name", .label = "parameter", .text = parameter->name});
    result_add(table,
               (ResultRow){.key = "unit", .text = experiment->parameter(experiment->given, parameter->name)->unit});
    result_add(table, (ResultRow){.key = "value",
                                  .label = "value",
                                  .kind = RESULT_NUMBER,
                                  .number = parameter->nominal,
                                  .text = quantity(&table->arena, unit, parameter->nominal)});
    result_add(table, (ResultRow){.key = "sensitivity",
                                  .label = "sensitivity",
                                  .kind = RESULT_NUMBER,
                                  .number = parameter->sensitivity,
                                  .text = jumps ? "jumps" : NULL,
                                  .significant = 2,
                                  .sign = true});
    result_add(table, (ResultRow){.key = "jumps", .kind = RESULT_FLAG, .number = jumps, .omitted = interrupted});
    add_side(table, &parameter->below, unit, false);
    add_side(table, &parameter->above, unit, true);
    result_end(table);
}

ResultTable result_types_parameters(const Types *types, const Experiment *experiment) {
    ResultTable table = {.numbers = RESULT_SHORTEST};
    for (size_t p = 0; p < types->parameter_count; p++)
        add_parameter(&table, &types->parameters[p], experiment, types->kind == TYPES_KIND_INTERRUPTED);
    return table;
}

/* Points ---------------------------------------------------------------------------------------------------------- */

static void add_point(ResultTable *table, const Types *types, const TypesPoint *point, const Experiment *experiment) {
    bool centre = point->parameter == types->parameter_count;
    const char *name = centre ? NULL : types->parameters[point->parameter].name;
    const char *unit = centre ? NULL : read_in(experiment, name);
    result_add(table, (ResultRow){.key = "parameter", .text = name});
    result_add(table, (ResultRow){.label = "point", .text = centre ? "centre" : name});
    result_add(table, (ResultRow){.key = "value",
                                  .label = "value",
                                  .kind = RESULT_NUMBER,
                                  .number = point->value,
                                  .text = centre ? NULL : quantity(&table->arena, unit, point->value)});
    result_add(table,
               (ResultRow){.key = "possible", .label = "in range", .kind = RESULT_FLAG, .number = point->possible});
    result_add(table, (ResultRow){.key = "irregular",
                                  .label = "starts that are not regular",
                                  .head = "not regular",
                                  .kind = RESULT_COUNT,
                                  .number = (double)point->irregular});
    result_add(table, (ResultRow){.key = "untold",
                                  .label = "undecided starts",
                                  .head = "undecided",
                                  .kind = RESULT_COUNT,
                                  .number = (double)point->undecided});
    result_end(table);
}

ResultTable result_types_points(const Types *types, const Experiment *experiment) {
    ResultTable table = {.numbers = RESULT_SHORTEST};
    for (size_t i = 0; i < types->point_count; i++)
        add_point(&table, types, &types->points[i], experiment);
    return table;
}

ResultTable result_types_answers(const TypesPoint *point, const Experiment *experiment) {
    ResultTable table = {.numbers = RESULT_SHORTEST};
    const Observable *outcome = &experiment->observables[experiment->outcome],
                     *measure = &experiment->observables[experiment->measure];
    for (size_t a = 0; a < point->answer_count; a++) {
        const TypesAnswer *answer = &point->answers[a];
        result_add(&table,
                   (ResultRow){
                       .key = outcome->name, .label = outcome->name, .kind = RESULT_NUMBER, .number = answer->outcome});
        result_add(&table, (ResultRow){.key = measure->name,
                                       .label = measure->name,
                                       .kind = RESULT_NUMBER,
                                       .number = answer->measure,
                                       .unit = measure->unit,
                                       .significant = 4});
        result_add(
            &table,
            (ResultRow){.key = "starts", .label = "starts", .kind = RESULT_COUNT, .number = (double)answer->starts});
        result_add(&table, (ResultRow){.key = "carried", .kind = RESULT_COUNT, .number = (double)answer->carried});
        result_end(&table);
    }
    return table;
}

/* Runs and advice ------------------------------------------------------------------------------------------------- */

static const char *advice_of(ResultTable *table, const Types *types, const Experiment *experiment, int cycles) {
    Text text = {0};
    advice_write(&text, types, experiment, cycles);
    const char *advice = arena_text(&table->arena, text.text);
    memory_free(text.text);
    return advice;
}

ResultTable result_types_basis(const Types *types, const Experiment *experiment, int cycles) {
    ResultTable table = {.numbers = RESULT_SHORTEST};
    const char *sought = types->sought == NEIGHBOURS_TROUBLE ? "trouble" : "regular";
    result_add(&table, (ResultRow){.key = "sought", .text = sought, .omitted = types->kind == TYPES_KIND_INTERRUPTED});
    result_add(&table,
               (ResultRow){.key = "runs", .label = "runs", .kind = RESULT_COUNT, .number = (double)types->runs});
    result_add(&table, (ResultRow){.key = "thorough",
                                   .label = "repeated with the full analysis",
                                   .kind = RESULT_COUNT,
                                   .number = (double)types->thorough});
    result_add(&table, (ResultRow){.key = "carried_runs",
                                   .kind = RESULT_COUNT,
                                   .number = (double)types->carried_runs,
                                   .omitted = types->carried_runs == 0});
    result_add(&table, (ResultRow){.key = "neighbour_runs",
                                   .label = "runs outside the window",
                                   .kind = RESULT_COUNT,
                                   .number = (double)types->neighbour_runs});
    result_add(&table,
               (ResultRow){.key = "stopped", .label = "stopped", .kind = RESULT_FLAG, .number = types->stopped});
    result_add(&table, (ResultRow){.key = "advice", .text = advice_of(&table, types, experiment, cycles)});
    result_end(&table);
    return table;
}
