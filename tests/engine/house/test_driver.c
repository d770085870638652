/* Tests of the law by which a driver steers, of a driver's strength, and of how hard a touch is. */

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "case.h"
#include "base/random.h"
#include "check.h"
#include "house/journey.h"
#include "house/phase.h"
#include "house/run.h"
#include "house/step.h"
#include "house/touch.h"
#include "house/world.h"
#include "inquiry/grade.h"
#include "planned_time.h"
#include "rooms.h"
#include "route/pace.h"
#include "route/search.h"
#include "route/smooth.h"
#include "route/strength.h"

/* The drive of a chair through a corridor. */
typedef struct Driven {
    double time;      /* s; infinite: it does not get out */
    double late;      /* m, farthest from the middle after 4.5 m of way */
    double last;      /* m, farthest from the middle in the last 2 m */
    double over;      /* m, farthest beyond the middle */
    double narrowest; /* m */
    double slowest;   /* m/s, from x = 7.3 to 8.3 m */
    double impact;    /* m/s */
} Driven;

static json_t *closed_corridor(double width, double y) {
    json_t *plan = case_corridor(width);
    json_array_append_new(json_object_get(plan, "walls"),
                          json_pack("{s:s, s:[[f,f],[f,f]], s:f}", "id", "west", "points", 0.0, -width / 2 - 0.1, 0.0,
                                    width / 2 + 0.1, "thickness", 0.2));
    case_add_person(plan, "manual-chair", 1, y, 0);
    return plan;
}

/* Drives the chair of a house by the plan for another one, which may be the same. */
static Driven drive_by(const House *house, const House *known) {
    Journeys journeys = journey_plan_all(known, NULL, 1, NULL);
    World world = world_create(house, journeys.of, NULL);
    double side = house->people[0].at.y < 0 ? -1 : 1;
    Driven drive = {.narrowest = HUGE_VAL, .slowest = HUGE_VAL};
    while (phase_any_active(&world)) {
        step_world(&world, NULL);
        Vec2 at = world_reference(&world, 0);
        double away = fabs(at.y);
        drive.late = at.x > 5.5 ? fmax(drive.late, away) : drive.late;
        drive.last = at.x > 16 ? fmax(drive.last, away) : drive.last;
        drive.over = fmax(drive.over, -side * at.y);
        drive.narrowest = fmin(drive.narrowest, world.sense[0].clearance);
        drive.impact = fmax(drive.impact, world.sense[0].impact);
        if (at.x > 7.3 && at.x < 8.3)
            drive.slowest = fmin(drive.slowest, vec2_length(world.velocity[0]));
    }
    drive.time = world.phase[0] == PHASE_OUT ? clock_time(&world.clock) : HUGE_VAL;
    world_destroy(&world);
    journey_free_all(&journeys);
    return drive;
}

static Driven drive_plan(json_t *plan, json_t *known, const char *const *settings) {
    House house, other;
    case_made(&house, plan, -1, settings);
    if (known)
        case_made(&other, known, -1, settings);
    Driven drive = drive_by(&house, known ? &other : &house);
    house_free(&house);
    if (known)
        house_free(&other);
    return drive;
}

/* The front edge is aimed back by e (1 + x) exp(-x), so that the tail does not swing out. */
TEST(put_off_its_plan_a_chair_comes_back_without_swinging) {
    Driven left = drive_plan(closed_corridor(0.9, 0.09), closed_corridor(0.9, 0), NULL);
    Driven right = drive_plan(closed_corridor(0.9, -0.09), closed_corridor(0.9, 0), NULL);
    printf("narrowest %.1f mm, %.1f mm off after 4.5 m\n", 1000 * left.narrowest, 1000 * left.late);
    CHECK(left.late < 0.01 && left.over < 0.005 && left.narrowest >= 0.04);
    CHECK_NEAR(right.time, left.time, 1e-9);
    CHECK_NEAR(right.narrowest, left.narrowest, 1e-9);
    CHECK_NEAR(right.late, left.late, 1e-9);
}

