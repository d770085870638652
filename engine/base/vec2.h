/* A point or a direction in the plane, in metres unless stated otherwise: x to the right, y up, angles
 * counter-clockwise from +x in radians. */
#pragma once

#include <math.h>
#include <stdbool.h>

#include "base/real.h"

typedef struct Vec2 {
    double x, y;
} Vec2;

/* An upright rectangle, low <= high in both coordinates. */
typedef struct Box {
    Vec2 low, high;
} Box;

static inline Vec2 vec2(double x, double y) {
    return (Vec2){x, y};
}

static inline Vec2 vec2_add(Vec2 a, Vec2 b) {
    return (Vec2){a.x + b.x, a.y + b.y};
}

static inline Vec2 vec2_sub(Vec2 a, Vec2 b) {
    return (Vec2){a.x - b.x, a.y - b.y};
}

static inline Vec2 vec2_scale(Vec2 a, double s) {
    return (Vec2){a.x * s, a.y * s};
}

/* a + s b */
static inline Vec2 vec2_along(Vec2 a, double s, Vec2 b) {
    return (Vec2){a.x + s * b.x, a.y + s * b.y};
}

static inline double vec2_dot(Vec2 a, Vec2 b) {
    return a.x * b.x + a.y * b.y;
}

/* Returns the z component of a x b: positive when b points to the left of a. */
static inline double vec2_cross(Vec2 a, Vec2 b) {
    return a.x * b.y - a.y * b.x;
}

static inline double vec2_length(Vec2 a) {
    return sqrt(a.x * a.x + a.y * a.y);
}

static inline double vec2_distance(Vec2 a, Vec2 b) {
    return vec2_length(vec2_sub(a, b));
}

/* Returns the direction of a; (0, 0) if a has no length. */
static inline Vec2 vec2_unit(Vec2 a) {
    double length = vec2_length(a);
    return length > 0 ? vec2_scale(a, 1 / length) : (Vec2){0, 0};
}

/* Returns a turned by a quarter counter-clockwise. */
static inline Vec2 vec2_left(Vec2 a) {
    return (Vec2){-a.y, a.x};
}

/* Returns the unit vector of an angle, rad. */
static inline Vec2 vec2_heading(double angle) {
    SineCosine turn = real_sincos(angle);
    return (Vec2){turn.cosine, turn.sine};
}

/* Converts a from the frame whose x axis is the unit vector `axis` to the frame in which `axis` is given. */
static inline Vec2 vec2_turn(Vec2 a, Vec2 axis) {
    return (Vec2){a.x * axis.x - a.y * axis.y, a.x * axis.y + a.y * axis.x};
}

/* The inverse of vec2_turn. */
static inline Vec2 vec2_unturn(Vec2 a, Vec2 axis) {
    return (Vec2){a.x * axis.x + a.y * axis.y, a.y * axis.x - a.x * axis.y};
}

/* Returns the angle from a to b, rad, in [-pi, pi], positive counter-clockwise. */
static inline double vec2_angle_between(Vec2 a, Vec2 b) {
    return real_atan2(vec2_cross(a, b), vec2_dot(a, b));
}

/* Returns the point of the segment from a to b that is nearest to p. */
static inline Vec2 vec2_nearest_on_segment(Vec2 p, Vec2 a, Vec2 b) {
    Vec2 ab = vec2_sub(b, a);
    double square = vec2_dot(ab, ab);
    double t = square > 0 ? vec2_dot(vec2_sub(p, a), ab) / square : 0;
    return vec2_along(a, t < 0 ? 0 : t > 1 ? 1 : t, ab);
}

/* Brings an angle into (-pi, pi]. */
static inline double vec2_wrap_angle(double angle) {
    if (angle > -M_PI && angle <= M_PI)
        return angle;
    double wrapped = remainder(angle, 2 * M_PI);
    return wrapped <= -M_PI ? wrapped + 2 * M_PI : wrapped;
}

static inline double radians(double degrees) {
    return degrees * (M_PI / 180);
}

static inline double degrees(double radians) {
    return radians * (180 / M_PI);
}

static inline Box box_around(Vec2 centre, double reach) {
    return (Box){{centre.x - reach, centre.y - reach}, {centre.x + reach, centre.y + reach}};
}

/* Returns a box that holds nothing; box_include grows it. */
static inline Box box_empty(void) {
    return (Box){{HUGE_VAL, HUGE_VAL}, {-HUGE_VAL, -HUGE_VAL}};
}

static inline Box box_include(Box box, Vec2 p) {
    return (Box){{fmin(box.low.x, p.x), fmin(box.low.y, p.y)}, {fmax(box.high.x, p.x), fmax(box.high.y, p.y)}};
}

static inline Box box_expand(Box box, double by) {
    return (Box){{box.low.x - by, box.low.y - by}, {box.high.x + by, box.high.y + by}};
}

static inline double box_width(Box box) {
    return box.high.x - box.low.x;
}

static inline double box_height(Box box) {
    return box.high.y - box.low.y;
}

static inline bool box_holds(Box box, Vec2 p) {
    return p.x >= box.low.x && p.x <= box.high.x && p.y >= box.low.y && p.y <= box.high.y;
}
