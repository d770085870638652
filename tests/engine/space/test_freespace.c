#include "check.h"

#include <stdint.h>
#include <string.h>

#include "base/random.h"
#include "space/freespace.h"
#include "space/passage.h"
#include "plan/plan.h"

/* A room of 6 m by 5 m with a wall of zero thickness, a thick one, and turned furniture. */
typedef struct Fixture {
    Wall walls[3];
    Vec2 points[9];
    Furniture furniture[3];
    Plan plan;
    Outline outline;
    FreeSpace space;
} Fixture;

static void fixture_make(Fixture *fixture, double cell) {
    *fixture = (Fixture){0};
    const Vec2 points[9] = {{0, 0}, {6, 0}, {6, 5}, {0, 5}, {0, 0}, {2, 0}, {2.3, 2}, {4, 5}, {4, 3}};
    memcpy(fixture->points, points, sizeof points);
    fixture->walls[0] = (Wall){.id = "w1", .points = {fixture->points, 5}, .thickness = 0.2};
    fixture->walls[1] = (Wall){.id = "w2", .points = {fixture->points + 5, 2}, .thickness = 0};
    fixture->walls[2] = (Wall){.id = "w3", .points = {fixture->points + 7, 2}, .thickness = 0.12};
    fixture->furniture[0] =
        (Furniture){.id = "f1", .name = "table", .centre = {3.2, 2.4}, .size = {0.8, 0.6}, .angle = 25};
    fixture->furniture[1] = (Furniture){.id = "f2", .name = "bed", .centre = {5, 1}, .size = {1, 1.8}, .angle = -10};
    fixture->furniture[2] = (Furniture){.id = "f3", .name = "", .centre = {1, 4}, .size = {0.5, 0.5}, .angle = 45};
    fixture->plan = (Plan){.name = "fixture",
                           .walls = fixture->walls,
                           .wall_count = 3,
                           .furniture = fixture->furniture,
                           .furniture_count = 3};
    Fault fault = {0};
    CHECK(outline_build(&fixture->outline, &fixture->plan, &fault));
    fault_clear(&fault);
    freespace_build(&fixture->space, &fixture->outline, cell);
}

static void fixture_free(Fixture *fixture) {
    freespace_free(&fixture->space);
    outline_free(&fixture->outline);
}

static double brute_distance(const Outline *outline, Vec2 at) {
    double nearest = HUGE_VAL;
    for (size_t f = 0; f < outline->face_count; f++)
        if (outline_planned(outline->faces[f].presence))
            nearest =
                fmin(nearest, vec2_distance(at, vec2_nearest_on_segment(at, outline->faces[f].a, outline->faces[f].b)));
    return nearest;
}

/* Returns the even-odd rule over the solids' rings, by the angle that each edge subtends. */
static bool brute_inside(const Outline *outline, Vec2 at) {
    double turns = 0;
    for (size_t r = 0; r < outline->rings.count; r++)
        for (size_t i = outline->rings.starts[r], end = outline->rings.starts[r + 1]; i < end; i++) {
            Vec2 a = vec2_sub(outline->rings.points[i], at);
            Vec2 b = vec2_sub(outline->rings.points[i + 1 < end ? i + 1 : outline->rings.starts[r]], at);
            turns += atan2(vec2_cross(a, b), vec2_dot(a, b)) / (2 * M_PI);
        }
    return (int64_t)llround(turns) % 2 != 0;
}

/* Returns the distance of a rectangle's outline from all faces, by points 1 mm apart. */
static double brute_clearance(const Outline *outline, Vec2 centre, Vec2 axis, double half_length, double half_width) {
    double nearest = HUGE_VAL;
    for (int side = 0; side < 4; side++) {
        double half = side % 2 ? half_width : half_length, other = side % 2 ? half_length : half_width;
        for (int i = 0; i <= 1000; i++) {
            Vec2 local = {half * (i / 500.0 - 1), side < 2 ? other : -other};
            if (side % 2)
                local = vec2(local.y, local.x);
            nearest = fmin(nearest, brute_distance(outline, vec2_add(centre, vec2_turn(local, axis))));
        }
    }
    return nearest;
}

static Vec2 somewhere(Random *random) {
    return vec2(-1 + 8 * random_uniform(random), -1 + 7 * random_uniform(random));
}

TEST(distances_on_the_grid_are_those_of_the_faces) {
    Fixture fixture;
    fixture_make(&fixture, 0.05);
    const FreeSpace *space = &fixture.space;
    Random random = random_seed(1, 1);
    double worst = 0;
    int wrong_sides = 0;
    for (int n = 0; n < 5000; n++) {
        int i = (int)(random_uniform(&random) * space->nx), j = (int)(random_uniform(&random) * space->ny);
        Vec2 at = {space->origin.x + i * space->cell, space->origin.y + j * space->cell};
        double got = (double)space->distance[j * space->nx + i], expected = brute_distance(&fixture.outline, at);
        worst = fmax(worst, fabs(fabs(got) - fmin(expected, FREESPACE_FARTHEST)));
        if (expected > 1e-4)
            wrong_sides += brute_inside(&fixture.outline, at) != (got < 0);
    }
    CHECK_NEAR(worst, 0, 1e-5);
    CHECK_NEAR(wrong_sides, 0, 0);
    fixture_free(&fixture);
}

