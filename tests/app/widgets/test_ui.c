#include "check.h"

#include <cairo.h>
#include <stdio.h>
#include <string.h>

#include "base/digest.h"
#include "pane.h"
#include "draw/text.h"

enum { WIDTH = 1280, HEIGHT = 720 };

/* The stops of the panel. */
enum { SLIDER, DAMPING, CHOICE, FLAG, KEEP, EXPORT, ROW_FIRST, ROW_SECOND, FIELD };

static uint64_t picture_digest(Pane *pane) {
    pane_picture(pane);
    return digest_bytes(DIGEST_START, pane->pixels, (size_t)pane->input.width * (size_t)pane->input.height * 4);
}

static Vec2 middle(Box box) {
    return vec2_scale(vec2_add(box.low, box.high), 0.5);
}

/* The focus -------------------------------------------------------------------------------------------------------- */

static void check_round(double text, Theme theme) {
    Pane pane = pane_begin(WIDTH, HEIGHT, text, theme);
    uint64_t seen[PANE_STOPS];
    pane_frame(&pane);
    for (int i = 0; i < PANE_STOPS; i++)
        pane_key(&pane, UI_KEY_NEXT);
    for (int i = 0; i < PANE_STOPS; i++) {
        CHECK(pane_key(&pane, UI_KEY_NEXT));
        seen[i] = picture_digest(&pane);
        for (int k = 0; k < i; k++)
            CHECK(seen[k] != seen[i]); /* each stop has a visible focus frame */
    }
    for (int i = 0; i < PANE_STOPS; i++) {
        pane_key(&pane, UI_KEY_NEXT);
        CHECK(picture_digest(&pane) == seen[i]);
    }
    pane_end(&pane);
}

TEST(tab_comes_to_every_stop_once_and_goes_round) {
    check_round(1, THEME_PAPER);
    check_round(2, THEME_BOARD);
}

TEST(shift_tab_goes_back) {
    Pane pane = pane_begin(WIDTH, HEIGHT, 1, THEME_PAPER);
    pane_frame(&pane);
    pane_go(&pane, "panel", 2);
    uint64_t before = picture_digest(&pane);
    pane_key(&pane, UI_KEY_NEXT);
    pane_key(&pane, UI_KEY_PREVIOUS);
    ui_key(pane.ui, UI_KEY_ESCAPE, false, false); /* its help, shown after a key as before */
    pane_go(&pane, "panel", 2);
    CHECK(picture_digest(&pane) == before);
    pane_end(&pane);
}

TEST(f6_comes_to_every_pane) {
    static const char *const names[] = {"menu", "plan", "rail", "panel", "timeline"};
    Pane pane = pane_begin(WIDTH, HEIGHT, 1, THEME_PAPER);
    pane_frame(&pane);
    CHECK_TEXT(ui_focus_pane(pane.ui), "");
    for (int i = 0; i <= PANE_PANES; i++) {
        CHECK(pane_key(&pane, UI_KEY_PANE));
        CHECK_TEXT(ui_focus_pane(pane.ui), names[i % PANE_PANES]);
        CHECK(ui_focus_is_pane(pane.ui) == (i % PANE_PANES == 1));
    }
    for (int i = PANE_PANES; i-- > 0;) {
        pane_key(&pane, UI_KEY_PANE_BACK);
        CHECK_TEXT(ui_focus_pane(pane.ui), names[i]);
    }
    pane_end(&pane);
}

TEST(the_frame_of_the_focus_is_black_on_paper_and_white_on_the_board) {
    for (Theme theme = THEME_PAPER; theme < THEME_COUNT; theme++) {
        Pane pane = pane_begin(WIDTH, HEIGHT, 1, theme);
        unsigned char ink = theme == THEME_PAPER ? 0 : 255;
        pane_go(&pane, "plan", 0);
        pane_picture(&pane);
        for (int i = 0; i < 3; i++) { /* the plan's left edge, three pixels wide; then the rim */
            const unsigned char *pixel = pane.pixels + 4 * (400 * WIDTH + (int)pane.canvas.low.x + i);
            CHECK(pixel[0] == ink && pixel[1] == ink && pixel[2] == ink);
            CHECK(pixel[12] == 255 - ink || i == 2);
        }
        pane_end(&pane);
    }
}