TEST(a_chair_comes_to_the_middle_of_a_corridor_from_any_start) {
    for (double width = 0.75; width < 1.21; width += 0.15) {
        double most = width / 2 - 0.315;
        const double starts[] = {0, most / 2, -0.9 * most, most - 0.005};
        for (size_t k = 0; k < sizeof starts / sizeof *starts; k++) {
            Driven drive = drive_plan(closed_corridor(width, starts[k]), NULL, NULL);
            printf("corridor %.2f m, start %.3f m aside: %.2f s, last %.4f m, narrowest %.1f mm\n", width, starts[k],
                   drive.time, drive.last, 1000 * drive.narrowest);
            CHECK(drive.time < HUGE_VAL && drive.narrowest > 0);
            CHECK(drive.last < (width < 1.05 ? 0.01 : 0.02));
        }
    }
    for (int side = -1; side <= 1; side += 2) { /* turned towards the middle */
        json_t *plan = closed_corridor(1.05, side * 0.105);
        json_object_set_new(json_array_get(json_object_get(plan, "people"), 0), "heading", json_real(-side * 12));
        Driven drive = drive_plan(plan, NULL, NULL);
        printf("corridor 1.05 m, turned by %d degrees: last %.4f m\n", -side * 12, drive.last);
        CHECK(drive.time < HUGE_VAL && drive.narrowest > 0 && drive.last < 0.01);
    }
    const char *const fine[] = {"run.dt=0.00025", NULL};
    Driven drive = drive_plan(closed_corridor(0.9, 0.07), NULL, NULL);
    CHECK_NEAR(drive_plan(closed_corridor(0.9, 0.07), NULL, fine).time, drive.time, 1e-3 * drive.time);
}

/* A box of 0.3 m that reaches `into` m into a corridor of 1.2 m. */
static json_t *boxed_corridor(double into) {
    json_t *plan = closed_corridor(1.2, 0);
    json_object_set_new(
        plan, "furniture",
        json_pack("[{s:s, s:[f,f], s:[f,f]}]", "id", "box", "centre", 8.0, -0.75 + into, "size", 0.3, 0.3));
    return plan;
}

TEST(what_the_plan_does_not_know_is_steered_round_or_braked_for) {
    Driven beside = drive_plan(boxed_corridor(0.15), closed_corridor(1.2, 0), NULL);
    printf("a box beside the way: %.1f mm, %.2f m/s\n", 1000 * beside.narrowest, beside.slowest);
    CHECK(beside.time < HUGE_VAL && beside.narrowest >= 0.10 && beside.slowest > 0.5);
    Driven before = drive_plan(boxed_corridor(0.3), closed_corridor(1.2, 0), NULL);
    printf("a box in the way: impact %.3f m/s\n", before.impact);
    CHECK(before.impact <= 0.05);
    const char *const off[] = {"run.ring=\"off\"", NULL};
    Driven blind = drive_plan(boxed_corridor(0.3), closed_corridor(1.2, 0), off);
    printf("without the personal space: impact %.3f m/s\n", blind.impact);
    CHECK(blind.impact > 0.05);
}

/* m/s, drive.creep of the manual chair */
static const double CREEP = 0.1;

static Driven drive_through_door(double width) {
    json_t *plan = closed_corridor(2, 0.3), *walls = json_object_get(plan, "walls");
    for (int side = -1; side <= 1; side += 2)
        json_array_append_new(walls, json_pack("{s:s, s:[[f,f],[f,f]], s:f}", "id", side < 0 ? "low" : "high", "points",
                                               8.0, side * 1.05, 8.0, side * width / 2, "thickness", 0.12));
    return drive_plan(plan, NULL, NULL);
}

TEST(a_door_takes_the_longer_the_narrower_it_is) {
    static const double widths[] = {0.66, 0.68, 0.70, 0.75};
    double last = HUGE_VAL, first = 0, slowest = 0;
    for (size_t k = 0; k < sizeof widths / sizeof *widths; k++) {
        Driven drive = drive_through_door(widths[k]);
        printf("door %.2f m: %.2f s, narrowest %.1f mm, slowest %.3f m/s\n", widths[k], drive.time,
               1000 * drive.narrowest, drive.slowest);
        CHECK(drive.time < last && drive.narrowest > 0);
        last = drive.time;
        slowest = drive.slowest;
        first = k == 0 ? slowest : first;
    }
    /* With 1.5 cm on either side, or less, a chair creeps at 0.10 m/s; with 6 cm it drives at 2 c / b = 0.30 m/s. */
    CHECK_NEAR(first, CREEP, 1e-3);
    CHECK_NEAR(slowest, 0.3, 3e-3);
    Driven gap = drive_through_door(0.636); /* 3 mm on either side */
    CHECK(gap.time < HUGE_VAL && gap.narrowest > 0);
    CHECK_NEAR(gap.slowest, CREEP, 1e-3);
}

