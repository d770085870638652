/* Tests measures of synthetic observations with known answers. */

#include <math.h>

#include "case.h"
#include "check.h"
#include "base/memory.h"
#include "inquiry/measure.h"

enum { PEOPLE = 10 };

static const TraceColumn columns[TRACE_COLUMNS] = {{"time", "s"}};

/* Ten people in a corridor 2 m wide along x, p01 to p10, at rest. */
static void corridor(House *house, Observation *observation) {
    json_t *plan = case_corridor(2), *people = json_object_get(plan, "people");
    for (int i = 0; i < PEOPLE; i++) {
        case_add_person(plan, "manual-chair", 1 + 1.3 * i, 0, 0);
        char id[8] = {'p', i == PEOPLE - 1 ? '1' : '0', (char)('0' + (i + 1) % 10), 0};
        json_t *person = json_array_get(people, (size_t)i);
        json_object_set_new(person, "id", json_string(id));
        json_object_set_new(person, "delay", json_real(i));
    }
    json_object_set_new(plan, "routes",
                        json_pack("[{s:s, s:[s,s], s:s}]", "id", "A", "people", "p01", "p02", "exit", "e1"));
    case_made(house, plan, -1, NULL);
    *observation = (Observation){.people = memory_zeroed(PEOPLE, sizeof *observation->people),
                                 .person_count = PEOPLE,
                                 .completed = true,
                                 .sample = 1};
    for (int i = 0; i < PEOPLE; i++)
        observation->people[i] = (PersonObservation){.took_part = true, .completed = true, .time = 10 + 2 * i};
    trace_init(&observation->trace, columns, TRACE_COLUMNS);
}

static void release(House *house, Observation *observation) {
    observation_free(observation);
    house_free(house);
}

static void add_row(Observation *observation, double time, int person, double x, double y) {
    trace_add(&observation->trace,
              (double[TRACE_COLUMNS]){[TRACE_TIME] = time, [TRACE_PERSON] = person, [TRACE_X] = x, [TRACE_Y] = y});
}

/* All people walk along x from their place, from `from` to `until`, person i at speed + i * step. */
static void walk(const House *house, Observation *observation, double speed, double step, int from, int until) {
    for (int t = 0; t <= until; t++)
        for (int i = 0; i < PEOPLE; i++)
            add_row(observation, t, i, house->people[i].at.x + (speed + i * step) * fmax(0, t - from),
                    house->people[i].at.y);
}

static MeasureAnswer take(const char *name, const House *house, const Observation *observation,
                          const MeasureQuestion *question) {
    MeasureAnswer answer = {.value = 0};
    const Measure *measure = measure_find(name);
    CHECK(measure);
    if (measure)
        measure->take(&answer, house, observation, question);
    return answer;
}

static const MeasureQuestion everybody = {.exit = "", .last = 1};

TEST(times_are_of_the_last_and_of_the_mean) {
    House house;
    Observation observation;
    corridor(&house, &observation);
    const char *two[] = {"p02", "p04"};
    MeasureQuestion pair = {.of = {two, 2}, .exit = "", .last = 1};
    CHECK_NEAR(take("time", &house, &observation, &everybody).value, 28, 0);
    CHECK_NEAR(take("mean_time", &house, &observation, &everybody).value, 19, 1e-12);
    CHECK_NEAR(take("time", &house, &observation, &pair).value, 16, 0);
    CHECK_NEAR(take("mean_time", &house, &observation, &pair).value, 14, 1e-12);
    CHECK_NEAR(take("out", &house, &observation, &pair).value, 2, 0);
    release(&house, &observation);
}

TEST(who_is_still_in_has_no_time_and_is_named) {
    House house;
    Observation observation;
    corridor(&house, &observation);
    observation.people[3].completed = false;
    observation.people[3].reason = REASON_BLOCKED;
    MeasureAnswer answer = take("time", &house, &observation, &everybody);
    CHECK(isnan(answer.value));
    CHECK_TEXT(answer.note, "1 of 10 people did not leave, the first of them p04: blocked after 16.0 s");
    CHECK_NEAR(take("out", &house, &observation, &everybody).value, 9, 0);
    release(&house, &observation);
}

