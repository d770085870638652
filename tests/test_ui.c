#include "check.h"

#include <cairo.h>
#include <stdio.h>
#include <string.h>

#include "base/digest.h"
#include "base/memory.h"
#include "pane.h"
#include "draw/text.h"

enum { WIDTH = 1280, HEIGHT = 720 };

/* The stops of the panel. */
enum { SLIDER, DAMPING, CHOICE, FLAG, KEEP, EXPORT, ROW_FIRST, ROW_SECOND, FIELD };

static uint64_t picture_digest(Pane *desk) {
    pane_picture(desk);
    return digest_bytes(DIGEST_START, desk->pixels, (size_t)desk->input.width * (size_t)desk->input.height * 4);
}

static Vec2 middle(Box box) {
    return vec2_scale(vec2_add(box.low, box.high), 0.5);
}

/* The focus -------------------------------------------------------------------------------------------------------- */

static void check_round(double text, Theme theme) {
    Pane desk = pane_begin(WIDTH, HEIGHT, text, theme);
    uint64_t seen[DESK_STOPS];
    pane_frame(&desk);
    for (int i = 0; i < DESK_STOPS; i++)
        pane_key(&desk, UI_KEY_NEXT);
    for (int i = 0; i < DESK_STOPS; i++) {
        CHECK(pane_key(&desk, UI_KEY_NEXT));
        seen[i] = picture_digest(&desk);
        for (int k = 0; k < i; k++)
            CHECK(seen[k] != seen[i]); /* each stop has its frame, and it is seen */
    }
    for (int i = 0; i < DESK_STOPS; i++) {
        pane_key(&desk, UI_KEY_NEXT);
        CHECK(picture_digest(&desk) == seen[i]);
    }
    pane_end(&desk);
}

TEST(tab_comes_to_every_stop_once_and_goes_round) {
    check_round(1, THEME_PAPER);
    check_round(2, THEME_BOARD);
}

TEST(shift_tab_goes_back) {
    Pane desk = pane_begin(WIDTH, HEIGHT, 1, THEME_PAPER);
    pane_frame(&desk);
    pane_go(&desk, "panel", 2);
    uint64_t before = picture_digest(&desk);
    pane_key(&desk, UI_KEY_NEXT);
    pane_key(&desk, UI_KEY_PREVIOUS);
    ui_key(desk.ui, UI_KEY_ESCAPE, false, false); /* its help, which it has now by a key as before */
    pane_go(&desk, "panel", 2);
    CHECK(picture_digest(&desk) == before);
    pane_end(&desk);
}

TEST(f6_comes_to_every_pane) {
    static const char *const names[] = {"menu", "plan", "rail", "panel", "timeline"};
    Pane desk = pane_begin(WIDTH, HEIGHT, 1, THEME_PAPER);
    pane_frame(&desk);
    CHECK_TEXT(ui_focus_pane(desk.ui), "");
    for (int i = 0; i <= DESK_PANES; i++) {
        CHECK(pane_key(&desk, UI_KEY_PANE));
        CHECK_TEXT(ui_focus_pane(desk.ui), names[i % DESK_PANES]);
        CHECK(ui_focus_is_pane(desk.ui) == (i % DESK_PANES == 1));
    }
    for (int i = DESK_PANES; i-- > 0;) {
        pane_key(&desk, UI_KEY_PANE_BACK);
        CHECK_TEXT(ui_focus_pane(desk.ui), names[i]);
    }
    pane_end(&desk);
}

TEST(the_frame_of_the_focus_is_black_on_paper_and_white_on_the_board) {
    for (Theme theme = THEME_PAPER; theme < THEME_COUNT; theme++) {
        Pane desk = pane_begin(WIDTH, HEIGHT, 1, theme);
        unsigned char ink = theme == THEME_PAPER ? 0 : 255;
        pane_go(&desk, "plan", 0);
        pane_picture(&desk);
        for (int i = 0; i < 3; i++) { /* the plan's left edge, three pixels wide; then the rim */
            const unsigned char *pixel = desk.pixels + 4 * (400 * WIDTH + (int)desk.canvas.low.x + i);
            CHECK(pixel[0] == ink && pixel[1] == ink && pixel[2] == ink);
            CHECK(pixel[12] == 255 - ink || i == 2);
        }
        pane_end(&desk);
    }
}