/* A chair comes by a sliding door in a thin wall, 6.5 cm from its leaf. */
TEST(a_shut_door_beside_the_way_stays_shut) {
    House house;
    json_t *plan = closed_corridor(0.7 - 2 * 0.07, 0), *north = json_array_get(json_object_get(plan, "walls"), 1);
    json_object_set_new(north, "thickness", json_real(0.06));
    json_object_set_new(json_array_get(json_object_get(plan, "walls"), 0), "thickness", json_real(0.06));
    json_object_set_new(plan, "doors",
                        json_pack("[{s:s, s:s, s:f, s:f, s:s, s:s}]", "id", "d1", "wall", "north", "at", 8.0, "width",
                                  0.8, "kind", "sliding", "state", "closed"));
    case_made(&house, plan, -1, NULL);
    Observation observation = case_run(&house, 1);
    CHECK(observation.completed && !isfinite(observation.door_opened[0]));
    observation_free(&observation);
    house_free(&house);
}

/* A chair whose way back to where it has been takes longer than people wait without progress. */
TEST(who_is_pushed_back_comes_again) {
    House house;
    case_made(&house, closed_corridor(0.75, 0), -1, (const char *const[]){"run.patience=3", NULL});
    Journeys journeys = journey_plan_all(&house, NULL, 1, NULL);
    World world = world_create(&house, journeys.of, NULL);
    bool pushed = false;
    while (phase_any_active(&world)) {
        step_world(&world, NULL);
        if (!pushed && world_reference(&world, 0).x > 6) {
            world.centre[0].x -= 2; /* 7 s at 0.3 m/s */
            world.drive[0].index = 0;
            pushed = true;
        }
    }
    CHECK(pushed && world.phase[0] == PHASE_OUT);
    world_destroy(&world);
    journey_free_all(&journeys);
    house_free(&house);
}

/* The chair stays within what the plan leaves free of it, also where that is 4 mm and it goes back twice. */
TEST(a_chair_touches_nothing_where_its_plan_is_free) {
    static const double legs[][2] = {{0.90, 0.90}, {0.92, 0.92}, {1.20, 0.80}};
    for (size_t k = 0; k < sizeof legs / sizeof *legs; k++) {
        House house;
        case_made(&house, case_corner(legs[k][0], legs[k][1], 0), -1, NULL);
        Journeys journeys = journey_plan_all(&house, NULL, 1, NULL);
        Observation observation = case_run(&house, 1);
        const PersonObservation *person = &observation.people[0];
        printf("corner %.2f, %.2f m: %.2f s, planned %.1f mm, driven %.1f mm\n", legs[k][0], legs[k][1], person->time,
               1000 * journeys.of[0].route.narrowest, 1000 * person->narrowest);
        CHECK(person->completed && journeys.of[0].route.narrowest > 0);
        CHECK(person->contacts == 0 && person->narrowest > 0);
        observation_free(&observation);
        journey_free_all(&journeys);
        house_free(&house);
    }
}

#define TRACKED 0.01 /* m: a chair drives this near to its path */

/* Where nothing disturbs a chair, the run is the plan: it takes the planned time, and no less clearance than TRACKED
 * allows. Returns whether something was touched, which may be where the plan itself has less than that to spare. */
static bool check_as_planned(json_t *plan, const char *profile, const char *what) {
    bool touched = false;
    House house;
    json_t *person = json_array_get(json_object_get(plan, "people"), 0);
    json_object_set_new(person, "profile", json_string(profile));
    case_made(&house, plan, -1, NULL);
    Journeys journeys = journey_plan_all(&house, NULL, 1, NULL);
    const Route *route = &journeys.of[0].route;
    if (route->answer == ROUTE_FOUND) {
        Observation observation = case_run(&house, 1);
        const PersonObservation *driven = &observation.people[0];
        double time = planned_time(&house, house.people[0].profile, route),
               least = rooms_clearance_along(&house.space, house.people[0].profile, route);
        printf("%s, %s: planned %.2f s, %.1f mm, driven %.2f s, %.1f mm\n", what, profile, time, 1000 * least,
               driven->time, 1000 * driven->narrowest);
        CHECK_NEAR(route->narrowest, least, 2e-4);
        CHECK(driven->completed && driven->narrowest > least - TRACKED);
        CHECK(driven->contacts == 0 || (least < TRACKED && driven->impact < 0.1));
        touched = driven->contacts > 0;
        CHECK_NEAR(driven->time, time, 0.03 * time);
        observation_free(&observation);
    }
    journey_free_all(&journeys);
    house_free(&house);
    return touched;
}

