#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/random.h"
#include "base/text.h"
#include "check.h"
#include "scratch.h"
#include "space/outline.h"

/* m: the grid on which walls are united, and its rounding. */
static const double GRID = 2e-6;

typedef struct Drawn {
    Plan plan;
    Outline outline;
} Drawn;

static Drawn draw(const char *members) {
    Drawn drawn = {.outline = {.faces = NULL}};
    Fault fault = {0};
    scratch_plan(&drawn.plan, members);
    CHECK(outline_build(&drawn.outline, &drawn.plan, &fault));
    check_say(&fault);
    return drawn;
}

static void wipe(Drawn *drawn) {
    outline_free(&drawn->outline);
    plan_free(&drawn->plan);
}

/* Counts the faces that run from a to b with the solid on their left. */
static int faces_between(const Outline *outline, double ax, double ay, double bx, double by) {
    int count = 0;
    for (size_t i = 0; i < outline->face_count; i++)
        count += vec2_distance(outline->faces[i].a, vec2(ax, ay)) < GRID &&
                 vec2_distance(outline->faces[i].b, vec2(bx, by)) < GRID;
    return count;
}

static int corners_at(const Outline *outline, double x, double y) {
    int count = 0;
    for (size_t i = 0; i < outline->corner_count; i++)
        count += vec2_distance(outline->corners[i].at, vec2(x, y)) < GRID;
    return count;
}

static double perimeter(const Outline *outline) {
    double sum = 0;
    for (size_t i = 0; i < outline->face_count; i++)
        sum += vec2_distance(outline->faces[i].a, outline->faces[i].b);
    return sum;
}

static double rings_area(const Rings *rings) {
    double sum = 0;
    for (size_t r = 0; r < rings->count; r++)
        for (size_t i = rings->starts[r]; i < rings->starts[r + 1]; i++) {
            size_t next = i + 1 < rings->starts[r + 1] ? i + 1 : rings->starts[r];
            sum += vec2_cross(rings->points[i], rings->points[next]) / 2;
        }
    return sum;
}

static double area(const Outline *outline) {
    return rings_area(&outline->rings);
}

/* Checks that every normal is a unit vector to the right of its face, and every corner turns left. */
static void check_sense(const Outline *outline) {
    for (size_t i = 0; i < outline->face_count; i++) {
        const Face *face = &outline->faces[i];
        Vec2 along = vec2_unit(vec2_sub(face->b, face->a));
        CHECK_NEAR(vec2_cross(along, face->normal), -1, 1e-12);
        CHECK_NEAR(vec2_dot(along, face->normal), 0, 1e-12);
    }
    for (size_t i = 0; i < outline->corner_count; i++) {
        const Corner *corner = &outline->corners[i];
        CHECK_NEAR(vec2_length(corner->in), 1, 1e-12);
        CHECK_NEAR(vec2_length(corner->out), 1, 1e-12);
        CHECK(vec2_cross(corner->in, corner->out) > 0 || vec2_dot(corner->in, corner->out) < -0.99);
    }
}

static double ray(const Drawn *drawn, double x, double y, double dx, double dy) {
    return outline_ray(&drawn->outline, vec2(x, y), vec2(dx, dy), 20, NULL);
}

static void check_l(const Drawn *drawn) {
    const Outline *outline = &drawn->outline;
    CHECK(faces_between(outline, 0, -0.1, 4.1, -0.1) == 1);
    CHECK(faces_between(outline, 4.1, -0.1, 4.1, 3) == 1);
    CHECK(faces_between(outline, 4.1, 3, 3.9, 3) == 1);
    CHECK(faces_between(outline, 3.9, 3, 3.9, 0.1) == 1);
    CHECK(faces_between(outline, 3.9, 0.1, 0, 0.1) == 1);
    CHECK(faces_between(outline, 0, 0.1, 0, -0.1) == 1);
    CHECK(outline->face_count == 6);
    CHECK(corners_at(outline, 4.1, -0.1) == 1);
    CHECK(corners_at(outline, 3.9, 0.1) == 0); /* the inner corner is not convex */
    CHECK(outline->corner_count == 5);
    CHECK_NEAR(area(outline), 4.1 * 0.2 + 2.9 * 0.2, 1e-5);
    check_sense(outline);
}

