#include "house/drive.h"

#include "base/real.h"
#include "house/aim.h"
#include "house/place.h"
#include "house/track.h"
#include "house/yield.h"
#include "plan/plan_geometry.h"
#include "route/pace.h"
#include "route/search.h"

/* All constants below are assumed; numbers for users are in the profile. */

/* rad: a turn on the spot counts as done this near to its end. */
static const double TURNED = 0.005;
/* 1: the share of the turning moment with which the end of a turn on the spot is planned. */
static const double SPOT_BRAKE = 0.4;
/* m: distance before the place where a door must be open at which a standing person reaches the handle. */
static const double ARMS_REACH = 0.25;
/* m: distance from the line of an exit that is not open. */
static const double STAND_OFF = 0.10;
/* rad: largest angle of the heading back towards the path. */
static const double STEEPEST_RETURN = 0.6;
/* 1: a driver who is passing overcomes the force of the personal space, as far as it exceeds this share of the driver's
 * own force. */
static const double HEEDED = 0.5;
/* Lateral control of a round body, which is not in the paper. */
static const double ROUND_RETURN_TIME = 1.0;  /* s, back to the middle of the path */
static const double ROUND_RETURN_SPEED = 0.2; /* m/s, at most */
static const double ROUND_LATERAL = 1.0;      /* m/s2, at most */
/* m and rad: smaller progress than this does not count. */
static const double PROGRESS = 0.05;
/* m: who is this far behind the farthest place has been pushed back by others; a retreat is half as long. */
static const double PUSHED_BACK = 2 * PLACE_RETREAT;
/* s and number: when a touching person without progress backs off, by PLACE_RETREAT, and how often. */
static const double RETRY_AFTER = 2;
enum { RETRIES_MOST = 3 };
/* m: the longest retreat, and the clearance that it keeps. */
static const double FARTHEST_RETREAT = 3, BEHIND = 0.05;
/* s: in which a driver who stands and changes direction turns to the heading of the path. */
static const double ALIGNING = 0.3;
/* m: lower bound of R, the denominator in the paper's F4. */
static const double SMALLEST_RADIUS = 0.1;

/* Counts the time without progress; from a place to which others have pushed a person back, the way counts again. */
static void watch_progress(Drive *drive, double dt) {
    drive->stalled += dt;
    if (drive->s < drive->best_s - PUSHED_BACK)
        drive->best_s = drive->s;
    if (drive->s > drive->best_s + PROGRESS) {
        drive->best_s = drive->s;
        drive->stalled = drive->room_by = 0;
        drive->retries = 0;
    }
}

/* Returns the way, up to `most` m, for which the chair can go straight back from where it goes in a direction. */
static double way_back(const World *world, size_t i, int direction, double most) {
    Rectangle rectangle = search_body(world->house->people[i].profile);
    Vec2 axis = world->axis[i];
    double way = 0;
    for (; way < most; way += PLACE_RETREAT) {
        Vec2 at = vec2_along(world->centre[i], -direction * (way + PLACE_RETREAT), axis);
        if (way + PLACE_RETREAT > world->drive[i].behind ||
            freespace_clearance(&world->house->space, at, axis, rectangle.half_length, rectangle.half_width, BEHIND,
                                NULL) < BEHIND)
            break;
    }
    return real_min(way, most);
}

static void begin_retreat(const World *world, size_t i, Drive *drive, double due) {
    int direction = place_direction(&world->journeys[i].track, drive->index);
    double way = drive->meets ? way_back(world, i, direction, real_min(drive->way_round, FARTHEST_RETREAT)) : 0;
    double takes = way / world->house->people[i].profile->reversing_speed;
    drive->retreats = true;
    drive->retreat_to = drive->s - real_max(way, PLACE_RETREAT);
    drive->retreat_by = real_max(due + 2 * RETRY_AFTER, drive->stalled + RETRY_AFTER + takes);
    drive->room_by = way > PLACE_RETREAT ? drive->retreat_by + takes : 0;
    drive->retries++;
}

