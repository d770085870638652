/* People on foot: thousands of discs in each other's personal spaces, one step after another.
 *
 * Same equation of motion and same contact law as everybody's (world.h); what differs is how it is kept. Everybody who
 * is there stands in a slot, cell by cell (cells.h), and each walker has a list of the walkers that it may touch before
 * two of them have come nearer by WALKERS_SKIN: lists live for some 50 steps. Each works out the forces on itself from
 * the frozen state of all and writes its own next state only, so that any number of threads give the same bits; the two
 * of a pair compute the same numbers with opposite signs, so that momentum is conserved. What a walker wants is decided
 * ten times a second (walk.h). Chairs stand in the slots too, so that walkers see them; their forces are ride.h's. */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "space/cell_grid.h"
#include "space/gap.h"

#define WALKERS_SKIN 0.20 /* m: how much nearer two may come before the lists are made anew */

/* What happens between two walkers of two kinds. */
typedef struct WalkerLaw {
    double range2; /* m2: beyond there is no force */
    double radii;  /* m, of both bodies */
    double reach;  /* m, of the larger personal space */
    ContactLaw space, contact;
} WalkerLaw;

/* What all of one profile have in common. */
typedef struct WalkerKind {
    double radius, reach; /* m */
    double mass;          /* kg */
    double per_response;  /* 1/s */
    double acceleration;  /* m/s2, most: a_0, and what the push allows */
    bool walks;           /* false: a chair */
} WalkerKind;

/* The springs between two walkers, as one of them keeps them. */
typedef struct WalkerSlip {
    double ring, body; /* m */
} WalkerSlip;

enum { WALKERS_WALLS = 6 /* faces and corners that one walker feels at once */ };

typedef struct WallSlips {
    int count;
    Slip slip[WALKERS_WALLS];
} WallSlips;

/* What a chunk of slots has to report after a step. */
typedef struct WalkerReport {
    double fastest2;   /* m2/s2, the square of the greatest speed */
    uint64_t digest;   /* sum over the walkers */
    int departures;    /* who have left */
    int crossings;     /* middles of bodies that went into a wall */
    uint32_t diverged; /* who, or UINT32_MAX */
    char padding[36];  /* a cache line each */
} WalkerReport;

typedef struct Walkers {
    CellGrid cells;
    WalkerKind *kinds; /* (kind_count) one per profile of the house */
    WalkerLaw *laws;   /* (kind_count x kind_count) */
    size_t kind_count;
    double widest;         /* m, farthest of anybody's edge from the middle */
    double range;          /* m, largest of the laws */
    bool any;              /* somebody walks */
    double travelled;      /* m, that anybody may have moved since the lists were made */
    uint64_t made;         /* step at which that was */
    int doors, departures; /* of the world, when the lists were made; -1: not yet */
    /* one per slot (cells.count) */
    size_t capacity;
    Vec2 *at, *velocity;           /* m, m/s: the present state */
    Vec2 *next_at, *next_velocity; /* the one in the making */
    Vec2 *wish;                    /* m/s, the velocity wanted */
    Vec2 *push;                    /* N, by chairs */
    Vec2 *facing;                  /* unit, when the lists were made */
    uint16_t *kind;
    uint8_t *marks;   /* WALKER_MARK_... */
    uint32_t *first;  /* (count + 1) of the list below */
    uint32_t *other;  /* (first[count]) slots, each walker's neighbours in rising order */
    WalkerSlip *slip; /* as many */
    size_t list_capacity, slip_capacity;
    /* the lists before these, from which the springs are taken over */
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

/* Lists nothing yet. walkers_clear releases it; `to` of walkers_copy has memory of its own. */
void walkers_init(Walkers *walkers, const struct World *world);
void walkers_copy(Walkers *to, const Walkers *from);
void walkers_clear(Walkers *walkers);

/* Makes slots and lists anew when somebody has moved too far, or a door or the number of people has changed. True: it
 * did, and whoever keeps lists of slots has to do so too. */
bool walkers_update(struct World *world);

/* Moves every walker by one step, from the forces of `push`, of each other and of obstacles, and adds up what happened
 * (world->departures, crossings); the sum of digests is returned. `senses`: world->sense is filled as well. */
uint64_t walkers_step(struct World *world, bool senses, size_t *diverged);

/* Chairs have moved: their slots follow. */
void walkers_sync_chairs(struct World *world);
