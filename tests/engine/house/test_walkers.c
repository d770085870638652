/* Tests people on foot: lists, forces, decisions, threads, and the effect of closing an exit. */

#include "house/walkers.h"

#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include "base/random.h"
#include "case.h"
#include "check.h"
#include "house/step.h"
#include "house/world.h"

/* Returns a closed hall from (0, 0) to (width, height) with walls 0.2 m thick. */
static json_t *closed_hall(double width, double height) {
    return json_pack("{s:s, s:i, s:s, s:[{s:s, s:[[i,i],[f,i],[f,f],[i,f],[i,i]], s:f}], s:[], s:[], s:[], s:[]}",
                     "format", "clearance-house", "version", 1, "name", "hall", "walls", "id", "w", "points", 0, 0,
                     width, 0, width, height, 0, height, 0, 0, "thickness", 0.2, "doors", "exits", "crowds", "people");
}

/* Adds a door in the middle of a side (0: bottom, 1: right, 2: top, 3: left) and the exit in it. */
static void add_door(json_t *plan, int side, double at, double width, const char *exit, double closes) {
    json_t *points = json_object_get(json_array_get(json_object_get(plan, "walls"), 0), "points");
    double end[2][2];
    for (int p = 0; p < 2; p++)
        for (int c = 0; c < 2; c++)
            end[p][c] = json_number_value(json_array_get(json_array_get(points, (size_t)(side + p)), (size_t)c));
    Vec2 from = vec2(end[0][0], end[0][1]), along = vec2_unit(vec2_sub(vec2(end[1][0], end[1][1]), from));
    Vec2 middle = vec2_along(vec2_along(from, at, along), -0.1, vec2_left(along));
    Vec2 a = vec2_along(middle, -width / 2, along), b = vec2_along(middle, width / 2, along);
    char id[16];
    snprintf(id, sizeof id, "door-%s", exit);
    json_array_append_new(json_object_get(plan, "doors"),
                          json_pack("{s:s, s:s, s:i, s:f, s:f, s:s}", "id", id, "wall", "w", "segment", side, "at", at,
                                    "width", width, "kind", "opening"));
    json_t *object = json_pack("{s:s, s:[f,f], s:[f,f]}", "id", exit, "from", a.x, a.y, "to", b.x, b.y);
    if (closes > 0)
        json_object_set_new(object, "closes", json_real(closes));
    json_array_append_new(json_object_get(plan, "exits"), object);
}

static void add_crowd(json_t *plan, const char *id, const char *profile, int count, double x0, double y0, double x1,
                      double y1) {
    json_array_append_new(json_object_get(plan, "crowds"),
                          json_pack("{s:s, s:s, s:i, s:[[f,f],[f,f],[f,f],[f,f]]}", "id", id, "profile", profile,
                                    "count", count, "area", x0, y0, x1, y0, x1, y1, x0, y1));
}

/* Returns a hall with three doors and a thousand people of all kinds, twenty of them in chairs. */
static json_t *mixed_hall(void) {
    json_t *plan = closed_hall(36, 30);
    add_door(plan, 1, 15, 1.6, "east", 0);
    add_door(plan, 3, 15, 1.2, "west", 4);
    add_door(plan, 0, 12, 2.0, "south", 0);
    add_crowd(plan, "chairs", "manual-chair", 15, 1, 1, 35, 29);
    add_crowd(plan, "electric", "electric-chair", 5, 1, 1, 35, 29);
    add_crowd(plan, "rollators", "rollator", 40, 1, 1, 35, 29);
    add_crowd(plan, "crutches", "crutches", 40, 1, 1, 35, 29);
    add_crowd(plan, "children", "child", 200, 1, 1, 35, 29);
    add_crowd(plan, "elderly", "elderly", 200, 1, 1, 35, 29);
    add_crowd(plan, "adults", "adult", 500, 1, 1, 35, 29);
    return plan;
}

LONG_TEST(a_thousand_people_and_chairs_have_the_same_digest_with_one_two_and_four_threads) {
    uint64_t digests[3];
    const int jobs[3] = {1, 2, 4};
    for (int k = 0; k < 3; k++) {
        House house;
        case_made(&house, mixed_hall(), -1, (const char *[]){"run.until=6", "run.sample=1", NULL});
        Observation observation = case_run(&house, jobs[k]);
        CHECK(house.person_count == 1000);
        CHECK(observation.wall_crossings == 0);
        digests[k] = observation.digest;
        observation_free(&observation);
        house_free(&house);
    }
    CHECK(digests[1] == digests[0]);
    CHECK(digests[2] == digests[0]);
}

