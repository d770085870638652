/* A house as described by its file: walls, doors, furniture, rooms, exits, people and their routes.
 *
 * SI units; x to the right, y up; angles in degrees counter-clockwise from +x, as in the file. A wall is a centre line
 * with a thickness; a door lies on one segment of its wall. Parameter tables describe everything; reading, writing,
 * errors, `--set` and assets/schema/house.schema.json follow from them. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "base/fault.h"
#include "base/memory.h"
#include "base/parameters.h"
#include "base/vec2.h"

typedef struct Wall {
    const char *id;
    Points points;    /* m, the centre line, at least two points; a closed wall repeats its first point */
    double thickness; /* m */
    double height;    /* m */
    bool closed_exit; /* True if it stands for the line of an exit that has closed (closed.h); never in a file */
} Wall;

typedef enum DoorKind { DOOR_OPENING, DOOR_HINGED, DOOR_SLIDING } DoorKind;
typedef enum DoorState { DOOR_OPEN, DOOR_CLOSED, DOOR_LOCKED } DoorState;
typedef enum DoorHinge { HINGE_START, HINGE_END } DoorHinge;
typedef enum DoorSwing { SWING_LEFT, SWING_RIGHT } DoorSwing;

typedef struct Door {
    const char *id;
    const char *wall;
    int segment;         /* segment of the wall's points, from 0 */
    double at;           /* m, position of the door's middle along the segment */
    double width;        /* m, clear width */
    int kind;            /* DoorKind */
    int state;           /* DoorState */
    int hinge;           /* DoorHinge: the end of the segment that is nearer to the hinge */
    int swing;           /* DoorSwing: the side of the wall's direction to which the leaf opens */
    double opening_time; /* s, from touching the handle of a closed door to passing */
    double leaf;         /* m, thickness of a hinged door's leaf */
    double rest;         /* m, of the width that the open leaf of a sliding door still covers */
    bool closer;         /* True if it closes by itself */
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
    double probability; /* 1, probability of toppling in a shake */
    bool toppled;       /* True if it lies on that face: the footprint includes the height */
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

/* A `place` in a house file begins the errors about it: "file:line:column: ", or "--set NAME: ". */

typedef struct Person {
    const char *id;
    const char *profile;
    Vec2 at;        /* m, the reference point: the drive axle's middle, or a round body's centre */
    double heading; /* degree */
    double delay;   /* s, before starting */
    double speed;   /* m/s, the free speed; 0: the profile's */
    size_t route;   /* resolved: index of the route of the person; SIZE_MAX: none */
    const char *place;
} Person;

typedef struct Crowd {
    const char *id;
    const char *profile;
    int count;
    Points area; /* m, an outline */
    double delay;
    size_t route; /* resolved, as for a person */
    const char *place;
} Crowd;

/* Measured runs of a route, as the file gives them: see plan/observed_times.h. */
typedef struct Observed {
    double mean;      /* s; 0: not given */
    double deviation; /* s; 0: not given */
    int runs;
    NumberList times; /* s, of each run */
    Ids drivers;      /* who drove each run; none: not given */
    int touches;      /* runs in which something was touched; -1: not counted */
} Observed;

typedef struct PlanRoute {
    const char *id;
    Ids people; /* people and crowds */
    Points via; /* m, points to pass within a body's length, in order */
    const char *exit;
    Observed observed;
    size_t exit_index; /* resolved from `exit`; SIZE_MAX: the quickest */
} PlanRoute;

typedef enum RunRoutes { ROUTES_TOGETHER, ROUTES_ALONE } RunRoutes;

/* What the personal space does to a chair in `driver`: see drive.c. */
typedef enum Ring { RING_AUTO, RING_PUSHES, RING_STEERS, RING_OFF } Ring;

typedef enum Switch { SWITCH_ON, SWITCH_OFF } Switch;

/* Settings of a run. */
typedef struct RunSettings {
    double dt;                /* s, the step */
    double until;             /* s, time limit */
    double sample;            /* s, between rows of the trace */
    int routes;               /* RunRoutes: all people together, or each route's people alone, as in an experiment */
    double cell;              /* m, of the grids of the route search */
    int reversals;            /* most changes of direction that a drivable route may need */
    double patience;          /* s without progress after which a person is blocked */
    double clearance_warning; /* m, a smaller clearance is a danger */
    double force_warning;     /* N, a harder contact is a danger */
    double loss_warning;      /* s, a place that costs more time is a hindrance */
    int ring;                 /* Ring */
    int wander, hands;        /* Switch, of drivers */
    int centripetal, lateral; /* Switch, of the paper's chairs */
} RunSettings;

/* A profile parameter that this house changes. */
typedef struct Override {
    const char *name;  /* "profile.manual-chair.width" */
    const char *value; /* as JSON */
    const char *place;
} Override;

/* Drivers that a house asks for besides the nominal one. */
typedef struct PlanDrivers {
    int count;              /* 0: none */
    const char *population; /* an id, or a file relative to the house file's folder; "": the usual one */
    const char *place;
} PlanDrivers;

/* A picture used as a template for the plan. */
typedef struct Background {
    const char *image;  /* its file, relative to the house file's folder; NULL: none */
    Vec2 at;            /* m, its lower left corner */
    double width;       /* m */
    double angle;       /* degree, about that corner */
    double opacity;     /* 1 */
    const char *digest; /* digest of the file's bytes, which identifies it; "": unknown */
} Background;

/* A zeroed plan is empty. plan_free releases it. */
typedef struct Plan {
    const char *path; /* path of its file, as given */
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
    PlanDrivers drivers;
    Background background;
    struct PlanIndex *index; /* finds elements by id */
    Arena arena;             /* memory of all of the above */
} Plan;

/* Reads a house file, then applies `settings` ("door.d1.width=0.8", setting_count of them, NULL when 0) and checks the
 * whole. Returns false after an error, with the plan unchanged. */
bool plan_read(Plan *plan, const char *path, const char *const *settings, size_t setting_count, Fault *fault);

/* Does the same with a house file's `text`, ended by 0, which need not be on disk: errors and plan->path use `path`. */
bool plan_read_text(Plan *plan, const char *path, const char *text, const char *const *settings, size_t setting_count,
                    Fault *fault);

/* Does the same with a house file's values; an error begins with the element, "door d1: ", if its text does not name
 * it. */
bool plan_read_values(Plan *plan, const char *path, json_t *values, Fault *fault);

/* Returns the parameter of a setting's NAME, "door.d1.width" or "person.p1.at.x", and the object that holds it. NULL:
 * an error, which begins with `place` and names the possible parameters. */
const Parameter *plan_parameter(const Plan *plan, const char *name, const void **object, const char *place,
                                Fault *fault);

/* True if the name is "profile.ID.NAME", which is only known after the profiles are read. */
bool plan_is_of_profile(const char *name);

/* Writes the plan, so that reading it gives the same plan, to a temporary file that is then renamed. Returns 0 or
 * errno. */
int plan_write(const Plan *plan, const char *path);

/* Returns the text that plan_write writes; memory_free it. */
char *plan_text(const Plan *plan);

void plan_free(Plan *plan);

/* Returns the JSON Schema (2020-12) of a house file, made from the tables. New; json_decref it. */
json_t *plan_schema(void);

/* Return the index of an id among the people, routes, doors or exits, or SIZE_MAX. */
size_t plan_find_person(const Plan *plan, const char *id);
size_t plan_find_route(const Plan *plan, const char *id);
size_t plan_find_door(const Plan *plan, const char *id);
size_t plan_find_exit(const Plan *plan, const char *id);

/* Returns the route that lists the person or crowd, or NULL. */
const PlanRoute *plan_route_of(const Plan *plan, const char *id);