TEST(an_l_of_walls_has_six_faces_and_five_convex_corners) {
    Drawn drawn = draw("'walls': [{'id': 'w1', 'points': [[0, 0], [4, 0], [4, 3]], 'thickness': 0.2}]");
    check_l(&drawn);
    wipe(&drawn);
}

TEST(two_walls_that_end_in_one_point_close_their_corner) {
    Drawn drawn = draw("'walls': [{'id': 'w1', 'points': [[0, 0], [4, 0]], 'thickness': 0.2}, "
                       "{'id': 'w2', 'points': [[4, 3], [4, 0]], 'thickness': 0.2}]");
    check_l(&drawn);
    wipe(&drawn);
}

TEST(a_closed_wall_has_an_outside_and_an_inside) {
    Drawn drawn = draw("'walls': [{'id': 'w1', 'points': [[0, 0], [4, 0], [4, 3], [0, 3], [0, 0]], 'thickness': 0.2}]");
    CHECK(drawn.outline.face_count == 8);
    CHECK(drawn.outline.corner_count == 4); /* the outer ones */
    CHECK(drawn.outline.rings.count == 2);
    CHECK_NEAR(area(&drawn.outline), 4.2 * 3.2 - 3.8 * 2.8, 1e-5);
    CHECK_NEAR(ray(&drawn, 2, 1.5, 1, 0), 1.9, GRID);
    CHECK_NEAR(ray(&drawn, 2, 1.5, 0, -1), 1.4, GRID);
    check_sense(&drawn.outline);
    wipe(&drawn);
}

TEST(nothing_of_a_junction_lies_hidden_in_a_wall) {
    Drawn drawn = draw("'walls': [{'id': 'w1', 'points': [[0, 0], [4, 0]], 'thickness': 0.2}, "
                       "{'id': 'w2', 'points': [[2, 0], [2, 3]], 'thickness': 0.2}]");
    const Outline *outline = &drawn.outline;
    CHECK(outline->face_count == 8);
    CHECK(outline->corner_count == 6);
    CHECK(corners_at(outline, 1.9, 3) == 1 && corners_at(outline, 2.1, 3) == 1);
    CHECK(corners_at(outline, 1.9, 0.1) == 0 && corners_at(outline, 2.1, 0.1) == 0);
    CHECK_NEAR(perimeter(outline), 4 + 0.2 + 0.2 + 1.9 + 1.9 + 2.9 + 2.9 + 0.2, 1e-5);
    for (size_t i = 0; i < outline->face_count; i++) {
        const Face *face = &outline->faces[i];
        bool upright = face->a.y > 0.1 + GRID || face->b.y > 0.1 + GRID;
        CHECK(face->owner == OWNER_WALL && face->index == (upright ? 1 : 0));
    }
    wipe(&drawn);
}

TEST(a_cross_of_walls_is_one_solid) {
    Drawn drawn = draw("'walls': [{'id': 'w1', 'points': [[-2, 0], [2, 0]], 'thickness': 0.2}, "
                       "{'id': 'w2', 'points': [[0, -2], [0, 2]], 'thickness': 0.2}]");
    CHECK(drawn.outline.rings.count == 1);
    CHECK(drawn.outline.face_count == 12);
    CHECK(drawn.outline.corner_count == 8);
    CHECK_NEAR(area(&drawn.outline), 2 * 4 * 0.2 - 0.2 * 0.2, 1e-5);
    wipe(&drawn);
}

TEST(furniture_against_a_wall_hides_the_wall_and_is_named_itself) {
    Drawn drawn = draw("'walls': [{'id': 'w1', 'points': [[0, 0], [4, 0]], 'thickness': 0.2}], "
                       "'furniture': [{'id': 'f1', 'name': 'wardrobe', 'centre': [2, 0.3], 'size': [1, 0.4]}]");
    const Outline *outline = &drawn.outline;
    CHECK(outline->rings.count == 1);
    CHECK_NEAR(area(outline), 4 * 0.2 + 1 * 0.4, 1e-5);
    CHECK(faces_between(outline, 2.5, 0.5, 1.5, 0.5) == 1);
    int face = -7;
    CHECK_NEAR(outline_ray(outline, vec2(2, 3), vec2(0, -1), 9, &face), 2.5, GRID);
    char name[96] = "";
    CHECK(face >= 0);
    if (face >= 0)
        outline_name(&drawn.plan, outline->faces[face].owner, outline->faces[face].index, name, sizeof name);
    CHECK_TEXT(name, "wardrobe (f1)");
    outline_place_name(outline, &drawn.plan, vec2(0.5, 0.4), name, sizeof name);
    CHECK_TEXT(name, "wall w1");
    outline_place_name(outline, &drawn.plan, vec2(2.2, 0.9), name, sizeof name);
    CHECK_TEXT(name, "wardrobe (f1)");
    wipe(&drawn);
}

