#include "study/type_map.h"

#include <math.h>
#include <string.h>

#include "check.h"
#include "base/stop.h"

/* Tests types on synthetic experiments, whose results are formulas of two parameters and the seed. */
typedef struct Told {
    double regular, outcome, measure;
} Told;

typedef struct Made {
    Told (*tell)(double a, double b, uint64_t seed);
    double farthest;                                     /* a larger a is invalid */
    Told (*carry)(double a, double b, const Told *from); /* of a trial carried on; NULL: none is */
} Made;

static const Parameter rows[] = {{.name = "a", .unit = "1", .low = 0, .high = 10},
                                 {.name = "b", .unit = "m", .low = 0, .high = 10},
                                 {.name = "nothing", .unit = "1", .low = 0, .high = 10}};
static const double nominals[] = {2, 3, 0};
static const Observable observables[] = {{"regular", "1", ""}, {"outcome", "1", ""}, {"measure", "N", ""}};

static const Parameter *find_row(const void *given, const char *name) {
    (void)given;
    for (size_t i = 0; i < 3; i++)
        if (strcmp(rows[i].name, name) == 0)
            return &rows[i];
    return NULL;
}

static double nominal(const void *given, const char *name) {
    const Parameter *row = find_row(given, name);
    return row ? nominals[row - rows] : 0;
}

static void run(const void *given, const char *const *names, size_t name_count, Trial *trials, size_t count, bool carry,
                const Stop *stop) {
    const Made *made = given;
    CHECK(!carry || made->carry);
    Told told = {0};
    for (size_t i = 0; i < count && !stop_requested(stop); i++) {
        double values[3] = {nominals[0], nominals[1], nominals[2]};
        for (size_t n = 0; n < name_count; n++)
            values[find_row(given, names[n]) - rows] = trials[i].at[n];
        told = carry && i ? made->carry(values[0], values[1], &told) : made->tell(values[0], values[1], trials[i].seed);
        trials[i].done = true;
        if (values[0] > made->farthest) {
            trials[i].fault = memory_zeroed(2, 1);
            continue;
        }
        memcpy(trials[i].observed, (double[]){told.regular, told.outcome, told.measure}, sizeof told);
    }
}

static Experiment make(Made *made) {
    return (Experiment){.kind = "beam",
                        .observables = observables,
                        .observable_count = 3,
                        .regular = 0,
                        .outcome = 1,
                        .measure = 2,
                        .periods = true,
                        .batch = 16,
                        .given = made,
                        .parameter = find_row,
                        .nominal = nominal,
                        .run = run};
}

static const char *const names[] = {"a", "b"};

static Types tell_carried(Told (*made)(double, double, uint64_t), Told (*carry)(double, double, const Told *),
                          int jobs) {
    Made given = {made, 10, carry};
    Experiment experiment = make(&given);
    experiment.carries = true;
    TypesTask task = {.experiment = &experiment, .names = names, .name_count = 2, .jobs = jobs};
    Types types;
    Fault fault = {0};
    memset(&types, 0x55, sizeof types);
    CHECK(types_classify(&types, &task, &fault));
    return types;
}

static Types tell_with(Told (*quick)(double, double, uint64_t), Told (*thorough)(double, double, uint64_t),
                       double farthest, int jobs) {
    Made first = {quick, farthest, NULL}, second = {thorough, farthest, NULL};
    Experiment experiment = make(&first), again = make(&second);
    TypesTask task = {
        .experiment = &experiment, .thorough = thorough ? &again : NULL, .names = names, .name_count = 2, .jobs = jobs};
    Types types;
    memset(&types, 0x55, sizeof types);
    Fault fault = {0};
    CHECK(types_classify(&types, &task, &fault));
    return types;
}

static Types tell(Told (*made)(double a, double b, uint64_t seed)) {
    return tell_with(made, NULL, 10, 2);
}

static Told power(double a, double b, uint64_t seed) {
    (void)seed;
    return (Told){1, 1, a * a / b};
}

