#include "laboratory/house/schedule.h"

#include <math.h>
#include <string.h>

#include "base/stopwatch.h"
#include "base/stop.h"
#include "laboratory/house/picture.h"
#include "visual/house/people_scene.h"

#define GRACE 0.3 /* s: a run may take this long before its first part is displayed or it is stopped */
#define EARLY                                                                                                          \
    0.15             /* s: the plan is drawn before the answer, and the old run disappears, if the answer takes longer \
                      */
#define PARTLY 2.0   /* s: after an edit, an incomplete run is displayed only if it takes longer */
#define TAKE_PART 16 /* new rows are copied once they make up 1/16 of the record, so total copying stays linear */
#define TAKE_NEAR 1.0 /* s: or once the displayed time is this close to the end of the record */

/* Requests -------------------------------------------------------------------------------------------------------- */

/* Requests the latest run, in brief or with the reasons why a person cannot leave. */
static void ask_for_run(HouseSession *session, bool brief) {
    HouseRun *latest = session->runs[RUN_LATEST];
    house_runs_set(session, RUN_CREW, NULL);
    if (latest && house_run_stage(latest) != HOUSE_WAITS)
        house_runs_set(session, RUN_OLDER, latest);
    house_runs_set(session, RUN_LATEST, NULL);
    if ((session->runs[RUN_RIVAL] && !house_runs_is_over(session, RUN_RIVAL)) ||
        (session->runs[RUN_ROUTES] && !house_runs_is_over(session, RUN_ROUTES))) {
        house_runs_drop(session, RUNS_DISPLAY); /* the worker must compute the latest run first */
        house_picture_void_film(session);
    }
    house_runs_ask(session, RUN_LATEST, brief);
    session->changed |= LABORATORY_PARAMETERS;
}

/* Requests the answer first; the reasons follow when the worker is free. */
void house_schedule_request(HouseSession *session) {
    ask_for_run(session, true);
}

/* Drops the requested runs. */
static void forget_asked(HouseSession *session) {
    house_runs_drop(session, RUNS_ANSWER);
    session->changed |= LABORATORY_TEXTS | LABORATORY_PARAMETERS;
}

/* True if the displayed run is over and has the present history. */
static bool is_up_to_date(const HouseSession *session) {
    return session->whole &&
           house_runs_is_of(session, session->runs[RUN_SHOWN], session->history.at, session->history.count);
}

/* True if people move at the displayed time and an edit applies from there on. */
static bool is_under_way(const HouseSession *session) {
    return session->changes_on_the_way && session->runs[RUN_SHOWN] && session->time > 0 &&
           session->time < session->observation->time;
}

/* Adds the draft to the history. A completed edit applies at the displayed time if that is wanted, otherwise from the
 * beginning on, as a gesture in progress does. */
static void note_history(HouseSession *session) {
    const char *text = draft_text(session->draft);
    uint64_t revision = draft_revision(session->draft);
    if (is_under_way(session))
        house_history_change(&session->history, session->time, text, revision);
    else if (session->history.at[session->history.count - 1].revision != revision)
        house_history_begin(&session->history, text, revision);
}

/* True if a run of this plan alone, with the present wish, was requested last and is not stopped. */
static bool is_requested(const HouseSession *session, const HouseEpoch *plan) {
    HouseRun *run = session->runs[RUN_LATEST] ? session->runs[RUN_LATEST] : session->runs[RUN_SHOWN];
    return house_runs_is_of(session, run, plan, 1) && !stop_requested(&run->stop) && house_run_stage(run) < HOUSE_OVER;
}

/* Requests the runs that the answer and the display still need. */
static void ask_missing(HouseSession *session) {
    HouseEpoch now = {0, NULL, draft_revision(session->draft)};
    bool mixed = session->history.count > 1 && !draft_is_open(session->draft);
    house_runs_drop(session, RUNS_EDIT);
    if (mixed) {
        forget_asked(session);
        if (!is_up_to_date(session))
            house_runs_ask(session, RUN_MIXED, false);
    } else if (!mixed && session->whole && house_runs_is_of(session, session->runs[RUN_SHOWN], &now, 1)) {
        forget_asked(session);
    } else if (!is_requested(session, &now)) {
        house_schedule_request(session);
    }
}

