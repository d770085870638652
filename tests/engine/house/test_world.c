/* Tests closed forms of a moving body and invariants of every world. */

#include "house/step.h"
#include "house/world.h"

#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include "case.h"
#include "check.h"
#include "house/drive.h"

/* Without driving: bodies move by forces alone. */
#define FREE(profile_)                                                                                                 \
    "profile." profile_ ".push=0", "profile." profile_ ".turning_moment=0", "profile." profile_ ".side_friction=0"

/* Returns a world whose people have no route and only feel forces. */
typedef struct Still {
    House house;
    Journeys journeys;
    World world;
} Still;

static void still_make(Still *still, json_t *plan, int driving, const char *const *settings) {
    case_made(&still->house, plan, driving, settings);
    still->journeys = (Journeys){.of = memory_zeroed(still->house.person_count, sizeof *still->journeys.of),
                                 .count = still->house.person_count};
    for (size_t i = 0; i < still->house.person_count; i++)
        still->journeys.of[i].route.answer = ROUTE_NO_EXIT;
}

static void still_free(Still *still) {
    world_destroy(&still->world);
    journey_free_all(&still->journeys);
    house_free(&still->house);
}

/* f = sqrt(2 k / m) / (2 pi) sqrt(1 - z^2), z = 2 c / (2 sqrt(2 k m)): the two rings of a corridor. */
TEST(a_disc_in_a_corridor_swings_as_its_two_ring_springs_say) {
    json_t *plan = case_corridor(0.8);
    case_add_person(plan, "miura-chair", 5, 0.03, 0);
    Still s;
    still_make(&s, plan, -1, (const char *[]){FREE("miura-chair"), NULL});
    s.world = world_create(&s.house, s.journeys.of, NULL);
    const Profile *profile = s.house.people[0].profile;
    double k = 2 * profile->space.normal_stiffness, c = 2 * profile->space.normal_damping, m = profile->mass;
    double zeta = c / (2 * sqrt(k * m)), frequency = sqrt(k / m) * sqrt(1 - zeta * zeta) / (2 * M_PI);
    double crossing[3] = {0}, peak[2] = {0};
    int crossings = 0;
    for (int step = 0; step < 20000 && crossings < 3; step++) {
        double before = s.world.centre[0].y;
        step_world(&s.world, NULL);
        double after = s.world.centre[0].y;
        if (before < 0 && after >= 0)
            crossing[crossings++] = (step + before / (before - after)) * s.world.clock.dt;
        if (crossings > 0 && crossings < 3)
            peak[crossings - 1] = fmax(peak[crossings - 1], after);
    }
    CHECK(crossings == 3);
    CHECK_NEAR(1 / (crossing[2] - crossing[1]), frequency, 1e-3 * frequency);
    double decrement = log(peak[0] / peak[1]);
    CHECK_NEAR(decrement / sqrt(4 * M_PI * M_PI + decrement * decrement), zeta, 0.02 * zeta);
    CHECK_NEAR(frequency, 0.5356, 1e-3);
    still_free(&s);
}

TEST(the_ring_brings_a_chair_to_the_middle_of_a_corridor) {
    json_t *plan = case_corridor(0.8);
    case_add_person(plan, "miura-chair", 5, 0.06, 0);
    Still s;
    still_make(&s, plan, -1, (const char *[]){FREE("miura-chair"), NULL});
    s.world = world_create(&s.house, s.journeys.of, NULL);
    for (int step = 0; step < 30000; step++)
        step_world(&s.world, NULL);
    CHECK_NEAR(s.world.centre[0].y, 0, 1e-4);
    still_free(&s);
}

