#include "window/panel.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "window/act.h"
#include "window/lesson.h"
#include "window/notice.h"
#include "window/panel_edit.h"
#include "window/plan_input.h"

enum { DIGITS_MOST = 6, PRESETS_IN_ROW = 2, OPEN_MOST = 3, SUBJECTS = 1 << 20 /* more than things of a kind */ };
#define LENGTH_DIGITS 2   /* of a length in m */
#define ARROW 7.0         /* design points: half the height of the handle's arrow */
#define STEPS_SHOWN 500.0 /* steps of a slider's range that its digits distinguish */

/* Folds ------------------------------------------------------------------------------------------------------------ */

/* Returns the task that the folds are remembered for. */
static const char *task_of(const Window *window) {
    const Tab *tab = &window->tabs[window->current];
    return lesson_is_shown(window)                       ? "lesson"
           : tab->laboratory->numbers_first              ? tab->laboratory->word
           : window->editing                             ? "edit"
           : tab->session && tab_opens_plots(tab, false) ? "crowd"
                                                         : "watch";
}

/* Returns the fold of a title as it was left, or NULL. */
static Fold *find_fold(Window *window, const char *name) {
    for (size_t i = 0; i < window->fold_count; i++)
        if (strcmp(window->folds[i].name, name) == 0)
            return &window->folds[i];
    return NULL;
}

/* Stores the folds: a line each, "+" for an open one. */
static void store_folds(Window *window) {
    Text text = {0};
    for (size_t i = 0; i < window->fold_count; i++)
        text_format(&text, "%s%c%s", i ? "\n" : "", window->folds[i].open ? '+' : '-', window->folds[i].name);
    window->settings.state.folds = settings_store(&window->settings, text.text ? text.text : "");
    memory_free(text.text);
}

void panel_read_folds(Window *window) {
    for (const char *line = window->settings.state.folds; *line; line += strcspn(line, "\n"), line += *line == '\n') {
        size_t length = strcspn(line, "\n");
        if (length < 2 || length > FOLD_NAME || window->fold_count == FOLDS_MOST || (*line != '+' && *line != '-'))
            continue;
        Fold *fold = &window->folds[window->fold_count++];
        snprintf(fold->name, sizeof fold->name, "%.*s", (int)length - 1, line + 1);
        fold->open = *line == '+';
    }
}

/* Shows the heading of a fold and returns true if it is open. Folds that were touched stay as they were left, for each
 * task, whatever the file; of the others the first ones are open, so that at most OPEN_MOST are unless more were
 * opened. */
static bool show_fold(Window *window, const char *title, const char *summary, bool open_at_first) {
    char name[FOLD_NAME];
    snprintf(name, sizeof name, "%s/%s", task_of(window), title);
    Fold *fold = find_fold(window, name);
    size_t taken = window->folds_open + window->folds_opened; /* by others that were opened, above and in all */
    bool touched = fold, open = touched ? fold->open : open_at_first && taken < OPEN_MOST;
    if (ui_fold(window->ui, title, open ? NULL : summary, &open)) {
        if (!fold && window->fold_count < FOLDS_MOST)
            fold = &window->folds[window->fold_count++];
        if (fold) {
            memcpy(fold->name, name, sizeof name);
            fold->open = open;
        }
        store_folds(window);
        touched = true;
        window->dirty = true;
    }
    window->folds_open += open && !touched;
    window->folds_opening += open && touched;
    return open;
}

/* Results ---------------------------------------------------------------------------------------------------------- */

/* True if the row can be chosen. */
static bool is_usable(const PanelRow *row) {
    return !row->act && (row->item.kind || !isnan(row->time));
}

static void act_row(Window *window, const PanelRow *row) {
    Editor *editor = tab_editor(window_tab(window));
    Fault fault = {0};
    if (row->act == ROW_ACT_SHAKE)
        act_do(window, ACTION_SHAKE, 0, 0);
    else if (row->act == ROW_ACT_STAND_UP)
        editor_stand_up(editor, &fault);
    else if (row->act == ROW_ACT_FIX)
        editor_fix_to_wall(editor, row->item, &fault);
    notice_fault(window, &fault, NAN);
    window->dirty = true;
}

