#include "pane.h"

#include <stdio.h>

#include "base/memory.h"
#include "check.h"
#include "draw/layout.h"

static const char *clipboard_get(void *context) {
    return context;
}

static void clipboard_set(void *context, const char *text) {
    snprintf(context, PANE_CLIPBOARD, "%s", text);
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
    Pane pane = {.offscreen = offscreen_create(OFFSCREEN_ANY, message), .width = WIDTH, .damping = DAMPING};
    if (!pane.offscreen)
        check_skip(message);
    pane.screen = paint_gl_screen_create(offscreen_gl(pane.offscreen));
    paint_gl_screen_leave_window(pane.screen);
    pane.clipboard = memory_zeroed(PANE_CLIPBOARD, 1);
    pane.ui = ui_create(pane.screen, theme, (UiClipboard){clipboard_get, clipboard_set, pane.clipboard});
    double unit = text * layout_unit(width, height);
    pane.input = (UiInput){.width = width, .height = height, .unit = unit, .seconds = 1.0 / 60, .mouse = {-1, -1}};
    pane.page = vec2(width / unit, height / unit);
    pane.pixels = memory_zeroed((size_t)width * (size_t)height, 4);
    snprintf(pane.name, sizeof pane.name, "L corridor");
    return pane;
}

void pane_end(Pane *pane) {
    ui_destroy(pane->ui);
    paint_gl_screen_destroy(pane->screen);
    offscreen_destroy(pane->offscreen);
    memory_free(pane->pixels);
    memory_free(pane->clipboard);
}

static bool button(Pane *pane, const char *label, bool chosen, bool disabled) {
    return ui_button(pane->ui, &(UiButton){.label = label,
                                           .chosen = chosen,
                                           .disabled = disabled,
                                           .help = "Name  K\nOne sentence about what it does."});
}

static void make_menu(Pane *pane) {
    static const char *const menus[] = {"File", "View", "Help"};
    ui_pane_begin(pane->ui, &(UiPane){.name = "menu", .box = {{0, 0}, {pane->page.x, 30}}, .ground = ROLE_SHADE});
    for (int i = 0; i < 3; i++) {
        ui_at(pane->ui, (Box){{60.0 * i, 0}, {60.0 * i + 60, 30}});
        ui_button(pane->ui, &(UiButton){.label = menus[i], .plain = true});
    }
    ui_pane_end(pane->ui);
}

static void make_plan(Pane *pane, double left, double right, double bottom) {
    Ui *ui = pane->ui;
    pane->canvas = (Box){{left, 30}, {right, bottom}};
    ui_pane_begin(ui, &(UiPane){.name = "plan", .box = pane->canvas, .ground = ROLE_PAPER, .stop = true});
    pane->grab = ui_grab(ui, "plan", pane->canvas);
    ui_draw_text(ui, UI_ANSWER, ROLE_TEXT, vec2(left + 18, 70), 0, "Out in 18.4 s");
    ui_draw_text(ui, UI_DETAIL, ROLE_TEXT, vec2(left + 18, 110), 0, "narrowest 0.06 m → ½ α Ж ✓");
    ui_draw_polyline(ui, (Vec2[]){{110, 200}, {200, 260}, {300, 180}}, 3, false, ROLE_LOCUS, 4);
    ui_draw_disc(ui, vec2(350, 200), 12, ROLE_IMPACT);
    ui_draw_diamond(ui, vec2(390, 200), 9, ROLE_TEXT);
    ui_pane_end(ui);
}

static void make_rail(Pane *pane, double bottom) {
    static const char *const tools[] = {"S\nselect", "W\nwall", "D\ndoor", "O\nobject", "M\nmeasure"};
    ui_pane_begin(pane->ui,
                  &(UiPane){.name = "rail", .box = {{0, 30}, {92, bottom}}, .ground = ROLE_SHADE, .scrolls = true});
    for (int i = 0; i < 5; i++)
        button(pane, tools[i], i == 2, false);
    ui_pane_end(pane->ui);
}

