/* Tight houses drawn from a seed, for the shipped manual chair: corners, doors off a corridor, S-bends, U-turns, small
 * flats, bends by any angle, wide doors onto narrow corridors, niches to back out of and furniture on alternate sides,
 * with widths near the least with which the chair can be driven.
 *
 * A scene is a list of rectangles, and can be moved, drawn in another manner, or given more room, before a house is
 * made from it. */
#pragma once

#include "base/random.h"
#include "house/house.h"
#include "route/route.h"

typedef enum TightKind {
    TIGHT_CORNER,
    TIGHT_IN,
    TIGHT_OUT,
    TIGHT_S,
    TIGHT_U,
    TIGHT_FLAT,
    TIGHT_BEND,
    TIGHT_WIDE_DOOR,
    TIGHT_NICHE,
    TIGHT_SLALOM,
    TIGHT_KINDS
} TightKind;

enum { TIGHT_MOST = 48, TIGHT_SIZES = 4 };

/* A rectangle along the line from a to b. */
typedef struct TightSolid {
    Vec2 a, b;   /* m */
    double half; /* m, half its thickness */
    bool wall;   /* True for a wall, false for a piece of furniture */
} TightSolid;

typedef struct TightScene {
    TightKind kind;
    double sizes[TIGHT_SIZES]; /* m, named by tight_sizes */
    TightSolid solids[TIGHT_MOST];
    size_t count;
    Vec2 exit[2]; /* m */
    Vec2 at;      /* m, start of the axle */
    double heading;
} TightScene;

const char *tight_kind_name(TightKind kind);

/* Writes the names and values of the sizes: "W1 0.92, W2 0.95". */
void tight_sizes(const TightScene *scene, char *text, size_t size);

/* Draws the scene of a kind. Its walls are parallel to the axes. */
TightScene tight_draw(TightKind kind, uint64_t seed);

/* Mirrors the scene at the x axis if asked to, turns it about the origin by `angle` rad, then shifts it. */
void tight_move(TightScene *scene, bool mirrored, double angle, Vec2 shift);

/* Moves every face of every solid by `by` m into the solid, so that the free space only grows. */
void tight_shrink(TightScene *scene, double by);

/* Moves every face of one solid outwards. */
void tight_grow(TightScene *scene, size_t solid, double by);

/* These draw the same obstacles or the same exit in another manner. */
void tight_swap_exit(TightScene *scene);
void tight_split_wall(TightScene *scene, Random *random);
void tight_reverse_walls(TightScene *scene);
void tight_add_inside(TightScene *scene, Random *random);

/* Returns the least signed distance, m, of the chair from the solids while it drives along the route, at places at most
 * 1 mm apart: positive when free, at most the true distance; negative by the depth of the overlap. Between two poses
 * the heading changes evenly with the way along an arc. */
double tight_sweep(const TightScene *scene, const Profile *profile, const Route *route);

/* A house made from a scene, and the query for its route. */
typedef struct TightHouse {
    House house; /* only the plan, the outline and the free space */
    Vec2 points[2 * TIGHT_MOST];
    Wall walls[TIGHT_MOST];
    Furniture furniture[TIGHT_MOST];
    Exit exit;
    RouteQuery query;
} TightHouse;

/* Builds the house, which must not be moved. tight_free releases it. */
void tight_build(TightHouse *tight, const TightScene *scene, const Profile *profile);
void tight_free(TightHouse *tight);