/* Lets a person who has run into something back off a little and try again; one for whom others wait tries as often as
 * needed, and goes back as far as it takes to swerve round who comes the other way. Returns true during the retreat,
 * which does not leave the present part of the path, but goes straight on behind the beginning of a path that was
 * planned where the person got stuck. */
static bool retreats(const World *world, size_t i, Drive *drive, bool touches) {
    const Track *track = &world->journeys[i].track;
    bool yields = drive->gives_way || drive->heeded < 0;
    double due = RETRY_AFTER * (drive->retries + (drive->gives_way ? 1 : 2));
    if (!drive->retreats && touches && drive->stalled > due && (yields || drive->retries < RETRIES_MOST))
        begin_retreat(world, i, drive, due);
    bool ended = drive->s <= drive->retreat_to || drive->stalled > drive->retreat_by ||
                 (drive->index > 0 && track->points[drive->index].direction != place_direction(track, drive->index));
    if (drive->retreats && ended) {
        drive->retreats = false;
        if (!drive->barred) /* the next attempt aims at the plan, not beside it like the last one */
            drive->aim = drive->axle = drive->aim_slope = drive->felt = 0;
    }
    return drive->retreats;
}

/* Moves back along the track with the retreating reference point. */
static void step_back(const Track *track, Vec2 at, Drive *drive) {
    while (drive->index > 0 && track->points[drive->index].direction == place_direction(track, drive->index)) {
        const TrackPoint *here = &track->points[drive->index];
        Vec2 way = vec2_sub(here[1].at, here->at);
        if (drive->index + 1 >= track->count || vec2_dot(vec2_sub(at, here->at), way) >= 0)
            return;
        drive->index--;
    }
}

/* Doors ------------------------------------------------------------------------------------------------------------ */

/* Returns the distance, m, to the waiting point before the next shut door; infinite without one. */
static double way_to_door(const World *world, size_t i, int *door) {
    const Track *track = &world->journeys[i].track;
    int next = track->points[world->drive[i].index].next_door;
    while (next >= 0 && world->door_open[track->points[next].door])
        next = (size_t)next + 1 < track->count ? track->points[next + 1].next_door : -1;
    if (next < 0)
        return HUGE_VAL;
    const TrackPoint *point = &track->points[next];
    *door = point->door;
    return point->s - world->drive[i].s;
}

/* A target speed, m/s, and its change when it is driven, m/s2. */
typedef struct Pace {
    double speed, hurry;
} Pace;

/* Returns the braking, m/s2, that is planned with at a point of the track, as the track's own speeds are. */
static double braking_at(const Profile *profile, const TrackPoint *point) {
    double braking = pace_braking(profile, point->clearance);
    return profile->driving == DRIVING_DRIVER ? real_min(braking, pace_in_bend(pace_turning(profile), point->curvature))
                                              : braking;
}

/* Returns the highest speed, up to `most` m/s, at which the person can still stop at `end`, m along the track. */
static Pace speed_to_stop(const Track *track, const Profile *profile, const Drive *drive, double end, double most) {
    const TrackPoint *points = track->points;
    Pace pace = {0, -braking_at(profile, &points[drive->index])};
    if (end <= drive->s)
        return pace;
    size_t k = drive->index;
    while (k + 1 < track->count && points[k + 1].s < end)
        k++;
    double square = 0;
    for (;; k--) {
        square += 2 * braking_at(profile, &points[k]) * (end - real_max(points[k].s, drive->s));
        end = points[k].s;
        if (k == drive->index || square > most * most)
            break;
    }
    pace.speed = sqrt(square);
    return pace;
}

/* Returns the highest speed at which the person can still stop before a shut door, and before an exit that is not open.
 */
