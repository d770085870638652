/* Which things may be near: boxes with a number each, in Box2D's dynamic tree (b2DynamicTree, 2.4.1).
 *
 * The tree holds single-precision boxes, fattened by 0.1 m; exact geometry in double precision is the caller's. The
 * answers of a query come in rising order of their numbers, so that sums made from them do not depend on the tree. A
 * tree may be queried by several threads at once while nobody changes it. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "base/vec2.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct Broadphase Broadphase;

Broadphase *broadphase_create(void);
void broadphase_destroy(Broadphase *broadphase);

/* Adds a box for `item` (>= 0). */
void broadphase_insert(Broadphase *broadphase, Box box, int item);

/* Calls `visit` for every item whose box meets `box`, until it returns false; in no particular order. */
void broadphase_visit(const Broadphase *broadphase, Box box, bool (*visit)(void *context, int item), void *context);

/* The items whose boxes meet `box`, in rising order: at most `capacity` are stored, the number found is returned. */
size_t broadphase_query(const Broadphase *broadphase, Box box, int *items, size_t capacity);

/* Walks the items whose boxes the segment from `from` to `to` meets. `hit` returns the fraction of the segment, 0 to 1,
 * at which it meets the item, or `best` when it does not meet it before `best`; the smallest is returned (1: none). */
double broadphase_ray(const Broadphase *broadphase, Vec2 from, Vec2 to,
                      double (*hit)(void *context, int item, Vec2 from, Vec2 to, double best), void *context);

#ifdef __cplusplus
}
#endif
