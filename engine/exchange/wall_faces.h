/* Turns walls that a drawing shows as two lines into walls with a thickness.
 *
 * The pieces between faces (wall_pieces.h) are brought together at their ends:
 *
 *     ============+  corner: both centre lines       ======   ======  T: the pieces of the through wall join,
 *     ---------+  |  reach their crossing            ----+ | +----    the third ends at their centre line
 *              |  |                                      | | |
 *
 *     =======|   |======  opening: both faces are interrupted; the wall continues, with an opening in it
 *     -------|   |------
 *
 * A stretch that window lines fill is wall. What remains of the lines outside the walls stays a wall of no thickness.
 * Private to the importers. */
#pragma once

#include "exchange/wall_chains.h"

typedef struct WallOpening {
    Vec2 a, b; /* m, on the wall's centre line */
    double thickness;
} WallOpening;

typedef struct WallFaces {
    WallOpening *openings; /* (opening_count) */
    size_t opening_count, opening_capacity;
    size_t walls;              /* number of walls found; 0: the drawing shows walls as single lines */
    size_t windows;            /* number of stretches that window lines fill */
    size_t doubled;            /* number of lines that repeat another one, if walls were found */
    bool too_many;             /* the drawing has so many lines that no walls were looked for */
    double thinnest, thickest; /* m */
    double apart;              /* m: if no walls were found, the distance of most lines that run in pairs, or 0 */
} WallFaces;

/* Replaces the lines (m) by walls and what remains of the lines, if most of the lines are faces of walls; otherwise
 * joins lines with a thickness across openings and appends the window lines. wall_faces_clear releases the result. */
WallFaces wall_faces_join(WallLines *lines, const WallLines *windows);
void wall_faces_clear(WallFaces *faces);

/* Returns the thickness (m) of the thickest wall if most of the lines are faces of walls when their coordinates are
 * multiplied by `scale` to give metres; otherwise 0. */
double wall_faces_likely(const WallLines *lines, double scale);
