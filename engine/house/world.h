/* State of the moving house: people as distinct elements with a personal space. step.h advances it.
 *
 * A world points only to data that does not change while it moves, and owns all data that does, so that it can be
 * copied as a whole. */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "base/parallel.h"
#include "space/gap.h"
#include "house/house.h"
#include "house/journey.h"
#include "house/ride.h"
#include "house/walk.h"
#include "house/walkers.h"
#include "mechanics/clock.h"

typedef enum Phase {
    PHASE_ABSENT,  /* takes no part in this run */
    PHASE_WAITING, /* before the delay is over */
    PHASE_MOVING,
    PHASE_STUCK, /* stays there: no path, or blocked */
    PHASE_OUT,   /* has crossed an exit and is removed */
} Phase;

/* Parts of a chair that touch: its front is that of the footrest. A hand stands beside the rim: observation.h. */
typedef enum BodyPart { PART_FRONT, PART_SIDE, PART_TAIL, PART_HAND } BodyPart;

/* What surrounds and touches a person in this step. */
typedef struct Sense {
    double clearance;   /* m, to the nearest obstacle or person, up to the personal space's reach */
    double ring;        /* m, greatest compression of the personal space */
    double left, right; /* m, from a driver to obstacles ahead of the axle on that side, up to the reach */
    double body_force;  /* N, sum of the normal forces on the body */
    double ring_force;  /* N, sum of the normal forces on the personal space */
    Vec2 nearest_at;    /* m, nearest point */
    Vec2 contact_at;    /* m, point of the hardest contact */
    double impact; /* m/s, greatest speed along the normal of a chair's contact that begins in this step; 0: none */
    double energy; /* J, of that impact (touch.h) */
    double mass;   /* kg, its effective mass */
    int part;      /* BodyPart, of that impact */
    int other;     /* the nearest person, or -1: an obstacle or nothing */
} Sense;

/* Progress of a person along the track. */
typedef struct Drive {
    size_t index;      /* index of the last track point passed */
    double s;          /* m, along the track */
    double offset;     /* m, to the left of the track */
    double aside;      /* m, wanted offset, to let a person pass */
    double swerve;     /* m/s, rate of that offset */
    double aim;        /* m, a: how far left of the plan the driver aims with the front edge (aim.c) */
    double aim_slope;  /* 1, its change by way */
    int aimed;         /* direction of the piece of the path that a and y belong to; 0: none */
    double axle;       /* m, y: how far left of the plan the axle follows it */
    double felt;       /* 1/m, what the personal space adds to the bend of the aim, noticed so far */
    double gone;       /* m, way since the start, for the errors of steering */
    double error;      /* 1/m, the present one */
    double turned;     /* rad, of the plan over the last way, for the slip */
    double free_way;   /* m, s of the first place ahead where something is in the way; infinite: none */
    double pause;      /* s, remaining time of a change of direction */
    double best_s;     /* m, farthest s so far */
    double best_turn;  /* rad, least remaining part of a turn on the spot */
    double stalled;    /* s, without progress */
    double handle;     /* s, spent at a shut door's handle */
    bool retreats;     /* backs off before another attempt, */
    double retreat_to; /* m, along the track: to there, */
    double retreat_by; /* s: or until it has been stalled for this long */
    double room_by;    /* s: until it has been stalled for this long, the chair it makes room for waits; 0: for none */
    int retries;       /* attempts since the last progress */
    int plans;         /* number of new plans after having been pushed off the path */
    double heeded;     /* m/s, speed limit due to the people ahead, when last updated */
    double around;     /* m, offset at which they are passed */
    double way_round;  /* m, of way that it takes to come to that offset */
    double behind;     /* m, to the nearest person straight behind; infinite: none in sight */
    bool barred;       /* True if it is in the way of the plan itself */
    bool gives_way;    /* True if it stands in the way of a chair that goes first, */
    bool meets;        /* and that faces it */
} Drive;

