#include "check.h"

#include <stdint.h>

#include "planned_time.h"
#include "route/hasten.h"
#include "tight.h"

static Profile manual_chair(void) {
    Profile profile = {0};
    Fault fault = {0};
    char path[4096];
    snprintf(path, sizeof path, "%s/assets/profiles/manual-chair.json", check_source());
    CHECK(profile_read(&profile, path, &fault));
    check_say(&fault);
    return profile;
}

/* A hall of 12 m by 12 m, the exit across x = 4. */
static TightScene hall(void) {
    TightScene scene = {.count = 4, .exit = {{4, -5}, {4, 5}}};
    const Vec2 corners[4] = {{-6, -6}, {6, -6}, {6, 6}, {-6, 6}};
    for (int i = 0; i < 4; i++)
        scene.solids[i] = (TightSolid){corners[i], corners[(i + 1) % 4], 0.06, true};
    return scene;
}

/* Returns the planned time of some poses in the hall, s. */
static double time_in_hall(const Profile *profile, Pose *poses, size_t count) {
    static TightHouse tight;
    TightScene scene = hall();
    tight_build(&tight, &scene, profile);
    Route route = {.answer = ROUTE_FOUND, .poses = poses, .count = count};
    double time = planned_time(&tight.house, profile, &route);
    tight_free(&tight);
    return time;
}

enum { MOST_POSES = 400 };

/* Adds poses on a straight line along x, every centimetre. */
static size_t roll(Pose *poses, size_t count, double from, double to, double heading, int direction) {
    int steps = (int)lround(fabs(to - from) / 0.01);
    for (int i = count > 0; i <= steps; i++)
        poses[count++] = (Pose){vec2(from + (to - from) * i / steps, 0), heading, ROUTE_CLEARANCE_REACH, direction};
    return count;
}

TEST(planned_time_of_a_straight_path_has_a_closed_form) {
    Profile profile = manual_chair();
    Pose poses[MOST_POSES];
    size_t count = roll(poses, 0, 1.005, 4.205, 0, 1);
    double v = profile.free_speed, a = profile.acceleration;
    CHECK_NEAR(time_in_hall(&profile, poses, count), 2.995 / v + v / (2 * a), 0.002);
    profile_free(&profile);
}

TEST(planned_time_counts_turns_on_the_spot_and_changes_of_direction) {
    Profile profile = manual_chair();
    double a = profile.acceleration, d = 0.8 * profile.deceleration, v = profile.free_speed;
    double back = profile.reversing_speed;
    Pose poses[MOST_POSES];
    size_t count = roll(poses, 0, 3.005, 2.005, 0, -1); /* backwards, then forwards */
    count = roll(poses, count, 2.005, 4.005, 0, 1);
    double away = 1 / back + back / (2 * a) + back / (2 * d), out = 1.995 / v + v / (2 * a);
    CHECK_NEAR(time_in_hall(&profile, poses, count), away + profile.reversing_time + out, 0.05);
    count = roll(poses, 0, 3.005, 2.005, M_PI, 1); /* forwards, half a turn, then forwards */
    for (int i = 1; i <= 36; i++)
        poses[count++] = (Pose){vec2(2.005, 0), M_PI - M_PI * i / 36, ROUTE_CLEARANCE_REACH, 0};
    count = roll(poses, count, 2.005, 4.005, 0, 1);
    double peak = fmin(v, sqrt(2 * a * d / (a + d)));
    away = 1 / peak + peak / (2 * a) + peak / (2 * d);
    CHECK_NEAR(time_in_hall(&profile, poses, count), away + M_PI / profile.turn_rate + out, 0.05);
    profile_free(&profile);
}

TEST(a_sweep_finds_an_overlap_between_two_poses) {
    Profile profile = manual_chair();
    TightScene scene = {.count = 1};
    scene.solids[0] = (TightSolid){{0.9, 0.40}, {1.1, 0.40}, 0.10, false}; /* its lower side at y = 0.30 */
    Pose poses[2] = {{vec2(-1, 0), 0, 0, 1}, {vec2(3, 0), 0, 0, 1}};
    Route route = {.answer = ROUTE_FOUND, .poses = poses, .count = 2};
    CHECK_NEAR(tight_sweep(&scene, &profile, &route), 0.30 - profile.width / 2, 1e-12);
    scene.solids[0] = (TightSolid){{0.95, 0.36}, {1.05, 0.36}, 0.02, false};
    CHECK_NEAR(tight_sweep(&scene, &profile, &route), 0.34 - profile.width / 2, 1e-12);
    /* A quarter turn on an arc of 1 m about (0, 1): the outer front corner is the farthest from it. */
    scene.solids[0] = (TightSolid){{3, -5}, {3, 5}, 0.1, false};
    Pose quarter[2] = {{vec2(0, 0), 0, 0, 1}, {vec2(1, 1), M_PI_2, 0, 1}};
    route.poses = quarter;
    double corner = hypot(1 + profile.width / 2, profile.length - profile.axle);
    CHECK_NEAR(tight_sweep(&scene, &profile, &route), 2.9 - corner, 1e-5);
    profile_free(&profile);
}

