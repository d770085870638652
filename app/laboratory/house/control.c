#include "laboratory/house/control.h"

#include <stdio.h>
#include <string.h>

#include "base/parameters_number.h"
#include "laboratory/house/fall.h"
#include "laboratory/house/schedule.h"
#include "laboratory/house/picture.h"
#include "plan/draft_file.h"
#include "plan/draft_parameter.h"
#include "result/names.h"

/* The editor ------------------------------------------------------------------------------------------------------- */

void house_control_select(HouseSession *session, Item chosen) {
    if (item_same(chosen, session->selected))
        return;
    bool people = chosen.kind == HOUSE_PERSON || session->selected.kind == HOUSE_PERSON;
    session->selected = chosen;
    session->changed |= LABORATORY_TEXTS | LABORATORY_PARAMETERS | (people ? LABORATORY_PLOTS : 0);
}

HouseSession *house_control_sync(void *context) {
    HouseSession *session = context;
    EditorShake shake;
    house_control_select(session, editor_selected(session->editor));
    if (editor_next_change(session->editor))
        house_schedule_apply_edit(session);
    if (editor_next_shake(session->editor, &shake))
        house_fall_shake(session, shake.seed, shake.ids, shake.count);
    return session;
}

/* Numbers ---------------------------------------------------------------------------------------------------------- */

const PanelParameter *house_control_parameters(const void *context, size_t *count) {
    const HouseSession *session = context;
    *count = session->values.count;
    return session->values.listed;
}

void house_control_begin_number(void *context, const char *name) {
    HouseSession *session = house_control_sync(context);
    size_t row = house_value_find(&session->values, name);
    char step[2 * HOUSE_ITEM_NAME] = "Change a number";
    if (row != SIZE_MAX)
        snprintf(step, sizeof step, "%s: %s", session->values.rows[row].group, session->values.rows[row].label);
    editor_begin_number(session->editor, step);
}

void house_control_end_number(void *context) {
    HouseSession *session = house_control_sync(context);
    editor_end_number(session->editor);
    house_control_sync(session); /* the number counts from the displayed time, before another gesture begins */
}

/* Adds the errors of a plan with the names in place of the ids. */
static void add_named(const HouseSession *session, Fault *fault, const Fault *own) {
    Arena arena = {0};
    const House *house = session->runs[RUN_SHOWN] ? &session->runs[RUN_SHOWN]->house : NULL;
    for (size_t i = 0; i < own->count; i++)
        fault_add(fault, "%s", names_plan_text(draft_plan(session->draft), house, own->lines[i], &arena));
    arena_clear(&arena);
}

/* Sets the value of a row in the draft: as its own step, unless a number is being dragged. */
static bool set_in_draft(HouseSession *session, size_t row, Fault *fault) {
    const PanelParameter *value = &session->values.rows[row];
    char name[HOUSE_ITEM_NAME];
    snprintf(name, sizeof name, "%s: %s", value->group, value->label);
    bool held = editor_drags_number(session->editor);
    if (held)
        draft_rewind(session->draft);
    else
        draft_begin(session->draft, name);
    bool known =
        draft_parameter_set(session->draft, value->name, parameters_number_json(value->row, value->value), fault);
    if (held)
        return known && draft_try(session->draft, fault);
    if (known)
        return draft_end(session->draft, fault);
    draft_cancel(session->draft);
    return false;
}

static void put_back(HouseSession *session, size_t row) {
    Fault none = {0};
    set_in_draft(session, row, &none);
    fault_clear(&none);
}

bool house_control_set(void *context, const char *name, double value, Fault *fault) {
    HouseSession *session = house_control_sync(context);
    size_t row = house_value_find(&session->values, name);
    if (row == SIZE_MAX) {
        fault_add(fault, "there is no parameter \"%s\"", name);
        return false;
    }
    double before = session->values.rows[row].value;
    if (!house_value_set(&session->values, row, value, fault))
        return false;
    if (value == before)
        return true;
    Fault own = {0};
    bool is_set = set_in_draft(session, row, &own);
    add_named(session, fault, &own);
    fault_clear(&own);
    if (!is_set) {
        session->values.rows[row].value = before;
        if (editor_drags_number(session->editor)) /* an earlier valid value, if there was one, is put back */
            put_back(session, row);
        return false;
    }
    house_schedule_apply_edit(session);
    if (session->runs[RUN_SHOWN])
        house_value_sort(&session->values, &session->runs[RUN_SHOWN]->house, session->selected);
    return true;
}