TEST(an_exit_is_kept_by_those_who_leave_by_it) {
    House house;
    Observation observation;
    corridor(&house, &observation);
    MeasureQuestion by_e1 = {.exit = "e1", .last = 1};
    CHECK_NEAR(take("assigned_exit", &house, &observation, &everybody).value, 1, 0);
    CHECK_NEAR(take("exit_count", &house, &observation, &by_e1).value, 10, 0);
    observation.people[1].completed = false;
    CHECK_NEAR(take("assigned_exit", &house, &observation, &everybody).value, 0.5, 0);
    CHECK_NEAR(take("exit_count", &house, &observation, &by_e1).value, 9, 0);
    const char *others[] = {"p05"};
    MeasureQuestion unassigned = {.of = {others, 1}, .exit = "", .last = 1};
    CHECK(isnan(take("assigned_exit", &house, &observation, &unassigned).value));
    release(&house, &observation);
}

TEST(a_start_is_when_somebody_has_moved_by_a_hair) {
    House house;
    Observation observation;
    corridor(&house, &observation);
    for (int t = 0; t <= 12; t++)
        for (int i = 0; i < PEOPLE; i++) /* each one row late, and p03 never */
            add_row(&observation, t, i, house.people[i].at.x + (i != 2 && t > i ? 0.5 : 0.005), 0);
    const char *most[] = {"p01", "p02", "p04", "p10"}, *one[] = {"p03"};
    MeasureQuestion started = {.of = {most, 4}, .exit = "", .last = 1}, never = {.of = {one, 1}, .exit = "", .last = 1};
    CHECK_NEAR(take("start", &house, &observation, &started).value, 1, 1e-12);
    MeasureAnswer answer = take("start", &house, &observation, &never);
    CHECK(isinf(answer.value));
    CHECK_TEXT(answer.note, "p03 never starts");
    release(&house, &observation);
}

TEST(speeds_have_the_mean_and_deviation_that_they_were_given) {
    House house;
    Observation observation;
    corridor(&house, &observation);
    walk(&house, &observation, 1, 0.1, 0, 10); /* 1.0, 1.1 ... 1.9 m/s */
    CHECK_NEAR(take("speed", &house, &observation, &everybody).value, 1.45, 1e-9);
    CHECK_NEAR(take("speed_deviation", &house, &observation, &everybody).value, 0.1 * sqrt(110.0 / 12), 1e-9);
    const char *two[] = {"p02", "p04"};
    MeasureQuestion pair = {.of = {two, 2}, .exit = "", .last = 1};
    CHECK_NEAR(take("slowest", &house, &observation, &pair).value, 1.1, 1e-9);
    CHECK_NEAR(take("fastest", &house, &observation, &pair).value, 1.3, 1e-9);
    Vec2 corners[] = {{2, -1}, {6, -1}, {6, 1}, {2, 1}};
    MeasureQuestion first = {.of = {two, 1}, .area = {corners, 4}, .exit = "", .last = 1};
    CHECK_NEAR(take("speed", &house, &observation, &first).value, 1.1, 1e-9);
    Vec2 elsewhere[] = {{2, 3}, {6, 3}, {6, 5}};
    first.area = (Points){elsewhere, 3};
    CHECK(isnan(take("speed", &house, &observation, &first).value));
    release(&house, &observation);
}

TEST(a_flow_is_people_per_time_and_width) {
    House house;
    Observation observation;
    corridor(&house, &observation); /* one every 2 s through 2 m */
    MeasureQuestion whole = {.exit = "e1", .last = 1};
    CHECK_NEAR(take("flow", &house, &observation, &whole).value, 0.25, 1e-12);
    MeasureQuestion middle = {.exit = "e1", .width = 0.5, .first = 0.2, .last = 0.8};
    CHECK_NEAR(take("flow", &house, &observation, &middle).value, 1, 1e-12);
    MeasureQuestion narrow = {.exit = "e1", .first = 0.5, .last = 0.6};
    CHECK(isnan(take("flow", &house, &observation, &narrow).value));
    release(&house, &observation);
}