TEST(a_stop_that_is_gone_leaves_the_focus_to_the_first_of_its_pane) {
    Pane desk = pane_begin(WIDTH, HEIGHT, 1, THEME_PAPER);
    pane_frame(&desk);
    pane_go(&desk, "panel", SLIDER);
    desk.short_panel = true;
    pane_frame(&desk);
    CHECK_TEXT(ui_focus_pane(desk.ui), "panel");
    int before = (int)desk.damping.value;
    CHECK(pane_key(&desk, UI_KEY_RIGHT));
    CHECK(desk.damping.value > before);
    pane_end(&desk);
}

/* The mouse -------------------------------------------------------------------------------------------------------- */

TEST(a_click_presses_once_and_leaves_the_focus) {
    Pane desk = pane_begin(WIDTH, HEIGHT, 1, THEME_PAPER);
    pane_go(&desk, "plan", 0);
    pane_down(&desk, middle(desk.pause));
    CHECK(ui_has_mouse(desk.ui));
    pane_frame(&desk);
    CHECK(desk.pauses == 0);
    pane_up(&desk, middle(desk.pause));
    pane_frame(&desk);
    CHECK(desk.pauses == 1);
    CHECK_TEXT(ui_focus_pane(desk.ui), "plan");
    CHECK(!pane_key(&desk, UI_KEY_SPACE));
    CHECK(desk.pauses == 1);
    pane_end(&desk);
}

TEST(a_press_that_goes_elsewhere_is_none) {
    Pane desk = pane_begin(WIDTH, HEIGHT, 1, THEME_PAPER);
    pane_frame(&desk);
    pane_down(&desk, middle(desk.pause));
    pane_up(&desk, middle(desk.canvas));
    pane_down(&desk, middle(desk.canvas));
    pane_up(&desk, middle(desk.pause));
    pane_frame(&desk);
    CHECK(desk.pauses == 0);
    CHECK(!desk.grab.held);
    pane_end(&desk);
}

TEST(a_canvas_is_held_outside_its_box_too) {
    Pane desk = pane_begin(WIDTH, HEIGHT, 2, THEME_PAPER);
    pane_frame(&desk);
    Vec2 at = middle(desk.canvas), outside = middle(desk.pause);
    pane_down(&desk, at);
    CHECK(desk.grab.pressed && desk.grab.held && !desk.grab.twice);
    CHECK_NEAR(desk.grab.at.x, at.x, 1e-9);
    CHECK(!ui_has_mouse(desk.ui));
    pane_move(&desk, outside);
    CHECK(desk.grab.held && !desk.grab.hovered && !desk.grab.pressed);
    CHECK_NEAR(desk.grab.delta.y, outside.y - at.y, 1e-9);
    pane_up(&desk, outside);
    CHECK(desk.grab.released && !desk.grab.held && desk.pauses == 0);
    pane_move(&desk, at);
    desk.input.wheel = -2;
    desk.input.down[1] = true;
    pane_frame(&desk);
    CHECK(desk.grab.wheel == -2 && desk.grab.right_pressed && !desk.grab.pressed);
    for (int i = 0; i < 30; i++) /* the first press of this test is half a second ago */
        pane_frame(&desk);
    pane_down(&desk, at);
    pane_up(&desk, at);
    pane_down(&desk, at);
    CHECK(desk.grab.twice);
    pane_end(&desk);
}

TEST(help_comes_after_half_a_second_of_hovering_and_goes_with_escape) {
    Pane desk = pane_begin(WIDTH, HEIGHT, 1, THEME_PAPER);
    pane_frame(&desk);
    pane_move(&desk, middle(desk.pause));
    uint64_t bare = picture_digest(&desk);
    CHECK(picture_digest(&desk) == bare);
    for (int i = 0; i < 40; i++)
        pane_frame(&desk);
    CHECK(picture_digest(&desk) != bare);
    CHECK(pane_key(&desk, UI_KEY_ESCAPE));
    CHECK(picture_digest(&desk) == bare);
    CHECK(!pane_key(&desk, UI_KEY_ESCAPE));
    pane_end(&desk);
}

