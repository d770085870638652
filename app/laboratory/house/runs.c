#include "laboratory/house/runs.h"

#include <string.h>

#include "base/digest.h"
#include "base/text.h"
#include "laboratory/house/picture.h"
#include "visual/house/people_scene.h"

#define MARGIN 1 /* samples at the end of a growing record, after which nobody's next place is known */

/* Roles ------------------------------------------------------------------------------------------------------------ */

static bool wants_rival(const HouseSession *session) {
    return session->ghost == GHOST_RIVAL;
}

static bool wants_routes(const HouseSession *session) {
    return session->layers & 1u << LAYER_WIDTHS &&
           session->runs[RUN_SHOWN]->house.person_count <= PEOPLE_SCENE_INDIVIDUALS;
}

static bool wants_grades(const HouseSession *session) {
    return house_runs_has_grade(session) && !draft_is_open(session->draft);
}

static bool wants_crew(const HouseSession *session) {
    return session->layers & 1u << LAYER_DRIVERS && !draft_is_open(session->draft) &&
           session->runs[RUN_SHOWN]->house.person_count <= PEOPLE_SCENE_INDIVIDUALS;
}

static bool wants_shakes(const HouseSession *session) {
    EditorShake shake;
    return editor_last_shake(session->editor, &shake) &&
           session->runs[RUN_SHOWN]->house.person_count <= PEOPLE_SCENE_INDIVIDUALS;
}

typedef struct RoleRow {
    HouseJob job;
    unsigned dropped;                               /* the events that end the role */
    bool (*is_wanted)(const HouseSession *session); /* true if a companion of the displayed run is wanted; NULL: an edit
                                                       requests the run */
} RoleRow;

static const RoleRow roles[RUN_ROLES] = {
    [RUN_SHOWN] = {HOUSE_JOB_RUN, RUNS_CLOSE, NULL},
    [RUN_LATEST] = {HOUSE_JOB_RUN, RUNS_CLOSE | RUNS_ANSWER, NULL},
    [RUN_OLDER] = {HOUSE_JOB_RUN, RUNS_CLOSE | RUNS_ANSWER, NULL},
    [RUN_MIXED] = {HOUSE_JOB_MIXED, RUNS_CLOSE | RUNS_EDIT, NULL},
    [RUN_EARLY] = {HOUSE_JOB_RUN, RUNS_CLOSE, NULL},
    [RUN_BEFORE] = {HOUSE_JOB_RUN, RUNS_CLOSE, NULL},
    [RUN_RIVAL] = {HOUSE_JOB_RIVAL, RUNS_CLOSE | RUNS_DISPLAY, wants_rival},
    [RUN_ROUTES] = {HOUSE_JOB_ROUTES, RUNS_CLOSE | RUNS_DISPLAY, wants_routes},
    [RUN_GRADES] = {HOUSE_JOB_GRADES, RUNS_CLOSE | RUNS_DISPLAY | RUNS_EDIT, wants_grades},
    [RUN_CREW] = {HOUSE_JOB_CREW, RUNS_CLOSE | RUNS_DISPLAY | RUNS_EDIT, wants_crew},
    [RUN_SHAKES] = {HOUSE_JOB_SHAKES, RUNS_CLOSE, wants_shakes},
};

void house_runs_retain(HouseRun *run) {
    if (run)
        run->roles++;
}

static HouseWorker *worker_of(const HouseSession *session, const HouseRun *run) {
    bool low = run->wish.job >= HOUSE_JOB_GRADES;
    return low ? session->crew_worker : session->worker;
}

void house_runs_release(HouseSession *session, HouseRun *run) {
    if (!run || --run->roles > 0) {
        if (run && run->roles == 1 && run == session->runs[RUN_EARLY])
            house_runs_set(session, RUN_EARLY, NULL);
        return;
    }
    house_worker_abandon(worker_of(session, run), run);
}

void house_runs_set(HouseSession *session, HouseRunRole role, HouseRun *run) {
    HouseRun *last = session->runs[role];
    if (last == run)
        return;
    house_runs_retain(run);
    session->runs[role] = run;
    if (role == RUN_SHAKES)
        session->outlook = NULL;
    if (role == RUN_CREW && session->crew) {
        session->crew = NULL;
        house_picture_void_film(session);
        session->changed |= LABORATORY_TEXTS;
    }
    if (role == RUN_EARLY)
        house_picture_void_film(session);
    house_runs_release(session, last);
}

void house_runs_drop(HouseSession *session, unsigned event) {
    for (int role = 0; role < RUN_ROLES; role++)
        if (roles[role].dropped & event)
            house_runs_set(session, (HouseRunRole)role, NULL);
}

/* Makes the wish one of the house as it stood before the last earthquake. */
static void stand_up(HouseSession *session, HouseWish *wish, Arena *arena) {
    EditorShake shake;
    if (!editor_last_shake(session->editor, &shake))
        return;
    const char **settings = arena_allocate(arena, (shake.count + 1) * sizeof *settings);
    for (size_t k = 0; k < shake.count; k++)
        settings[k] = text_in_arena(arena, "furniture.%s.toppled=false", shake.ids[k]);
    wish->settings = settings;
    wish->setting_count = shake.count;
    session->standing = shake.standing;
}

