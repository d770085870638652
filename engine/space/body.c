#include "space/body.h"

Body body_of(const Profile *profile) {
    Body body = {.core_count = 1,
                 .radius = profile->width / 2,
                 .reach = profile->space_reach,
                 .sight = fmax(profile->space_reach, BODY_SIGHT)};
    if (profile->driving == DRIVING_WALKER)
        body.sight = body.reach;
    if (profile->driving == DRIVING_DRIVER) {
        double rear = -profile->axle - profile->mass_centre;
        body.core_count = 4;
        body.radius = profile->corner_radius;
        body.core_low = vec2(rear + body.radius, body.radius - profile->width / 2);
        body.core_high = vec2(rear + profile->length - body.radius, profile->width / 2 - body.radius);
    }
    body.core[0] = body.core_low;
    body.core[1] = vec2(body.core_high.x, body.core_low.y);
    body.core[2] = body.core_high;
    body.core[3] = vec2(body.core_low.x, body.core_high.y);
    body.middle = vec2_scale(vec2_add(body.core_low, body.core_high), 0.5);
    body.half = vec2_scale(vec2_sub(body.core_high, body.core_low), 0.5);
    for (int i = 0; i < 4; i++) {
        body.swing = fmax(body.swing, vec2_length(body.core[i]));
        body.outer = fmax(body.outer, vec2_length(vec2_sub(body.core[i], body.middle)) + body.radius + body.sight);
    }
    return body;
}
