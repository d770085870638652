/* What is said of a house at work: the answer, and the rows of the panel. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "laboratory/house_live_parts.h"
#include "laboratory/people_scene.h"

#define MOMENT 0.1 /* s, of a steady clock, from one time that the present numbers are told to the next */
#define AHEAD 2.0  /* s, before somebody comes to a dangerous point: from there it is seen how */

enum { TICKS_MOST = 2000 };

#define NEW_CONTACT 0.1 /* s: a body that has been free for less is still touching */

static LiveRow *add_row(HouseLive *live, RowKind kind, const char *first) {
    HouseWords *words = &live->words;
    words->rows = memory_reserve(words->rows, &words->row_capacity, words->row_count + 1, sizeof *words->rows);
    LiveRow *row = &words->rows[words->row_count++];
    *row = (LiveRow){.row = {.kind = kind, .role = ROLE_TEXT, .cells = {first}}, .time = NAN};
    return row;
}

static void add_pair(HouseLive *live, const char *what, const char *value) {
    add_row(live, ROW_PLAIN, what)->row.cells[1] = value;
}

/* The selected thing
 * -------------------------------------------------------------------------------------------------*/

/* The row of the trace at or before a time; NULL: none. */
static const double *row_at(const Trail *trail, double time) {
    size_t low = 0, high = trail->count;
    while (high > low + 1) {
        size_t middle = low + (high - low) / 2;
        *(trail->rows[middle][TRACE_TIME] <= time ? &low : &high) = middle;
    }
    return trail->count ? trail->rows[low] : NULL;
}

static void say_moment(HouseLive *live, size_t person, double time) {
    Scene *scene = &live->words.scene;
    const double *row = row_at(&live->trails[person], time);
    if (!row)
        return;
    double reach = live->shown->house.people[person].profile->space_reach;
    bool free = row[TRACE_CLEARANCE] >= reach;
    add_pair(live, "speed now", scene_text(scene, "%.2f m/s", row[TRACE_SPEED]));
    add_pair(live, "clearance now",
             free ? scene_text(scene, "over %.2f m", reach) : people_scene_clearance(scene, row[TRACE_CLEARANCE]));
    add_pair(live, "contact force now", scene_text(scene, "%.0f N", row[TRACE_BODY_FORCE]));
}

static const char *result_of(HouseLive *live, const PersonObservation *observed) {
    if (observed->completed)
        return scene_text(&live->words.scene, "out in %.1f s", observed->time);
    return live->whole ? observation_reason(observed->reason) : "on the way";
}

static void say_narrowest(HouseLive *live, size_t person) {
    Scene *scene = &live->words.scene;
    const House *house = &live->shown->house;
    const PersonObservation *observed = &live->observation->people[person];
    char place[HOUSE_THING_NAME];
    if (!(observed->narrowest < house->people[person].profile->space_reach)) {
        add_pair(live, "narrowest", "stays free");
        return;
    }
    if (observed->narrowest_other >= 0)
        snprintf(place, sizeof place, "person %s", house->people[observed->narrowest_other].id);
    else
        outline_place_name(&house->outline, &house->plan, observed->narrowest_to, place, sizeof place);
    add_pair(live, scene_text(scene, "narrowest, %s", place), people_scene_clearance(scene, observed->narrowest));
}

static void say_person(HouseLive *live, size_t i, double time) {
    Scene *scene = &live->words.scene;
    const Inhabitant *person = &live->shown->house.people[i];
    const PersonObservation *observed = &live->observation->people[i];
    add_pair(live, "profile", arena_text(&scene->arena, person->profile->name));
    if (person->route)
        add_pair(live, "route", arena_text(&scene->arena, person->route->id));
    if (!observed->took_part) {
        add_pair(live, "takes no part", NULL);
        return;
    }
    add_pair(live, "result", result_of(live, observed));
    add_pair(live, "way so long", scene_text(scene, "%.2f m", observed->path_length));
    say_narrowest(live, i);
    add_pair(live, "contacts", scene_text(scene, "%d", observed->contacts));
    if (observed->contacts)
        add_pair(live, "hardest contact", scene_text(scene, "%.0f N", observed->peak_force));
    add_pair(live, "personal space pressed", scene_text(scene, "%.1f s", observed->ring_time));
    say_moment(live, i, time);
}

