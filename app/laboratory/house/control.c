#include "laboratory/house/control.h"

#include <stdio.h>
#include <string.h>

#include "base/parameters_number.h"
#include "laboratory/house/fall.h"
#include "laboratory/house/schedule.h"
#include "plan/draft_file.h"
#include "plan/draft_parameter.h"

/* The editor ------------------------------------------------------------------------------------------------------- */

void house_control_select(HouseSession *live, Item chosen) {
    if (item_same(chosen, live->selected))
        return;
    bool people = chosen.kind == HOUSE_PERSON || live->selected.kind == HOUSE_PERSON;
    live->selected = chosen;
    live->changed |= LABORATORY_WORDS | LABORATORY_PARAMETERS | (people ? LABORATORY_PLOTS : 0);
}

HouseSession *house_control_sync(void *context) {
    HouseSession *live = context;
    EditorShake shake;
    house_control_select(live, editor_selected(live->editor));
    if (editor_next_change(live->editor))
        house_schedule_apply_edit(live);
    if (editor_next_shake(live->editor, &shake))
        house_fall_shake(live, shake.seed, shake.ids, shake.count);
    return live;
}

/* Numbers ---------------------------------------------------------------------------------------------------------- */

const PanelParameter *house_control_parameters(const void *context, size_t *count) {
    const HouseSession *live = context;
    *count = live->values.count;
    return live->values.listed;
}

void house_control_hold(void *context, const char *name) {
    HouseSession *live = house_control_sync(context);
    size_t row = house_value_find(&live->values, name);
    char step[2 * HOUSE_THING_NAME] = "Change a number";
    if (row != SIZE_MAX)
        snprintf(step, sizeof step, "%s: %s", live->values.rows[row].group, live->values.rows[row].label);
    editor_hold_number(live->editor, step);
}

void house_control_settle(void *context) {
    editor_settle(house_control_sync(context)->editor);
}

/* Sets the value of a row in the draft: as its own step, unless a number is being dragged. */
static bool set_in_draft(HouseSession *live, size_t row, Fault *fault) {
    const PanelParameter *value = &live->values.rows[row];
    char name[HOUSE_THING_NAME];
    snprintf(name, sizeof name, "%s: %s", value->group, value->label);
    bool held = editor_holds_number(live->editor);
    if (held)
        draft_rewind(live->draft);
    else
        draft_begin(live->draft, name);
    bool known = draft_parameter_set(live->draft, value->name, parameters_number_json(value->row, value->value), fault);
    if (held)
        return known && draft_try(live->draft, fault);
    if (known)
        return draft_end(live->draft, fault);
    draft_cancel(live->draft);
    return false;
}

static void put_back(HouseSession *live, size_t row) {
    Fault none = {0};
    set_in_draft(live, row, &none);
    fault_clear(&none);
}

bool house_control_set(void *context, const char *name, double value, Fault *fault) {
    HouseSession *live = house_control_sync(context);
    size_t row = house_value_find(&live->values, name);
    if (row == SIZE_MAX) {
        fault_add(fault, "there is no number called \"%s\"", name);
        return false;
    }
    double before = live->values.rows[row].value;
    if (!house_value_set(&live->values, row, value, fault))
        return false;
    if (value == before)
        return true;
    if (!set_in_draft(live, row, fault)) {
        live->values.rows[row].value = before;
        if (editor_holds_number(live->editor)) /* the last that stood, if there was one, is what is put down */
            put_back(live, row);
        return false;
    }
    house_schedule_apply_edit(live);
    if (live->runs[RUN_SHOWN])
        house_value_sort(&live->values, &live->runs[RUN_SHOWN]->house, live->selected);
    return true;
}

