/* A house as its file gives it: walls, doors, furniture, rooms, exits, people and their routes.
 *
 * SI units; x to the right, y up; angles in degrees counter-clockwise from +x, as in the file. A wall is a centre line
 * with a thickness; a door lies on one segment of its wall. Everything is described by parameter tables, from which
 * reading, writing, faults, `--set` and assets/schema/house.schema.json follow. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "base/fault.h"
#include "base/memory.h"
#include "base/parameters.h"
#include "base/vec2.h"

typedef struct Wall {
    const char *id;
    Points points;    /* m, the centre line, two or more; a closed wall repeats its first point */
    double thickness; /* m */
    double height;    /* m */
} Wall;

typedef enum DoorKind { DOOR_OPENING, DOOR_HINGED, DOOR_SLIDING } DoorKind;
typedef enum DoorState { DOOR_OPEN, DOOR_CLOSED, DOOR_LOCKED } DoorState;
typedef enum DoorHinge { HINGE_START, HINGE_END } DoorHinge;
typedef enum DoorSwing { SWING_LEFT, SWING_RIGHT } DoorSwing;

typedef struct Door {
    const char *id;
    const char *wall;
    int segment;         /* of the wall's points, from 0 */
    double at;           /* m along the segment, of the door's middle */
    double width;        /* m, clear */
    int kind;            /* DoorKind */
    int state;           /* DoorState */
    int hinge;           /* DoorHinge: the end of the segment that is nearer to the hinge */
    int swing;           /* DoorSwing: the side of the wall's direction to which the leaf opens */
    double opening_time; /* s, from touching the handle of a closed door to passing */
    size_t wall_index;   /* resolved from `wall` */
} Door;

typedef enum ToppleFace { TOPPLE_FRONT, TOPPLE_BACK, TOPPLE_LEFT, TOPPLE_RIGHT, TOPPLE_NO } ToppleFace;

typedef struct Furniture {
    const char *id;
    const char *name;
    Vec2 centre;        /* m */
    Vec2 size;          /* m, along its own x and y before turning */
    double angle;       /* degree */
    double height;      /* m */
    int topples;        /* ToppleFace: front is its own -y, back +y, left -x, right +x */
    double probability; /* 1, of toppling in a shake */
    bool toppled;       /* lies on that face: the footprint has grown by the height */
} Furniture;

typedef struct Room {
    const char *id;
    const char *name;
    Points outline; /* m */
} Room;

typedef struct Exit {
    const char *id;
    Vec2 from, to; /* m */
    double opens;  /* s */
    double closes; /* s; infinite: never */
} Exit;

/* A `place`, of what is in a house file, begins the faults about it: "file:line:column: ", or "--set NAME: ". */

typedef struct Person {
    const char *id;
    const char *profile;
    Vec2 at;        /* m, the reference point: the drive axle's middle, or a round body's centre */
    double heading; /* degree */
    double delay;   /* s, before starting */
    double speed;   /* m/s, the free speed; 0: the profile's */
    size_t route;   /* resolved: the place of the route that lists them; SIZE_MAX: none */
    const char *place;
} Person;

typedef struct Crowd {
    const char *id;
    const char *profile;
    int count;
    Points area; /* m, an outline */
    double delay;
    size_t route; /* resolved, as a person's */
    const char *place;
} Crowd;

/* What somebody measured for a route; mean 0: nobody has. */
typedef struct Observed {
    double mean;      /* s */
    double deviation; /* s */
    int runs;
} Observed;

typedef struct PlanRoute {
    const char *id;
    Ids people; /* and crowds */
    Points via; /* m, passed within a body's length, in order */
    const char *exit;
    Observed observed;
    size_t exit_index; /* resolved from `exit`; SIZE_MAX: the quickest */
} PlanRoute;

typedef enum RunRoutes { ROUTES_TOGETHER, ROUTES_ALONE } RunRoutes;

