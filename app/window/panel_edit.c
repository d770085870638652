#include "window/panel_edit.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/quantity.h"
#include "window/act.h"
#include "window/notice.h"
#include "window/plan_input.h"

/* Design points. */
#define CARD_SCALE 36.0 /* a metre */
#define CARD_HEIGHT 72.0

enum { CARD_COLUMNS = 2 };
enum { SCALE_MOST = 64 /* bytes of a typed length */ };

/* Catalogue -------------------------------------------------------------------------------------------------------- */

/* Shows pieces of furniture as cards, drawn to one scale, their backs thick. True if one was chosen. */
static bool show_card(Window *window, Editor *editor, const CatalogueRow *item, size_t index, bool chosen) {
    Vec2 half = vec2_scale(item->size, CARD_SCALE / 2);
    const Vec2 shape[] = {{-half.x, -half.y}, {half.x, -half.y}, {half.x, half.y}, {-half.x, half.y}};
    UiCard card = {.id = text_in_arena(&window->arena, "item %zu", index),
                   .name = item->name,
                   .picture_height = CARD_HEIGHT,
                   .shape = shape,
                   .shape_count = item->size.x > 0 ? sizeof shape / sizeof *shape : 0,
                   .help = text_in_arena(&window->arena, "%s: %s", item->name, item->detail),
                   .chosen = chosen};
    if (!ui_card(window->ui, &card))
        return false;
    editor_choose_item(editor, index);
    ui_focus(window->ui, "view");
    window->dirty = true;
    return true;
}

static void show_cards(Window *window, Editor *editor) {
    size_t count, chosen = editor_item(editor), column = 0;
    const CatalogueRow *items = editor_items(editor, &count);
    const char *group = "";
    ui_text(window->ui, UI_SMALL, ROLE_DIM_TEXT, chosen < count ? items[chosen].detail : "");
    for (size_t n = 1; n <= count; n++, column++) { /* the first one, of a free size, comes last */
        size_t i = n % count;
        if (strcmp(group, items[i].group) != 0) {
            ui_row(window->ui, 1);
            ui_heading(window->ui, *items[i].group ? items[i].group : "Any size");
            column = 0;
        }
        group = items[i].group;
        if (column % CARD_COLUMNS == 0)
            ui_row(window->ui, CARD_COLUMNS);
        if (show_card(window, editor, &items[i], i, i == chosen))
            return;
    }
    ui_row(window->ui, 1);
}

static void show_items(Window *window, Editor *editor) {
    size_t count, chosen = editor_item(editor);
    const CatalogueRow *items = editor_items(editor, &count);
    const char *group = "";
    for (size_t i = 0; i < count; i++) {
        if (strcmp(group, items[i].group) != 0)
            ui_heading(window->ui, items[i].group);
        group = items[i].group;
        UiRow row = {.id = text_in_arena(&window->arena, "item %zu", i),
                     .shape = ROW_PLAIN,
                     .cells = {items[i].name},
                     .help = text_in_arena(&window->arena, "%s: %s", items[i].name, items[i].detail),
                     .selected = i == chosen,
                     .usable = true};
        if (ui_list_row(window->ui, &row)) {
            editor_choose_item(editor, i);
            ui_focus(window->ui, "view");
            window->dirty = true;
            return;
        }
        if (i == chosen)
            ui_text(window->ui, UI_SMALL, ROLE_DIM_TEXT, items[i].detail);
    }
}

/* Headings ----------------------------------------------------------------------------------------------------------
 */

void panel_edit_heading(Window *window, const char *text) {
    for (size_t i = 0; i < window->heading_count; i++)
        if (strcmp(window->headings[i], text) == 0)
            return;
    if (window->heading_count < HEADINGS_MOST)
        snprintf(window->headings[window->heading_count++], sizeof window->headings[0], "%s", text);
    ui_heading(window->ui, text);
}

/* Texts of the selection ------------------------------------------------------------------------------------------- */

