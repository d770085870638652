/* What is in work for a house that is shown, and what takes the place of what: the runs that have been asked for, the
 * one shown, the one before, the rival, the planned ways. */
#include <string.h>

#include "base/clock.h"
#include "base/parallel.h"
#include "laboratory/house/session_parts.h"
#include "visual/house/people_scene.h"

#define GRACE 0.3    /* s: a run that is over within so much is waited for before anything of it is shown, or stopped */
#define EARLY 0.15   /* s: an answer that takes longer is not waited for before the plan is drawn */
#define MARGIN 2     /* samples at the end of a record that still changes are not shown */
#define TAKE_PART 16 /* rows are taken over when they are such a part of all, so that this costs little in sum */
#define TAKE_NEAR 1.0 /* s: or when what is shown comes so near to the end */

/* The plan of a run that is in work is drawn already; NULL: of none. */
static void show_early(HouseSession *live, HouseRun *run) {
    live->early = run;
    house_show_anew(live);
}

/* Neither shown, nor before, nor the answer any more. */
static void release(HouseSession *live, HouseRun *run) {
    if (run && run == live->early)
        show_early(live, NULL);
    if (run && run != live->shown && run != live->before && run != live->clean)
        house_worker_abandon(live->worker, run);
}

Before house_follow_ghost(const HouseSession *live) {
    if (live->ghost == GHOST_BEFORE && live->before && live->before != live->shown)
        return (Before){.house = &live->before->house, .observation = &live->before->observation};
    if (live->ghost == GHOST_RIVAL && live->rival_over)
        return (Before){.house = &live->rival->house,
                        .observation = &live->rival->observation,
                        .name = profile_driving_name(live->rival->wish.driving)};
    return (Before){.house = NULL};
}

int house_follow_other(const HouseSession *live) {
    const House *house = &live->shown->house;
    for (size_t k = 0; k < house->profile_count; k++)
        if (house->profiles[k].driving != DRIVING_WALKER)
            return house->profiles[k].driving == DRIVING_MIURA ? DRIVING_DRIVER : DRIVING_MIURA;
    return DRIVING_MIURA;
}

double house_follow_reach(const HouseSession *live) {
    if (!live->shown)
        return 0;
    const Observation *observation = live->observation;
    return live->whole ? observation->time : fmax(0, observation->time - MARGIN * observation->sample);
}

/* Asking ---------------------------------------------------------------------------------------------------------- */

/* A mixed one of the whole history, all others of the draft as it is; `brief`: without what takes long to explain. */
static HouseRun *ask(HouseSession *live, HouseJob job, int driving, bool brief) {
    HouseEpoch now = {0, draft_text(live->draft), draft_revision(live->draft)};
    HouseWish wish = live->wish;
    wish.path = editor_path(live->editor);
    wish.job = job;
    wish.epochs = job == HOUSE_JOB_MIXED ? live->history.at : &now;
    wish.epoch_count = job == HOUSE_JOB_MIXED ? live->history.count : 1;
    wish.driving = driving;
    wish.brief = brief;
    HouseRun *run = house_run_create(&wish);
    house_worker_ask(live->worker, run);
    live->changed |= LABORATORY_WORDS;
    return run;
}

/* What belongs to the one shown, and would belong to another one. */
static void drop_companions(HouseSession *live) {
    release(live, live->rival);
    release(live, live->ways);
    live->rival = live->ways = NULL;
    live->rival_over = live->ways_over = false;
}

/* In brief, or with everything that can be said. */
static void ask_for_run(HouseSession *live, bool brief) {
    if (live->latest && house_run_stage(live->latest) == HOUSE_WAITS) {
        release(live, live->latest);
    } else if (live->latest) {
        release(live, live->older);
        live->older = live->latest;
    }
    if ((live->rival && !live->rival_over) || (live->ways && !live->ways_over)) {
        drop_companions(live); /* the worker has something else to do */
        house_show_anew(live);
    }
    live->latest = ask(live, HOUSE_JOB_RUN, live->wish.driving, brief);
    live->changed |= LABORATORY_PARAMETERS;
}

/* The answer comes first, why somebody cannot pass when there is time. */
void house_follow_ask(HouseSession *live) {
    ask_for_run(live, true);
}

/* Nothing that was asked for is waited for any more. */
static void forget_asked(HouseSession *live) {
    release(live, live->older);
    release(live, live->latest);
    live->older = live->latest = NULL;
    live->changed |= LABORATORY_WORDS | LABORATORY_PARAMETERS;
}

static void forget_mixed(HouseSession *live) {
    release(live, live->mixed);
    live->mixed = NULL;
}