static const char *const with_door = "'walls': [{'id': 'w1', 'points': [[0, 0], [4, 0]], 'thickness': 0.1}], "
                                     "'doors': [{'id': 'd1', 'wall': 'w1', 'at': 2, 'width': 0.8%s}]";

static Drawn draw_door(const char *more) {
    char members[600];
    snprintf(members, sizeof members, with_door, more);
    return draw(members);
}

TEST(a_door_cuts_its_wall_over_its_clear_width) {
    Drawn drawn = draw_door("");
    CHECK(drawn.outline.rings.count == 2);
    CHECK(drawn.outline.face_count == 8);
    CHECK(drawn.outline.corner_count == 8);
    CHECK_NEAR(ray(&drawn, 2, 0, 1, 0), 0.4, GRID);
    CHECK_NEAR(ray(&drawn, 2, 0, -1, 0), 0.4, GRID);
    CHECK_NEAR(ray(&drawn, 2.39, 3, 0, -1), 20, 0);
    CHECK_NEAR(ray(&drawn, 2.41, 3, 0, -1), 2.95, GRID);
    char name[96];
    outline_place_name(&drawn.outline, &drawn.plan, vec2(2.1, 0.2), name, sizeof name);
    CHECK_TEXT(name, "door d1");
    wipe(&drawn);
}

TEST(a_locked_door_is_wall) {
    Drawn drawn = draw_door(", 'kind': 'hinged', 'state': 'locked'");
    CHECK(drawn.outline.rings.count == 1);
    CHECK(drawn.outline.face_count == 4);
    CHECK_NEAR(ray(&drawn, 2, 3, 0, -1), 2.95, GRID);
    wipe(&drawn);
}

TEST(a_standing_leaf_hangs_beside_the_opening_and_does_not_narrow_it) {
    for (int place = 0; place < 4; place++) {
        bool at_end = place & 1, to_right = place & 2;
        char more[100];
        snprintf(more, sizeof more, ", 'kind': 'hinged', 'hinge': '%s', 'swing': '%s'", at_end ? "end" : "start",
                 to_right ? "right" : "left");
        Drawn drawn = draw_door(more);
        double hinge = at_end ? 2.4 : 1.6, out = to_right ? -1 : 1, beside = at_end ? 1 : -1;
        double tip = out * (0.05 + 0.8);
        CHECK(corners_at(&drawn.outline, hinge, tip) == 1);
        CHECK(corners_at(&drawn.outline, hinge + beside * 0.04, tip) == 1);
        CHECK_NEAR(ray(&drawn, 2, out * 0.5, beside, 0), 0.4, GRID);
        CHECK_NEAR(ray(&drawn, 2, out * 0.5, -beside, 0), 20, 0);
        CHECK_NEAR(ray(&drawn, 2, 0, 1, 0), 0.4, GRID);
        CHECK_NEAR(ray(&drawn, 2, 0, -1, 0), 0.4, GRID);
        int face = -7;
        char name[96] = "";
        outline_ray(&drawn.outline, vec2(2, out * 0.5), vec2(beside, 0), 9, &face);
        if (face >= 0)
            outline_name(&drawn.plan, drawn.outline.faces[face].owner, drawn.outline.faces[face].index, name,
                         sizeof name);
        CHECK_TEXT(name, "door d1");
        check_sense(&drawn.outline);
        wipe(&drawn);
    }
}