/* With a long step people decide often while others leave: reading data that another thread writes would change the
 * result. */
LONG_TEST(leaving_people_do_not_change_what_others_decide_in_the_same_step) {
    uint64_t digests[4];
    for (int k = 0; k < 4; k++) {
        House house;
        case_made(&house, mixed_hall(), -1, (const char *[]){"run.dt=0.005", "run.until=12", "run.sample=1", NULL});
        Observation observation = case_run(&house, k % 2 ? 4 : 1);
        digests[k] = observation.digest;
        observation_free(&observation);
        house_free(&house);
        CHECK(digests[k] == digests[0]);
    }
}

TEST(walkers_wait_for_an_exit_that_opens_later) {
    json_t *plan = closed_hall(8, 4);
    add_door(plan, 1, 2, 1, "e", 0);
    json_object_set_new(json_array_get(json_object_get(plan, "exits"), 0), "opens", json_real(30));
    case_add_person(plan, "adult", 2, 2, 0);
    House house;
    case_made(&house, plan, -1, NULL);
    Observation observation = case_run(&house, 1);
    CHECK(observation.completed);
    CHECK_NEAR(observation.time, 30.5, 0.6);
    observation_free(&observation);
    house_free(&house);
}

/* Those in front are pressed against the exit by those behind; `beyond` moves the exit out of its door. */
static void press_against_shut_exit(double beyond, double opens, double closes, bool chairs) {
    json_t *plan = closed_hall(10, 6);
    add_door(plan, 1, 3, 1, "e", closes);
    json_t *exit = json_array_get(json_object_get(plan, "exits"), 0);
    if (opens > 0)
        json_object_set_new(exit, "opens", json_real(opens));
    for (int end = 0; end < 2; end++) {
        json_t *point = json_object_get(exit, end ? "to" : "from");
        json_array_set_new(point, 0, json_real(json_number_value(json_array_get(point, 0)) + beyond));
    }
    add_door(plan, 3, 3, 1, "other", 0);
    if (chairs) {
        json_array_remove(json_object_get(plan, "exits"), 1);
        case_add_person(plan, "manual-chair", 7, 3, 0);
        case_add_person(plan, "electric-chair", 5, 3, 0);
    } else {
        add_crowd(plan, "c", "adult", 50, 6, 1, 9, 5);
    }
    House house;
    case_made(&house, plan, -1, NULL);
    Observation observation = case_run(&house, 1);
    for (size_t i = 0; i < observation.person_count; i++) {
        const PersonObservation *person = &observation.people[i];
        CHECK(person->completed);
        if (person->completed && strcmp(house.plan.exits[person->exit].id, "e") == 0)
            CHECK(person->time >= opens && (closes == 0 || person->time <= closes));
    }
    observation_free(&observation);
    house_free(&house);
}

TEST(nobody_is_pressed_out_by_a_shut_exit) {
    for (int place = 0; place < 2; place++) {
        press_against_shut_exit(0.5 * place, 15, 0, false);
        press_against_shut_exit(0.5 * place, 15, 0, true);
        for (double closes = 5; closes < 12; closes += 1)
            press_against_shut_exit(0.5 * place, 0, closes, false);
    }
}

TEST(each_of_two_doors_takes_its_own_time_to_open) {
    json_t *plan = closed_hall(10, 4);
    add_door(plan, 1, 2, 1, "e", 0);
    for (int k = 0; k < 2; k++) {
        char wall[] = "across-0", door[] = "shut-0";
        wall[7] = door[5] = (char)('0' + k);
        double x = 4 + 0.3 * k;
        json_array_append_new(json_object_get(plan, "walls"), json_pack("{s:s, s:[[f,f],[f,f]], s:f}", "id", wall,
                                                                        "points", x, 0.0, x, 4.0, "thickness", 0.1));
        json_array_append_new(json_object_get(plan, "doors"),
                              json_pack("{s:s, s:s, s:i, s:f, s:f, s:s, s:s, s:f}", "id", door, "wall", wall, "segment",
                                        0, "at", 2.0, "width", 0.9, "kind", "sliding", "state", "closed",
                                        "opening_time", 8.0));
    }
    case_add_person(plan, "adult", 1, 2, 0);
    House house;
    case_made(&house, plan, -1, NULL);
    Observation observation = case_run(&house, 1);
    CHECK(observation.completed);
    CHECK_NEAR(observation.time, 9.1 / 1.34 + 2 * 8, 3);
    observation_free(&observation);
    house_free(&house);
}

