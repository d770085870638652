/* The look of people, from above and raised. The outline of a body is exactly that of the simulation: a rounded
 * rectangle, or a disc for the driving model of the paper. The drawing inside it, a wheelchair with its driver or a
 * person on foot, is a likeness. */
#pragma once

#include <stddef.h>

#include "draw/scene.h"
#include "plan/profile.h"
#include "route/route.h"

/* m, where a person's letter stands in the raised view */
#define SILHOUETTE_NAME_HEIGHT 1.45

enum { SILHOUETTE_POINTS = 28 /* seven a corner: 1 mm from the circle for a body of 0.7 m */ };

/* Returns the body with its reference point at `at`, or its personal space, `grown` m beyond the body;
 * counter-clockwise. */
void silhouette_outline(const Profile *profile, Vec2 at, double heading, double grown, Vec2 outline[SILHOUETTE_POINTS]);

/* Adds the body as a polygon. */
Primitive *silhouette_add(Scene *scene, Role role, const Profile *profile, Pose pose);

/* Returns the middle of a body whose reference point is `at`. */
Vec2 silhouette_middle(const Profile *profile, Vec2 at, double heading);

/* Returns the convex hull of two outlines, counter-clockwise: the area swept from one pose to the next. Returns its
 * number of points, at most 2 SILHOUETTE_POINTS. */
size_t silhouette_hull(const Vec2 first[SILHOUETTE_POINTS], const Vec2 second[SILHOUETTE_POINTS],
                       Vec2 hull[2 * SILHOUETTE_POINTS]);

/* Returns the point of an outline that is nearest to `to`. */
Vec2 silhouette_nearest(const Vec2 outline[SILHOUETTE_POINTS], Vec2 to);

/* A point of a body's edge and the unit normal there, outwards. */
typedef struct EdgePoint {
    Vec2 at, normal;
} EdgePoint;

enum { SILHOUETTE_EDGE = 72 /* points of an edge: at most 0.11 m apart on a chair, 10 degrees in a corner */ };

/* Lists the body's edge, counter-clockwise: the origins of rays to all sides. */
void silhouette_edge(const Profile *profile, Vec2 at, double heading, EdgePoint edge[SILHOUETTE_EDGE]);

/* Returns the distance along the unit vector `way` from `from` to a closed outline; at most `reach`. */
double silhouette_ray(const Vec2 *outline, size_t count, Vec2 from, Vec2 way, double reach);

/* Adds the outline in `role`, and in it wheels, seat and driver; in a round body they are as large as fits. */
void silhouette_add_chair(Scene *scene, const Profile *profile, Pose pose, Role role);

/* Adds many people of one profile on foot: two primitives for all of them, and for at most SILHOUETTE_HEADINGS people
 * one more each, which shows their heading; as dots, without heads and headings, one for all of them. */
void silhouette_add_walkers(Scene *scene, const Profile *profile, const Pose *poses, size_t count, bool dots);

enum { SILHOUETTE_HEADINGS = 1500 };
