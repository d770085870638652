/* Tests the window's layout: at every size and with every option no areas overlap and all lie inside the window. */

#include "window/frame.h"

#include <math.h>

#include "check.h"

static bool is_there(Box box) {
    return box_width(box) > 1e-9 && box_height(box) > 1e-9;
}

static bool overlap(Box a, Box b) {
    const double touch = 1e-6;
    return is_there(a) && is_there(b) && a.low.x < b.high.x - touch && b.low.x < a.high.x - touch &&
           a.low.y < b.high.y - touch && b.low.y < a.high.y - touch;
}

static void check_apart(const Frame *frame) {
    Box boxes[16];
    size_t count = 0;
    const Box bars[] = {frame->menu, frame->answer, frame->toolbar, frame->view, frame->timeline, frame->strip};
    for (size_t i = 0; i < sizeof bars / sizeof *bars; i++)
        boxes[count++] = bars[i];
    for (size_t i = 0; i < frame->pane_count; i++)
        boxes[count++] = frame->panes[i];
    if (!frame->drawer)
        boxes[count++] = frame->panel;
    for (size_t i = 0; i < count; i++) {
        CHECK(boxes[i].low.x >= -1e-9 && boxes[i].high.x <= frame->page.x + 1e-9);
        CHECK(boxes[i].low.y >= -1e-9 && boxes[i].high.y <= frame->page.y + 1e-9);
        for (size_t j = 0; j < i; j++)
            CHECK(!overlap(boxes[i], boxes[j]));
    }
}

TEST(nothing_overlaps_at_any_size) {
    for (double width = 300; width < 1500; width += 53)
        for (double height = 200; height < 900; height += 47)
            for (unsigned wishes = 0; wishes < 16; wishes++)
                for (size_t plots = 0; plots <= FRAME_PANES_MOST; plots++) {
                    FrameWish wish = {.panel = wishes & 1,
                                      .plots = wishes & 2,
                                      .present = wishes & 4,
                                      .plot_count = plots,
                                      .tool_count = wishes & 8 ? 10 : 0,
                                      .aspect = wishes & 1 ? 1.2 : 6};
                    Frame frame = frame_make(vec2(width, height), &wish);
                    check_apart(&frame);
                }
}

TEST(on_a_full_page_the_view_is_large_and_all_plots_are_there) {
    Frame house =
        frame_make(vec2(1280, 720), &(FrameWish){.panel = true, .plots = true, .plot_count = 2, .aspect = 1.2});
    CHECK(house.pane_count == 2);
    CHECK(box_width(house.view) >= 500 && box_height(house.view) >= 500);
    Frame beam = frame_make(vec2(1280, 720), &(FrameWish){.panel = true, .plots = true, .plot_count = 5, .aspect = 6});
    CHECK(beam.pane_count == 5);
    CHECK(box_width(beam.view) >= 900 && box_height(beam.view) >= 120);
}

TEST(at_twice_the_letters_there_is_still_a_view) {
    Frame frame = frame_make(vec2(640, 360), &(FrameWish){.plots = true, .plot_count = 2, .aspect = 1.2});
    CHECK(frame.compact && frame.drawer);
    CHECK(box_width(frame.view) >= 250 && box_height(frame.view) >= 200);
}

TEST(presenting_leaves_answer_view_and_timeline) {
    Frame frame = frame_make(
        vec2(853, 480), &(FrameWish){.panel = true, .plots = true, .present = true, .plot_count = 2, .aspect = 1.2});
    CHECK(!is_there(frame.menu) && !is_there(frame.strip) && !is_there(frame.panel));
    CHECK(is_there(frame.answer) && is_there(frame.view) && is_there(frame.timeline));
}

TEST(the_rail_has_words_where_there_is_room_and_goes_before_a_class) {
    FrameWish wish = {.panel = true, .plots = true, .plot_count = 2, .tool_count = 10, .aspect = 1.2};
    Frame wide = frame_make(vec2(1280, 720), &wish), low = frame_make(vec2(500, 300), &wish);
    CHECK(wide.tool_labels && wide.tool_columns == 1 && is_there(wide.toolbar));
    CHECK(!low.tool_labels && low.tool_columns == 2 && box_width(low.view) >= 250);
    wish.present = true;
    CHECK(!is_there(frame_make(vec2(1280, 720), &wish).toolbar));
}

TEST(presentation_grows_unless_it_leaves_too_small_a_page) {
    CHECK_NEAR(frame_unit(1280, 720, 1, 1, false), 1, 1e-12);
    CHECK_NEAR(frame_unit(1920, 1080, 1, 1, false), sqrt(1.5), 1e-12);
    for (double text = 1; text <= 2; text += 0.25)
        for (int height = 480; height <= 2160; height += 60) {
            int width = height * 16 / 9;
            double own = frame_unit(width, height, 1, text, false), present = frame_unit(width, height, 1, text, true);
            CHECK(present >= own);
            CHECK(present <= own || (width / present >= 800 - 1e-9 && height / present >= 450 - 1e-9));
        }
    CHECK_NEAR(frame_unit(1280, 720, 1, 1, true), 1.45, 1e-12);
    CHECK_NEAR(frame_unit(1280, 720, 1, 1.5, true), 1.6, 1e-12);
    CHECK_NEAR(frame_unit(1280, 720, 1, 2, true), 2, 1e-12);
}

/* The dials of a machine say nothing without their names; a plan has so many that they hide it. */
TEST(a_machine_keeps_its_names_while_the_view_has_room) {
    FrameWish wish = {.present = true, .aspect = 2};
    Frame present = frame_make(vec2(883, 497), &wish), tiny = frame_make(vec2(500, 300), &wish);
    CHECK(present.compact && !frame_hides_names(&present, false) && frame_hides_names(&present, true));
    CHECK(tiny.compact && frame_hides_names(&tiny, false));
    Frame full = frame_make(vec2(1280, 720), &wish);
    CHECK(!frame_hides_names(&full, false) && !frame_hides_names(&full, true));
}
