#include "result/advice.h"

#include <math.h>
#include <string.h>

/* Sentences about the runs from all starts, or from some of them, at the centre of the window or at another point. */
typedef struct StartSentences {
    const char *all_here;  /* number of starts */
    const char *some_here; /* number, number of all */
    const char *all_at;    /* point, number of all */
    const char *some_at;   /* point, number, number of all */
} StartSentences;

/* Sentences about the sensitivity to a parameter. */
typedef struct SlopeSentences {
    const char *more, *less; /* parameter, % */
    const char *jumps;       /* parameter: the measure is 0 on one side */
} SlopeSentences;

/* The sentences for one kind of experiment; what they take is named in the order in which they take it. */
typedef struct Sentences {
    const char *kind;
    const char *headline[5];      /* by TypesKind */
    const char *one_answer;       /* measure */
    const char *steep;            /* a sentence about the sensitivity follows */
    const char *start_decides;    /* answers */
    const char *start_decides_at; /* point, answers */
    const char *changes;          /* answers */
    const char *changes_at;       /* point, answers */
    const char *answer_of_all;    /* of a list: measure, number of starts, words of the outcome */
    const char *answer_of_some;   /* of a list: measure, number of starts, number of all, words of it */
    StartSentences irregular, undecided;
    const char *remedy;
    SlopeSentences slope, steepest;
    const char *stays;       /* %, parameters */
    const char *becomes_not; /* %, parameters */
    const char *regular_at;  /* points */
} Sentences;