/* Shows a text field; true if the text was changed, which may change the list of texts. */
static bool show_text(Window *window, Editor *editor, const EditText *text) {
    RefusedText *refused = &window->refused_text;
    bool kept = strcmp(refused->name, text->name) == 0;
    char typed[EDITOR_TEXT_MOST];
    Fault fault = {0};
    snprintf(typed, sizeof typed, "%s", kept ? refused->typed : text->value);
    const char *help = text_in_arena(&window->arena, "%s: %s Return applies it", text->label, text->help);
    const char *name = text_in_arena(&window->arena, "%s", text->name);
    const char *label = kept ? text_in_arena(&window->arena, "%s \u00b7 not applied", text->label) : text->label;
    if (!ui_field(window->ui, name, label, help, typed, sizeof typed))
        return false;
    *refused->name = 0;
    if (strcmp(typed, text->value) == 0)
        return false;
    if (!editor_set_text(editor, name, typed, &fault)) {
        snprintf(refused->name, sizeof refused->name, "%s", name);
        snprintf(refused->typed, sizeof refused->typed, "%s", typed);
        refused->tab = window_tab(window);
        refused->edits = editor_edit_count(editor);
    }
    notice_fault(window, &fault, NAN);
    return true;
}

/* Forgets what was refused once another thing is selected or changed. */
static void forget_refused(Window *window, Editor *editor, const EditText *texts, size_t count) {
    RefusedText *refused = &window->refused_text;
    bool listed = false;
    for (size_t i = 0; i < count; i++)
        listed |= strcmp(texts[i].name, refused->name) == 0;
    if (!listed || refused->tab != window_tab(window) || refused->edits != editor_edit_count(editor))
        *refused->name = 0;
}

/* Shows the texts of the house itself, or all others. */
static void show_texts(Window *window, Editor *editor, bool of_house) {
    static const char house[] = "house.";
    size_t count;
    const EditText *texts = editor_texts(editor, &count);
    const char *group = "";
    forget_refused(window, editor, texts, count);
    for (size_t i = 0; i < count; i++) {
        if ((strncmp(texts[i].name, house, sizeof house - 1) == 0) != of_house)
            continue;
        if (strcmp(group, texts[i].group) != 0)
            panel_edit_heading(window, texts[i].group);
        group = texts[i].group;
        if (show_text(window, editor, &texts[i]))
            return;
    }
}

/* The picture ------------------------------------------------------------------------------------------------------ */

/* Shows the path of the picture to trace and a slider for its opacity. */
static void show_image(Window *window, Editor *editor) {
    TraceImage image = editor_image(editor);
    char path[WINDOW_PATH];
    Fault fault = {0};
    ui_heading(window->ui, "Picture to trace");
    snprintf(path, sizeof path, "%s", image.path ? image.path : "");
    if (ui_field(window->ui, "image path", "PNG file",
                 "PNG file: Type its path; Return shows the picture, an empty path removes it", path, sizeof path)) {
        editor_set_image(editor, *path ? path : NULL, &fault);
        notice_fault(window, &fault, NAN);
        return;
    }
    if (!image.path)
        return;
    UiSlider slider = {.id = "image opacity",
                       .label = "opacity",
                       .unit = "%",
                       .help = "opacity: Opacity of the picture",
                       .value = 100 * image.opacity,
                       .initial = 50,
                       .high = 100,
                       .most = 100};
    if (ui_slider(window->ui, &slider) != UI_SAME)
        editor_fade_image(editor, slider.value / 100);
}

/* The scale -------------------------------------------------------------------------------------------------------- */

/* Offers to type the real length of the last measured distance, which scales the whole house. */
static void show_scale(Window *window, Editor *editor) {
    char typed[SCALE_MOST], reason[QUANTITY_REASON];
    double length, measured = editor_measured(editor);
    Fault fault = {0};
    if (!(measured > 0))
        return;
    ui_heading(window->ui, "Scale");
    snprintf(typed, sizeof typed, "%.3f m", measured);
    if (!ui_field(window->ui, "real length", "real length of the last measure",
                  "real length: Type what the measured distance really is; Return scales the whole house", typed,
                  sizeof typed))
        return;
    if (!quantity_read(typed, "m", &length, reason) || !(length > 0))
        fault_add(&fault, "%s: type a length above 0, such as 4.20 m", typed);
    else if (editor_set_measured(editor, length, &fault))
        notice_post(window, "%s", editor_undo_name(editor));
    notice_fault(window, &fault, NAN);
}

/* Proposals -------------------------------------------------------------------------------------------------------- */

/* Uses the proposal that is shown beside the plan, as one step. */
static void use_proposal(Window *window, Editor *editor, size_t chosen) {
    Fault fault = {0};
    editor_accept(editor, chosen, &fault);
    ui_focus(window->ui, "view"); /* the button is gone: Space must play */
    notice_fault(window, &fault, NAN);
}

