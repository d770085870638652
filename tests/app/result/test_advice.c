/* The sentences of the advice, on types written by hand. */
#include "check.h"

#include <math.h>
#include <string.h>

#include "result/advice.h"

static const Observable observables[] = {{"regular", "1", ""}, {"outcome", "1", ""}, {"measure", "N", ""}};
static const Parameter clearance = {.name = "joint.clearance", .unit = "m"}, speed = {.name = "speed", .unit = "1"};

static const Parameter *find_parameter(const void *given, const char *name) {
    (void)given;
    return strcmp(name, speed.name) == 0 ? &speed : &clearance;
}

static Experiment make_experiment(const char *kind) {
    return (Experiment){.kind = kind,
                        .observables = observables,
                        .observable_count = 3,
                        .outcome = 1,
                        .measure = 2,
                        .periods = true,
                        .parameter = find_parameter};
}

/* A window of two parameters; its centre has one answer from all starts. */
static Types make_types(TypesKind kind, TypesReason reason) {
    Types types = {
        .kind = kind,
        .reason = reason,
        .parameters = {{.name = "joint.clearance", .nominal = 1e-4, .sensitivity = 0},
                       {.name = "speed", .nominal = 2, .sensitivity = NAN}},
        .parameter_count = 2,
        .points = {{.parameter = 2, .value = NAN, .answers = {{1, 500, TYPES_STARTS}}, .answer_count = 1},
                   {.parameter = 0, .value = 9.9e-5, .answers = {{2, 400, 12}, {3, 300, 4}}, .answer_count = 2}},
        .point_count = 2,
        .runs = 80};
    for (size_t p = 0; p < 2; p++)
        types.parameters[p].below.reached = types.parameters[p].above.reached = 0.2;
    return types;
}

static void check_advice(const char *kind, const Types *types, int cycles, const char *expected) {
    Experiment experiment = make_experiment(kind);
    Text text = {0};
    advice_write(&text, types, &experiment, cycles);
    CHECK_TEXT(text.text, expected);
    memory_free(text.text);
}

#define BASIS "This rests on 80 runs from 16 starts within 1 % of here.\n"

TEST(one_answer_far_from_trouble_is_said_for_a_beam_and_for_a_house) {
    Types types = make_types(TYPES_I, TYPES_ALL_WELL);
    check_advice("beam", &types, 0,
                 "Type I: run it here. It is periodic with one answer within 1 % of every number: 500 N.\n"
                 "It stays periodic with one of these changed alone by up to 20 %: clearance or speed.\n" BASIS);
    types.parameters[0].sensitivity = -2.5;
    check_advice("house", &types, 400,
                 "Type I: this route can be relied on. All people leave, with one answer within 1 % of every number: "
                 "500 N.\nAll people also leave with one of these changed alone by up to 20 %: clearance or speed.\n"
                 "It depends most on clearance: 1 % more makes the time 2.5 % shorter.\n"
                 "This rests on 80 runs of 400 cycles from 16 starts within 1 % of here.\n");
}

TEST(a_steep_answer_says_how_steep_and_where_the_nearest_trouble_is) {
    Types types = make_types(TYPES_II, TYPES_STEEP_ANSWER);
    types.parameters[0].sensitivity = HUGE_VAL;
    types.parameters[0].above = (Neighbour){.answer = NEIGHBOUR_FOUND, .value = 1.1e-4, .share = 0.1};
    types.parameters[1].below = (Neighbour){.answer = NEIGHBOUR_FOUND, .value = 1.9, .share = -0.05};
    types.neighbour_runs = 40;
    check_advice("beam", &types, 0,
                 "Type II: run it here only with close tolerances. It is periodic throughout, but its largest force "
                 "changes steeply. A change of 1 % in clearance decides whether there is any force at all.\n"
                 "The nearest trouble is at speed 1.9 (5 % below); then at clearance 0.11 mm (10 % above).\n"
                 "This rests on 80 runs from 16 starts within 1 % of here. Runs beyond that, from 4 starts: 40.\n");
}