static const Sentences all_sentences[] = {
    {.kind = "beam",
     .headline = {"The type is undecided.", "Type I: run it here.", "Type II: run it here only with close tolerances.",
                  "Type III: do not run it here.", "The search for the type was interrupted."},
     .one_answer = "It is periodic with one answer within 1 %% of every number: %s.",
     .steep = "It is periodic throughout, but its largest force changes steeply.",
     .start_decides = "It is periodic throughout, but right here the start decides: %s.",
     .start_decides_at = "It is periodic throughout, but at %s the start decides: %s.",
     .changes = "It is regular throughout, but right here it moves otherwise: %s.",
     .changes_at = "It is regular throughout, but at %s it moves otherwise: %s.",
     .answer_of_all = "%1$s (%3$s) from each of %2$d starts",
     .answer_of_some = "%1$s (%4$s) from %2$zu of %3$d starts",
     .irregular = {"It is not periodic right here, from any of %d starts.",
                   "It is not periodic right here, from %zu of %d starts.",
                   "It is not periodic at %s, from any of %d starts.",
                   "It is not periodic at %s, from %zu of %d starts."},
     .undecided = {"It is undecided whether it is periodic right here, from any of %d starts.",
                   "It is undecided whether it is periodic right here, from %zu of %d starts.",
                   "It is undecided whether it is periodic at %s, from any of %d starts.",
                   "It is undecided whether it is periodic at %s, from %zu of %d starts."},
     .remedy = "clearance run says what was tried there.",
     .slope = {"1 %% more %s makes the largest force %.2g %% larger.",
               "1 %% more %s makes the largest force %.2g %% smaller.",
               "A change of 1 %% in %s decides whether there is any force at all."},
     .steepest = {"It depends most on %s: 1 %% more makes the largest force %.2g %% larger.",
                  "It depends most on %s: 1 %% more makes the largest force %.2g %% smaller.",
                  "It depends most on %s: a change of 1 %% decides whether there is any force at all."},
     .stays = "It stays periodic with one of these changed alone by up to %.3g %%: %s.",
     .becomes_not = "It does not become periodic with one of these changed alone by up to %.3g %%: %s.",
     .regular_at = "With one number changed alone it is periodic again at %s."},
    {.kind = "crank",
     .headline = {"The type is undecided.", "Type I: run it here.", "Type II: run it here only with close tolerances.",
                  "Type III: do not run it here.", "The search for the type was interrupted."},
     .one_answer = "Its revolutions repeat, with one answer within 1 %% of every number: %s.",
     .steep = "Its revolutions repeat throughout, but the largest joint force changes steeply.",
     .start_decides = "Its revolutions repeat throughout, but right here the start decides: %s.",
     .start_decides_at = "Its revolutions repeat throughout, but at %s the start decides: %s.",
     .changes = "It is regular throughout, but right here it moves otherwise: %s.",
     .changes_at = "It is regular throughout, but at %s it moves otherwise: %s.",
     .answer_of_all = "%1$s (%3$s) from each of %2$d starts",
     .answer_of_some = "%1$s (%4$s) from %2$zu of %3$d starts",
     .irregular = {"Its revolutions do not repeat right here, from any of %d starts.",
                   "Its revolutions do not repeat right here, from %zu of %d starts.",
                   "Its revolutions do not repeat at %s, from any of %d starts.",
                   "Its revolutions do not repeat at %s, from %zu of %d starts."},
     .undecided = {"It is undecided whether its revolutions repeat right here, from any of %d starts.",
                   "It is undecided whether its revolutions repeat right here, from %zu of %d starts.",
                   "It is undecided whether its revolutions repeat at %s, from any of %d starts.",
                   "It is undecided whether its revolutions repeat at %s, from %zu of %d starts."},
     .remedy = "clearance run says what was tried there; a larger run.transient_cycles may tell.",
     .slope = {"1 %% more %s makes the largest joint force %.2g %% larger.",
               "1 %% more %s makes the largest joint force %.2g %% smaller.",
               "A change of 1 %% in %s decides whether there is any force at all."},
     .steepest = {"It depends most on %s: 1 %% more makes the largest joint force %.2g %% larger.",
                  "It depends most on %s: 1 %% more makes the largest joint force %.2g %% smaller.",
                  "It depends most on %s: a change of 1 %% decides whether there is any force at all."},
     .stays = "Its revolutions still repeat with one of these changed alone by up to %.3g %%: %s.",
     .becomes_not = "Its revolutions do not repeat either with one of these changed alone by up to %.3g %%: %s.",
     .regular_at = "With one number changed alone its revolutions repeat again at %s."},
    {.kind = "house",
     .headline = {"The type is undecided.", "Type I: this route can be relied on.",
                  "Type II: this route depends on small changes.", "Type III: do not rely on this route.",
                  "The search for the type was interrupted."},
     .one_answer = "All people leave, with one answer within 1 %% of every number: %s.",
     .steep = "All people leave throughout, but the time changes steeply.",
     .start_decides = "All people leave throughout, but right here the start decides: %s.",
     .start_decides_at = "All people leave throughout, but at %s the start decides: %s.",
     .changes = "All people leave throughout, but right here by another route: %s.",
     .changes_at = "All people leave throughout, but at %s by another route: %s.",
     .answer_of_all = "%s from each of %d starts",
     .answer_of_some = "%s from %zu of %d starts",
     .irregular = {"Not all people leave right here, from any of %d starts.",
                   "Not all people leave right here, from %zu of %d starts.",
                   "Not all people leave at %s, from any of %d starts.",
                   "Not all people leave at %s, from %zu of %d starts."},
     .undecided = {"It is undecided whether all people leave right here, from any of %d starts.",
                   "It is undecided whether all people leave right here, from %zu of %d starts.",
                   "It is undecided whether all people leave at %s, from any of %d starts.",
                   "It is undecided whether all people leave at %s, from %zu of %d starts."},
     .remedy = "A larger run.until may decide it.",
     .slope = {"1 %% more %s makes the time %.2g %% longer.", "1 %% more %s makes the time %.2g %% shorter.",
               "A change of 1 %% in %s decides whether it takes any time at all."},
     .steepest = {"It depends most on %s: 1 %% more makes the time %.2g %% longer.",
                  "It depends most on %s: 1 %% more makes the time %.2g %% shorter.",
                  "It depends most on %s: a change of 1 %% decides whether it takes any time at all."},
     .stays = "All people also leave with one of these changed alone by up to %.3g %%: %s.",
     .becomes_not = "Not all people leave with one of these changed alone by up to %.3g %% either: %s.",
     .regular_at = "With one number changed alone all people leave at %s."},
};
enum { KINDS = sizeof all_sentences / sizeof *all_sentences };