static double between(Random *random, double low, double high) {
    return low + (high - low) * random_uniform(random);
}

static void check_houses_as_planned(int count) {
    static const char *const profiles[] = {"manual-chair", "electric-chair", "assisted-chair"};
    Random random = random_seed(11, 0);
    int touched = 0;
    for (int k = 0; k < count; k++) {
        char what[80];
        const char *profile = profiles[k / 2 % 3];
        double angle = k % 3 ? between(&random, 0, 2 * M_PI) : 0;
        double first = between(&random, 0.84, 1.25), second = between(&random, 0.84, 1.25);
        snprintf(what, sizeof what, "corner %.3f, %.3f m", first, second);
        touched += check_as_planned(case_corner(first, second, angle), profile, what);
        double wide = between(&random, 0.94, 1.35), door = between(&random, 0.72, 0.92);
        snprintf(what, sizeof what, "door of %.3f m %s a corridor of %.3f m", door, k % 2 ? "into" : "out of", wide);
        touched += check_as_planned(case_side_door(wide, door, k % 2, angle), profile, what);
    }
    CHECK(touched <= count / 100); /* an electric chair in a door of 0.725 m */
}

TEST(a_chair_drives_as_planned) {
    check_houses_as_planned(6);
}

LONG_TEST(a_chair_drives_as_planned_in_many_houses) {
    check_houses_as_planned(100);
}

/* Every driver gets out by the way that is planned for the strength there is, without a touch, and none the later the
 * stronger: by more than 0.5 % of the time, since ways are found by descent. */
LONG_TEST(a_weak_driver_plans_for_the_strength_that_there_is) {
    static const char *const rows[2] = {"push", "turning_moment"};
    static const int strengths[2][9] = {{10, 20, 30, 60, 100}, {2, 3, 4, 5, 8, 12, 20, 35, 55}};
    for (int row = 0; row < 2; row++) {
        double last[8] = {HUGE_VAL, HUGE_VAL, HUGE_VAL, HUGE_VAL, HUGE_VAL, HUGE_VAL, HUGE_VAL, HUGE_VAL};
        for (int k = 0; k < 9 && strengths[row][k]; k++) {
            House house;
            char setting[80];
            snprintf(setting, sizeof setting, "profile.manual-chair.%s=%d", rows[row], strengths[row][k]);
            case_house(&house, "ube-techno-house", -1, (const char *const[]){setting, NULL});
            Journeys journeys = journey_plan_all(&house, NULL, 1, NULL);
            Observation observation = case_run(&house, 1);
            printf("%s:", setting);
            for (size_t i = 0; i < observation.person_count; i++) {
                const PersonObservation *person = &observation.people[i];
                printf(" %.2f s %.3f m/s", person->time, person->impact);
                CHECK(person->completed == (journeys.of[i].route.answer == ROUTE_FOUND));
                CHECK(person->impact <= 0.05);
                CHECK(person->time <= last[i] * 1.005);
                last[i] = person->time;
            }
            printf("\n");
            observation_free(&observation);
            journey_free_all(&journeys);
            house_free(&house);
        }
    }
}

