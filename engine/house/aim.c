/* A driver aims with the feet. The front edge, l_f ahead of the axle, is a to the left of where the plan has it; s is
 * the way. c_L and c_R are the clearances on the left and right of what is ahead of the axle, up to the reach of the
 * personal space, e_L = c_plan,L - a and e_R = c_plan,R + a the expected ones, clipped alike, and
 * u = (min(0, c_R - e_R) - min(0, c_L - e_L)) / 2 is what is nearer than the plan says. Then
 *
 *     a'' + 2 sqrt(K) a' + K_p a + K_r (g a + u) = n(s)       K_r = 1 / l_r^2, K_p = 1 / l_p^2, K = K_r + K_p
 *     y'  = (a - y) / l_f                                     the axle: a tractrix, without side-slip
 *
 * so that the personal space is a stimulus: on its own plan, and between walls that press alike, it is silent. Where it
 * pushes the body instead (house_ring), u is left out; where it is off, K_r is.
 * g = clamp((reach - c_ahead) / 0.1 m, 0, 1), with c_ahead the least planned clearance of the next TRACK_FORESIGHT:
 * near walls the line is held as tightly as the personal space asks, in the open room only by sight. The term with K_r
 * lags by the driver's reaction time. n is the error of steering, white by way and constant over ERROR_LENGTH, with
 * the intensity with which the front edge errs by alpha v (pace.h) near walls: 4 K^(3/2) (alpha v)^2 without a lag.
 *
 * In a turn a chair slips outwards, and its driver notices that late: the front edge is then not at a but at
 *
 *     a - d theta                                             theta the turn of the plan over the last metre, rad
 *
 * with d the row drive.drift, m/rad. A turn on the spot ends with an error of the heading, drawn for each turn, of the
 * deviation drive.spot_error. The nominal driver makes none of these errors.
 *
 * What a driver expects is not felt, however near; so a goes no farther into what is touched than the chair is, and
 * back to 0 when the driver has backed off from something, unless the plan does not know it. */
#include "house/aim.h"

#include <stdint.h>

#include "base/random.h"
#include "base/real.h"
#include "route/pace.h"
#include "route/search.h"

/* Assumed, all of them; numbers for users are in the profile. */

/* m: by which clearances near the reach tighten the line. */
static const double TIGHTENING = 0.1;
/* m: of way, over which an error of steering is constant. */
static const double ERROR_LENGTH = 0.05;
/* m: of way, over which a turn makes a chair slip. */
static const double DRIFTING = 1;
/* Apart from the streams of the errors by way. */
static const uint64_t SPOTS = (uint64_t)1 << 63;
/* 1: largest slope of the aim. */
static const double STEEPEST_AIM = 0.6;
/* m: of way, before what is in the way. */
static const double STOP_SHORT = 0.05;
/* m: so much of an offset at the beginning of a piece of the path is the tracker's; the rest is aimed at. */
static const double TRACKED = 0.01;
/* m: a body that is farther off its line than this goes on beside it for a while. */
static const double OFF_THE_LINE = 0.05;
/* m: what is this much nearer than the plan and the shift allow is not in the plan. */
static const double UNPLANNED = 2e-3;

bool aim_steers(const World *world, size_t i) {
    return house_ring(world->house) == RING_STEERS && world->house->people[i].profile->driving == DRIVING_DRIVER;
}

/* Returns the variance of a, 1/m3 times the intensity of a white n, where the term with K_r lags by `lag` m of way:
 * a / n = (lag s + 1) / (lag s^3 + (1 + 2 lag sqrt(K)) s^2 + (2 sqrt(K) + lag K_p) s + K), whose square is integrated
 * by the formula of Newton, Gould and Kaiser (1957). Without a lag it is 1 / (4 K^(3/2)). */
static double variance_of_aim(double stiffness, double by_sight, double lag) {
    double root = sqrt(stiffness), d2 = 1 + 2 * lag * root, d1 = 2 * root + lag * by_sight;
    return (lag * lag * stiffness + d2) / (2 * stiffness * (d1 * d2 - stiffness * lag));
}