void house_control_reset(void *context) {
    HouseSession *live = house_control_sync(context);
    uint64_t before = draft_revision(live->draft);
    editor_reset(live->editor, "Reset scene");
    if (draft_revision(live->draft) == before)
        return;
    for (size_t i = 0; i < live->values.count; i++)
        live->values.rows[i].value = live->values.rows[i].initial;
    if (live->kept_itself)
        house_schedule_clear(live);
    house_history_begin(&live->history, draft_text(live->draft), draft_revision(live->draft));
    house_schedule_apply_edit(live);
}

/* Choices ---------------------------------------------------------------------------------------------------------- */

#define GHOST "Ghost"
#define ROUTE "Route"
#define DRIVING "Driving"

static PanelChoice *add_choice(HouseSession *live, const char *name, const char *meaning) {
    PanelChoice *choice = &live->choices[live->choice_count];
    *choice = (PanelChoice){.name = name, .meaning = meaning, .words = live->choice_words[live->choice_count]};
    live->choice_count++;
    return choice;
}

/* `chosen`: this is what is so now. */
static void add_word(HouseSession *live, PanelChoice *choice, const char *word, bool chosen) {
    if (choice->count == HOUSE_CHOICE_WORDS)
        return;
    if (chosen)
        choice->chosen = choice->count;
    live->choice_words[choice - live->choices][choice->count++] = word;
}

static bool anybody_rides(const House *house) {
    for (size_t k = 0; k < house->profile_count; k++)
        if (house->profiles[k].driving != DRIVING_WALKER)
            return true;
    return false;
}

static void list(HouseSession *live) {
    bool rides = live->runs[RUN_SHOWN] && anybody_rides(&live->runs[RUN_SHOWN]->house);
    live->choice_count = 0;
    PanelChoice *ghost = add_choice(live, GHOST,
                                    "What is shown behind, for comparison: the run that was kept with K, "
                                    "or the same house with the other way of driving.");
    add_word(live, ghost, "none", live->ghost == GHOST_NONE);
    if (live->runs[RUN_BEFORE])
        add_word(live, ghost, "before", live->ghost == GHOST_BEFORE);
    if (rides)
        add_word(live, ghost, profile_driving_name(house_runs_other_driving(live)), live->ghost == GHOST_RIVAL);
    const Plan *plan = draft_plan(live->draft);
    if (plan->route_count > 1) {
        PanelChoice *route = add_choice(live, ROUTE, "Whose route is driven: everybody's, or one alone.");
        add_word(live, route, "everybody", !live->wish.route);
        for (size_t r = 0; r < plan->route_count; r++) {
            const char *id = plan->routes[r].id;
            add_word(live, route, id, live->wish.route && strcmp(live->wish.route, id) == 0);
        }
    }
    if (!rides)
        return;
    PanelChoice *driving = add_choice(live, DRIVING,
                                      "The way of driving: as each profile says, a driver who turns the "
                                      "chair, or the paper's disc on straight legs and corners.");
    add_word(live, driving, "as in the file", live->wish.driving < 0);
    for (int way = DRIVING_DRIVER; way <= DRIVING_MIURA; way++)
        add_word(live, driving, profile_driving_name(way), live->wish.driving == way);
}

static void take_ghost(HouseSession *live, const char *word) {
    live->ghost = strcmp(word, "none") == 0 ? GHOST_NONE : strcmp(word, "before") == 0 ? GHOST_BEFORE : GHOST_RIVAL;
    live->retell = true;
    live->changed |= LABORATORY_WORDS | LABORATORY_PLOTS;
    house_session_void_film(live);
}

static const PanelChoice *list_choices(HouseSession *live, size_t *count) {
    list(live);
    *count = live->choice_count;
    return live->choices;
}

static void apply_choice(HouseSession *live, size_t choice, size_t word) {
    list(live);
    if (choice >= live->choice_count || word >= live->choices[choice].count)
        return;
    const PanelChoice *taken = &live->choices[choice];
    if (strcmp(taken->name, GHOST) == 0) {
        take_ghost(live, taken->words[word]);
    } else if (strcmp(taken->name, ROUTE) == 0) {
        live->wish.route = word ? arena_text(&live->arena, taken->words[word]) : NULL;
        house_schedule_request(live);
    } else {
        live->wish.driving = (int)word - 1;
        editor_set_driving(live->editor, live->wish.driving);
        house_schedule_store(live, true);
        house_schedule_request(live);
    }
}