TEST(one_answer_that_changes_slowly_is_type_one_and_its_sensitivities_are_its_powers) {
    Types types = tell(power);
    CHECK(types.kind == TYPES_I && types.reason == TYPES_ALL_WELL);
    CHECK_NEAR(types.parameters[0].sensitivity, 2, 1e-9);
    CHECK_NEAR(types.parameters[1].sensitivity, -1, 1e-9);
    CHECK(types.answers == 1 && types.point_count == 5);
    CHECK(types.runs == 5 * TYPES_STARTS && types.thorough == 0);
    CHECK(types.points[0].answers[0].starts == TYPES_STARTS);
    CHECK(types.parameters[0].above.answer == NEIGHBOUR_NONE && types.parameters[0].below.answer == NEIGHBOUR_NONE);
    CHECK_NEAR(types.parameters[0].above.reached, 0.2, 1e-12);
    CHECK(types.neighbour_runs == 4 * NEIGHBOURS_STEPS * NEIGHBOURS_STARTS);
    CHECK_TEXT(types_kind_name(types.kind), "I");
}

static Told steep(double a, double b, uint64_t seed) {
    (void)seed;
    return (Told){1, 1, pow(a, 4.9) * pow(b, -5.1)};
}

TEST(a_sensitivity_of_five_makes_type_two) {
    Types types = tell(steep);
    CHECK(types.kind == TYPES_II && types.reason == TYPES_STEEP_ANSWER);
    CHECK_NEAR(types.parameters[1].sensitivity, -5.1, 1e-9);
    CHECK(types.points[types.worst].parameter == 1);
}

static Told two(double a, double b, uint64_t seed) {
    (void)b;
    return (Told){1, 1, seed % 4 ? a : 1.5 * a};
}

TEST(two_answers_are_type_two_and_counted) {
    Types types = tell(two);
    CHECK(types.kind == TYPES_II && types.reason == TYPES_SEVERAL && types.answers == 2);
    CHECK(types.worst == 0);
    CHECK(types.points[0].answers[0].starts == 12 && types.points[0].answers[1].starts == 4);
    CHECK_NEAR(types.points[0].answers[1].measure, 3, 1e-12);
    CHECK_NEAR(types.parameters[0].sensitivity, 1, 1e-9);
}

static Told nearly_the_same(double a, double b, uint64_t seed) {
    (void)b;
    return (Told){1, 1, a * (1 + 1e-4 * (double)seed)};
}

TEST(measures_that_nearly_agree_are_of_one_answer) {
    CHECK(tell(nearly_the_same).kind == TYPES_I);
}

static Told another_there(double a, double b, uint64_t seed) {
    (void)seed;
    return (Told){1, a > 2.01 ? 3 : 1, b};
}

TEST(an_answer_that_is_another_at_the_windows_edge_is_type_two) {
    Types types = tell(another_there);
    CHECK(types.kind == TYPES_II && types.reason == TYPES_SEVERAL && types.answers == 1);
    CHECK(types.points[types.worst].parameter == 0 && types.points[types.worst].value > 2);
}

/* Every start leads to one answer wherever it is regular; at the upper end of a there is only another one, which lasts
 * below it, too. */
static Told lasts(double a, double b, const Told *from) {
    return from->outcome == 3 ? *from : another_there(a, b, 0);
}

TEST(an_answer_that_only_motions_carried_on_reach_is_found) {
    Types types = tell_carried(another_there, lasts, 2);
    CHECK(types.kind == TYPES_II && types.reason == TYPES_SEVERAL && types.worst == 0);
    const TypesPoint *centre = &types.points[0];
    CHECK(centre->answer_count == 2 && centre->answers[0].starts == TYPES_STARTS && centre->answers[0].carried == 3);
    CHECK(centre->answers[1].starts == 0 && centre->answers[1].carried == 1 && centre->answers[1].outcome == 3);
    CHECK(types.points[1].answer_count == 2 && types.points[1].answers[1].outcome == 3);
    CHECK(types.carried_runs == 8 && types.runs == 5 * TYPES_STARTS);
    Types alone = tell_carried(another_there, lasts, 1);
    CHECK(memcmp(&alone, &types, sizeof types) == 0);
}