static Pace speed_to_barriers(const World *world, size_t i, Drive *drive, double most) {
    const Journey *journey = &world->journeys[i];
    const Track *track = &journey->track;
    const Exit *exit = &world->house->plan.exits[journey->route.exit];
    const Profile *profile = world->house->people[i].profile;
    double time = clock_time(&world->clock);
    int door = -1;
    double way = way_to_door(world, i, &door);
    if (!plan_geometry_is_open(exit, time))
        way = real_min(way, track->exit_s - STAND_OFF - drive->s);
    if (time < exit->opens)
        drive->stalled = 0; /* the exit will open */
    Pace pace = {HUGE_VAL, 0};
    if (way < HUGE_VAL)
        pace = speed_to_stop(track, profile, drive, drive->s + way, most);
    if (!aim_steers(world, i) || !(drive->free_way < HUGE_VAL))
        return pace;
    Pace before_obstacle = speed_to_stop(track, profile, drive, drive->free_way, most);
    if (!drive->barred && before_obstacle.speed < profile->creep)
        before_obstacle = (Pace){profile->creep, 0};
    return pace.speed < before_obstacle.speed ? pace : before_obstacle;
}

/* Returns the track's speed, limited by doors and exits; 0 at the end of the track. */
static Pace wanted_speed(const World *world, size_t i, Drive *drive, const Place *place) {
    if (place->next == place->here)
        return (Pace){0, 0};
    Pace planned = place->speed < PLACE_SLOWEST ? (Pace){PLACE_SLOWEST, 0} : (Pace){place->speed, place->hurry};
    Pace pace = speed_to_barriers(world, i, drive, planned.speed);
    return pace.speed < planned.speed ? pace : planned;
}

int drive_door_at_hand(const World *world, size_t i) {
    int door = -1;
    bool at_rest = vec2_length(world->velocity[i]) < 2 * PLACE_SLOWEST;
    return way_to_door(world, i, &door) < ARMS_REACH && at_rest ? door : -1;
}

/* Forces ------------------------------------------------------------------------------------------------------------*/

/* Returns F3: towards the target speed along a direction, which itself changes at `hurry`, m/s2, limited by the
 * acceleration `faster_by`, m/s2, by a_d and the push; `others` is the sum of other forces along the direction. The
 * paper's element knows only its speed and yields to forces; a driver feels them (`holding` is 1) and pushes against
 * them, with `most` N. */
static double driving_force(const Profile *profile, double most, double faster_by, double target, double hurry,
                            double speed, double others, double holding) {
    double wanted = profile->mass * ((target - speed) / profile->speed_response + hurry) - holding * others;
    double ahead = profile->mass * (target > 0 && speed >= 0 ? faster_by : profile->deceleration);
    double back = profile->mass * (target < 0 && speed <= 0 ? faster_by : profile->deceleration);
    wanted = real_clamp(wanted, -back - others, ahead - others);
    return real_clamp(wanted, -most, most);
}

/* rad/s2: with less turning moment than this per moment of inertia, a driver steers more calmly. */
static const double AGILE = 4.5;
/* m: of way within the response of the turn rate; on a longer one a driver comes back to the path more slowly, since
 * from twice that on a chair would swing about it. */
static const double PROMPT = 0.15;

/* Returns the angular acceleration that the whole turning moment gives about the axle, rad/s2. */
static double agility(const Profile *profile) {
    double square =
        profile->radius_of_gyration * profile->radius_of_gyration + profile->mass_centre * profile->mass_centre;
    return profile->turning_moment / (profile->mass * square);
}

/* Returns how many times as long a way a driver takes to come back to the path: the moment that an offset calls for
 * falls with the third power of that length, so that a weak driver is not asked for more than there is, and does not
 * swing about the path. */
static double calmness(const Profile *profile) {
    return agility(profile) < AGILE ? real_exp(real_log(AGILE / agility(profile)) / 3) : 1;
}

/* Returns how much of the path's own curvature is driven, the rest being the average of what is near, 1: less than all
 * where its change asks for `change`, rad/s2, of which there is not as much. */
static double sharpness(const Profile *profile, double change) {
    double most = PACE_OWN_MOMENT * agility(profile);
    return fabs(change) > most ? most / fabs(change) : 1;
}