void house_schedule_apply_edit(HouseSession *session) {
    if (session->wish.route && plan_find_route(draft_plan(session->draft), session->wish.route) == SIZE_MAX)
        session->wish.route = NULL;
    if (session->runs[RUN_SHOWN] && house_run_revision(session->runs[RUN_SHOWN]) != draft_revision(session->draft))
        house_schedule_store(session, true);
    if (!draft_is_open(session->draft))
        note_history(session);
    session->changed |= LABORATORY_PARAMETERS;
    ask_missing(session);
    session->undone |=
        session->runs[RUN_SHOWN] && house_run_revision(session->runs[RUN_SHOWN]) == draft_revision(session->draft);
    if (session->stored_by_itself && house_run_revision(session->runs[RUN_BEFORE]) == draft_revision(session->draft))
        house_schedule_clear(session); /* nothing has changed */
}

void house_schedule_restart(HouseSession *session) {
    if (session->history.count < 2)
        return;
    house_history_begin(&session->history, draft_text(session->draft), draft_revision(session->draft));
    ask_missing(session);
}

/* True if people take part in the displayed run, and each of them has room to stand and an exit to go to: earlier plans
 * of a new house are not worth comparing with. */
static bool is_answered(const HouseSession *session) {
    bool answered = false;
    for (size_t i = 0; i < session->observation->person_count; i++) {
        const PersonObservation *person = &session->observation->people[i];
        if (person->took_part && (person->reason == REASON_NO_EXIT ||
                                  (person->reason == REASON_CANNOT_PASS && census_start(&person->blockage))))
            return false;
        answered |= person->took_part;
    }
    return answered;
}

/* True if the displayed run is worth being kept by itself: an answer for a plan that somebody left, not for one that a
 * gesture in progress passed through. */
static bool is_worth_keeping(const HouseSession *session) {
    uint64_t left = session->history.at[session->history.count - 1].revision;
    return !session->runs[RUN_BEFORE] && house_run_revision(session->runs[RUN_SHOWN]) == left && is_answered(session);
}

bool house_schedule_store(HouseSession *session, bool by_itself) {
    if (!session->whole || (by_itself && !is_worth_keeping(session)))
        return false;
    house_runs_set(session, RUN_BEFORE, session->runs[RUN_SHOWN]);
    session->stored_by_itself = by_itself;
    session->ghost = by_itself && session->ghost != GHOST_NONE ? session->ghost : GHOST_BEFORE;
    session->texts_are_stale = true;
    house_picture_void_film(session);
    return true;
}

void house_schedule_clear(HouseSession *session) {
    house_runs_set(session, RUN_BEFORE, NULL);
    session->stored_by_itself = false;
    session->ghost = session->ghost == GHOST_BEFORE ? GHOST_NONE : session->ghost;
    session->texts_are_stale = true;
    session->changed |= LABORATORY_TEXTS | LABORATORY_PLOTS;
    house_picture_void_film(session);
}

/* Errors ---------------------------------------------------------------------------------------------------------- */

static void report_error(HouseSession *session, double time) {
    session->error_time = time;
    session->changed |= LABORATORY_ERROR | LABORATORY_TEXTS;
}

static void clear_error(HouseSession *session) {
    memory_free(session->error.text);
    session->error = (Text){0};
    session->changed |= LABORATORY_TEXTS;
}

/* Reports each person whose numbers diverged, with the time and a remedy. */
static void report_divergence(HouseSession *session) {
    for (size_t i = 0; i < session->observation->person_count; i++) {
        const PersonObservation *person = &session->observation->people[i];
        const Inhabitant *who = &session->runs[RUN_SHOWN]->house.people[i];
        if (person->reason != REASON_DIVERGED)
            continue;
        if (session->error.used)
            text_add(&session->error, "\n");
        text_format(
            &session->error,
            "the numbers of person %s diverged at %.3f s; the run ends with the last valid state. Use a smaller "
            "run.dt or a softer contact of %s",
            who->id, person->time, who->profile->name);
        report_error(session, person->time);
    }
}

/* Returns the line of an error without its place: it was found in the text of the draft, not in the file. */
static const char *without_place(const HouseSession *session, const char *line) {
    size_t length = strlen(session->wish.path);
    if (strncmp(line, session->wish.path, length) != 0)
        return line;
    const char *rest = line + length + strspn(line + length, ":0123456789");
    return *rest == ' ' ? rest + 1 : line;
}

