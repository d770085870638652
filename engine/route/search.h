/* Searches the path of a chair by hybrid A* over the drive axle's middle, the heading, the direction of travel and the
 * number of changes of direction. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "route/field.h"
#include "route/fields.h"
#include "route/route.h"

/* The exact rectangle of the body. */
typedef struct Rectangle {
    double half_length, half_width; /* m */
    double ahead;                   /* m, from the axle to the rectangle's middle */
} Rectangle;

/* m: a pose counts as free only with at least this clearance, which makes it possible to prove that motions between
 * poses are free. */
#define SEARCH_CLEARANCE 0.0015

typedef struct SearchGrain {
    double cell;         /* m */
    double turn;         /* rad */
    double step;         /* m, of one motion */
    bool skids;          /* True if the body may also turn about its middle while the drive wheels skid sideways */
    double weight;       /* 1, weight of the remaining time (weighted A*; Pohl 1970) */
    size_t most_nodes;   /* nodes to expand, at most */
    int least_reversals; /* changes of direction: ways with fewer are not found */
} SearchGrain;

/* A searched path: poses some centimetres apart, the first one the start. */
typedef struct SearchTrack {
    Pose *poses; /* (count) */
    size_t count, capacity;
    int reversals;
    int direction; /* direction of the last motion along the path, 0: no motion yet */
    size_t exit;   /* exit crossed, or SIZE_MAX */
    double skid;   /* m, of the drive wheels sideways, in all */
} SearchTrack;

typedef enum SearchAnswer {
    SEARCH_FOUND,
    SEARCH_NONE,    /* every state at this grain has been tried */
    SEARCH_GAVE_UP, /* most_nodes reached */
    SEARCH_INTERRUPTED,
} SearchAnswer;

Rectangle search_body(const Profile *profile);

/* Returns the distance from the axle to the farthest corner of the body, m. */
double search_farthest(const Rectangle *body);

/* Returns the clearance of the body at a pose, m, up to `reach`. */
double search_clearance(const FreeSpace *space, const Rectangle *body, Vec2 at, double heading, double reach,
                        int *face);

/* Continues `track` from its last pose to the goal of `field`, with `least_reversals` to `most_reversals` changes of
 * direction in total; `times` notes which times of the field are read (NULL: not noted). The track is unchanged unless
 * SEARCH_FOUND is returned. */
SearchAnswer search_leg(SearchTrack *track, const Field *field, const FreeSpace *space, Reads *times, const Goal *goal,
                        const Rectangle *body, const SearchGrain *grain, int least_reversals, int most_reversals);

/* Returns the field that leads a search for the query to a goal: the caller must release it with fields_release. */
const Field *search_field(const RouteQuery *query, const Goal *goal, double radius);

/* Searches from the query's start through all goals in order, into `track`. `radius`: m, of a disc about the axle that
 * never leaves the body. `pins` (goal_count; may be NULL) are the indices of the poses at which the legs end. */
SearchAnswer search_legs(const RouteQuery *query, const Goal *goals, size_t goal_count, const Rectangle *body,
                         double radius, const SearchGrain *grain, int most_reversals, SearchTrack *track, size_t *pins);

void search_track_add(SearchTrack *track, Pose pose);
void search_track_clear(SearchTrack *track);
