#include "house/shake.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>

#include "base/digest.h"
#include "base/random.h"
#include "base/text.h"

/* m: a body that is touched by less is not caught, as rounding decides there. */
static const double GRAZED = 1e-3;

void shake_draw(const Plan *plan, uint64_t seed, bool *topples) {
    for (size_t f = 0; f < plan->furniture_count; f++) {
        const Furniture *piece = &plan->furniture[f];
        Random random = random_seed(seed, digest_text(DIGEST_START, piece->id));
        topples[f] = shake_can_topple(piece) && random_uniform(&random) < piece->probability;
    }
}

size_t shake_settings(const Plan *plan, const bool *topples, const char **settings, Arena *arena) {
    size_t count = 0;
    for (size_t f = 0; f < plan->furniture_count; f++)
        if (topples[f])
            settings[count++] = text_in_arena(arena, "furniture.%s.toppled=true", plan->furniture[f].id);
    return count;
}

/* How far two ranges overlap; negative: they are apart. */
static double overlap(double low_a, double high_a, double low_b, double high_b) {
    return fmin(high_a, high_b) - fmax(low_a, low_b);
}

/* Of a rectangle along `axis`, in the frame of another one about `middle`. */
static bool is_apart(const Vec2 corners[4], Vec2 middle, Vec2 axis, double half_length, double half_width) {
    Vec2 low = {HUGE_VAL, HUGE_VAL}, high = {-HUGE_VAL, -HUGE_VAL};
    for (int i = 0; i < 4; i++) {
        Vec2 own = vec2_unturn(vec2_sub(corners[i], middle), axis);
        low = vec2(fmin(low.x, own.x), fmin(low.y, own.y));
        high = vec2(fmax(high.x, own.x), fmax(high.y, own.y));
    }
    return overlap(low.x, high.x, -half_length, half_length) < GRAZED ||
           overlap(low.y, high.y, -half_width, half_width) < GRAZED;
}

/* Lies a rectangle (corners) on the body's? Two rectangles are apart when they are along a side of one of them. */
static bool catches_rectangle(const Vec2 corners[4], const Inhabitant *person) {
    const Profile *profile = person->profile;
    Vec2 axis = vec2_heading(person->heading), side = vec2_unit(vec2_sub(corners[1], corners[0]));
    double half_length = profile->length / 2, half_width = profile->width / 2;
    Vec2 middle = vec2_along(person->at, half_length - profile->axle, axis), body[4];
    for (int i = 0; i < 4; i++) {
        Vec2 own = {i == 0 || i == 3 ? -half_length : half_length, i < 2 ? -half_width : half_width};
        body[i] = vec2_add(middle, vec2_turn(own, axis));
    }
    Vec2 centre = vec2_scale(vec2_add(corners[0], corners[2]), 0.5);
    return !is_apart(corners, middle, axis, half_length, half_width) &&
           !is_apart(body, centre, side, vec2_distance(corners[0], corners[1]) / 2,
                     vec2_distance(corners[1], corners[2]) / 2);
}

static bool catches_disc(const Vec2 corners[4], Vec2 at, double radius) {
    Vec2 side = vec2_unit(vec2_sub(corners[1], corners[0]));
    Vec2 own = vec2_unturn(vec2_sub(at, vec2_scale(vec2_add(corners[0], corners[2]), 0.5)), side);
    double out_x = fmax(fabs(own.x) - vec2_distance(corners[0], corners[1]) / 2, 0);
    double out_y = fmax(fabs(own.y) - vec2_distance(corners[1], corners[2]) / 2, 0);
    return hypot(out_x, out_y) < radius - GRAZED;
}

const Furniture *shake_catches(const Plan *plan, const bool *topples, const Inhabitant *person) {
    for (size_t f = 0; f < plan->furniture_count; f++) {
        if (!topples[f])
            continue;
        Furniture lying = plan->furniture[f];
        lying.toppled = true;
        Vec2 corners[4];
        plan_furniture_corners(&lying, corners);
        bool rectangle = person->profile->driving == DRIVING_DRIVER;
        if (rectangle ? catches_rectangle(corners, person)
                      : catches_disc(corners, person->at, person->profile->width / 2))
            return &plan->furniture[f];
    }
    return NULL;
}

Route shake_route(const Plan *plan, const Inhabitant *caught) {
    Route route = {.answer = ROUTE_CANNOT_PASS, .exit = SIZE_MAX, .blockage = {.at = caught->at}};
    char name[sizeof route.blockage.what - sizeof "under "];
    outline_name(plan, OWNER_FURNITURE, (int)(caught->under - plan->furniture), name, sizeof name);
    snprintf(route.blockage.what, sizeof route.blockage.what, "under %s", name);
    return route;
}