/* Returns n in the present length of way. */
static double steering_error(const World *world, size_t i, const Profile *profile, double stiffness, double speed,
                             double gone) {
    uint64_t stream = ((uint64_t)i << 32) + (uint64_t)(gone / ERROR_LENGTH);
    Random random = random_seed(world->house->seed + ((uint64_t)world->house->driver << 32), stream);
    double by_sight = 1 / (profile->sight * profile->sight);
    double variance = variance_of_aim(stiffness, by_sight, speed * profile->reaction);
    return random_normal(&random, 0, pace_error(profile) * speed / sqrt(variance * ERROR_LENGTH));
}

static double aim_ahead(const Profile *profile) {
    return profile->length - profile->axle;
}

static bool errs(const House *house) {
    return house->driver > 0 && house->plan.run.wander == SWITCH_ON;
}

/* Returns where the front edge goes, m, to the left. */
static double front_of(const Profile *profile, const Drive *drive) {
    return drive->aim - profile->drift * drive->turned;
}

/* Returns the turn of the plan over the last DRIFTING m of the present piece, rad. */
static double turn_before(const Track *track, const Drive *drive, const Place *place) {
    size_t begin = drive->index;
    int direction = place_direction(track, begin);
    while (begin > 0 && place_direction(track, begin - 1) == direction && track->points[begin].s > drive->s - DRIFTING)
        begin--;
    return vec2_wrap_angle(place->heading - track->points[begin].heading);
}

/* Returns the clearance of the body at a point of the plan, shifted, m, up to 0. */
static double shifted_clearance(const World *world, const Rectangle *body, const TrackPoint *point, double shift) {
    Vec2 axis = vec2_heading(point->heading);
    Vec2 at = vec2_along(vec2_along(point->at, shift, vec2_left(axis)), body->ahead, axis);
    return freespace_clearance(&world->house->space, at, axis, body->half_length, body->half_width, 0, NULL);
}

/* Returns how far to the left of the plan the body goes on, m: as it is aimed, and farther where it has come off that,
 * as after it has given way. */
static double shift_of(const Drive *drive) {
    double aimed = drive->aside + drive->axle, off = drive->offset - aimed;
    return aimed + off - real_clamp(off, -OFF_THE_LINE, OFF_THE_LINE);
}

/* Finds the first place ahead, up to where the chair could stop twice, at which the body, shifted as it is, would meet
 * something. A shift takes no more than itself from the planned clearance: where only it is in the way, the chair
 * creeps, since it comes back to its line by driving; what takes more is not in the plan, and bars the way. */
static void look_for_obstacles(const World *world, size_t i, Drive *drive, double shift, double speed) {
    const Profile *profile = world->house->people[i].profile;
    const Track *track = &world->journeys[i].track;
    Rectangle body = search_body(profile);
    double braking = pace_braking(profile, 0), end = drive->s + speed * speed / braking + STOP_SHORT;
    for (size_t k = drive->index + 1; k < track->count && track->points[k].direction > 0; k++) {
        const TrackPoint *point = &track->points[k];
        double clearance = shifted_clearance(world, &body, point, shift);
        if (clearance < 0) {
            drive->free_way = point->s - STOP_SHORT;
            drive->barred = clearance < point->clearance - fabs(shift) - UNPLANNED;
            return;
        }
        if (point->s > end)
            break;
    }
    drive->free_way = HUGE_VAL;
}

/* Returns u, m, to the left. */
static double nearer_than_planned(const World *world, size_t i, const Drive *drive, const Place *place) {
    const Sense *sense = &world->sense[i];
    const Profile *profile = world->house->people[i].profile;
    double aside = drive->aside + front_of(profile, drive), reach = profile->space_reach;
    double left = real_min(sense->left - real_min(place->here->left - aside, reach), 0);
    double right = real_min(sense->right - real_min(place->here->right + aside, reach), 0);
    return (right - left) / 2;
}

