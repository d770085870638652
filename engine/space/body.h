/* The body of a person in the contact geometry.
 *
 * A body is a rounded rectangle: all points within `radius` of a core rectangle. The core of a round body is a point.
 *
 *       .-----------------.
 *      ( o---------------o )      o  the core's corners, in contact with faces
 *      | |     core    +x| |      sides of the core in contact with corners of obstacles
 *      ( o---------------o )      the frame's origin is the mass centre, x along the heading
 *       '-----------------'
 */
#pragma once

#include "base/vec2.h"
#include "plan/profile.h"

/* m: gaps are measured up to this distance even without a personal space, to report how near a body comes. */
#define BODY_SIGHT 0.30

typedef struct Body {
    Vec2 core_low, core_high; /* m, in the body's frame */
    Vec2 core[4];             /* m, its corners, counter-clockwise from the right rear; all alike for a disc */
    Vec2 middle, half;        /* m, of the core: its middle and its half sides */
    int core_count;           /* 4, or 1 for a disc */
    double radius;            /* m, of the rounded outline */
    double reach;             /* m, of the personal space beyond the body */
    double sight;             /* m, distance up to which gaps are computed: the reach, and at least BODY_SIGHT */
    double outer;             /* m, radius about the core's middle that encloses the body and its sight */
    double swing;             /* m, radius about the mass centre that encloses the core: what a turn moves */
} Body;

Body body_of(const Profile *profile);

/* A body at a position and heading. */
typedef struct Stance {
    const Body *body;
    Vec2 centre, axis; /* m; unit */
    Vec2 middle;       /* m, middle of the core */
    Vec2 core[4];      /* m, (core_count) the core's corners relative to the centre */
} Stance;

static inline void body_stance(Stance *stance, const Body *body, Vec2 centre, Vec2 axis) {
    stance->body = body;
    stance->centre = centre;
    stance->axis = axis;
    stance->middle = vec2_add(centre, vec2_turn(body->middle, axis));
    for (int i = 0; i < body->core_count; i++)
        stance->core[i] = vec2_turn(body->core[i], axis);
}

/* Returns how far a body with heading `axis` extends from its mass centre along a direction (unit), m. */
static inline double body_extent(const Body *body, Vec2 axis, Vec2 direction) {
    Vec2 own = vec2_unturn(direction, axis);
    double middle = vec2_dot(own, body->middle);
    return middle + fabs(own.x) * body->half.x + fabs(own.y) * body->half.y + body->radius;
}