TEST(a_stop_that_is_gone_leaves_the_focus_to_the_first_of_its_pane) {
    Pane pane = pane_begin(WIDTH, HEIGHT, 1, THEME_PAPER);
    pane_frame(&pane);
    pane_go(&pane, "panel", SLIDER);
    pane.short_panel = true;
    pane_frame(&pane);
    CHECK_TEXT(ui_focus_pane(pane.ui), "panel");
    int before = (int)pane.damping.value;
    CHECK(pane_key(&pane, UI_KEY_RIGHT));
    CHECK(pane.damping.value > before);
    pane_end(&pane);
}

TEST(a_pane_that_is_gone_leaves_the_focus_where_no_key_presses_a_button) {
    Pane pane = pane_begin(WIDTH, HEIGHT, 1, THEME_PAPER);
    pane.modal = false;
    pane_frame(&pane);
    pane_go(&pane, "panel", SLIDER);
    pane.no_panel = true;
    pane_frame(&pane);
    pane_frame(&pane);
    CHECK_TEXT(ui_focus_pane(pane.ui), "plan");
    CHECK(ui_focus_is_pane(pane.ui));
    pane_end(&pane);
}

/* The mouse -------------------------------------------------------------------------------------------------------- */

TEST(a_click_presses_once_and_leaves_the_focus) {
    Pane pane = pane_begin(WIDTH, HEIGHT, 1, THEME_PAPER);
    pane_go(&pane, "plan", 0);
    pane_down(&pane, middle(pane.pause));
    pane_frame(&pane);
    CHECK(pane.pauses == 0);
    pane_up(&pane, middle(pane.pause));
    pane_frame(&pane);
    CHECK(pane.pauses == 1);
    CHECK_TEXT(ui_focus_pane(pane.ui), "plan");
    CHECK(!pane_key(&pane, UI_KEY_SPACE));
    CHECK(pane.pauses == 1);
    pane_end(&pane);
}

TEST(a_press_that_goes_elsewhere_is_none) {
    Pane pane = pane_begin(WIDTH, HEIGHT, 1, THEME_PAPER);
    pane_frame(&pane);
    pane_down(&pane, middle(pane.pause));
    pane_up(&pane, middle(pane.canvas));
    pane_down(&pane, middle(pane.canvas));
    pane_up(&pane, middle(pane.pause));
    pane_frame(&pane);
    CHECK(pane.pauses == 0);
    CHECK(!pane.grab.held);
    pane_end(&pane);
}

TEST(a_canvas_is_held_outside_its_box_too) {
    Pane pane = pane_begin(WIDTH, HEIGHT, 2, THEME_PAPER);
    pane_frame(&pane);
    Vec2 at = middle(pane.canvas), outside = middle(pane.pause);
    pane_down(&pane, at);
    CHECK(pane.grab.pressed && pane.grab.held && !pane.grab.twice);
    CHECK_NEAR(pane.grab.at.x, at.x, 1e-9);
    pane_move(&pane, outside);
    CHECK(pane.grab.held && !pane.grab.hovered && !pane.grab.pressed);
    CHECK_NEAR(pane.grab.delta.y, outside.y - at.y, 1e-9);
    pane_up(&pane, outside);
    CHECK(pane.grab.released && !pane.grab.held && pane.pauses == 0);
    pane_move(&pane, at);
    pane.input.wheel = -2;
    pane.input.down[1] = true;
    pane_frame(&pane);
    CHECK(pane.grab.wheel == -2 && pane.grab.right_pressed && !pane.grab.pressed);
    for (int i = 0; i < 30; i++) /* the first press of this test is half a second old */
        pane_frame(&pane);
    pane_down(&pane, at);
    pane_up(&pane, at);
    pane_down(&pane, at);
    CHECK(pane.grab.twice);
    pane_end(&pane);
}

TEST(help_comes_after_half_a_second_of_hovering_and_goes_with_escape) {
    Pane pane = pane_begin(WIDTH, HEIGHT, 1, THEME_PAPER);
    pane_frame(&pane);
    pane_move(&pane, middle(pane.pause));
    uint64_t bare = picture_digest(&pane);
    CHECK(picture_digest(&pane) == bare);
    for (int i = 0; i < 40; i++)
        pane_frame(&pane);
    CHECK(picture_digest(&pane) != bare);
    CHECK(pane_key(&pane, UI_KEY_ESCAPE));
    CHECK(picture_digest(&pane) == bare);
    CHECK(!pane_key(&pane, UI_KEY_ESCAPE));
    pane_end(&pane);
}

