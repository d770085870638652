#include "laboratory/house/runs.h"

#include <string.h>

#include "visual/house/people_scene.h"

#define MARGIN 2 /* samples at the end of a record that still changes are not shown */

/* Roles ------------------------------------------------------------------------------------------------------------ */

static bool wants_rival(const HouseSession *live) {
    return live->ghost == GHOST_RIVAL;
}

static bool wants_routes(const HouseSession *live) {
    return live->layers & 1u << LAYER_WIDTHS && live->runs[RUN_SHOWN]->house.person_count <= PEOPLE_SCENE_INDIVIDUALS;
}

typedef struct RoleRow {
    HouseJob job;
    unsigned dropped;                            /* by these events */
    bool (*is_wanted)(const HouseSession *live); /* a companion of the displayed run; NULL: asked for by an edit */
} RoleRow;

static const RoleRow roles[RUN_ROLES] = {
    [RUN_SHOWN] = {HOUSE_JOB_RUN, RUNS_CLOSE, NULL},
    [RUN_LATEST] = {HOUSE_JOB_RUN, RUNS_CLOSE | RUNS_ANSWER, NULL},
    [RUN_OLDER] = {HOUSE_JOB_RUN, RUNS_CLOSE | RUNS_ANSWER, NULL},
    [RUN_MIXED] = {HOUSE_JOB_MIXED, RUNS_CLOSE | RUNS_EDIT, NULL},
    [RUN_CLEAN] = {HOUSE_JOB_RUN, RUNS_CLOSE, NULL},
    [RUN_EARLY] = {HOUSE_JOB_RUN, RUNS_CLOSE, NULL},
    [RUN_BEFORE] = {HOUSE_JOB_RUN, RUNS_CLOSE, NULL},
    [RUN_RIVAL] = {HOUSE_JOB_RIVAL, RUNS_CLOSE | RUNS_DISPLAY, wants_rival},
    [RUN_ROUTES] = {HOUSE_JOB_WAYS, RUNS_CLOSE | RUNS_DISPLAY, wants_routes},
};

void house_runs_retain(HouseRun *run) {
    if (run)
        run->roles++;
}

void house_runs_release(HouseSession *live, HouseRun *run) {
    if (!run || --run->roles > 0) {
        if (run && run->roles == 1 && run == live->runs[RUN_EARLY])
            house_runs_set(live, RUN_EARLY, NULL);
        return;
    }
    house_worker_abandon(live->worker, run);
}

void house_runs_set(HouseSession *live, HouseRunRole role, HouseRun *run) {
    HouseRun *last = live->runs[role];
    if (last == run)
        return;
    house_runs_retain(run);
    live->runs[role] = run;
    if (role == RUN_EARLY)
        house_session_void_film(live);
    house_runs_release(live, last);
}

void house_runs_drop(HouseSession *live, unsigned event) {
    for (int role = 0; role < RUN_ROLES; role++)
        if (roles[role].dropped & event)
            house_runs_set(live, (HouseRunRole)role, NULL);
}

void house_runs_ask(HouseSession *live, HouseRunRole role, bool brief) {
    HouseEpoch now = {0, draft_text(live->draft), draft_revision(live->draft)};
    HouseWish wish = live->wish;
    bool mixed = role == RUN_MIXED;
    wish.path = editor_path(live->editor);
    wish.job = roles[role].job;
    wish.epochs = mixed ? live->history.at : &now;
    wish.epoch_count = mixed ? live->history.count : 1;
    wish.driving = role == RUN_RIVAL ? house_runs_other_driving(live) : live->wish.driving;
    wish.brief = brief;
    house_runs_set(live, role, house_run_create(&wish));
    house_worker_ask(live->worker, live->runs[role]);
    live->changed |= LABORATORY_WORDS;
}

bool house_runs_is_over(const HouseSession *live, HouseRunRole role) {
    return live->runs[role] && live->runs[role]->noticed;
}

bool house_runs_wants(const HouseSession *live, HouseRunRole role) {
    return roles[role].is_wanted && roles[role].is_wanted(live);
}

/* Facts about the runs
 * ---------------------------------------------------------------------------------------------------- */

Before house_runs_compared(const HouseSession *live) {
    if (live->ghost == GHOST_BEFORE && live->runs[RUN_BEFORE] && live->runs[RUN_BEFORE] != live->runs[RUN_SHOWN])
        return (Before){.house = &live->runs[RUN_BEFORE]->house, .observation = &live->runs[RUN_BEFORE]->observation};
    if (live->ghost == GHOST_RIVAL && house_runs_is_over(live, RUN_RIVAL))
        return (Before){.house = &live->runs[RUN_RIVAL]->house,
                        .observation = &live->runs[RUN_RIVAL]->observation,
                        .name = profile_driving_name(live->runs[RUN_RIVAL]->wish.driving)};
    return (Before){.house = NULL};
}

int house_runs_other_driving(const HouseSession *live) {
    const House *house = &live->runs[RUN_SHOWN]->house;
    for (size_t k = 0; k < house->profile_count; k++)
        if (house->profiles[k].driving != DRIVING_WALKER)
            return house->profiles[k].driving == DRIVING_MIURA ? DRIVING_DRIVER : DRIVING_MIURA;
    return DRIVING_MIURA;
}

double house_runs_reach(const HouseSession *live) {
    if (!live->runs[RUN_SHOWN])
        return 0;
    const Observation *observation = live->observation;
    return live->whole ? observation->time : fmax(0, observation->time - MARGIN * observation->sample);
}

const HouseRun *house_runs_answering(const HouseSession *live) {
    return live->runs[RUN_CLEAN] ? live->runs[RUN_CLEAN] : live->runs[RUN_SHOWN];
}

bool house_runs_is_of(const HouseSession *live, const HouseRun *run, const HouseEpoch *epochs, size_t count) {
    const char *route = run ? run->wish.route : NULL, *wished = live->wish.route;
    return run && (route ? wished && strcmp(route, wished) == 0 : !wished) && run->wish.driving == live->wish.driving &&
           house_history_same(run->wish.epochs, run->wish.epoch_count, epochs, count);
}

bool house_runs_seeks_reasons(const HouseSession *live) {
    HouseEpoch now = {0, NULL, draft_revision(live->draft)};
    return live->runs[RUN_LATEST] && !live->runs[RUN_LATEST]->wish.brief && (live->runs[RUN_CLEAN] || live->whole) &&
           house_runs_is_of(live, house_runs_answering(live), &now, 1);
}
