/* A piece of furniture while it falls or is set up again: for display only; in a plan a piece stands or lies.
 *
 * It turns about the lower edge of the face to which it falls. Seen from above, its shadow beyond that edge grows with
 * constant acceleration, to share s of its height after sqrt(s) of the time; it leans by arcsin(s) then:
 *
 *         +----+              .-+                              s           0 ... 1, the share
 *         |    |           .-'   \                             height h    standing
 *       h |    |          +     .-+                            depth d     across the edge
 *         |    |           \ .-'            +-------------+
 *         +----+            +               |             | d
 *         d    edge         edge            edge     h                                                            */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "plan/plan.h"

#define FURNITURE_FALL_SECONDS 0.6 /* that a fall takes */
#define FURNITURE_FALL_SPREAD 0.4  /* s, within which pieces begin to fall in a shake */

typedef struct FurnitureFall {
    Furniture piece; /* the final state: lying, or upright */
    double delay;    /* s, until the fall begins */
    double way;      /* 0: standing, to 1: lying */
} FurnitureFall;

/* Advances the fall by this time, s. */
void furniture_fall_move(FurnitureFall *fall, double seconds);
bool furniture_fall_is_over(const FurnitureFall *fall);
double furniture_fall_share(const FurnitureFall *fall);

/* Returns the area that a piece covers and its height, m, at a share: 0 standing, 1 lying. */
void furniture_fall_corners(const Furniture *piece, double share, Vec2 corners[4]);
double furniture_fall_height(const Furniture *piece, double share);

/* Returns the range, m beyond the edge about which it turns, that the leaning piece covers at a height below its own;
 * negative: over its standing place. */
void furniture_fall_cut(const Furniture *piece, double share, double height, double *from, double *to);

/* Returns the time, s, until a piece begins to fall in the shake of a seed: bound to the piece's id, as the draw is. */
double furniture_fall_delay(uint64_t seed, const char *id);
