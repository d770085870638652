/* Tests the foot of a plan: the key of the colours of a crowd, with five numbers at every size and no words over
 * others, and the scale bar. */
#include <string.h>

#include "check.h"
#include "draw/layout.h"
#include "visual/house/density_scene.h"

static bool overlap(const Caption *a, const Caption *b) {
    Vec2 apart = vec2_sub(a->centre, b->centre);
    return fabs(apart.x) < (a->extent.x + b->extent.x) / 2 && fabs(apart.y) < (a->extent.y + b->extent.y) / 2;
}

TEST(the_key_has_five_numbers_and_no_words_overlap_also_when_it_is_tiny) {
    static const Vec2 pages[] = {{1280, 720}, {976, 540}, {640, 400}, {486, 500}, {400, 300}, {320, 200}, {260, 160}};
    static const char *const numbers[] = {"0.5", "1", "1.5", "2", "3+"};
    for (size_t p = 0; p < sizeof pages / sizeof *pages; p++) {
        Scene scene = {.box = {{0, 0}, {60, 20}}, .bare = true, .unscaled = true};
        Layout layout = {.caption_count = 0};
        density_scene_key(&scene);
        layout_make(&layout, &scene, pages[p]);
        size_t found = 0;
        for (size_t n = 0; n < sizeof numbers / sizeof *numbers; n++)
            for (size_t i = 0; i < layout.caption_count; i++)
                found += strcmp(layout.captions[i].text, numbers[n]) == 0;
        CHECK(found == 5 && layout.caption_count == 6); /* and what they are */
        for (size_t a = 0; a < layout.caption_count; a++)
            for (size_t b = a + 1; b < layout.caption_count; b++)
                CHECK(!overlap(&layout.captions[a], &layout.captions[b]));
        layout_clear(&layout);
        scene_clear(&scene);
    }
}

TEST(large_letters_leave_the_numbers_of_the_key_apart) {
    static const Vec2 pages[] = {{640, 360}, {427, 240}, {341, 200}, {280, 160}};
    for (size_t p = 0; p < sizeof pages / sizeof *pages; p++) {
        Scene scene = {.box = {{0, 0}, {20, 20}}, .bare = true, .unscaled = true};
        Layout layout = {.caption_count = 0};
        density_scene_key(&scene);
        layout_make(&layout, &scene, pages[p]);
        bool first = false, last = false;
        for (size_t a = 0; a < layout.caption_count; a++) {
            first |= strcmp(layout.captions[a].text, "0.5") == 0;
            last |= strcmp(layout.captions[a].text, "3+") == 0;
            for (size_t b = a + 1; b < layout.caption_count; b++)
                CHECK(!overlap(&layout.captions[a], &layout.captions[b]));
        }
        CHECK(first && (last || pages[p].x < 300));
        CHECK(layout.caption_count >= 5 || pages[p].x < 640);
        layout_clear(&layout);
        scene_clear(&scene);
    }
}

TEST(the_scale_is_shorter_where_the_usual_one_would_lie_over_the_plan) {
    static const struct {
        Vec2 page;
        const char *length;
    } cases[] = {{{720, 540}, "1 m"}, {{330, 236}, "2 m"}, {{300, 236}, "1 m"}};
    for (size_t c = 0; c < sizeof cases / sizeof *cases; c++) {
        Scene scene = {.box = {{0, 0}, {6, 8}}, .bare = true};
        Layout layout = {.caption_count = 0};
        layout_make(&layout, &scene, cases[c].page);
        const Sample *bar = &layout.samples[layout.sample_count - 1];
        CHECK_TEXT(layout.captions[layout.caption_count - 1].text, cases[c].length);
        CHECK(bar->from.x > layout_point(&layout, scene.box.high).x || bar->from.y > layout.plan.high.y);
        layout_clear(&layout);
        scene_clear(&scene);
    }
}

TEST(an_area_counts_when_enough_people_stand_there) {
    Vec2 places[400];
    size_t count = 0;
    for (int x = 0; x < 20; x++)
        for (int y = 0; y < 20; y++) /* 4 on a square metre, on 10 m x 10 m */
            places[count++] = vec2(5.25 + 0.5 * x, 5.25 + 0.5 * y);
    Box box = {{0, 0}, {20, 20}};
    CHECK_NEAR(density_scene_area(box, places, count, 2), 100, 12); /* the disc blurs the edge of 40 m */
    CHECK(density_scene_area(box, places, count, 5) == 0);
    CHECK(density_scene_area(box, places, 0, 0.5) == 0);
}