/* Shows a button; neighbours share a line. */
static void show_act(Window *window, const PanelRow *rows, size_t count, size_t index) {
    size_t side = 0;
    while (index + side < count && rows[index + side].act)
        side++;
    if (!index || !rows[index - 1].act)
        ui_row(window->ui, (int)side);
    bool pressed = ui_button(window->ui, &(UiButton){.label = rows[index].row.cells[0], .help = rows[index].help});
    if (side == 1)
        ui_row(window->ui, 1);
    if (pressed)
        act_row(window, &rows[index]);
}

static void show_row(Window *window, Tab *tab, const PanelRow *row, size_t index) {
    const SceneRow *scene = &row->row;
    bool usable = is_usable(row);
    bool narrow = scene->kind == ROW_DISC && scene->cells[2] && !frame_is_wide(window->frame.page); /* the cost alone */
    if (scene->kind == ROW_PLAIN && !usable && !scene->cells[1]) {
        ui_text(window->ui, UI_BODY, ROLE_TEXT, scene->cells[0]);
        return;
    }
    const char *name = scene->cells[0] && !*scene->cells[0] && scene->mark ? scene->mark : scene->cells[0];
    UiRow shown = {
        .id = text_in_arena(&window->arena, "row %zu", index),
        .mark = scene->mark,
        .role = scene->role,
        .shape = (int)scene->kind,
        .style = (int)scene->style,
        .cells = {scene->cells[0], narrow ? scene->cells[2] : scene->cells[1], narrow ? NULL : scene->cells[2]},
        .help = usable ? text_in_arena(&window->arena, "%s: Select it and go to its time", name) : NULL,
        .selected = row->item.kind && item_same(row->item, tab->laboratory->selected(tab->session)),
        .has_bar = row->has_bar,
        .bar = row->bar,
        .dim = tab->laboratory->answer(tab->session).stale,
        .usable = usable};
    Item item = row->item;
    double time = row->time;
    if (!ui_list_row(window->ui, &shown))
        return;
    if (item.kind)
        tab_select(tab, item);
    if (!isnan(time))
        tab_seek(tab, time);
    window->dirty = true;
}

/* Returns the first row of the lists with rows that can be chosen; the rows before them describe the selection and the
 * comparison. */
static size_t find_lists(const Tab *tab) {
    size_t count, begin = 0;
    const PanelRow *rows = tab->laboratory->rows(tab->session, &count);
    for (size_t i = 0; i < count && !is_usable(&rows[i]); i++)
        begin = rows[i].row.kind == ROW_HEADING ? i : begin;
    return begin;
}

/* Returns the row behind the list that begins with a heading. */
static size_t list_end(const PanelRow *rows, size_t count, size_t heading) {
    size_t end = heading + 1;
    while (end < count && rows[end].row.kind != ROW_HEADING)
        end++;
    return end;
}

/* Returns the row behind what describes the selection, whose list comes first. What compares two runs follows the
 * numbers of the selection: it comes with the first change of one of them, which must not move from under the pointer.
 */
static size_t find_comparison(const Tab *tab) {
    size_t count, lists = find_lists(tab);
    const PanelRow *rows = tab->laboratory->rows(tab->session, &count);
    size_t end = count && rows[0].row.kind == ROW_HEADING ? list_end(rows, count, 0) : 0;
    return end < lists ? end : lists;
}

static void show_rows(Window *window, Tab *tab, size_t from, size_t to) {
    size_t count;
    const PanelRow *rows = tab->laboratory->rows(tab->session, &count);
    bool open = true, selected = tab->laboratory->selected(tab->session).kind;
    for (size_t i = from; i < count && i < to; i++) {
        if (rows[i].row.kind == ROW_HEADING && selected && !is_usable(&rows[i]) && i == 0) {
            panel_edit_heading(window, rows[i].row.cells[0]); /* of the selection, whose numbers follow at once */
        } else if (rows[i].row.kind == ROW_HEADING && rows[i].advice && lesson_is_shown(window)) {
            open = false;
        } else if (rows[i].row.kind == ROW_HEADING) {
            size_t all = list_end(rows, count, i) - i - 1;
            const char *told = rows[i].row.cells[1];
            const char *summary = text_in_arena(&window->arena, "%s", told ? told : "");
            if (!told)
                summary = text_in_arena(&window->arena, "%zu", all);
            open = show_fold(window, rows[i].row.cells[0], summary, strcmp(rows[i].row.cells[0], "Key") != 0);
        } else if (open && rows[i].act) {
            show_act(window, rows, count, i);
        } else if (open) {
            show_row(window, tab, &rows[i], i);
        }
        rows = tab->laboratory->rows(tab->session, &count); /* a choice may have changed the rows */
    }
}

