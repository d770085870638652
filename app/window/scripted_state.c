#include "window/scripted_state.h"

#include <math.h>
#include <stdio.h>

#include "draw/caption.h"
#include "window/dialog_gallery.h"
#include "window/lesson.h"
#include "window/menu.h"
#include "window/notice.h"
#include "window/plan_input.h"

static json_t *json_box(const Window *window, Box box) {
    double unit = window->unit;
    return json_pack("[f,f,f,f]", box.low.x * unit, box.low.y * unit, box.high.x * unit, box.high.y * unit);
}

/* Returns a JSON number, or null for NAN and infinity. */
static json_t *number_or_null(double value) {
    return isfinite(value) ? json_real(value) : json_null();
}

static json_t *text_or_null(const char *text) {
    return text ? json_string(text) : json_null();
}

static json_t *frame_state(const Window *window) {
    const Frame *frame = &window->frame;
    const PlotPanes *panes = &window->tabs[window->current].panes;
    json_t *state = json_object(), *plots = json_object();
    json_object_set_new(state, "menu", json_box(window, frame->menu));
    json_object_set_new(state, "answer", json_box(window, frame->answer));
    json_object_set_new(state, "view", json_box(window, frame->view));
    json_object_set_new(state, "card", json_box(window, frame->card));
    json_object_set_new(state, "rail", json_box(window, frame->toolbar));
    json_object_set_new(state, "panel", json_box(window, frame->panel));
    json_object_set_new(state, "handle", json_box(window, frame->handle));
    json_object_set_new(state, "timeline", json_box(window, frame->timeline));
    json_object_set_new(state, "strip", json_box(window, frame->strip));
    json_object_set_new(state, "tries", json_box(window, window->tries));
    for (size_t i = 0; i < frame->pane_count && i < panes->count; i++)
        json_object_set_new(plots, panes->panes[i].source.name, json_box(window, frame->panes[i]));
    json_object_set_new(state, "plots", plots);
    return state;
}

/* Returns the texts of a plot with their boxes, in pixels of the window. */
static json_t *plot_texts(const PlotPane *pane) {
    json_t *texts = json_array();
    const Layout *sheet = &plot_canvas_layout(pane->canvas)->sheet;
    for (size_t i = 0; i < sheet->caption_count; i++) {
        const Caption *caption = &sheet->captions[i];
        Vec2 half = vec2_scale(caption->turned ? vec2(caption->extent.y, caption->extent.x) : caption->extent, 0.5);
        Vec2 at = vec2_add(pane->place.low, caption->centre);
        json_array_append_new(texts, json_pack("{s:s,s:[f,f,f,f],s:f}", "string", caption->text, "box",
                                               pane->unit * (at.x - half.x), pane->unit * (at.y - half.y),
                                               pane->unit * (at.x + half.x), pane->unit * (at.y + half.y), "size",
                                               pane->unit * caption->size));
    }
    return texts;
}

/* Returns the labels that the ticks of an axis must have. */
static json_t *plot_ticks(const PlotTicks *ticks) {
    json_t *labels = json_array();
    for (int i = 0; i < ticks->count; i++) {
        char label[PLOT_TICKS_LABEL];
        plot_ticks_label(ticks, i, label);
        json_array_append_new(labels, json_string(label));
    }
    return labels;
}