static void say_door(HouseLive *live, const Door *door) {
    static const char *const kinds[] = {"opening", "hinged", "sliding"}, *const states[] = {"open", "closed", "locked"};
    Scene *scene = &live->words.scene;
    add_pair(live, "clear width", scene_text(scene, "%.3f m", door->width));
    add_pair(live, "kind", kinds[door->kind]);
    add_pair(live, "state", states[door->state]);
    add_pair(live, "in wall", arena_text(&scene->arena, door->wall));
}

static void say_hazard(HouseLive *live, const Hazard *hazard) {
    Scene *scene = &live->words.scene;
    add_pair(live, "clearance", people_scene_clearance(scene, hazard->clearance));
    add_pair(live, "hardest contact", scene_text(scene, "%.0f N", hazard->peak_force));
    add_pair(live, "lost time", scene_text(scene, "%.1f s", hazard->lost_time));
}

static void say_selected(HouseLive *live, double time) {
    Scene *scene = &live->words.scene;
    const Plan *plan = &live->shown->house.plan;
    LiveThing thing = live->selected;
    char name[HOUSE_THING_NAME];
    house_live_thing_name(&live->shown->house, live->observation, thing, name, sizeof name);
    if (!*name)
        return;
    add_row(live, ROW_HEADING, scene_text(scene, "%c%s", *name - ('a' <= *name && *name <= 'z' ? 32 : 0), name + 1));
    if (thing.kind == HOUSE_PERSON) {
        say_person(live, thing.index, time);
    } else if (thing.kind == HOUSE_HAZARD) {
        say_hazard(live, &live->observation->hazards[thing.index]);
    } else if (thing.kind == HOUSE_DOOR) {
        say_door(live, &plan->doors[thing.index]);
    } else if (thing.kind == HOUSE_FURNITURE) {
        const Furniture *piece = &plan->furniture[thing.index];
        add_pair(live, "size", scene_text(scene, "%.2f x %.2f m", piece->size.x, piece->size.y));
        add_pair(live, "height", scene_text(scene, "%.2f m", piece->height));
        add_pair(live, "toppled", piece->toppled ? "yes" : "no");
    } else if (thing.kind == HOUSE_WALL) {
        add_pair(live, "thickness", scene_text(scene, "%.3f m", plan->walls[thing.index].thickness));
    } else if (thing.kind == HOUSE_EXIT) {
        const Exit *exit = &plan->exits[thing.index];
        add_pair(live, "width", scene_text(scene, "%.2f m", vec2_distance(exit->from, exit->to)));
    }
}

/* Before and now
 * -----------------------------------------------------------------------------------------------------*/

typedef struct Totals {
    double time, narrowest, force, ring;
    int contacts;
    bool completed;
} Totals;

static Totals totals_of(const Observation *observation) {
    Totals totals = {.time = observation->time, .narrowest = HUGE_VAL, .completed = observation->completed};
    for (size_t i = 0; i < observation->person_count; i++) {
        const PersonObservation *person = &observation->people[i];
        if (!person->took_part)
            continue;
        totals.narrowest = fmin(totals.narrowest, person->narrowest);
        totals.contacts += person->contacts;
        totals.force = fmax(totals.force, person->peak_force);
        totals.ring += person->ring_time;
    }
    return totals;
}

static void add_comparison(HouseLive *live, const char *what, const char *before, const char *now) {
    LiveRow *row = add_row(live, ROW_PLAIN, what);
    row->row.cells[1] = before;
    row->row.cells[2] = now;
}

