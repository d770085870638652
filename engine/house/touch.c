#include "house/touch.h"

/* m, assumed: what touches nearer to an end of the body than this belongs to that end. */
static const double END = 0.10;

static double inertia_about_axle(const Profile *profile) {
    double gyration = profile->radius_of_gyration, ahead = profile->mass_centre;
    return profile->mass * (gyration * gyration + ahead * ahead);
}

double touch_mass(const Profile *profile, Vec2 axis, Vec2 arm, Vec2 normal) {
    if (profile->driving != DRIVING_DRIVER)
        return profile->mass;
    Vec2 from_axle = vec2_along(arm, profile->mass_centre, axis);
    double along = vec2_dot(normal, axis), turning = vec2_cross(from_axle, normal);
    return 1 / (along * along / profile->mass + turning * turning / inertia_about_axle(profile));
}

static int part_at(const Profile *profile, Vec2 axis, Vec2 arm) {
    double ahead = vec2_dot(arm, axis) + profile->mass_centre; /* of the axle */
    if (ahead > profile->length - profile->axle - END)
        return PART_FRONT;
    return ahead < END - profile->axle ? PART_TAIL : PART_SIDE;
}

void touch_begin(Sense *sense, const Profile *profile, Vec2 axis, Vec2 arm, Vec2 normal, double rate, double against) {
    if (-rate <= sense->impact)
        return;
    sense->impact = -rate;
    sense->mass = 1 / (1 / touch_mass(profile, axis, arm, normal) + 1 / against);
    sense->energy = sense->mass * rate * rate / 2;
    sense->part = part_at(profile, axis, arm);
}

const char *touch_part(int part) {
    static const char *const names[] = {"front", "side", "tail", "hand"};
    return names[part];
}
