/* Tests that triangles cover a ring once, and that their borders are the ring: whichever way the ring runs, however it
 * is turned, and whether it is halved, a fan, or goes through GEOS. */

#include "paint/tessellation.h"

#include <math.h>
#include <string.h>

#include "check.h"

enum { POINTS_MOST = 72 };

typedef struct Ring {
    Vec2 points[POINTS_MOST];
    size_t count;
} Ring;

static double ring_area(const Ring *ring) {
    double twice = 0;
    for (size_t i = 0; i < ring->count; i++)
        twice += vec2_cross(ring->points[i], ring->points[(i + 1) % ring->count]);
    return fabs(twice) / 2;
}

static double ring_length(const Ring *ring) {
    double length = 0;
    for (size_t i = 0; i < ring->count; i++)
        length += vec2_distance(ring->points[i], ring->points[(i + 1) % ring->count]);
    return length;
}

/* Checks the triangles of a ring, and their number. */
static void check_ring(const Ring *ring, size_t expected) {
    Tessellation tessellation = {0};
    const size_t starts[] = {0, ring->count};
    tessellation_make(&tessellation, ring->points, starts, 1, false);
    double area = 0, border = 0;
    for (size_t i = 0; i < tessellation.count; i++) {
        const Triangle *triangle = &tessellation.triangles[i];
        Vec2 a = triangle->corners[0], b = triangle->corners[1], c = triangle->corners[2];
        double own = vec2_cross(vec2_sub(b, a), vec2_sub(c, a)) / 2;
        CHECK(own >= 0);
        area += own;
        for (int k = 0; k < 3; k++)
            border += triangle->border[k] ? vec2_distance(triangle->corners[k], triangle->corners[(k + 1) % 3]) : 0;
    }
    CHECK_NEAR((double)tessellation.count, (double)expected, 0);
    CHECK_NEAR(area, ring_area(ring), 1e-12 * ring_area(ring));
    CHECK_NEAR(border, ring_length(ring), 1e-12 * ring_length(ring));
    tessellation_clear(&tessellation);
}

/* Checks a ring as it is, turned by some angles, and each of these run backwards and from every point on. */
static void check_turned(const Ring *ring, size_t expected) {
    for (int angle = 0; angle < 8; angle++)
        for (size_t first = 0; first < ring->count; first++)
            for (int backwards = 0; backwards < 2; backwards++) {
                Ring turned = {.count = ring->count};
                for (size_t i = 0; i < ring->count; i++) {
                    size_t from = (first + (backwards ? ring->count - i : i)) % ring->count;
                    turned.points[i] = vec2_turn(ring->points[from], vec2_heading(0.7 * angle));
                }
                check_ring(&turned, expected);
            }
}

TEST(a_convex_quadrangle_is_two_triangles) {
    check_turned(&(Ring){.points = {{0, 0}, {3, 0.5}, {2, 2}, {-1, 1}}, .count = 4}, 2);
}

TEST(a_quadrangle_with_a_corner_that_points_inwards_is_covered_once) {
    /* from the corner that points inwards, and from the one opposite, two triangles; from the others a fan or GEOS */
    const Ring ring = {.points = {{0, 0}, {4, -1}, {1, 0.2}, {4, 1.5}}, .count = 4};
    check_ring(&ring, 2);
    check_ring(&(Ring){.points = {{4, -1}, {1, 0.2}, {4, 1.5}, {0, 0}}, .count = 4}, 2);
}

TEST(a_personal_space_that_is_pressed_in_is_a_fan) {
    Ring ring = {.count = POINTS_MOST};
    for (size_t i = 0; i < ring.count; i++) {
        double angle = 2 * M_PI * (double)i / (double)ring.count;
        ring.points[i] = vec2_scale(vec2_heading(angle), 1 - 0.3 * exp(-8 * angle * angle));
    }
    check_ring(&ring, POINTS_MOST);
}

TEST(a_ring_that_hides_a_part_from_its_middle_goes_through_geos) {
    /* a U: the mean of its points lies in the gap */
    const Ring ring = {.points = {{0, 0}, {3, 0}, {3, 3}, {2, 3}, {2, 1}, {1, 1}, {1, 3}, {0, 3}}, .count = 8};
    check_turned(&ring, 6);
}

/* A ring that GEOS has met before is not sent there again: the triangles must be those of the first time, and those of
 * a ring that differs in one bit must be its own. */
TEST(triangles_that_are_kept_are_those_of_the_ring) {
    Tessellation tessellation = {0};
    Ring ring = {.points = {{0, 0}, {3, 0}, {3, 3}, {2, 3}, {2, 1}, {1, 1}, {1, 3}, {0, 3}}, .count = 8};
    const size_t starts[] = {0, 8};
    for (int round = 0; round < 3; round++)
        for (int i = 0; i < TESSELLATION_KEPT + 3; i++) {
            Ring other = ring;
            other.points[3].x = i ? 2 + 0.01 * i : nextafter(2, 3);
            const Ring *rings[] = {&ring, &other, &ring};
            for (size_t r = 0; r < sizeof rings / sizeof *rings; r++) {
                Tessellation fresh = {0};
                tessellation_make(&tessellation, rings[r]->points, starts, 1, false);
                tessellation_make(&fresh, rings[r]->points, starts, 1, false);
                CHECK(fresh.count == 6 && tessellation.count == 6);
                for (size_t k = 0; k < fresh.count; k++)
                    CHECK(memcmp(fresh.triangles[k].corners, tessellation.triangles[k].corners,
                                 sizeof fresh.triangles[k].corners) == 0 &&
                          memcmp(fresh.triangles[k].border, tessellation.triangles[k].border,
                                 sizeof fresh.triangles[k].border) == 0);
                tessellation_clear(&fresh);
            }
        }
    tessellation_clear(&tessellation);
}