static void compare(HouseLive *live) {
    Before ghost = house_live_part_ghost(live);
    Scene *scene = &live->words.scene;
    if (!ghost.observation || !live->whole)
        return;
    Totals before = totals_of(ghost.observation), now = totals_of(live->observation);
    LiveRow *heading = add_row(live, ROW_HEADING, "Compare");
    heading->row.cells[1] = house_scene_before_word(ghost);
    heading->row.cells[2] = "now";
    add_comparison(live, "time", before.completed ? scene_text(scene, "%.1f s", before.time) : "not out",
                   now.completed ? scene_text(scene, "%.1f s", now.time) : "not out");
    const char *narrowest = people_scene_clearance(scene, before.narrowest);
    add_comparison(live, "narrowest", narrowest, people_scene_clearance(scene, now.narrowest));
    const char *contacts = scene_text(scene, "%d", before.contacts);
    add_comparison(live, "contacts", contacts, scene_text(scene, "%d", now.contacts));
    const char *force = scene_text(scene, "%.0f N", before.force);
    add_comparison(live, "hardest contact", force, scene_text(scene, "%.0f N", now.force));
    const char *ring = scene_text(scene, "%.1f s", before.ring);
    add_comparison(live, "space pressed", ring, scene_text(scene, "%.1f s", now.ring));
}

/* What the scene lists: dangerous points and people
 * ------------------------------------------------------------------*/

/* When somebody is nearest to a dangerous point, less so much that one sees them come; s. */
static double time_before(const HouseLive *live, const Hazard *hazard) {
    double least = HUGE_VAL, time = 0;
    const Trace *trace = &live->observation->trace;
    for (size_t r = 0; r < trace->rows; r++) {
        const double *row = trace_row(trace, r);
        double distance = vec2_distance(vec2(row[TRACE_X], row[TRACE_Y]), hazard->at);
        if (distance < least) {
            least = distance;
            time = row[TRACE_TIME];
        }
    }
    return fmax(0, time - AHEAD);
}

/* Rows of the scene's list with what they mean: the n-th below a heading is the n-th of its kind. */
static void add_listed(HouseLive *live) {
    const Scene *scene = &live->words.scene;
    const House *house = &live->shown->house;
    size_t hazard = 0, person = 0;
    for (size_t i = 0; i < scene->row_count; i++) {
        LiveRow *row = add_row(live, ROW_PLAIN, NULL);
        row->row = scene->rows[i];
        if (row->row.kind == ROW_DISC) {
            row->thing = (LiveThing){HOUSE_HAZARD, hazard};
            row->time = time_before(live, &live->observation->hazards[hazard++]);
        } else if (row->row.kind == ROW_LINE && house->person_count <= PEOPLE_SCENE_INDIVIDUALS) {
            while (person < house->person_count && !live->observation->people[person].took_part)
                person++;
            if (person < house->person_count)
                row->thing = (LiveThing){HOUSE_PERSON, person++};
        }
    }
}

/* Ticks
 * --------------------------------------------------------------------------------------------------------------*/

static void add_tick(HouseLive *live, double time, LiveTickKind kind) {
    HouseWords *words = &live->words;
    if (words->tick_count == TICKS_MOST)
        return;
    words->ticks = memory_reserve(words->ticks, &words->tick_capacity, words->tick_count + 1, sizeof *words->ticks);
    words->ticks[words->tick_count++] = (LiveTick){time, kind};
}

static int compare_ticks(const void *a, const void *b) {
    const LiveTick *p = a, *q = b;
    return p->time != q->time ? (p->time > q->time) - (p->time < q->time) : (int)p->kind - (int)q->kind;
}

static void make_ticks(HouseLive *live) {
    const Observation *observation = live->observation;
    live->words.tick_count = 0;
    for (size_t i = 0; i < observation->person_count; i++) {
        const PersonObservation *person = &observation->people[i];
        const Trail *trail = &live->trails[i];
        double touched = -HUGE_VAL;
        for (size_t r = 0; r < trail->count; r++) {
            const double *row = trail->rows[r];
            if (!(row[TRACE_BODY_FORCE] > 0))
                continue;
            if (row[TRACE_TIME] - touched > NEW_CONTACT)
                add_tick(live, row[TRACE_TIME], LIVE_TICK_CONTACT);
            touched = row[TRACE_TIME];
        }
        if (person->completed)
            add_tick(live, person->time, LIVE_TICK_EXIT);
        if (person->reason == REASON_DIVERGED)
            add_tick(live, person->time, LIVE_TICK_TROUBLE);
    }
    if (live->words.tick_count > 1)
        qsort(live->words.ticks, live->words.tick_count, sizeof *live->words.ticks, compare_ticks);
}

/* The answer
 * ---------------------------------------------------------------------------------------------------------*/