/* What `check` finds before anything moves, a run and a grade tell alike. */
static Blockage weak_at(json_t *plan, const char *one, const char *two) {
    House house;
    case_made(&house, plan, -1, (const char *[]){one, two, NULL});
    Journeys journeys = journey_plan_all(&house, NULL, 1, NULL);
    Observation observation = case_run(&house, 1);
    Grade grade = grade_person(&house, 0, NULL);
    const PersonObservation *person = &observation.people[0];
    const Route *route = &journeys.of[0].route;
    bool weak = route->answer == ROUTE_TOO_WEAK;
    char said[ROUTE_WIDTHS] = "";
    if (weak)
        route_widths(&route->blockage, said, sizeof said);
    printf("%s %s: %s %s %s\n", one, two ? two : "", observation_reason(person->reason), person->blockage.what, said);
    CHECK(weak == (person->reason == REASON_TOO_WEAK) && weak == grade.weak && person->completed == !weak);
    CHECK(!weak || (grade.letter == GRADE_E && route->fits && !route->drivable && person->blockage.posed));
    CHECK(!weak || strcmp(person->blockage.what, route->blockage.what) == 0);
    CHECK(!weak || strncmp(grade.what, person->blockage.what, 4) == 0); /* on the first way, not the quickest */
    Blockage blockage = person->blockage;
    observation_free(&observation);
    journey_free_all(&journeys);
    house_free(&house);
    return blockage;
}

/* On the spot: the row, and some 0.05 N m for the inertia. */
TEST(a_turn_on_the_spot_asks_for_the_scrub_and_hardly_more) {
    House house;
    case_made(&house, closed_corridor(1.2, 0), -1, (const char *[]){"profile.manual-chair.scrub=26", NULL});
    Profile weak = *house.people[0].profile;
    weak.turning_moment = 2;
    Route route = {.answer = ROUTE_FOUND, .count = 3};
    route.poses = memory_zeroed(route.count, sizeof *route.poses);
    route.poses[1] = (Pose){.at = {1, 0}, .direction = 1};
    route.poses[2] = (Pose){.at = {1, 0}, .heading = M_PI_2};
    strength_test(&route, &weak, false);
    Blockage spot = route.blockage;
    CHECK(route.answer == ROUTE_TOO_WEAK && route.fits);
    CHECK(spot.lacks == LACK_MOMENT && strcmp(spot.what, "turn at (1.00, 0.00)") == 0);
    CHECK(spot.needs > 26 && spot.needs < 26.1);
    CHECK_NEAR(spot.has, 2, 1e-9);
    route_free(&route);
    house_free(&house);
}

/* From rest: 80 kg (0.1 m/s)^2 / (2 0.5 m) = 0.8 N. */
TEST(who_is_too_weak_at_any_speed_is_told_so_by_check_run_and_grade) {
    Blockage push = weak_at(closed_corridor(1.2, 0), "profile.manual-chair.push=0.001", NULL);
    CHECK(push.lacks == LACK_PUSH && strncmp(push.what, "start from rest at ", 19) == 0);
    CHECK_NEAR(push.needs, 0.8, 0.01);
    CHECK_NEAR(push.has, 0.001, 1e-9);
    CHECK(weak_at(closed_corridor(1.2, 0), "profile.manual-chair.push=1", NULL).needs == 0);
    /* Where bends and changes of direction lead round, nobody has to turn on the spot. */
    CHECK(weak_at(case_corner(0.90, 0.90, 0), "profile.manual-chair.turning_moment=2", "profile.manual-chair.scrub=26")
              .needs == 0);
    CHECK(weak_at(case_corner(1.6, 1.6, 0), "profile.manual-chair.scrub=60", NULL).needs == 0);
    Blockage bend = weak_at(case_corner(1.6, 1.6, 0), "profile.manual-chair.turning_moment=0.001", NULL);
    CHECK(bend.lacks == LACK_MOMENT && bend.needs > 0.01);
    CHECK(weak_at(closed_corridor(1.2, 0), "profile.manual-chair.turning_moment=0", NULL).needs == 0);
}

typedef struct Bump {
    double speed, energy, impulse; /* m/s, J, N s */
} Bump;

/* Lets a chair without strength, on the plan of one with, roll at 0.3 m/s against a wall across its way, 0.1 mm ahead
 * of its front edge. */
