/* The time to the goal from every place, which guides the search for a route.
 *
 * The time is that of a disc that always fits inside the body, by Dijkstra's method on the grid of distances, 16
 * neighbours a point, with the speed law of the driver: v = (W - w) / b between v_min and v_free, W twice the distance
 * to the nearest obstacle. A closed door costs its opening time. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "base/stop.h"
#include "space/freespace.h"
#include "plan/plan.h"
#include "plan/profile.h"

/* The end of a leg of a route: within `radius` of a point, or across one of several lines. */
typedef struct Goal {
    Vec2 at;             /* m */
    double radius;       /* m; 0: across an exit */
    size_t exit;         /* SIZE_MAX: any usable exit */
    double time;         /* s, time from which an exit must be usable */
    double opens_before; /* s: exits that open at that time or later do not count; 0: all count */
} Goal;

/* A disc that no time leads through, since the body cannot pass there although the disc can (settle.c). */
typedef struct FieldBar {
    Vec2 at;       /* m */
    double radius; /* m */
} FieldBar;

enum { FIELD_BARS_MOST = 4 };

typedef struct FieldBars {
    FieldBar all[FIELD_BARS_MOST]; /* (count) */
    size_t count;
} FieldBars;

typedef struct DoorLine {
    Vec2 from, to; /* m */
    double delay;  /* s */
} DoorLine;

typedef struct Ground {
    const Plan *plan;
    const FreeSpace *space;
    const Profile *profile;
    float *slowness;      /* (ny x nx) s/m; 0 where the disc does not pass */
    double free_from;     /* m: nothing slows a driver down who is as far from all obstacles */
    unsigned char *doors; /* (ny x nx) 1: near a closed door; NULL: no closed door */
    DoorLine *lines;      /* (line_count) */
    size_t line_count;
    FieldBars bars;
    const Stop *stop; /* set: searches on this ground stop; NULL: never */
} Ground;

/* The times are computed as far as they are asked for, by any thread. */
typedef struct Field {
    const Ground *ground;
    float *time; /* (ny x nx) s to the goal, infinite where the goal cannot be reached; known where field_know was */
    struct Spread *spread; /* that computes them */
} Field;

/* Prepares the ground for discs of `radius` m. field_ground_clear releases it. */
void field_ground_init(Ground *ground, const Plan *plan, const FreeSpace *space, const Profile *profile, double radius);
/* Does the same without the allowance for the grid's rounding: every point that is let through is truly free. */
void field_ground_init_exact(Ground *ground, const Plan *plan, const FreeSpace *space, const Profile *profile,
                             double radius);
/* Bars the ground, before a field is computed on it. */
void field_ground_bar(Ground *ground, const FieldBars *bars);
void field_ground_clear(Ground *ground);

/* Returns the speed of the steering law, m/s, where the nearest obstacle is `distance` m from the body's middle. */
double field_speed(const Profile *profile, double distance);

#define FIELD_COMFORT 0.10 /* m */

/* Returns the factor, at least 1, by which time counts more at a clearance (m) below FIELD_COMFORT. */
double field_discomfort(double clearance);

/* Returns the delay of closed doors on the straight line between two places, s. */
double field_delay(const Ground *ground, Vec2 from, Vec2 to);

/* Returns the goal across `exit`, or across any exit for SIZE_MAX, for a person who starts at `time` s, of those that
 * open before `opens_before`, s (0: any). */
Goal field_exit_goal(size_t exit, double time, double opens_before);

/* True if the exit counts, and is or will be open, for a person who starts at the goal's time. */
bool field_exit_usable(const Goal *goal, const Plan *plan, size_t exit);

/* True if a straight motion ends the leg: it ends near the point, or plan_geometry_leads_out says that it leads out.
 * `*exit` tells where (SIZE_MAX: nowhere). */
bool field_goal_reached(const Goal *goal, const Plan *plan, Vec2 from, Vec2 to, size_t *exit);

/* Begins at a goal. field_clear releases the field. */
void field_init(Field *field, const Ground *ground, const Goal *goal);
void field_clear(Field *field);

/* Computes the times of the points [low_x, high_x) x [low_y, high_y) of the grid. */
void field_know(const Field *field, int low_x, int low_y, int high_x, int high_y);

/* Returns the time from a place, s, interpolated; infinite where there is no path. */
double field_time(const Field *field, Vec2 at);

/* Notes what field_time reads for a place. */
void field_note_time(const Field *field, Vec2 at, Reads *reads);
