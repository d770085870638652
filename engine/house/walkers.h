/* People on foot: thousands of discs in each other's personal spaces, one step after another.
 *
 * Walkers have the same equation of motion and the same contact law as all people (step.h), but another data layout.
 * Each person present stands in a slot, cell by cell (cell_grid.h), and each walker has a list of the walkers that it
 * may touch before two of them have come nearer by WALKERS_SKIN: lists live for some 50 steps. Each walker computes the
 * forces on itself from the frozen state of all and writes only its own next state, so that any number of threads give
 * the same bits; the two walkers of a pair compute the same numbers with opposite signs, so that momentum is conserved.
 * The wanted velocity is decided ten times per second (walk.h). Chairs stand in slots too, so that walkers see them;
 * ride.h computes their forces. */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "space/cell_grid.h"
#include "space/gap.h"

#define WALKERS_SKIN 0.20 /* m: how much nearer two walkers may come before the lists are rebuilt */

/* The law between two walkers of two kinds. */
typedef struct WalkerLaw {
    double range2; /* m2: no force beyond */
    double radii;  /* m, sum of both radii */
    double reach;  /* m, of the larger personal space */
    ContactLaw space, contact;
} WalkerLaw;

/* Constants of all people of one profile. */
typedef struct WalkerKind {
    double radius, reach; /* m */
    double mass;          /* kg */
    double per_response;  /* 1/s */
    double acceleration;  /* m/s2, limit: a_0, and what the push allows */
    bool walks;           /* false: a chair */
} WalkerKind;

/* The springs between two walkers, as stored by one of them. */
typedef struct WalkerSlip {
    double ring, body; /* m */
} WalkerSlip;

enum { WALKERS_WALLS = 6 /* faces and corners that one walker touches at once */ };

typedef struct WallSlips {
    int count;
    Slip slip[WALKERS_WALLS];
} WallSlips;

/* Results of a chunk of slots after a step. */
typedef struct WalkerReport {
    double fastest2;   /* m2/s2, the square of the greatest speed */
    uint64_t digest;   /* sum over the walkers */
    int departures;    /* number of people who left */
    int crossings;     /* number of bodies' middles that entered a wall */
    uint32_t diverged; /* person who diverged, or UINT32_MAX */
    char padding[36];  /* pads to a cache line */
} WalkerReport;

typedef struct Walkers {
    CellGrid cells;
    WalkerKind *kinds; /* (kind_count) one per profile of the house */
    WalkerLaw *laws;   /* (kind_count x kind_count) */
    size_t kind_count;
    double widest;         /* m, farthest distance of any body's edge from its middle */
    double range;          /* m, largest range of the laws */
    bool any;              /* True if there are walkers */
    double travelled;      /* m, bound of each person's motion since the lists were built */
    uint64_t made;         /* step at which the lists were built */
    int doors, departures; /* of the world, when the lists were built; -1: never */
    /* one per slot (cells.count) */
    size_t capacity;
    Vec2 *at, *velocity;           /* m, m/s: the present state */
    Vec2 *next_at, *next_velocity; /* the next state */
    Vec2 *wish;                    /* m/s, wanted velocity */
    Vec2 *push;                    /* N, by chairs */
    Vec2 *facing;                  /* unit, when the lists were built */
    uint16_t *kind;
    uint8_t *marks;   /* WALKER_MARK_... */
    uint32_t *first;  /* (count + 1) begin of each walker in the list below */
    uint32_t *other;  /* (first[count]) slots, each walker's neighbours in rising order */
    WalkerSlip *slip; /* (first[count]) */
    size_t list_capacity, slip_capacity;
    /* the previous lists, from which the springs are copied */
    uint32_t *old_first, *old_other, *old_who;
    WalkerSlip *old_slip;
    size_t old_list_capacity, old_slip_capacity;
    /* one per person */
    uint32_t *slot_of, *old_slot_of; /* UINT32_MAX: none */
    WallSlips *walls;
    size_t people;
    WalkerReport *reports; /* (chunks) */
    size_t report_capacity;
} Walkers;

struct World;

/* Starts without lists. walkers_clear releases them; `to` of walkers_copy has memory of its own. */
void walkers_init(Walkers *walkers, const struct World *world);
void walkers_copy(Walkers *to, const Walkers *from);
void walkers_clear(Walkers *walkers);

/* Rebuilds slots and lists when a person has moved too far, or a door or the number of people has changed. Returns true
 * if it did; other lists of slots must then be rebuilt, too. */
bool walkers_update(struct World *world);

/* Moves every walker by one step, from the forces of `push`, of other walkers and of obstacles, and adds up departures
 * and crossings in the world; returns the sum of digests. `senses`: also fills in world->sense. */
uint64_t walkers_step(struct World *world, bool senses, size_t *diverged);

/* Copies the positions of chairs, which have moved, to their slots. */
void walkers_sync_chairs(struct World *world);
