#include "check.h"

#include <math.h>
#include <stdint.h>

#include "base/memory.h"
#include "rooms.h"
#include "route/settle.h"
#include "route/hasten.h"
#include "route/pace.h"

/* Two passages, both open at the ends: from (1, W1 / 2) along the first to the exit across the second, 4 m behind the
 * inner corner. */
static void make_corner(Rooms *fixture, double w1, double w2, double angle) {
    *fixture = (Rooms){.profile = rooms_chair(1.1, 0.63)};
    const Vec2 points[6] = {{-1, w1}, {4, w1}, {4, w1 + 5}, {-1, 0}, {4 + w2, 0}, {4 + w2, w1 + 5}};
    for (size_t i = 0; i < 6; i++)
        fixture->points[i] = points[i];
    fixture->walls[0] = (Wall){.id = "w1", .points = {fixture->points, 3}};
    fixture->walls[1] = (Wall){.id = "w2", .points = {fixture->points + 3, 3}};
    fixture->exits[0] = (Exit){.id = "e1", .from = {4, w1 + 4}, .to = {4 + w2, w1 + 4}, .closes = HUGE_VAL};
    fixture->plan =
        (Plan){.name = "corner", .walls = fixture->walls, .wall_count = 2, .exits = fixture->exits, .exit_count = 1};
    fixture->query.at = vec2(1, w1 / 2);
    rooms_build(fixture);
    rooms_turn(fixture, angle, vec2(0, 0));
}

/* Returns the time of the way that is decided for, s. */
static double decided_time(Rooms *fixture, int *reversals) {
    RouteQuery query = fixture->query;
    query.fields = fields_create();
    Rectangle body = search_body(query.profile);
    Goal goal = field_exit_goal(SIZE_MAX, 0, 0);
    SearchTrack track = {0};
    FitPlace tightest;
    size_t pin;
    CHECK(settle_way(&query, &body, &goal, 1, 0.05, &track, &pin, &tightest) == DECIDE_FOUND);
    *reversals = track.reversals;
    Way way = way_of_track(&track, &query.plan->exits[0], NULL, 0, 0.05);
    double time = hasten_time(&way, query.space, &body, query.profile);
    way_free(&way);
    search_track_clear(&track);
    fields_destroy(query.fields);
    return time;
}

/* Returns the skids, m, with which the chair gets round a corner, after checking their track; 0: it does not. */
static double skids(double width) {
    Rooms fixture;
    rooms_make_corner(&fixture, 1.1, 0.63, width, width, false);
    fixture.profile.skid_time = 100;
    RouteQuery query = fixture.query;
    query.fields = fields_create();
    Rectangle body = search_body(query.profile);
    Goal goal = field_exit_goal(SIZE_MAX, 0, 0);
    SearchTrack track = {0};
    bool found = decide_with_skids(&query, &body, &goal, 1, &track) == SEARCH_FOUND;
    double skid = 0;
    for (size_t i = 1; found && i < track.count; i++) {
        const Pose *from = &track.poses[i - 1], *to = &track.poses[i];
        double turn = vec2_wrap_angle(to->heading - from->heading), shift = vec2_distance(from->at, to->at);
        Vec2 middle = vec2_along(from->at, body.ahead, vec2_heading(from->heading));
        Vec2 later = vec2_along(to->at, body.ahead, vec2_heading(to->heading));
        CHECK(search_clearance(query.space, &body, to->at, to->heading, 0.1, NULL) > 0);
        if (to->direction)
            continue;
        CHECK(shift < 1e-9 || vec2_distance(middle, later) < 1e-9); /* on the spot it turns about axle or middle */
        skid += shift < 1e-9 ? 0 : body.ahead * fabs(turn);
    }
    CHECK_NEAR(track.skid, found ? skid : 0, 1e-9);
    search_track_clear(&track);
    fields_destroy(query.fields);
    rooms_free(&fixture);
    return found ? skid : 0;
}

/* The closed form for a helper, who shifts the chair anywhere, is 0.834 m; without skids it needs about 0.90 m. */
TEST(a_chair_that_skids_needs_hardly_more_room_than_one_that_is_carried) {
    double last = HUGE_VAL;
    CHECK_NEAR(skids(0.82), 0, 0);
    for (double width = 0.86; width < 0.895; width += 0.01) {
        double skid = skids(width);
        CHECK(skid > 0 && skid <= last);
        last = skid;
    }
    CHECK(last < 0.1); /* m: in all */
}

/* The times are the least ones that many searches and long descents have found, s. */
TEST(a_corner_is_turned_in_the_least_time_that_is_known) {
    const struct {
        double width, time;
    } known[] = {{0.92, 14.5}, {0.93, 14.0}, {0.94, 13.7}, {0.96, 13.6}, {1.00, 13.2}, {1.20, 12.0}, {1.50, 12.0}};
    double last = HUGE_VAL;
    for (size_t i = 0; i < sizeof known / sizeof *known; i++) {
        Rooms fixture;
        int reversals;
        make_corner(&fixture, known[i].width, known[i].width, 0);
        double time = decided_time(&fixture, &reversals);
        CHECK(time <= 1.03 * known[i].time);
        CHECK(time <= 1.01 * last); /* room never costs time */
        CHECK_NEAR(reversals, 0, 0);
        last = time;
        rooms_free(&fixture);
    }
}