/* Returns the axes, the cursor and the texts of each plot that is shown. */
static json_t *plot_panes_state(const PlotPanes *panes) {
    json_t *state = json_object();
    for (size_t i = 0; i < panes->count; i++) {
        const PlotPane *pane = &panes->panes[i];
        if (!pane->canvas)
            continue;
        PlotPaneAxes axes = plot_panes_axes(pane);
        json_t *one = json_pack("{s:[f,f],s:[f,f],s:i,s:i}", "x", axes.x[0], axes.x[1], "y", axes.y[0], axes.y[1],
                                "views", (int)pane->view_count, "corner", pane->box.corner);
        const PlotLayout *layout = plot_canvas_layout(pane->canvas);
        json_object_set_new(one, "texts", plot_texts(pane));
        json_object_set_new(one, "x_ticks", plot_ticks(&layout->x));
        json_object_set_new(one, "y_ticks", plot_ticks(&layout->y));
        json_object_set_new(one, "x_unit", text_or_null(pane->shown.x.unit));
        json_object_set_new(one, "x_title", text_or_null(pane->shown.x.title));
        json_object_set_new(one, "cursor", number_or_null(pane->source.cursor));
        if (pane->source.cursor_y_parameter)
            json_object_set_new(one, "cursor_y", number_or_null(pane->source.cursor_y));
        json_object_set_new(state, pane->source.name, one);
    }
    return state;
}

static json_t *parameters_state(const Tab *tab) {
    json_t *state = json_object();
    size_t count;
    const PanelParameter *parameters = tab->laboratory->parameters(tab->session, &count);
    for (size_t i = 0; i < count; i++)
        json_object_set_new(state, parameters[i].name, number_or_null(parameters[i].value));
    return state;
}

static json_t *choices_state(const Tab *tab) {
    json_t *state = json_object();
    size_t count;
    const PanelChoice *choices = tab->laboratory->choices(tab->session, &count);
    for (size_t i = 0; i < count; i++)
        json_object_set_new(state, choices[i].name, json_string(choices[i].options[choices[i].chosen]));
    return state;
}

/* Returns the rows of the panel, cell by cell. */
static json_t *rows_state(const Tab *tab) {
    size_t count;
    const PanelRow *rows = tab->laboratory->rows(tab->session, &count);
    json_t *state = json_array();
    for (size_t i = 0; i < count; i++) {
        json_t *cells = json_array();
        for (size_t c = 0; c < sizeof rows[i].row.cells / sizeof *rows[i].row.cells; c++)
            json_array_append_new(cells, json_string(rows[i].row.cells[c] ? rows[i].row.cells[c] : ""));
        json_array_append_new(state, cells);
    }
    return state;
}

static json_t *answer_state(const Tab *tab) {
    Result answer = tab->laboratory->answer(tab->session);
    bool working = tab->laboratory->runs && tab->laboratory->runs(tab->session).working;
    json_t *state =
        json_pack("{s:s,s:b,s:b}", "title", answer.title, "stale", answer.stale || working, "grey", answer.stale);
    json_object_set_new(state, "detail", answer.detail ? json_string(answer.detail) : json_null());
    json_object_set_new(state, "cure", answer.cure ? json_string(answer.cure) : json_null());
    json_object_set_new(state, "doing", answer.doing ? json_string(answer.doing) : json_null());
    json_object_set_new(state, "grading", json_boolean(answer.grading));
    json_object_set_new(state, "shaking", json_boolean(answer.shaking));
    return state;
}

/* Returns the identities of the runs that the parts of the window show. */
static json_t *runs_state(const Tab *tab) {
    if (!tab->laboratory->runs)
        return json_null();
    LaboratoryRuns runs = tab->laboratory->runs(tab->session);
    const struct {
        const char *name;
        uint64_t run;
    } parts[] = {{"answer", runs.answer}, {"picture", runs.picture}, {"rows", runs.rows}, {"plots", runs.plots}};
    json_t *state = json_object();
    for (size_t i = 0; i < sizeof parts / sizeof *parts; i++) {
        char text[32];
        snprintf(text, sizeof text, "%016llx", (unsigned long long)parts[i].run);
        json_object_set_new(state, parts[i].name, json_string(text));
    }
    json_object_set_new(state, "working", json_boolean(runs.working));
    return state;
}

static json_t *command_state(const Tab *tab) {
    size_t count;
    const char *const *words = tab->laboratory->command(tab->session, &count);
    char *command = export_command(words, count);
    json_t *state = json_string(command);
    memory_free(command);
    return state;
}