/* Runs ------------------------------------------------------------------------------------------------------------- */

const Preset *house_control_presets(const void *context, size_t *count) {
    (void)context;
    *count = 0;
    return NULL;
}

void house_control_prefer(void *context, size_t preset) {
    (void)context;
    (void)preset;
}

const PanelChoice *house_control_choices(void *context, size_t *count) {
    return list_choices(house_control_sync(context), count);
}

void house_control_choose(void *context, size_t choice, size_t word) {
    apply_choice(house_control_sync(context), choice, word);
}

/* What is recorded is what would come: only a run that was stopped or broke down is made again, or one in which the
 * plan changed. */
void house_control_again(void *context) {
    HouseSession *live = house_control_sync(context);
    house_schedule_restart(live);
    if (live->trouble.text && !live->runs[RUN_LATEST])
        house_schedule_request(live);
}

bool house_control_keep(void *context, double time) {
    HouseSession *live = house_control_sync(context);
    (void)time;
    live->changed |= LABORATORY_WORDS | LABORATORY_PLOTS;
    return house_schedule_store(live, false);
}

void house_control_clear(void *context, double time) {
    (void)time;
    house_schedule_clear(house_control_sync(context));
}

/* The command line ------------------------------------------------------------------------------------------------- */

enum { WORDS = 8 /* besides settings: the verb, the file, and three options with their values */ };

/* True if the draft equals its file with these settings: no item was added, moved by the pointer or
 * taken away. */
static bool is_file_with(const HouseSession *live, const char *const *settings, size_t count) {
    const char *path = draft_file_path(live->draft);
    Fault none = {0};
    Plan plan = {0};
    bool same = path && plan_read(&plan, path, settings, count, &none);
    char *text = same ? plan_text(&plan) : NULL;
    same = text && strcmp(text, draft_text(live->draft)) == 0;
    memory_free(text);
    plan_free(&plan);
    fault_clear(&none);
    return same;
}

/* The settings that make the draft of its file: those it was opened with, and what was changed since; (count). */
static const char **make_settings(HouseSession *live, size_t *count) {
    const LaboratoryOptions *given = &live->given;
    const char **settings = memory_zeroed(given->setting_count + live->values.count + 1, sizeof *settings);
    *count = given->setting_count;
    for (size_t i = 0; i < given->setting_count; i++)
        settings[i] = given->settings[i];
    *count += house_value_settings(&live->values, settings + *count, &live->command_arena);
    return settings;
}

const char *const *house_control_command(void *context, size_t *count) {
    HouseSession *live = house_control_sync(context);
    const HouseWish *wish = &live->wish;
    Arena *arena = &live->command_arena;
    arena_clear(arena);
    memory_free(live->command);
    size_t setting_count, used = 0;
    const char **settings = make_settings(live, &setting_count);
    const char **words = memory_zeroed(WORDS + 2 * setting_count, sizeof *words);
    bool whole = is_file_with(live, NULL, 0), made = !whole && is_file_with(live, settings, setting_count);
    words[used++] = "run";
    words[used++] = whole || made ? draft_file_path(live->draft) : "";
    for (size_t i = 0; made && i < setting_count; i++) {
        words[used++] = "--set";
        words[used++] = settings[i];
    }
    if (wish->route) {
        words[used++] = "--route";
        words[used++] = wish->route;
    }
    if (wish->driving >= 0) {
        words[used++] = "--driving";
        words[used++] = profile_driving_name(wish->driving);
    }
    if (wish->seed != 1) {
        words[used++] = "--seed";
        words[used++] = text_in_arena(arena, "%llu", (unsigned long long)wish->seed);
    }
    memory_free(settings);
    live->command = words;
    *count = used;
    return words;
}