void house_control_reset(void *context) {
    HouseSession *session = house_control_sync(context);
    bool other = editor_reset(session->editor, "Reset scene");
    for (size_t i = 0; i < session->values.count; i++)
        session->values.rows[i].value = session->values.rows[i].initial;
    if (other && session->stored_by_itself)
        house_schedule_clear(session);
    if (other)
        house_history_begin(&session->history, draft_text(session->draft), draft_revision(session->draft));
    house_control_sync(session);
}

/* Choices ---------------------------------------------------------------------------------------------------------- */

#define GHOST "Compare with"
#define ROUTE "Route"
#define DRIVING "Driving"
#define EDITS "Edits"

static PanelChoice *add_choice(HouseSession *session, const char *name, const char *meaning) {
    PanelChoice *choice = &session->choices[session->choice_count];
    *choice =
        (PanelChoice){.name = name, .meaning = meaning, .options = session->choice_options[session->choice_count]};
    session->choice_count++;
    return choice;
}

/* Adds a word to a choice; `chosen`: the word is the present value. */
static void add_option(HouseSession *session, PanelChoice *choice, const char *word, bool chosen) {
    if (choice->count == HOUSE_CHOICE_OPTIONS)
        return;
    if (chosen)
        choice->chosen = choice->count;
    session->choice_options[choice - session->choices][choice->count++] = word;
}

static bool anybody_rides(const House *house) {
    for (size_t k = 0; k < house->profile_count; k++)
        if (house->profiles[k].driving != DRIVING_WALKER)
            return true;
    return false;
}

static void list(HouseSession *session) {
    bool rides = session->runs[RUN_SHOWN] && anybody_rides(&session->runs[RUN_SHOWN]->house);
    session->choice_count = 0;
    PanelChoice *ghost = add_choice(session, GHOST,
                                    "The run that is shown for comparison: the saved run, or the same house "
                                    "with the other driving model.");
    add_option(session, ghost, "none", session->ghost == GHOST_NONE);
    if (session->runs[RUN_BEFORE])
        add_option(session, ghost, "before", session->ghost == GHOST_BEFORE);
    if (rides)
        add_option(session, ghost, profile_driving_name(house_runs_other_driving(session)),
                   session->ghost == GHOST_RIVAL);
    const Plan *plan = draft_plan(session->draft);
    if (plan->route_count > 1) {
        PanelChoice *route = add_choice(session, ROUTE, "The routes in use: those of all people, or a single one.");
        add_option(session, route, "all people", !session->wish.route);
        for (size_t r = 0; r < plan->route_count; r++) {
            const char *id = plan->routes[r].id;
            add_option(session, route, id, session->wish.route && strcmp(session->wish.route, id) == 0);
        }
    }
    PanelChoice *edits = add_choice(session, EDITS,
                                    "The time from which an edit applies: the beginning, so that the whole run is of "
                                    "one plan, or the displayed time.");
    add_option(session, edits, "from the start", !session->changes_on_the_way);
    add_option(session, edits, "while it runs", session->changes_on_the_way);
    if (!rides)
        return;
    PanelChoice *driving = add_choice(session, DRIVING,
                                      "The driving model: that of each profile, a driver who turns the "
                                      "chair, or the paper's disc on straight legs and corners.");
    add_option(session, driving, "as in the file", session->wish.driving < 0);
    for (int model = DRIVING_DRIVER; model <= DRIVING_MIURA; model++)
        add_option(session, driving, profile_driving_name(model), session->wish.driving == model);
}

static void apply_ghost(HouseSession *session, const char *word) {
    session->ghost = strcmp(word, "none") == 0 ? GHOST_NONE : strcmp(word, "before") == 0 ? GHOST_BEFORE : GHOST_RIVAL;
    session->texts_are_stale = true;
    session->changed |= LABORATORY_TEXTS | LABORATORY_PLOTS;
    house_picture_void_film(session);
}

