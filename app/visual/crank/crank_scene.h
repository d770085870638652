/* A slider crank at one moment as scenes, in metres of the drawing: the mechanism seen from a raised viewpoint, what
 * bends magnified; next to it the socket with the path of the ball in a loupe, and the joint's force over the crank
 * angle as a polar diagram.
 *
 *   springs               +---- loupe -----+
 *    [block]==== crank    |   ( path of )  |
 *          (pin)          |   ( the ball)  |
 *              \ coupler  +--- polar ------+
 *               \         | force outwards |
 *    ======[slider]===    | angle as crank |
 *        guide            +----------------+                                                                        */
#pragma once

#include "crank/crank_cycle.h"
#include "cycle/response.h"
#include "draw/scene.h"

/* The parts that are drawn. */
enum {
    CRANK_SCENE_LOUPE = 1,
    CRANK_SCENE_POLAR = 2,
    CRANK_SCENE_FORCES = 4,
    CRANK_SCENE_NAMES = 8,
    CRANK_SCENE_ALL = 15,
};

/* The direction in which the loupe is looked through. */
typedef enum CrankSight { CRANK_SIGHT_SIDE, CRANK_SIGHT_ALONG, CRANK_SIGHT_ABOVE, CRANK_SIGHTS } CrankSight;

/* (CRANK_SIGHTS) "from the side", ... */
extern const char *const crank_scene_sights[CRANK_SIGHTS];

/* Overlap of ball and wall is magnified by this more than the clearance, so that it can be seen. */
#define CRANK_SCENE_OVERLAP 3.0

/* The style of the drawing. */
typedef struct CrankScale {
    unsigned parts; /* CRANK_SCENE_...: all by default */
    CrankSight sight;
    double unit;         /* m, the crank's radius */
    double bend;         /* 1, magnification of bending and of the support's motion */
    double largest;      /* N, at the edge of the polar diagram */
    double place;        /* m, middle of the slider's stroke */
    double loupe, reach; /* m, radius of the clearance in the loupe, and of the polar diagram */
    Vec2 socket, polar;  /* their middles */
    Box box;
} CrankScale;

/* Makes the style for a crank whose coupler and support move by at most `reach` m, with forces of at most `force` N. */
CrankScale crank_scene_scale(const Crank *crank, const Tree *tree, double reach, double force);

/* A moment of the motion, and what came before it. */
typedef struct CrankMoment {
    double time;         /* s, since the revolution began: the angle, unless it is in the state */
    const double *state; /* (2 x coordinates) of the tree; only the coordinates are used */
    double force;        /* N, of the joint */

    const double *along, *across, *up; /* (path_count) m, of the ball in its socket, the moment last */
    size_t path_count;
    const double *angle, *forces; /* (force_count) rad, N; the moment last */
    size_t force_count;
    size_t present; /* first one of the present revolution, which is drawn thick */
} CrankMoment;

/* Returns the largest displacement, m, of a point of the coupler across it, or of the support. */
double crank_scene_reach(const Tree *tree, const double *state);

/* Add the fixed part: guide, disc, grounds, the wall of the socket, the rings of the polar diagram, names; and the
 * parts that move. */
void crank_scene_still(Scene *scene, const Crank *crank, const Tree *tree, const CrankScale *scale);
void crank_scene_moving(Scene *scene, const Tree *tree, const CrankScale *scale, const CrankMoment *moment);

/* Simulates a recorded revolution again to a row of the trace (from 0), and describes that moment, with arrays in the
 * scene's memory; `turn` holds its state, and `reach` (m) becomes the largest displacement until then. */
CrankMoment crank_scene_moment(Scene *scene, const Tree *tree, const Response *response, size_t row, Turn *turn,
                               double *reach);

/* Adds the texts around the picture of a row. */
void crank_scene_labels(Scene *scene, const Crank *crank, const Response *response, size_t row);

/* Adds the whole picture of a row of the trace, or of the moment of the largest force in the last recorded revolutions.
 * The trace must have a whole revolution. */
void crank_scene_make_at(Scene *scene, const Crank *crank, const Tree *tree, const Response *response, size_t row);
void crank_scene_make(Scene *scene, const Crank *crank, const Tree *tree, const Response *response);