static const Sentences *find_sentences(const Experiment *experiment) {
    for (size_t k = 0; k < KINDS; k++)
        if (strcmp(all_sentences[k].kind, experiment->kind) == 0)
            return &all_sentences[k];
    return &all_sentences[0];
}

/* The text that is written, and its subject. */
typedef struct Advice {
    Text *text;
    const Types *types;
    const Experiment *experiment;
    const Sentences *sentences;
    Arena arena; /* of the names, numbers and lists in the sentences */
} Advice;

/* Names, numbers and lists ----------------------------------------------------------------------------------------- */

/* Returns "clearance" for "joint.clearance"; "door.d1.width" unchanged. */
static const char *short_name(const char *name) {
    const char *first = strchr(name, '.');
    return first && first == strrchr(name, '.') ? first + 1 : name;
}

/* Lengths below this are printed in mm. */
static const double SMALL_LENGTH = 0.5;

/* Returns "clearance 0.1315 mm": a parameter and its value. */
static const char *point_of(Advice *advice, const char *name, double value) {
    const char *unit = advice->experiment->parameter(advice->experiment->given, name)->unit;
    if (experiment_turns(advice->experiment, name))
        return text_in_arena(&advice->arena, "%.4g rpm", EXPERIMENT_RPM * value);
    if (strcmp(unit, "1") == 0)
        return text_in_arena(&advice->arena, "%s %.4g", short_name(name), value);
    if (strcmp(unit, "m") == 0 && fabs(value) < SMALL_LENGTH)
        return text_in_arena(&advice->arena, "%s %.4g mm", short_name(name), 1000 * value);
    return text_in_arena(&advice->arena, "%s %.4g %s", short_name(name), value, unit);
}

static const char *measure_of(Advice *advice, double value) {
    const Observable *measure = &advice->experiment->observables[advice->experiment->measure];
    return text_in_arena(&advice->arena, "%.4g %s", value, measure->unit);
}

/* Returns the point of the window that decides the type, "clearance 0.1257 mm", or NULL at its centre. */
static const char *worst_point(Advice *advice) {
    const Types *types = advice->types;
    const TypesPoint *point = &types->points[types->worst];
    if (point->parameter == types->parameter_count)
        return NULL;
    return point_of(advice, types->parameters[point->parameter].name, point->value);
}

/* Returns a list with one more item, the index-th of `count`: "a, b or c". */
static const char *list_with(Advice *advice, const char *list, const char *item, size_t index, size_t count) {
    return index == 0 ? item : text_in_arena(&advice->arena, index + 1 < count ? "%s, %s" : "%s or %s", list, item);
}

/* Returns what tells answers of one machine apart: a period, or that a regular motion has none. */
static const char *outcome_of(Advice *advice, double outcome) {
    return outcome > 0 ? text_in_arena(&advice->arena, "period %g", outcome) : "quasi-periodic";
}

static const char *answers_of(Advice *advice, const TypesPoint *point) {
    const char *list = NULL;
    for (size_t a = 0; a < point->answer_count; a++) {
        const TypesAnswer *answer = &point->answers[a];
        const char *measure = measure_of(advice, answer->measure), *outcome = outcome_of(advice, answer->outcome);
        const char *item =
            !answer->starts
                ? text_in_arena(&advice->arena, "%s (%s) only carried on from a neighbouring value", measure, outcome)
            : answer->starts < TYPES_STARTS
                ? text_in_arena(&advice->arena, advice->sentences->answer_of_some, measure, answer->starts,
                                TYPES_STARTS, outcome)
                : text_in_arena(&advice->arena, advice->sentences->answer_of_all, measure, TYPES_STARTS, outcome);
        list = list_with(advice, list, item, a, point->answer_count);
    }
    return list;
}

