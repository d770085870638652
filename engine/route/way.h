/* The way of a chair as stations that can be moved: what relax.c makes free and hasten.c makes quick.
 *
 * A piece is a part without a change of direction or a turn on the spot. Its stations lie one `step` apart; the axis of
 * an inner one is that of the line from the station before it to the one after it, so that the drive axle never slips
 * sideways. At a joint, where two pieces meet, each has a station at the same place; the headings there are free
 * numbers, the same on both sides unless the chair turns on the spot. The way ends straight. */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "route/search.h"
#include "space/freespace.h"

typedef struct Station {
    Vec2 at;   /* m, the middle of the drive axle */
    Vec2 axis; /* unit, of the body */
    size_t piece;
} Station;

typedef struct WayPiece {
    size_t first, last; /* its stations, at least WAY_SHORTEST steps */
    int direction;      /* +1 forwards, -1 backwards */
    double step;        /* m, between stations */
} WayPiece;

enum { WAY_SHORTEST = 3 };

/* The headings at the beginning of a piece: joint 0 is the start, whose `in` is given. */
typedef struct Joint {
    double in, out; /* rad, the same number unless the chair turns on the spot */
    bool turns;     /* True if it does */
} Joint;

/* A place that the way passes. */
typedef struct WayPin {
    Vec2 at;        /* m */
    double radius;  /* m */
    size_t station; /* the nearest one */
} WayPin;

typedef struct Way {
    Station *stations; /* (count); owned, as all below */
    size_t count;
    WayPiece *pieces; /* (piece_count) */
    Joint *joints;    /* (piece_count) joint k is before piece k */
    size_t piece_count;
    WayPin *pins; /* (pin_count) in their order along the way */
    size_t pin_count;
    const Exit *exit; /* its end lies on this line, a hair behind it; not owned */
} Way;

/* Makes a way of a searched track that crosses the exit with its last motion, about `spacing` m between stations, and
 * passes `pin_count` goals in order. way_free releases it; piece_count 0: the track does not move. */
Way way_of_track(const SearchTrack *track, const Exit *exit, const Goal *pins, size_t pin_count, double spacing);
Way way_copy(const Way *way);

/* Returns a digest of the stations, pieces and joints. */
uint64_t way_digest(const Way *way);

/* Makes one piece of each two that meet at a turn on the spot without a change of direction: there it has a kink.
 * Returns false if there is none. */
bool way_join(Way *way);

/* Gives each change of direction at which the way turns on the spot one heading, after `share` (0 to 1) of that turn.
 * Returns false if there is none. */
bool way_straighten_cusps(Way *way, double share);

/* Leaves piece k out if it is at most `most` m long and not the last one. Two pieces in one direction become one, with
 * a kink; else the next one begins where the one before it ends, or at the start. Returns false if it stays. */
bool way_drop(Way *way, size_t k, double most);
void way_free(Way *way);

/* Spaces the stations again, about `spacing` m apart, along the same curve. */
void way_resample(Way *way, double spacing);

/* Adds the poses of the way, turns on the spot in steps of 5 degrees, after the start's pose. */
void way_write(const Way *way, SearchTrack *track);

/* Derives the axes of the stations low to high from their places and the joints. */
void way_set_axes(Way *way, size_t low, size_t high);

/* Returns the place and the axis at `part`, 0 to 1, of the step from a station to the next one of its piece. */
Station way_between(const Way *way, size_t station, double part);

/* Returns the number of places between a station and the next one, 1 to WAY_MOST_BETWEEN, at which to look at the body:
 * the more it turns the more. */
int way_places(const Way *way, size_t station);

enum { WAY_MOST_BETWEEN = 6 };

/* A place on the step from a station to the next one of its piece. */
typedef struct WayPlace {
    double part;      /* 1, of the step */
    double clearance; /* m, of the body, up to some reach */
} WayPlace;

/* Returns the clearance of the body, m, up to `reach`, at `part` of the step from a station to the next one. */
double way_clearance_between(const Way *way, size_t station, double part, const FreeSpace *space, const Rectangle *body,
                             double reach);

/* True if the body does not come nearer than `least` m to anything between two places of a step, to half a millimetre:
 * while it moves straight ahead it comes no nearer than at both, and while it turns no nearer than its corners move. */
bool way_stays_clear(const Way *way, size_t station, const FreeSpace *space, const Rectangle *body, WayPlace from,
                     WayPlace to, double least, double reach);

/* Returns the number of changes of direction. */
int way_reversals(const Way *way);

/* True if between the stations low and high each step turns by no more than 0.25 rad, and leads along the mean of its
 * axes to 0.05: the stations are near enough to each other for the curve. */
bool way_is_smooth(const Way *way, size_t low, size_t high);

/* True if between the stations low and high no step is much longer or shorter than the step of its piece: the averages
 * over some stations are those over as much of the way. */
bool way_is_even(const Way *way, size_t low, size_t high);

/* True if way_is_even holds, but for steps that were already as short or as long when the stations were those of
 * `before` (count). */
bool way_stays_even(const Way *way, const Station *before, size_t low, size_t high);

/* True if the way passes its pins, and crosses its exit. */
bool way_reaches_goals(const Way *way);

/* Returns how far, m, the last station may move along the exit's line: [low, high] of the distance from its beginning.
 */
void way_exit_range(const Way *way, double *low, double *high);

/* Returns the least clearance of the body, m, up to `reach`, at the stations, half-way between them, and on the spot.
 */
double way_clearance(const Way *way, const FreeSpace *space, const Rectangle *body, double reach);

/* Returns the least clearance of the body, m, up to `reach`, in the turn on the spot before a piece; `reach` if there
 * is none. The error is at most 1 mm for a body within 1 m of its axle. */
double way_spot_clearance(const Way *way, size_t piece, const FreeSpace *space, const Rectangle *body, double reach);

/* True if every motion is proved free with a clearance of `margin` m, by halving each until its ends have room enough.
 */
bool way_swept(const Way *way, const FreeSpace *space, const Rectangle *body, double margin);
