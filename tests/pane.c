#include "pane.h"

#include <stdio.h>
#include <string.h>

#include "base/memory.h"
#include "check.h"
#include "draw/layout.h"

static const char *clipboard_get(void *context) {
    return context;
}

static void clipboard_set(void *context, const char *text) {
    snprintf(context, DESK_CLIPBOARD, "%s", text);
}

static const UiSlider WIDTH = {.label = "Width",
                               .unit = "m",
                               .help = "Width\nHow far the door's jambs are apart.",
                               .value = 0.8,
                               .initial = 0.8,
                               .low = 0.6,
                               .high = 1.6,
                               .least = 0.5,
                               .most = 2,
                               .digits = 2};
static const UiSlider DAMPING = {.label = "Contact damping",
                                 .unit = "N s/m",
                                 .value = 300,
                                 .initial = 200,
                                 .low = 1,
                                 .high = 10000,
                                 .most = 1e5,
                                 .logarithmic = true,
                                 .whole = true};

Pane pane_begin(int width, int height, double text, Theme theme) {
    char message[OFFSCREEN_MESSAGE];
    Pane desk = {.offscreen = offscreen_create(OFFSCREEN_ANY, message), .width = WIDTH, .damping = DAMPING};
    if (!desk.offscreen)
        check_skip(message);
    desk.screen = paint_gl_screen_create(offscreen_gl(desk.offscreen));
    paint_gl_screen_leave_window(desk.screen);
    desk.clipboard = memory_allocate(DESK_CLIPBOARD, 1);
    desk.ui = ui_create(desk.screen, theme, (UiClipboard){clipboard_get, clipboard_set, desk.clipboard});
    double unit = text * layout_unit(width, height);
    desk.input = (UiInput){.width = width, .height = height, .unit = unit, .seconds = 1.0 / 60, .mouse = {-1, -1}};
    desk.page = vec2(width / unit, height / unit);
    desk.pixels = memory_allocate((size_t)width * (size_t)height, 4);
    snprintf(desk.name, sizeof desk.name, "L corridor");
    return desk;
}

void pane_end(Pane *desk) {
    ui_destroy(desk->ui);
    paint_gl_screen_destroy(desk->screen);
    offscreen_destroy(desk->offscreen);
    memory_free(desk->pixels);
    memory_free(desk->clipboard);
}

static bool button(Pane *desk, const char *label, bool chosen, bool disabled) {
    return ui_button(desk->ui, &(UiButton){.label = label,
                                           .chosen = chosen,
                                           .disabled = disabled,
                                           .help = "Name  K\nOne sentence about what it does."});
}

static void make_menu(Pane *desk) {
    static const char *const menus[] = {"File", "View", "Help"};
    ui_pane_begin(desk->ui, &(UiPane){.name = "menu", .box = {{0, 0}, {desk->page.x, 30}}, .ground = ROLE_SHADE});
    for (int i = 0; i < 3; i++) {
        ui_at(desk->ui, (Box){{60.0 * i, 0}, {60.0 * i + 60, 30}});
        ui_button(desk->ui, &(UiButton){.label = menus[i], .plain = true});
    }
    ui_pane_end(desk->ui);
}

static void make_plan(Pane *desk, double left, double right, double bottom) {
    Ui *ui = desk->ui;
    desk->canvas = (Box){{left, 30}, {right, bottom}};
    ui_pane_begin(ui, &(UiPane){.name = "plan", .box = desk->canvas, .ground = ROLE_PAPER, .stop = true});
    desk->grab = ui_grab(ui, "plan", desk->canvas);
    ui_draw_words(ui, UI_ANSWER, ROLE_TEXT, vec2(left + 18, 70), 0, "Out in 18.4 s");
    ui_draw_words(ui, UI_DETAIL, ROLE_TEXT, vec2(left + 18, 110), 0, "narrowest 0.06 m → ½ α Ж ✓");
    ui_draw_polyline(ui, (Vec2[]){{110, 200}, {200, 260}, {300, 180}}, 3, false, ROLE_LOCUS, 4);
    ui_draw_disc(ui, vec2(350, 200), 12, ROLE_IMPACT);
    ui_draw_diamond(ui, vec2(390, 200), 9, ROLE_TEXT);
    ui_pane_end(ui);
}

static void make_rail(Pane *desk, double bottom) {
    static const char *const tools[] = {"S\nselect", "W\nwall", "D\ndoor", "O\nobject", "M\nmeasure"};
    ui_pane_begin(desk->ui,
                  &(UiPane){.name = "rail", .box = {{0, 30}, {92, bottom}}, .ground = ROLE_SHADE, .scrolls = true});
    for (int i = 0; i < 5; i++)
        button(desk, tools[i], i == 2, false);
    ui_pane_end(desk->ui);
}

