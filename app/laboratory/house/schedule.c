#include "laboratory/house/schedule.h"

#include <string.h>

#include "base/clock.h"
#include "base/parallel.h"
#include "visual/house/people_scene.h"

#define GRACE 0.3    /* s: a run that is over within so much is waited for before anything of it is shown, or stopped */
#define EARLY 0.15   /* s: an answer that takes longer is not waited for before the plan is drawn */
#define TAKE_PART 16 /* rows are taken over when they are such a part of all, so that this costs little in sum */
#define TAKE_NEAR 1.0 /* s: or when what is shown comes so near to the end */

/* Asking ---------------------------------------------------------------------------------------------------------- */

/* Asks for the latest run, in brief or with the reasons why somebody cannot leave. */
static void ask_for_run(HouseSession *live, bool brief) {
    HouseRun *latest = live->runs[RUN_LATEST];
    if (latest && house_run_stage(latest) != HOUSE_WAITS)
        house_runs_set(live, RUN_OLDER, latest);
    house_runs_set(live, RUN_LATEST, NULL);
    if ((live->runs[RUN_RIVAL] && !house_runs_is_over(live, RUN_RIVAL)) ||
        (live->runs[RUN_ROUTES] && !house_runs_is_over(live, RUN_ROUTES))) {
        house_runs_drop(live, RUNS_DISPLAY); /* the worker has something else to do */
        house_session_void_film(live);
    }
    house_runs_ask(live, RUN_LATEST, brief);
    live->changed |= LABORATORY_PARAMETERS;
}

/* The answer comes first; the reasons follow when the worker is free. */
void house_schedule_request(HouseSession *live) {
    ask_for_run(live, true);
}

/* Drops the runs that were asked for. */
static void forget_asked(HouseSession *live) {
    house_runs_drop(live, RUNS_ANSWER);
    live->changed |= LABORATORY_WORDS | LABORATORY_PARAMETERS;
}

/* Sets the run of the answer; NULL: the displayed one. */
static void set_clean(HouseSession *live, HouseRun *run) {
    house_runs_set(live, RUN_CLEAN, run);
    live->retell = true;
    live->changed |= LABORATORY_WORDS;
}

/* True if the displayed run is over and has the present history. */
static bool is_up_to_date(const HouseSession *live) {
    return live->whole && house_runs_is_of(live, live->runs[RUN_SHOWN], live->history.at, live->history.count);
}

/* True if people move at the displayed time: then an edit applies from there on. */
static bool is_under_way(const HouseSession *live) {
    return live->runs[RUN_SHOWN] && live->time > 0 && live->time < live->observation->time;
}

/* A completed edit applies at the displayed time; a gesture in progress is shown from the beginning on. */
static void note_history(HouseSession *live) {
    const char *text = draft_text(live->draft);
    uint64_t revision = draft_revision(live->draft);
    if (is_under_way(live))
        house_history_change(&live->history, live->time, text, revision);
    else if (live->history.at[live->history.count - 1].revision != revision)
        house_history_begin(&live->history, text, revision);
}

/* Asks for the runs that the answer and the display still need. */
static void ask_missing(HouseSession *live) {
    HouseEpoch now = {0, NULL, draft_revision(live->draft)};
    bool mixed = live->history.count > 1 && !draft_is_open(live->draft);
    house_runs_drop(live, RUNS_EDIT);
    if (mixed && live->whole && house_runs_is_of(live, live->runs[RUN_SHOWN], &now, 1))
        set_clean(live, live->runs[RUN_SHOWN]);
    if (mixed && house_runs_is_of(live, live->runs[RUN_CLEAN], &now, 1)) {
        forget_asked(live);
        if (!is_up_to_date(live))
            house_runs_ask(live, RUN_MIXED, true);
    } else if (!mixed && live->whole && house_runs_is_of(live, live->runs[RUN_SHOWN], &now, 1)) {
        forget_asked(live);
        set_clean(live, NULL);
    } else {
        house_schedule_request(live);
    }
}