/* The answer ------------------------------------------------------------------------------------------------------- */

/* Adds the sentence about the answers at the deciding point. */
static void add_answers(Advice *advice, const char *here, const char *at) {
    const char *point = worst_point(advice);
    const char *answers = answers_of(advice, &advice->types->points[advice->types->worst]);
    if (point)
        text_format(advice->text, at, point, answers);
    else
        text_format(advice->text, here, answers);
}

/* Adds the sentence about so many starts at the deciding point; about none: about a motion carried on. `carried`: what
 * that is. */
static void add_starts(Advice *advice, const StartSentences *sentences, size_t starts, const char *carried) {
    const char *point = worst_point(advice);
    bool some = starts < TYPES_STARTS;
    if (!starts && point)
        text_format(advice->text, "Carried on from a neighbouring value, the motion at %s is %s.", point, carried);
    else if (!starts)
        text_format(advice->text, "Carried on from a neighbouring value, the motion right here is %s.", carried);
    else if (point && some)
        text_format(advice->text, sentences->some_at, point, starts, TYPES_STARTS);
    else if (point)
        text_format(advice->text, sentences->all_at, point, TYPES_STARTS);
    else if (some)
        text_format(advice->text, sentences->some_here, starts, TYPES_STARTS);
    else
        text_format(advice->text, sentences->all_here, TYPES_STARTS);
}

