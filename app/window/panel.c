#include "window/panel.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

#include "window/act.h"
#include "window/edit.h"
#include "window/panel_edit.h"

enum { DIGITS_MOST = 6, PRESETS_IN_ROW = 2 };
#define STEPS_SHOWN 500.0 /* of a slider's range, that its digits tell apart */

/* What came of it -------------------------------------------------------------------------------------------------- */

/* Can it be chosen? */
static bool is_usable(const LiveRow *row) {
    return row->thing.kind || !isnan(row->time);
}

static void show_row(Window *window, Room *room, const LiveRow *row, size_t index) {
    const SceneRow *scene = &row->row;
    if (scene->kind == ROW_HEADING) {
        ui_heading(window->ui, scene->cells[0]);
        return;
    }
    bool usable = is_usable(row);
    if (scene->kind == ROW_PLAIN && !usable && !scene->cells[1]) {
        ui_text(window->ui, UI_BODY, ROLE_TEXT, scene->cells[0]);
        return;
    }
    UiRow shown = {.id = text_in_arena(&window->words, "row %zu", index),
                   .mark = scene->mark,
                   .role = scene->role,
                   .shape = (int)scene->kind,
                   .style = (int)scene->style,
                   .cells = {scene->cells[0], scene->cells[1], scene->cells[2]},
                   .help =
                       usable ? text_in_arena(&window->words, "%s: selects it and goes there", scene->cells[0]) : NULL,
                   .selected = row->thing.kind && live_same(row->thing, room->kind->selected(room->live)),
                   .usable = usable};
    LiveThing thing = row->thing;
    double time = row->time;
    if (!ui_list_row(window->ui, &shown))
        return;
    if (thing.kind)
        room_select(room, thing);
    if (!isnan(time))
        room_seek(room, time);
    window->dirty = true;
}

/* The row where the lists begin from which something can be chosen; those before only tell: of what is selected, and of
 * before and now. */
static size_t find_lists(const Room *room) {
    size_t count, begin = 0;
    const LiveRow *rows = room->kind->rows(room->live, &count);
    for (size_t i = 0; i < count && !is_usable(&rows[i]); i++)
        begin = rows[i].row.kind == ROW_HEADING ? i : begin;
    return begin;
}

static void show_rows(Window *window, Room *room, size_t from, size_t to) {
    size_t count;
    const LiveRow *rows = room->kind->rows(room->live, &count);
    for (size_t i = from; i < count && i < to; i++) {
        show_row(window, room, &rows[i], i);
        rows = room->kind->rows(room->live, &count); /* choosing one may have changed them */
    }
}

static void show_choices(Window *window, Room *room) {
    size_t count;
    const LiveChoice *choices = room->kind->choices(room->live, &count);
    for (size_t i = 0; i < count; i++) {
        size_t chosen = choices[i].chosen;
        if (choices[i].count < 2)
            continue;
        const char *help = text_in_arena(&window->words, "%s: %s", choices[i].name, choices[i].meaning);
        if (ui_choice(window->ui, choices[i].name, choices[i].name, help, choices[i].words, choices[i].count,
                      &chosen)) {
            room->kind->choose(room->live, i, chosen);
            choices = room->kind->choices(room->live, &count);
            window->dirty = true;
        }
    }
}

static void show_presets(Window *window, Room *room) {
    size_t count;
    const LivePreset *presets = room->kind->presets(room->live, &count);
    if (!count)
        return;
    ui_heading(window->ui, "Presets");
    for (size_t i = 0; i < count; i++) {
        if (i % PRESETS_IN_ROW == 0)
            ui_row(window->ui, PRESETS_IN_ROW);
        const char *help = text_in_arena(&window->words, "%s: %s", presets[i].name, presets[i].meaning);
        if (ui_button(window->ui, &(UiButton){.label = presets[i].name, .help = help})) {
            room->kind->prefer(room->live, i);
            return;
        }
    }
}

/* Numbers ---------------------------------------------------------------------------------------------------------- */

static double factor_of(const LiveParameter *parameter) {
    return parameter->factor > 0 ? parameter->factor : 1;
}

/* Digits behind the point that tell apart what a slider's steps do, and that the value has. */
static int digits_of(const LiveParameter *parameter) {
    double range = (parameter->high - parameter->low) * factor_of(parameter) / STEPS_SHOWN;
    int digits = range > 0 ? (int)ceil(-log10(range)) : 0;
    digits = digits < 0 || parameter->row->kind == PARAMETER_WHOLE ? 0 : digits;
    return digits > DIGITS_MOST ? DIGITS_MOST : digits;
}

static const char *help_of(Window *window, const LiveParameter *parameter) {
    return text_in_arena(&window->words, "%s: %s%s%s (--set %s=...)", parameter->label, parameter->meaning,
                         parameter->provenance ? ". From: " : "", parameter->provenance ? parameter->provenance : "",
                         parameter->name);
}

static void show_number(Window *window, const LiveParameter *parameter) {
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
    UiChange change = ui_slider(window->ui, &slider);
    if (change == UI_MOVING)
        edit_hold_number(window, parameter->name);
    if (change != UI_SAME && slider.value != factor * parameter->value)
        act_set(window, parameter->name, slider.value / factor);
}

static size_t split_words(Window *window, const char *choices, const char **words, size_t most) {
    size_t count = 0;
    while (count < most) {
        size_t length = strcspn(choices, "|");
        words[count++] = text_in_arena(&window->words, "%.*s", (int)length, choices);
        if (!choices[length])
            break;
        choices += length + 1;
    }
    return count;
}

