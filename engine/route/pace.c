#include "route/pace.h"

#include <math.h>
#include <stdbool.h>

#include "base/real.h"

/* 1, assumed: the share of the turn rate with which a driver plans; the rest is a reserve for coming back to the path.
 */
static const double PLANNED_TURN = 0.9;
/* 1, assumed: the share of the push that the swing of the mass centre may take; the rest is for braking. */
static const double PLANNED_SWING = 0.5;

/* m/s, assumed: the slowest that a driver turns with on the way; less could as well be a turn on the spot. */
static const double TURNING_CREEP = 0.03;

/* m/s2: the least acceleration that is planned with, so that times stay finite without any strength. */
static const double WEAKEST = 0.01;

/* Returns the speed, m/s, that the clearance allows. */
static double speed_in_gap(const Profile *profile, double free, double clearance) {
    double speed = profile->steering_time > 0 ? 2 * clearance / profile->steering_time : HUGE_VAL;
    if (clearance < profile->hands)
        speed = real_min(speed, PACE_TUCKED_SPEED);
    return real_min(real_max(speed, profile->minimum_speed), free);
}

double pace_turning(const Profile *profile) {
    double square = profile->radius_of_gyration * profile->radius_of_gyration +
                    profile->mass_centre * profile->mass_centre; /* m2, of the inertia about the axle */
    double inertia = profile->mass * square;
    return inertia > 0 ? PACE_MOMENT * profile->turning_moment / inertia : HUGE_VAL;
}

/* Returns the turn rate that is planned with, rad/s: with the push the driver holds the mass centre, which swings
 * outwards by m c w^2. */
static double planned_turn(const Profile *profile) {
    double swung = profile->mass * profile->mass_centre;
    double held = swung > 0 ? sqrt(PLANNED_SWING * profile->push / swung) : HUGE_VAL;
    return PLANNED_TURN * real_min(profile->turn_rate, held);
}

Agility pace_agility(const Profile *profile) {
    double swung = profile->mass * profile->mass_centre;
    return (Agility){pace_turning(profile), planned_turn(profile),
                     swung > 0 ? PACE_MOMENT * profile->turning_moment / swung : HUGE_VAL, pace_sharpest(profile)};
}

double pace_in_passage(const Profile *profile, double free, double width) {
    double speed = profile->steering_time > 0 ? (width - profile->width) / profile->steering_time : HUGE_VAL;
    return real_min(real_max(speed, profile->creep), free);
}

double pace_at(const Profile *profile, const Agility *agility, double passage, double clearance, double curvature,
               double bending, int direction) {
    double speed = speed_in_gap(profile, passage, clearance);
    if (direction < 0)
        speed = real_min(speed, profile->reversing_speed);
    double bend = fabs(curvature), change = fabs(bending);
    if (bend > 0)
        speed = real_min(speed, real_min(sqrt(real_min(profile->lateral_acceleration, agility->swing) / bend),
                                         agility->rate / bend));
    if (change > 0)
        speed = real_min(speed, sqrt(agility->acceleration / change));
    return real_max(speed, real_min(TURNING_CREEP, passage));
}

double pace_price(const Profile *profile, double left, double right) {
    double reach = profile->space_reach;
    double on_left = real_max(reach - left, 0), on_right = real_max(reach - right, 0);
    return reach > 0 ? profile->space_price * (on_left * on_left + on_right * on_right) / (reach * reach) : 0;
}

double pace_enough(const Profile *profile) {
    return profile->free_speed * profile->steering_time / 2;
}

static double strength(const Profile *profile, double clearance) {
    double share = clearance < profile->hands ? PACE_TUCKED_PUSH : 1;
    return real_max(share * profile->push / profile->mass, WEAKEST);
}

double pace_starting(const Profile *profile, double clearance) {
    return real_min(profile->acceleration, strength(profile, clearance));
}

double pace_braking(const Profile *profile, double clearance) {
    bool paper = profile->driving != DRIVING_DRIVER;
    return PACE_PLANNED *
           (paper ? profile->deceleration : real_min(profile->deceleration, strength(profile, clearance)));
}

double pace_spot_moment(const Profile *profile) {
    const double rate = 0.1, turned = 1; /* rad/s, rad */
    double gyration = profile->radius_of_gyration, ahead = profile->mass_centre;
    return profile->scrub + profile->mass * (gyration * gyration + ahead * ahead) * rate * rate / (2 * turned);
}

double pace_sharpest(const Profile *profile) {
    return planned_turn(profile) / TURNING_CREEP;
}

double pace_in_bend(double turning, double curvature) {
    double bend = fabs(curvature);
    return bend > 0 ? real_max(turning / bend, WEAKEST) : HUGE_VAL;
}

double pace_error(const Profile *profile) {
    return profile->caution > 0 ? profile->steering_time / (2 * profile->caution) : 0;
}