TEST(help_of_a_pressed_button_waits_until_the_mouse_has_left_it) {
    Pane pane = pane_begin(WIDTH, HEIGHT, 1, THEME_PAPER);
    pane_frame(&pane);
    pane_move(&pane, middle(pane.pause));
    pane_down(&pane, middle(pane.pause));
    pane_up(&pane, middle(pane.pause));
    uint64_t bare = picture_digest(&pane);
    for (int i = 0; i < 40; i++)
        pane_frame(&pane);
    CHECK(picture_digest(&pane) == bare); /* who has pressed it knows what it does, and looks at the result */
    pane_move(&pane, middle(pane.canvas));
    pane_frame(&pane);
    pane_move(&pane, middle(pane.pause));
    for (int i = 0; i < 40; i++)
        pane_frame(&pane);
    CHECK(picture_digest(&pane) != bare);
    pane_end(&pane);
}

TEST(help_comes_with_the_focus_of_a_key) {
    Pane pane = pane_begin(WIDTH, HEIGHT, 1, THEME_PAPER);
    pane_frame(&pane);
    CHECK(!ui_focus_help(pane.ui));
    pane_go(&pane, "rail", 0);
    pane_key(&pane, UI_KEY_NEXT);
    CHECK_TEXT(ui_focus_help(pane.ui), "Name  K\nOne sentence about what it does.");
    CHECK(pane_key(&pane, UI_KEY_ESCAPE));
    CHECK(!pane_key(&pane, UI_KEY_ESCAPE));
    CHECK(ui_focus_help(pane.ui));
    pane_end(&pane);
}

TEST(a_modal_pane_keeps_the_focus_and_the_mouse) {
    Pane pane = pane_begin(WIDTH, HEIGHT, 1, THEME_PAPER);
    pane_go(&pane, "plan", 0);
    pane.modal = true;
    pane_frame(&pane);
    pane_down(&pane, middle(pane.pause));
    pane_up(&pane, middle(pane.pause));
    CHECK(pane.pauses == 0);
    for (int i = 0; i < 5; i++) {
        pane_key(&pane, i % 2 ? UI_KEY_NEXT : UI_KEY_PANE);
        CHECK_TEXT(ui_focus_pane(pane.ui), "dialog");
    }
    pane_go(&pane, "dialog", 0);
    CHECK(pane_key(&pane, UI_KEY_ENTER));
    CHECK(pane.saves == 1);
    CHECK(!pane_key(&pane, UI_KEY_ESCAPE));
    pane.modal = false;
    pane_frame(&pane);
    CHECK_TEXT(ui_focus_pane(pane.ui), "plan");
    pane_end(&pane);
}

static int frames_until_rest(Pane *pane) {
    int count = 0;
    while (ui_is_busy(pane->ui) && count < 100) {
        pane_frame(pane);
        count++;
    }
    return count;
}

TEST(a_window_at_rest_needs_no_frames) {
    Pane pane = pane_begin(WIDTH, HEIGHT, 1, THEME_PAPER);
    pane_frame(&pane);
    CHECK(frames_until_rest(&pane) < 5);
    ui_key(pane.ui, UI_KEY_NEXT, false, false);
    CHECK(ui_is_busy(pane.ui));
    CHECK(frames_until_rest(&pane) < 5);
    pane_move(&pane, middle(pane.pause));
    int frames = frames_until_rest(&pane);
    CHECK(frames > 25 && frames < 40); /* the help appears */
    uint64_t shown = picture_digest(&pane);
    CHECK(picture_digest(&pane) == shown);
    pane_move(&pane, vec2(pane.pause.high.x + 2, pane.pause.low.y));
    frames = frames_until_rest(&pane);
    CHECK(frames > 20 && frames < 40); /* and leaves time for the mouse to reach it */
    CHECK(picture_digest(&pane) != shown);
    pane.modal = true;
    pane_frame(&pane);
    CHECK(ui_is_busy(pane.ui)); /* the focus moves there */
    CHECK(frames_until_rest(&pane) < 5);
    pane_end(&pane);
}