TEST(distances_between_grid_points_are_off_by_half_a_cell_at_most) {
    Fixture fixture;
    fixture_make(&fixture, 0.05);
    Random random = random_seed(1, 2);
    double worst = 0;
    for (int n = 0; n < 20000; n++) {
        Vec2 at = somewhere(&random);
        double expected = fmin(brute_distance(&fixture.outline, at), FREESPACE_FARTHEST);
        if (!brute_inside(&fixture.outline, at) && expected > 0.05)
            worst = fmax(worst, fabs(freespace_distance(&fixture.space, at) - expected));
    }
    CHECK_NEAR(worst, 0, 0.025);
    CHECK_NEAR(freespace_distance(&fixture.space, vec2(1000, -1000)), FREESPACE_FARTHEST, 0);
    fixture_free(&fixture);
}

TEST(exact_distances_are_those_of_the_nearest_face) {
    Fixture fixture;
    fixture_make(&fixture, 0.1);
    Random random = random_seed(1, 3);
    double worst = 0;
    for (int n = 0; n < 5000; n++) {
        Vec2 at = somewhere(&random);
        double reach = 1.5 * random_uniform(&random);
        int face = -2;
        double got = freespace_exact(&fixture.space, at, reach, &face);
        worst = fmax(worst, fabs(got - fmin(brute_distance(&fixture.outline, at), reach)));
        if (face >= 0) {
            const Face *nearest = &fixture.outline.faces[face];
            worst = fmax(worst, fabs(got - vec2_distance(at, vec2_nearest_on_segment(at, nearest->a, nearest->b))));
        } else {
            CHECK_NEAR(got, reach, 0);
        }
    }
    CHECK_NEAR(worst, 0, 1e-12);
    fixture_free(&fixture);
}

TEST(clearance_of_a_free_rectangle_is_the_distance_of_its_outline) {
    Fixture fixture;
    fixture_make(&fixture, 0.05);
    Random random = random_seed(1, 4);
    double worst = 0;
    int free = 0;
    for (int n = 0; n < 600; n++) {
        Vec2 at = somewhere(&random), axis = vec2_heading(2 * M_PI * random_uniform(&random));
        double half_length = 0.1 + random_uniform(&random), half_width = 0.1 + 0.4 * random_uniform(&random);
        double got = freespace_clearance(&fixture.space, at, axis, half_length, half_width, 0.5, NULL);
        if (got <= 0)
            continue;
        free++;
        double expected = brute_clearance(&fixture.outline, at, axis, half_length, half_width);
        worst = fmax(worst, fabs(got - fmin(expected, 0.5)));
    }
    CHECK(free > 50);
    CHECK_NEAR(worst, 0, 2e-3);
    fixture_free(&fixture);
}

TEST(a_rectangle_touches_when_it_has_grown_by_its_growth) {
    Fixture fixture;
    fixture_make(&fixture, 0.05);
    Random random = random_seed(1, 5);
    int wrong = 0, tried = 0;
    for (int n = 0; n < 20000; n++) {
        Vec2 at = somewhere(&random), axis = vec2_heading(2 * M_PI * random_uniform(&random));
        double length = 0.3 + 0.5 * random_uniform(&random), width = 0.2 + 0.2 * random_uniform(&random);
        double growth = freespace_growth(&fixture.space, at, axis, length, width, 0.3, NULL);
        if (growth >= 0.3 || growth < 0.01 - width)
            continue;
        if (brute_inside(&fixture.outline, at))
            continue;
        tried++;
        double less = growth - 1e-6, more = growth + 1e-6;
        wrong += freespace_clearance(&fixture.space, at, axis, length + less, width + less, 1, NULL) < 0;
        wrong += freespace_clearance(&fixture.space, at, axis, length + more, width + more, 1, NULL) > 0;
    }
    CHECK(tried > 3000);
    CHECK_NEAR(wrong, 0, 0);
    fixture_free(&fixture);
}

