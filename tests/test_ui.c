#include "check.h"

#include <stdio.h>
#include <string.h>

#include "base/memory.h"
#include "draw/layout.h"
#include "draw/offscreen.h"
#include "draw/png.h"
#include "window/ui.h"

typedef struct Desk {
    Offscreen *offscreen;
    PaintGlScreen *screen;
    Ui *ui;
    UiInput input;
    unsigned char *pixels;
    bool flag;
    size_t choice;
    UiSlider width, gap;
    char name[64];
    int pressed; /* of the buttons, how often */
    bool modal, tall;
    UiChange change;
} Desk;

static Desk desk_make(int width, int height, double text, Theme theme) {
    char message[OFFSCREEN_MESSAGE];
    Desk desk = {.offscreen = offscreen_create(OFFSCREEN_ANY, message)};
    if (!desk.offscreen)
        check_skip(message);
    desk.screen = paint_gl_screen_create(offscreen_gl(desk.offscreen));
    paint_gl_screen_leave_window(desk.screen);
    desk.ui = ui_create(desk.screen, theme, (UiClipboard){0});
    desk.input = (UiInput){.width = width,
                           .height = height,
                           .unit = text * layout_unit(width, height),
                           .seconds = 1.0 / 60,
                           .mouse = {-1, -1}};
    desk.pixels = memory_allocate((size_t)width * (size_t)height, 4);
    desk.width = (UiSlider){.label = "Width",
                            .unit = "m",
                            .help = "Width\nHow wide the door is between its jambs.",
                            .value = 0.9,
                            .initial = 0.8,
                            .low = 0.6,
                            .high = 1.5,
                            .least = 0.6,
                            .most = 1.5,
                            .digits = 2};
    desk.gap = (UiSlider){.label = "Contact damping",
                          .unit = "N s/m",
                          .value = 200,
                          .initial = 200,
                          .low = 1,
                          .high = 10000,
                          .least = 0,
                          .most = 1e6,
                          .logarithmic = true,
                          .digits = 0};
    snprintf(desk.name, sizeof desk.name, "L corridor");
    return desk;
}

static void desk_clear(Desk *desk) {
    ui_destroy(desk->ui);
    paint_gl_screen_destroy(desk->screen);
    offscreen_destroy(desk->offscreen);
    memory_free(desk->pixels);
}

static bool button(Desk *desk, const char *label, bool chosen, bool disabled) {
    bool used = ui_button(desk->ui, &(UiButton){.label = label,
                                                .chosen = chosen,
                                                .disabled = disabled,
                                                .help = "Name  K\nOne sentence about what it does."});
    desk->pressed += used;
    return used;
}

static void make_rail(Desk *desk, double high) {
    ui_pane_begin(desk->ui,
                  &(UiPane){.name = "rail", .box = {{0, 30}, {92, high - 62}}, .ground = ROLE_SHADE, .scrolls = true});
    static const char *const tools[] = {"S\nselect", "W\nwall", "D\ndoor", "O\nobject", "M\nmeasure"};
    for (int i = 0; i < 5; i++)
        button(desk, tools[i], i == 2, false);
    ui_pane_end(desk->ui);
}

static void make_panel(Desk *desk, double wide, double high) {
    Ui *ui = desk->ui;
    ui_pane_begin(
        ui, &(UiPane){
                .name = "panel", .box = {{wide - 344, 30}, {wide, high - 62}}, .ground = ROLE_PANEL, .scrolls = true});
    ui_heading(ui, "Door d2");
    desk->change = ui_slider(ui, &desk->width);
    ui_slider(ui, &desk->gap);
    static const char *const states[] = {"open", "closed", "locked"};
    ui_choice(ui, "state", "State", NULL, states, 3, &desk->choice);
    ui_flag(ui, NULL, "Lock the walls", "Lock the walls", &desk->flag);
    ui_row(ui, 3);
    button(desk, "Keep", false, false);
    button(desk, "Clear", false, true);
    button(desk, "Export...", false, false);
    ui_heading(ui, "Dangerous points");
    ui_list_row(ui, &(UiRow){.mark = "1",
                             .role = ROLE_DANGER_HIGH,
                             .shape = ROW_DISC,
                             .cells = {"door d2", "0.06 m", "410 N"},
                             .usable = true,
                             .selected = true});
    ui_list_row(ui, &(UiRow){.mark = "2",
                             .role = ROLE_DANGER_MIDDLE,
                             .shape = ROW_DISC,
                             .cells = {"wardrobe", "0.11 m", "-2.9 s"},
                             .usable = true});
    ui_list_row(
        ui,
        &(UiRow){.mark = "A", .role = ROLE_LOCUS, .shape = ROW_LINE, .cells = {"route A with a long name", "12.3 s"}});
    ui_list_row(ui,
                &(UiRow){.role = ROLE_GHOST, .shape = ROW_LINE, .style = LINE_DASHED, .cells = {"before", "14.0 s"}});
    ui_text(ui, UI_SMALL, ROLE_DIM_TEXT,
            "The number is the smallest clearance on the way, and what it costs: seconds, or the force of a touch.");
    ui_field(ui, "name", "Name of the house", NULL, desk->name, sizeof desk->name);
    ui_line(ui, UI_BODY, ROLE_ERROR, "One line that is far too long for the panel in which it stands");
    ui_pane_end(ui);
}