static void add_slope(Advice *advice, const SlopeSentences *sentences, const TypesParameter *parameter) {
    double slope = parameter->sensitivity;
    const char *name = short_name(parameter->name);
    if (isinf(slope))
        text_format(advice->text, sentences->jumps, name);
    else
        text_format(advice->text, slope < 0 ? sentences->less : sentences->more, name, fabs(slope));
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

static void add_reason(Advice *advice) {
    const Types *types = advice->types;
    const Sentences *sentences = advice->sentences;
    const TypesPoint *worst = &types->points[types->worst];
    if (types->reason != TYPES_INTERRUPTED)
        text_add(advice->text, " ");
    switch (types->reason) {
    case TYPES_ALL_WELL:
        text_format(advice->text, sentences->one_answer, measure_of(advice, types->points[0].answers[0].measure));
        break;
    case TYPES_STEEP_ANSWER:
        text_format(advice->text, "%s ", sentences->steep);
        add_slope(advice, &sentences->slope, steepest(types));
        break;
    case TYPES_SEVERAL:
        if (worst->answer_count > 1)
            add_answers(advice, sentences->start_decides, sentences->start_decides_at);
        else
            add_answers(advice, sentences->changes, sentences->changes_at);
        break;
    case TYPES_NOT_REGULAR:
        add_starts(advice, &sentences->irregular, worst->irregular, "not periodic");
        if (worst->verdict)
            text_format(advice->text, " The motion that was analysed fully there is %s.", worst->verdict);
        break;
    case TYPES_FLIPS:
        add_answers(advice, "Its period doubles within 1 %% of here; right here it has %s.",
                    "Its period doubles within 1 %% of here; at %s it has %s.");
        break;
    case TYPES_UNDECIDED:
        add_starts(advice, &sentences->undecided, worst->undecided, "undecided");
        text_format(advice->text, " %s", sentences->remedy);
        break;
    case TYPES_INTERRUPTED:
        break; /* the headline says all */
    }
    text_add(advice->text, "\n");
}

/* Neighbours ------------------------------------------------------------------------------------------------------- */

/* Returns the nearer side of a parameter on which a change was found; NULL: none. */
static const Neighbour *nearer_side(const TypesParameter *parameter) {
    const Neighbour *below = parameter->below.answer == NEIGHBOUR_FOUND ? &parameter->below : NULL;
    const Neighbour *above = parameter->above.answer == NEIGHBOUR_FOUND ? &parameter->above : NULL;
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

static const char *side_of(Advice *advice, const TypesParameter *parameter) {
    const Neighbour *side = nearer_side(parameter);
    const char *point = point_of(advice, parameter->name, side->value);
    return text_in_arena(&advice->arena, side->share < 0 ? "%s (%.3g %% below)" : "%s (%.3g %% above)", point,
                         100 * fabs(side->share));
}

static const char *sides_of(Advice *advice, const size_t *order, size_t count) {
    const char *list = NULL;
    for (size_t i = 0; i < count; i++)
        list = list_with(advice, list, side_of(advice, &advice->types->parameters[order[i]]), i, count);
    return list;
}

static const char *names_of(Advice *advice) {
    const Types *types = advice->types;
    const char *list = NULL;
    for (size_t p = 0; p < types->parameter_count; p++)
        list = list_with(advice, list, short_name(types->parameters[p].name), p, types->parameter_count);
    return list;
}

/* Returns the least distance searched on all sides, 1. */
static double least_reached(const Types *types) {
    double least = HUGE_VAL;
    for (size_t p = 0; p < types->parameter_count; p++)
        if (types->parameters[p].nominal != 0)
            least = fmin(least, fmin(types->parameters[p].below.reached, types->parameters[p].above.reached));
    return isinf(least) ? 0 : least;
}

static void add_neighbours(Advice *advice) {
    const Types *types = advice->types;
    const Sentences *sentences = advice->sentences;
    size_t order[TYPES_PARAMETERS_MOST], found = order_parameters(types, order);
    bool trouble = types->sought == NEIGHBOURS_TROUBLE;
    if (!types->parameter_count || types->stopped)
        return;
    if (!found)
        text_format(advice->text, trouble ? sentences->stays : sentences->becomes_not, 100 * least_reached(types),
                    names_of(advice));
    else if (!trouble)
        text_format(advice->text, sentences->regular_at, sides_of(advice, order, found));
    else if (found == 1)
        text_format(advice->text, "The nearest trouble is at %s.", sides_of(advice, order, 1));
    else
        text_format(advice->text, "The nearest trouble is at %s; then at %s.", sides_of(advice, order, 1),
                    sides_of(advice, order + 1, found - 1));
    text_add(advice->text, "\n");
}

/* The basis -------------------------------------------------------------------------------------------------------- */

static void add_basis(Advice *advice, int cycles) {
    const Types *types = advice->types;
    if (cycles)
        text_format(advice->text, "This rests on %zu runs of %d %ss from %d starts within 1 %% of here.", types->runs,
                    cycles, experiment_cycle(advice->experiment), TYPES_STARTS);
    else
        text_format(advice->text, "This rests on %zu runs from %d starts within 1 %% of here.", types->runs,
                    TYPES_STARTS);
    if (types->thorough)
        text_format(advice->text, " Repeated with the full analysis: %zu of them.", types->thorough);
    if (types->carried_runs)
        text_format(advice->text, " Carried on from neighbouring values, upwards and downwards: %zu runs.",
                    types->carried_runs);
    if (types->neighbour_runs)
        text_format(advice->text, " Runs beyond that, from %d starts: %zu.", NEIGHBOURS_STARTS, types->neighbour_runs);
    if (types->stopped)
        text_add(advice->text, " The search was stopped before it was complete.");
    text_add(advice->text, "\n");
}

void advice_write(Text *text, const Types *types, const Experiment *experiment, int cycles) {
    Advice advice = {.text = text, .types = types, .experiment = experiment, .sentences = find_sentences(experiment)};
    const TypesParameter *most = steepest(types);
    text_add(text, advice.sentences->headline[types->kind]);
    add_reason(&advice);
    add_neighbours(&advice);
    if (most && types->reason != TYPES_STEEP_ANSWER && most->sensitivity != 0) {
        add_slope(&advice, &advice.sentences->steepest, most);
        text_add(text, "\n");
    }
    add_basis(&advice, cycles);
    arena_clear(&advice.arena);
}