TEST(help_comes_with_the_focus_of_a_key) {
    Pane desk = pane_begin(WIDTH, HEIGHT, 1, THEME_PAPER);
    pane_frame(&desk);
    CHECK(!ui_focus_help(desk.ui));
    pane_go(&desk, "rail", 0);
    pane_key(&desk, UI_KEY_NEXT);
    CHECK_TEXT(ui_focus_help(desk.ui), "Name  K\nOne sentence about what it does.");
    CHECK(pane_key(&desk, UI_KEY_ESCAPE));
    CHECK(!pane_key(&desk, UI_KEY_ESCAPE));
    CHECK(ui_focus_help(desk.ui));
    pane_end(&desk);
}

TEST(a_modal_pane_keeps_the_focus_and_the_mouse) {
    Pane desk = pane_begin(WIDTH, HEIGHT, 1, THEME_PAPER);
    pane_go(&desk, "plan", 0);
    desk.modal = true;
    pane_frame(&desk);
    pane_down(&desk, middle(desk.pause));
    pane_up(&desk, middle(desk.pause));
    CHECK(desk.pauses == 0 && ui_has_mouse(desk.ui));
    for (int i = 0; i < 5; i++) {
        pane_key(&desk, i % 2 ? UI_KEY_NEXT : UI_KEY_PANE);
        CHECK_TEXT(ui_focus_pane(desk.ui), "dialog");
    }
    pane_go(&desk, "dialog", 0);
    CHECK(pane_key(&desk, UI_KEY_ENTER));
    CHECK(desk.saves == 1);
    CHECK(!pane_key(&desk, UI_KEY_ESCAPE));
    desk.modal = false;
    pane_frame(&desk);
    CHECK_TEXT(ui_focus_pane(desk.ui), "plan");
    pane_end(&desk);
}

/* Widgets by keys -------------------------------------------------------------------------------------------------- */

TEST(buttons_flags_choices_and_rows_have_keys) {
    Pane desk = pane_begin(WIDTH, HEIGHT, 1, THEME_PAPER);
    pane_frame(&desk);
    pane_go(&desk, "panel", KEEP);
    CHECK(pane_key(&desk, UI_KEY_ENTER) && pane_key(&desk, UI_KEY_SPACE));
    CHECK(desk.keeps == 2);
    pane_go(&desk, "panel", FLAG);
    CHECK(pane_key(&desk, UI_KEY_SPACE) && desk.flag);
    pane_go(&desk, "panel", CHOICE);
    CHECK(pane_key(&desk, UI_KEY_RIGHT) && desk.choice == 1);
    CHECK(pane_key(&desk, UI_KEY_END) && desk.choice == 2);
    CHECK(pane_key(&desk, UI_KEY_RIGHT) && desk.choice == 2);
    CHECK(pane_key(&desk, UI_KEY_HOME) && desk.choice == 0);
    pane_go(&desk, "panel", ROW_FIRST);
    CHECK(pane_key(&desk, UI_KEY_DOWN) && pane_key(&desk, UI_KEY_DOWN) && pane_key(&desk, UI_KEY_ENTER));
    CHECK(desk.rows == 10);
    pane_go(&desk, "plan", 0);
    CHECK(!pane_key(&desk, UI_KEY_ENTER) && !pane_key(&desk, UI_KEY_LEFT) && !pane_key(&desk, UI_KEY_PAGE_DOWN));
    pane_end(&desk);
}

TEST(keys_between_two_frames_are_all_used) {
    Pane desk = pane_begin(WIDTH, HEIGHT, 1, THEME_PAPER);
    pane_frame(&desk);
    pane_go(&desk, "panel", SLIDER);
    ui_key(desk.ui, UI_KEY_RIGHT, false, false);
    ui_key(desk.ui, UI_KEY_RIGHT, false, false);
    ui_key(desk.ui, UI_KEY_NEXT, false, false);
    ui_key(desk.ui, UI_KEY_NEXT, false, false);
    ui_key(desk.ui, UI_KEY_RIGHT, false, false);
    pane_frame(&desk);
    CHECK_NEAR(desk.width.value, 0.9, 1e-12);
    CHECK(desk.choice == 1);
    ui_key(desk.ui, UI_KEY_PREVIOUS, false, false);
    ui_key(desk.ui, UI_KEY_PREVIOUS, false, false);
    ui_key(desk.ui, UI_KEY_ENTER, false, false);
    ui_type(desk.ui, "1");
    ui_type(desk.ui, "3");
    ui_key(desk.ui, UI_KEY_BACKSPACE, false, false);
    ui_type(desk.ui, ".2");
    ui_key(desk.ui, UI_KEY_ENTER, false, false);
    CHECK(!ui_types(desk.ui));
    CHECK(!ui_key(desk.ui, UI_KEY_SPACE, false, false));
    pane_frame(&desk);
    CHECK_NEAR(desk.width.value, 1.2, 1e-12);
    pane_end(&desk);
}