/* The run of the answer is another one, or NULL. */
static void set_clean(HouseSession *live, HouseRun *run) {
    HouseRun *last = live->clean;
    live->clean = run;
    if (last != run)
        release(live, last);
    live->retell = true;
    live->changed |= LABORATORY_WORDS;
}

/* Is a run what would come of some epochs with route and driving as they are? */
static bool is_of(const HouseSession *live, const HouseRun *run, const HouseEpoch *epochs, size_t count) {
    const char *route = run ? run->wish.route : NULL, *wished = live->wish.route;
    return run && (route ? wished && strcmp(route, wished) == 0 : !wished) && run->wish.driving == live->wish.driving &&
           house_history_same(run->wish.epochs, run->wish.epoch_count, epochs, count);
}

/* Is what is shown, all of it, what is to be shown? */
static bool is_up_to_date(const HouseSession *live) {
    return live->whole && is_of(live, live->shown, live->history.at, live->history.count);
}

const HouseRun *house_follow_answering(const HouseSession *live) {
    return live->clean ? live->clean : live->shown;
}

bool house_follow_seeks_reasons(const HouseSession *live) {
    HouseEpoch now = {0, NULL, draft_revision(live->draft)};
    return live->latest && !live->latest->wish.brief && (live->clean || live->whole) &&
           is_of(live, house_follow_answering(live), &now, 1);
}

/* Is somebody on the way at what is shown? Then an edit goes on from there. */
static bool is_under_way(const HouseSession *live) {
    return live->shown && live->time > 0 && live->time < live->observation->time;
}

/* What is done is done at the moment that is shown; what is only in the hand is shown from the beginning on. */
static void note_history(HouseSession *live) {
    const char *text = draft_text(live->draft);
    uint64_t revision = draft_revision(live->draft);
    if (is_under_way(live))
        house_history_change(&live->history, live->time, text, revision);
    else if (live->history.at[live->history.count - 1].revision != revision)
        house_history_begin(&live->history, text, revision);
}

/* Asks for what is missing of the answer and of what is to be shown. */
static void ask_missing(HouseSession *live) {
    HouseEpoch now = {0, NULL, draft_revision(live->draft)};
    bool mixed = live->history.count > 1 && !draft_is_open(live->draft);
    forget_mixed(live);
    if (mixed && live->whole && is_of(live, live->shown, &now, 1))
        set_clean(live, live->shown);
    if (mixed && is_of(live, live->clean, &now, 1)) {
        forget_asked(live);
        if (!is_up_to_date(live))
            live->mixed = ask(live, HOUSE_JOB_MIXED, live->wish.driving, true);
    } else if (!mixed && live->whole && is_of(live, live->shown, &now, 1)) {
        forget_asked(live);
        set_clean(live, NULL);
    } else {
        house_follow_ask(live);
    }
}

void house_follow_edited(HouseSession *live) {
    if (live->wish.route && plan_find_route(draft_plan(live->draft), live->wish.route) == SIZE_MAX)
        live->wish.route = NULL;
    if (live->shown && house_run_revision(live->shown) != draft_revision(live->draft))
        house_follow_keep(live, true);
    if (!draft_is_open(live->draft))
        note_history(live);
    ask_missing(live);
    if (live->kept_itself && house_run_revision(live->before) == draft_revision(live->draft))
        house_follow_forget(live); /* all is as before */
}

void house_follow_clean(HouseSession *live) {
    if (live->history.count < 2)
        return;
    house_history_begin(&live->history, draft_text(live->draft), draft_revision(live->draft));
    ask_missing(live);
}

bool house_follow_keep(HouseSession *live, bool by_itself) {
    if (!live->whole || (by_itself && (live->before || !live->shown->house.person_count)))
        return false;
    HouseRun *last = live->before;
    live->before = live->shown;
    release(live, last);
    live->kept_itself = by_itself;
    live->ghost = by_itself && live->ghost != GHOST_NONE ? live->ghost : GHOST_BEFORE;
    live->retell = true;
    house_show_anew(live);
    return true;
}