/* Returns the moment towards the turn rate `target`, rad/s, which itself changes at `rate`, rad/s2, against the moment
 * `load` about the axle of contacts with the body or its personal space: a driver feels the load and holds against it,
 * up to the strength of the arms: `most` N m. */
static double turning_moment(const Profile *profile, double most, double target, double rate, double turn,
                             double load) {
    double square = profile->radius_of_gyration * profile->radius_of_gyration +
                    profile->mass_centre * profile->mass_centre; /* about the axle */
    double response = calmness(profile) * profile->turn_response;
    double wanted = profile->mass * square * ((target - turn) / response + rate) - load;
    return real_clamp(wanted, -most, most);
}

/* Returns the effort that cancels the force of the personal space beyond what the driver yields to, since the driver
 * intends to come that near. */
static Effort overcome(const World *world, size_t i) {
    const Profile *profile = world->house->people[i].profile;
    Vec2 axis = world->axis[i];
    double along = vec2_dot(world->ring[i], axis), moment = world->ring_moment[i];
    double push = HEEDED * profile->push, turning = HEEDED * profile->turning_moment;
    return (Effort){vec2_scale(axis, real_clamp(along, -push, push) - along),
                    real_clamp(moment, -turning, turning) - moment};
}

/* Returns the moment about the axle, N m, that the driver holds against. `force` and `moment`, about the mass centre,
 * are those of contacts: the drive wheels do not slip sideways, so that a force across the chair turns it about the
 * axle. A driver who touches something and is stalled holds against nothing, so that the contact turns the chair along
 * it. */
static double load_of(const World *world, size_t i, Vec2 force, double moment) {
    if (world->sense[i].body_force > 0 && world->drive[i].stalled > RETRY_AFTER)
        return 0;
    return moment + world->house->people[i].profile->mass_centre * vec2_cross(world->axis[i], force);
}

/* True if a driver gets nowhere, backs off or touches something, and so uses both arms however narrow the place is. */
static bool frees_itself(const World *world, size_t i) {
    const Drive *drive = &world->drive[i];
    return drive->retreats || drive->stalled > RETRY_AFTER || world->sense[i].body_force > 0;
}

/* Returns a driver's effort towards a speed along the axis, m/s, that itself changes at `hurry`, m/s2, and a turn rate,
 * rad/s, that changes at `change`, rad/s2, and by `bend`, rad/m, with the speed, with `strength` N m. */
static Effort exert(const World *world, size_t i, double speed, double hurry, double turn, double change, double bend,
                    double strength) {
    const Profile *profile = world->house->people[i].profile;
    Vec2 axis = world->axis[i];
    Effort effort = overcome(world, i);
    Vec2 felt = vec2_add(world->force[i], effort.force);
    double swing =
        profile->mass * profile->mass_centre * world->turn[i] * world->turn[i]; /* N, outwards from the axle */
    double others = vec2_dot(felt, axis) + swing, load = load_of(world, i, felt, world->moment[i] + effort.moment);
    const TrackPoint *here = &world->journeys[i].track.points[world->drive[i].index];
    bool tucked = here->clearance < profile->hands && !frees_itself(world, i);
    double bent = real_max(fabs(here->curvature), fabs(bend));
    double faster = real_min(profile->acceleration, pace_in_bend(pace_turning(profile), bent));
    double most = (tucked ? PACE_TUCKED_PUSH : 1) * profile->push;
    double push = driving_force(profile, most, faster, speed, hurry, vec2_dot(world->velocity[i], axis), others, 1);
    effort.force = vec2_along(effort.force, push, axis);
    change += bend * (push + others) / profile->mass;
    effort.moment += turning_moment(profile, strength, turn, change, world->turn[i], load);
    return effort;
}