TEST(a_tight_corner_takes_the_same_time_at_any_angle) {
    const double angles[] = {radians(10), radians(30), radians(45)};
    Rooms fixture;
    int reversals;
    make_corner(&fixture, 0.93, 0.93, 0);
    double time = decided_time(&fixture, &reversals);
    rooms_free(&fixture);
    for (size_t i = 0; i < sizeof angles / sizeof *angles; i++) {
        make_corner(&fixture, 0.93, 0.93, angles[i]);
        CHECK_NEAR(decided_time(&fixture, &reversals), time, 0.01 * time);
        CHECK_NEAR(reversals, 0, 0);
        rooms_free(&fixture);
    }
}

TEST(a_body_that_does_not_fit_is_proved_not_to) {
    Rooms fixture;
    rooms_make_corner(&fixture, 1.1, 0.63, 0.82, 0.82, false);
    fixture.query.fields = fields_create();
    Rectangle body = search_body(fixture.query.profile);
    Goal goal = field_exit_goal(SIZE_MAX, 0, 0);
    SearchTrack track = {0};
    FitPlace tightest;
    size_t pin;
    CHECK(settle_way(&fixture.query, &body, &goal, 1, 0.05, &track, &pin, &tightest) == DECIDE_TOO_NARROW);
    CHECK_NEAR((double)track.count, 0, 0);
    CHECK_NEAR(tightest.margin, (2 * (M_SQRT2 * 0.82 - 0.63) - 1.1) / 6, 0.004);
    fields_destroy(fixture.query.fields);
    rooms_free(&fixture);
}

/* The corners of the body, which turns about an axle off its middle, pass a post in a few hundredths of a radian. */
TEST(a_turn_on_the_spot_is_as_tight_as_its_tightest_heading) {
    const double room = 0.02; /* m, between the circle of the front corners and the post */
    Rooms fixture = {.profile = rooms_chair(1.1, 0.63)};
    Rectangle body = search_body(&fixture.profile);
    double radius = hypot(body.ahead + body.half_length, body.half_width);
    for (int i = 0; i < 12; i++) {
        double aside = radians(20 + 3.3 * i);
        Vec2 post = vec2_scale(vec2_heading(aside), radius + room);
        fixture.points[0] = post;
        fixture.points[1] = vec2_along(post, 1, vec2_heading(aside));
        fixture.walls[0] = (Wall){.id = "w1", .points = {fixture.points, 2}};
        fixture.exits[0] = (Exit){.id = "e1", .from = {-3, -1}, .to = {-3, 1}, .closes = HUGE_VAL};
        fixture.plan =
            (Plan){.name = "post", .walls = fixture.walls, .wall_count = 1, .exits = fixture.exits, .exit_count = 1};
        rooms_build(&fixture);
        Station stations[4] = {{.at = {0, 0}}, {.at = {-0.1, 0}}, {.at = {-0.2, 0}}, {.at = {-0.3, 0}}};
        WayPiece piece = {0, 3, 1, 0.1};
        Joint joint = {.in = 0, .out = M_PI, .turns = true};
        Way way = {.stations = stations,
                   .count = 4,
                   .pieces = &piece,
                   .joints = &joint,
                   .piece_count = 1,
                   .exit = &fixture.exits[0]};
        CHECK_NEAR(way_spot_clearance(&way, 0, &fixture.space, &body, 0.5), room, 0.001);
        rooms_free(&fixture);
    }
}

TEST(the_pace_follows_its_limits) {
    Profile chair = rooms_chair(1.1, 0.63);
    Agility agility = pace_agility(&chair);
    CHECK_NEAR(pace_at(&chair, &agility, 0.69, 1, 0, 0, 1), 0.69, 0);                  /* free */
    CHECK_NEAR(pace_at(&chair, &agility, 0.69, 0.1, 0, 0, 1), 0.5, 1e-12);             /* 2 c / b */
    CHECK_NEAR(pace_at(&chair, &agility, 0.69, 0.01, 0, 0, 1), 0.3, 0);                /* the least speed */
    CHECK_NEAR(pace_at(&chair, &agility, 0.69, 1, 0, 0, -1), 0.3, 0);                  /* backwards */
    CHECK_NEAR(pace_at(&chair, &agility, 0.69, 1, -2, 0, 1), 0.45, 1e-12);             /* 0.9 turn rate / k */
    CHECK_NEAR(pace_at(&chair, &agility, 0.69, 1, 1.3, 0, 1), sqrt(0.6 / 1.3), 1e-12); /* sqrt(a / k) */
    CHECK_NEAR(pace_at(&chair, &agility, 0.69, pace_enough(&chair), 0, 0, 1), 0.69, 1e-12);
    CHECK_NEAR(pace_at(&chair, &agility, pace_in_passage(&chair, 0.69, 0.63 + 0.06), 0.03, 0, 0, 1), 0.15,
               1e-12); /* (W - w) / b */
    CHECK_NEAR(pace_at(&chair, &agility, pace_in_passage(&chair, 0.69, 0.63 + 0.02), 0.01, 0, 0, 1), 0.1,
               1e-12); /* the creep */
    chair.mass = 80;
    chair.radius_of_gyration = 0.5;
    chair.turning_moment = 40;
    agility = pace_agility(&chair);
    CHECK_NEAR(pace_at(&chair, &agility, 0.69, 1, 0, 10, 1), sqrt(40 / 2 / (80 * 0.25 * 10)),
               1e-12); /* I v^2 dk/ds = M / 2 */
}