static void show_word(Window *window, const LiveParameter *parameter) {
    enum { WORDS_MOST = 8 };
    const char *words[WORDS_MOST];
    size_t count = split_words(window, parameter->row->choices, words, WORDS_MOST), chosen = (size_t)parameter->value;
    if (ui_choice(window->ui, parameter->name, parameter->label, help_of(window, parameter), words, count, &chosen))
        act_set(window, parameter->name, (double)chosen);
}

static void show_parameter(Window *window, const LiveParameter *parameter) {
    bool value = parameter->value != 0;
    switch (parameter->row->kind) {
    case PARAMETER_FLAG:
        if (ui_flag(window->ui, parameter->name, parameter->label, help_of(window, parameter), &value))
            act_set(window, parameter->name, value);
        break;
    case PARAMETER_CHOICE:
        show_word(window, parameter);
        break;
    default:
        show_number(window, parameter);
    }
}

/* Those that are looked for most, or all. */
static void show_parameters(Window *window, Room *room, bool first) {
    size_t count;
    const LiveParameter *parameters = room->kind->parameters(room->live, &count);
    const char *group = "";
    for (size_t i = 0; i < count; i++) {
        if (parameters[i].first != first)
            continue;
        if (strcmp(group, parameters[i].group) != 0)
            ui_heading(window->ui, parameters[i].group);
        group = text_in_arena(&window->words, "%s", parameters[i].group);
        show_parameter(window, &parameters[i]);
        parameters = room->kind->parameters(room->live, &count); /* a change may have made them anew */
    }
}

static void show_more(Window *window, Room *room) {
    ui_gap(window->ui, 6);
    ui_row(window->ui, 2);
    if (ui_button(window->ui, &(UiButton){.label = "Reset all", .help = keys_help(&window->words, ACTION_UNDO_ALL)}))
        act_do(window, ACTION_UNDO_ALL, 0, 0);
    if (ui_button(window->ui, &(UiButton){.label = window->more ? "Fewer numbers" : "All numbers",
                                          .help = "All numbers: shows every number that can be changed",
                                          .chosen = window->more}))
        window->more = !window->more;
    if (window->more)
        show_parameters(window, room, false);
}

/* Layers and plots ------------------------------------------------------------------------------------------------- */

static void show_layers(Window *window, Room *room) {
    ui_heading(window->ui, "Layers");
    for (size_t i = 0; i < room->kind->layer_count; i++) {
        bool shown = room_layers(room) >> i & 1;
        const char *label = text_in_arena(&window->words, "%zu  %s", i + 1, room->kind->layers[i]);
        const char *help =
            text_in_arena(&window->words, "%s (%zu): %s", room->kind->layers[i], i + 1, room->kind->meanings[i]);
        if (ui_flag(window->ui, label, label, help, &shown))
            act_do(window, ACTION_LAYER, '1' + (int32_t)i, 0);
    }
}

/* The names without one of them, or with it at the end. */
static const char *toggled(Window *window, const char *names, const char *name, bool add) {
    Text text = {0};
    for (const char *at = names; *at; at += strcspn(at, ","), at += *at == ',') {
        size_t length = strcspn(at, ",");
        if (length != strlen(name) || strncmp(at, name, length) != 0)
            text_format(&text, "%s%.*s", text.used ? "," : "", (int)length, at);
    }
    if (add)
        text_format(&text, "%s%s", text.used ? "," : "", name);
    const char *kept = settings_keep(&window->settings, text.text ? text.text : "none");
    memory_free(text.text);
    return kept;
}

static void show_plots(Window *window, Room *room) {
    ui_heading(window->ui, "Plots");
    size_t count = room->kind->plot_count(room->live);
    for (size_t i = 0; i < count; i++) {
        LivePlot plot = room->kind->plot(room->live, i);
        bool shown = false;
        for (size_t c = 0; c < room->charts.count; c++)
            shown |= strcmp(room->charts.charts[c].live.name, plot.name) == 0;
        const char *help = text_in_arena(&window->words, "%s: shows the plot, or not", plot.title);
        if (ui_flag(window->ui, text_in_arena(&window->words, "plot %s", plot.name), plot.title, help, &shown)) {
            room->plots = toggled(window, room->plots, plot.name, shown);
            room->charts_wait = true;
        }
    }
}

void panel_show(Window *window) {
    Room *room = window_room(window);
    if (box_width(window->frame.panel) <= 0)
        return;
    ui_pane_begin(window->ui,
                  &(UiPane){.name = "panel", .box = window->frame.panel, .ground = ROLE_PANEL, .scrolls = true});
    if (room->live) {
        bool selected = room->kind->selected(room->live).kind;
        size_t lists = room->kind->numbers_first ? 0 : selected ? find_lists(room) : SIZE_MAX;
        panel_edit_show(window);
        show_rows(window, room, 0, lists);
        show_parameters(window, room, true); /* of what is selected: Enter goes to the first that can be changed */
        panel_edit_show_words(window);
        show_presets(window, room);
        show_rows(window, room, lists, SIZE_MAX);
        show_choices(window, room);
        show_more(window, room);
        panel_edit_show_house(window);
        show_plots(window, room);
        show_layers(window, room);
    }
    ui_pane_end(window->ui);
}