static void show_choices(Window *window, Tab *tab) {
    size_t count, shown = 0;
    bool open_at_first = tab->laboratory->numbers_first;
    const PanelChoice *choices = tab->laboratory->choices(tab->session, &count);
    for (size_t i = 0; i < count; i++) {
        size_t chosen = choices[i].chosen;
        if (choices[i].count < 2)
            continue;
        if (!shown++ && !show_fold(window, "Compare and run", choices[i].options[choices[i].chosen], open_at_first))
            return;
        const char *help = text_in_arena(&window->arena, "%s: %s", choices[i].name, choices[i].meaning);
        if (ui_choice(window->ui, choices[i].name, choices[i].name, help, choices[i].options, choices[i].count,
                      &chosen)) {
            tab->laboratory->choose(tab->session, i, chosen);
            choices = tab->laboratory->choices(tab->session, &count);
            window->dirty = true;
        }
    }
}

static void show_presets(Window *window, Tab *tab) {
    size_t count;
    const Preset *presets = tab->laboratory->presets(tab->session, &count);
    if (!count)
        return;
    if (!show_fold(window, "Good starts", NULL, true))
        return;
    for (size_t i = 0; i < count; i++) {
        if (i % PRESETS_IN_ROW == 0)
            ui_row(window->ui, count - i < PRESETS_IN_ROW ? (int)(count - i) : PRESETS_IN_ROW);
        const char *help = text_in_arena(&window->arena, "%s: %s", presets[i].name, presets[i].meaning);
        if (ui_button(window->ui, &(UiButton){.label = presets[i].name, .help = help})) {
            tab->laboratory->apply_preset(tab->session, i);
            return;
        }
    }
}

/* Numbers ---------------------------------------------------------------------------------------------------------- */

static double factor_of(const PanelParameter *parameter) {
    return parameter->factor > 0 ? parameter->factor : 1;
}

/* Returns the number of decimals that distinguishes the steps of a slider. */
static int digits_of(const PanelParameter *parameter) {
    double range = (parameter->high - parameter->low) * factor_of(parameter) / STEPS_SHOWN;
    int digits = range > 0 ? (int)ceil(-log10(range)) : 0;
    digits = digits < 0 || parameter->row->kind == PARAMETER_WHOLE ? 0 : digits;
    return digits > DIGITS_MOST ? DIGITS_MOST : digits;
}

static const char *help_of(Window *window, const PanelParameter *parameter) {
    return text_in_arena(&window->arena, "%s: %s%s%s (--set %s=...)", parameter->label, parameter->meaning,
                         parameter->provenance ? ". From: " : "", parameter->provenance ? parameter->provenance : "",
                         parameter->name);
}

/* Changes a number; a fault is posted. */
static void set(Window *window, const char *name, double value) {
    Fault fault = {0};
    tab_set(window_tab(window), name, value, &fault);
    notice_fault(window, &fault, NAN);
}

static void show_number(Window *window, const PanelParameter *parameter) {
    double factor = factor_of(parameter);
    UiSlider slider = {.id = parameter->name,
                       .label = parameter->label,
                       .unit = parameter->unit ? parameter->unit : parameter->row->unit,
                       .help = help_of(window, parameter),
                       .value = factor * parameter->value,
                       .initial = factor * parameter->initial,
                       .low = factor * parameter->low,
                       .high = factor * parameter->high,
                       .least = factor * parameter->row->low,
                       .most = factor * parameter->row->high,
                       .logarithmic = parameter->logarithmic,
                       .whole = parameter->row->kind == PARAMETER_WHOLE,
                       .digits = digits_of(parameter)};
    slider.digits_least = strcmp(slider.unit, "m") == 0 ? LENGTH_DIGITS : 0;
    UiChange change = ui_slider(window->ui, &slider);
    if (change == UI_MOVING)
        plan_input_hold_number(window, parameter->name);
    if (change != UI_SAME && slider.value != factor * parameter->value)
        set(window, parameter->name, slider.value / factor);
}

static size_t split_words(Window *window, const char *choices, const char **words, size_t most) {
    size_t count = 0;
    while (count < most) {
        size_t length = strcspn(choices, "|");
        words[count++] = text_in_arena(&window->arena, "%.*s", (int)length, choices);
        if (!choices[length])
            break;
        choices += length + 1;
    }
    return count;
}