void house_schedule_apply_edit(HouseSession *live) {
    if (live->wish.route && plan_find_route(draft_plan(live->draft), live->wish.route) == SIZE_MAX)
        live->wish.route = NULL;
    if (live->runs[RUN_SHOWN] && house_run_revision(live->runs[RUN_SHOWN]) != draft_revision(live->draft))
        house_schedule_store(live, true);
    if (!draft_is_open(live->draft))
        note_history(live);
    ask_missing(live);
    if (live->kept_itself && house_run_revision(live->runs[RUN_BEFORE]) == draft_revision(live->draft))
        house_schedule_clear(live); /* all is as before */
}

void house_schedule_restart(HouseSession *live) {
    if (live->history.count < 2)
        return;
    house_history_begin(&live->history, draft_text(live->draft), draft_revision(live->draft));
    ask_missing(live);
}

bool house_schedule_store(HouseSession *live, bool by_itself) {
    if (!live->whole || (by_itself && (live->runs[RUN_BEFORE] || !live->runs[RUN_SHOWN]->house.person_count)))
        return false;
    house_runs_set(live, RUN_BEFORE, live->runs[RUN_SHOWN]);
    live->kept_itself = by_itself;
    live->ghost = by_itself && live->ghost != GHOST_NONE ? live->ghost : GHOST_BEFORE;
    live->retell = true;
    house_session_void_film(live);
    return true;
}

void house_schedule_clear(HouseSession *live) {
    house_runs_set(live, RUN_BEFORE, NULL);
    live->kept_itself = false;
    live->ghost = live->ghost == GHOST_BEFORE ? GHOST_NONE : live->ghost;
    live->retell = true;
    live->changed |= LABORATORY_WORDS | LABORATORY_PLOTS;
    house_session_void_film(live);
}

/* Trouble --------------------------------------------------------------------------------------------------------- */

static void say_trouble(HouseSession *live, double time) {
    live->trouble_time = time;
    live->changed |= LABORATORY_TROUBLE | LABORATORY_WORDS;
}

static void clear_trouble(HouseSession *live) {
    memory_free(live->trouble.text);
    live->trouble = (Text){0};
    live->changed |= LABORATORY_WORDS;
}

/* Reports each person whose numbers diverged, when, and what would help. */
static void tell_divergence(HouseSession *live) {
    for (size_t i = 0; i < live->observation->person_count; i++) {
        const PersonObservation *person = &live->observation->people[i];
        const Inhabitant *who = &live->runs[RUN_SHOWN]->house.people[i];
        if (person->reason != REASON_DIVERGED)
            continue;
        text_format(&live->trouble,
                    "%sthe numbers of person %s diverged at %.3f s, the run ends with the last good state: smaller "
                    "run.dt or softer contact of %s would help",
                    live->trouble.used ? "\n" : "", who->id, person->time, who->profile->name);
        say_trouble(live, person->time);
    }
}

/* The edited plan is invalid: undoes the edit, and restarts the displayed run if it was cancelled.
 */
static void undo_invalid(HouseSession *live, HouseRun *run) {
    clear_trouble(live);
    for (size_t i = 0; i < run->fault.count; i++)
        text_format(&live->trouble, "%s%s", i ? "\n" : "", run->fault.lines[i]);
    say_trouble(live, NAN);
    live->changed |= LABORATORY_PARAMETERS;
    if (!live->runs[RUN_SHOWN])
        return;
    uint64_t revision = house_run_revision(run);
    bool undone = !draft_is_open(live->draft) && revision == draft_revision(live->draft) &&
                  revision != house_run_revision(live->runs[RUN_SHOWN]) && draft_undo(live->draft);
    if (undone)
        note_history(live);
    live->wish.driving = live->runs[RUN_SHOWN]->wish.driving;
    editor_set_driving(live->editor, live->wish.driving);
    house_value_list_again(&live->values, &live->opened, &live->runs[RUN_SHOWN]->house);
    if ((undone && !is_up_to_date(live)) || (!live->whole && house_run_stage(live->runs[RUN_SHOWN]) == HOUSE_STOPPED))
        ask_missing(live);
}