static Told becomes_wild(double a, double b, const Told *from) {
    (void)from;
    return (Told){b > 3.01, 1, a};
}

TEST(a_motion_carried_on_that_is_not_regular_is_type_three) {
    Types types = tell_carried(power, becomes_wild, 2);
    CHECK(types.kind == TYPES_III && types.reason == TYPES_NOT_REGULAR && types.points[types.worst].irregular == 0);
    CHECK(types.points[types.worst].carried_irregular > 0);
}

static Told flip(double a, double b, uint64_t seed) {
    (void)seed;
    return (Told){1, a > 2.01 ? 2 : 1, b};
}

static Told flip_backwards(double a, double b, uint64_t seed) {
    (void)seed;
    return (Told){1, b > 2.98 ? 4 : 2, a};
}

TEST(a_period_that_doubles_inside_the_window_is_type_two) {
    Types types = tell(flip);
    CHECK(types.kind == TYPES_II && types.reason == TYPES_FLIPS);
    CHECK(types.points[types.worst].parameter == 0 && types.points[types.worst].value > 2);
    types = tell(flip_backwards);
    CHECK(types.kind == TYPES_II && types.reason == TYPES_FLIPS);
    CHECK(types.points[types.worst].parameter == 1 && types.points[types.worst].value < 3);
}

static Told both_periods(double a, double b, uint64_t seed) {
    return (Told){1, seed % 2 ? 1 : 2, a * b};
}

TEST(two_periods_beside_each_other_everywhere_are_no_flip) {
    Types types = tell(both_periods);
    CHECK(types.kind == TYPES_II && types.reason == TYPES_SEVERAL);
}

static Told chaos_above(double a, double b, uint64_t seed) {
    return (Told){b > 3.02 && seed == 7 ? 0 : 1, 1, a * b};
}

TEST(one_irregular_start_at_one_point_of_the_window_is_type_three) {
    Types types = tell(chaos_above);
    CHECK(types.kind == TYPES_III && types.reason == TYPES_NOT_REGULAR);
    const TypesPoint *worst = &types.points[types.worst];
    CHECK(worst->parameter == 1 && worst->irregular == 1);
    CHECK_NEAR(worst->value, 3.03, 1e-12);
    CHECK(types.sought == NEIGHBOURS_TROUBLE);
}

static Told undecided_below(double a, double b, uint64_t seed) {
    return (Told){b < 2.98 && seed == 3 ? NAN : 1, 1, a * b};
}

static Told chaos_here(double a, double b, uint64_t seed) {
    (void)seed;
    return (Told){a < 1.905 ? 1 : 0, 1, b};
}

TEST(what_cannot_be_told_is_unresolved_unless_something_else_is_irregular) {
    Types types = tell(undecided_below);
    CHECK(types.kind == TYPES_UNRESOLVED && types.reason == TYPES_UNDECIDED);
    CHECK(types.points[types.worst].parameter == 1 && types.points[types.worst].undecided == 1);
    CHECK_TEXT(types_kind_name(types.kind), "unresolved");
}

TEST(from_an_irregular_point_the_nearest_regular_ones_are_sought) {
    Types types = tell(chaos_here);
    CHECK(types.kind == TYPES_III && types.worst == 0 && types.sought == NEIGHBOURS_REGULAR);
    CHECK(types.parameters[0].below.answer == NEIGHBOUR_FOUND && types.parameters[0].above.answer == NEIGHBOUR_NONE);
    CHECK_NEAR(types.parameters[0].below.share, -0.05, 1e-12);
    CHECK_NEAR(types.parameters[0].below.value, 1.9, 1e-12);
    CHECK(types.parameters[1].below.answer == NEIGHBOUR_NONE && isnan(types.parameters[0].sensitivity));
}