/* Undoes an edit that made the plan invalid, and restarts the displayed run if it was cancelled. */
static void undo_invalid(HouseSession *session, HouseRun *run) {
    clear_error(session);
    for (size_t i = 0; i < run->fault.count; i++)
        text_format(&session->error, "%s%s", i ? "\n" : "", without_place(session, run->fault.lines[i]));
    report_error(session, NAN);
    session->changed |= LABORATORY_PARAMETERS;
    if (!session->runs[RUN_SHOWN]) {
        house_picture_make_plain(session);
        return;
    }
    uint64_t revision = house_run_revision(run);
    bool undone = !draft_is_open(session->draft) && revision == draft_revision(session->draft) &&
                  revision != house_run_revision(session->runs[RUN_SHOWN]) && draft_undo(session->draft);
    if (undone)
        note_history(session);
    session->wish.driving = session->runs[RUN_SHOWN]->wish.driving;
    editor_set_driving(session->editor, session->wish.driving);
    house_value_rebuild(&session->values, &session->opened, &session->runs[RUN_SHOWN]->house);
    if ((undone && !is_up_to_date(session)) ||
        (!session->whole && house_run_stage(session->runs[RUN_SHOWN]) == HOUSE_STOPPED))
        ask_missing(session);
}

/* Display --------------------------------------------------------------------------------------------------------- */

/* Reselects by id; a dangerous point does not survive a new run. */
static void reselect(HouseSession *session, const House *before, const House *now) {
    Item item = session->selected;
    session->selected = (Item){0, 0};
    editor_set_selected(session->editor, session->selected);
    if (item.kind == HOUSE_HAZARD || item.index >= house_item_count(before, NULL, item.kind))
        return;
    session->selected = house_item_find(now, item.kind, house_item_id(before, item));
    editor_set_selected(session->editor, session->selected);
}

/* Completes the displayed run: its own observation replaces the growing one. */
static void finish(HouseSession *session) {
    house_picture_void_film(session);
    trail_clear(&session->trails);
    observation_free(&session->growing);
    session->whole = true;
    session->observation = &session->runs[RUN_SHOWN]->observation;
    trail_grow(&session->trails, session->observation);
    report_divergence(session);
    session->texts_are_stale = true;
    session->changed |= LABORATORY_TEXTS | LABORATORY_PLOTS;
}

/* Forgets the saved run that was saved automatically if it is of other people. */
static void drop_other_people(HouseSession *session, const House *house) {
    if (session->stored_by_itself && !house_run_alike(&session->runs[RUN_BEFORE]->house, house))
        house_schedule_clear(session);
}

/* Displays another run, from its beginning unless it only continues the displayed one. */
static void swap_in(HouseSession *session, HouseRun *run) {
    const HouseRun *last = session->runs[RUN_SHOWN];
    if (last && run->wish.epoch_count == 1 && house_runs_identity(run) != house_runs_identity(last))
        session->changed |= LABORATORY_RESTART;
    drop_other_people(session, &run->house);
    session->edited = NAN;
    session->settles = false;
    house_picture_void_film(session);
    trail_clear(&session->trails);
    observation_free(&session->growing);
    clear_error(session);
    if (last)
        reselect(session, &last->house, &run->house);
    house_runs_set(session, RUN_SHOWN, run);
    house_runs_set(session, RUN_EARLY, NULL);
    session->whole = false;
    session->growing = house_run_begin(run);
    session->observation = &session->growing;
    house_runs_drop(session, RUNS_DISPLAY);
    if (house_run_stage(run) == HOUSE_OVER) {
        finish(session);
    } else {
        house_run_copy_rows(run, &session->growing, 1);
        trail_grow(&session->trails, session->observation);
    }
    if (!session->opened.count)
        house_value_list(&session->opened, &run->house);
    if (!editor_drags_number(session->editor) &&
        house_run_revision(run) == draft_revision(session->draft)) /* otherwise the sliders are ahead of the run */
        house_value_rebuild(&session->values, &session->opened, &run->house);
    session->texts_are_stale = true;
    session->changed |= LABORATORY_ALL & ~LABORATORY_ERROR;
}

/* Updates --------------------------------------------------------------------------------------------------------- */

/* True if a requested run can be displayed. */
static bool is_ready(HouseSession *session, HouseRun *run, double time) {
    HouseStage stage = house_run_stage(run);
    if (stage == HOUSE_OVER || (!session->runs[RUN_SHOWN] && (stage == HOUSE_PLANS || stage == HOUSE_DRIVES)))
        return true;
    double patience = session->runs[RUN_SHOWN] ? PARTLY : GRACE;
    return stage == HOUSE_DRIVES && house_run_age(run) > patience && house_run_reach(run) > time + TAKE_NEAR;
}