typedef struct World {
    const House *house;
    const Journey *journeys; /* (count) */
    ParallelTeam *team;      /* not owned; NULL: the calling thread alone */
    Clock clock;
    size_t count;         /* number of people */
    size_t present_count; /* people who take part and are not out */
    size_t rider_count;   /* those of them in chairs */
    uint64_t digest;
    uint64_t decision_steps; /* steps between two decisions of a walker, or two updates of a driver's view */
    uint64_t sense_steps;    /* steps between two updates of walkers' senses; chairs' are always updated */
    bool sensed;             /* True if walkers' senses were updated in the last step */
    int door_changes;
    int shut_doors;      /* doors that can be opened and have not been */
    int departures;      /* number of people who have left */
    int resumed;         /* departures after which the blocked have tried again */
    int wall_crossings;  /* number of bodies' middles that entered a wall: must be 0 */
    double next_start;   /* s, end of the next delay */
    double last_opening; /* s, last opening of an exit: waiting before that is not being blocked */
    Box bounds;          /* m: a person outside counts as thrown out of the house */
    Walkers walkers;
    Rides rides;
    /* one per person (count), of the mass centre unless stated otherwise */
    Vec2 *centre;        /* m */
    Vec2 *axis;          /* unit, along the heading */
    double *heading;     /* rad */
    Vec2 *velocity;      /* m/s */
    double *turn;        /* rad/s */
    Vec2 *force;         /* N, contact forces of this step; chairs only, as the next four */
    Vec2 *ring;          /* N, the part of it that obstacles exert through the personal space */
    double *ring_moment; /* N m */
    double *moment;      /* N m */
    Drive *drive;
    Walk *walk;      /* walkers only */
    size_t *present; /* (present_count) indices of people, rising */
    size_t *riders;  /* (rider_count) indices of people in chairs, rising */
    size_t *seat;    /* index of a chair in the arrays below */
    int *phase;      /* Phase */
    int *reason;     /* Reason, of stuck people */
    size_t *exit;    /* exit crossed; SIZE_MAX: none */
    double *ended;   /* s, when out or stuck */
    double *start;   /* s, when the delay is over */
    Sense *sense;
    Body *body;
    bool *was_clear; /* True if clear of everything at the start; a chair that was not stays there, and after a change
                        of the plan every person */
    bool *door_open; /* (doors) */
    /* one per chair, indexed by its seat */
    NeighbourList *neighbours;
    Slip *slips; /* (chairs x GAPS_MOST) */
    int *slip_count;
    void *block; /* memory of all arrays above */
    size_t block_size;
} World;

/* Creates the world before its first step. The house and the journeys must outlive it. world_destroy releases it. */
World world_create(const House *house, const Journey *journeys, const bool *part);
void world_destroy(World *world);

/* Returns a copy with memory of its own and bitwise equal state. */
World world_copy(const World *world);

/* True if no face that is present reaches into the core of the person's body, so that every overlap is less than the
 * body's rounding. Tests the faces themselves, not the neighbours stored for contacts; debug builds assert this after
 * every step for all chairs except those that the contact law is pushing out. */
bool world_is_clear(const World *world, size_t i);

#define WORLD_SENSE_PERIOD 0.01 /* s, period of the updates of walkers' senses */

/* For the parts of a step -------------------------------------------------------------------------------------------
 */

/* The two halves of world_create: world_place places all people, and world_begin computes their senses from the present
 * positions. */
World world_place(const House *house, const bool *part);
void world_begin(World *world, const Journey *journeys);

/* Lists again the people present. */
void world_list_present(World *world);

/* True if no body overlaps the door's leaf in the given position, open or shut. */
bool world_leaf_is_free(const World *world, size_t door, Presence presence);

/* True if the place is finite and not far outside the house. */
static inline bool world_holds(const World *world, Vec2 at) {
    return at.x >= world->bounds.low.x && at.x <= world->bounds.high.x && at.y >= world->bounds.low.y &&
           at.y <= world->bounds.high.y;
}

/* Adds one gap to a sense: the gap (m), the personal space's reach (m), the forces (N) on body and ring, the point, and
 * the other person (-1: an obstacle). */
static inline void world_feel(Sense *sense, double gap, double reach, double body, double ring, Vec2 at, int other) {
    if (gap < sense->clearance) {
        sense->clearance = gap;
        sense->nearest_at = at;
        sense->other = other;
    }
    sense->ring = real_max(sense->ring, real_min(reach, reach - gap));
    if (body > 0 && body >= sense->body_force)
        sense->contact_at = at;
    sense->body_force += body;
    sense->ring_force += ring;
}

/* True if the person is in a chair, or is a disc of the paper. */
static inline bool world_rides(const World *world, size_t i) {
    return world->house->people[i].profile->driving != DRIVING_WALKER;
}

/* Returns the reference point of a person, m. */
static inline Vec2 world_reference(const World *world, size_t i) {
    const Profile *profile = world->house->people[i].profile;
    double back = profile->driving == DRIVING_DRIVER ? profile->mass_centre : 0;
    return vec2_along(world->centre[i], -back, world->axis[i]);
}