/* Returns the times of the exits that the timeline marks. */
static json_t *ticks_state(const Tab *tab) {
    json_t *ticks = json_array();
    size_t count;
    const TimelineMark *marks = tab->laboratory->marks(tab->session, &count);
    for (size_t i = 0; i < count; i++)
        if (marks[i].kind == TIMELINE_EXIT)
            json_array_append_new(ticks, json_real(marks[i].time));
    return ticks;
}

/* Returns the labels of all marks. */
static json_t *marks_state(const GestureView *gesture) {
    static const char *const kinds[] = {
        [MARK_OUTLINE] = "outline", [MARK_LINE] = "line",   [MARK_EXIT] = "exit",           [MARK_SWING] = "swing",
        [MARK_RING] = "ring",       [MARK_GUIDE] = "guide", [MARK_DIMENSION] = "dimension", [MARK_SNAP] = "snap",
        [MARK_START] = "start",     [MARK_PLACE] = "place", [MARK_HANDLE] = "handle",       [MARK_GAP] = "gap"};
    json_t *state = json_array();
    for (size_t i = 0; i < gesture->mark_count; i++) {
        const EditMark *mark = &gesture->marks[i];
        json_t *one = json_pack("{s:s,s:s*,s:b}", "kind", kinds[mark->kind], "words", mark->text, "held", mark->active);
        if (mark->count)
            json_object_set_new(one, "at", json_pack("[f,f]", mark->points[0].x, mark->points[0].y));
        json_array_append_new(state, one);
    }
    return state;
}

static json_t *gesture_state(const GestureView *gesture) {
    json_t *state = json_pack("{s:b,s:s,s:s*,s:s*,s:s*}", "active", gesture->active, "doing", gesture->doing, "refusal",
                              gesture->refusal, "typed", gesture->typed, "wrong", gesture->typed_error);
    json_t *fields = json_object();
    for (size_t i = 0; i < gesture->field_count; i++)
        json_object_set_new(fields, gesture->fields[i].name, number_or_null(gesture->fields[i].value));
    json_object_set_new(state, "fields", fields);
    if (gesture->field < gesture->field_count)
        json_object_set_new(state, "field", json_string(gesture->fields[gesture->field].name));
    json_object_set_new(state, "marks", marks_state(gesture));
    if (gesture->preview)
        json_object_set_new(state, "preview",
                            json_pack("{s:s,s:b,s:b}", "words", gesture->preview, "refused", gesture->preview_refused,
                                      "warns", gesture->preview_warns));
    return state;
}

static const char *key_of(const Tab *tab, Item item) {
    return tab->laboratory->item_key ? tab->laboratory->item_key(tab->session, item)
                                     : tab->laboratory->item_name(tab->session, item);
}

static json_t *selection_state(const Tab *tab, Editor *editor) {
    json_t *state = json_array();
    size_t count;
    const Item *items = editor_selection(editor, &count);
    for (size_t i = 0; i < count; i++)
        json_array_append_new(state, json_string(key_of(tab, items[i])));
    return state;
}

/* Returns the fix that is shown beside the plan; null: none. */
static json_t *split_state(const Window *window, const Tab *tab) {
    if (!tab->trial.session)
        return json_null();
    Result answer = tab->laboratory->answer(tab->trial.session);
    json_t *state =
        json_pack("{s:i,s:s,s:b}", "fix", (int)tab->trial.proposal, "title", answer.title, "stale", answer.stale);
    json_object_set_new(state, "beside", json_box(window, window->frame.beside));
    json_object_set_new(state, "time", json_real(trial_time(tab->laboratory, tab->trial.session, tab->player.time)));
    json_object_set_new(state, "end", json_real(tab->laboratory->span(tab->trial.session).end));
    return state;
}