/* Turns on the spot, heading by heading of the track, and comes to rest where the track stops turning to that side. */
static Effort turn_on_the_spot(const World *world, size_t i, Drive *drive, const Place *place) {
    const Track *track = &world->journeys[i].track;
    const Profile *profile = world->house->people[i].profile;
    Vec2 axis = world->axis[i];
    size_t end = drive->index + 1;
    double left = vec2_wrap_angle(track->points[end].heading - world->heading[i]);
    double planned = vec2_wrap_angle(track->points[end].heading - place->here->heading);
    while (end + 1 < track->count && track->points[end + 1].direction == 0) {
        double more = vec2_wrap_angle(track->points[end + 1].heading - track->points[end].heading);
        if (more * planned < 0)
            break;
        left += more;
        planned += more;
        end++;
    }
    left += aim_spot_error(world, i, end);
    bool last = end == drive->index + 1;
    double response = calmness(profile) * profile->turn_response;
    double step = fabs(vec2_wrap_angle(place->next->heading - place->here->heading));
    bool ended = last ? fabs(left) < real_max(TURNED, copysign(response, left) * world->turn[i])
                      : fabs(planned) < TURNED || ((left - planned) * planned < 0 && fabs(left) < fabs(planned) - step);
    if (ended)
        place_pass(track, profile, drive);
    drive->aimed = 0;
    if (fabs(left) < drive->best_turn - PROGRESS) {
        drive->best_turn = fabs(left);
        drive->stalled = 0;
    }
    double inertia = profile->mass * profile->radius_of_gyration * profile->radius_of_gyration;
    double strength = real_max(profile->turning_moment - profile->scrub, 0); /* N m */
    double brake = SPOT_BRAKE * strength / inertia;                          /* rad/s2 */
    int door = -1;
    bool barred = way_to_door(world, i, &door) < 2 * PLACE_ARRIVED; /* barred until the door is open */
    double slower = sqrt(2 * brake * fabs(left)), rate = real_min(profile->turn_rate, slower);
    double change = rate < slower || barred || !(slower > 0) ? 0 : -brake * real_clamp(world->turn[i] / slower, -1, 1);
    double back = vec2_dot(vec2_sub(place->here->at, world_reference(world, i)), axis);
    double speed = real_clamp(back / profile->speed_response / 4, -2 * PLACE_SLOWEST, 2 * PLACE_SLOWEST);
    return exert(world, i, speed, 0, copysign(barred ? 0 : rate, left), change, 0, strength);
}

static Effort drive_driver(const World *world, size_t i, Drive *drive, const Place *place) {
    const Profile *profile = world->house->people[i].profile;
    Vec2 axis = world->axis[i];
    int direction = place_direction(&world->journeys[i].track, drive->index);
    if (direction == 0)
        return turn_on_the_spot(world, i, drive, place);
    Pace wanted = wanted_speed(world, i, drive, place);
    double target = yield_speed(world, i, drive, vec2_scale(axis, direction), wanted.speed);
    aim_take(world, i, drive, place, direction);
    if (drive->pause > 0) {
        drive->pause -= world->clock.dt;
        target = 0;
    }
    int sense = 1; /* forwards or backwards along the path */
    bool held = world->sense[i].body_force > 0 || world->sense[i].ring > 0 || target < 0;
    target = real_max(target, 0);
    if (retreats(world, i, drive, held)) {
        target = profile->reversing_speed;
        sense = -1;
    }
    /* Offsets and turns in the body's own frame: its left, its heading, also when it goes backwards. */
    double speed = vec2_dot(world->velocity[i], axis);
    double offset = direction * (drive->offset - drive->aside - drive->axle);
    double pace = target > 0 ? real_max(fabs(speed), real_min(target, PLACE_SLOWEST)) : 0;
    double swerve = drive->swerve; /* 1: the slope of the swerve itself */
    if (direction > 0)
        swerve += aim_slope(profile, drive);
    double slant = vec2_wrap_angle(world->heading[i] - place->heading) - swerve;
    double sharp = sharpness(profile, place->bending * pace * pace);
    double bend = (target > 0) * (place->even + sharp * (place->curvature - place->even));
    double bending = place->even_bending + sharp * (place->bending - place->even_bending);
    /* Return to the path at an angle in proportion to the offset, with an upper bound, so that no chair turns round
     * however far off it is. */
    double calm = calmness(profile) * real_max(1, pace * profile->turn_response / PROMPT);
    double back = profile->heading_gain > 0 ? profile->lateral_gain / (calm * profile->heading_gain) * offset : 0;
    back = sense * direction * real_clamp(back, -STEEPEST_RETURN, STEEPEST_RETURN);
    double turn = sense * bend * pace - profile->heading_gain / calm * pace * real_sin(slant + back);
    if (drive->pause > 0)
        turn = -slant / ALIGNING;
    turn = real_clamp(turn, -profile->turn_rate, profile->turn_rate);
    bool as_wanted = sense > 0 && target > 0 && target == wanted.speed;
    double hurry = as_wanted ? wanted.hurry * real_clamp(direction * speed / target, 0, 1) : 0;
    return exert(world, i, sense * direction * target, direction * hurry, turn, pace * pace * bending, direction * bend,
                 profile->turning_moment);
}