TEST(momentum_between_walkers_is_conserved_to_rounding) {
    json_t *plan = closed_hall(40, 40);
    add_crowd(plan, "c", "adult", 120, 16, 16, 24, 24);
    add_crowd(plan, "k", "child", 60, 16, 16, 24, 24);
    House house;
    case_made(&house, plan, -1, (const char *[]){"profile.adult.push=0", "profile.child.push=0", NULL});
    Journeys journeys = journey_plan_all(&house, NULL, 1, NULL);
    World world = world_create(&house, journeys.of, NULL);
    Random random = random_seed(7, 7);
    for (size_t i = 0; i < world.count; i++)
        world.velocity[i] = vec2(random_normal(&random, 0, 0.8), random_normal(&random, 0, 0.8));
    world.walkers.doors = -1; /* the slots receive the velocities */
    Vec2 momentum[2] = {{0, 0}, {0, 0}};
    double hardest = 0;
    for (int end = 0; end < 2; end++) {
        for (int step = 0; end && step < 2000; step++) {
            step_world(&world, NULL);
            for (size_t i = 0; world.sensed && i < world.count; i++)
                hardest = fmax(hardest, world.sense[i].body_force);
        }
        for (size_t i = 0; i < world.count; i++)
            momentum[end] = vec2_along(momentum[end], house.people[i].profile->mass, world.velocity[i]);
    }
    CHECK(hardest > 100);
    CHECK_NEAR(momentum[1].x, momentum[0].x, 1e-8);
    CHECK_NEAR(momentum[1].y, momentum[0].y, 1e-8);
    world_destroy(&world);
    journey_free_all(&journeys);
    house_free(&house);
}

/* Momentum of a chair and of the walkers that push it: equal and opposite. */
TEST(momentum_between_walkers_and_chairs_is_conserved_to_rounding) {
    json_t *plan = closed_hall(40, 40);
    add_crowd(plan, "a", "manual-chair", 10, 15, 15, 25, 25);
    add_crowd(plan, "c", "adult", 60, 15, 15, 25, 25);
    House house;
    case_made(&house, plan, -1,
              (const char *[]){"profile.adult.push=0", "profile.manual-chair.push=0",
                               "profile.manual-chair.turning_moment=0", "profile.manual-chair.side_friction=0", NULL});
    Journeys journeys = journey_plan_all(&house, NULL, 1, NULL);
    World world = world_create(&house, journeys.of, NULL);
    Random random = random_seed(8, 8);
    for (size_t i = 0; i < world.count; i++)
        world.velocity[i] = vec2(random_normal(&random, 0, 0.8), random_normal(&random, 0, 0.8));
    world.walkers.doors = -1;
    Vec2 momentum[2] = {{0, 0}, {0, 0}};
    for (int end = 0; end < 2; end++) {
        for (int step = 0; end && step < 2000; step++)
            step_world(&world, NULL);
        for (size_t i = 0; i < world.count; i++)
            momentum[end] = vec2_along(momentum[end], house.people[i].profile->mass, world.velocity[i]);
    }
    CHECK_NEAR(momentum[1].x, momentum[0].x, 1e-8);
    CHECK_NEAR(momentum[1].y, momentum[0].y, 1e-8);
    world_destroy(&world);
    journey_free_all(&journeys);
    house_free(&house);
}

TEST(lists_hold_everybody_who_can_be_felt_at_every_step) {
    House house;
    case_made(&house, mixed_hall(), -1, NULL);
    Journeys journeys = journey_plan_all(&house, NULL, 2, NULL);
    World world = world_create(&house, journeys.of, NULL);
    size_t missing = 0, found = 0, made = 0;
    const uint32_t *lists = NULL;
    for (int step = 0; step < 600; step++) {
        step_world(&world, NULL);
        const Walkers *walkers = &world.walkers;
        made += walkers->other != lists;
        lists = walkers->other;
        for (uint32_t a = 0; step % 40 == 0 && a < walkers->cells.count; a++)
            for (uint32_t b = 0; b < walkers->cells.count; b++) {
                const WalkerLaw *law = &walkers->laws[walkers->kind[a] * walkers->kind_count + walkers->kind[b]];
                Vec2 from = vec2_sub(walkers->at[a], walkers->at[b]);
                bool walk = walkers->kinds[walkers->kind[a]].walks && walkers->kinds[walkers->kind[b]].walks;
                if (a == b || !walk || vec2_dot(from, from) >= law->range2)
                    continue;
                bool listed = false;
                for (uint32_t k = walkers->first[a]; k < walkers->first[a + 1]; k++)
                    listed |= walkers->other[k] == b;
                missing += !listed;
                found++;
            }
    }
    CHECK(found > 1000);
    CHECK(missing == 0);
    CHECK(made < 60); /* they stay for many steps */
    world_destroy(&world);
    journey_free_all(&journeys);
    house_free(&house);
}

