/* The body of a person, as contact sees it.
 *
 * A body is a rounded rectangle: all points within `radius` of a core rectangle. A round body has a core of no size.
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

/* m: gaps are measured up to here even without a personal space, to know how near a body comes. */
#define BODY_SIGHT 0.30

typedef struct Body {
    Vec2 core_low, core_high; /* m, in the body's frame */
    Vec2 core[4];             /* m, its corners, counter-clockwise from the right rear; all alike for a disc */
    Vec2 middle, half;        /* m, of the core: its middle and its half sides */
    int core_count;           /* 4, or 1 for a disc */
    double radius;            /* m, of the rounding */
    double reach;             /* m, of the personal space beyond the body */
    double sight;             /* m, up to which gaps are looked for: the reach, and at least BODY_SIGHT */
    double outer;             /* m, radius about the core's middle that holds the body and as far as it looks */
    double swing;             /* m, radius about the mass centre that holds the core: what turning moves */
} Body;

Body body_of(const Profile *profile);

/* A body as it stands. */
typedef struct Stance {
    const Body *body;
    Vec2 centre, axis; /* m; unit */
    Vec2 middle;       /* m, of the core */
    Vec2 core[4];      /* m, the core's corners from the centre */
} Stance;

static inline Stance body_stance(const Body *body, Vec2 centre, Vec2 axis) {
    Stance stance = {.body = body, .centre = centre, .axis = axis};
    stance.middle = vec2_add(centre, vec2_turn(body->middle, axis));
    for (int i = 0; i < body->core_count; i++)
        stance.core[i] = vec2_turn(body->core[i], axis);
    return stance;
}

/* How far a body with heading `axis` reaches from its mass centre along a direction (unit), m. */
static inline double body_extent(const Body *body, Vec2 axis, Vec2 direction) {
    Vec2 own = vec2_unturn(direction, axis);
    double middle = vec2_dot(own, body->middle);
    return middle + fabs(own.x) * body->half.x + fabs(own.y) * body->half.y + body->radius;
}
