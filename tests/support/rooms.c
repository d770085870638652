#include "rooms.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

#include "check.h"
#include "route/fit.h"
#include "route/search.h"
#include "route/smooth.h"

Profile rooms_chair(double length, double width) {
    return (Profile){.name = "chair",
                     .length = length,
                     .width = width,
                     .axle = 0.28,
                     .free_speed = 0.69,
                     .minimum_speed = 0.3,
                     .creep = 0.1,
                     .steering_time = 0.4,
                     .acceleration = 0.5,
                     .deceleration = 1,
                     .lateral_acceleration = 0.6,
                     .turn_rate = 1,
                     .reversing_speed = 0.3,
                     .reversing_time = 1,
                     .mass = 80,
                     .push = 100,
                     .space_reach = 0.3};
}

void rooms_build(Rooms *fixture) {
    Fault fault = {0};
    fixture->plan.run.cell = 0.05;
    CHECK(outline_build(&fixture->outline, &fixture->plan, &fault));
    fault_clear(&fault);
    freespace_build(&fixture->space, &fixture->outline, fixture->plan.run.cell);
    fixture->query.plan = &fixture->plan;
    fixture->query.space = &fixture->space;
    fixture->query.profile = &fixture->profile;
    fixture->query.exit = SIZE_MAX;
    fixture->query.most_reversals = 6;
}

void rooms_free(Rooms *fixture) {
    freespace_free(&fixture->space);
    outline_free(&fixture->outline);
}

void rooms_make_corner(Rooms *fixture, double length, double width, double w1, double w2, bool mirrored) {
    *fixture = (Rooms){.profile = rooms_chair(length, width)};
    double arm = 1.5 * length + 0.4, top = w2 + arm, side = w1 + arm, sign = mirrored ? -1 : 1;
    const Vec2 points[7] = {{0, top}, {0, 0}, {side, 0}, {side, w2}, {w1, w2}, {w1, top}, {0, top}};
    for (size_t i = 0; i < 7; i++)
        fixture->points[i] = vec2(sign * points[i].x, points[i].y);
    fixture->walls[0] = (Wall){.id = "w1", .points = {fixture->points, 7}, .thickness = 0};
    double line = side - length + 0.1;
    fixture->exits[0] = (Exit){.id = "e1", .from = {sign * line, 0}, .to = {sign * line, w2}, .closes = HUGE_VAL};
    fixture->plan =
        (Plan){.name = "corner", .walls = fixture->walls, .wall_count = 1, .exits = fixture->exits, .exit_count = 1};
    fixture->query.at = vec2(sign * w1 / 2, top - 0.28 - 0.05);
    fixture->query.heading = -M_PI_2;
    rooms_build(fixture);
}

void rooms_make_two(Rooms *fixture, double width, double door, int state) {
    *fixture = (Rooms){.profile = rooms_chair(1.1, width)};
    const Vec2 points[7] = {{0, 0}, {6, 0}, {6, 3}, {0, 3}, {0, 0}, {3, 0}, {3, 3}};
    memcpy(fixture->points, points, sizeof points);
    fixture->walls[0] = (Wall){.id = "w1", .points = {fixture->points, 5}, .thickness = 0.12};
    fixture->walls[1] = (Wall){.id = "w2", .points = {fixture->points + 5, 2}, .thickness = 0.12};
    fixture->doors[0] = (Door){.id = "d1",
                               .wall = "w2",
                               .at = 1.5,
                               .width = door,
                               .kind = state == DOOR_OPEN ? DOOR_OPENING : DOOR_SLIDING,
                               .state = state,
                               .opening_time = 3,
                               .leaf = 0.04,
                               .wall_index = 1};
    fixture->exits[0] = (Exit){.id = "e1", .from = {5, 0}, .to = {5, 3}, .closes = HUGE_VAL};
    fixture->plan = (Plan){.name = "rooms",
                           .walls = fixture->walls,
                           .wall_count = 2,
                           .doors = fixture->doors,
                           .door_count = 1,
                           .exits = fixture->exits,
                           .exit_count = 1,
                           .furniture = fixture->furniture};
    fixture->query.at = vec2(1, 1.5);
    rooms_build(fixture);
}