static Told trouble_further(double a, double b, uint64_t seed) {
    return (Told){a > 2.105 && seed == 2 ? 0 : 1, 1, b};
}

TEST(from_a_regular_point_the_nearest_trouble_is_sought_in_steps_of_a_half_and_one_per_cent) {
    Types types = tell(trouble_further);
    CHECK(types.kind == TYPES_I && types.sought == NEIGHBOURS_TROUBLE);
    CHECK_NEAR(types.parameters[0].above.share, 0.06, 1e-12);
    CHECK_NEAR(neighbours_share(0), 0.005, 1e-15);
    CHECK_NEAR(neighbours_share(NEIGHBOURS_FINE), 0.06, 1e-15);
    CHECK_NEAR(neighbours_share(NEIGHBOURS_STEPS - 1), 0.2, 1e-15);
}

TEST(where_values_are_out_of_range_the_search_ends_and_says_how_far_it_came) {
    Types types = tell_with(power, NULL, 2.25, 1);
    CHECK(types.parameters[0].above.answer == NEIGHBOUR_NONE);
    CHECK_NEAR(types.parameters[0].above.reached, 0.12, 1e-12);
    CHECK_NEAR(types.parameters[0].below.reached, 0.2, 1e-12);
    types = tell_with(power, NULL, 2.01, 1); /* the end of the window is out of range and is ignored */
    CHECK(types.kind == TYPES_I && !types.points[2].possible && types.runs == 4 * TYPES_STARTS);
    types = tell_with(power, NULL, 1, 1); /* and here the centre */
    CHECK(types.kind == TYPES_UNRESOLVED);
}

static Told hasty(double a, double b, uint64_t seed) {
    return (Told){seed == 5 ? 0 : seed == 6 ? NAN : 1, 1, a * b};
}

static Told never(double a, double b, uint64_t seed) {
    (void)seed;
    return (Told){NAN, 1, a * b};
}

TEST(what_is_not_quickly_told_regular_is_told_thoroughly) {
    Types types = tell_with(hasty, power, 10, 2);
    CHECK(types.kind == TYPES_II && types.thorough == 10); /* all regular, but with another response */
    types = tell_with(hasty, hasty, 10, 2);
    CHECK(types.kind == TYPES_III && types.thorough == 2 && types.worst == 0);
    types = tell_with(hasty, never, 10, 2);
    CHECK(types.kind == TYPES_UNRESOLVED && types.thorough == TYPES_UNDECIDED_MOST);
    CHECK(types.points[0].irregular == 0 && types.points[0].undecided == 2);
    types = tell_with(never, power, 10, 2);
    CHECK(types.kind == TYPES_I && types.thorough == types.runs);
}

static Told touches_above(double a, double b, uint64_t seed) {
    (void)seed;
    return (Told){1, 1, a > 2.01 ? b : 0};
}

static Told never_touches(double a, double b, uint64_t seed) {
    (void)a, (void)b, (void)seed;
    return (Told){1, 1, 0};
}

TEST(a_measure_that_begins_inside_the_window_is_steep_and_one_that_is_nothing_is_not) {
    Types types = tell(touches_above);
    CHECK(types.kind == TYPES_II && isinf(types.parameters[0].sensitivity));
    types = tell(never_touches);
    CHECK(types.kind == TYPES_I && types.parameters[0].sensitivity == 0);
}

TEST(a_parameter_that_is_nothing_has_no_window) {
    Made made = {power, 10, NULL};
    Experiment experiment = make(&made);
    const char *nothing[] = {"nothing"};
    TypesTask task = {.experiment = &experiment, .names = nothing, .name_count = 1, .jobs = 1};
    Types types;
    Fault fault = {0};
    CHECK(types_classify(&types, &task, &fault));
    CHECK(types.kind == TYPES_I && types.point_count == 1 && isnan(types.parameters[0].sensitivity));
    CHECK(types.parameters[0].below.answer == NEIGHBOUR_NONE && types.neighbour_runs == 0);
}

