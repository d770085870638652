#include "result/jam.h"

#include <math.h>
#include <string.h>

#include "base/text.h"
#include "plan/plan_geometry.h"
#include "result/census.h"
#include "result/names.h"

#define AT 3.0     /* m, from an exit or a door to the jam in front of it */
#define NEAR 6.0   /* m, from a door to a jam that is told by the door it is near */
#define BESIDE 0.6 /* m, from a wall to the room that the wall belongs to */

#define AROUND 2.0  /* m, from a jam to the people who wait in it */
#define SET_OFF 0.5 /* m, from the start of a person who has set off */
#define SLOT 1.0    /* s, over which lost time is summed */

enum {
    WAYS = 8,  /* directions in which a room is looked for */
    SLOTS = 3, /* over which the sum is a mean */
};

/* Returns the nearest exit within a distance, m, or NULL. */
static const Exit *exit_near(const Plan *plan, Vec2 at, double within) {
    const Exit *found = NULL;
    for (size_t e = 0; e < plan->exit_count; e++) {
        const Exit *exit = &plan->exits[e];
        double away = vec2_distance(at, vec2_nearest_on_segment(at, exit->from, exit->to));
        if (away > within)
            continue;
        within = away;
        found = exit;
    }
    return found;
}

/* Returns the nearest door within a distance, m, or NULL. */
static const Door *door_near(const Plan *plan, Vec2 at, double within) {
    const Door *found = NULL;
    for (size_t d = 0; d < plan->door_count; d++) {
        Vec2 from, to;
        plan_geometry_door_ends(plan, &plan->doors[d], &from, &to);
        double away = vec2_distance(at, vec2_nearest_on_segment(at, from, to));
        if (away > within)
            continue;
        within = away;
        found = &plan->doors[d];
    }
    return found;
}

/* Returns the name of the room of a place, which may lie in a wall; NULL: there is none. */
static const char *room_near(const Plan *plan, Vec2 at) {
    const char *room = names_room(plan, at);
    for (int way = 0; way < WAYS && !room; way++)
        room = names_room(plan, vec2_along(at, BESIDE, vec2_heading(2 * M_PI * way / WAYS)));
    return room;
}

static bool is_furniture(const char *what) {
    static const char *const others[] = {"wall ", "door ", "person "};
    for (size_t i = 0; i < sizeof others / sizeof *others; i++)
        if (strncmp(what, others[i], strlen(others[i])) == 0)
            return false;
    return strcmp(what, OUTLINE_FREE_SPACE) != 0;
}

JamPlace jam_place(const Plan *plan, const Hazard *hazard) {
    JamPlace place = {.exit = exit_near(plan, hazard->at, AT)};
    if (place.exit)
        return place;
    place.door = door_near(plan, hazard->at, AT);
    if (place.door)
        return place;
    place.room = room_near(plan, hazard->at);
    place.thing = is_furniture(hazard->what) ? hazard->what : NULL;
    place.door = place.thing ? NULL : door_near(plan, hazard->at, NEAR);
    place.exit = place.thing || place.door || place.room ? NULL : exit_near(plan, hazard->at, NEAR);
    place.nameless = !place.thing && !place.door && !place.room && !place.exit;
    return place;
}

bool jam_is_same(const Plan *plan, const Hazard *a, const Hazard *b) {
    JamPlace p = jam_place(plan, a), q = jam_place(plan, b);
    if (p.nameless || q.nameless)
        return p.nameless && q.nameless && strcmp(a->what, b->what) == 0;
    bool same_thing = p.thing && q.thing ? strcmp(p.thing, q.thing) == 0 : !p.thing && !q.thing;
    return p.exit == q.exit && p.door == q.door && p.room == q.room && same_thing;
}

/* Returns the door's name, with its distance where that is far: "5 m from shop 18 door". */
static const char *name_from_door(const Plan *plan, const Door *door, Vec2 at, Arena *arena) {
    Vec2 from, to;
    plan_geometry_door_ends(plan, door, &from, &to);
    double away = vec2_distance(at, vec2_nearest_on_segment(at, from, to));
    const char *name = names_door(plan, (size_t)(door - plan->doors), arena);
    return away > AT ? text_in_arena(arena, "%.0f m from %s", away, name) : name;
}

static const char *crowd_name(const House *house, const Hazard *hazard, Arena *arena) {
    const Plan *plan = &house->plan;
    JamPlace place = jam_place(plan, hazard);
    if (place.exit)
        return plan->exit_count > 1 ? text_in_arena(arena, "exit %s", place.exit->id) : "exit";
    const char *thing = place.door ? name_from_door(plan, place.door, hazard->at, arena) : NULL;
    thing = place.thing || place.nameless ? names_thing(house, hazard->what, hazard->at, arena) : thing;
    if (!place.room)
        return thing;
    bool own = thing && strncmp(thing, place.room, strlen(place.room)) == 0; /* "shop 3 door" in shop 3 */
    return thing && !own ? text_in_arena(arena, "%s, %s", place.room, thing) : place.room;
}

const char *jam_name(const House *house, const Hazard *hazard, Arena *arena) {
    return house->person_count > CENSUS_FEW ? crowd_name(house, hazard, arena)
                                            : names_thing(house, hazard->what, hazard->at, arena);
}

/* Returns the share of time that a person loses at a row of the trace; 0: elsewhere, or not on the way. */
static double loss_at(const House *house, const double *row, Vec2 place) {
    const Inhabitant *person = &house->people[(size_t)row[TRACE_PERSON]];
    Vec2 at = vec2(row[TRACE_X], row[TRACE_Y]);
    if (vec2_distance(at, place) > AROUND || vec2_distance(at, person->at) < SET_OFF)
        return 0;
    return fmax(0, 1 - fabs(row[TRACE_SPEED]) / person->profile->free_speed);
}

double jam_worst(const House *house, const Observation *observation, const Hazard *hazard) {
    double end = 0, most = 0;
    for (size_t r = 0; r < observation->trace.rows; r++)
        end = fmax(end, trace_row(&observation->trace, r)[TRACE_TIME]);
    size_t count = (size_t)(end / SLOT) + SLOTS, worst = 0;
    double *lost = memory_zeroed(count, sizeof *lost);
    for (size_t r = 0; r < observation->trace.rows; r++) {
        const double *row = trace_row(&observation->trace, r);
        lost[(size_t)(row[TRACE_TIME] / SLOT)] += loss_at(house, row, hazard->at);
    }
    for (size_t i = 0; i + SLOTS <= count; i++) {
        double sum = 0;
        for (size_t k = i; k < i + SLOTS; k++)
            sum += lost[k];
        worst = sum > most ? i : worst;
        most = fmax(most, sum);
    }
    memory_free(lost);
    return fmin((double)worst * SLOT + SLOTS * SLOT / 2, end);
}