static void show_word(Window *window, const PanelParameter *parameter) {
    enum { WORDS_MOST = 8 };
    const char *words[WORDS_MOST];
    size_t count = split_words(window, parameter->row->choices, words, WORDS_MOST), chosen = (size_t)parameter->value;
    if (ui_choice(window->ui, parameter->name, parameter->label, help_of(window, parameter), words, count, &chosen))
        set(window, parameter->name, (double)chosen);
}

static void show_parameter(Window *window, const PanelParameter *parameter) {
    bool value = parameter->value != 0;
    switch (parameter->row->kind) {
    case PARAMETER_FLAG:
        if (ui_flag(window->ui, parameter->name, parameter->label, help_of(window, parameter), &value))
            set(window, parameter->name, value);
        break;
    case PARAMETER_CHOICE:
        show_word(window, parameter);
        break;
    default:
        show_number(window, parameter);
    }
}

/* True if other parameters of the group of the index-th one, at which it begins, stand above it. */
static bool begins_above(const PanelParameter *parameters, size_t count, size_t index) {
    const PanelParameter *mine = &parameters[index];
    for (size_t i = 0; i < count; i++)
        if ((mine->first ? parameters[i].first && i < index : parameters[i].first || i < index) &&
            strcmp(parameters[i].group, mine->group) == 0)
            return true;
    return false;
}

/* Shows the most used parameters, or all others, in folds; those of the selection stay open. */
static void show_parameters(Window *window, Tab *tab, bool first) {
    size_t count;
    const PanelParameter *parameters = tab->laboratory->parameters(tab->session, &count);
    const char *group = "";
    bool selected = tab->laboratory->selected(tab->session).kind, open = true, any = false;
    for (size_t i = 0; i < count; i++) {
        bool of_item = strncmp(parameters[i].name, "profile.", 8) != 0 && !tab->laboratory->numbers_first;
        if (parameters[i].idle || parameters[i].first != first || (first && !selected && of_item))
            continue;
        if (strcmp(group, parameters[i].group) != 0) {
            bool heads = first && selected && !any;
            group = text_in_arena(&window->arena, "%s", parameters[i].group);
            open = true;
            if (heads)
                panel_edit_heading(window, group);
            else
                open = show_fold(window,
                                 begins_above(parameters, count, i) ? text_in_arena(&window->arena, "%s: more", group)
                                                                    : group,
                                 NULL, first && (selected || tab->laboratory->numbers_first));
            any = true;
            parameters = tab->laboratory->parameters(tab->session, &count);
        }
        if (open)
            show_parameter(window, &parameters[i]);
        parameters = tab->laboratory->parameters(tab->session, &count); /* a change may have rebuilt the parameters */
    }
}

static void show_more(Window *window, Tab *tab) {
    if (!show_fold(window, "All numbers", NULL, false))
        return;
    if (ui_button(window->ui, &(UiButton){.label = "Reset all", .help = keys_help(&window->arena, ACTION_UNDO_ALL)}))
        act_do(window, ACTION_UNDO_ALL, 0, 0);
    show_parameters(window, tab, false);
}

/* Layers and plots ------------------------------------------------------------------------------------------------- */

enum { DIGITS = 9 /* keys of layers */ };

static void show_layers(Window *window, Tab *tab) {
    size_t count = tab->laboratory->layer_count;
    if (!show_fold(window, "Show", text_in_arena(&window->arena, "layers 1 to %zu", count < DIGITS ? count : DIGITS),
                   false))
        return;
    for (size_t i = 0; i < tab->laboratory->layer_count; i++) {
        bool shown = tab_layers(tab) >> i & 1;
        const char *key = i < DIGITS ? text_in_arena(&window->arena, "%zu", i + 1) : keys_row(ACTION_DRIVERS).key;
        const char *label = text_in_arena(&window->arena, "%s  %s", key, tab->laboratory->layers[i]);
        const char *help =
            text_in_arena(&window->arena, "%s (%s): %s", tab->laboratory->layers[i], key, tab->laboratory->meanings[i]);
        if (ui_flag(window->ui, label, label, help, &shown))
            act_do(window, ACTION_LAYER, '1' + (int32_t)i, 0);
    }
}