static const PanelChoice *list_choices(HouseSession *session, size_t *count) {
    list(session);
    *count = session->choice_count;
    return session->choices;
}

static void apply_choice(HouseSession *session, size_t choice, size_t word) {
    list(session);
    if (choice >= session->choice_count || word >= session->choices[choice].count)
        return;
    const PanelChoice *taken = &session->choices[choice];
    if (strcmp(taken->name, GHOST) == 0) {
        apply_ghost(session, taken->options[word]);
    } else if (strcmp(taken->name, ROUTE) == 0) {
        session->wish.route = word ? arena_text(&session->arena, taken->options[word]) : NULL;
        house_schedule_request(session);
    } else if (strcmp(taken->name, EDITS) == 0) {
        session->changes_on_the_way = word == 1;
    } else {
        session->wish.driving = (int)word - 1;
        editor_set_driving(session->editor, session->wish.driving);
        house_schedule_store(session, true);
        house_schedule_request(session);
    }
}

/* Runs ------------------------------------------------------------------------------------------------------------- */

const Preset *house_control_presets(const void *context, size_t *count) {
    (void)context;
    *count = 0;
    return NULL;
}

void house_control_apply_preset(void *context, size_t preset) {
    (void)context;
    (void)preset;
}

const PanelChoice *house_control_choices(void *context, size_t *count) {
    return list_choices(house_control_sync(context), count);
}

void house_control_choose(void *context, size_t choice, size_t word) {
    apply_choice(house_control_sync(context), choice, word);
}

/* Restarts the displayed run. A run is deterministic, so it is computed again only if it was stopped, diverged, or
 * contains a change of the plan. */
void house_control_restart(void *context) {
    HouseSession *session = house_control_sync(context);
    house_schedule_restart(session);
    if (session->error.text && !session->runs[RUN_LATEST])
        house_schedule_request(session);
}

bool house_control_save_run(void *context, double time) {
    HouseSession *session = house_control_sync(context);
    (void)time;
    session->changed |= LABORATORY_TEXTS | LABORATORY_PLOTS;
    return house_schedule_store(session, false);
}

void house_control_clear(void *context, double time) {
    (void)time;
    house_schedule_clear(house_control_sync(context));
}

/* The command line ------------------------------------------------------------------------------------------------- */

enum { WORDS = 8 /* besides settings: the verb, the file, and three options with their values */ };

/* True if the draft equals its file with these settings: no item was added, moved with the pointer or removed. */
static bool is_file_with(const HouseSession *session, const char *const *settings, size_t count) {
    const char *path = draft_file_path(session->draft);
    Fault none = {0};
    Plan plan = {0};
    bool same = path && plan_read(&plan, path, settings, count, &none);
    char *text = same ? plan_text(&plan) : NULL;
    same = text && strcmp(text, draft_text(session->draft)) == 0;
    memory_free(text);
    plan_free(&plan);
    fault_clear(&none);
    return same;
}

/* Returns the settings that turn the file into the draft (count): the settings at the opening and the later changes. */
static const char **make_settings(HouseSession *session, size_t *count) {
    const LaboratoryOptions *given = &session->given;
    const char **settings = memory_zeroed(given->setting_count + session->values.count + 1, sizeof *settings);
    *count = given->setting_count;
    for (size_t i = 0; i < given->setting_count; i++)
        settings[i] = given->settings[i];
    *count += house_value_settings(&session->values, settings + *count, &session->command_arena);
    return settings;
}

const char *const *house_control_command(void *context, size_t *count) {
    HouseSession *session = house_control_sync(context);
    const HouseWish *wish = &session->wish;
    Arena *arena = &session->command_arena;
    arena_clear(arena);
    memory_free(session->command);
    size_t setting_count, used = 0;
    const char **settings = make_settings(session, &setting_count);
    const char **words = memory_zeroed(WORDS + 2 * setting_count, sizeof *words);
    bool whole = is_file_with(session, NULL, 0), made = !whole && is_file_with(session, settings, setting_count);
    words[used++] = "run";
    words[used++] = whole || made ? draft_file_path(session->draft) : "";
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
    session->command = words;
    *count = used;
    return words;
}