void house_runs_ask(HouseSession *session, HouseRunRole role, bool brief) {
    HouseEpoch now = {0, draft_text(session->draft), draft_revision(session->draft)};
    HouseWish wish = session->wish;
    bool mixed = role == RUN_MIXED;
    wish.path = editor_path(session->editor);
    wish.job = roles[role].job;
    wish.epochs = mixed ? session->history.at : &now;
    wish.epoch_count = mixed ? session->history.count : 1;
    wish.driving = role == RUN_RIVAL ? house_runs_other_driving(session) : session->wish.driving;
    wish.brief = brief;
    Arena arena = {0};
    if (role == RUN_SHAKES)
        stand_up(session, &wish, &arena);
    house_runs_set(session, role, house_run_create(&wish));
    arena_clear(&arena);
    house_worker_ask(worker_of(session, session->runs[role]), session->runs[role]);
    session->changed |= LABORATORY_TEXTS;
}

bool house_runs_is_over(const HouseSession *session, HouseRunRole role) {
    return session->runs[role] && session->runs[role]->noticed;
}

bool house_runs_wants(const HouseSession *session, HouseRunRole role) {
    return roles[role].is_wanted && roles[role].is_wanted(session);
}

bool house_runs_has_grade(const HouseSession *session) {
    const HouseRun *shown = session->runs[RUN_SHOWN];
    return session->whole && session->observation->completed && shown->wish.epoch_count == 1 &&
           shown->house.person_count <= PEOPLE_SCENE_INDIVIDUALS;
}

/* Facts about the runs -------------------------------------------------------------------------------------------- */

Before house_runs_compared(const HouseSession *session) {
    if (session->ghost == GHOST_BEFORE && session->runs[RUN_BEFORE] &&
        session->runs[RUN_BEFORE] != session->runs[RUN_SHOWN])
        return (Before){.house = &session->runs[RUN_BEFORE]->house,
                        .observation = &session->runs[RUN_BEFORE]->observation};
    if (session->ghost == GHOST_RIVAL && house_runs_is_over(session, RUN_RIVAL))
        return (Before){.house = &session->runs[RUN_RIVAL]->house,
                        .observation = &session->runs[RUN_RIVAL]->observation,
                        .name = profile_driving_name(session->runs[RUN_RIVAL]->wish.driving)};
    return (Before){.house = NULL};
}

int house_runs_other_driving(const HouseSession *session) {
    const House *house = &session->runs[RUN_SHOWN]->house;
    for (size_t k = 0; k < house->profile_count; k++)
        if (house->profiles[k].driving != DRIVING_WALKER)
            return house->profiles[k].driving == DRIVING_MIURA ? DRIVING_DRIVER : DRIVING_MIURA;
    return DRIVING_MIURA;
}

double house_runs_reach(const HouseSession *session) {
    if (!session->runs[RUN_SHOWN])
        return 0;
    const Observation *observation = session->observation;
    if (house_runs_is_working(session)) /* nobody moves */
        return session->settles && !session->runs[RUN_MIXED] ? 0 : session->time;
    return session->whole ? observation->time : fmax(0, observation->time - MARGIN * observation->sample);
}

uint64_t house_runs_identity(const HouseRun *run) {
    uint64_t digest = DIGEST_START;
    if (!run)
        return 0;
    for (size_t i = 0; i < run->wish.epoch_count; i++) {
        digest = digest_text(digest, run->wish.epochs[i].text);
        digest = digest_bytes(digest, &run->wish.epochs[i].time, sizeof run->wish.epochs[i].time);
    }
    digest = digest_text(digest, run->wish.route ? run->wish.route : "");
    digest = digest_bytes(digest, &run->wish.driving, sizeof run->wish.driving);
    return digest_bytes(digest, &run->wish.seed, sizeof run->wish.seed);
}

bool house_runs_is_working(const HouseSession *session) {
    const HouseRun *newest = session->runs[RUN_LATEST] ? session->runs[RUN_LATEST] : session->runs[RUN_MIXED];
    return session->runs[RUN_SHOWN] && newest && !house_runs_seeks_reasons(session);
}

bool house_runs_is_wished(const HouseSession *session, const HouseRun *run) {
    const char *route = run->wish.route, *wished = session->wish.route;
    return (route ? wished && strcmp(route, wished) == 0 : !wished) && run->wish.driving == session->wish.driving;
}

bool house_runs_is_of(const HouseSession *session, const HouseRun *run, const HouseEpoch *epochs, size_t count) {
    return run && house_runs_is_wished(session, run) &&
           house_history_same(run->wish.epochs, run->wish.epoch_count, epochs, count);
}

bool house_runs_seeks_reasons(const HouseSession *session) {
    HouseEpoch now = {0, NULL, draft_revision(session->draft)};
    return session->runs[RUN_LATEST] && !session->runs[RUN_LATEST]->wish.brief && session->whole &&
           house_runs_is_of(session, session->runs[RUN_SHOWN], &now, 1);
}
