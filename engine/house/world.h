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
    PHASE_STUCK, /* stands there for good: no way, blocked */
    PHASE_OUT,   /* has crossed an exit and is gone */
} Phase;

/* What a person feels in this step. */
typedef struct Sense {
    double clearance;  /* m, to the nearest of everything, up to the personal space's reach */
    double ring;       /* m, greatest compression of the personal space */
    double body_force; /* N, sum of the normal forces on the body */
    double ring_force; /* N, of the personal space */
    Vec2 nearest_at;   /* m, where it is nearest */
    Vec2 contact_at;   /* m, where the body touches hardest */
    int other;         /* the person who is nearest, or -1: an obstacle or nothing */
} Sense;

/* How a person gets on along the track. */
typedef struct Drive {
    size_t index;      /* the last track point passed */
    double s;          /* m, along the track */
    double offset;     /* m, to the left of the track */
    double aside;      /* m, the offset wanted, to let somebody pass */
    double swerve;     /* m/s, at which that changes */
    double pause;      /* s, left of a change of direction */
    double best_s;     /* m, farthest so far */
    double best_turn;  /* rad, least left of a turn on the spot */
    double stalled;    /* s, without getting on */
    double handle;     /* s, spent at a shut door's handle */
    double retreat_to; /* m, along the track: back to there, to try again; negative: not retreating */
    int retries;       /* since the last progress */
    int departures;    /* of others that had been seen when the person gave up */
    int plans;         /* made since the first, after having been pushed off the way */
    double heeded;     /* m/s, the speed that the people ahead leave, when last looked at */
    double around;     /* m, the offset at which they are passed */
} Drive;

typedef struct World {
    const House *house;
    const Journey *journeys; /* (count) */
    ParallelTeam *team;      /* not owned; NULL: this thread alone */
    Clock clock;
    size_t count;         /* of people */
    size_t present_count; /* of those who take part and are not out */
    size_t rider_count;   /* of them in chairs */
    uint64_t digest;
    uint64_t decision_steps; /* from one decision of a walker, or look of a chair's driver, to the next */
    uint64_t sense_steps;    /* from one time that walkers' senses are filled to the next; chairs' always are */
    bool sensed;             /* walkers' senses were filled in the last step */
    int door_changes;
    int shut_doors;      /* that can be opened and have not been */
    int departures;      /* people who have left */
    int resumed;         /* departures after which the blocked have tried again */
    int wall_crossings;  /* middles of bodies that went into a wall: there must be none */
    double next_start;   /* s, when the next delay is over */
    double last_opening; /* s, of an exit: until then waiting is not being blocked */
    Box bounds;          /* m: whoever leaves it has been thrown out of the house */
    Walkers walkers;
    Rides rides;
    /* one per person (count), of the mass centre unless said otherwise */
    Vec2 *centre;        /* m */
    Vec2 *axis;          /* unit, along the heading */
    double *heading;     /* rad */
    Vec2 *velocity;      /* m/s */
    double *turn;        /* rad/s */
    Vec2 *force;         /* N, of contacts, this step; chairs only, as the next four */
    Vec2 *ring;          /* N, of it what obstacles do through the personal space */
    double *ring_moment; /* N m */
    double *moment;      /* N m */
    Drive *drive;
    Walk *walk;      /* walkers only */
    size_t *present; /* (present_count) who they are, rising */
    size_t *riders;  /* (rider_count) of them in chairs, rising */
    size_t *seat;    /* of a chair, its place in the arrays below */
    int *phase;      /* Phase */
    int *reason;     /* Reason, of the stuck */
    size_t *exit;    /* crossed; SIZE_MAX: none */
    double *ended;   /* s, when out or stuck */
    double *start;   /* s, when the delay is over */
    Sense *sense;
    Body *body;
    bool *was_clear; /* of everything at the start; a chair that was not stays there, and after a change of the plan
                        everybody */
    bool *door_open; /* (doors) */
    /* one per chair, by its seat */
    NeighbourList *neighbours;
    Slip *slips; /* (chairs x GAPS_MOST) */
    int *slip_count;
    void *block; /* all of the arrays above */
    size_t block_size;
} World;

/* The world before its first step. The house and the journeys must outlive it. world_destroy releases it. */
World world_create(const House *house, const Journey *journeys, const bool *part);
void world_destroy(World *world);

/* A copy with memory of its own, same state to the bit. */
World world_copy(const World *world);

/* Does no face that is there reach into the core of the person's body? Then it overlaps everything by less than its
 * rounding. Looks at the faces themselves, not at the neighbours kept for contacts; debug builds assert after every
 * step that it holds for everybody but those whom the contact law is pushing out. */
bool world_is_clear(const World *world, size_t i);

#define WORLD_SENSE_PERIOD 0.01 /* s, between two times that walkers' senses are filled */

/* For the parts of a step -------------------------------------------------------------------------------------------
 */

/* The two halves of world_create: everybody in place, and, from wherever they have been put then, what they feel. */
World world_place(const House *house, const bool *part);
void world_begin(World *world, const Journey *journeys);

/* Lists anew who is there. */
void world_list_present(World *world);

/* Is nobody where the door's leaf is, open or shut? */
bool world_leaf_is_free(const World *world, size_t door, Presence presence);

/* Is the place finite and not far out of the house? */
static inline bool world_holds(const World *world, Vec2 at) {
    return at.x >= world->bounds.low.x && at.x <= world->bounds.high.x && at.y >= world->bounds.low.y &&
           at.y <= world->bounds.high.y;
}

/* Adds what one gap does: the gap (m), the personal space's reach (m), the forces (N) on body and ring, where, and who
 * the other is (-1: an obstacle). */
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

/* Is the person in a chair, or a disc of the paper? */
static inline bool world_rides(const World *world, size_t i) {
    return world->house->people[i].profile->driving != DRIVING_WALKER;
}

/* The reference point of a person, m. */
static inline Vec2 world_reference(const World *world, size_t i) {
    const Profile *profile = world->house->people[i].profile;
    double back = profile->driving == DRIVING_DRIVER ? profile->mass_centre : 0;
    return vec2_along(world->centre[i], -back, world->axis[i]);
}
