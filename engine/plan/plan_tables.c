#include "plan/plan_tables.h"

#include <stdint.h>
#include <string.h>

#include "plan/population.h"

#define NAME(struct_, field_, meaning_)                                                                                \
    { .name = #field_, .kind = PARAMETER_TEXT, .offset = offsetof(struct_, field_), .unit = "", .meaning = meaning_ }
#define ID(struct_, field_, meaning_)                                                                                  \
    {                                                                                                                  \
        .name = #field_, .kind = PARAMETER_ID, .offset = offsetof(struct_, field_), .unit = "", .needed = true,        \
        .meaning = meaning_                                                                                            \
    }
#define NUMBER(struct_, field_, unit_, low_, high_, fallback_, meaning_, provenance_)                                  \
    {                                                                                                                  \
        .name = #field_, .kind = PARAMETER_NUMBER, .offset = offsetof(struct_, field_), .unit = unit_, .low = low_,    \
        .high = high_, .fallback = fallback_, .meaning = meaning_, .provenance = provenance_                           \
    }
#define NEEDED_NUMBER(struct_, field_, unit_, low_, high_, meaning_)                                                   \
    {                                                                                                                  \
        .name = #field_, .kind = PARAMETER_NUMBER, .offset = offsetof(struct_, field_), .unit = unit_, .low = low_,    \
        .high = high_, .needed = true, .meaning = meaning_                                                             \
    }
#define WHOLE(struct_, field_, low_, high_, fallback_, needed_, meaning_, provenance_)                                 \
    {                                                                                                                  \
        .name = #field_, .kind = PARAMETER_WHOLE, .offset = offsetof(struct_, field_), .unit = "1", .low = low_,       \
        .high = high_, .fallback = fallback_, .needed = needed_, .meaning = meaning_, .provenance = provenance_        \
    }
#define CHOICE(struct_, field_, choices_, fallback_, meaning_)                                                         \
    {                                                                                                                  \
        .name = #field_, .kind = PARAMETER_CHOICE, .offset = offsetof(struct_, field_), .unit = "",                    \
        .choices = choices_, .fallback = fallback_, .meaning = meaning_                                                \
    }
#define POINT(struct_, field_, meaning_)                                                                               \
    {                                                                                                                  \
        .name = #field_, .kind = PARAMETER_POINT, .offset = offsetof(struct_, field_), .unit = "m", .needed = true,    \
        .meaning = meaning_                                                                                            \
    }
#define POINTS(struct_, field_, least_, needed_, meaning_)                                                             \
    {                                                                                                                  \
        .name = #field_, .kind = PARAMETER_POINTS, .offset = offsetof(struct_, field_), .unit = "m", .low = least_,    \
        .needed = needed_, .meaning = meaning_                                                                         \
    }

#define TABLE(what_, rows_)                                                                                            \
    { what_, rows_, sizeof rows_ / sizeof *rows_ }

#define FARTHEST PARAMETER_FARTHEST

static const Parameter wall_rows[] = {
    ID(Wall, id, "name of the wall"),
    POINTS(Wall, points, 2, true, "centre line; a closed wall repeats its first point"),
    NUMBER(Wall, thickness, "m", 0, 5, 0.12, "thickness", "assumed: a stud wall with boards"),
    NUMBER(Wall, height, "m", 0, 100, 2.4, "height", "assumed: a usual storey"),
};

static const Parameter door_rows[] = {
    ID(Door, id, "name of the door"),
    ID(Door, wall, "wall of the door"),
    WHOLE(Door, segment, 0, 1e6, 0, false, "segment of the wall's points, from 0", "the first"),
    NEEDED_NUMBER(Door, at, "m", 0, FARTHEST, "middle of the door, along its segment"),
    NEEDED_NUMBER(Door, width, "m", 0.01, 100, "clear width"),
    CHOICE(Door, kind, "opening|hinged|sliding", DOOR_OPENING, "kind of door"),
    CHOICE(Door, state, "open|closed|locked", DOOR_OPEN,
           "state; a closed door costs time, a locked one counts as wall"),
    CHOICE(Door, hinge, "start|end", HINGE_START, "the end of the segment nearer to the hinge"),
    CHOICE(Door, swing, "left|right", SWING_LEFT, "the side of the wall's direction to which the leaf opens"),
    NUMBER(Door, opening_time, "s", 0, 600, 3, "time to open it when it is closed", "assumed"),
    NUMBER(Door, leaf, "m", 0, 0.3, 0.04, "thickness of a hinged door's leaf", "assumed: a usual inner door"),
    NUMBER(Door, rest, "m", 0, 100, 0, "what the open leaf of a sliding door still covers of the width", "none"),
    {.name = "closer",
     .kind = PARAMETER_FLAG,
     .offset = offsetof(Door, closer),
     .unit = "",
     .meaning = "closes by itself"},
};

static const Parameter furniture_rows[] = {
    ID(Furniture, id, "name for references"),
    NAME(Furniture, name, "displayed name"),
    POINT(Furniture, centre, "middle of the footprint of the standing piece"),
    POINT(Furniture, size, "footprint along its own x and y"),
    NUMBER(Furniture, angle, "degree", -360, 360, 0, "turned counter-clockwise by", "along the axes"),
    NUMBER(Furniture, height, "m", 0, 100, 0.7, "height", "assumed: a table's"),
    CHOICE(Furniture, topples, "front|back|left|right|no", TOPPLE_NO,
           "face to which it falls: front is its own -y, back +y, left -x, right +x"),
    NUMBER(Furniture, probability, "1", 0, 1, 0.5, "probability of toppling in a shake", "assumed"),
    {.name = "toppled",
     .kind = PARAMETER_FLAG,
     .offset = offsetof(Furniture, toppled),
     .unit = "",
     .meaning = "already lies on that face"},
};

static const Parameter room_rows[] = {
    ID(Room, id, "name for references"),
    NAME(Room, name, "displayed name"),
    POINTS(Room, outline, 3, true, "outline"),
};

static const Parameter exit_rows[] = {
    ID(Exit, id, "name of the exit"),
    POINT(Exit, from, "one end of the line to cross"),
    POINT(Exit, to, "other end of the line to cross"),
    NUMBER(Exit, opens, "s", 0, 1e6, 0, "usable from", "from the beginning"),
    NUMBER(Exit, closes, "s", 0, HUGE_VAL, HUGE_VAL, "usable until; absent: always", "always"),
};

static const Parameter person_rows[] = {
    ID(Person, id, "name of the person"),
    ID(Person, profile, "a profile in assets/profiles"),
    POINT(Person, at, "start of the reference point: the drive axle's middle, or a round body's centre"),
    NUMBER(Person, heading, "degree", -360, 360, 0, "heading at the start", "along +x"),
    NUMBER(Person, delay, "s", 0, 1e6, 0, "time before starting", "none"),
    NUMBER(Person, speed, "m/s", 0, 10, 0, "free speed; 0: the profile's mean", "the profile's mean"),
};

static const Parameter crowd_rows[] = {
    ID(Crowd, id, "name of the crowd; its people are NAME-1, NAME-2, ..."),
    ID(Crowd, profile, "a profile in assets/profiles"),
    WHOLE(Crowd, count, 1, 1e5, 1, true, "number of people", ""),
    POINTS(Crowd, area, 3, true, "outline of the area in which the seed places them"),
    NUMBER(Crowd, delay, "s", 0, 1e6, 0, "time before starting", "none"),
};

static const Parameter observed_rows[] = {
    NUMBER(Observed, mean, "s", 0, 1e6, 0, "mean time of the measured runs; absent: that of times", "that of times"),
    NUMBER(Observed, deviation, "s", 0, 1e6, 0, "their standard deviation; absent: that of times", "unknown"),
    WHOLE(Observed, runs, 1, 1e6, 1, false, "number of runs; absent: that of times", "one"),
    {.name = "times",
     .kind = PARAMETER_NUMBERS,
     .offset = offsetof(Observed, times),
     .unit = "s",
     .low = 0.001,
     .high = 1e6,
     .meaning = "time of each run"},
    {.name = "drivers",
     .kind = PARAMETER_IDS,
     .offset = offsetof(Observed, drivers),
     .unit = "",
     .meaning = "who drove each run, in the order of times; equal ids are the same person"},
    WHOLE(Observed, touches, -1, 1e6, -1, false, "runs in which something was touched; -1: not counted", "not counted"),
};

static const ParameterTable observed_table = TABLE("observed", observed_rows);

static const Parameter route_rows[] = {
    ID(PlanRoute, id, "name of the route"),
    {.name = "people",
     .kind = PARAMETER_IDS,
     .offset = offsetof(PlanRoute, people),
     .unit = "",
     .needed = true,
     .meaning = "the people and crowds that take it"},
    POINTS(PlanRoute, via, 0, false, "points to pass within a body's length, in order"),
    {.name = "exit",
     .kind = PARAMETER_ID,
     .offset = offsetof(PlanRoute, exit),
     .unit = "",
     .meaning = "exit of the route; absent: the quickest"},
    {.name = "observed",
     .kind = PARAMETER_TABLE,
     .offset = offsetof(PlanRoute, observed),
     .unit = "",
     .table = &observed_table,
     .meaning = "measured times"},
};

static const Parameter run_rows[] = {
    NUMBER(RunSettings, dt, "s", 1e-6, 0.1, 0.001, "time step", "chosen: times change by under 0.01 % when halved"),
    NUMBER(RunSettings, until, "s", 0, 1e5, 600, "time to give up at", "chosen"),
    NUMBER(RunSettings, sample, "s", 1e-6, 100, 0.04, "time between two rows of the trace", "chosen: 25 per second"),
    CHOICE(RunSettings, routes, "together|alone", ROUTES_TOGETHER,
           "all people together, or each route's people alone, as in an experiment"),
    NUMBER(RunSettings, cell, "m", 0.01, 0.2, 0.05, "cell of the route search", "chosen"),
    WHOLE(RunSettings, reversals, 0, 20, 6, false, "largest number of changes of direction in a drivable route",
          "assumed"),
    NUMBER(RunSettings, patience, "s", 0.1, 1e4, 20, "time without getting on before a person counts as blocked",
           "assumed"),
    NUMBER(RunSettings, clearance_warning, "m", 0, 2, 0.05, "clearance below which a place is dangerous", "assumed"),
    NUMBER(RunSettings, force_warning, "N", 0, 1e6, 50, "contact force above which a place is dangerous", "assumed"),
    NUMBER(RunSettings, loss_warning, "s", 0, 1e4, 1, "lost time above which a place is a hindrance", "assumed"),
    CHOICE(
        RunSettings, ring, "auto|push|steer|off", RING_AUTO,
        "what the personal space does to a driver: it pushes the body as in the paper, or it is what the driver steers "
        "by; auto: steer, but push the nominal driver among people on foot"),
    CHOICE(RunSettings, wander, "on|off", SWITCH_ON, "errors of steering, of all drivers but the nominal one"),
    CHOICE(RunSettings, hands, "on|off", SWITCH_ON, "the space for hands at the rims"),
    CHOICE(RunSettings, centripetal, "on|off", SWITCH_ON, "F4 of the paper's chairs"),
    CHOICE(RunSettings, lateral, "on|off", SWITCH_ON,
           "lateral control of the paper's chairs, which is not in the paper"),
};

const ParameterTable plan_tables_run = TABLE("run", run_rows);

static const Parameter drivers_rows[] = {
    WHOLE(PlanDrivers, count, 0, DRIVERS_MOST, 0, true, "drivers of a population besides the nominal one; 0: none", ""),
    NAME(PlanDrivers, population, "one of assets/populations, or a file; absent: manual-jp"),
};

const ParameterTable plan_tables_drivers = TABLE("drivers", drivers_rows);

static const Parameter background_rows[] = {
    {.name = "image",
     .kind = PARAMETER_TEXT,
     .offset = offsetof(Background, image),
     .unit = "",
     .needed = true,
     .meaning = "file of a picture, relative to the folder of the house file"},
    POINT(Background, at, "lower left corner of the picture"),
    NEEDED_NUMBER(Background, width, "m", 0.01, FARTHEST, "its width"),
    NUMBER(Background, angle, "degree", -360, 360, 0, "turned counter-clockwise about that corner by",
           "along the axes"),
    NUMBER(Background, opacity, "1", 0, 1, 0.5, "how much of it is seen", "chosen"),
    {.name = "digest",
     .kind = PARAMETER_TEXT,
     .offset = offsetof(Background, digest),
     .unit = "",
     .meaning = "of the file's bytes, by which it is known again"},
};

const ParameterTable plan_tables_background = TABLE("background", background_rows);

#define COMPONENT(struct_, point_, axis_, meaning_)                                                                    \
    {                                                                                                                  \
        .name = #point_ "." #axis_, .kind = PARAMETER_NUMBER, .offset = offsetof(struct_, point_.axis_), .unit = "m",  \
        .low = -FARTHEST, .high = FARTHEST, .meaning = meaning_                                                        \
    }
#define COMPONENTS(struct_, point_, meaning_)                                                                          \
    COMPONENT(struct_, point_, x, meaning_ ", along x"), COMPONENT(struct_, point_, y, meaning_ ", along y")

static const Parameter furniture_components[] = {
    COMPONENTS(Furniture, centre, "middle of the footprint"),
    COMPONENTS(Furniture, size, "footprint"),
};

static const Parameter exit_components[] = {
    COMPONENTS(Exit, from, "one end of the exit"),
    COMPONENTS(Exit, to, "the other end of the exit"),
};

static const Parameter person_components[] = {COMPONENTS(Person, at, "start of the reference point")};

#define LIST(key_, what_, rows_, components_, array_, count_, type_)                                                   \
    { key_, TABLE(what_, rows_), components_, offsetof(Plan, array_), offsetof(Plan, count_), sizeof(type_) }
#define NO_COMPONENTS                                                                                                  \
    { NULL, NULL, 0 }

const PlanList plan_tables_lists[PLAN_LISTS] = {
    [LIST_WALLS] = LIST("walls", "wall", wall_rows, NO_COMPONENTS, walls, wall_count, Wall),
    [LIST_DOORS] = LIST("doors", "door", door_rows, NO_COMPONENTS, doors, door_count, Door),
    [LIST_FURNITURE] = LIST("furniture", "furniture", furniture_rows, TABLE("furniture", furniture_components),
                            furniture, furniture_count, Furniture),
    [LIST_ROOMS] = LIST("rooms", "room", room_rows, NO_COMPONENTS, rooms, room_count, Room),
    [LIST_EXITS] = LIST("exits", "exit", exit_rows, TABLE("exit", exit_components), exits, exit_count, Exit),
    [LIST_PEOPLE] =
        LIST("people", "person", person_rows, TABLE("person", person_components), people, person_count, Person),
    [LIST_CROWDS] = LIST("crowds", "crowd", crowd_rows, NO_COMPONENTS, crowds, crowd_count, Crowd),
    [LIST_ROUTES] = LIST("routes", "route", route_rows, NO_COMPONENTS, routes, route_count, PlanRoute),
};

void *plan_tables_allocate(Plan *plan, const PlanList *list, size_t count) {
    void *array = arena_allocate(&plan->arena, count * list->size);
    *(void **)((char *)plan + list->array) = array;
    *(size_t *)((char *)plan + list->count) = count;
    return array;
}

void *plan_tables_element(const Plan *plan, const PlanList *list, size_t index) {
    char *array = *(char *const *)((const char *)plan + list->array);
    return array + index * list->size;
}

size_t plan_tables_count(const Plan *plan, const PlanList *list) {
    return *(const size_t *)((const char *)plan + list->count);
}

const char *plan_tables_id(const Plan *plan, const PlanList *list, size_t index) {
    return *(const char *const *)plan_tables_element(plan, list, index);
}

/* A hash table with open addressing, at most half full. An id that has changed leaves its old slot behind, which is
 * then skipped, since the element itself holds its present id. */
typedef struct IndexSlot {
    const PlanList *list; /* NULL: empty */
    size_t index;
} IndexSlot;

typedef struct PlanIndex {
    IndexSlot *slots; /* (size) */
    size_t size;      /* a power of two */
} PlanIndex;

static bool slot_has(const Plan *plan, const IndexSlot *slot, const PlanList *list, const char *id) {
    return slot->list == list && strcmp(plan_tables_id(plan, list, slot->index), id) == 0;
}

/* Returns the slot of the id, or the empty slot where it belongs. */
static IndexSlot *find_slot(const Plan *plan, const PlanList *list, const char *id) {
    const PlanIndex *index = plan->index;
    uint64_t hash = 0xcbf29ce484222325u + (uint64_t)(list - plan_tables_lists); /* FNV-1a */
    for (const char *c = id; *c; c++)
        hash = (hash ^ (unsigned char)*c) * 0x100000001b3u;
    size_t at = (hash ^ hash >> 32) & (index->size - 1);
    while (index->slots[at].list && !slot_has(plan, &index->slots[at], list, id))
        at = (at + 1) & (index->size - 1);
    return &index->slots[at];
}

void plan_tables_renamed(Plan *plan, const PlanList *list, size_t index) {
    IndexSlot *slot = find_slot(plan, list, plan_tables_id(plan, list, index));
    if (!slot->list) /* a repeated id, which is an error, finds its first element */
        *slot = (IndexSlot){list, index};
}

void plan_tables_index(Plan *plan, size_t changes) {
    size_t count = changes;
    for (size_t l = 0; l < PLAN_LISTS; l++)
        count += plan_tables_count(plan, &plan_tables_lists[l]);
    plan->index = arena_allocate(&plan->arena, sizeof *plan->index);
    plan->index->size = 16;
    while (plan->index->size < 2 * count)
        plan->index->size *= 2;
    plan->index->slots = arena_allocate(&plan->arena, plan->index->size * sizeof *plan->index->slots);
    for (size_t l = 0; l < PLAN_LISTS; l++)
        for (size_t i = 0; i < plan_tables_count(plan, &plan_tables_lists[l]); i++)
            plan_tables_renamed(plan, &plan_tables_lists[l], i);
}

size_t plan_tables_find(const Plan *plan, const PlanList *list, const char *id) {
    const IndexSlot *slot = find_slot(plan, list, id);
    return slot->list ? slot->index : SIZE_MAX;
}