TEST(tight_houses_are_within_reach_of_their_start_and_moved_as_a_whole) {
    Profile profile = manual_chair();
    static TightHouse tight, other;
    for (uint64_t seed = 0; seed < 60; seed++) {
        TightScene scene = tight_draw((TightKind)(seed % TIGHT_KINDS), seed), moved = scene;
        tight_move(&moved, seed & 1, 0.1 + (double)seed, vec2(700, -900));
        tight_build(&tight, &scene, &profile);
        tight_build(&other, &moved, &profile);
        double clearance[2];
        for (int i = 0; i < 2; i++) {
            const TightHouse *of = i ? &other : &tight;
            Vec2 axis = vec2_heading(of->query.heading);
            Vec2 centre = vec2_along(of->query.at, profile.length / 2 - profile.axle, axis);
            clearance[i] =
                freespace_clearance(&of->house.space, centre, axis, profile.length / 2, profile.width / 2, 0.5, NULL);
        }
        CHECK(clearance[0] > 0.05);
        CHECK_NEAR(clearance[0], clearance[1], 2e-6); /* outlines are rounded to 1 um */
        tight_free(&tight);
        tight_free(&other);
    }
    profile_free(&profile);
}

static Vec2 rounded(Vec2 at, double parts) {
    return vec2(round(at.x * parts) / parts, round(at.y * parts) / parts);
}

static void round_scene(TightScene *scene, double parts) {
    for (size_t i = 0; i < scene->count; i++) {
        scene->solids[i].a = rounded(scene->solids[i].a, parts);
        scene->solids[i].b = rounded(scene->solids[i].b, parts);
    }
    for (int i = 0; i < 2; i++)
        scene->exit[i] = rounded(scene->exit[i], parts);
    scene->at = rounded(scene->at, parts);
    scene->heading = radians(round(degrees(scene->heading) * parts) / parts);
}

/* Houses drawn to the millimetre, and copies of them that were turned and written to a file, to the nanometre: the same
 * answers, changes of direction and times. */
TEST(a_house_that_was_turned_and_written_to_a_file_has_the_same_routes) {
    Profile profile = manual_chair();
    static TightHouse tight, other;
    for (uint64_t seed = 0; seed < 20; seed++) {
        TightScene scene = tight_draw((TightKind)(seed % TIGHT_KINDS), 900 + seed);
        round_scene(&scene, 1e3);
        TightScene moved = scene;
        tight_move(&moved, seed & 1, 0.1 + (double)seed, vec2(12, -9));
        round_scene(&moved, 1e9);
        tight_build(&tight, &scene, &profile);
        tight_build(&other, &moved, &profile);
        Route route = route_drive(&tight.query), turned = route_drive(&other.query);
        CHECK(route.answer == turned.answer);
        CHECK(route.reversals == turned.reversals);
        if (route.answer == ROUTE_FOUND && turned.answer == ROUTE_FOUND)
            CHECK_NEAR(planned_time(&other.house, &profile, &turned), planned_time(&tight.house, &profile, &route),
                       1e-3);
        route_free(&route);
        route_free(&turned);
        tight_free(&tight);
        tight_free(&other);
    }
    profile_free(&profile);
}

TEST(free_space_only_grows_when_a_tight_house_gets_wider) {
    Profile profile = manual_chair();
    static TightHouse tight, other;
    Random random = random_seed(5, 3);
    for (uint64_t seed = 0; seed < 12; seed++) {
        TightScene scene = tight_draw((TightKind)(seed % TIGHT_KINDS), seed), wider = scene;
        tight_shrink(&wider, 0.025);
        tight_build(&tight, &scene, &profile);
        tight_build(&other, &wider, &profile);
        for (int i = 0; i < 2000; i++) {
            Vec2 at = vec2_along(scene.at, 5 * random_uniform(&random), vec2_heading(7 * random_uniform(&random)));
            if (freespace_distance(&tight.house.space, at) < 0.1) /* inside, or where interpolation is not exact */
                continue;
            double before = freespace_exact(&tight.house.space, at, 0.5, NULL);
            CHECK(freespace_exact(&other.house.space, at, 0.5, NULL) >= before - 1e-9);
        }
        tight_free(&tight);
        tight_free(&other);
    }
    profile_free(&profile);
}

/* Returns the route through a tight house whose passages are wider by `wider` m. */
static Route route_through(TightHouse *tight, TightKind kind, uint64_t seed, double wider, const Profile *profile) {
    TightScene scene = tight_draw(kind, seed);
    tight_shrink(&scene, wider / 2);
    tight_build(tight, &scene, profile);
    return route_drive(&tight->query);
}

