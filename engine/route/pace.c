#include "route/pace.h"

#include <math.h>

/* 1, assumed: the share of the turning moment with which a driver plans. */
static const double PLANNED_MOMENT = 0.5;
/* 1, assumed: the share of the turn rate with which a driver plans; the rest is a reserve for coming back to the path.
 */
static const double PLANNED_TURN = 0.9;

double pace_at(const Profile *profile, double free, double clearance, double curvature, double bending, int direction) {
    double speed = profile->steering_time > 0 ? 2 * clearance / profile->steering_time : HUGE_VAL;
    speed = fmin(fmax(speed, profile->minimum_speed), free);
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
    return fmax(speed, fmin(PACE_CREEP, free));
}

double pace_enough(const Profile *profile) {
    return profile->free_speed * profile->steering_time / 2;
}
