#include "visual/study/advice.h"

#include <math.h>
#include <string.h>

/* The terms of one kind of experiment. */
typedef struct Terms {
    const char *kind;
    const char *headline[4];         /* by TypesKind */
    const char *regular, *irregular; /* beginnings of sentences */
    const char *unsure;
    const char *stays, *becomes_not; /* for "nothing changes with one number alone" */
    const char *again;               /* for places where it is regular again */
    const char *measure;
    const char *changes; /* the verb of a changing answer */
    const char *longer;  /* the remedy if the type is undecided */
} Terms;

static const Terms all_terms[] = {
    {.kind = "beam",
     .headline = {"The type is undecided", "Type I: run it here", "Type II: run it here only with close tolerances",
                  "Type III: do not run it here"},
     .regular = "It is periodic",
     .irregular = "It is not periodic",
     .unsure = "It is undecided whether it is periodic",
     .stays = "It stays periodic",
     .becomes_not = "It does not become periodic",
     .again = "it is periodic again",
     .measure = "the largest force",
     .changes = "has another period",
     .longer = "a larger run.transient_cycles may decide it"},
    {.kind = "house",
     .headline = {"The type is undecided", "Type I: this route can be relied on",
                  "Type II: this route depends on small changes", "Type III: do not rely on this route"},
     .regular = "Everybody gets out",
     .irregular = "Not everybody gets out",
     .unsure = "It is undecided whether everybody gets out",
     .stays = "Everybody gets out also",
     .becomes_not = "Not everybody gets out either",
     .again = "everybody gets out",
     .measure = "the time",
     .changes = "takes another route",
     .longer = "a larger run.until may decide it"},
};
enum { KINDS = sizeof all_terms / sizeof *all_terms };

static const Terms *find_terms(const Experiment *experiment) {
    for (size_t k = 0; k < KINDS; k++)
        if (strcmp(all_terms[k].kind, experiment->kind) == 0)
            return &all_terms[k];
    return &all_terms[0];
}

/* Returns "clearance" for "joint.clearance"; "door.d1.width" unchanged. */
static const char *short_name(const char *name) {
    const char *first = strchr(name, '.');
    return first && first == strrchr(name, '.') ? first + 1 : name;
}

/* Lengths below this are printed in mm. */
static const double SMALL_LENGTH = 0.5;

static void add_quantity(Text *text, const char *unit, double value) {
    bool small = strcmp(unit, "m") == 0 && fabs(value) < SMALL_LENGTH;
    text_format(text, "%.4g%s%s", small ? 1000 * value : value, strcmp(unit, "1") ? " " : "",
                small               ? "mm"
                : strcmp(unit, "1") ? unit
                                    : "");
}

/* Adds "clearance 0.1315 mm": a parameter and its value. */
static void add_value(Text *text, const Experiment *experiment, const char *name, double value) {
    text_format(text, "%s ", short_name(name));
    add_quantity(text, experiment->parameter(experiment->given, name)->unit, value);
}

static void add_measure(Text *text, const Experiment *experiment, double value) {
    text_format(text, "%.4g %s", value, experiment->observables[experiment->measure].unit);
}

/* The answer's sentence ------------------------------------------------------------------------------------------- */

/* Adds "here" or "at clearance 0.1257 mm". */
static void add_place(Text *text, const Types *types, const Experiment *experiment, size_t at) {
    const TypesPoint *point = &types->points[at];
    if (point->parameter == types->parameter_count) {
        text_add(text, "right here");
        return;
    }
    text_add(text, "at ");
    add_value(text, experiment, types->parameters[point->parameter].name, point->value);
}

/* Adds how many starts do so; `all` replaces the number if all do. */
static void add_starts(Text *text, size_t starts, const char *all) {
    if (starts < TYPES_STARTS)
        text_format(text, " from %zu of %d starts", starts, TYPES_STARTS);
    else
        text_format(text, " from %s of %d starts", all, TYPES_STARTS);
}