/* How to run the house. */
typedef struct RunSettings {
    double dt;                /* s, the step */
    double until;             /* s, when to give up */
    double sample;            /* s, between rows of the trace */
    int routes;               /* RunRoutes: everybody at once, or each route's people alone, as in an experiment */
    double cell;              /* m, of the grids of the route search */
    int reversals;            /* most changes of direction that a drivable route may need */
    double patience;          /* s without getting on after which a person is blocked */
    double clearance_warning; /* m, a body nearer to something than this is in danger */
    double force_warning;     /* N, a contact harder than this is a danger */
    double loss_warning;      /* s, a place that costs more than this is a hindrance */
} RunSettings;

/* A parameter of a profile that this house changes. */
typedef struct Override {
    const char *name;  /* "profile.manual-chair.width" */
    const char *value; /* as JSON */
    const char *place;
} Override;

/* A picture that the plan was traced over. */
typedef struct Background {
    const char *image;  /* its file, from the house file's folder on; NULL: there is none */
    Vec2 at;            /* m, its lower left corner */
    double width;       /* m */
    double angle;       /* degree, about that corner */
    double opacity;     /* 1 */
    const char *digest; /* of the file's bytes, by which it is known again; "": unknown */
} Background;

/* Zero is an empty plan. plan_free releases what a reader filled. */
typedef struct Plan {
    const char *path; /* of its file, as given */
    const char *name;
    const char *note;
    Wall *walls; /* (wall_count), and so on */
    Door *doors;
    Furniture *furniture;
    Room *rooms;
    Exit *exits;
    Person *people;
    Crowd *crowds;
    PlanRoute *routes;
    Override *overrides;
    size_t wall_count, door_count, furniture_count, room_count, exit_count, person_count, crowd_count, route_count;
    size_t override_count;
    RunSettings run;
    Background background;
    struct PlanIndex *index; /* finds what has an id */
    Arena arena;             /* holds all of the above */
} Plan;

/* Reads a house file, then applies `settings` ("door.d1.width=0.8", setting_count of them, NULL when 0) and checks
 * the whole. False: faults say where and what, and the plan is as it was. */
bool plan_read(Plan *plan, const char *path, const char *const *settings, size_t setting_count, Fault *fault);

/* The same of a house file's `text`, ended by 0, which need not be on the disk: faults and plan->path are of `path`. */
bool plan_read_text(Plan *plan, const char *path, const char *text, const char *const *settings, size_t setting_count,
                    Fault *fault);

/* The same of a house file's values; a fault begins with what it is about, "door d1: ", where it does not say that. */
bool plan_read_values(Plan *plan, const char *path, json_t *values, Fault *fault);

/* The parameter that a setting's NAME means, "door.d1.width" or "person.p1.at.x", and what has it. NULL: a fault, which
 * begins with `place`, says what there is instead. */
const Parameter *plan_parameter(const Plan *plan, const char *name, const void **object, const char *place,
                                Fault *fault);

/* Is it "profile.ID.NAME", which only whoever has read the profiles can find? */
bool plan_is_of_profile(const char *name);

/* Writes the plan so that reading it again gives the same plan. Beside and renamed. 0, or errno. */
int plan_write(const Plan *plan, const char *path);

/* What plan_write writes; memory_free it. */
char *plan_text(const Plan *plan);

void plan_free(Plan *plan);

/* JSON Schema (2020-12) of a house file, made from the tables. New; json_decref it. */
json_t *plan_schema(void);

/* The place of an id among the people, or SIZE_MAX; and so on. */
size_t plan_find_person(const Plan *plan, const char *id);
size_t plan_find_route(const Plan *plan, const char *id);
size_t plan_find_door(const Plan *plan, const char *id);
size_t plan_find_exit(const Plan *plan, const char *id);

/* The route that lists the person or crowd, or NULL. */
const PlanRoute *plan_route_of(const Plan *plan, const char *id);