TEST(momentum_between_chairs_is_conserved_to_rounding) {
    for (int driving = 0; driving < 2; driving++) {
        json_t *plan = case_corridor(10);
        case_add_person(plan, "manual-chair", 5, 0, 0);
        case_add_person(plan, "manual-chair", 7, 0.2, 150);
        case_add_person(plan, "manual-chair", 6, -1.7, 80);
        Still s;
        still_make(&s, plan, driving, (const char *[]){FREE("manual-chair"), NULL});
        s.world = world_create(&s.house, s.journeys.of, NULL);
        World *world = &s.world;
        world->velocity[0] = vec2(1.5, 0.1);
        world->velocity[1] = vec2(-1.2, -0.1);
        world->velocity[2] = vec2(0.1, 0.7);
        double mass = s.house.people[0].profile->mass, touched = 0;
        double gyration = s.house.people[0].profile->radius_of_gyration;
        Vec2 momentum[2] = {{0, 0}, {0, 0}};
        double angular[2] = {0, 0};
        for (int end = 0; end < 2; end++) {
            for (int step = 0; end && step < 3000; step++) {
                step_world(world, NULL);
                touched = fmax(touched, world->sense[0].body_force);
            }
            for (int i = 0; i < 3; i++) {
                momentum[end] = vec2_along(momentum[end], mass, world->velocity[i]);
                angular[end] +=
                    mass * (vec2_cross(world->centre[i], world->velocity[i]) + gyration * gyration * world->turn[i]);
            }
        }
        CHECK(touched > 100);
        CHECK_NEAR(momentum[1].x, momentum[0].x, 1e-9);
        CHECK_NEAR(momentum[1].y, momentum[0].y, 1e-9);
        if (driving == DRIVING_DRIVER) /* a disc of the paper does not turn */
            CHECK_NEAR(angular[1], angular[0], 1e-8);
        still_free(&s);
    }
}

TEST(a_chair_that_rolls_has_no_side_slip) {
    json_t *plan = case_corridor(10);
    case_add_person(plan, "manual-chair", 5, 0, 30);
    Still s;
    still_make(&s, plan, -1,
               (const char *[]){"profile.manual-chair.push=0", "profile.manual-chair.turning_moment=0", NULL});
    s.world = world_create(&s.house, s.journeys.of, NULL);
    s.world.velocity[0] = vec2(0.5, 0);
    s.world.turn[0] = 0.5;
    for (int step = 0; step < 2000; step++) {
        step_world(&s.world, NULL);
        Vec2 axis = vec2_heading(s.world.heading[0] - s.world.turn[0] * s.world.clock.dt); /* that of the impulse */
        double slip =
            vec2_dot(s.world.velocity[0], vec2_left(axis)) - s.house.people[0].profile->mass_centre * s.world.turn[0];
        if (step > 300) /* the friction limit first removes the initial velocity */
            CHECK_NEAR(slip, 0, 1e-12);
    }
    still_free(&s);
}

/* Pushed by 100 N and nothing else, at rest against a wall: F = k_n times the overlap. */
TEST(a_chair_pushed_against_a_wall_rests_where_its_spring_says) {
    json_t *plan = case_corridor(3);
    json_array_append_new(json_object_get(plan, "walls"), json_pack("{s:s, s:[[f,f],[f,f]], s:f}", "id", "end",
                                                                    "points", 10.0, -1.5, 10.0, 1.5, "thickness", 0.2));
    case_add_person(plan, "manual-chair", 8, 0, 0);
    Still s;
    still_make(&s, plan, -1,
               (const char *[]){FREE("manual-chair"), "profile.manual-chair.space.reach=0",
                                "profile.manual-chair.space.normal_stiffness=0", NULL});
    s.world = world_create(&s.house, s.journeys.of, NULL);
    const double push = 100;
    const Profile *profile = s.house.people[0].profile;
    for (int step = 0; step < 30000; step++) {
        s.world.velocity[0].x += push / profile->mass * s.world.clock.dt;
        step_world(&s.world, NULL);
    }
    /* At rest: the dashpot takes the push and the braking of one step. */
    double force = s.world.sense[0].body_force, slack = 2 * push / 80 * 1e-3 * profile->contact.normal_damping;
    CHECK_NEAR(force, push, 0.05);
    CHECK_NEAR(-s.world.sense[0].clearance * profile->contact.normal_stiffness, push, slack);
    still_free(&s);
}

/* Alone in a wide corridor: a_0 up to the free speed, then the free speed. */
TEST(a_free_run_accelerates_by_a_0_and_keeps_the_free_speed) {
    for (int driving = 0; driving < 2; driving++) {
        json_t *plan = case_corridor(4);
        case_add_person(plan, "manual-chair", 1, 0, 0);
        House house;
        case_made(&house, plan, driving, NULL);
        const Profile *profile = house.people[0].profile;
        Journeys journeys = journey_plan_all(&house, NULL, 1, NULL);
        World world = world_create(&house, journeys.of, NULL);
        while (clock_time(&world.clock) < 1)
            step_world(&world, NULL);
        CHECK_NEAR(vec2_length(world.velocity[0]), profile->acceleration * clock_time(&world.clock), 2e-3);
        while (clock_time(&world.clock) < 4)
            step_world(&world, NULL);
        CHECK_NEAR(vec2_length(world.velocity[0]), profile->free_speed, 1e-3);
        world_destroy(&world);
        journey_free_all(&journeys);
        house_free(&house);
    }
}