TEST(a_door_that_can_be_opened_is_there_shut_and_open) {
    const struct {
        const char *more;
        int shut, open, open_corners;
    } cases[] = {{", 'kind': 'hinged', 'state': 'closed'", 2, 3, 2},
                 {", 'kind': 'sliding', 'state': 'closed'", 2, 0, 0},
                 {", 'kind': 'sliding', 'state': 'open'", 0, 0, 0},
                 {", 'kind': 'opening', 'state': 'closed'", 0, 0, 0},
                 {", 'kind': 'hinged', 'state': 'locked'", 0, 0, 0}};
    for (size_t c = 0; c < sizeof cases / sizeof *cases; c++) {
        Drawn drawn = draw_door(cases[c].more);
        int shut = 0, open = 0, open_corners = 0;
        for (size_t i = 0; i < drawn.outline.face_count; i++) {
            const Face *face = &drawn.outline.faces[i];
            shut += face->presence == PRESENT_SHUT;
            open += face->presence == PRESENT_OPEN;
            CHECK((face->presence == PRESENT_ALWAYS) == (face->door < 0));
        }
        for (size_t i = 0; i < drawn.outline.corner_count; i++)
            open_corners += drawn.outline.corners[i].presence == PRESENT_OPEN;
        CHECK_NEAR(shut, cases[c].shut, 0);
        CHECK_NEAR(open, cases[c].open, 0);
        CHECK_NEAR(open_corners, cases[c].open_corners, 0);
        bool locked = strstr(cases[c].more, "locked");
        CHECK_NEAR(ray(&drawn, 2.2, -3, 0, 1), locked ? 2.95 : 20, locked ? GRID : 0); /* a ray sees it open */
        check_sense(&drawn.outline);
        wipe(&drawn);
    }
}

TEST(a_thin_wall_is_two_faces_back_to_back) {
    Drawn drawn = draw("'walls': [{'id': 'w1', 'points': [[0, 0], [4, 0]], 'thickness': 0}]");
    CHECK(drawn.outline.face_count == 2);
    CHECK(drawn.outline.corner_count == 2);
    CHECK(faces_between(&drawn.outline, 0, 0, 4, 0) == 1 && faces_between(&drawn.outline, 4, 0, 0, 0) == 1);
    CHECK_NEAR(ray(&drawn, 1, 2, 0, -1), 2, GRID);
    CHECK_NEAR(ray(&drawn, 1, -2, 0, 1), 2, GRID);
    check_sense(&drawn.outline);
    wipe(&drawn);
}

TEST(a_thin_wall_may_turn_have_a_door_and_end_in_a_thick_one) {
    Drawn drawn = draw("'walls': [{'id': 'w1', 'points': [[0, 0], [4, 0], [4, 3]], 'thickness': 0}]");
    CHECK(drawn.outline.face_count == 4);
    CHECK(drawn.outline.corner_count == 3);
    wipe(&drawn);
    drawn = draw("'walls': [{'id': 'w1', 'points': [[0, 0], [4, 0]], 'thickness': 0}], "
                 "'doors': [{'id': 'd1', 'wall': 'w1', 'at': 2, 'width': 0.8}]");
    CHECK(drawn.outline.face_count == 4);
    CHECK(faces_between(&drawn.outline, 0, 0, 1.6, 0) == 1 && faces_between(&drawn.outline, 2.4, 0, 4, 0) == 1);
    CHECK_NEAR(ray(&drawn, 2, 2, 0, -1), 20, 0);
    wipe(&drawn);
    drawn = draw("'walls': [{'id': 'w1', 'points': [[0, 0], [4, 0]], 'thickness': 0}, "
                 "{'id': 'w2', 'points': [[4, -1], [4, 1]], 'thickness': 0.2}]");
    CHECK(drawn.outline.face_count == 6);
    CHECK(faces_between(&drawn.outline, 0, 0, 3.9, 0) == 1);
    wipe(&drawn);
}

TEST(rays_measure_a_corridors_width_in_any_direction) {
    Random random = random_seed(5, 1);
    for (int i = 0; i < 50; i++) {
        double angle = 2 * M_PI * random_uniform(&random), width = 0.6 + 2 * random_uniform(&random);
        double thickness = 0.3 * random_uniform(&random), half = (width + thickness) / 2;
        Vec2 along = vec2_heading(angle), side = vec2_left(along);
        Vec2 a = vec2_along(vec2_scale(along, -10), half, side), b = vec2_along(vec2_scale(along, 10), half, side);
        Vec2 c = vec2_along(vec2_scale(along, -10), -half, side), d = vec2_along(vec2_scale(along, 10), -half, side);
        char members[600];
        snprintf(members, sizeof members,
                 "'walls': [{'id': 'w1', 'points': [[%.17g, %.17g], [%.17g, %.17g]], 'thickness': %.17g}, "
                 "{'id': 'w2', 'points': [[%.17g, %.17g], [%.17g, %.17g]], 'thickness': %.17g}]",
                 a.x, a.y, b.x, b.y, thickness, c.x, c.y, d.x, d.y, thickness);
        Drawn drawn = draw(members);
        double offset = (random_uniform(&random) - 0.5) * width;
        Vec2 from = vec2_scale(side, offset);
        int left = -7, right = -7;
        double to_left = outline_ray(&drawn.outline, from, side, 20, &left);
        double to_right = outline_ray(&drawn.outline, from, vec2_scale(side, -1), 20, &right);
        CHECK_NEAR(to_left, width / 2 - offset, GRID);
        CHECK_NEAR(to_left + to_right, width, GRID);
        CHECK(left >= 0 && drawn.outline.faces[left].index == 0);
        CHECK(right >= 0 && drawn.outline.faces[right].index == 1);
        wipe(&drawn);
    }
}