TEST(a_slider_goes_by_twentieths_hundredths_and_tenths) {
    Pane desk = pane_begin(WIDTH, HEIGHT, 1, THEME_PAPER);
    pane_frame(&desk);
    pane_go(&desk, "panel", SLIDER);
    CHECK(pane_key(&desk, UI_KEY_RIGHT) && desk.width_change == UI_CHANGED);
    CHECK_NEAR(desk.width.value, 0.85, 1e-12);
    pane_key(&desk, UI_KEY_PAGE_UP);
    CHECK_NEAR(desk.width.value, 0.95, 1e-12);
    ui_key(desk.ui, UI_KEY_DOWN, true, false);
    pane_frame(&desk);
    CHECK_NEAR(desk.width.value, 0.94, 1e-12);
    pane_key(&desk, UI_KEY_END);
    CHECK_NEAR(desk.width.value, 1.6, 0);
    pane_key(&desk, UI_KEY_RIGHT);
    CHECK_NEAR(desk.width.value, 1.6, 0);
    pane_key(&desk, UI_KEY_HOME);
    CHECK_NEAR(desk.width.value, 0.6, 0);
    pane_key(&desk, UI_KEY_DELETE);
    CHECK_NEAR(desk.width.value, 0.8, 0);
    pane_go(&desk, "panel", DAMPING);
    pane_key(&desk, UI_KEY_HOME);
    pane_key(&desk, UI_KEY_RIGHT);
    CHECK_NEAR(desk.damping.value, 2, 0); /* a twentieth of it is less than the next whole number */
    CHECK(!pane_key(&desk, UI_KEY_SPACE));
    pane_end(&desk);
}

TEST(a_slider_is_dragged_and_says_when_the_hand_leaves) {
    Pane desk = pane_begin(WIDTH, HEIGHT, 1, THEME_PAPER);
    pane_frame(&desk);
    double left = desk.page.x - 344 + 16 + 6, width = 312 - 12, y = 112;
    pane_down(&desk, vec2(left + width / 2, y));
    CHECK(desk.width_change == UI_MOVING);
    CHECK_NEAR(desk.width.value, 1.1, 1e-12);
    pane_move(&desk, vec2(left + width * 0.75, y + 300));
    CHECK_NEAR(desk.width.value, 1.35, 1e-12);
    pane_move(&desk, vec2(0, y));
    CHECK_NEAR(desk.width.value, 0.6, 0);
    CHECK(desk.width_change == UI_MOVING);
    pane_up(&desk, vec2(left + width / 2, y));
    CHECK(desk.width_change == UI_CHANGED);
    CHECK_NEAR(desk.width.value, 1.1, 1e-12);
    pane_down(&desk, vec2(left + 9, y));
    pane_up(&desk, vec2(left + 9, y));
    pane_down(&desk, vec2(left + 9, y));
    CHECK_NEAR(desk.width.value, 0.8, 0);
    pane_end(&desk);
}

/* Typing ----------------------------------------------------------------------------------------------------------- */

TEST(a_typed_value_counts_when_it_is_of_the_range) {
    Pane desk = pane_begin(WIDTH, HEIGHT, 1, THEME_PAPER);
    pane_frame(&desk);
    pane_go(&desk, "panel", SLIDER);
    CHECK(pane_key(&desk, UI_KEY_ENTER) && ui_types(desk.ui));
    pane_type(&desk, "95 cm");
    CHECK_NEAR(desk.width.value, 0.95, 1e-12);
    CHECK(desk.width_change == UI_CHANGED && !ui_types(desk.ui));
    desk.width.value = 0.8123;
    pane_frame(&desk);
    pane_key(&desk, UI_KEY_ENTER);
    pane_key(&desk, UI_KEY_ENTER);
    CHECK_NEAR(desk.width.value, 0.8123, 0); /* looked at, not changed */
    pane_key(&desk, UI_KEY_ENTER);
    ui_type(desk.ui, "2");
    pane_key(&desk, UI_KEY_NEXT);
    CHECK_NEAR(desk.width.value, 2, 0); /* beyond the track, within what may be typed */
    pane_end(&desk);
}