void rooms_turn(Rooms *fixture, double angle, Vec2 shift) {
    Vec2 axis = vec2_heading(angle), *ends[] = {&fixture->exits[0].from, &fixture->exits[0].to, &fixture->query.at};
    for (size_t i = 0; i < sizeof fixture->points / sizeof *fixture->points; i++)
        fixture->points[i] = vec2_add(vec2_turn(fixture->points[i], axis), shift);
    for (size_t i = 0; i < sizeof ends / sizeof *ends; i++)
        *ends[i] = vec2_add(vec2_turn(*ends[i], axis), shift);
    fixture->query.heading += angle;
    rooms_free(fixture);
    rooms_build(fixture);
}

double rooms_clearance_along(const FreeSpace *space, const Profile *profile, const Route *route) {
    enum { PARTS = 100 };
    Rectangle body = search_body(profile);
    double least = ROUTE_CLEARANCE_REACH;
    for (size_t i = 1; i < route->count; i++) {
        const Pose *from = &route->poses[i - 1], *to = &route->poses[i];
        double turn = vec2_wrap_angle(to->heading - from->heading);
        for (int k = 0; k <= PARTS; k++) {
            double part = (double)k / PARTS;
            Vec2 at = to->direction ? smooth_between(from, to, to->direction, part) : from->at;
            least = fmin(least, search_clearance(space, &body, at, from->heading + part * turn, least, NULL));
        }
    }
    return least;
}

void rooms_check_path(const Rooms *fixture, const Route *route) {
    const Profile *profile = &fixture->profile;
    double slip = 0, farthest = 0, turned = 0, length = 0;
    int reversals = 0, last = 0;
    for (size_t i = 0; i < route->count; i++) {
        const Pose *pose = &route->poses[i];
        Vec2 axis = vec2_heading(pose->heading);
        double clearance =
            freespace_clearance(&fixture->space, vec2_along(pose->at, profile->length / 2 - profile->axle, axis), axis,
                                profile->length / 2, profile->width / 2, ROUTE_CLEARANCE_REACH, NULL);
        CHECK_NEAR(pose->clearance, clearance, 1e-12);
        if (i == 0)
            continue;
        const Pose *before = &route->poses[i - 1];
        Vec2 motion = vec2_sub(pose->at, before->at);
        double moved = vec2_length(motion), turn = fabs(pose->heading - before->heading);
        length += moved;
        farthest = fmax(farthest, moved);
        turned = fmax(turned, turn);
        if (pose->direction == 0) {
            CHECK_NEAR(moved, 0, 1e-12);
        } else if (moved > 1e-9) {
            Vec2 mean = vec2_heading((pose->heading + before->heading) / 2);
            slip = fmax(slip, fabs(vec2_cross(mean, motion)) / moved);
            CHECK(vec2_dot(mean, motion) * pose->direction > 0);
            reversals += last != 0 && last != pose->direction;
            last = pose->direction;
        }
    }
    CHECK(route->narrowest > 0);
    CHECK_NEAR(route->narrowest, rooms_clearance_along(&fixture->space, profile, route), 2e-4);
    CHECK_NEAR(slip, 0, 0.06);
    CHECK_NEAR(farthest, 0.04, 0.04);
    CHECK_NEAR(turned, 0, radians(16));
    CHECK_NEAR(reversals, route->reversals, 0);
    CHECK_NEAR(length, route->length, 1e-9);
    CHECK(route->fits && route->drivable && route->answer == ROUTE_FOUND);
}

double rooms_fit_margin(const Rooms *fixture) {
    const RouteQuery *query = &fixture->query;
    Rectangle body = search_body(query->profile);
    Goal goal = field_exit_goal(query->exit, query->time, query->opens_before);
    FitPlace tightest;
    CHECK(fit_margin(query, &body, &goal, 1, -0.1, ROOMS_FIT_MOST, &tightest) == FIT_KNOWN);
    return fmin(tightest.margin + FIT_RESOLUTION / 2, ROOMS_FIT_MOST);
}