static void add_editor(json_t *state, Window *window, const Tab *tab) {
    Editor *editor = tab_editor(tab);
    if (!editor)
        return;
    size_t count;
    const char *doing = NULL;
    json_object_set_new(state, "tool", json_string(editor_tool_row(editor_tool(editor))->name));
    json_object_set_new(state, "gesture", gesture_state(editor_gesture(editor)));
    json_object_set_new(state, "selection", selection_state(tab, editor));
    json_object_set_new(state, "undo_name", text_or_null(editor_undo_name(editor)));
    json_object_set_new(state, "redo_name", text_or_null(editor_redo_name(editor)));
    json_object_set_new(state, "edits", json_integer((json_int_t)editor_edit_count(editor)));
    json_object_set_new(state, "unsaved_edits", json_integer((json_int_t)tab_edit_count(tab)));
    json_object_set_new(state, "changed", json_boolean(editor_is_changed(editor)));
    json_object_set_new(state, "unsaved", json_boolean(tab_unsaved(tab)));
    json_object_set_new(state, "shown_title", json_string(tab_title(tab, &window->arena)));
    json_object_set_new(state, "snaps", json_boolean(!window->plan_input.free));
    json_object_set_new(state, "held", json_boolean(window->plan_input.holds));
    json_object_set_new(state, "animation", text_or_null(plan_input_animation(tab)));
    editor_proposals(editor, &count, &doing);
    json_object_set_new(state, "proposals", json_integer((json_int_t)count));
    json_object_set_new(state, "proposing", text_or_null(doing));
    json_object_set_new(state, "split", split_state(window, tab));
}

/* Returns the places of (0, 0), (1, 0) and (0, 1) m in the window, pixels. */
static json_t *floor_state(const Window *window, const Tab *tab) {
    Vec2 places[] = {{0, 0}, {1, 0}, {0, 1}};
    json_t *state = json_array();
    for (size_t i = 0; tab->view_layers.painted && i < 3; i++) {
        Vec2 at = vec2_add(window->frame.view.low, view_layers_point(&tab->view_layers, places[i]));
        json_array_append_new(state, json_pack("[f,f]", at.x * window->unit, at.y * window->unit));
    }
    return state;
}

static void add_captions(json_t *labels, const Window *window, const Layout *layout) {
    static const char *const shapes[] = {[LABEL_BARE] = "name", [LABEL_TAG] = "tag", [LABEL_DISC] = "disc"};
    for (size_t i = 0; i < layout->caption_count; i++) {
        const Caption *caption = &layout->captions[i];
        Box box = caption_box(caption);
        box.low = vec2_add(box.low, window->frame.view.low);
        box.high = vec2_add(box.high, window->frame.view.low);
        Vec2 pointed = vec2_add(caption->leader ? caption->pointed : caption->centre, window->frame.view.low);
        json_t *one = json_pack("{s:s,s:f,s:s}", "string", caption->text, "size", caption->size * window->unit, "kind",
                                shapes[caption->shape]);
        json_object_set_new(one, "box", json_box(window, box));
        json_object_set_new(one, "pointed", json_pack("[f,f]", pointed.x * window->unit, pointed.y * window->unit));
        json_array_append_new(labels, one);
    }
}

static void add_selected_name(json_t *labels, const Window *window) {
    const SelectedName *name = &window->selected_name;
    if (!*name->text)
        return;
    json_t *one = json_pack("{s:s,s:f,s:s}", "string", name->text, "size", 16 * window->unit, "kind", "selected");
    json_object_set_new(one, "box", json_box(window, name->box));
    json_object_set_new(one, "pointed",
                        json_pack("[f,f]", name->pointed.x * window->unit, name->pointed.y * window->unit));
    json_array_append_new(labels, one);
}