/* What is shown --------------------------------------------------------------------------------------------------- */

/* Reselects by id; a dangerous point does not survive a new run. */
static void select_again(HouseSession *live, const House *before, const House *now) {
    Item thing = live->selected;
    live->selected = (Item){0, 0};
    editor_set_selected(live->editor, live->selected);
    if (thing.kind == HOUSE_HAZARD || thing.index >= house_item_count(before, NULL, thing.kind))
        return;
    live->selected = house_item_find(now, thing.kind, house_item_id(before, thing));
    editor_set_selected(live->editor, live->selected);
}

/* The displayed run is over: its own observation replaces the growing one. */
static void finish(HouseSession *live) {
    house_session_void_film(live);
    trail_clear(&live->trails);
    observation_free(&live->growing);
    live->whole = true;
    live->observation = &live->runs[RUN_SHOWN]->observation;
    trail_grow(&live->trails, live->observation);
    tell_divergence(live);
    live->retell = true;
    live->changed |= LABORATORY_WORDS | LABORATORY_PLOTS;
}

/* Displays another run. */
static void swap_in(HouseSession *live, HouseRun *run) {
    const HouseRun *last = live->runs[RUN_SHOWN];
    house_session_void_film(live);
    trail_clear(&live->trails);
    observation_free(&live->growing);
    clear_trouble(live);
    if (last)
        select_again(live, &last->house, &run->house);
    house_runs_set(live, RUN_SHOWN, run);
    house_runs_set(live, RUN_EARLY, NULL);
    live->whole = false;
    live->growing = house_run_begin(run);
    live->observation = &live->growing;
    house_runs_drop(live, RUNS_DISPLAY);
    if (house_run_stage(run) == HOUSE_OVER) {
        finish(live);
    } else {
        house_run_take(run, &live->growing, 1);
        trail_grow(&live->trails, live->observation);
    }
    if (!live->opened.count)
        house_value_list(&live->opened, &run->house);
    if (!editor_holds_number(live->editor) &&
        house_run_revision(run) == draft_revision(live->draft)) /* else the sliders are ahead of the run */
        house_value_list_again(&live->values, &live->opened, &run->house);
    live->retell = true;
    live->changed |= LABORATORY_ALL & ~LABORATORY_TROUBLE;
}

/* Following ------------------------------------------------------------------------------------------------------- */

/* True if a run that was asked for can be displayed. */
static bool is_ready(HouseSession *live, HouseRun *run, double time) {
    HouseStage stage = house_run_stage(run);
    if (stage == HOUSE_OVER || (!live->runs[RUN_SHOWN] && (stage == HOUSE_PLANS || stage == HOUSE_DRIVES)))
        return true;
    return stage == HOUSE_DRIVES && house_run_age(run) > GRACE && house_run_reach(run) > time + TAKE_NEAR;
}

/* True if a run only gives the answer to an edit while people move: the mixed run is displayed instead. */
static bool is_answer_only(const HouseSession *live, const HouseRun *run) {
    return live->history.count > 1 && !draft_is_open(live->draft) &&
           house_run_revision(run) == draft_revision(live->draft);
}

static void update_asked(HouseSession *live, HouseRunRole role, double time) {
    HouseRun *run = live->runs[role];
    if (!run)
        return;
    bool latest = role == RUN_LATEST;
    HouseStage stage = house_run_stage(run);
    if (stage == HOUSE_FAILED || stage == HOUSE_STOPPED) {
        house_runs_retain(run);
        house_runs_set(live, role, NULL);
        if (latest && stage == HOUSE_FAILED)
            undo_invalid(live, run);
        house_runs_release(live, run);
    } else if (latest && is_answer_only(live, run)) {
        if (stage != HOUSE_OVER)
            return;
        set_clean(live, run);
        house_runs_set(live, role, NULL);
        ask_missing(live);
    } else if (is_ready(live, run, time)) {
        if (latest)
            house_runs_set(live, RUN_OLDER, NULL);
        if (role != RUN_MIXED)
            set_clean(live, NULL);
        swap_in(live, run);
        house_runs_set(live, role, NULL);
    }
}