static Told steeper_beyond(double a, double b, uint64_t seed) {
    (void)seed;
    return (Told){a < 9 ? 1 : NAN, 1, b < 5 ? a * a : pow(a, 6)};
}

TEST(each_run_of_a_typed_experiment_has_the_type_of_its_place) {
    static const char *const varied[] = {"b", "a"};
    const double at[][2] = {{2, 2}, {6, 2}, {2, 9.5}};
    Made made = {steeper_beyond, 10, NULL};
    Experiment of = make(&made), experiment;
    TypeMap map = {.of = &of, .names = names, .name_count = 1};
    Fault fault = {0};
    CHECK(type_map_open(&map, &experiment, &fault));
    CHECK(experiment.observable_count == 4);
    CHECK_TEXT(experiment.observables[3].name, "type");
    Trial trials[3];
    double observed[3][4];
    for (size_t i = 0; i < 3; i++)
        trials[i] = (Trial){.at = at[i], .observed = observed[i]};
    experiment.run(experiment.given, varied, 2, trials, 3, false, NULL);
    CHECK_NEAR(observed[0][3], 1, 0);
    CHECK_NEAR(observed[1][3], 2, 0);
    CHECK(isnan(observed[2][3]));
    CHECK_NEAR(observed[1][2], 64, 0);
    CHECK(trials[1].at == at[1]);
    type_map_close(&map);
    map.names = (const char *const[]){"c"};
    CHECK(!type_map_open(&map, &experiment, &fault));
    fault_clear(&fault);
}

TEST(the_same_is_told_with_any_number_of_jobs) {
    Told (*const all[])(double, double, uint64_t) = {power, two, flip, chaos_above, trouble_further};
    for (size_t i = 0; i < sizeof all / sizeof *all; i++) {
        Types alone = tell_with(all[i], all[i], 2.25, 1), many = tell_with(all[i], all[i], 2.25, 5);
        CHECK(alone.kind == many.kind && alone.worst == many.worst && alone.runs == many.runs);
        CHECK(alone.thorough == many.thorough && alone.neighbour_runs == many.neighbour_runs);
        CHECK(memcmp(alone.points, many.points, sizeof alone.points) == 0);
    }
}

TEST(names_that_are_no_parameters_are_a_fault) {
    Made made = {power, 10, NULL};
    Experiment experiment = make(&made);
    const char *wrong[] = {"a", "c"};
    TypesTask task = {.experiment = &experiment, .names = wrong, .name_count = 2, .jobs = 1};
    Types types;
    Fault fault = {0};
    CHECK(!types_classify(&types, &task, &fault));
    CHECK(fault.count == 1);
    CHECK_TEXT(fault.lines[0], "types: c: unknown parameter of a beam");
    fault_clear(&fault);
    const char *twice[] = {"b", "b"};
    task.names = twice;
    CHECK(!types_classify(&types, &task, &fault));
    CHECK(fault.count == 1);
    CHECK_TEXT(fault.lines[0], "types: b is named twice");
    fault_clear(&fault);
}

TEST(stopped_it_says_nothing) {
    Made made = {power, 10, NULL};
    Experiment experiment = make(&made);
    Stop stop = {1};
    TypesTask task = {.experiment = &experiment, .names = names, .name_count = 2, .jobs = 2, .stop = &stop};
    Types types;
    Fault fault = {0};
    CHECK(types_classify(&types, &task, &fault));
    CHECK(types.kind == TYPES_KIND_INTERRUPTED && types.stopped && types.runs == 0);
    CHECK_TEXT(types_kind_name(types.kind), "interrupted");
    CHECK(types.reason == TYPES_INTERRUPTED && types.point_count == 0);
    CHECK(types.parameters[0].below.answer == NEIGHBOUR_INTERRUPTED && isnan(types.parameters[0].below.reached));
}