/* Returns the texts in the view. */
static json_t *text_state(const Window *window, const Tab *tab) {
    json_t *labels = json_array();
    if (tab->view_layers.painted) {
        add_captions(labels, window, &tab->view_layers.still);
        add_captions(labels, window, &tab->view_layers.moving);
        add_selected_name(labels, window);
    }
    return labels;
}

static void add_tab(json_t *state, Window *window) {
    const Tab *tab = window_tab(window);
    const Player *player = &tab->player;
    RecordSpan span = tab_span(tab);
    Item item = tab->laboratory->selected(tab->session);
    char digest[32];
    snprintf(digest, sizeof digest, "%016llx",
             tab->laboratory->digest ? (unsigned long long)tab->laboratory->digest(tab->session) : 0ull);
    json_object_set_new(state, "file", tab->path ? json_string(tab->path) : json_null());
    json_object_set_new(state, "title", json_string(tab->laboratory->title(tab->session)));
    json_object_set_new(state, "digest", json_string(digest));
    json_object_set_new(state, "time", number_or_null(player->time));
    json_object_set_new(state, "begin", number_or_null(span.begin));
    json_object_set_new(state, "end", number_or_null(span.end));
    json_object_set_new(state, "step", number_or_null(span.step));
    json_object_set_new(state, "complete", json_boolean(span.complete));
    json_object_set_new(state, "playing", json_boolean(player->playing));
    json_object_set_new(state, "speed", number_or_null(player_speed(player)));
    json_object_set_new(state, "achieved", number_or_null(player->achieved));
    json_object_set_new(state, "loops", json_boolean(player->loops));
    json_object_set_new(state, "follows", json_boolean(tab->follows));
    json_object_set_new(state, "raised", json_boolean(tab->camera.kind == VIEW_RAISED));
    json_object_set_new(state, "zoom", number_or_null(tab->camera.zoom));
    json_object_set_new(state, "azimuth", number_or_null(tab->camera.azimuth));
    json_object_set_new(state, "layers", json_integer(tab_layers(tab)));
    json_object_set_new(state, "clock", json_string(tab->laboratory->clock(tab->session, player->time)));
    json_object_set_new(state, "ticks", ticks_state(tab));
    json_object_set_new(state, "selected", item.kind ? json_string(key_of(tab, item)) : json_null());
    json_object_set_new(state, "floor", floor_state(window, tab));
    json_object_set_new(state, "answer", answer_state(tab));
    json_object_set_new(state, "runs", runs_state(tab));
    json_object_set_new(state, "text_in_view", text_state(window, tab));
    json_object_set_new(state, "rows", rows_state(tab));
    json_object_set_new(state, "parameters", parameters_state(tab));
    json_object_set_new(state, "choices", choices_state(tab));
    json_object_set_new(state, "charts", plot_panes_state(&tab->panes));
    json_object_set_new(state, "command", command_state(tab));
    add_editor(state, window, tab);
}

static void add_menu(json_t *state, Window *window) {
    json_object_set_new(state, "menu", json_string(keys_menus[window->menu]));
    json_object_set_new(state, "menu_box", json_box(window, menu_box(window)));
    json_object_set_new(state, "menu_scrolls", json_boolean(menu_scrolls(window)));
    json_object_set_new(state, "focus_row", json_string(menu_focused(window)));
}

json_t *scripted_state_texts(const Window *window) {
    size_t count;
    const UiPainted *painted = ui_painted(window->ui, &count);
    json_t *texts = json_array();
    for (size_t i = 0; i < count; i++) {
        const Box *box = &painted[i].box, *clip = &painted[i].clip;
        json_array_append_new(texts, json_pack("{s:s,s:[f,f,f,f],s:[f,f,f,f]}", "string", painted[i].text, "box",
                                               box->low.x, box->low.y, box->high.x, box->high.y, "clip", clip->low.x,
                                               clip->low.y, clip->high.x, clip->high.y));
    }
    return texts;
}

