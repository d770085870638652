#include <stdlib.h>

#include "base/random.h"
#include "check.h"
#include "mechanics/broadphase.h"

enum { BOXES = 400, QUERIES = 300 };

static const double FAT = 0.1 + 1e-4; /* m: the tree's margin, and its single precision at 100 m */

static double between(Random *random, double low, double high) {
    return low + (high - low) * random_uniform(random);
}

static Box random_box(Random *random, double largest) {
    Vec2 low = {between(random, -50, 50), between(random, -50, 50)};
    return (Box){low, vec2_add(low, vec2(between(random, 0, largest), between(random, 0, largest)))};
}

static bool boxes_meet(Box a, Box b) {
    return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y;
}

/* Returns a tree of BOXES boxes, with every third removed again (its box then holds nothing). */
static Broadphase *grow(Random *random, Box boxes[BOXES]) {
    Broadphase *tree = broadphase_create();
    for (int i = 0; i < BOXES; i++) {
        boxes[i] = random_box(random, 8);
        broadphase_insert(tree, boxes[i], i);
    }
    return tree;
}

static bool mark(void *context, int item) {
    ((int *)context)[item]++;
    return true;
}

TEST(a_query_finds_every_box_that_meets_it_and_none_beyond_the_margin) {
    Random random = random_seed(1, 1);
    Box boxes[BOXES];
    Broadphase *tree = grow(&random, boxes);
    for (int q = 0; q < QUERIES; q++) {
        Box box = random_box(&random, 20);
        int items[BOXES], marks[BOXES] = {0};
        size_t found = broadphase_query(tree, box, items, BOXES), next = 0;
        broadphase_visit(tree, box, mark, marks);
        bool same = true, complete = true, close = true;
        for (int i = 0; i < BOXES; i++) {
            bool listed = next < found && items[next] == i;
            next += listed;
            same &= marks[i] == listed;
            complete &= listed || !boxes_meet(box, boxes[i]);
            close &= !listed || boxes_meet(box_expand(box, FAT), boxes[i]);
        }
        CHECK(next == found); /* ascending, each once */
        CHECK(same);
        CHECK(complete);
        CHECK(close);
    }
    broadphase_destroy(tree);
}

TEST(a_query_with_little_room_still_counts_what_it_finds) {
    Random random = random_seed(2, 1);
    Box boxes[BOXES];
    Broadphase *tree = grow(&random, boxes);
    Box all = {{-100, -100}, {100, 100}};
    int items[5] = {-7, -7, -7, -7, -7};
    CHECK(broadphase_query(tree, all, items, 4) == BOXES);
    CHECK(items[0] >= 0 && items[0] < items[1] && items[1] < items[2] && items[2] < items[3]);
    CHECK(items[4] == -7);
    CHECK(broadphase_query(tree, all, NULL, 0) == BOXES);
    broadphase_destroy(tree);
}

static bool stop_at_three(void *context, int item) {
    (void)item;
    return ++*(int *)context < 3;
}

TEST(a_visit_ends_when_it_is_told_to) {
    Random random = random_seed(3, 1);
    Box boxes[BOXES];
    Broadphase *tree = grow(&random, boxes);
    int count = 0;
    broadphase_visit(tree, (Box){{-100, -100}, {100, 100}}, stop_at_three, &count);
    CHECK_NEAR(count, 3, 0);
    broadphase_destroy(tree);
}

/* Tests the ray against one diagonal of each box. */
typedef struct Fence {
    const Box *boxes;
    int calls;
} Fence;

/* Returns the fraction of from-to at which the ray meets the diagonal, or `best`. */
static double meet(const Box *box, Vec2 from, Vec2 to, double best) {
    Vec2 along = vec2_sub(to, from), side = vec2_sub(box->high, box->low), offset = vec2_sub(box->low, from);
    double turn = vec2_cross(along, side), t = vec2_cross(offset, side) / turn, s = vec2_cross(offset, along) / turn;
    return turn != 0 && t >= 0 && t < best && s >= 0 && s <= 1 ? t : best;
}

static double hit(void *context, int item, Vec2 from, Vec2 to, double best) {
    Fence *fence = context;
    fence->calls++;
    return meet(&fence->boxes[item], from, to, best);
}

TEST(a_ray_meets_what_trying_everything_finds) {
    Random random = random_seed(4, 1);
    Box boxes[BOXES];
    Broadphase *tree = grow(&random, boxes);
    int met = 0, calls = 0;
    for (int q = 0; q < QUERIES; q++) {
        Vec2 from = {between(&random, -60, 60), between(&random, -60, 60)};
        Vec2 to = {between(&random, -60, 60), between(&random, -60, 60)};
        double expected = 1;
        for (int i = 0; i < BOXES; i++)
            expected = meet(&boxes[i], from, to, expected);
        Fence fence = {boxes, 0};
        double got = broadphase_ray(tree, from, to, hit, &fence);
        CHECK_NEAR(got, expected, 0); /* the same sums on the same numbers */
        met += expected < 1;
        calls += fence.calls;
    }
    CHECK(met > QUERIES / 4);
    CHECK(calls < QUERIES * BOXES / 4); /* the tree must save work */
    broadphase_destroy(tree);
}

TEST(a_ray_of_no_length_and_an_empty_tree_meet_nothing) {
    Broadphase *tree = broadphase_create();
    Fence fence = {NULL, 0};
    int items[1];
    CHECK(broadphase_ray(tree, vec2(0, 0), vec2(9, 9), hit, &fence) == 1);
    CHECK(broadphase_query(tree, box_around(vec2(0, 0), 9), items, 1) == 0);
    broadphase_insert(tree, box_around(vec2(0, 0), 1), 0);
    CHECK(broadphase_ray(tree, vec2(0, 0), vec2(0, 0), hit, &fence) == 1);
    CHECK(fence.calls == 0);
    broadphase_destroy(tree);
}
