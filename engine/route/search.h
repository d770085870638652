/* Search for a path of a chair: hybrid A* over the drive axle's middle, the heading, the direction of travel and the
 * number of changes of direction. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "route/field.h"
#include "route/route.h"

/* The exact rectangle that moves. */
typedef struct Rectangle {
    double half_length, half_width; /* m */
    double ahead;                   /* m, from the axle to the rectangle's middle */
} Rectangle;

/* A pose is taken for free only with this much clearance, m: it is what lets motions between poses be proven free. */
#define SEARCH_CLEARANCE 0.0015

typedef struct SearchGrain {
    double cell;       /* m */
    double turn;       /* rad */
    double step;       /* m, of one motion */
    double weight;     /* 1, of the time still to go (weighted A*; Pohl 1970) */
    size_t most_nodes; /* to expand */
} SearchGrain;

/* A path as it was searched: poses some centimetres apart, the first one the start. */
typedef struct SearchTrack {
    Pose *poses; /* (count) */
    size_t count, capacity;
    int reversals;
    int direction; /* of the last motion along the path, 0: none yet */
    size_t exit;   /* crossed, or SIZE_MAX */
} SearchTrack;

typedef enum SearchAnswer {
    SEARCH_FOUND,
    SEARCH_NONE,    /* nothing left to try at this grain */
    SEARCH_GAVE_UP, /* most_nodes */
} SearchAnswer;

Rectangle search_body(const Profile *profile);

/* The clearance of the body at a pose, m, up to `reach`. */
double search_clearance(const FreeSpace *space, const Rectangle *body, Vec2 at, double heading, double reach,
                        int *face);

/* Continues `track` from its last pose to the goal that `field` leads to, with at most `most_reversals` changes of
 * direction altogether. Leaves the track as it was unless SEARCH_FOUND. */
SearchAnswer search_leg(SearchTrack *track, const Field *field, const Goal *goal, const Rectangle *body,
                        const SearchGrain *grain, int most_reversals);

void search_track_add(SearchTrack *track, Pose pose);
void search_track_clear(SearchTrack *track);