static void make_rows(Pane *desk) {
    Ui *ui = desk->ui;
    ui_heading(ui, "Dangerous points");
    desk->rows += ui_list_row(ui, &(UiRow){.mark = "1",
                                           .role = ROLE_DANGER_HIGH,
                                           .shape = ROW_DISC,
                                           .cells = {"door d2", "0.06 m", "410 N"},
                                           .usable = true,
                                           .selected = true});
    desk->rows += 10 * ui_list_row(ui, &(UiRow){.mark = "2",
                                                .role = ROLE_DANGER_MIDDLE,
                                                .shape = ROW_DISC,
                                                .cells = {"wardrobe", "0.11 m", "-2.9 s"},
                                                .usable = true});
    ui_list_row(
        ui,
        &(UiRow){.mark = "A", .role = ROLE_LOCUS, .shape = ROW_LINE, .cells = {"route A with a long name", "12.3 s"}});
    ui_list_row(
        ui,
        &(UiRow){.role = ROLE_GHOST, .shape = ROW_LINE, .style = LINE_DASHED, .cells = {"before", "14.0 s", "+1 s"}});
    ui_text(ui, UI_SMALL, ROLE_DIM_TEXT,
            "The smallest clearance on the way, and what it costs: seconds, or the force of a touch.");
}

static void make_panel(Pane *desk, double bottom) {
    static const char *const states[] = {"open", "closed", "locked"};
    Ui *ui = desk->ui;
    ui_pane_begin(ui, &(UiPane){.name = "panel",
                                .box = {{desk->page.x - 344, 30}, {desk->page.x, bottom}},
                                .ground = ROLE_PANEL,
                                .scrolls = true});
    ui_heading(ui, "Door d2");
    UiChange change = desk->short_panel ? UI_SAME : ui_slider(ui, &desk->width);
    desk->width_change = change > desk->width_change ? change : desk->width_change;
    ui_slider(ui, &desk->damping);
    ui_choice(ui, "state", "State", NULL, states, 3, &desk->choice);
    ui_flag(ui, NULL, "Lock the walls", "Lock the walls", &desk->flag);
    ui_row(ui, 3);
    desk->keeps += button(desk, "Keep", false, false);
    button(desk, "Clear", false, true);
    button(desk, "Export...", false, false);
    make_rows(desk);
    desk->entered |= ui_field(ui, "name", "Name of the house", NULL, desk->name, sizeof desk->name);
    ui_line(ui, UI_BODY, ROLE_ERROR, "One line that is far too long for the panel in which it stands");
    ui_pane_end(ui);
}

static void make_timeline(Pane *desk, double top) {
    Ui *ui = desk->ui;
    desk->pause = (Box){{8, top + 10}, {90, top + 50}};
    ui_pane_begin(ui, &(UiPane){.name = "timeline", .box = {{0, top}, desk->page}, .ground = ROLE_SHADE});
    ui_at(ui, desk->pause);
    desk->pauses += button(desk, "Pause", true, false);
    ui_draw_words(ui, UI_CLOCK, ROLE_TEXT, vec2(104, top + 30), 0, "7.32 s");
    ui_pane_end(ui);
}

static void make_dialog(Pane *desk) {
    Ui *ui = desk->ui;
    Vec2 middle = vec2_scale(desk->page, 0.5);
    ui_pane_begin(ui, &(UiPane){.name = "dialog",
                                .box = {{middle.x - 150, middle.y - 65}, {middle.x + 150, middle.y + 65}},
                                .ground = ROLE_PAPER,
                                .modal = true});
    ui_heading(ui, "Save before closing?");
    ui_text(ui, UI_BODY, ROLE_TEXT, "The house has been changed.");
    ui_row(ui, 2);
    desk->saves += button(desk, "Save", true, false);
    button(desk, "Do not save", false, false);
    ui_pane_end(ui);
}

void pane_frame(Pane *desk) {
    double bottom = desk->page.y - 62;
    paint_gl_screen_begin(desk->screen, desk->input.width, desk->input.height, (Colour){1, 1, 1});
    ui_begin(desk->ui, &desk->input);
    make_menu(desk);
    make_plan(desk, 92, desk->page.x - 344, bottom);
    make_rail(desk, bottom);
    make_panel(desk, bottom);
    make_timeline(desk, bottom);
    if (desk->modal)
        make_dialog(desk);
    ui_end(desk->ui);
    desk->input.wheel = 0;
}

void pane_picture(Pane *desk) {
    for (int i = 0; i < 3; i++) /* words that are seen for the first time, and what scrolls, are there then */
        pane_frame(desk);
    paint_gl_screen_read(desk->screen, desk->pixels);
}

void pane_move(Pane *desk, Vec2 to) {
    desk->input.mouse = vec2_scale(to, desk->input.unit);
    pane_frame(desk);
}

void pane_down(Pane *desk, Vec2 at) {
    pane_move(desk, at);
    desk->input.down[0] = true;
    pane_frame(desk);
}

void pane_up(Pane *desk, Vec2 at) {
    pane_move(desk, at);
    desk->input.down[0] = false;
    pane_frame(desk);
}

bool pane_key(Pane *desk, UiKey key) {
    bool used = ui_key(desk->ui, key, false, false);
    pane_frame(desk);
    return used;
}

void pane_type(Pane *desk, const char *words) {
    ui_type(desk->ui, words);
    pane_key(desk, UI_KEY_ENTER);
}

void pane_go(Pane *desk, const char *pane, int stops) {
    ui_focus(desk->ui, pane);
    for (int i = 0; i < stops; i++)
        ui_key(desk->ui, UI_KEY_NEXT, false, false);
    pane_frame(desk);
}