TEST(a_line_is_passed_once_and_between_its_ends) {
    House house;
    Observation observation;
    corridor(&house, &observation);
    walk(&house, &observation, 1.3, 0, 0, 20); /* 1.3 m apart at 1.3 m/s: one a second */
    Vec2 ends[] = {{14, -1}, {14, 1}}, aside[] = {{14, 0.5}, {14, 1}};
    MeasureQuestion across = {.exit = "", .line = {ends, 2}, .last = 1};
    CHECK_NEAR(take("passed", &house, &observation, &across).value, 10, 0);
    CHECK_NEAR(take("flow", &house, &observation, &across).value, 0.5, 1e-9);
    CHECK_NEAR(take("last_passing", &house, &observation, &across).value, 10, 1e-9);
    across.line = (Points){aside, 2};
    CHECK_NEAR(take("passed", &house, &observation, &across).value, 0, 0);
    CHECK(isnan(take("last_passing", &house, &observation, &across).value));
    release(&house, &observation);
}

TEST(density_is_the_mean_number_per_area_and_speed_the_way_per_time) {
    House house;
    Observation observation;
    corridor(&house, &observation);
    walk(&house, &observation, 0, 0, 0, 4); /* all stand; x = 1, 2.3 ... 12.7 */
    Vec2 corners[] = {{0, -1}, {4, -1}, {4, 1}, {0, 1}};
    MeasureQuestion area = {.exit = "", .area = {corners, 4}, .from = 0.5, .until = 3.5, .last = 1};
    CHECK_NEAR(take("density", &house, &observation, &area).value, 3.0 / 8, 1e-12);
    CHECK_NEAR(take("area_speed", &house, &observation, &area).value, 0, 1e-12);
    trace_clear(&observation.trace);
    trace_init(&observation.trace, columns, TRACE_COLUMNS);
    walk(&house, &observation, 1, 0.1, 0, 4);
    MeasureQuestion all = {.exit = "", .area = {corners, 4}, .from = 0, .until = 4, .last = 1};
    Vec2 far[] = {{-100, -1}, {100, -1}, {100, 1}, {-100, 1}};
    all.area = (Points){far, 4};
    CHECK_NEAR(take("density", &house, &observation, &all).value, 10.0 / 400, 1e-12);
    CHECK_NEAR(take("area_speed", &house, &observation, &all).value, 1.45, 1e-9);
    observation.completed = false;
    observation.time = 3;
    CHECK(isnan(take("density", &house, &observation, &all).value));
    release(&house, &observation);
}

TEST(overtaking_counts_pairs_of_which_the_one_behind_is_out_first) {
    House house;
    Observation observation;
    corridor(&house, &observation); /* the exit is at x = 18: p01 starts farthest behind and is out first */
    const char *behind[] = {"p01", "p02"}, *ahead[] = {"p09", "p10"};
    MeasureQuestion question = {.of = {behind, 2}, .past = {ahead, 2}, .exit = "", .last = 1};
    CHECK_NEAR(take("overtaking", &house, &observation, &question).value, 1, 0);
    observation.people[1].time = 27; /* between p09 and p10 */
    CHECK_NEAR(take("overtaking", &house, &observation, &question).value, 0.75, 0);
    MeasureQuestion other_way = {.of = {ahead, 2}, .past = {behind, 2}, .exit = "", .last = 1};
    CHECK(isnan(take("overtaking", &house, &observation, &other_way).value));
    release(&house, &observation);
}

TEST(members_of_a_crowd_are_known_by_its_name) {
    House house;
    json_t *plan = case_corridor(2);
    json_object_set_new(plan, "crowds",
                        json_pack("[{s:s, s:s, s:i, s:[[f,f],[f,f],[f,f]]}]", "id", "c-1", "profile", "adult", "count",
                                  2, "area", 1.0, -1.0, 9.0, -1.0, 9.0, 1.0));
    case_add_person(plan, "adult", 12, 0, 0);
    case_made(&house, plan, -1, NULL);
    const char *crowd[] = {"c-1"}, *part[] = {"c"}, *person[] = {"p1"};
    size_t of_crowd = 0, of_part = 0, of_person = 0;
    for (size_t i = 0; i < house.person_count; i++) {
        of_crowd += measure_is_of(&house, i, &(Ids){crowd, 1});
        of_part += measure_is_of(&house, i, &(Ids){part, 1});
        of_person += measure_is_of(&house, i, &(Ids){person, 1});
        CHECK(measure_is_of(&house, i, &(Ids){NULL, 0}));
    }
    CHECK(of_crowd == 2 && of_part == 0 && of_person == 1);
    house_free(&house);
}