static void make_modal(Desk *desk, double wide, double high) {
    Ui *ui = desk->ui;
    ui_pane_begin(ui, &(UiPane){.name = "dialog",
                                .box = {{wide / 2 - 150, high / 2 - 80}, {wide / 2 + 150, high / 2 + 80}},
                                .ground = ROLE_PAPER,
                                .modal = true});
    ui_heading(ui, "Save before closing?");
    ui_text(ui, UI_BODY, ROLE_TEXT, "The house has been changed.");
    ui_row(ui, 2);
    button(desk, "Save", true, false);
    button(desk, "Do not save", false, false);
    ui_pane_end(ui);
}

static void desk_frame(Desk *desk) {
    Ui *ui = desk->ui;
    double wide = desk->input.width / desk->input.unit, high = desk->input.height / desk->input.unit;
    paint_gl_screen_begin(desk->screen, desk->input.width, desk->input.height, (Colour){1, 1, 1});
    ui_begin(ui, &desk->input);
    ui_pane_begin(ui, &(UiPane){.name = "menu", .box = {{0, 0}, {wide, 30}}, .ground = ROLE_SHADE});
    double x = 0;
    static const char *const menus[] = {"File", "View", "Help"};
    for (int i = 0; i < 3; i++, x += 60) {
        ui_at(ui, (Box){{x, 0}, {x + 60, 30}});
        ui_button(ui, &(UiButton){.label = menus[i], .plain = true});
    }
    ui_pane_end(ui);
    ui_pane_begin(
        ui, &(UiPane){.name = "plan", .box = {{92, 30}, {wide - 344, high - 62}}, .ground = ROLE_PAPER, .stop = true});
    ui_grab(ui, "plan", (Box){{92, 30}, {wide - 344, high - 62}});
    ui_draw_words(ui, UI_ANSWER, ROLE_TEXT, vec2(110, 70), 0, "Out in 18.4 s");
    ui_draw_words(ui, UI_DETAIL, ROLE_TEXT, vec2(110, 110), 0, "narrowest 0.06 m at door d2 → ½ α Ж ✓");
    ui_draw_polyline(ui, (Vec2[]){{110, 200}, {200, 260}, {300, 180}}, 3, false, ROLE_LOCUS, 4);
    ui_draw_disc(ui, vec2(350, 200), 12, ROLE_IMPACT);
    ui_draw_diamond(ui, vec2(390, 200), 9, ROLE_TEXT);
    ui_pane_end(ui);
    make_rail(desk, high);
    make_panel(desk, wide, high);
    ui_pane_begin(ui, &(UiPane){.name = "timeline", .box = {{0, high - 62}, {wide, high}}, .ground = ROLE_SHADE});
    ui_at(ui, (Box){{8, high - 52}, {90, high - 12}});
    button(desk, "Pause", true, false);
    ui_draw_words(ui, UI_CLOCK, ROLE_TEXT, vec2(104, high - 32), 0, "7.32 s");
    ui_pane_end(ui);
    if (desk->modal)
        make_modal(desk, wide, high);
    ui_end(ui);
}

static void show(Desk *desk, const char *name, int frames) {
    for (int i = 0; i < frames; i++)
        desk_frame(desk);
    paint_gl_screen_read(desk->screen, desk->pixels);
    char path[100];
    snprintf(path, sizeof path, "/tmp/ui-%s.png", name);
    png_write(path, desk->pixels, desk->input.width, desk->input.height);
}

TEST(a_sample_is_shown) {
    for (int theme = 0; theme < 2; theme++)
        for (int text = 1; text <= 2; text++) {
            Desk desk = desk_make(1280, 720, text, (Theme)theme);
            char name[40];
            snprintf(name, sizeof name, "%d-%d", theme, text);
            show(&desk, name, 3);
            for (int i = 0; i < 10; i++)
                ui_key(desk.ui, UI_KEY_NEXT, false, false);
            snprintf(name, sizeof name, "%d-%d-focus", theme, text);
            show(&desk, name, 3);
            ui_key(desk.ui, UI_KEY_ENTER, false, false);
            ui_type(desk.ui, "9999");
            ui_key(desk.ui, UI_KEY_ENTER, false, false);
            snprintf(name, sizeof name, "%d-%d-wrong", theme, text);
            show(&desk, name, 3);
            desk.modal = true;
            snprintf(name, sizeof name, "%d-%d-modal", theme, text);
            show(&desk, name, 3);
            desk_clear(&desk);
        }
}