void house_follow_forget(HouseSession *live) {
    HouseRun *last = live->before;
    live->before = NULL;
    release(live, last);
    live->kept_itself = false;
    live->ghost = live->ghost == GHOST_BEFORE ? GHOST_NONE : live->ghost;
    live->retell = true;
    live->changed |= LABORATORY_WORDS | LABORATORY_PLOTS;
    house_show_anew(live);
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

/* Whose numbers were lost, when, and what would help. */
static void tell_divergence(HouseSession *live) {
    for (size_t i = 0; i < live->observation->person_count; i++) {
        const PersonObservation *person = &live->observation->people[i];
        const Inhabitant *who = &live->shown->house.people[i];
        if (person->reason != REASON_DIVERGED)
            continue;
        text_format(&live->trouble,
                    "%sthe numbers of person %s diverged at %.3f s, the run ends with the last good state: smaller "
                    "run.dt or softer contact of %s would help",
                    live->trouble.used ? "\n" : "", who->id, person->time, who->profile->name);
        say_trouble(live, person->time);
    }
}

/* There is no such house: the step that made it is undone, and the one that is shown is made again if it was stopped.
 */
static void turn_back(HouseSession *live, HouseRun *run) {
    clear_trouble(live);
    for (size_t i = 0; i < run->fault.count; i++)
        text_format(&live->trouble, "%s%s", i ? "\n" : "", run->fault.lines[i]);
    say_trouble(live, NAN);
    live->changed |= LABORATORY_PARAMETERS;
    if (!live->shown)
        return;
    uint64_t revision = house_run_revision(run);
    bool undone = !draft_is_open(live->draft) && revision == draft_revision(live->draft) &&
                  revision != house_run_revision(live->shown) && draft_undo(live->draft);
    if (undone)
        note_history(live);
    live->wish.driving = live->shown->wish.driving;
    editor_set_driving(live->editor, live->wish.driving);
    house_value_list_again(&live->values, &live->opened, &live->shown->house);
    if ((undone && !is_up_to_date(live)) || (!live->whole && house_run_stage(live->shown) == HOUSE_STOPPED))
        ask_missing(live);
}

/* What is shown --------------------------------------------------------------------------------------------------- */

/* A thing is the same by its name; a dangerous point of another run is another one. */
static void select_again(HouseSession *live, const House *before, const House *now) {
    Item thing = live->selected;
    live->selected = (Item){0, 0};
    editor_set_selected(live->editor, live->selected);
    if (thing.kind == HOUSE_HAZARD || thing.index >= house_item_count(before, NULL, thing.kind))
        return;
    live->selected = house_item_find(now, thing.kind, house_item_id(before, thing));
    editor_set_selected(live->editor, live->selected);
}

/* The one shown is over: its own observation takes the place of the one that grew. */
static void finish(HouseSession *live) {
    house_show_anew(live);
    trail_clear(&live->trails);
    observation_free(&live->growing);
    live->whole = true;
    live->observation = &live->shown->observation;
    trail_grow(&live->trails, live->observation);
    tell_divergence(live);
    live->retell = true;
    live->changed |= LABORATORY_WORDS | LABORATORY_PLOTS;
}

/* Another run takes the place of the one shown. */
static void swap_in(HouseSession *live, HouseRun *run) {
    HouseRun *last = live->shown;
    house_show_anew(live);
    trail_clear(&live->trails);
    observation_free(&live->growing);
    clear_trouble(live);
    if (last)
        select_again(live, &last->house, &run->house);
    live->shown = run;
    live->early = NULL;
    live->whole = false;
    live->growing = house_run_begin(run);
    live->observation = &live->growing;
    release(live, last);
    drop_companions(live);
    if (house_run_stage(run) == HOUSE_OVER) {
        finish(live);
    } else {
        house_run_take(run, &live->growing, 1);
        trail_grow(&live->trails, live->observation);
    }
    if (!live->opened.count)
        house_value_list(&live->opened, &run->house);
    if (!editor_holds_number(live->editor) &&
        house_run_revision(run) == draft_revision(live->draft)) /* else it is not as the hand has it */
        house_value_list_again(&live->values, &live->opened, &run->house);
    live->retell = true;
    live->changed |= LABORATORY_ALL & ~LABORATORY_TROUBLE;
}

/* Following ------------------------------------------------------------------------------------------------------- */

/* Is it time to show a run that has been asked for? */
static bool is_ready(HouseSession *live, HouseRun *run, double time) {
    HouseStage stage = house_run_stage(run);
    if (stage == HOUSE_OVER || (!live->shown && (stage == HOUSE_PLANS || stage == HOUSE_DRIVES)))
        return true;
    return stage == HOUSE_DRIVES && house_run_age(run) > GRACE && house_run_reach(run) > time + TAKE_NEAR;
}

/* A run that is the answer to an edit under way is not shown: it is what the answer says, and asks for what is. */
static bool is_answer_only(const HouseSession *live, const HouseRun *run) {
    return live->history.count > 1 && !draft_is_open(live->draft) &&
           house_run_revision(run) == draft_revision(live->draft);
}

static void follow_asked(HouseSession *live, HouseRun **asked, double time) {
    HouseRun *run = *asked;
    if (!run)
        return;
    bool latest = asked == &live->latest;
    HouseStage stage = house_run_stage(run);
    if (stage == HOUSE_FAILED || stage == HOUSE_STOPPED) {
        *asked = NULL;
        if (latest && stage == HOUSE_FAILED)
            turn_back(live, run);
        release(live, run);
    } else if (latest && is_answer_only(live, run)) {
        if (stage != HOUSE_OVER)
            return;
        live->latest = NULL;
        set_clean(live, run);
        ask_missing(live);
    } else if (is_ready(live, run, time)) {
        *asked = NULL;
        if (latest) {
            release(live, live->older);
            live->older = NULL;
        }
        if (asked != &live->mixed)
            set_clean(live, NULL);
        swap_in(live, run);
    }
}

/* What has begun before the latest was asked for may end, so that something is seen while a slider moves, but not for
 * long. */
static void hurry(HouseSession *live) {
    if (!live->latest || house_run_stage(live->latest) != HOUSE_WAITS)
        return;
    if (live->older && house_run_age(live->older) > GRACE) {
        release(live, live->older);
        live->older = NULL;
    }
    if (live->shown && !live->whole)
        parallel_stop(&live->shown->stop);
}

static void follow_shown(HouseSession *live, double time) {
    if (!live->shown || live->whole)
        return;
    if (house_run_stage(live->shown) == HOUSE_OVER) {
        finish(live);
        return;
    }
    bool near = time + TAKE_NEAR > house_follow_reach(live);
    size_t least = near ? 1 : live->observation->trace.rows / TAKE_PART + 1;
    if (!house_run_take(live->shown, &live->growing, least))
        return;
    trail_grow(&live->trails, live->observation);
    if (live->film)
        film_extend(live->film);
    house_session_plots_make(live, false);
    if (clock_now() - live->words.said > GRACE) {
        live->retell = true;
        live->changed |= LABORATORY_WORDS;
    }
}

/* Asks for something that belongs to the one shown, when it is wanted and is not there; true: it has come just now. */
static bool follow_companion(HouseSession *live, HouseRun **companion, bool *over, HouseJob job, int driving) {
    if (*over)
        return false;
    if (!*companion)
        *companion = ask(live, job, driving, false);
    HouseStage stage = house_run_stage(*companion);
    *over = stage == HOUSE_OVER;
    if (*over)
        house_show_anew(live);
    return *over;
}

static void follow_companions(HouseSession *live) {
    if (!live->whole || live->latest || live->mixed)
        return;
    bool crowd = live->shown->house.person_count > PEOPLE_SCENE_INDIVIDUALS;
    if (live->ghost == GHOST_RIVAL &&
        follow_companion(live, &live->rival, &live->rival_over, HOUSE_JOB_RIVAL, house_follow_other(live))) {
        live->retell = true;
        live->changed |= LABORATORY_WORDS | LABORATORY_PLOTS;
    }
    if (live->layers & 1u << LAYER_WIDTHS && !crowd)
        follow_companion(live, &live->ways, &live->ways_over, HOUSE_JOB_WAYS, live->wish.driving);
}

/* Where the answer takes long, walls and furniture are drawn before it: as soon as the house is read, with the same
 * people in it. */
static void follow_plan(HouseSession *live) {
    HouseRun *run = live->latest;
    if (!run || run == live->early || !live->shown || house_run_age(run) < EARLY)
        return;
    HouseStage stage = house_run_stage(run);
    if ((stage == HOUSE_PLANS || stage == HOUSE_DRIVES) && house_run_alike(&run->house, &live->shown->house))
        show_early(live, run);
}

/* Why somebody does not get out is looked for when nothing is in the hand. */
static void follow_reasons(HouseSession *live) {
    const HouseRun *run = house_follow_answering(live);
    bool whole = live->clean || live->whole;
    if (whole && run->wish.brief && !run->observation.completed && !live->latest && !draft_is_open(live->draft))
        ask_for_run(live, false);
}

void house_follow_all(HouseSession *live, double time) {
    follow_asked(live, &live->older, time);
    follow_asked(live, &live->latest, time);
    follow_asked(live, &live->mixed, time);
    hurry(live);
    follow_plan(live);
    follow_shown(live, time);
    follow_reasons(live);
    follow_companions(live);
}

void house_follow_end(HouseSession *live) {
    HouseRun *clean = live->clean != live->shown && live->clean != live->before ? live->clean : NULL;
    HouseRun *runs[] = {
        live->shown, live->before != live->shown ? live->before : NULL, clean, live->latest, live->mixed, live->older};
    drop_companions(live);
    for (size_t i = 0; i < sizeof runs / sizeof *runs; i++)
        house_worker_abandon(live->worker, runs[i]);
    house_worker_destroy(live->worker);
    trail_clear(&live->trails);
    observation_free(&live->growing);
}