static void add_answers(Text *text, const Types *types, const Experiment *experiment, size_t at) {
    const TypesPoint *point = &types->points[at];
    for (size_t a = 0; a < point->answer_count; a++) {
        const TypesAnswer *answer = &point->answers[a];
        text_add(text, a == 0 ? "" : a + 1 < point->answer_count ? ", " : " or ");
        add_measure(text, experiment, answer->measure);
        if (experiment->periods)
            text_format(text, " (period %g)", answer->outcome);
        add_starts(text, answer->starts, "each");
    }
}

/* Adds "1 % more clearance is 7.3 % more of the largest force". */
static void add_sensitivity(Text *text, const Terms *terms, const TypesParameter *parameter) {
    if (isinf(parameter->sensitivity))
        text_format(text, "a change of 1 %% in %s decides whether there is any force at all",
                    short_name(parameter->name));
    else
        text_format(text, "1 %% more %s makes %s %.2g %% %s", short_name(parameter->name), terms->measure,
                    fabs(parameter->sensitivity), parameter->sensitivity < 0 ? "less" : "more");
}

static const TypesParameter *steepest(const Types *types) {
    const TypesParameter *most = NULL;
    for (size_t p = 0; p < types->parameter_count; p++) {
        const TypesParameter *parameter = &types->parameters[p];
        if (!isnan(parameter->sensitivity) && (!most || fabs(parameter->sensitivity) > fabs(most->sensitivity)))
            most = parameter;
    }
    return most;
}

static void add_reason(Text *text, const Types *types, const Experiment *experiment, const Terms *terms) {
    const TypesPoint *worst = &types->points[types->worst];
    switch (types->reason) {
    case TYPES_ALL_WELL:
        text_format(text, "%s with one answer within 1 %% of every number: ", terms->regular);
        add_measure(text, experiment, types->points[0].answers[0].measure);
        break;
    case TYPES_STEEP_ANSWER:
        text_format(text, "%s throughout, but steep: ", terms->regular);
        add_sensitivity(text, terms, steepest(types));
        break;
    case TYPES_SEVERAL:
        text_format(text, "%s throughout, but ", terms->regular);
        add_place(text, types, experiment, types->worst);
        if (worst->answer_count > 1)
            text_add(text, " the start decides: ");
        else
            text_format(text, " it %s: ", terms->changes);
        add_answers(text, types, experiment, types->worst);
        break;
    case TYPES_NOT_REGULAR:
        text_format(text, "%s ", terms->irregular);
        add_place(text, types, experiment, types->worst);
        text_add(text, ",");
        add_starts(text, worst->irregular, "any");
        break;
    case TYPES_FLIPS:
        text_format(text, "Its period doubles within 1 %% of here: ");
        add_place(text, types, experiment, types->worst);
        text_add(text, " ");
        add_answers(text, types, experiment, types->worst);
        break;
    case TYPES_UNDECIDED:
        text_format(text, "%s ", terms->unsure);
        add_place(text, types, experiment, types->worst);
        text_add(text, ",");
        add_starts(text, worst->undecided, "any");
        text_format(text, "; %s", types->stopped ? "it was stopped" : terms->longer);
        break;
    }
    text_add(text, ".\n");
}

/* Neighbours ------------------------------------------------------------------------------------------------------ */

/* Returns the nearer side of a parameter on which a change was found; NULL: none. */
static const Neighbour *nearer_side(const TypesParameter *parameter) {
    const Neighbour *below = parameter->below.found ? &parameter->below : NULL;
    const Neighbour *above = parameter->above.found ? &parameter->above : NULL;
    return !below || (above && above->share < -below->share) ? above : below;
}

/* Lists the parameters (indices) with such a side, the nearest first; returns their number. */
static size_t order_parameters(const Types *types, size_t order[TYPES_PARAMETERS_MOST]) {
    size_t count = 0;
    for (size_t p = 0; p < types->parameter_count; p++) {
        const Neighbour *side = nearer_side(&types->parameters[p]);
        size_t at = count;
        if (!side)
            continue;
        for (; at && fabs(nearer_side(&types->parameters[order[at - 1]])->share) > fabs(side->share); at--)
            order[at] = order[at - 1];
        order[at] = p;
        count++;
    }
    return count;
}

