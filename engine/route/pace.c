#include "route/pace.h"

#include <math.h>
#include <stdbool.h>

/* 1, assumed: the share of the turning moment with which a driver plans. */
static const double PLANNED_MOMENT = 0.5;
/* 1, assumed: the share of the turn rate with which a driver plans; the rest is a reserve for coming back to the path.
 */
static const double PLANNED_TURN = 0.9;

/* m/s2: the least acceleration that is planned with, so that times stay finite without any strength. */
static const double WEAKEST = 0.01;

double pace_creep(const Profile *profile) {
    return profile->creep > 0 ? profile->creep : PACE_CREEP;
}

/* Returns the speed, m/s, that the clearance allows. */
static double speed_in_gap(const Profile *profile, double free, double clearance) {
    double speed = profile->steering_time > 0 ? 2 * clearance / profile->steering_time : HUGE_VAL;
    if (clearance < profile->hands)
        speed = fmin(speed, PACE_TUCKED_SPEED);
    return fmin(fmax(speed, profile->creep > 0 ? profile->creep : profile->minimum_speed), free);
}

double pace_at(const Profile *profile, double free, double clearance, double curvature, double bending, int direction) {
    double speed = speed_in_gap(profile, free, clearance);
    if (direction < 0)
        speed = fmin(speed, profile->reversing_speed);
    double bend = fabs(curvature), change = fabs(bending);
    if (bend > 0)
        speed = fmin(speed, fmin(sqrt(profile->lateral_acceleration / bend), PLANNED_TURN * profile->turn_rate / bend));
    double square = profile->radius_of_gyration * profile->radius_of_gyration +
                    profile->mass_centre * profile->mass_centre; /* m2, of the inertia about the axle */
    double inertia = profile->mass * square;
    if (change > 0 && inertia > 0)
        speed = fmin(speed, sqrt(PLANNED_MOMENT * profile->turning_moment / (inertia * change)));
    return fmax(speed, fmin(pace_creep(profile), free));
}

double pace_enough(const Profile *profile) {
    return profile->free_speed * profile->steering_time / 2;
}

static double strength(const Profile *profile, double clearance) {
    double share = clearance < profile->hands ? PACE_TUCKED_PUSH : 1;
    return fmax(share * profile->push / profile->mass, WEAKEST);
}

double pace_starting(const Profile *profile, double clearance) {
    return fmin(profile->acceleration, strength(profile, clearance));
}

double pace_braking(const Profile *profile, double clearance) {
    bool paper = profile->driving != DRIVING_DRIVER;
    return PACE_PLANNED * (paper ? profile->deceleration : fmin(profile->deceleration, strength(profile, clearance)));
}

double pace_error(const Profile *profile) {
    return profile->caution > 0 ? profile->steering_time / (2 * profile->caution) : 0;
}