json_t *scripted_state_of(Window *window) {
    static const char *const dialogs[DIALOGS] = {"none",   "menu",     "keys",      "gallery", "open",    "save",
                                                 "export", "messages", "explain",   "about",   "history", "leave",
                                                 "lesson", "kept",     "recovered", "unit"};
    const Message *last = messages_last(&window->messages);
    json_t *state = json_object();
    json_object_set_new(state, "laboratory", json_string(window_tab(window)->laboratory->word));
    json_object_set_new(state, "width", json_integer(window->width));
    json_object_set_new(state, "height", json_integer(window->height));
    json_object_set_new(state, "text", number_or_null(window->text));
    json_object_set_new(state, "theme", json_string(window->theme == THEME_BOARD ? "board" : "paper"));
    json_object_set_new(state, "sheet", json_string(dialogs[window->dialog]));
    if (window->dialog == DIALOG_MENU)
        add_menu(state, window);
    json_object_set_new(state, "panel", json_boolean(window->panel));
    json_object_set_new(state, "plots", json_boolean(window->plots_shown));
    json_object_set_new(state, "editing", json_boolean(window->editing));
    json_object_set_new(state, "refused", json_boolean(window->plan_input.refused));
    json_object_set_new(state, "unit", json_real(window->unit));
    json_object_set_new(state, "hovered", json_string(window->hovered));
    json_object_set_new(state, "echo", json_string(window->echo));
    json_object_set_new(state, "present", json_boolean(window->present));
    json_object_set_new(state, "fullscreen", json_boolean(window->fullscreen));
    json_object_set_new(state, "sound", json_boolean(window->sound != NULL));
    json_object_set_new(state, "tried", json_integer(window->settings.state.tried));
    json_object_set_new(state, "field", json_string(window->field));
    json_t *strip = json_array();
    for (size_t i = 0; i < window->strip_count; i++)
        json_array_append_new(strip, json_string(window->strip_keys[i]));
    json_object_set_new(state, "strip_keys", strip);
    json_t *listed = json_array();
    for (size_t i = 0; window->dialog == DIALOG_OPEN && i < window->folder.count; i++)
        if (dialog_gallery_lists(window, &window->folder.entries[i]))
            json_array_append_new(listed, json_string(window->folder.entries[i].name));
    for (size_t i = 0; window->dialog == DIALOG_GALLERY && i < window->shown_count; i++)
        json_array_append_new(listed, json_string(window->shown[i]));
    json_object_set_new(state, "listed", listed);
    json_object_set_new(state, "writing", json_boolean(window->export != NULL));
    const ExportStatus *export = window->export ? export_update(window->export) : NULL;
    json_object_set_new(state, "export",
                        export ? json_pack("{s:s,s:s}", "path", export->folder, "doing", export->doing) : json_null());
    json_object_set_new(state, "focus", json_string(ui_focus_pane(window->ui)));
    json_object_set_new(state, "focus_help", text_or_null(ui_focus_help(window->ui)));
    json_object_set_new(state, "focus_is_pane", json_boolean(ui_focus_is_pane(window->ui)));
    json_object_set_new(state, "types", json_boolean(ui_types(window->ui)));
    json_object_set_new(state, "message", last ? json_string(last->text) : json_null());
    json_object_set_new(state, "mouse", json_pack("[ff]", window->mouse.x, window->mouse.y));
    json_object_set_new(state, "inputs", json_integer((json_int_t)window->inputs));
    size_t faults;
    const Message *shown = notice_shown(window, &faults);
    json_object_set_new(state, "said", text_or_null(shown ? shown->text : NULL));
    json_object_set_new(state, "faults", json_integer((json_int_t)faults));
    json_object_set_new(state, "messages", json_integer((json_int_t)window->messages.total));
    json_object_set_new(state, "frame", frame_state(window));
    json_object_set_new(state, "lesson", lesson_state(window));
    if (window_tab(window)->session)
        add_tab(state, window);
    return state;
}
