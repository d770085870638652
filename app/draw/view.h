/* The viewpoint of a scene, and the page position of each of its points.
 *
 * The plan is seen from above: a metre has the same length everywhere. The raised view is a mild perspective,
 *
 *     X = F (p . right) / d        d = D - p . back
 *     Y = -F (p . up) / d
 *
 * of a camera that looks at the middle of the house from the distance D; F is chosen so that the house fills its place.
 * Both views are one matrix in homogeneous coordinates, so that painters, labels and tests compute the same. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "base/vec2.h"

typedef enum ViewKind { VIEW_PLAN, VIEW_RAISED } ViewKind;

#define VIEW_NAMES "plan|raised"

typedef struct Camera {
    ViewKind kind;
    double azimuth;   /* degrees, of the raised view: 0 looks up the plan, along +y; 90 from the right, along -x */
    double elevation; /* degrees above the floor, more than 0, at most 90 */
    double zoom;      /* 1: as large as fits; 0 counts as 1 */
    Vec2 pan;         /* m, from the middle of the scene's box to the middle of the picture */
} Camera;

/* Defaults of the raised view. */
#define VIEW_AZIMUTH 10.0
#define VIEW_ELEVATION 60.0

typedef struct View {
    bool raised;
    double rows[4][4]; /* (x, y, z, 1) in m to page x W, page y W, depth W, W; depth from -1, near, to 1 */
} View;

View view_plan(double metre, Vec2 origin);

/* Fits the content of `box`, up to `top` m, into a place on the page. */
View view_raised(Camera camera, Box box, double top, Box place);

/* Returns the page position of a point of the house, `height` m above the floor. */
Vec2 view_point(const View *view, Vec2 at, double height);

/* Returns the place on the floor, m, under a point of the page. */
Vec2 view_floor(const View *view, Vec2 page);

/* Returns the depth of the point, from -1, near, to 1. */
double view_depth(const View *view, Vec2 at, double height);

/* True if everything over these points, up to `height` m, lies before the camera. */
bool view_sees(const View *view, const Vec2 *points, size_t count, double height);

/* Returns the length of a horizontal metre at that point, in design points. */
double view_scale(const View *view, Vec2 at, double height);