static void bare_pane(Pane *pane, bool modal) {
    paint_gl_screen_begin(pane->screen, WIDTH, HEIGHT, (Colour){1, 1, 1});
    ui_begin(pane->ui, &pane->input);
    ui_pane_begin(pane->ui,
                  &(UiPane){.name = "words", .box = {{100, 100}, {400, 300}}, .scrolls = true, .modal = modal});
    for (int i = 0; i < 30; i++)
        ui_line(pane->ui, UI_BODY, ROLE_TEXT, "One of many lines of words");
    ui_pane_end(pane->ui);
    ui_end(pane->ui);
}

TEST(words_that_do_not_fit_are_scrolled_by_keys) {
    for (int modal = 0; modal < 2; modal++) {
        Pane pane = pane_begin(WIDTH, HEIGHT, 1, THEME_PAPER);
        bare_pane(&pane, modal);
        ui_key(pane.ui, UI_KEY_NEXT, false, false);
        bare_pane(&pane, modal);
        CHECK_TEXT(ui_focus_pane(pane.ui), "words");
        CHECK(ui_focus_is_pane(pane.ui));
        paint_gl_screen_read(pane.screen, pane.pixels);
        uint64_t before = digest_bytes(DIGEST_START, pane.pixels, 4 * WIDTH * HEIGHT);
        CHECK(ui_key(pane.ui, UI_KEY_PAGE_DOWN, false, false));
        CHECK(!ui_key(pane.ui, UI_KEY_SPACE, false, false));
        bare_pane(&pane, modal);
        bare_pane(&pane, modal);
        paint_gl_screen_read(pane.screen, pane.pixels);
        CHECK(digest_bytes(DIGEST_START, pane.pixels, 4 * WIDTH * HEIGHT) != before);
        ui_key(pane.ui, UI_KEY_HOME, false, false);
        bare_pane(&pane, modal);
        bare_pane(&pane, modal);
        paint_gl_screen_read(pane.screen, pane.pixels);
        CHECK(digest_bytes(DIGEST_START, pane.pixels, 4 * WIDTH * HEIGHT) == before);
        pane_end(&pane);
    }
}

/* Widgets by keys -------------------------------------------------------------------------------------------------- */

TEST(buttons_flags_choices_and_rows_have_keys) {
    Pane pane = pane_begin(WIDTH, HEIGHT, 1, THEME_PAPER);
    pane_frame(&pane);
    pane_go(&pane, "panel", KEEP);
    CHECK(pane_key(&pane, UI_KEY_ENTER) && pane_key(&pane, UI_KEY_SPACE));
    CHECK(pane.keeps == 2);
    pane_go(&pane, "panel", FLAG);
    CHECK(pane_key(&pane, UI_KEY_SPACE) && pane.flag);
    pane_go(&pane, "panel", CHOICE);
    CHECK(pane_key(&pane, UI_KEY_RIGHT) && pane.choice == 1);
    CHECK(pane_key(&pane, UI_KEY_END) && pane.choice == 2);
    CHECK(pane_key(&pane, UI_KEY_RIGHT) && pane.choice == 2);
    CHECK(pane_key(&pane, UI_KEY_HOME) && pane.choice == 0);
    pane_go(&pane, "panel", ROW_FIRST);
    CHECK(pane_key(&pane, UI_KEY_DOWN) && pane_key(&pane, UI_KEY_DOWN) && pane_key(&pane, UI_KEY_ENTER));
    CHECK(pane.rows == 10);
    pane_go(&pane, "plan", 0);
    CHECK(!pane_key(&pane, UI_KEY_ENTER) && !pane_key(&pane, UI_KEY_LEFT) && !pane_key(&pane, UI_KEY_PAGE_DOWN));
    pane_end(&pane);
}

TEST(keys_between_two_frames_are_all_used) {
    Pane pane = pane_begin(WIDTH, HEIGHT, 1, THEME_PAPER);
    pane_frame(&pane);
    pane_go(&pane, "panel", SLIDER);
    ui_key(pane.ui, UI_KEY_RIGHT, false, false);
    ui_key(pane.ui, UI_KEY_RIGHT, false, false);
    ui_key(pane.ui, UI_KEY_NEXT, false, false);
    ui_key(pane.ui, UI_KEY_NEXT, false, false);
    ui_key(pane.ui, UI_KEY_RIGHT, false, false);
    pane_frame(&pane);
    CHECK_NEAR(pane.width.value, 0.9, 1e-12);
    CHECK(pane.choice == 1);
    ui_key(pane.ui, UI_KEY_PREVIOUS, false, false);
    ui_key(pane.ui, UI_KEY_PREVIOUS, false, false);
    ui_key(pane.ui, UI_KEY_ENTER, false, false);
    ui_type(pane.ui, "1");
    ui_type(pane.ui, "3");
    ui_key(pane.ui, UI_KEY_BACKSPACE, false, false);
    ui_type(pane.ui, ".2");
    ui_key(pane.ui, UI_KEY_ENTER, false, false);
    CHECK(!ui_types(pane.ui));
    CHECK(!ui_key(pane.ui, UI_KEY_SPACE, false, false));
    pane_frame(&pane);
    CHECK_NEAR(pane.width.value, 1.2, 1e-12);
    pane_end(&pane);
}