static void update_asked(HouseSession *session, HouseRunRole role, double time) {
    HouseRun *run = session->runs[role];
    if (!run)
        return;
    bool latest = role == RUN_LATEST;
    HouseStage stage = house_run_stage(run);
    if (stage == HOUSE_FAILED || stage == HOUSE_STOPPED) {
        house_runs_retain(run);
        house_runs_set(session, role, NULL);
        if (latest && stage == HOUSE_FAILED)
            undo_invalid(session, run);
        house_runs_release(session, run);
    } else if (is_ready(session, run, time)) {
        if (latest)
            house_runs_set(session, RUN_OLDER, NULL);
        swap_in(session, run);
        house_runs_set(session, role, NULL);
    }
}

/* Limits the time for which the latest request waits: a run begun before it may end, so that a result is seen while
 * a slider moves, but not for long. */
static void hurry(HouseSession *session) {
    if (!session->runs[RUN_LATEST] || house_run_stage(session->runs[RUN_LATEST]) != HOUSE_WAITS)
        return;
    if (session->runs[RUN_OLDER] && house_run_age(session->runs[RUN_OLDER]) > GRACE)
        house_runs_set(session, RUN_OLDER, NULL);
    if (session->runs[RUN_SHOWN] && !session->whole)
        stop_request(&session->runs[RUN_SHOWN]->stop);
}

static void update_shown(HouseSession *session, double time) {
    if (!session->runs[RUN_SHOWN] || session->whole)
        return;
    if (house_run_stage(session->runs[RUN_SHOWN]) == HOUSE_OVER) {
        finish(session);
        return;
    }
    bool near = time + TAKE_NEAR > house_runs_reach(session);
    size_t least = near ? 1 : session->observation->trace.rows / TAKE_PART + 1;
    if (!house_run_copy_rows(session->runs[RUN_SHOWN], &session->growing, least))
        return;
    trail_grow(&session->trails, session->observation);
    if (session->film && !session->film_is_stale)
        film_extend(session->film);
    house_picture_make_plots(session, false);
    if (stopwatch_now() - session->texts.said > GRACE) {
        session->texts_are_stale = true;
        session->changed |= LABORATORY_TEXTS;
    }
}

/* Requests a companion of the displayed run if it is wanted and missing; true: it has just been completed. */
static bool update_companion(HouseSession *session, HouseRunRole role) {
    if (!house_runs_wants(session, role) || house_runs_is_over(session, role))
        return false;
    if (!session->runs[role])
        house_runs_ask(session, role, false);
    session->runs[role]->noticed = house_run_stage(session->runs[role]) == HOUSE_OVER;
    return session->runs[role]->noticed;
}

/* Shows the drivers of the last complete step. */
static void update_crew(HouseSession *session) {
    bool wanted = house_runs_wants(session, RUN_CREW);
    if (!wanted && session->runs[RUN_CREW] && !house_runs_is_over(session, RUN_CREW))
        house_runs_set(session, RUN_CREW, NULL);
    update_companion(session, RUN_CREW);
    const Crew *crew = wanted && session->runs[RUN_CREW] ? house_run_crew(session->runs[RUN_CREW]) : NULL;
    if (crew == session->crew)
        return;
    session->crew = crew;
    house_picture_void_film(session);
    session->changed |= LABORATORY_TEXTS;
}

/* Shows the earthquakes of the last complete step. They are of the house as it stood, and stay while it is shaken
 * again; whatever else the worker has to do comes first. */
static void update_shakes(HouseSession *session) {
    const HouseRun *run = session->runs[RUN_SHAKES];
    bool over = house_runs_is_over(session, RUN_SHAKES), wanted = house_runs_wants(session, RUN_SHAKES);
    bool later = (house_runs_wants(session, RUN_GRADES) && !house_runs_is_over(session, RUN_GRADES)) ||
                 (house_runs_wants(session, RUN_CREW) && !house_runs_is_over(session, RUN_CREW));
    EditorShake shake;
    bool holds = wanted && editor_last_shake(session->editor, &shake) && shake.standing == session->standing;
    if (run && (!holds || !house_runs_is_wished(session, run) || (later && !over)))
        house_runs_set(session, RUN_SHAKES, NULL);
    if (!later)
        update_companion(session, RUN_SHAKES);
    const Outlook *outlook = session->runs[RUN_SHAKES] ? house_run_outlook(session->runs[RUN_SHAKES]) : NULL;
    session->changed |= outlook != session->outlook ? LABORATORY_TEXTS : 0;
    session->outlook = outlook;
}

