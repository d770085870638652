/* Tests that names on a plan leave the people on it free, and how walls are called. */
#include "check.h"
#include <string.h>

#include "draw/layout.h"
#include "result/names.h"
#include "visual/house/plan_picture.h"
#include "visual/house/plan_scene.h"

static const char room[] =
    "{\"format\": \"clearance-house\", \"version\": 1, \"name\": \"hall\","
    " \"walls\": [{\"id\": \"w1\", \"points\": [[0, 0], [6, 0], [6, 4], [0, 4], [0, 0]], \"thickness\": 0.1}],"
    " \"rooms\": [{\"id\": \"r1\", \"name\": \"living room\", \"outline\": [[0, 0], [6, 0], [6, 4], [0, 4]]}],"
    " \"people\": [{\"id\": \"p1\", \"profile\": \"manual-chair\", \"at\": [3, 2], \"heading\": 0}]}";

TEST(names_leave_people_free) {
    static const Vec2 pages[] = {{1280, 720}, {640, 400}, {400, 300}};
    House house = {.seed = 0};
    Fault fault = {0};
    CHECK(plan_read_text(&house.plan, "hall", room, NULL, 0, &fault) &&
          outline_build(&house.outline, &house.plan, &fault));
    for (size_t p = 0; p < sizeof pages / sizeof *pages; p++) {
        Scene scene = {.bare = true, .unscaled = true};
        Layout layout = {.caption_count = 0};
        plan_picture_bare(&scene, &house);
        plan_scene_names(&scene, &house);
        layout_make(&layout, &scene, pages[p]);
        Vec2 at = layout_point(&layout, vec2(3, 2));
        for (size_t i = 0; i < layout.caption_count; i++) {
            const Caption *caption = &layout.captions[i];
            CHECK(fabs(caption->centre.x - at.x) > caption->extent.x / 2 ||
                  fabs(caption->centre.y - at.y) > caption->extent.y / 2);
        }
        layout_clear(&layout);
        scene_clear(&scene);
    }
    house_free(&house);
    fault_clear(&fault);
}

static void check_wall(const char *source, Vec2 at, const char *called) {
    House house = {.seed = 0};
    Fault fault = {0};
    Arena arena = {0};
    CHECK(plan_read_text(&house.plan, "hall", source, NULL, 0, &fault));
    CHECK_TEXT(names_thing(&house, "wall w1", at, &arena), called);
    arena_clear(&arena);
    house_free(&house);
    fault_clear(&fault);
}

TEST(a_wall_is_called_by_its_room_or_else_by_the_side_of_the_plan) {
    char bare[sizeof room];
    const char *rooms = strstr(room, " \"rooms\""), *people = strstr(room, " \"people\"");
    snprintf(bare, sizeof bare, "%.*s%s", (int)(rooms - room), room, people);
    check_wall(room, vec2(3, 0.05), "lower wall of living room");
    check_wall(bare, vec2(3, 0.05), "lower wall");
    check_wall(bare, vec2(5.95, 2), "right wall");
    check_wall(bare, vec2(3, 2), "wall");
}

TEST(sentences_name_things_with_an_article) {
    static const char plan[] =
        "{\"format\": \"clearance-house\", \"version\": 1, \"name\": \"hall\","
        " \"walls\": [{\"id\": \"w1\", \"points\": [[0, 0], [6, 0], [6, 4], [0, 4], [0, 0]], \"thickness\": 0.1}],"
        " \"furniture\": [{\"id\": \"f1\", \"name\": \"chest of drawers\", \"centre\": [3, 2], \"size\": [1, 1]},"
        "                 {\"id\": \"stove\", \"centre\": [1, 1], \"size\": [0.5, 0.5]}]}";
    static const char *const sentences[][2] = {
        {"A cannot pass wall w1", "A cannot pass the wall"},
        {"A cannot pass chest of drawers (f1)", "A cannot pass the chest of drawers"},
        {"A is blocked at stove after 3.0 s", "A is blocked at the stove after 3.0 s"},
        {"A cannot pass here", "A cannot pass here"},
        {"narrowest 0.06 m beside chest of drawers (f1)", "narrowest 0.06 m beside chest of drawers"},
    };
    House house = {.seed = 0};
    Fault fault = {0};
    Arena arena = {0};
    CHECK(plan_read_text(&house.plan, "hall", plan, NULL, 0, &fault));
    for (size_t i = 0; i < sizeof sentences / sizeof *sentences; i++)
        CHECK_TEXT(names_text(&house, sentences[i][0], &arena), sentences[i][1]);
    arena_clear(&arena);
    house_free(&house);
    fault_clear(&fault);
}

TEST(people_of_one_route_are_told_apart) {
    PlanRoute routes[] = {{.id = "A"}, {.id = "B"}};
    Inhabitant people[] = {
        {.id = "c", .route = &routes[0]}, {.id = "d", .route = &routes[1]}, {.id = "e", .route = &routes[0]}};
    House house = {.people = people, .person_count = 3};
    Arena arena = {0};
    CHECK_TEXT(names_person(&house, 0, &arena), "A-1");
    CHECK_TEXT(names_person(&house, 1, &arena), "B");
    CHECK_TEXT(names_person(&house, 2, &arena), "A-2");
    arena_clear(&arena);
}
