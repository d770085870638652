/* Tests that outlines of walls are kept while walls and doors are the same, and are those of the plan after any edit of
 * either. */
#include "visual/house/plan_walls.h"

#include <string.h>

#include "case.h"
#include "check.h"

#define CUT 0.9 /* m */

static void check_same(const PlanWalls *a, const PlanWalls *b) {
    CHECK_NEAR((double)a->count, (double)b->count, 0);
    for (size_t i = 0; i < a->count; i++) {
        const Rings *first = &a->bands[i].rings, *second = &b->bands[i].rings;
        CHECK(first->count == second->count && first->point_count == second->point_count);
        CHECK(memcmp(first->points, second->points, first->point_count * sizeof *first->points) == 0);
        CHECK(memcmp(first->starts, second->starts, (first->count + 1) * sizeof *first->starts) == 0);
        CHECK_NEAR(a->bands[i].shown, b->bands[i].shown, 0);
    }
}

/* Updates kept outlines after an edit; true: they were kept, which only an edit of something else may do. */
static bool keeps(PlanWalls *kept, const char *const *settings) {
    House house;
    PlanWalls fresh = {0};
    const Vec2 *before = kept->count ? kept->bands[0].rings.points : NULL;
    bool made;
    case_house(&house, "ube-techno-house", -1, settings);
    made = plan_walls_update(kept, &house.plan, CUT);
    CHECK(made || kept->bands[0].rings.points == before);
    CHECK(plan_walls_update(&fresh, &house.plan, CUT));
    check_same(kept, &fresh);
    plan_walls_clear(&fresh);
    house_free(&house);
    return !made;
}

TEST(outlines_are_kept_until_a_wall_or_a_door_changes) {
    PlanWalls kept = {0};
    CHECK(!keeps(&kept, NULL));
    CHECK(keeps(&kept, NULL));
    CHECK(keeps(&kept, (const char *[]){"furniture.chair-1.centre=[0.9,1.6]", NULL}));
    CHECK(!keeps(&kept, (const char *[]){"door.d1.width=0.83", NULL}));
    CHECK(keeps(&kept, (const char *[]){"door.d1.width=0.83", NULL}));
    CHECK(!keeps(&kept, (const char *[]){"door.d1.state=locked", NULL}));
    CHECK(!keeps(&kept, (const char *[]){"wall.w5.thickness=0.15", NULL}));
    CHECK(!keeps(&kept, (const char *[]){"wall.w5.height=0.5", NULL}));
    CHECK(kept.count == 2 && kept.bands[0].shown < CUT);
    CHECK(!keeps(&kept, NULL));
    plan_walls_clear(&kept);
}