/* "before 24.1 s, -5.7 s (-24 %)" */
static const char *against(HouseLive *live) {
    Before ghost = house_live_part_ghost(live);
    Scene *scene = &live->words.scene;
    if (!ghost.observation)
        return "";
    const char *word = house_scene_before_word(ghost);
    double before = ghost.observation->time, more = live->observation->time - before;
    if (!ghost.observation->completed)
        return scene_text(scene, "%s not out", word);
    if (!live->observation->completed || before <= 0)
        return scene_text(scene, "%s %.1f s", word, before);
    return scene_text(scene, "%s %.1f s, %+.1f s (%+.0f %%)", word, before, more, 100 * more / before);
}

static void say_answer(HouseLive *live) {
    HouseWords *words = &live->words;
    if (!live->whole) {
        bool driving = live->observation->trace.rows;
        words->title = driving ? "Driving ..." : "Planning ...";
        words->role = ROLE_TEXT;
        words->detail = "";
        return;
    }
    const char *than = against(live);
    words->title = words->scene.title;
    words->role = words->scene.title_role;
    words->detail =
        *than ? scene_text(&words->scene, "%s%s%s", than, *words->scene.detail ? "; " : "", words->scene.detail)
              : words->scene.detail;
}

void house_live_words_make(HouseLive *live, double time) {
    HouseWords *words = &live->words;
    scene_clear(&words->scene);
    words->row_count = 0;
    words->said = house_live_part_now();
    words->time = time;
    if (!live->shown)
        return;
    Census census = census_take(&live->shown->house, live->observation);
    house_scene_begin(&words->scene, &live->shown->house, live->observation, &census);
    census_clear(&census);
    say_answer(live);
    say_selected(live, time);
    compare(live);
    add_listed(live);
    make_ticks(live);
}

void house_live_words_clear(HouseLive *live) {
    scene_clear(&live->words.scene);
    memory_free(live->words.rows);
    memory_free(live->words.ticks);
    live->words = (HouseWords){.title = NULL};
}

bool house_live_words_moved(const HouseLive *live, double time) {
    if (!live->shown || live->selected.kind != HOUSE_PERSON || time == live->words.time)
        return false;
    const Trail *trail = &live->trails[live->selected.index];
    return house_live_part_now() - live->words.said >= MOMENT && row_at(trail, time) != row_at(trail, live->words.time);
}

/* What is in work, in words; NULL: nothing. */
static const char *say_doing(HouseLive *live, HouseRun *run, const char *who) {
    switch (house_live_run_stage(run)) {
    case HOUSE_WAITS:
    case HOUSE_READS:
        snprintf(live->doing, sizeof live->doing, "%sreading the house", who);
        break;
    case HOUSE_PLANS:
        snprintf(live->doing, sizeof live->doing, "%splanning the ways", who);
        break;
    case HOUSE_DRIVES:
        snprintf(live->doing, sizeof live->doing, "%scomputed %.1f s", who, house_live_run_reach(run));
        break;
    case HOUSE_OVER:
    case HOUSE_FAILED:
    case HOUSE_STOPPED:
        return NULL;
    }
    return live->doing;
}

LiveAnswer house_live_words_answer(HouseLive *live) {
    const HouseWords *words = &live->words;
    LiveAnswer answer = {.title = live->shown ? words->title : "Reading ...",
                         .role = live->shown ? words->role : ROLE_TEXT,
                         .detail = live->shown ? words->detail : "",
                         .stale = live->shown && live->latest,
                         .part = NAN};
    if (live->latest)
        answer.doing = say_doing(live, live->latest, "");
    else if (live->shown && !live->whole)
        answer.doing = say_doing(live, live->shown, "");
    else if (live->rival && !live->rival_over) {
        char who[32];
        snprintf(who, sizeof who, "%s: ", profile_driving_name(live->rival->wish.driving));
        answer.doing = say_doing(live, live->rival, who);
    }
    return answer;
}

bool house_live_words_does_other(HouseLive *live) {
    LiveAnswer answer = house_live_words_answer(live);
    const char *doing = answer.doing ? answer.doing : "";
    bool other = strcmp(doing, live->done) != 0;
    snprintf(live->done, sizeof live->done, "%s", doing);
    return other;
}