TEST(what_cannot_be_used_stays_typed_until_it_is_corrected_or_escaped) {
    static const char *const words[] = {"abc", "9999", "-1", " ", "1e400", "1\n2\n3", "5 kg", "\xFF\xC0"};
    Pane desk = pane_begin(WIDTH, HEIGHT, 1, THEME_PAPER);
    pane_frame(&desk);
    pane_go(&desk, "panel", SLIDER);
    uint64_t before = picture_digest(&desk);
    for (size_t i = 0; i < sizeof words / sizeof *words; i++) {
        pane_key(&desk, UI_KEY_ENTER);
        pane_key(&desk, UI_KEY_DELETE);
        snprintf(desk.clipboard, DESK_CLIPBOARD, "%s", words[i]);
        CHECK(pane_key(&desk, UI_KEY_PASTE));
        pane_key(&desk, UI_KEY_ENTER);
        CHECK(ui_types(desk.ui));
        pane_key(&desk, UI_KEY_NEXT);
        CHECK(!ui_types(desk.ui));
        pane_key(&desk, UI_KEY_PREVIOUS);
        ui_key(desk.ui, UI_KEY_SPACE, false, false);
        CHECK(picture_digest(&desk) != before);
        CHECK_NEAR(desk.width.value, 0.8, 0);
        CHECK(pane_key(&desk, UI_KEY_ESCAPE));
        pane_go(&desk, "panel", SLIDER);
        CHECK(picture_digest(&desk) == before);
    }
    pane_key(&desk, UI_KEY_ENTER);
    pane_type(&desk, "9999");
    pane_key(&desk, UI_KEY_SELECT_ALL);
    pane_type(&desk, "0,7");
    CHECK_NEAR(desk.width.value, 0.7, 1e-12);
    pane_end(&desk);
}

TEST(a_field_is_typed_into_as_soon_as_it_has_the_focus) {
    Pane desk = pane_begin(WIDTH, HEIGHT, 1, THEME_PAPER);
    pane_frame(&desk);
    pane_go(&desk, "panel", FIELD);
    CHECK(ui_types(desk.ui));
    ui_type(desk.ui, "Küche");
    pane_frame(&desk);
    CHECK_TEXT(desk.name, "Küche");
    ui_key(desk.ui, UI_KEY_LEFT, true, false);
    ui_key(desk.ui, UI_KEY_LEFT, true, false);
    ui_key(desk.ui, UI_KEY_CUT, false, true);
    ui_key(desk.ui, UI_KEY_HOME, false, false);
    ui_key(desk.ui, UI_KEY_PASTE, false, true);
    pane_frame(&desk);
    CHECK_TEXT(desk.name, "heKüc");
    CHECK(pane_key(&desk, UI_KEY_SPACE)); /* the window plays nothing while somebody types */
    CHECK(pane_key(&desk, UI_KEY_ESCAPE));
    CHECK_TEXT(desk.name, "L corridor");
    CHECK(!ui_types(desk.ui) && !desk.entered);
    pane_key(&desk, UI_KEY_ENTER);
    pane_type(&desk, "漢字 and more than there is room for in 32 bytes");
    CHECK(desk.entered);
    CHECK_TEXT(desk.name, "漢字 and more than there is r");
    pane_end(&desk);
}

TEST(a_field_is_opened_by_the_mouse_and_left_by_it) {
    Pane desk = pane_begin(WIDTH, 1000, 1, THEME_PAPER);
    pane_go(&desk, "plan", 0);
    Vec2 value = {desk.page.x - 20, 88};
    pane_down(&desk, value);
    pane_up(&desk, value);
    CHECK(ui_types(desk.ui));
    CHECK_TEXT(ui_focus_pane(desk.ui), "plan");
    ui_type(desk.ui, "1.5");
    pane_down(&desk, middle(desk.canvas));
    pane_up(&desk, middle(desk.canvas));
    CHECK(!ui_types(desk.ui));
    CHECK_NEAR(desk.width.value, 1.5, 1e-12);
    pane_end(&desk);
}

