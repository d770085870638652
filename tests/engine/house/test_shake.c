#include "house/shake.h"

#include <stdint.h>
#include <stdio.h>
#include <unistd.h>

#include "check.h"
#include "scratch.h"
#include "house/run.h"

/* A room of 6 m by 4 m with its exit on the right; a wardrobe in the middle falls upwards, a shelf at the wall falls
 * downwards, a table never falls. */
#define ROOM                                                                                                           \
    "{'format': 'clearance-house', 'version': 1, 'name': 'room', 'walls': ["                                           \
    "{'id': 'w1', 'points': [[0, 0], [6, 0], [6, 4], [0, 4], [0, 0]], 'thickness': 0.1}],"                             \
    "'doors': [{'id': 'd1', 'wall': 'w1', 'segment': 1, 'at': 2, 'width': 1.2}],"                                      \
    "'exits': [{'id': 'e1', 'from': [6.1, 1.4], 'to': [6.1, 2.6]}],"
#define WARDROBE                                                                                                       \
    "{'id': 'wardrobe', 'centre': [3, 0.5], 'size': [1, 0.5], 'height': 1.8, 'topples': 'back', 'probability': 1}"
#define TABLE "{'id': 'table', 'centre': [5, 0.5], 'size': [1, 0.5], 'probability': 1}"
#define SHELF "{'id': 'shelf', 'centre': [1, 3.7], 'size': [1, 0.3], 'height': 1, 'topples': 'front'}"

static bool read_house(House *house, const char *text, uint64_t seed, bool shake) {
    char path[SCRATCH_PATH], profiles[4096];
    scratch_write(path, text);
    snprintf(profiles, sizeof profiles, "%s/assets/profiles", check_source());
    Fault fault = {0};
    *house = (House){0};
    bool good = house_read(house, path,
                           &(HouseOptions){.profiles = profiles, .seed = seed, .driving = -1, .shake = shake}, &fault);
    for (size_t i = 0; i < fault.count; i++)
        printf("%s\n", fault.lines[i]);
    CHECK(good);
    fault_clear(&fault);
    unlink(path);
    return good;
}

static Observation run(const House *house) {
    Observation observation;
    run_house(&observation, house, &(RunOptions){.route = SIZE_MAX, .jobs = 1});
    return observation;
}

TEST(what_cannot_topple_does_not_and_what_surely_does_always_does) {
    House house;
    read_house(&house, ROOM "'furniture': [" WARDROBE ", " TABLE "]}", 1, false);
    for (uint64_t seed = 0; seed < 200; seed++) {
        bool topples[2];
        shake_draw(&house.plan, seed, topples);
        CHECK(topples[0] && !topples[1]);
    }
    house_free(&house);
}

TEST(a_piece_topples_as_often_as_its_probability_says) {
    Furniture piece = {.id = "f1", .topples = TOPPLE_FRONT, .probability = 0.3};
    Plan plan = {.furniture = &piece, .furniture_count = 1};
    size_t fell = 0;
    bool topples;
    for (uint64_t seed = 0; seed < 10000; seed++) {
        shake_draw(&plan, seed, &topples);
        fell += topples;
    }
    CHECK_NEAR((double)fell / 10000, 0.3, 4 * 0.0046); /* four standard deviations */
}

TEST(one_piece_more_changes_nothing_for_the_others) {
    Furniture few[2] = {{.id = "a", .topples = TOPPLE_BACK, .probability = 0.5},
                        {.id = "b", .topples = TOPPLE_BACK, .probability = 0.5}};
    Furniture many[3] = {few[1], {.id = "c", .topples = TOPPLE_LEFT, .probability = 0.5}, few[0]};
    Plan plan = {.furniture = few, .furniture_count = 2}, other = {.furniture = many, .furniture_count = 3};
    size_t different = 0;
    for (uint64_t seed = 0; seed < 100; seed++) {
        bool one[2], two[3];
        shake_draw(&plan, seed, one);
        shake_draw(&other, seed, two);
        CHECK(one[0] == two[2] && one[1] == two[0]);
        different += one[0] != one[1];
    }
    CHECK(different > 25 && different < 75); /* and two pieces fall independently */
}

TEST(what_lies_already_cannot_fall_again) {
    Furniture piece = {.id = "f1", .topples = TOPPLE_FRONT, .probability = 1, .toppled = true};
    Plan plan = {.furniture = &piece, .furniture_count = 1};
    bool topples = true;
    shake_draw(&plan, 1, &topples);
    CHECK(!topples);
}

TEST(a_shaken_house_is_the_one_that_its_settings_make) {
    House shaken, plain;
    const char *text = ROOM "'furniture': [" WARDROBE ", " SHELF ", " TABLE "],"
                            "'people': [{'id': 'p1', 'profile': 'manual-chair', 'at': [1, 1]}]}";
    read_house(&plain, text, 3, false);
    bool topples[3];
    shake_draw(&plain.plan, 3, topples);
    const char *settings[3];
    Arena arena = {0};
    size_t count = shake_settings(&plain.plan, topples, settings, &arena);
    CHECK(count >= 1);
    CHECK_TEXT(settings[0], "furniture.wardrobe.toppled=true");
    read_house(&shaken, text, 3, true);
    char path[SCRATCH_PATH], profiles[4096];
    scratch_write(path, text);
    snprintf(profiles, sizeof profiles, "%s/assets/profiles", check_source());
    Fault fault = {0};
    CHECK(house_read(
        &plain, path,
        &(HouseOptions){.profiles = profiles, .settings = settings, .setting_count = count, .seed = 3, .driving = -1},
        &fault));
    unlink(path);
    Observation one = run(&shaken), two = run(&plain);
    CHECK(one.completed && one.digest == two.digest && one.time == two.time);
    observation_free(&one);
    observation_free(&two);
    house_free(&shaken);
    house_free(&plain);
    arena_clear(&arena);
}

