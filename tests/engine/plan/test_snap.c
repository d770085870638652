/* Tests snapping: the nearest target within reach, and none beyond. */

#include "plan/snap_piece.h"

#include <math.h>

#include "check.h"

static Vec2 outer[] = {{0, 0}, {4, 0}, {4, 3}, {0, 3}, {0, 0}}, inner[] = {{2, 0}, {2, 2}},
            slanted[] = {{6, 0}, {8, 2}};
static Wall walls[] = {{.id = "w1", .points = {outer, 5}, .thickness = 0.12, .height = 2.4},
                       {.id = "w2", .points = {inner, 2}, .thickness = 0.1, .height = 2.4},
                       {.id = "w3", .points = {slanted, 2}, .thickness = 0.1, .height = 2.4}};
static Door doors[] = {{.id = "d1", .wall = "w1", .segment = 2, .at = 2, .width = 0.8}};
static Furniture pieces[] = {{.id = "f1", .name = "table", .centre = {3, 1.5}, .size = {1, 0.6}, .topples = TOPPLE_NO}};
static const Plan plan = {
    .walls = walls, .wall_count = 3, .doors = doors, .door_count = 1, .furniture = pieces, .furniture_count = 1};

static Snap at(double x, double y, SnapAsk ask) {
    ask.at = vec2(x, y);
    ask.reach = ask.reach > 0 ? ask.reach : 0.1;
    if (!ask.along)
        ask.along = NAN;
    return snap_point(&plan, &ask);
}

static void check_snap(Snap snap, double x, double y, const char *words) {
    CHECK_NEAR(snap.at.x, x, 0);
    CHECK_NEAR(snap.at.y, y, 0);
    CHECK_TEXT(snap.text, words);
}

TEST(ends_and_corners_come_before_lines_and_lines_before_the_grid) {
    check_snap(at(2.05, 1.96, (SnapAsk){.faces = false}), 2, 2, "end of w2");
    check_snap(at(3.95, 2.97, (SnapAsk){.faces = false}), 4, 3, "corner of w1");
    check_snap(at(2.04, 1.203, (SnapAsk){.faces = false}), 2, 1.2, "on w2");
    check_snap(at(1.004, 1.404, (SnapAsk){.faces = false}), 1, 1.4, "");
    check_snap(at(1.0044, 1.4, (SnapAsk){.free = true}), 1.004, 1.4, "");
    check_snap(at(2.05, 1.96, (SnapAsk){.free = true}), 2.05, 1.96, "");
}

TEST(what_moves_itself_is_not_snapped_to) {
    const char *self[] = {"w2"};
    check_snap(at(2.05, 1.3, (SnapAsk){.without = self, .without_count = 1}), 2.05, 1.3, "");
}

TEST(a_line_from_somewhere_is_snapped_to_angles_and_its_length_to_centimetres) {
    Vec2 from = {1, 1};
    Snap snap = at(1.5, 1.04, (SnapAsk){.from = &from});
    check_snap(snap, 1.5, 1, "0 degrees");
    CHECK(snap.guide_count == 1);
    snap = at(1 + 0.5 * cos(radians(46)), 1 + 0.5 * sin(radians(46)), (SnapAsk){.from = &from});
    CHECK_TEXT(snap.text, "45 degrees");
    CHECK_NEAR(vec2_distance(snap.at, from), 0.5, 1e-9);
    check_snap(at(1.94, 1.03, (SnapAsk){.from = &from}), 2, 1, "on w2, 0 degrees");
    Vec2 slope = {6.5, 2.5}; /* square to w3, whose direction is 45 degrees */
    CHECK_TEXT(at(7.1, 1.95, (SnapAsk){.from = &slope}).text, "-45 degrees");
    snap = at(6.5 + 0.6 * cos(radians(20)), 2.5 + 0.6 * sin(radians(20)),
              (SnapAsk){.from = &slope, .along = 5, .reach = 0.05});
    CHECK_TEXT(snap.text, "20 degrees");
}

TEST(the_first_point_closes_what_is_drawn_and_others_are_in_line) {
    Vec2 own[] = {{5, 5}, {7, 5}, {7, 6}};
    SnapAsk ask = {.from = &own[2], .own = own, .own_count = 3, .closes = true};
    check_snap(at(5.04, 5.04, ask), 5, 5, "first point");
    check_snap(at(5.04, 6.03, ask), 5, 6, "in line with the first point, 180 degrees");
}

TEST(faces_and_edges_of_openings_are_snapped_to_where_they_are_wanted) {
    check_snap(at(1.0, 0.08, (SnapAsk){.faces = true}), 1, 0.06, "on w1");
    check_snap(at(2.52, 1.78, (SnapAsk){.faces = true}), 2.5, 1.8, "corner of f1");
    check_snap(at(2.42, 2.98, (SnapAsk){.doors = true}), 2.4, 3, "edge of d1");
}