TEST(a_copy_of_a__to_the_same_bits) {
    House house;
    case_house(&house, "two-chairs-corridor", -1, NULL);
    Journeys journeys = journey_plan_all(&house, NULL, 1, NULL);
    World world = world_create(&house, journeys.of, NULL);
    for (int step = 0; step < 3000; step++)
        step_world(&world, NULL);
    World copy = world_copy(&world);
    for (int step = 0; step < 6000; step++)
        step_world(&world, NULL);
    for (int step = 0; step < 6000; step++)
        step_world(&copy, NULL);
    CHECK(copy.digest == world.digest);
    CHECK(memcmp(copy.centre, world.centre, 2 * sizeof *world.centre) == 0);
    world_destroy(&copy);
    world_destroy(&world);
    journey_free_all(&journeys);
    house_free(&house);
}

TEST(two_jobs_give_the_bits_of_one) {
    House house;
    case_house(&house, "ube-techno-house", -1, NULL);
    Observation one = case_run(&house, 1), two = case_run(&house, 2);
    CHECK(one.digest == two.digest);
    CHECK(one.trace.rows == two.trace.rows);
    CHECK(memcmp(one.trace.values, two.trace.values, one.trace.rows * TRACE_COLUMNS * sizeof(double)) == 0);
    observation_free(&one);
    observation_free(&two);
    house_free(&house);
}

TEST(the_order_of_people_in_the_file_does_not_matter) {
    uint64_t digest[2];
    for (int order = 0; order < 2; order++) {
        json_t *plan = case_plan("two-chairs-corridor"), *people = json_object_get(plan, "people");
        if (order) {
            json_array_append(people, json_array_get(people, 0));
            json_array_remove(people, 0);
        }
        House house;
        case_made(&house, plan, -1, NULL);
        Observation observation = case_run(&house, 1);
        digest[order] = observation.digest;
        CHECK(observation.completed);
        observation_free(&observation);
        house_free(&house);
    }
    CHECK(digest[0] == digest[1]);
}

/* Absurd stiffness is refused with its longest step; a step that the check lets through does not diverge. */
TEST(a_step_beyond_the_contact_laws_limit_is_refused) {
    char path[4096], profiles[4096];
    snprintf(path, sizeof path, "%s/houses/straight-corridor.json", check_source());
    snprintf(profiles, sizeof profiles, "%s/assets/profiles", check_source());
    const char *settings[] = {"profile.manual-chair.contact.normal_stiffness=1e8"};
    HouseOptions options = {.profiles = profiles, .settings = settings, .setting_count = 1, .driving = -1};
    House house = {.seed = 0};
    Fault fault = {0};
    CHECK(!house_read(&house, path, &options, &fault));
    CHECK(fault.count == 1 && strstr(fault.lines[0], "needs at most"));
    fault_clear(&fault);
}

/* The driver's moment changes with the turn by m (k^2 + c^2) / tau: the mass centre is c ahead of the axle that stands
 * still. */
TEST(a_turning_chair_needs_the_moment_about_its_axle) {
    const double turns[] = {-0.4, -0.1, 0.1, 0.3}, headings[] = {-25, -8, 0, 12, 30};
    json_t *plan = case_corridor(10);
    case_add_person(plan, "manual-chair", 2, 0, 0);
    House house;
    case_made(
        &house, plan, DRIVING_DRIVER,
        (const char *[]){"profile.manual-chair.turning_moment=1000", "profile.manual-chair.mass_centre=0.2", NULL});
    const Profile *profile = house.people[0].profile;
    Journeys journeys = journey_plan_all(&house, NULL, 1, NULL);
    World world = world_create(&house, journeys.of, NULL);
    while (clock_time(&world.clock) < 1)
        step_world(&world, NULL);
    double square = profile->radius_of_gyration * profile->radius_of_gyration + 0.2 * 0.2;
    for (int h = 0; h < 5; h++) {
        world.heading[0] = radians(headings[h]);
        world.axis[0] = vec2_heading(world.heading[0]);
        world.turn[0] = 0;
        Drive drive = world.drive[0];
        double still = drive_person(&world, 0, &drive).moment;
        for (int t = 0; t < 4; t++) {
            world.turn[0] = turns[t];
            drive = world.drive[0];
            CHECK_NEAR(drive_person(&world, 0, &drive).moment - still,
                       -profile->mass * square * turns[t] / profile->turn_response, 1e-9);
        }
    }
    world_destroy(&world);
    journey_free_all(&journeys);
    house_free(&house);
}