TEST(a_copy_of_a_crowd_goes_on_with_the_same_bits) {
    House house;
    case_made(&house, mixed_hall(), -1, NULL);
    Journeys journeys = journey_plan_all(&house, NULL, 2, NULL);
    World world = world_create(&house, journeys.of, NULL);
    for (int step = 0; step < 333; step++)
        step_world(&world, NULL);
    World copy = world_copy(&world);
    for (int step = 0; step < 333; step++) {
        step_world(&world, NULL);
        step_world(&copy, NULL);
    }
    CHECK(copy.digest == world.digest);
    world_destroy(&copy);
    world_destroy(&world);
    journey_free_all(&journeys);
    house_free(&house);
}

TEST(numbers_that_diverge_name_the_walker_and_keep_the_last_good_state) {
    json_t *plan = closed_hall(10, 10);
    add_crowd(plan, "c", "adult", 20, 1, 1, 9, 9);
    House house;
    case_made(&house, plan, -1, NULL);
    Journeys journeys = journey_plan_all(&house, NULL, 1, NULL);
    World world = world_create(&house, journeys.of, NULL);
    step_world(&world, NULL);
    Vec2 good = world.centre[7];
    world.velocity[7] = vec2(NAN, 0);
    world.walkers.doors = -1;
    size_t who = SIZE_MAX;
    CHECK(step_world(&world, &who) == STEP_DIVERGED);
    CHECK(who == 7 && world.reason[7] == REASON_DIVERGED);
    CHECK(world.centre[7].x == good.x && world.centre[7].y == good.y);
    world_destroy(&world);
    journey_free_all(&journeys);
    house_free(&house);
}

TEST(somebody_alone_walks_at_the_free_speed) {
    House house;
    json_t *plan = case_corridor(2);
    case_add_person(plan, "adult", 0.5, 0, 0);
    case_made(&house, plan, -1, NULL);
    Observation observation = case_run(&house, 1);
    CHECK(observation.completed);
    CHECK_NEAR(observation.people[0].path_length, 17.5, 0.02);
    CHECK_NEAR(observation.people[0].time, 17.5 / house.people[0].speed, 0.5);
    observation_free(&observation);
    house_free(&house);
}

TEST(nobody_is_stuck_behind_the_jambs_of_a_narrow_door) {
    for (int k = 0; k < 3; k++) {
        const double widths[3] = {0.70, 0.80, 0.90};
        json_t *plan = closed_hall(6, 5);
        add_door(plan, 1, 2.5, widths[k], "e", 0);
        add_crowd(plan, "c", "adult", 30, 0.3, 0.3, 5.7, 4.7);
        House house;
        case_made(&house, plan, -1, NULL);
        Observation observation = case_run(&house, 1);
        printf("  %.2f m: 30 people in %.1f s\n", widths[k], observation.time);
        CHECK(observation.completed);
        CHECK(observation.wall_crossings == 0);
        observation_free(&observation);
        house_free(&house);
    }
}

TEST(people_whose_exit_closes_turn_to_the_other) {
    json_t *plan = closed_hall(20, 6);
    add_door(plan, 1, 3, 1, "near", 2);
    add_door(plan, 3, 3, 1, "far", 0);
    add_crowd(plan, "c", "adult", 20, 12, 1, 17, 5);
    case_add_person(plan, "manual-chair", 14, 3, 0);
    House house;
    case_made(&house, plan, -1, NULL);
    Observation observation = case_run(&house, 1);
    size_t far = 0;
    for (size_t i = 0; i < observation.person_count; i++)
        far += observation.people[i].completed && strcmp(house.plan.exits[observation.people[i].exit].id, "far") == 0;
    CHECK(observation.completed);
    CHECK(far >= 18);
    observation_free(&observation);
    house_free(&house);
}