TEST(straight_is_along_one_axis) {
    Vec2 from = {1, 1};
    check_snap(at(1.5, 1.3, (SnapAsk){.from = &from, .straight = true}), 1.5, 1, "straight across");
    check_snap(at(1.2, 1.95, (SnapAsk){.from = &from, .straight = true}), 1, 2, "in line with w2");
}

TEST(angles_are_exact_along_the_axes_and_wrapped) {
    CHECK(snap_heading(90).x == 0 && snap_heading(-90).y == -1 && snap_heading(540).x == -1);
    CHECK_NEAR(snap_angle(vec2(-1, 0)), 180, 0);
    CHECK_NEAR(snap_angle(vec2(1, 1)), 45, 0);
    CHECK_NEAR(snap_turn(-172.6, false), 180, 0);
    CHECK_NEAR(snap_turn(187.46, true), -172.5, 0);
    CHECK_NEAR(snap_tidy(0.1 + 0.2), 0.3, 0);
}

TEST(the_nearest_wall_is_found_with_the_place_on_it) {
    SnapWall wall;
    CHECK(snap_wall(&plan, vec2(2.2, 1.3), &wall));
    CHECK(wall.wall == 1 && wall.segment == 0);
    CHECK_NEAR(wall.along, 1.3, 1e-12);
    CHECK_NEAR(wall.distance, 0.2, 1e-12);
    CHECK(!snap_wall(&(Plan){.name = ""}, vec2(0, 0), &wall));
}

TEST(a_piece_touches_what_it_is_brought_near_to) {
    Furniture piece = {.size = {1, 0.5}, .topples = TOPPLE_NO};
    Snap snap = snap_piece_place(&plan, &piece, &(SnapAsk){.at = {1.003, 2.65}, .reach = 0.1});
    check_snap(snap, 1, 2.69, "against w1");
    snap = snap_piece_place(&plan, &piece, &(SnapAsk){.at = {0.6, 2.65}, .reach = 0.1});
    check_snap(snap, 0.56, 2.69, "against w1");
    snap = snap_piece_place(&plan, &piece, &(SnapAsk){.at = {1.42, 1.004}, .reach = 0.1});
    check_snap(snap, 1.45, 1, "against w2");
    snap = snap_piece_place(&plan, &piece, &(SnapAsk){.at = {3.004, 0.9}, .reach = 0.1});
    check_snap(snap, 3, 0.95, "against f1");
    piece.angle = 90;
    snap = snap_piece_place(&plan, &piece, &(SnapAsk){.at = {0.35, 1.504}, .reach = 0.1});
    check_snap(snap, 0.31, 1.5, "against w1");
    snap = snap_piece_place(&plan, &piece, &(SnapAsk){.at = {0.3504, 1.504}, .reach = 0.1, .free = true});
    check_snap(snap, 0.35, 1.504, "");
}

TEST(a_back_goes_to_the_wall) {
    static const struct {
        Vec2 hand, centre;
        double angle;
    } walls_around[] = {
        {{1, 2.6}, {1, 2.69}, 0}, {{1, 0.3}, {1, 0.31}, 180}, {{0.3, 1}, {0.31, 1}, 90}, {{3.7, 1}, {3.69, 1}, -90}};
    Furniture piece = {.size = {1, 0.5}, .topples = TOPPLE_NO};
    for (size_t i = 0; i < 4; i++) {
        double angle = NAN;
        Vec2 centre = {NAN, NAN};
        SnapAsk ask = {.at = walls_around[i].hand, .reach = 0.1};
        CHECK(snap_piece_back(&plan, &piece, &ask, &angle, &centre));
        CHECK_NEAR(angle, walls_around[i].angle, 0);
        CHECK_NEAR(centre.x, walls_around[i].centre.x, 1e-12);
        CHECK_NEAR(centre.y, walls_around[i].centre.y, 1e-12);
    }
    SnapAsk away = {.at = {1, 1.5}, .reach = 0.1};
    double angle;
    Vec2 centre;
    CHECK(!snap_piece_back(&plan, &piece, &away, &angle, &centre));
}

TEST(the_room_beside_a_piece_ends_at_the_next_face) {
    const char *self[] = {"f1"};
    CHECK_NEAR(snap_piece_gap(&plan, vec2(3.5, 1.5), vec2(1, 0), self, 1), 0.44, 1e-12);
    CHECK_NEAR(snap_piece_gap(&plan, vec2(2.5, 1.5), vec2(-1, 0), self, 1), 0.45, 1e-12);
    CHECK_NEAR(snap_piece_gap(&plan, vec2(1, 1), vec2(0, 1), NULL, 0), 1.94, 1e-12);
    CHECK(isinf(snap_piece_gap(&plan, vec2(10, 10), vec2(0, 1), NULL, 0)));
}