static void make_rows(Pane *pane) {
    Ui *ui = pane->ui;
    ui_heading(ui, "Dangerous points");
    pane->rows += ui_list_row(ui, &(UiRow){.mark = "1",
                                           .role = ROLE_DANGER_HIGH,
                                           .shape = ROW_DISC,
                                           .cells = {"door d2", "0.06 m", "410 N"},
                                           .usable = true,
                                           .selected = true});
    pane->rows += 10 * ui_list_row(ui, &(UiRow){.mark = "2",
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

static void make_panel(Pane *pane, double bottom) {
    static const char *const states[] = {"open", "closed", "locked"};
    Ui *ui = pane->ui;
    ui_pane_begin(ui, &(UiPane){.name = "panel",
                                .box = {{pane->page.x - 344, 30}, {pane->page.x, bottom}},
                                .ground = ROLE_PANEL,
                                .scrolls = true});
    ui_heading(ui, "Door d2");
    UiChange change = pane->short_panel ? UI_SAME : ui_slider(ui, &pane->width);
    pane->width_change = change > pane->width_change ? change : pane->width_change;
    ui_slider(ui, &pane->damping);
    ui_choice(ui, "state", "State", NULL, states, 3, &pane->choice);
    ui_flag(ui, NULL, "Lock the walls", "Lock the walls", &pane->flag);
    ui_row(ui, 3);
    pane->keeps += button(pane, "Keep", false, false);
    button(pane, "Clear", false, true);
    button(pane, "Export...", false, false);
    make_rows(pane);
    pane->entered |= ui_field(ui, "name", "Name of the house", NULL, pane->name, sizeof pane->name);
    ui_line(ui, UI_BODY, ROLE_ERROR, "One line that is far too long for the panel in which it stands");
    ui_pane_end(ui);
}

static void make_timeline(Pane *pane, double top) {
    Ui *ui = pane->ui;
    pane->pause = (Box){{8, top + 10}, {90, top + 50}};
    ui_pane_begin(ui, &(UiPane){.name = "timeline", .box = {{0, top}, pane->page}, .ground = ROLE_SHADE});
    ui_at(ui, pane->pause);
    pane->pauses += button(pane, "Pause", true, false);
    ui_draw_text(ui, UI_CLOCK, ROLE_TEXT, vec2(104, top + 30), 0, "7.32 s");
    ui_pane_end(ui);
}

static void make_dialog(Pane *pane) {
    Ui *ui = pane->ui;
    Vec2 middle = vec2_scale(pane->page, 0.5);
    ui_pane_begin(ui, &(UiPane){.name = "dialog",
                                .box = {{middle.x - 150, middle.y - 65}, {middle.x + 150, middle.y + 65}},
                                .ground = ROLE_PAPER,
                                .modal = true});
    ui_heading(ui, "Save before closing?");
    ui_text(ui, UI_BODY, ROLE_TEXT, "The house has been changed.");
    ui_row(ui, 2);
    pane->saves += button(pane, "Save", true, false);
    button(pane, "Do not save", false, false);
    ui_pane_end(ui);
}

void pane_frame(Pane *pane) {
    double bottom = pane->page.y - 62;
    paint_gl_screen_begin(pane->screen, pane->input.width, pane->input.height, (Colour){1, 1, 1});
    ui_begin(pane->ui, &pane->input);
    make_menu(pane);
    make_plan(pane, 92, pane->page.x - 344, bottom);
    make_rail(pane, bottom);
    if (!pane->no_panel)
        make_panel(pane, bottom);
    make_timeline(pane, bottom);
    if (pane->modal)
        make_dialog(pane);
    ui_end(pane->ui);
    pane->input.wheel = 0;
}

void pane_picture(Pane *pane) {
    for (int i = 0; i < 3; i++) /* words that are seen for the first time, and what scrolls, are there then */
        pane_frame(pane);
    paint_gl_screen_read(pane->screen, pane->pixels);
}

void pane_move(Pane *pane, Vec2 to) {
    pane->input.mouse = vec2_scale(to, pane->input.unit);
    pane_frame(pane);
}

void pane_down(Pane *pane, Vec2 at) {
    pane_move(pane, at);
    pane->input.down[0] = true;
    pane_frame(pane);
}

void pane_up(Pane *pane, Vec2 at) {
    pane_move(pane, at);
    pane->input.down[0] = false;
    pane_frame(pane);
}

bool pane_key(Pane *pane, UiKey key) {
    bool used = ui_key(pane->ui, key, false, false);
    pane_frame(pane);
    return used;
}

void pane_type(Pane *pane, const char *words) {
    ui_type(pane->ui, words);
    pane_key(pane, UI_KEY_ENTER);
}

void pane_go(Pane *pane, const char *name, int stops) {
    ui_focus(pane->ui, name);
    for (int i = 0; i < stops; i++)
        ui_key(pane->ui, UI_KEY_NEXT, false, false);
    pane_frame(pane);
}