TEST(a_ray_that_meets_nothing_reaches_as_far_as_it_was_asked) {
    Drawn drawn = draw("'walls': [{'id': 'w1', 'points': [[0, 0], [4, 0]]}]");
    int face = -7;
    CHECK_NEAR(outline_ray(&drawn.outline, vec2(2, 1), vec2(0, 1), 7, &face), 7, 0);
    CHECK(face == -1);
    CHECK_NEAR(outline_ray(&drawn.outline, vec2(2, 1), vec2(0, -1), 0.5, &face), 0.5, 0);
    CHECK(face == -1);
    wipe(&drawn);
}

/* True if p is inside a closed ring of the outline (odd number of crossings). */
static bool inside_rings(const Outline *outline, Vec2 p) {
    bool inside = false;
    for (size_t r = 0; r < outline->rings.count; r++)
        for (size_t i = outline->rings.starts[r]; i < outline->rings.starts[r + 1]; i++) {
            Vec2 a = outline->rings.points[i];
            Vec2 b = outline->rings.points[i + 1 < outline->rings.starts[r + 1] ? i + 1 : outline->rings.starts[r]];
            if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y))
                inside = !inside;
        }
    return inside;
}

TEST(a_heap_of_furniture_is_solid_exactly_where_a_piece_is) {
    Random random = random_seed(6, 1);
    char members[8000] = "'walls': [], 'furniture': [";
    for (int i = 0; i < 40; i++) {
        size_t used = strlen(members);
        snprintf(members + used, sizeof members - used,
                 "%s{'id': 'f%d', 'centre': [%.4f, %.4f], 'size': [%.4f, %.4f], 'angle': %.3f}", i ? ", " : "", i,
                 8 * random_uniform(&random), 8 * random_uniform(&random), 0.2 + random_uniform(&random),
                 0.2 + random_uniform(&random), 360 * random_uniform(&random));
    }
    strcat(members, "]");
    Drawn drawn = draw(members);
    for (int i = 0; i < 5000; i++) {
        Vec2 p = {10 * random_uniform(&random) - 1, 10 * random_uniform(&random) - 1};
        bool solid = false;
        double edge = 1;
        for (size_t f = 0; f < drawn.plan.furniture_count; f++) {
            const Furniture *piece = &drawn.plan.furniture[f];
            Vec2 own = vec2_unturn(vec2_sub(p, piece->centre), vec2_heading(radians(piece->angle)));
            double x = fabs(own.x) - piece->size.x / 2, y = fabs(own.y) - piece->size.y / 2;
            solid |= x < 0 && y < 0;
            edge = fmin(edge, fabs(fmax(x, y)));
        }
        if (edge > 1e-4)
            CHECK(inside_rings(&drawn.outline, p) == solid);
    }
    /* Just outside each face is free space. */
    for (size_t i = 0; i < drawn.outline.face_count; i++) {
        const Face *face = &drawn.outline.faces[i];
        Vec2 middle = vec2_scale(vec2_add(face->a, face->b), 0.5);
        CHECK(!inside_rings(&drawn.outline, vec2_along(middle, 1e-5, face->normal)));
        CHECK(inside_rings(&drawn.outline, vec2_along(middle, -1e-5, face->normal)));
    }
    check_sense(&drawn.outline);
    wipe(&drawn);
}

