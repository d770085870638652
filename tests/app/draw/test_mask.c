#include "draw/mask.h"

#include <string.h>

#include "base/memory.h"
#include "check.h"

TEST(a_mask_sums_weight_times_area_and_takes_the_largest_weight) {
    Mask mask;
    mask_init(&mask, (Box){{0, 0}, {80, 40}});
    mask_mark_box(&mask, (Box){{8, 8}, {23.9, 23.9}}, 2);
    mask_mark_box(&mask, (Box){{8, 8}, {23.9, 23.9}}, 1);
    CHECK_NEAR(mask_cost(&mask, (Box){{0, 0}, {80, 40}}), 2 * 16 * 16, 1e-6);
    CHECK_NEAR(mask_cost(&mask, (Box){{10, 10}, {13, 14}}), 2 * 3 * 4, 1e-6);
    CHECK_NEAR(mask_cost(&mask, (Box){{-10, 0}, {0, 10}}), MASK_OUTSIDE * 100, 1e-6);
    CHECK_NEAR(mask_line_cost(&mask, vec2(0, 30), vec2(80, 30)), 0, 1e-6);
    mask_clear(&mask);
}

TEST(a_mask_leaves_the_hole_of_a_ring_free) {
    Mask mask;
    mask_init(&mask, (Box){{0, 0}, {100, 100}});
    Vec2 points[] = {{0, 0}, {100, 0}, {100, 100}, {0, 100}, {20, 20}, {80, 20}, {80, 80}, {20, 80}};
    mask_mark_rings(&mask, points, (size_t[]){0, 4, 8}, 2, 1);
    CHECK_NEAR(mask_cost(&mask, (Box){{30, 30}, {70, 70}}), 0, 1e-6);
    CHECK_NEAR(mask_cost(&mask, (Box){{0, 0}, {10, 100}}), 1000, 1e-6);
    mask_clear(&mask);
}

/* A map may lie where another one lay before. */
TEST(a_new_mask_has_marked_no_cells) {
    Mask mask;
    mask_init(&mask, (Box){{0, 0}, {100, 100}});
    for (int round = 0; round < 2; round++) {
        mask_mark_line(&mask, vec2(50, 50), vec2(50, 50), 3, 1);
        CHECK(mask_cost(&mask, (Box){{0, 0}, {100, 100}}) > 0);
        memory_free(mask.weights);
        mask_init(&mask, (Box){{0, 0}, {100, 100}});
    }
    mask_clear(&mask);
}

/* The boxes of a line's points, one by one, raise the same cells. */
TEST(a_line_marks_the_cells_of_each_of_its_points) {
    Mask line, boxes;
    mask_init(&line, (Box){{0, 0}, {100, 100}});
    mask_init(&boxes, (Box){{0, 0}, {100, 100}});
    Vec2 from = {50, 50};
    for (int i = 0; i < 400; i++) {
        Vec2 to = vec2_along(vec2(50, 50), 0.15 * i, vec2_heading(0.05 * i));
        double weight = 0.5 + 0.1 * (i % 7 == 0) - 0.2 * (i % 11 == 0);
        mask_mark_line(&line, from, to, 3, weight);
        int pieces = (int)ceil(vec2_distance(from, to) / 4) + 1;
        for (int k = 0; k <= pieces; k++)
            mask_mark_box(&boxes, box_around(vec2_along(from, (double)k / pieces, vec2_sub(to, from)), 1.5), weight);
        from = to;
    }
    CHECK(memcmp(line.weights, boxes.weights, (size_t)line.nx * (size_t)line.ny * sizeof *line.weights) == 0);
    mask_clear(&line);
    mask_clear(&boxes);
}