/* Returns the names without one of them, or with it at the end. */
static const char *toggled(Window *window, const char *names, const char *name, bool add) {
    Text text = {0};
    for (const char *at = names; *at; at += strcspn(at, ","), at += *at == ',') {
        size_t length = strcspn(at, ",");
        if (length != strlen(name) || strncmp(at, name, length) != 0)
            text_format(&text, "%s%.*s", text.used ? "," : "", (int)length, at);
    }
    if (add)
        text_format(&text, "%s%s", text.used ? "," : "", name);
    const char *kept = settings_store(&window->settings, text.text ? text.text : "none");
    memory_free(text.text);
    return kept;
}

/* Returns a title without the term in brackets at its end, for which the panel is too narrow: the tooltip has it. */
static const char *before_bracket(Window *window, const char *title) {
    const char *bracket = strstr(title, " (");
    return bracket ? text_in_arena(&window->arena, "%.*s", (int)(bracket - title), title) : title;
}

static void show_plots(Window *window, Tab *tab) {
    if (!show_fold(window, "Plots", keys_row(ACTION_PLOTS).key, false))
        return;
    size_t count = tab->laboratory->plot_count(tab->session);
    for (size_t i = 0; i < count; i++) {
        LaboratoryPlot plot = tab->laboratory->plot(tab->session, i);
        bool shown = false;
        for (size_t c = 0; c < tab->panes.count; c++)
            shown |= strcmp(tab->panes.panes[c].source.name, plot.name) == 0;
        const char *help = text_in_arena(&window->arena, "%s: Show or hide the plot", plot.title);
        const char *label = before_bracket(window, plot.title);
        if (ui_flag(window->ui, text_in_arena(&window->arena, "plot %s", plot.name), label, help, &shown)) {
            tab->plots = toggled(window, tab_plots(tab), plot.name, shown);
            tab->plot_panes_stale = true;
        }
    }
}

void panel_show(Window *window) {
    Tab *tab = window_tab(window);
    if (box_width(window->frame.panel) <= 0)
        return;
    window->dirty |= window->folds_opened != window->folds_opening; /* those above have not known it */
    window->folds_opened = window->folds_opening;
    window->heading_count = 0;
    window->folds_open = window->folds_opening = 0;
    Item item = tab->session ? tab->laboratory->selected(tab->session) : (Item){0};
    if (item.kind)
        window->panel_subject = (size_t)item.kind * SUBJECTS + item.index;
    ui_pane_begin(window->ui, &(UiPane){.name = "panel",
                                        .box = window->frame.panel,
                                        .ground = ROLE_PANEL,
                                        .scrolls = true,
                                        .subject = window->panel_subject});
    if (tab->session) {
        bool selected = item.kind;
        size_t lists = tab->laboratory->numbers_first ? 0 : selected ? find_comparison(tab) : SIZE_MAX;
        panel_edit_show(window);
        if (!selected)
            panel_edit_show_way_out(window);
        show_rows(window, tab, 0, lists);
        show_parameters(window, tab,
                        true); /* parameters of the selection: Enter focuses the first one that can be changed */
        panel_edit_show_texts(window);
        if (selected) /* the first stop of the focus is a number of the selection */
            panel_edit_show_way_out(window);
        show_presets(window, tab);
        show_rows(window, tab, lists, SIZE_MAX);
        show_choices(window, tab);
        show_more(window, tab);
        panel_edit_show_house(window);
        show_plots(window, tab);
        show_layers(window, tab);
    }
    ui_pane_end(window->ui);
}

void panel_show_handle(Window *window) {
    Box box = window->frame.handle;
    if (box_width(box) <= 0)
        return;
    bool open = box_width(window->frame.panel) > 0;
    ui_pane_begin(window->ui, &(UiPane){.name = "handle", .box = box, .ground = ROLE_SHADE});
    ui_at(window->ui, box);
    if (ui_button(window->ui,
                  &(UiButton){.id = "panel handle", .label = "", .help = keys_help(&window->arena, ACTION_PANEL)}))
        act_do(window, ACTION_PANEL, 0, 0);
    Vec2 middle = vec2_scale(vec2_add(box.low, box.high), 0.5), tip = {open ? ARROW / 2 : -ARROW / 2, 0};
    Vec2 arrow[] = {vec2_sub(middle, vec2(tip.x, ARROW)), vec2_add(middle, tip), vec2_sub(middle, vec2(tip.x, -ARROW))};
    ui_draw_polyline(window->ui, arrow, sizeof arrow / sizeof *arrow, false, ROLE_TEXT, 2.5);
    ui_pane_end(window->ui);
}
