#include "captions.h"
#include "check.h"

static const Vec2 PAGE = {1280, 720};

/* Adds a sign at a point, with its places above and below it. */
static void add_sign(Scene *scene, Vec2 at, const char *text, const char *brief) {
    Primitive *sign = scene_add_label(scene, ROLE_TEXT, 17, at, text);
    Vec2 places[] = {at, {at.x, at.y + 1}, at, {at.x, at.y - 1}};
    scene_bind_label(scene, sign, places, 4);
    sign->brief = brief;
    sign->shape = LABEL_TAG;
    sign->fixed = true;
}

static double distance_to(Box box, Vec2 at) {
    return vec2_distance(at, vec2(real_clamp(at.x, box.low.x, box.high.x), real_clamp(at.y, box.low.y, box.high.y)));
}

TEST(signs_whose_places_are_all_taken_stand_near_their_point_and_apart) {
    Scene scene = {.box = {{0, 0}, {6, 4}}};
    static const char *const names[] = {"first: 1000", "second: 1000", "third: 1000", "fourth: 1000"};
    for (size_t i = 0; i < 4; i++)
        add_sign(&scene, vec2(3 + 0.02 * (double)i, 2), names[i], NULL);
    Layout layout;
    layout_make(&layout, &scene, PAGE);
    for (size_t i = 0; i < 4; i++) {
        const Caption *sign = captions_find(&layout, names[i]);
        CHECK(sign != NULL);
        CHECK(sign && distance_to(caption_box(sign), sign->pointed) < 40);
        for (size_t k = 0; sign && k < layout.caption_count; k++)
            CHECK(&layout.captions[k] == sign ||
                  !captions_overlap(caption_box(sign), caption_box(&layout.captions[k])));
    }
    layout_clear(&layout);
    scene_clear(&scene);
}

TEST(a_sign_stands_nearer_to_its_own_point_than_to_another_sign_s) {
    Scene scene = {.box = {{0, 0}, {6, 4}}};
    Vec2 places[] = {{1.2, 2.5}, {1.2, 3}, {1.2, 2}, {1.2, 1.5}};
    Primitive *sign = scene_add_label(&scene, ROLE_TEXT, 17, vec2(1.2, 2), "one with a long name");
    scene_bind_label(&scene, sign, places, 4);
    sign->fixed = true;
    add_sign(&scene, vec2(1.2, 2.7), "two", NULL);
    Layout layout;
    layout_make(&layout, &scene, PAGE);
    const Caption *one = captions_find(&layout, "one with a long name");
    CHECK(one && distance_to(caption_box(one), layout_point(&layout, vec2(1.2, 2))) <
                     distance_to(caption_box(one), layout_point(&layout, vec2(1.2, 2.7))));
    layout_clear(&layout);
    scene_clear(&scene);
}

TEST(no_label_lies_where_a_button_lies) {
    Scene scene = {.box = {{0, 0}, {6, 4}}};
    add_sign(&scene, vec2(3, 2), "sign", NULL);
    scene_add_label(&scene, ROLE_TEXT, 17, vec2(3, 2.1), "free");
    Layout layout = {0};
    layout_make(&layout, &scene, PAGE);
    Box first = caption_box(captions_find(&layout, "sign"));
    layout_clear(&layout);
    scene.taken = box_expand(first, 20);
    layout_make(&layout, &scene, PAGE);
    Scene over = {0};
    add_sign(&over, vec2(3, 2.4), "over", NULL);
    Layout moving = {0};
    layout_make_over(&moving, &layout, &over);
    const Caption *labels[] = {captions_find(&layout, "sign"), captions_find(&layout, "free"),
                               captions_find(&moving, "over")};
    for (size_t i = 0; i < 3; i++) {
        CHECK(labels[i] != NULL);
        CHECK(labels[i] && !captions_overlap(caption_box(labels[i]), scene.taken));
    }
    layout_clear(&moving);
    layout_clear(&layout);
    scene_clear(&over);
    scene_clear(&scene);
}