/* Cases in which a way without a change of direction is known: its time, s, with the width that both jambs leave. */
TEST(a_little_more_room_never_costs_a_change_of_direction) {
    static const struct {
        TightKind kind;
        uint64_t seed;
        double wider, time;
    } known[] = {
        {TIGHT_IN, 175, 0.01, 13.3}, {TIGHT_IN, 115, 0.01, 13.3}, {TIGHT_IN, 67, 0.02, 14.1},
        {TIGHT_IN, 13, 0.02, 14.9},  {TIGHT_OUT, 146, 0, 15.7},   {TIGHT_U, 130, 0.02, 16.8},
    };
    Profile profile = manual_chair();
    static TightHouse tight;
    for (size_t i = 0; i < sizeof known / sizeof *known; i++) {
        Route route = route_through(&tight, known[i].kind, known[i].seed, known[i].wider, &profile);
        CHECK(route.answer == ROUTE_FOUND);
        CHECK_NEAR(route.reversals, 0, 0);
        CHECK(planned_time(&tight.house, &profile, &route) <= 1.02 * known[i].time);
        route_free(&route);
        tight_free(&tight);
    }
    profile_free(&profile);
}

/* Doors that are hardly wider than the chair, which creeps through them: what a way costs while it is planned, at any
 * distance of its stations, and what it takes when it is driven. */
TEST(a_way_takes_as_long_as_it_was_planned_with) {
    static const struct {
        TightKind kind;
        uint64_t seed;
    } cases[] = {{TIGHT_OUT, 1002}, {TIGHT_IN, 1001}};
    static const double spacings[] = {0.05, 0.04, 0.031, 0.025}; /* m */
    Profile profile = manual_chair();
    static TightHouse tight;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        Route route = route_through(&tight, cases[i].kind, cases[i].seed, 0, &profile);
        CHECK(route.answer == ROUTE_FOUND);
        double time = planned_time(&tight.house, &profile, &route);
        SearchTrack track = {.poses = route.poses, .count = route.count, .exit = route.exit};
        Rectangle body = search_body(&profile);
        for (size_t k = 0; k < sizeof spacings / sizeof *spacings; k++) {
            Way way = way_of_track(&track, &tight.house.plan.exits[route.exit], NULL, 0, spacings[k]);
            CHECK_NEAR(hasten_time(&way, tight.query.space, &body, &profile), time, 0.02 * time);
            way_free(&way);
        }
        route_free(&route);
        tight_free(&tight);
    }
    profile_free(&profile);
}

/* One solid 1 and 3 cm smaller on every side: cases in which the answer was a no, a needless change of direction, or a
 * longer time. */
TEST(a_smaller_solid_never_costs_time) {
    static const struct {
        TightKind kind;
        uint64_t seed;
        size_t solid;
    } cases[] = {{TIGHT_WIDE_DOOR, 1, 4}, {TIGHT_WIDE_DOOR, 408, 2}, {TIGHT_SLALOM, 23, 0}};
    static const double smaller[] = {0, 0.01, 0.03}; /* m */
    Profile profile = manual_chair();
    static TightHouse tight;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        double best = HUGE_VAL;
        for (size_t k = 0; k < sizeof smaller / sizeof *smaller; k++) {
            TightScene scene = tight_draw(cases[i].kind, cases[i].seed);
            tight_grow(&scene, cases[i].solid, -smaller[k]);
            tight_build(&tight, &scene, &profile);
            Route route = route_drive(&tight.query);
            CHECK(route.answer == ROUTE_FOUND);
            double time = planned_time(&tight.house, &profile, &route);
            CHECK(time <= 1.01 * best);
            best = fmin(best, time);
            route_free(&route);
            tight_free(&tight);
        }
    }
    profile_free(&profile);
}

/* With the same room on both sides the middle is the best place. */
TEST(a_chair_keeps_to_the_middle_of_a_straight_corridor) {
    Profile profile = manual_chair();
    static TightHouse tight;
    TightScene scene = {.count = 3, .exit = {{9, 0}, {9, 0.88}}, .at = {1, 0.44}};
    scene.solids[0] = (TightSolid){{0, -0.05}, {10, -0.05}, 0.05, true};
    scene.solids[1] = (TightSolid){{0, 0.93}, {10, 0.93}, 0.05, true};
    scene.solids[2] = (TightSolid){{-0.05, -0.1}, {-0.05, 0.98}, 0.05, true};
    tight_build(&tight, &scene, &profile);
    Route route = route_drive(&tight.query);
    CHECK(route.answer == ROUTE_FOUND);
    for (size_t i = 0; i < route.count; i++)
        CHECK_NEAR(route.poses[i].at.y, 0.44, 0.005);
    route_free(&route);
    tight_free(&tight);
    profile_free(&profile);
}