static void update_companions(HouseSession *session) {
    if (!session->whole || session->runs[RUN_LATEST] || session->runs[RUN_MIXED])
        return;
    if (update_companion(session, RUN_RIVAL)) {
        house_picture_void_film(session);
        session->texts_are_stale = true;
        session->changed |= LABORATORY_TEXTS | LABORATORY_PLOTS;
    }
    if (update_companion(session, RUN_ROUTES))
        house_picture_void_film(session);
    if (update_companion(session, RUN_GRADES))
        session->changed |= LABORATORY_TEXTS;
    update_crew(session);
    update_shakes(session);
}

/* Draws walls and furniture before the answer if the answer takes long: as soon as the house is read, if it has the
 * same people. */
static void update_plan(HouseSession *session) {
    HouseRun *run = session->runs[RUN_LATEST];
    if (!run || run == session->runs[RUN_EARLY] || !session->runs[RUN_SHOWN] || house_run_age(run) < EARLY)
        return;
    HouseStage stage = house_run_stage(run);
    if ((stage == HOUSE_PLANS || stage == HOUSE_DRIVES) &&
        house_run_alike(&run->house, &session->runs[RUN_SHOWN]->house))
        house_runs_set(session, RUN_EARLY, run);
}

/* Searches for the reasons why a person cannot leave, unless an edit is in progress. */
static void update_reasons(HouseSession *session) {
    const HouseRun *run = session->runs[RUN_SHOWN];
    if (session->whole && run->wish.brief && !run->observation.completed && !session->runs[RUN_LATEST] &&
        !draft_is_open(session->draft))
        ask_for_run(session, false);
}

/* Stops displaying the old run as if it held when the newest one takes longer than EARLY. */
static void update_settling(HouseSession *session) {
    bool working = house_runs_is_working(session);
    if (!working)
        session->edited = NAN;
    else if (isnan(session->edited))
        session->edited = stopwatch_now();
    bool settles = working && stopwatch_now() - session->edited > EARLY;
    if (settles == session->settles)
        return;
    session->settles = settles;
    session->changed |= LABORATORY_TEXTS | LABORATORY_PLOTS;
    session->changed |= settles && !session->runs[RUN_MIXED] ? LABORATORY_RESTART : 0;
    session->texts_are_stale = true;
    house_picture_void_film(session);
}

void house_schedule_stop(HouseSession *session) {
    if (!house_runs_is_working(session) || draft_is_open(session->draft))
        return;
    forget_asked(session);
    house_runs_drop(session, RUNS_EDIT);
    while (draft_revision(session->draft) != house_run_revision(session->runs[RUN_SHOWN]) && draft_undo(session->draft))
        ;
    note_history(session);
    session->wish.driving = session->runs[RUN_SHOWN]->wish.driving;
    session->wish.route =
        session->runs[RUN_SHOWN]->wish.route ? arena_text(&session->arena, session->runs[RUN_SHOWN]->wish.route) : NULL;
    editor_set_driving(session->editor, session->wish.driving);
    house_value_rebuild(&session->values, &session->opened, &session->runs[RUN_SHOWN]->house);
    session->changed |= LABORATORY_PARAMETERS;
    session->texts_are_stale = true;
    if (!is_up_to_date(session))
        ask_missing(session);
}

/* The numbers of a change that was undone before its run was shown are those of the shown run again. */
static void take_back_numbers(HouseSession *session) {
    if (!session->undone || editor_drags_number(session->editor))
        return;
    session->undone = false;
    if (house_run_revision(session->runs[RUN_SHOWN]) != draft_revision(session->draft))
        return;
    house_value_rebuild(&session->values, &session->opened, &session->runs[RUN_SHOWN]->house);
    session->changed |= LABORATORY_PARAMETERS;
}

void house_schedule_update(HouseSession *session, double time) {
    take_back_numbers(session);
    update_asked(session, RUN_OLDER, time);
    update_asked(session, RUN_LATEST, time);
    update_asked(session, RUN_MIXED, time);
    hurry(session);
    update_plan(session);
    update_shown(session, time);
    update_reasons(session);
    update_companions(session);
    update_settling(session);
}

void house_schedule_end(HouseSession *session) {
    house_runs_drop(session, RUNS_CLOSE);
    house_worker_destroy(session->worker);
    house_worker_destroy(session->crew_worker);
    trail_clear(&session->trails);
    observation_free(&session->growing);
}