TEST(those_who_cannot_get_out_are_named_and_the_others_go_on) {
    json_t *plan = closed_hall(12, 6);
    add_door(plan, 1, 3, 1, "e", 0);
    json_array_append_new(json_object_get(plan, "walls"), json_pack("{s:s, s:[[f,f],[f,f]], s:f}", "id", "across",
                                                                    "points", 5.0, 0.0, 5.0, 6.0, "thickness", 0.1));
    json_array_append_new(json_object_get(plan, "doors"),
                          json_pack("{s:s, s:s, s:i, s:f, s:f, s:s}", "id", "slit", "wall", "across", "segment", 0,
                                    "at", 3.0, "width", 0.3, "kind", "opening"));
    add_crowd(plan, "in", "adult", 4, 1, 1, 4, 5);
    add_crowd(plan, "out", "adult", 4, 6, 1, 11, 5);
    House house;
    case_made(&house, plan, -1, NULL);
    Observation observation = case_run(&house, 1);
    for (size_t i = 0; i < observation.person_count; i++) {
        const PersonObservation *person = &observation.people[i];
        bool inside = strncmp(house.people[i].id, "in", 2) == 0;
        CHECK(person->completed == !inside);
        if (inside) {
            CHECK(person->reason == REASON_CANNOT_PASS);
            CHECK_TEXT(person->blockage.what, "door slit");
            CHECK_NEAR(person->blockage.has, 0.3, 0.02);
        }
    }
    observation_free(&observation);
    house_free(&house);
}

TEST(walkers_open_a_shut_door) {
    json_t *plan = closed_hall(8, 4);
    add_door(plan, 1, 2, 1, "e", 0);
    json_array_append_new(json_object_get(plan, "walls"), json_pack("{s:s, s:[[f,f],[f,f]], s:f}", "id", "across",
                                                                    "points", 4.0, 0.0, 4.0, 4.0, "thickness", 0.1));
    json_array_append_new(json_object_get(plan, "doors"),
                          json_pack("{s:s, s:s, s:i, s:f, s:f, s:s, s:s, s:f}", "id", "shut", "wall", "across",
                                    "segment", 0, "at", 2.0, "width", 0.9, "kind", "sliding", "state", "closed",
                                    "opening_time", 3.0));
    case_add_person(plan, "adult", 1, 2, 0);
    House house;
    case_made(&house, plan, -1, NULL);
    Observation observation = case_run(&house, 1);
    CHECK(observation.completed);
    CHECK_NEAR(observation.time, 7.1 / 1.34 + 3, 1.2);
    observation_free(&observation);
    house_free(&house);
}

TEST(a_crowd_has_the_speeds_of_its_profile) {
    json_t *plan = closed_hall(60, 60);
    add_crowd(plan, "c", "rollator", 800, 1, 1, 59, 59);
    House house;
    case_made(&house, plan, -1, NULL);
    double sum = 0;
    for (size_t i = 0; i < house.person_count; i++)
        sum += house.people[i].speed;
    CHECK_NEAR(sum / (double)house.person_count, house.people[0].profile->free_speed, 0.03);
    house_free(&house);
}

/* Returns how many of sixty people, who stand before the near exit of a hall, leave by the far exit. `across` is the
 * length of a wall that stands between the two exits, m; 0: none. */
static size_t people_by_the_far_exit(double across, int jobs, uint64_t *digest) {
    json_t *plan = closed_hall(16, 10);
    add_door(plan, 0, 5, 0.8, "near", 0);
    add_door(plan, 0, 11, 0.8, "far", 0);
    add_crowd(plan, "c", "adult", 60, 1, 1, 7, 7);
    if (across > 0)
        json_array_append_new(json_object_get(plan, "walls"),
                              json_pack("{s:s, s:[[f,f],[f,f]], s:f}", "id", "across", "points", 8.0, 0.0, 8.0, across,
                                        "thickness", 0.1));
    House house;
    case_made(&house, plan, -1, NULL);
    Observation observation = case_run(&house, jobs);
    size_t far = 0;
    for (size_t i = 0; i < observation.person_count; i++)
        far += observation.people[i].completed && strcmp(house.plan.exits[observation.people[i].exit].id, "far") == 0;
    printf("  wall of %.1f m: %zu of 60 by the far exit, all in %.1f s\n", across, far, observation.time);
    CHECK(observation.completed);
    *digest = observation.digest;
    observation_free(&observation);
    house_free(&house);
    return far;
}

TEST(people_turn_from_a_queue_to_another_exit_that_they_see) {
    uint64_t digest, again, hidden;
    size_t far = people_by_the_far_exit(0, 1, &digest);
    CHECK(far >= 15 && far <= 30);
    CHECK(people_by_the_far_exit(0, 3, &again) == far);
    CHECK(again == digest);
    CHECK(people_by_the_far_exit(9, 1, &hidden) == 0);
}