TEST(an_empty_plan_has_an_outline_of_nothing) {
    Drawn drawn = draw("'walls': []");
    CHECK(drawn.outline.face_count == 0 && drawn.outline.corner_count == 0 && drawn.outline.rings.count == 0);
    CHECK(drawn.outline.box.low.x < drawn.outline.box.high.x);
    CHECK_NEAR(ray(&drawn, 0, 0, 1, 0), 20, 0);
    wipe(&drawn);
}

TEST(a_wall_whose_ends_nearly_meet_is_closed) {
    Drawn drawn =
        draw("'walls': [{'id': 'w1', 'points': [[1e-10, 0], [4, 0], [4, 3], [0, 3], [0, 0]], 'thickness': 0.2}]");
    CHECK(drawn.outline.face_count == 8);
    CHECK_NEAR(perimeter(&drawn.outline), 2 * (4.2 + 3.2) + 2 * (3.8 + 2.8), 1e-6);
    wipe(&drawn);
}

TEST(doors_side_by_side_are_cut_at_once) {
    enum { DOORS = 300 };
    Text text = {0};
    char door[120];
    text_add(&text, "'walls': [{'id': 'w1', 'points': [[0, 0], [600, 0]], 'thickness': 0.2}], 'doors': [");
    for (int d = 0; d < DOORS; d++) {
        snprintf(door, sizeof door, "%s{'id': 'd%d', 'wall': 'w1', 'at': %g, 'width': %g}", d ? ", " : "", d,
                 0.5 + 2 * d, d % 3 ? 0.9 : 1.0);
        text_add(&text, door);
    }
    text_add(&text, ", {'id': 'next', 'wall': 'w1', 'at': 1.5, 'width': 1}]"); /* from the first to the second */
    Drawn drawn = draw(text.text);
    memory_free(text.text);
    CHECK(drawn.outline.face_count == 4 * DOORS);
    wipe(&drawn);
}

TEST(the_owner_of_a_face_is_found_among_any_number) {
    enum { WALLS = 200 };
    Text text = {0};
    char wall[120];
    text_add(&text, "'walls': [");
    for (int w = 0; w < WALLS; w++) {
        double angle = M_PI * w / WALLS;
        snprintf(wall, sizeof wall, "{'id': 'w%d', 'points': [[%.9f, %.9f], [%.9f, %.9f]], 'thickness': 0.002}, ", w,
                 -9 * cos(angle), -9 * sin(angle), 9 * cos(angle), 9 * sin(angle));
        text_add(&text, wall);
    }
    text_add(&text, "{'id': 'last', 'points': [[0, -0.5], [0, 0.5]], 'thickness': 1}]");
    Drawn drawn = draw(text.text);
    memory_free(text.text);
    int last = 0;
    for (size_t f = 0; f < drawn.outline.face_count; f++)
        last += drawn.outline.faces[f].index == WALLS;
    CHECK(last > WALLS);
    wipe(&drawn);
}

static double walls_area(const Plan *plan, double low, double high) {
    Rings rings;
    CHECK(outline_walls(plan, low, high, &rings));
    double sum = rings_area(&rings);
    outline_free_rings(&rings);
    return sum;
}

/* A wall of 2.4 m with a door, a rail of 0.9 m that continues it, and a wardrobe against both. */
TEST(walls_alone_are_without_furniture_and_sorted_by_height) {
    Drawn drawn = draw("'walls': [{'id': 'w1', 'points': [[0, 0], [4, 0]], 'thickness': 0.2}, "
                       "{'id': 'w2', 'points': [[4, 0], [6, 0]], 'thickness': 0.2, 'height': 0.9}], "
                       "'doors': [{'id': 'd1', 'wall': 'w1', 'at': 1, 'width': 0.8}], "
                       "'furniture': [{'id': 'f1', 'name': 'wardrobe', 'centre': [4, 0.35], 'size': [1, 0.6], "
                       "'height': 1.8}]");
    CHECK_NEAR(walls_area(&drawn.plan, 0, HUGE_VAL), 5.2 * 0.2, 1e-5);
    CHECK_NEAR(walls_area(&drawn.plan, 0, 1), 2 * 0.2, 1e-5);
    CHECK_NEAR(walls_area(&drawn.plan, 1, HUGE_VAL), 3.2 * 0.2, 1e-5);
    CHECK_NEAR(walls_area(&drawn.plan, 3, HUGE_VAL), 0, 0);
    wipe(&drawn);
}