TEST(a_slider_goes_by_twentieths_hundredths_and_tenths) {
    Pane pane = pane_begin(WIDTH, HEIGHT, 1, THEME_PAPER);
    pane_frame(&pane);
    pane_go(&pane, "panel", SLIDER);
    CHECK(pane_key(&pane, UI_KEY_RIGHT) && pane.width_change == UI_CHANGED);
    CHECK_NEAR(pane.width.value, 0.85, 1e-12);
    pane_key(&pane, UI_KEY_PAGE_UP);
    CHECK_NEAR(pane.width.value, 0.95, 1e-12);
    ui_key(pane.ui, UI_KEY_DOWN, true, false);
    pane_frame(&pane);
    CHECK_NEAR(pane.width.value, 0.94, 1e-12);
    pane_key(&pane, UI_KEY_END);
    CHECK_NEAR(pane.width.value, 1.6, 0);
    pane_key(&pane, UI_KEY_RIGHT);
    CHECK_NEAR(pane.width.value, 1.6, 0);
    pane_key(&pane, UI_KEY_HOME);
    CHECK_NEAR(pane.width.value, 0.6, 0);
    pane_key(&pane, UI_KEY_DELETE);
    CHECK_NEAR(pane.width.value, 0.8, 0);
    pane_go(&pane, "panel", DAMPING);
    pane_key(&pane, UI_KEY_HOME);
    pane_key(&pane, UI_KEY_RIGHT);
    CHECK_NEAR(pane.damping.value, 2, 0); /* a twentieth of it is less than the next integer */
    CHECK(!pane_key(&pane, UI_KEY_SPACE));
    pane_end(&pane);
}

TEST(a_slider_is_dragged_and_says_when_the_hand_leaves) {
    Pane pane = pane_begin(WIDTH, HEIGHT, 1, THEME_PAPER);
    pane_frame(&pane);
    double left = pane.page.x - 344 + 16 + 6, width = 312 - 12, y = 112;
    pane_down(&pane, vec2(left + width / 2, y));
    CHECK(pane.width_change == UI_MOVING);
    CHECK_NEAR(pane.width.value, 1.1, 1e-12);
    pane_move(&pane, vec2(left + width * 0.75, y + 300));
    CHECK_NEAR(pane.width.value, 1.35, 1e-12);
    pane_move(&pane, vec2(0, y));
    CHECK_NEAR(pane.width.value, 0.6, 0);
    CHECK(pane.width_change == UI_MOVING);
    pane_up(&pane, vec2(left + width / 2, y));
    CHECK(pane.width_change == UI_CHANGED);
    CHECK_NEAR(pane.width.value, 1.1, 1e-12);
    pane_down(&pane, vec2(left + 9, y));
    pane_up(&pane, vec2(left + 9, y));
    pane_down(&pane, vec2(left + 9, y));
    CHECK_NEAR(pane.width.value, 0.8, 0);
    pane_end(&pane);
}

/* Typing ----------------------------------------------------------------------------------------------------------- */

TEST(a_typed_value_counts_when_it_is_of_the_range) {
    Pane pane = pane_begin(WIDTH, HEIGHT, 1, THEME_PAPER);
    pane_frame(&pane);
    pane_go(&pane, "panel", SLIDER);
    CHECK(pane_key(&pane, UI_KEY_ENTER) && ui_types(pane.ui));
    pane_type(&pane, "95 cm");
    CHECK_NEAR(pane.width.value, 0.95, 1e-12);
    CHECK(pane.width_change == UI_CHANGED && !ui_types(pane.ui));
    pane.width.value = 0.8123;
    pane_frame(&pane);
    pane_key(&pane, UI_KEY_ENTER);
    pane_key(&pane, UI_KEY_ENTER);
    CHECK_NEAR(pane.width.value, 0.8123, 0); /* viewed, not changed */
    pane_key(&pane, UI_KEY_ENTER);
    ui_type(pane.ui, "2");
    pane_key(&pane, UI_KEY_NEXT);
    CHECK_NEAR(pane.width.value, 2, 0); /* beyond the track, within the valid range */
    pane_end(&pane);
}

