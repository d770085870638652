/* A piece of furniture on its way from standing to lying, or back: only before the eye, in a plan it stands or lies.
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

#define FURNITURE_FALL_SECONDS 0.6 /* that it takes */
#define FURNITURE_FALL_SPREAD 0.4  /* s, within which pieces begin in a shake */

typedef struct FurnitureFall {
    Furniture piece; /* as it will be: lying, or upright */
    double delay;    /* s, until it begins */
    double way;      /* 0: it stands, to 1: it lies */
} FurnitureFall;

/* Moves it on by so many s. */
void furniture_fall_move(FurnitureFall *fall, double seconds);
bool furniture_fall_is_over(const FurnitureFall *fall);
double furniture_fall_share(const FurnitureFall *fall);

/* What a piece covers and how high it is, m, at a share: those of a piece that stands at 0, that lies at 1. */
void furniture_fall_corners(const Furniture *piece, double share, Vec2 corners[4]);
double furniture_fall_height(const Furniture *piece, double share);

/* The leaning piece, cut level at a height, m, below that: from where to where it is, m beyond the edge about which it
 * turns; negative: over where it stood. */
void furniture_fall_cut(const Furniture *piece, double share, double height, double *from, double *to);

/* s, until a piece begins in the shake of a seed: bound to its id, as the draw is. */
double furniture_fall_delay(uint64_t seed, const char *id);