TEST(clearance_beside_before_and_across_a_wall_has_closed_forms) {
    Fixture fixture;
    fixture_make(&fixture, 0.05);
    const FreeSpace *space = &fixture.space;
    int face;
    /* The lower wall's inner face is y = 0.1, the left one's x = 0.1. */
    CHECK_NEAR(freespace_clearance(space, vec2(1.0, 0.6), vec2(1, 0), 0.4, 0.3, 0.5, &face), 0.2, 1e-12);
    CHECK(face >= 0 && fixture.outline.faces[face].owner == OWNER_WALL && fixture.outline.faces[face].index == 0);
    CHECK_NEAR(freespace_clearance(space, vec2(1.0, 0.35), vec2(1, 0), 0.4, 0.3, 0.5, &face), -0.05, 1e-12);
    /* A corner of the rectangle, turned by 45 degrees, points at the wall. */
    double corner = (0.4 + 0.3) * M_SQRT1_2;
    CHECK_NEAR(freespace_clearance(space, vec2(1.0, 1.0), vec2_heading(M_PI / 4), 0.4, 0.3, 0.5, &face), 0.9 - corner,
               1e-12);
    CHECK_NEAR(freespace_clearance(space, vec2(1.0, 0.5), vec2_heading(M_PI / 4), 0.4, 0.3, 0.5, &face), 0.4 - corner,
               1e-12);
    /* Obstacles are far away, and none is nearer than asked for. */
    CHECK_NEAR(freespace_clearance(space, vec2(50, 50), vec2(1, 0), 0.4, 0.3, 0.5, &face), 0.5, 0);
    CHECK(face == -1);
    fixture_free(&fixture);
}

TEST(a_rectangle_inside_a_solid_is_not_free) {
    Fixture fixture;
    fixture_make(&fixture, 0.05);
    Furniture *bed = &fixture.furniture[1];
    double got = freespace_clearance(&fixture.space, bed->centre, vec2(1, 0), 0.05, 0.05, 0.5, NULL);
    CHECK_NEAR(got, -0.55, 0.05);
    CHECK(freespace_growth(&fixture.space, bed->centre, vec2(1, 0), 0.05, 0.05, 0.5, NULL) < -0.05);
    fixture_free(&fixture);
}

TEST(a_body_larger_than_the_buckets_reach_is_measured_as_well) {
    Fixture fixture;
    fixture_make(&fixture, 0.05);
    CHECK_NEAR(freespace_clearance(&fixture.space, vec2(3, -5), vec2(1, 0), 4, 0.5, 10, NULL), 4.4, 1e-12);
    CHECK_NEAR(freespace_clearance(&fixture.space, vec2(3, -2.1), vec2(0, 1), 2.2, 0.5, 10, NULL), -0.2, 1e-12);
    fixture_free(&fixture);
}

TEST(a_plan_as_large_as_a_country_gets_a_coarse_grid) {
    Vec2 points[2] = {{-1e5, -1e5}, {1e5, 1e5}};
    Wall wall = {.id = "w", .points = {points, 2}, .thickness = 0.1};
    Plan plan = {.name = "", .walls = &wall, .wall_count = 1};
    Outline outline = {0};
    Fault fault = {0};
    CHECK(outline_build(&outline, &plan, &fault));
    FreeSpace space;
    freespace_build(&space, &outline, 0.01);
    CHECK((double)space.nx * space.ny <= FREESPACE_MOST_POINTS);
    double distance = freespace_exact(&space, vec2(1, 0), 1.5, NULL);
    CHECK_NEAR(distance, M_SQRT1_2 - 0.05, 1e-6);
    freespace_free(&space);
    outline_free(&outline);
    fault_clear(&fault);
}

TEST(an_empty_plan_has_nothing_in_the_way) {
    Plan plan = {.name = ""};
    Outline outline = {0};
    Fault fault = {0};
    CHECK(outline_build(&outline, &plan, &fault));
    FreeSpace space;
    freespace_build(&space, &outline, 0.05);
    CHECK_NEAR(freespace_distance(&space, vec2(0, 0)), FREESPACE_FARTHEST, 0);
    CHECK_NEAR(freespace_clearance(&space, vec2(0, 0), vec2(1, 0), 1, 1, 0.5, NULL), 0.5, 0);
    freespace_free(&space);
    outline_free(&outline);
    fault_clear(&fault);
}

TEST(a_passage_is_as_wide_as_rays_across_it_are_long) {
    Fixture fixture;
    fixture_make(&fixture, 0.05);
    Random random = random_seed(11, 1);
    int narrow = 0;
    for (int i = 0; i < 2000; i++) {
        Vec2 at = {6 * random_uniform(&random), 5 * random_uniform(&random)};
        Vec2 along = vec2_heading(2 * M_PI * random_uniform(&random));
        if (freespace_distance(&fixture.space, at) < 0.1)
            continue;
        const double half = 0.8; /* m */
        Passage rays = passage_at(&fixture.outline, at, along);
        double width = fmin(rays.left, half) + fmin(rays.right, half);
        CHECK_NEAR(passage_width(passage_within(&fixture.space, at, along, half)), width, 1e-6);
        narrow += width < 2 * half;
    }
    CHECK(narrow > 300);
    fixture_free(&fixture);
}