TEST(what_cannot_be_used_stays_typed_until_it_is_corrected_or_escaped) {
    static const char *const words[] = {"abc", "9999", "-1", " ", "1e400", "1\n2\n3", "5 kg", "\xFF\xC0"};
    Pane pane = pane_begin(WIDTH, HEIGHT, 1, THEME_PAPER);
    pane_frame(&pane);
    pane_go(&pane, "panel", SLIDER);
    uint64_t before = picture_digest(&pane);
    for (size_t i = 0; i < sizeof words / sizeof *words; i++) {
        pane_key(&pane, UI_KEY_ENTER);
        pane_key(&pane, UI_KEY_DELETE);
        snprintf(pane.clipboard, PANE_CLIPBOARD, "%s", words[i]);
        CHECK(pane_key(&pane, UI_KEY_PASTE));
        pane_key(&pane, UI_KEY_ENTER);
        CHECK(ui_types(pane.ui));
        pane_key(&pane, UI_KEY_NEXT);
        CHECK(!ui_types(pane.ui));
        pane_key(&pane, UI_KEY_PREVIOUS);
        ui_key(pane.ui, UI_KEY_SPACE, false, false);
        CHECK(picture_digest(&pane) != before);
        CHECK_NEAR(pane.width.value, 0.8, 0);
        CHECK(pane_key(&pane, UI_KEY_ESCAPE));
        pane_go(&pane, "panel", SLIDER);
        CHECK(picture_digest(&pane) == before);
    }
    pane_key(&pane, UI_KEY_ENTER);
    pane_type(&pane, "9999");
    pane_key(&pane, UI_KEY_SELECT_ALL);
    pane_type(&pane, "0,7");
    CHECK_NEAR(pane.width.value, 0.7, 1e-12);
    pane_end(&pane);
}

TEST(a_field_is_typed_into_as_soon_as_it_has_the_focus) {
    Pane pane = pane_begin(WIDTH, HEIGHT, 1, THEME_PAPER);
    pane_frame(&pane);
    pane_go(&pane, "panel", FIELD);
    CHECK(ui_types(pane.ui));
    ui_type(pane.ui, "Küche");
    pane_frame(&pane);
    CHECK_TEXT(pane.name, "Küche");
    ui_key(pane.ui, UI_KEY_LEFT, true, false);
    ui_key(pane.ui, UI_KEY_LEFT, true, false);
    ui_key(pane.ui, UI_KEY_CUT, false, true);
    ui_key(pane.ui, UI_KEY_HOME, false, false);
    ui_key(pane.ui, UI_KEY_PASTE, false, true);
    pane_frame(&pane);
    CHECK_TEXT(pane.name, "heKüc");
    CHECK(pane_key(&pane, UI_KEY_SPACE)); /* playback keys are off while a person types */
    CHECK(pane_key(&pane, UI_KEY_ESCAPE));
    CHECK_TEXT(pane.name, "L corridor");
    CHECK(!ui_types(pane.ui) && !pane.entered);
    pane_key(&pane, UI_KEY_ENTER);
    pane_type(&pane, "漢字 and more than there is room for in 32 bytes");
    CHECK(pane.entered);
    CHECK_TEXT(pane.name, "漢字 and more than there is r");
    pane_end(&pane);
}

TEST(a_field_is_opened_by_the_mouse_and_left_by_it) {
    Pane pane = pane_begin(WIDTH, 1000, 1, THEME_PAPER);
    pane_go(&pane, "plan", 0);
    Vec2 value = {pane.page.x - 20, 88};
    pane_down(&pane, value);
    pane_up(&pane, value);
    CHECK(ui_types(pane.ui));
    CHECK_TEXT(ui_focus_pane(pane.ui), "plan");
    ui_type(pane.ui, "1.5");
    pane_down(&pane, middle(pane.canvas));
    pane_up(&pane, middle(pane.canvas));
    CHECK(!ui_types(pane.ui));
    CHECK_NEAR(pane.width.value, 1.5, 1e-12);
    pane_end(&pane);
}