static void add_side(Text *text, const Experiment *experiment, const TypesParameter *parameter) {
    const Neighbour *side = nearer_side(parameter);
    add_value(text, experiment, parameter->name, side->value);
    text_format(text, " (%.3g %% %s)", 100 * fabs(side->share), side->share < 0 ? "below" : "above");
}

/* Returns the least distance searched on all sides, 1. */
static double least_reached(const Types *types) {
    double least = HUGE_VAL;
    for (size_t p = 0; p < types->parameter_count; p++)
        if (types->parameters[p].nominal != 0)
            least = fmin(least, fmin(types->parameters[p].below.reached, types->parameters[p].above.reached));
    return isinf(least) ? 0 : least;
}

static void add_found(Text *text, const Types *types, const Experiment *experiment, const size_t *order, size_t count) {
    for (size_t i = 0; i < count; i++) {
        text_add(text, i == 0 ? "" : i + 1 < count ? ", " : " or ");
        add_side(text, experiment, &types->parameters[order[i]]);
    }
}

static void add_names(Text *text, const Types *types) {
    for (size_t p = 0; p < types->parameter_count; p++)
        text_format(text, "%s%s",
                    p == 0                           ? ""
                    : p + 1 < types->parameter_count ? ", "
                                                     : " or ",
                    short_name(types->parameters[p].name));
}

static void add_neighbours(Text *text, const Types *types, const Experiment *experiment, const Terms *terms) {
    size_t order[TYPES_PARAMETERS_MOST], found = order_parameters(types, order);
    bool trouble = types->sought == NEIGHBOURS_TROUBLE;
    if (!types->parameter_count || (types->stopped && !found))
        return;
    if (!found) {
        text_format(text, "%s with one of these changed alone by up to %.3g %%: ",
                    trouble ? terms->stays : terms->becomes_not, 100 * least_reached(types));
        add_names(text, types);
    } else if (trouble) {
        text_add(text, "The nearest trouble is at ");
        add_found(text, types, experiment, order, 1);
        text_add(text, found > 1 ? "; then at " : "");
        add_found(text, types, experiment, order + 1, found - 1);
    } else {
        text_format(text, "With one number changed alone %s at ", terms->again);
        add_found(text, types, experiment, order, found);
    }
    text_add(text, ".\n");
}

static void add_basis(Text *text, const Types *types, const char *each) {
    if (each)
        text_format(text, "This rests on %zu runs of %s from %d starts within 1 %% of here", types->runs, each,
                    TYPES_STARTS);
    else
        text_format(text, "This rests on %zu runs from %d starts within 1 %% of here", types->runs, TYPES_STARTS);
    if (types->thorough)
        text_format(text, ", %zu of them repeated with the full analysis", types->thorough);
    if (types->neighbour_runs)
        text_format(text, ", and on %zu runs beyond, from %d starts", types->neighbour_runs, NEIGHBOURS_STARTS);
    text_format(text, "%s.\n", types->stopped ? "; it was stopped before it was complete" : "");
}

void advice_write(Text *text, const Types *types, const Experiment *experiment, const char *each) {
    const Terms *terms = find_terms(experiment);
    const TypesParameter *most = steepest(types);
    text_format(text, "%s. ", terms->headline[types->kind]);
    add_reason(text, types, experiment, terms);
    add_neighbours(text, types, experiment, terms);
    if (most && types->reason != TYPES_STEEP_ANSWER && most->sensitivity != 0) {
        text_add(text, "It depends most on the ");
        text_format(text, "%s: ", short_name(most->name));
        add_sensitivity(text, terms, most);
        text_add(text, ".\n");
    }
    add_basis(text, types, each);
}