/* A run begun before the latest was asked for may end, so that a result is seen while a slider moves, but not for
 * long. */
static void hurry(HouseSession *live) {
    if (!live->runs[RUN_LATEST] || house_run_stage(live->runs[RUN_LATEST]) != HOUSE_WAITS)
        return;
    if (live->runs[RUN_OLDER] && house_run_age(live->runs[RUN_OLDER]) > GRACE)
        house_runs_set(live, RUN_OLDER, NULL);
    if (live->runs[RUN_SHOWN] && !live->whole)
        parallel_stop(&live->runs[RUN_SHOWN]->stop);
}

static void update_shown(HouseSession *live, double time) {
    if (!live->runs[RUN_SHOWN] || live->whole)
        return;
    if (house_run_stage(live->runs[RUN_SHOWN]) == HOUSE_OVER) {
        finish(live);
        return;
    }
    bool near = time + TAKE_NEAR > house_runs_reach(live);
    size_t least = near ? 1 : live->observation->trace.rows / TAKE_PART + 1;
    if (!house_run_take(live->runs[RUN_SHOWN], &live->growing, least))
        return;
    trail_grow(&live->trails, live->observation);
    if (live->film && !live->film_is_stale)
        film_extend(live->film);
    house_session_plots_make(live, false);
    if (clock_now() - live->words.said > GRACE) {
        live->retell = true;
        live->changed |= LABORATORY_WORDS;
    }
}

/* Asks for a companion of the displayed run if it is wanted and not there; true: it has come just now. */
static bool update_companion(HouseSession *live, HouseRunRole role) {
    if (!house_runs_wants(live, role) || house_runs_is_over(live, role))
        return false;
    if (!live->runs[role])
        house_runs_ask(live, role, false);
    live->runs[role]->noticed = house_run_stage(live->runs[role]) == HOUSE_OVER;
    if (live->runs[role]->noticed)
        house_session_void_film(live);
    return live->runs[role]->noticed;
}

static void update_companions(HouseSession *live) {
    if (!live->whole || live->runs[RUN_LATEST] || live->runs[RUN_MIXED])
        return;
    if (update_companion(live, RUN_RIVAL)) {
        live->retell = true;
        live->changed |= LABORATORY_WORDS | LABORATORY_PLOTS;
    }
    update_companion(live, RUN_ROUTES);
}

/* If the answer takes long, walls and furniture are drawn before it: as soon as the house is read, with the same
 * people in it. */
static void update_plan(HouseSession *live) {
    HouseRun *run = live->runs[RUN_LATEST];
    if (!run || run == live->runs[RUN_EARLY] || !live->runs[RUN_SHOWN] || house_run_age(run) < EARLY)
        return;
    HouseStage stage = house_run_stage(run);
    if ((stage == HOUSE_PLANS || stage == HOUSE_DRIVES) && house_run_alike(&run->house, &live->runs[RUN_SHOWN]->house))
        house_runs_set(live, RUN_EARLY, run);
}

/* Looks for the reasons why somebody cannot leave, unless an edit is in progress. */
static void update_reasons(HouseSession *live) {
    const HouseRun *run = house_runs_answering(live);
    bool whole = live->runs[RUN_CLEAN] || live->whole;
    if (whole && run->wish.brief && !run->observation.completed && !live->runs[RUN_LATEST] &&
        !draft_is_open(live->draft))
        ask_for_run(live, false);
}

void house_schedule_update(HouseSession *live, double time) {
    update_asked(live, RUN_OLDER, time);
    update_asked(live, RUN_LATEST, time);
    update_asked(live, RUN_MIXED, time);
    hurry(live);
    update_plan(live);
    update_shown(live, time);
    update_reasons(live);
    update_companions(live);
}

void house_schedule_end(HouseSession *live) {
    house_runs_drop(live, RUNS_CLOSE);
    house_worker_destroy(live->worker);
    trail_clear(&live->trails);
    observation_free(&live->growing);
}