/* Shows the proposals, the smallest change first; the chosen one is shown beside the plan. */
static void show_proposals(Window *window, Editor *editor) {
    size_t count, chosen;
    const char *doing = NULL;
    const Proposal *proposals = editor_proposals(editor, &count, &doing);
    editor_chosen_proposal(editor, &chosen);
    if (count)
        ui_text(window->ui, UI_BODY, ROLE_DIM_TEXT,
                text_in_arena(&window->arena, "%zu tried. The plan is unchanged until you use a fix.",
                              editor_proposal_tries(editor)));
    for (size_t i = 0; i < count; i++) {
        UiRow row = {.id = text_in_arena(&window->arena, "proposal %zu", i),
                     .mark = text_in_arena(&window->arena, "%zu", i + 1),
                     .role = ROLE_EXIT_TAG,
                     .shape = ROW_DISC,
                     .cells = {proposals[i].text, proposals[i].size},
                     .help = text_in_arena(&window->arena, "%s: Show it beside the plan", proposals[i].text),
                     .selected = i == chosen,
                     .usable = true};
        if (ui_list_row(window->ui, &row)) {
            editor_choose_proposal(editor, i);
            ui_focus(window->ui, "view");
            window->dirty = true;
            return;
        }
        ui_text(window->ui, UI_BODY, ROLE_EXIT_TAG, proposals[i].answer);
    }
    if (count) {
        ui_row(window->ui, 2);
        bool use = ui_button(window->ui, &(UiButton){.label = "Use it",
                                                     .chosen = true,
                                                     .help = "Use it (Return): Change the plan; Undo reverts it"});
        bool drop = ui_button(window->ui, &(UiButton){.label = "Not this one",
                                                      .help = "Not this one (Escape): Go back to the plan as it is"});
        ui_row(window->ui, 1);
        if (use)
            use_proposal(window, editor, chosen);
        else if (drop)
            editor_drop_proposals(editor);
    }
    if (doing)
        ui_text(window->ui, UI_BODY, ROLE_DIM_TEXT, doing);
    if (editor_seeks_proposals(editor) &&
        ui_button(window->ui, &(UiButton){.label = "Stop", .help = "Stop (Escape): End the search for a fix"}))
        editor_drop_proposals(editor);
}

static void show_way_out(Window *window, Tab *tab, Editor *editor) {
    size_t count;
    const char *doing = NULL;
    Result answer = tab->laboratory->answer(tab->session);
    bool asked = editor_proposals(editor, &count, &doing) && count > 0;
    if (asked) {
        ui_heading(window->ui, count > 1 ? "Fixes that work" : "A fix that works");
        show_proposals(window, editor);
        return;
    }
    if (answer.role != ROLE_ERROR && !asked && !doing)
        return;
    bool shows = tab_first_place(tab), asks = !doing && !answer.broken;
    if (shows && asks)
        ui_row(window->ui, 2);
    if (shows && ui_button(window->ui, &(UiButton){.id = "show", .label = "Show", .help = "Show: Zoom to the place"}))
        act_show_place(window);
    if (asks &&
        ui_button(window->ui, &(UiButton){.label = "Suggest a fix",
                                          .help = "Suggest a fix: Find the smallest change that lets all people "
                                                  "leave, by simulating wider doors and moved furniture"})) {
        editor_ask_proposals(editor);
        ui_focus(window->ui, "view"); /* Return uses a fix, Escape drops it */
    }
    ui_row(window->ui, 1);
    show_proposals(window, editor);
}

void panel_edit_show(Window *window) {
    Tab *tab = window_tab(window);
    Editor *editor = tab_editor(tab);
    if (!editor)
        return;
    if (editor_tool(editor) == TOOL_FURNITURE)
        show_cards(window, editor);
    else
        show_items(window, editor);
    if (editor_tool(editor) == TOOL_IMAGE || editor_image(editor).path)
        show_image(window, editor);
    if (editor_tool(editor) == TOOL_MEASURE)
        show_scale(window, editor);
}

void panel_edit_show_way_out(Window *window) {
    Tab *tab = window_tab(window);
    Editor *editor = tab_editor(tab);
    if (editor)
        show_way_out(window, tab, editor);
}

void panel_edit_show_texts(Window *window) {
    Tab *tab = window_tab(window);
    Editor *editor = tab_editor(tab);
    if (editor)
        show_texts(window, editor, false);
}

void panel_edit_show_house(Window *window) {
    Tab *tab = window_tab(window);
    Editor *editor = tab_editor(tab);
    if (editor)
        show_texts(window, editor, true);
}
