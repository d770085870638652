/* Finds items that may be near each other: numbered boxes in Box2D's dynamic tree (b2DynamicTree, 2.4.1).
 *
 * The tree holds single-precision boxes, fattened by 0.1 m; the caller does the exact geometry in double precision. A
 * query returns its items in rising order of their numbers, so that sums made from them do not depend on the tree. A
 * tree may be queried by several threads at once while no thread changes it. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "base/vec2.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Ends the program in one line (base/memory.h) where the C++ of Box2D and GEOS is out of memory, which would otherwise
 * throw an exception. Box2D's own allocation, which does not check, is replaced too. */
void broadphase_use_memory(void);

typedef struct Broadphase Broadphase;

Broadphase *broadphase_create(void);
void broadphase_destroy(Broadphase *broadphase);

/* Adds a box for `item` (>= 0). */
void broadphase_insert(Broadphase *broadphase, Box box, int item);

/* Calls `visit` for every item whose box meets `box`, in no particular order, until it returns false. */
void broadphase_visit(const Broadphase *broadphase, Box box, bool (*visit)(void *context, int item), void *context);

/* Stores the items whose boxes meet `box`, in rising order, at most `capacity` of them, and returns the number found.
 */
size_t broadphase_query(const Broadphase *broadphase, Box box, int *items, size_t capacity);

/* Visits the items whose boxes meet the segment from `from` to `to`. `hit` returns the fraction of the segment, 0 to 1,
 * at which it meets the item, or `best` if it does not meet the item before `best`. Returns the smallest fraction (1:
 * none). */
double broadphase_ray(const Broadphase *broadphase, Vec2 from, Vec2 to,
                      double (*hit)(void *context, int item, Vec2 from, Vec2 to, double best), void *context);

#ifdef __cplusplus
}
#endif