static Bump roll_against_wall(double damping) {
    House house, known;
    char setting[80];
    snprintf(setting, sizeof setting, "profile.manual-chair.contact.normal_damping=%.6f", damping);
    const char *const settings[] = {setting, "profile.manual-chair.push=0.001", "run.ring=\"off\"", NULL};
    json_t *plan = closed_corridor(1.5, 0), *open = json_deep_copy(plan);
    json_array_append_new(
        json_object_get(plan, "walls"),
        json_pack("{s:s, s:[[f,f],[f,f]], s:f}", "id", "east", "points", 1.9201, -0.9, 1.9201, 0.9, "thickness", 0.2));
    case_made(&house, plan, -1, settings);
    case_made(&known, open, -1, NULL);
    Journeys journeys = journey_plan_all(&known, NULL, 1, NULL);
    World world = world_create(&house, journeys.of, NULL);
    Bump bump = {0};
    world.velocity[0] = vec2(0.3, 0);
    for (int step = 0; step < 500; step++) {
        step_world(&world, NULL);
        bump.speed = fmax(bump.speed, world.sense[0].impact);
        bump.energy = fmax(bump.energy, world.sense[0].energy);
        bump.impulse += world.sense[0].body_force * world.clock.dt;
    }
    world_destroy(&world);
    journey_free_all(&journeys);
    house_free(&house);
    house_free(&known);
    return bump;
}

/* m v^2 / 2 = 3.6 J and, by the contact law with its damping ratio of 0.707, 1.208 m v = 29.1 N s. */
TEST(a_wall_is_met_with_the_speed_and_energy_of_the_chair_whatever_the_damping) {
    const double damping = sqrt(2 * 80.2 * 20000);
    Bump bump = roll_against_wall(damping);
    printf("against a wall: %.4f m/s, %.3f J, %.2f N s\n", bump.speed, bump.energy, bump.impulse);
    CHECK_NEAR(bump.speed, 0.3, 0.005);
    CHECK_NEAR(bump.energy, 3.6, 0.03 * 3.6);
    CHECK_NEAR(bump.impulse, 29.1, 0.05 * 29.1);
    for (double factor = 0.5; factor < 3; factor *= 4) {
        Bump other = roll_against_wall(factor * damping);
        CHECK_NEAR(other.speed, bump.speed, 1e-3 * bump.speed);
        CHECK_NEAR(other.energy, bump.energy, 1e-3 * bump.energy);
    }
}

TEST(an_impact_has_the_mass_that_resists_it) {
    Profile chair = {.driving = DRIVING_DRIVER, .length = 1.1, .width = 0.63, .axle = 0.28, .mass = 80.2};
    chair.mass_centre = 0.15;
    chair.radius_of_gyration = 0.35;
    Vec2 axis = {1, 0};
    CHECK_NEAR(touch_mass(&chair, axis, vec2(0.67, 0), vec2(-1, 0)), 80.2, 1e-9); /* head on */
    /* A front corner sideways, 0.82 m ahead of the axle: m (k^2 + c^2) / 0.82^2. */
    CHECK_NEAR(touch_mass(&chair, axis, vec2(0.67, 0.315), vec2(0, -1)), 17.3, 0.02 * 17.3);
    Sense sense = {0};
    touch_begin(&sense, &chair, axis, vec2(0.67, 0.1), vec2(-1, 0), 0.1, HUGE_VAL); /* it leaves */
    CHECK_NEAR(sense.impact, 0, 0);
    touch_begin(&sense, &chair, axis, vec2(0.67, 0), vec2(-1, 0), -0.3, HUGE_VAL);
    CHECK_NEAR(sense.impact, 0.3, 0);
    CHECK_NEAR(sense.energy, 80.2 * 0.09 / 2, 1e-9); /* 3.6 J */
    CHECK(sense.part == PART_FRONT);
    sense = (Sense){.impact = 0}; /* another chair head on, which gives way as much */
    touch_begin(&sense, &chair, axis, vec2(0.67, 0), vec2(-1, 0), -0.6, 80.2);
    CHECK_NEAR(sense.energy, 40.1 * 0.36 / 2, 1e-9);
}

TEST(switches_of_the_paper_s_chair_change_its_run) {
    double times[3];
    const char *const switches[3] = {"run.lateral=\"on\"", "run.centripetal=\"off\"", "run.lateral=\"off\""};
    for (int w = 0; w < 3; w++) {
        House house;
        case_house(&house, "corner-1.20-1.20", DRIVING_MIURA, (const char *const[]){switches[w], NULL});
        Observation observation = case_run(&house, 1);
        times[w] = observation.people[0].completed ? observation.people[0].time : HUGE_VAL;
        observation_free(&observation);
        house_free(&house);
    }
    printf("miura %.2f s, without F4 %.2f s, without lateral control %.2f s\n", times[0], times[1], times[2]);
    CHECK(fabs(times[1] - times[0]) < 0.2); /* s: F4 hardly matters */
    CHECK(times[1] != times[0]);
}