/* The fallen wardrobe lies from y = 0.25 to 2.55 and from x = 2.5 to 3.5. */
TEST(whoever_stands_where_a_piece_falls_is_caught_under_it) {
    static const char *const profiles[] = {"manual-chair", "adult"};
    for (int p = 0; p < 2; p++) {
        char text[2048];
        snprintf(text, sizeof text,
                 ROOM "'furniture': [" WARDROBE "],"
                      "'people': [{'id': 'p1', 'profile': '%s', 'at': [3, 1.8]},"
                      "{'id': 'p2', 'profile': 'adult', 'at': [4.5, 3.2]}]}",
                 profiles[p]);
        House house;
        read_house(&house, text, 1, true);
        Observation observation = run(&house);
        const PersonObservation *caught = observation_of_person(&house, &observation, "p1");
        CHECK(caught->took_part && !caught->completed && caught->reason == REASON_CANNOT_PASS);
        CHECK_TEXT(caught->blockage.what, "under furniture wardrobe");
        CHECK(observation_of_person(&house, &observation, "p2")->completed && !observation.completed);
        CHECK_NEAR(caught->blockage.at.x, 3, 1e-9);
        observation_free(&observation);
        house_free(&house);
    }
}

TEST(a_body_is_caught_from_the_first_millimetres_on) {
    Furniture piece = {.id = "f1",
                       .centre = {0, 0},
                       .size = {1, 0.5},
                       .angle = 30,
                       .height = 1,
                       .topples = TOPPLE_RIGHT,
                       .probability = 1};
    Plan plan = {.furniture = &piece, .furniture_count = 1};
    bool topples = true;
    Profile disc = {.driving = DRIVING_WALKER, .width = 0.4}, chair = {.driving = DRIVING_DRIVER};
    chair.length = 1;
    chair.width = 0.6;
    chair.axle = 0.3;
    Vec2 out = vec2_heading(radians(30)); /* its far end lies 1.5 m from its centre */
    for (int touches = 0; touches < 2; touches++) {
        double off = touches ? -0.005 : 0.005;
        Inhabitant person = {.profile = &disc, .at = vec2_scale(out, 1.7 + off)};
        CHECK((shake_catches(&plan, &topples, &person) == &piece) == touches);
        person = (Inhabitant){.profile = &chair, .at = vec2_scale(out, 1.8 + off), .heading = radians(30)};
        CHECK((shake_catches(&plan, &topples, &person) == &piece) == touches);
        person.at = vec2_scale(out, 1.8 + off); /* sideways: half its width */
        person.heading = radians(120);
        CHECK((shake_catches(&plan, &topples, &person) == &piece) == touches);
    }
}

TEST(a_crowd_stands_in_a_shake_where_it_stands_without) {
    const char *text = ROOM "'furniture': [" WARDROBE ", " SHELF "],"
                            "'crowds': [{'id': 'c', 'profile': 'adult', 'count': 30,"
                            "'area': [[0.3, 1], [5.5, 1], [5.5, 3.2], [0.3, 3.2]]}]}";
    House plain, shaken;
    read_house(&plain, text, 7, false);
    read_house(&shaken, text, 7, true);
    size_t caught = 0;
    for (size_t i = 0; i < plain.person_count; i++) {
        CHECK(plain.people[i].at.x == shaken.people[i].at.x && plain.people[i].at.y == shaken.people[i].at.y);
        caught += shaken.people[i].under != NULL;
    }
    CHECK(caught > 0 && caught < 30);
    Observation observation = run(&shaken);
    for (size_t i = 0; i < shaken.person_count; i++)
        CHECK(observation.people[i].completed == !shaken.people[i].under);
    observation_free(&observation);
    house_free(&plain);
    house_free(&shaken);
}

TEST(whoever_something_lies_on_already_is_caught_too) {
    House house;
    if (!read_house(&house,
                    ROOM "'furniture': [{'id': 'wardrobe', 'centre': [3, 0.5], 'size': [1, 0.5], 'height': 1.8, "
                         "'topples': 'back', 'toppled': true}], "
                         "'people': [{'id': 'p1', 'profile': 'manual-chair', 'at': [3, 1.5]}]}",
                    1, false))
        return;
    Observation observation = run(&house);
    CHECK(house.people[0].under == &house.plan.furniture[0]);
    CHECK(observation.people[0].reason == REASON_CANNOT_PASS);
    CHECK_TEXT(observation.people[0].blockage.what, "under furniture wardrobe");
    observation_free(&observation);
    house_free(&house);
}