TEST(several_answers_are_listed_with_their_starts) {
    Types types = make_types(TYPES_II, TYPES_SEVERAL);
    types.parameter_count = 1;
    types.worst = 1;
    types.parameters[0].below.answer = NEIGHBOUR_FOUND;
    types.parameters[0].below.value = 9e-5;
    types.parameters[0].below.share = -0.1;
    check_advice(
        "beam", &types, 0,
        "Type II: run it here only with close tolerances. It is periodic throughout, but at clearance 0.099 mm "
        "the start decides: 400 N (period 2) from 12 of 16 starts or 300 N (period 3) from 4 of 16 starts.\n"
        "The nearest trouble is at clearance 0.09 mm (10 % below).\n" BASIS);
    types.points[1].answers[0].starts = TYPES_STARTS;
    types.points[1].answer_count = 1;
    types.points[1].answers[0].outcome = 0;
    check_advice("beam", &types, 0,
                 "Type II: run it here only with close tolerances. It is regular throughout, but at clearance 0.099 mm "
                 "it moves otherwise: 400 N (quasi-periodic) from each of 16 starts.\n"
                 "The nearest trouble is at clearance 0.09 mm (10 % below).\n" BASIS);
    check_advice("house", &types, 0,
                 "Type II: this route depends on small changes. All people leave throughout, but at clearance 0.099 mm "
                 "by another route: 400 N from each of 16 starts.\n"
                 "The nearest trouble is at clearance 0.09 mm (10 % below).\n" BASIS);
}

TEST(a_point_that_is_not_regular_says_from_how_many_starts_and_what_would_help) {
    Types types = make_types(TYPES_III, TYPES_NOT_REGULAR);
    types.sought = NEIGHBOURS_REGULAR;
    types.points[0].irregular = TYPES_STARTS;
    check_advice(
        "house", &types, 0,
        "Type III: do not rely on this route. Not all people leave right here, from any of 16 starts.\n"
        "Not all people leave with one of these changed alone by up to 20 % either: clearance or speed.\n" BASIS);
    types.worst = 1;
    types.points[1].irregular = 3;
    types.parameters[1].above = (Neighbour){.answer = NEIGHBOUR_FOUND, .value = 2.2, .share = 0.1};
    check_advice("beam", &types, 0,
                 "Type III: do not run it here. It is not periodic at clearance 0.099 mm, from 3 of 16 starts.\n"
                 "With one number changed alone it is periodic again at speed 2.2 (10 % above).\n" BASIS);
}

TEST(an_undecided_type_names_the_remedy_unless_it_was_stopped) {
    Types types = make_types(TYPES_UNRESOLVED, TYPES_UNDECIDED);
    types.parameter_count = 0;
    types.points[0].parameter = 0;
    types.points[0].undecided = 5;
    types.thorough = 4;
    check_advice(
        "house", &types, 0,
        "The type is undecided. It is undecided whether all people leave right here, from 5 of 16 starts. A "
        "larger run.until may decide it.\n"
        "This rests on 80 runs from 16 starts within 1 % of here. Repeated with the full analysis: 4 of them.\n");
    types.stopped = true;
    types.kind = TYPES_KIND_INTERRUPTED;
    types.reason = TYPES_INTERRUPTED;
    check_advice(
        "beam", &types, 0,
        "The search for the type was interrupted.\n"
        "This rests on 80 runs from 16 starts within 1 % of here. Repeated with the full analysis: 4 of them. The "
        "search was stopped before it was complete.\n");
}

TEST(a_period_that_doubles_is_said_of_the_point_where_it_has) {
    Types types = make_types(TYPES_II, TYPES_FLIPS);
    types.worst = 1;
    types.points[1].answer_count = 1;
    check_advice("beam", &types, 0,
                 "Type II: run it here only with close tolerances. Its period doubles within 1 % of here; at clearance "
                 "0.099 mm it has "
                 "400 N (period 2) from 12 of 16 starts.\n"
                 "It stays periodic with one of these changed alone by up to 20 %: clearance or speed.\n" BASIS);
}