/* Letters ---------------------------------------------------------------------------------------------------------- */

/* Rows of pixels of one byte in four, or of one, that are rather dark. */
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
    static const double sizes[UI_LETTERS] = {17, 15, 17, 19, 26, 22, 40};
    for (double text = 1; text <= 3; text += 0.5) {
        Pane desk = pane_begin(WIDTH, HEIGHT, text, THEME_PAPER);
        for (UiLetters letters = UI_BODY; letters < UI_LETTERS; letters++) {
            paint_gl_screen_begin(desk.screen, WIDTH, HEIGHT, (Colour){1, 1, 1});
            ui_begin(desk.ui, &desk.input);
            ui_draw_words(desk.ui, letters, ROLE_TEXT, vec2(100, 100), 0.5, "H");
            ui_end(desk.ui);
            paint_gl_screen_read(desk.screen, desk.pixels);
            bool bold = letters == UI_BOLD || letters == UI_HEADING || letters == UI_CLOCK || letters == UI_ANSWER;
            CHECK_NEAR(dark_rows(desk.pixels, WIDTH, HEIGHT, 4 * WIDTH, 4, 0, 155),
                       pango_height(sizes[letters] * text, bold), 1);
        }
        pane_end(&desk);
    }
}

TEST(no_label_is_cut) {
    static const char *const labels[] = {"Keep", "Clear", "Export...", "open", "closed", "locked"};
    for (int text = 1; text <= 3; text++) {
        Pane desk = pane_begin(WIDTH, HEIGHT, text, THEME_PAPER);
        pane_frame(&desk);
        for (int i = 0; i < 6; i++) { /* three side by side in the panel */
            CHECK(ui_extent(desk.ui, UI_BOLD, labels[i]).x < (312 - 2 * 8) / 3.0 - 8);
            CHECK(ui_extent(desk.ui, UI_BOLD, labels[i]).y < 24);
        }
        CHECK(ui_extent(desk.ui, UI_SMALL, "measure").x < 80);
        pane_end(&desk);
    }
}

TEST(letters_of_any_script_can_be_asked_for) {
    Pane desk = pane_begin(WIDTH, HEIGHT, 1, THEME_PAPER);
    pane_frame(&desk);
    ui_extent(desk.ui, UI_BODY, "żółć 漢字 \xF0\x9F\x98\x80 \xFF\xC3");
    pane_picture(&desk);
    CHECK(ui_extent(desk.ui, UI_BODY, "ż").x > 0);
    pane_end(&desk);
}

/* Anything --------------------------------------------------------------------------------------------------------- */

TEST(a_thousand_frames_of_anything_are_survived) {
    static const char *const words[] = {"0.7", "9", "-", "漢", "\xC3", " m", "e", "abc def", ",", "\n"};
    Pane desk = pane_begin(640, 480, 1.5, THEME_BOARD);
    unsigned long state = 1;
    for (int i = 0; i < 1000; i++) {
        for (int k = 0; k < 4; k++) {
            state = state * 6364136223846793005u + 1442695040888963407u;
            unsigned what = (unsigned)(state >> 33);
            if (what % 3 == 0)
                ui_type(desk.ui, words[what / 3 % 10]);
            else
                ui_key(desk.ui, what / 3 % UI_KEYS, what / 128 % 4 == 0, what / 1024 % 4 == 0);
            desk.input.down[k % 3] = what / 4096 % 3 == 0;
            if (what / 8192 % 3 == 0)
                desk.input.mouse = vec2(what / 16384 % 660 - 10.0, what / 3 % 500 - 10.0);
            desk.input.wheel = what / 4 % 16 == 0 ? (int)(what / 64 % 7) - 3 : 0;
        }
        desk.modal = i / 50 % 4 == 3;
        desk.short_panel = i / 30 % 3 == 2;
        desk.input.unit = i / 100 % 2 ? 1.5 : 2.25;
        desk.page = vec2(640 / desk.input.unit, 480 / desk.input.unit);
        pane_frame(&desk);
        CHECK(desk.width.value >= 0.5 && desk.width.value <= 2);
        CHECK(desk.damping.value >= 0 && desk.damping.value <= 1e5);
        CHECK(desk.choice < 3 && strlen(desk.name) < sizeof desk.name);
    }
    pane_end(&desk);
}