/* A driver who touches something on one side aims no farther to that side than the chair is. */
static void stop_at_contact(const Sense *sense, Drive *drive) {
    double off = drive->offset - drive->aside, aim = drive->aim;
    if (!(sense->body_force > 0))
        return;
    if (sense->left <= 0)
        drive->aim = real_min(aim, real_max(off, 0));
    if (sense->right <= 0)
        drive->aim = real_max(drive->aim, real_min(off, 0));
    if (drive->aim != aim)
        drive->aim_slope = 0;
}

double aim_slope(const Profile *profile, const Drive *drive) {
    return (front_of(profile, drive) - drive->axle) / aim_ahead(profile);
}

/* The nominal driver makes no errors: without a stimulus the aim is the plan. */
static bool keeps_to_plan(const House *house) {
    return house->driver == 0 && house_ring(house) != RING_STEERS;
}

void aim_take(const World *world, size_t i, Drive *drive, const Place *place, int direction) {
    const House *house = world->house;
    if (keeps_to_plan(house))
        return;
    const Profile *profile = house->people[i].profile;
    double near = 1 / (profile->space_centring * profile->space_centring);
    double stiffness = near + 1 / (profile->sight * profile->sight), reach = profile->space_reach;
    double speed = real_max(direction * vec2_dot(world->velocity[i], world->axis[i]), 0);
    double moved = speed * world->clock.dt, before = drive->gone;
    drive->gone += moved;
    if (direction < 0) { /* backwards only the axle is steered */
        drive->aim = drive->axle = drive->aim_slope = drive->felt = drive->turned = 0;
        drive->aimed = direction;
        drive->free_way = HUGE_VAL;
        return;
    }
    if (direction != drive->aimed) { /* a new piece begins where the last one has ended */
        double off = drive->offset - drive->aside;
        drive->aim = drive->axle = off - real_clamp(off, -TRACKED, TRACKED);
        drive->aim_slope = drive->felt = 0;
        drive->aimed = direction;
    }
    if (errs(house) && floor(drive->gone / ERROR_LENGTH) > floor(before / ERROR_LENGTH))
        drive->error = steering_error(world, i, profile, stiffness, speed, drive->gone);
    if (errs(house))
        drive->turned = turn_before(&world->journeys[i].track, drive, place);
    double wanted = 0;
    if (house_ring(house) != RING_OFF)
        wanted = near * (real_clamp((reach - place->here->narrow) / TIGHTENING, 0, 1) * drive->aim);
    if (house_ring(house) == RING_STEERS)
        wanted += near * nearer_than_planned(world, i, drive, place);
    double noticed = profile->reaction > 0 ? real_min(world->clock.dt / profile->reaction, 1) : 1;
    drive->felt += noticed * (wanted - drive->felt);
    double bend = drive->error - 2 * sqrt(stiffness) * drive->aim_slope -
                  drive->aim / (profile->sight * profile->sight) - drive->felt;
    drive->aim_slope = real_clamp(drive->aim_slope + moved * bend, -STEEPEST_AIM, STEEPEST_AIM);
    drive->aim += moved * drive->aim_slope;
    stop_at_contact(&world->sense[i], drive);
    drive->axle += moved * (front_of(profile, drive) - drive->axle) / aim_ahead(profile);
    if (aim_steers(world, i) && (world->clock.step + i) % world->decision_steps == 0)
        look_for_obstacles(world, i, drive, shift_of(drive), speed);
}

double aim_spot_error(const World *world, size_t i, size_t end) {
    const House *house = world->house;
    if (!errs(house))
        return 0;
    uint64_t turn = end + ((uint64_t)world->drive[i].plans << 24), stream = SPOTS + ((uint64_t)i << 32) + turn;
    Random random = random_seed(house->seed + ((uint64_t)house->driver << 32), stream);
    return random_normal(&random, 0, radians(house->people[i].profile->spot_error));
}