/* Letters ---------------------------------------------------------------------------------------------------------- */

/* Rows of dark pixels, with one byte in four or one byte per pixel. */
static int dark_rows(const unsigned char *pixels, int width, int height, int stride, int bytes, int least, int most) {
    int first = -1, last = -1;
    for (int y = 0; y < height; y++)
        for (int x = 0; x < width; x++) {
            int value = pixels[y * stride + x * bytes];
            if (value < least || value > most)
                continue;
            first = first < 0 ? y : first;
            last = y;
        }
    return first < 0 ? 0 : last - first + 1;
}

static int pango_height(double size, bool bold) {
    cairo_surface_t *surface = cairo_image_surface_create(CAIRO_FORMAT_A8, 400, 300);
    cairo_t *cairo = cairo_create(surface);
    text_show(cairo, "H", size, bold, vec2(200, 150));
    cairo_destroy(cairo);
    cairo_surface_flush(surface);
    int rows = dark_rows(cairo_image_surface_get_data(surface), 400, 300, cairo_image_surface_get_stride(surface), 1,
                         100, 255);
    cairo_surface_destroy(surface);
    return rows;
}

TEST(letters_are_as_high_as_those_of_pictures) {
    static const double sizes[UI_TEXT_STYLES] = {16, 16, 16, 18, 24, 20, 40};
    for (double text = 1; text <= 3; text += 0.5) {
        Pane pane = pane_begin(WIDTH, HEIGHT, text, THEME_PAPER);
        for (UiTextStyle letters = UI_BODY; letters < UI_TEXT_STYLES; letters++) {
            paint_gl_screen_begin(pane.screen, WIDTH, HEIGHT, (Colour){1, 1, 1});
            ui_begin(pane.ui, &pane.input);
            ui_draw_text(pane.ui, letters, ROLE_TEXT, vec2(100, 100), 0.5, "H");
            ui_end(pane.ui);
            paint_gl_screen_read(pane.screen, pane.pixels);
            bool bold = letters == UI_BOLD || letters == UI_HEADING || letters == UI_CLOCK || letters == UI_ANSWER;
            CHECK_NEAR(dark_rows(pane.pixels, WIDTH, HEIGHT, 4 * WIDTH, 4, 0, 155),
                       pango_height(sizes[letters] * text, bold), 1);
        }
        pane_end(&pane);
    }
}

/* Anything --------------------------------------------------------------------------------------------------------- */

TEST(a_thousand_frames_of_anything_are_survived) {
    static const char *const words[] = {"0.7", "9", "-", "漢", "\xC3", " m", "e", "abc def", ",", "\n"};
    Pane pane = pane_begin(640, 480, 1.5, THEME_BOARD);
    unsigned long state = 1;
    for (int i = 0; i < 1000; i++) {
        for (int k = 0; k < 4; k++) {
            state = state * 6364136223846793005u + 1442695040888963407u;
            unsigned what = (unsigned)(state >> 33);
            if (what % 3 == 0)
                ui_type(pane.ui, words[what / 3 % 10]);
            else
                ui_key(pane.ui, what / 3 % UI_KEYS, what / 128 % 4 == 0, what / 1024 % 4 == 0);
            pane.input.down[k % 3] = what / 4096 % 3 == 0;
            if (what / 8192 % 3 == 0)
                pane.input.mouse = vec2(what / 16384 % 660 - 10.0, what / 3 % 500 - 10.0);
            pane.input.wheel = what / 4 % 16 == 0 ? (int)(what / 64 % 7) - 3 : 0;
        }
        pane.modal = i / 50 % 4 == 3;
        pane.short_panel = i / 30 % 3 == 2;
        pane.input.unit = i / 100 % 2 ? 1.5 : 2.25;
        pane.page = vec2(640 / pane.input.unit, 480 / pane.input.unit);
        pane_frame(&pane);
        CHECK(pane.width.value >= 0.5 && pane.width.value <= 2);
        CHECK(pane.damping.value >= 0 && pane.damping.value <= 1e5);
        CHECK(pane.choice < 3 && strlen(pane.name) < sizeof pane.name);
    }
    pane_end(&pane);
}
