#include "house/shake.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>

#include "base/digest.h"
#include "base/random.h"
#include "base/real.h"
#include "base/rectangle.h"
#include "base/text.h"
#include "plan/plan_geometry.h"

/* m: a body that overlaps by less is not caught, since rounding would decide. */
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

static bool catches_rectangle(const Vec2 corners[4], const Inhabitant *person) {
    const Profile *profile = person->profile;
    Vec2 axis = vec2_heading(person->heading), body[4];
    Vec2 middle = vec2_along(person->at, profile->length / 2 - profile->axle, axis);
    rectangle_corners(middle, axis, vec2(profile->length, profile->width), body);
    return rectangle_overlap(corners, body) > GRAZED;
}

static bool catches_disc(const Vec2 corners[4], Vec2 at, double radius) {
    Vec2 side = vec2_unit(vec2_sub(corners[1], corners[0]));
    Vec2 own = vec2_unturn(vec2_sub(at, vec2_scale(vec2_add(corners[0], corners[2]), 0.5)), side);
    double out_x = fmax(fabs(own.x) - vec2_distance(corners[0], corners[1]) / 2, 0);
    double out_y = fmax(fabs(own.y) - vec2_distance(corners[1], corners[2]) / 2, 0);
    return real_hypot(out_x, out_y) < radius - GRAZED;
}

const Furniture *shake_catches(const Plan *plan, const bool *topples, const Inhabitant *person) {
    for (size_t f = 0; f < plan->furniture_count; f++) {
        if (!topples[f])
            continue;
        Furniture lying = plan->furniture[f];
        lying.toppled = true;
        Vec2 corners[4];
        plan_geometry_corners(&lying, corners);
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