/* Drives as in the paper: along the leg, or along the tangent about the corner with F4 towards it. */
static Effort drive_miura(const World *world, size_t i, Drive *drive, const Place *place) {
    const Track *track = &world->journeys[i].track;
    const Profile *profile = world->house->people[i].profile;
    Vec2 way = place->along, velocity = world->velocity[i], centripetal = {0, 0};
    const RunSettings *run = &world->house->plan.run;
    if (place->here->corner >= 0 && place->next->corner >= 0) {
        const TrackCorner *corner = &track->corners[place->here->corner];
        Vec2 from = vec2_sub(world->centre[i], corner->centre);
        double radius = real_max(vec2_length(from), SMALLEST_RADIUS);
        way = vec2_scale(vec2_left(vec2_unit(from)), corner->turn > 0 ? 1 : -1);
        double speed = vec2_dot(velocity, way);
        if (run->centripetal == SWITCH_ON)
            centripetal = vec2_scale(vec2_unit(from), -profile->mass * speed * speed / radius);
    }
    double target = wanted_speed(world, i, drive, place).speed;
    double push = driving_force(profile, profile->push, profile->acceleration, target, 0, vec2_dot(velocity, way),
                                vec2_dot(world->force[i], way), 0);
    Vec2 across = vec2_left(way);
    double back = real_clamp(-drive->offset / ROUND_RETURN_TIME, -ROUND_RETURN_SPEED, ROUND_RETURN_SPEED);
    double sideways =
        real_clamp((back - vec2_dot(velocity, across)) / profile->speed_response, -ROUND_LATERAL, ROUND_LATERAL);
    if (run->lateral == SWITCH_OFF)
        sideways = 0;
    Vec2 force = vec2_along(vec2_scale(way, push), profile->mass * sideways, across);
    return (Effort){vec2_add(force, centripetal), 0};
}

Effort drive_person(const World *world, size_t i, Drive *drive) {
    const Profile *profile = world->house->people[i].profile;
    if (drive->retreats)
        step_back(&world->journeys[i].track, world_reference(world, i), drive);
    Place place = place_find(&world->journeys[i].track, profile, world_reference(world, i),
                             vec2_length(world->velocity[i]), drive);
    watch_progress(drive, world->clock.dt);
    return profile->driving == DRIVING_MIURA ? drive_miura(world, i, drive, &place)
                                             : drive_driver(world, i, drive, &place);
}

void drive_hold_sideways(const Profile *profile, double dt, Vec2 axis, Vec2 *velocity, double *turn) {
    const double gravity = 9.81; /* m/s2 */
    Vec2 across = vec2_left(axis);
    double c = profile->mass_centre;
    double inertia = profile->mass * profile->radius_of_gyration * profile->radius_of_gyration;
    double slip = vec2_dot(*velocity, across) - c * *turn;
    double most = profile->side_friction * profile->mass * gravity * dt;
    double impulse = real_clamp(-slip / (1 / profile->mass + c * c / inertia), -most, most);
    *velocity = vec2_along(*velocity, impulse / profile->mass, across);
    *turn -= c * impulse / inertia;
}
