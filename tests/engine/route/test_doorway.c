/* Tests of which shut doors a chair opens along a path: a wall along x with a door from 1.6 to 2.4 m. */

#include "check.h"

#include "route/doorway.h"

enum { MOST = 200 };

#define OPENING 3.0 /* s */

typedef struct Scene {
    Vec2 points[2];
    Wall wall;
    Door door;
    Plan plan;
    Profile chair;
    DoorwayPlace places[MOST];
    size_t count;
} Scene;

static void make_scene(Scene *scene, DoorKind kind) {
    *scene = (Scene){.points = {{0, 0}, {4, 0}},
                     .wall = {.id = "w1", .thickness = 0.1},
                     .door = {.id = "d1",
                              .at = 2,
                              .width = 0.8,
                              .kind = kind,
                              .state = DOOR_CLOSED,
                              .swing = SWING_LEFT,
                              .opening_time = OPENING},
                     .chair = {.driving = DRIVING_DRIVER, .width = 0.63, .length = 1.1, .axle = 0.27}};
    scene->wall.points.at = scene->points;
    scene->wall.points.count = 2;
    scene->plan =
        (Plan){.name = "wall", .walls = &scene->wall, .wall_count = 1, .doors = &scene->door, .door_count = 1};
}

/* Adds places every 5 cm from one place to another, the body ahead in the direction of travel. */
static void go(Scene *scene, Vec2 from, Vec2 to) {
    Vec2 axis = vec2_unit(vec2_sub(to, from));
    for (double s = 0; s <= vec2_distance(from, to) && scene->count < MOST; s += 0.05)
        scene->places[scene->count++] = (DoorwayPlace){vec2_along(from, s, axis), axis};
}

static double delay(const Scene *scene) {
    return doorway_delay(scene->places, scene->count, &scene->plan, &scene->chair);
}

TEST(a_door_is_opened_once_however_often_it_is_gone_through) {
    Scene scene;
    make_scene(&scene, DOOR_SLIDING);
    go(&scene, vec2(2, -2), vec2(2, 2));
    CHECK_NEAR(delay(&scene), OPENING, 0);
    go(&scene, vec2(2, 2), vec2(2, -2));
    CHECK_NEAR(delay(&scene), OPENING, 0);
    scene.door.state = DOOR_OPEN;
    CHECK_NEAR(delay(&scene), 0, 0);
}

/* Past a sliding door, the side of the chair 1 and 5 cm from its leaf, in front of which the wall is cut away. */
TEST(a_door_that_a_chair_only_comes_by_stays_shut) {
    static const double spaces[] = {0.01, 0.05};
    for (size_t i = 0; i < 2; i++) {
        Scene scene;
        make_scene(&scene, DOOR_SLIDING);
        double y = scene.chair.width / 2 + spaces[i];
        go(&scene, vec2(0.5, y), vec2(3.5, y));
        CHECK_NEAR(delay(&scene), spaces[i] < 0.03 ? OPENING : 0, 0);
    }
}

/* Where it swings to, a hinged door is in the way; but it stays shut unless the chair comes to its leaf. */
TEST(doors_are_marked_where_the_chair_gets_in_their_way) {
    Scene scene;
    int doors[MOST];
    make_scene(&scene, DOOR_HINGED);
    go(&scene, vec2(2, 3), vec2(2, -2));
    doorway_mark(doors, scene.places, scene.count, &scene.plan, &scene.chair);
    size_t marked = 0, first = MOST;
    for (size_t i = 0; i < scene.count; i++)
        if (doors[i] >= 0) {
            first = marked++ ? first : i;
            CHECK(doors[i] == 0);
        }
    CHECK(marked == 1);
    /* the front edge, 0.83 m ahead of the axle, comes within 0.1 m of the swing, which is 0.8 m deep */
    CHECK_NEAR(scene.places[first].at.y, 0.83 + 0.8 + 0.1, 0.06);
}
