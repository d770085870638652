#include "house/yield.h"

#include "route/pace.h"

/* All constants below are assumed. */

/* m: how far ahead people are seen. */
static const double SIGHT = 6.0;
/* m: distance between two people who pass, and to a wall; a smaller distance than the last value is touching rather
 * than passing. */
static const double PASSING_SPACE = 0.25, WALL_SPACE = 0.10, PASSING_LEAST = 0.02;
/* m: distance kept behind and before people. */
static const double STAND_OFF = 0.20;
/* m: a person standing this little to one side counts as straight ahead and is passed on the left, as in Japan. */
static const double STRAIGHT_AHEAD = 0.15;
/* m/s: not a speed, but a code: a person is so near that one of the two must back off. */
static const double BACK_OFF = -1;
/* m: of two people this level, neither is ahead. */
static const double LEVEL = 0.05;
/* 1: slope of a swerve relative to the path. */
static const double SWERVE = 0.22;
/* m: of way in which a chair that has swerved comes to lie along its path again. */
static const double SETTLING = 1;
/* 1: cosine of the largest angle to the path at which a person goes along it. */
static const double STRAIGHT = 0.7;
/* m/s: speed of passing closely, and the speed below which a person counts as standing. */
static const double SLOW_PASSING = 0.15, STANDING = 0.05;
/* s: when two people wait for each other for this long, one continues: of two chairs with the same exit the one that is
 * nearer to it, of others the first in the file, and a chair before a walker, who can step aside. */
static const double DEADLOCK = 2;

bool yield_sees(const World *world, size_t i, size_t j) {
    if (freespace_sees(&world->house->space, world->centre[i], world->centre[j]))
        return true; /* quick decision; places hidden on the grid are checked more closely */
    Vec2 to = vec2_sub(world->centre[j], world->centre[i]);
    double distance = vec2_length(to);
    return distance <= 0 || outline_ray(&world->house->outline, world->centre[i], vec2_scale(to, 1 / distance),
                                        distance, NULL) >= distance;
}

/* Returns how far a body extends from its centre along a direction. */
static double extent(const World *world, size_t i, Vec2 direction) {
    return body_extent(&world->body[i], world->axis[i], direction);
}

/* Returns the point of the track ahead that is nearest to a person. */
static const TrackPoint *nearest_point(const Track *track, size_t index, Vec2 at) {
    const TrackPoint *nearest = &track->points[index];
    double least = HUGE_VAL, end = nearest->s + SIGHT;
    for (size_t k = index; k < track->count && track->points[k].s < end; k += 2) {
        double distance = vec2_distance(track->points[k].at, at);
        if (distance < least) {
            least = distance;
            nearest = &track->points[k];
        }
    }
    return nearest;
}

/* A person seen from the path of person i, at the place where the path comes nearest. */
typedef struct Sight {
    const TrackPoint *here, *there;
    Vec2 way, left; /* unit, of the path there */
    double ahead;   /* m, between the two bodies along the path */
    double lateral; /* m, from the path to the other, positive on the left */
    double coming;  /* m/s, of the other along the path */
    double gap;     /* m, between the two bodies across the path */
    double abreast; /* m, between the two middles when both go straight and pass with space */
} Sight;

/* True if chair j faces those who come along the path. */
static bool faces(const World *world, size_t j, const Sight *sight) {
    return world_rides(world, j) && vec2_dot(world->axis[j], sight->way) < -STRAIGHT;
}

static Sight look_at(const World *world, size_t i, size_t j) {
    const Track *track = &world->journeys[i].track;
    const Drive *drive = &world->drive[i];
    const Profile *own = world->house->people[i].profile, *other = world->house->people[j].profile;
    Sight sight = {.here = &track->points[drive->index], .there = nearest_point(track, drive->index, world->centre[j])};
    sight.way = vec2_scale(vec2_heading(sight.there->heading), sight.there->direction < 0 ? -1 : 1);
    sight.left = vec2_left(sight.way);
    Vec2 to = vec2_sub(world->centre[j], world->centre[i]), back = vec2_scale(sight.way, -1);
    sight.ahead = real_min(sight.there->s - drive->s, vec2_dot(to, sight.way)) - extent(world, i, sight.way) -
                  extent(world, j, back);
    sight.lateral = vec2_dot(sight.left, vec2_sub(world->centre[j], sight.there->at));
    sight.coming = vec2_dot(world->velocity[j], sight.way);
    double apart = sight.lateral - drive->offset;
    Vec2 side = apart > 0 ? sight.left : vec2_scale(sight.left, -1);
    sight.gap = fabs(apart) - extent(world, i, side) - extent(world, j, vec2_scale(side, -1));
    bool straight = fabs(vec2_dot(world->axis[j], sight.way)) > STRAIGHT;
    sight.abreast = own->width / 2 + PASSING_SPACE + (straight ? other->width / 2 : extent(world, j, side));
    return sight;
}

/* Returns the offset from the path at which the other is passed: 0 when the path itself leaves space. The other person,
 * who sees the same situation from the other end, chooses the same side. */
static double pass_offset(const World *world, size_t i, const Sight *sight) {
    double half = world->house->people[i].profile->width / 2 + WALL_SPACE;
    double left_room = real_max(real_min(sight->here->room_left, sight->there->room_left) - half, 0);
    double right_room = real_max(real_min(sight->here->room_right, sight->there->room_right) - half, 0);
    if (fabs(sight->lateral) >= sight->abreast)
        return 0;
    double left = sight->lateral + sight->abreast, right = sight->abreast - sight->lateral;
    bool leftwards = sight->lateral < STRAIGHT_AHEAD;
    if (leftwards ? left > left_room && right <= right_room : right > right_room && left <= left_room)
        leftwards = !leftwards;
    return leftwards ? real_min(left, left_room) : -real_min(right, right_room);
}

/* True if chair i has precedence over chair j: of two with the same exit the one that has the shorter way left. */
static bool precedes(const World *world, size_t i, size_t j) {
    const Journey *a = &world->journeys[i], *b = &world->journeys[j];
    if (a->route.exit != b->route.exit || !a->track.count || !b->track.count)
        return i < j;
    double left_a = a->track.points[a->track.count - 1].s - world->drive[i].s;
    double left_b = b->track.points[b->track.count - 1].s - world->drive[j].s;
    return left_a < left_b || (left_a <= left_b && i < j);
}

/* True if person i lets j go first: of two chairs that go the same way side by side, too near to continue both, the one
 * ahead goes first. When each sees the other ahead on its own path, and both wait, the one with precedence goes. */
static bool lets_go_first(const World *world, size_t i, size_t j, const Sight *sight) {
    bool beside = world_rides(world, j) && world->phase[j] == PHASE_MOVING && sight->ahead < 0 &&
                  sight->gap <= PASSING_LEAST && vec2_dot(world->axis[j], sight->way) > STRAIGHT;
    Vec2 to = vec2_sub(world->centre[j], world->centre[i]);
    double ahead = vec2_dot(to, sight->way);
    double near = (world->house->people[i].profile->width + world->house->people[j].profile->width) / 2 + PASSING_SPACE;
    bool both_wait = world->drive[i].stalled > DEADLOCK && vec2_length(world->velocity[j]) < STANDING;
    return beside && !(both_wait && precedes(world, i, j)) && vec2_length(to) < near &&
           (ahead > LEVEL || (ahead > -LEVEL && j < i));
}

/* Returns the distance between two bodies along the line of their centres, m; negative if they may overlap. */
static double apart(const World *world, size_t i, size_t j) {
    Vec2 to = vec2_unit(vec2_sub(world->centre[j], world->centre[i]));
    return vec2_distance(world->centre[i], world->centre[j]) - extent(world, i, to) -
           extent(world, j, vec2_scale(to, -1));
}

/* True if a chair j that lets this one go first backs off to make room, or comes back from there. */
static bool makes_room(const World *world, size_t i, size_t j, const Sight *sight) {
    return faces(world, j, sight) && sight->gap <= PASSING_LEAST && sight->ahead >= -STAND_OFF &&
           world->phase[j] == PHASE_MOVING && world->drive[j].stalled < world->drive[j].room_by &&
           precedes(world, i, j);
}

/* Returns the way that a chair which comes towards this person needs to stop, m, of the way between the two. */
static double stopping_way(const World *world, size_t j, const Sight *sight) {
    double braking = PACE_PLANNED * world->house->people[j].profile->deceleration;
    return world_rides(world, j) && sight->coming < 0 ? sight->coming * sight->coming / (2 * braking) : 0;
}

static double speed_past(const World *world, size_t i, size_t j, const Sight *sight, double speed) {
    const Profile *profile = world->house->people[i].profile;
    if (lets_go_first(world, i, j, sight))
        return 0;
    double law = profile->steering_time > 0 ? 2 * sight->gap / profile->steering_time : HUGE_VAL;
    if (sight->gap > PASSING_LEAST || sight->ahead < -STAND_OFF)
        return real_min(speed, real_max(law, SLOW_PASSING));
    double free = sight->ahead - STAND_OFF - stopping_way(world, j, sight);
    double braking = sqrt(2 * PACE_PLANNED * profile->deceleration * real_max(0, free));
    bool both_wait = vec2_length(world->velocity[j]) < STANDING && world->drive[i].stalled > DEADLOCK &&
                     world->phase[j] == PHASE_MOVING;
    bool room = sight->ahead > PASSING_LEAST || apart(world, i, j) > STAND_OFF, chair = world_rides(world, j);
    if (both_wait && (!chair || (precedes(world, i, j) && room)))
        braking = SLOW_PASSING;
    else if (both_wait && chair && !room && !precedes(world, i, j))
        return BACK_OFF;
    double away = faces(world, j, sight) ? 0 : real_max(sight->coming, 0); /* who rolls back is not pressed */
    return real_min(speed, braking + away);
}

/* True if person i, who stands, is in the way of a chair j with precedence. */
static bool gives_way(const World *world, size_t i, size_t j) {
    if (!world_rides(world, j) || world->phase[j] != PHASE_MOVING || world->drive[i].stalled <= DEADLOCK)
        return false;
    return apart(world, i, j) < STAND_OFF && !precedes(world, i, j);
}

/* Notes a person straight behind. */
static void look_behind(const World *world, size_t i, size_t j, Vec2 travel, Drive *drive) {
    Vec2 to = vec2_sub(world->centre[j], world->centre[i]), left = vec2_left(travel), back = vec2_scale(travel, -1);
    double across = fabs(vec2_dot(to, left)), behind = vec2_dot(to, back);
    if (across < extent(world, i, left) + extent(world, j, left))
        drive->behind = real_min(drive->behind, behind - extent(world, i, back) - extent(world, j, travel));
}

/* Lowers the speed to what the other person allows, and updates the offset at which that person is passed. */
static void heed(const World *world, size_t i, size_t j, Vec2 travel, Drive *drive) {
    if (j == i || world->phase[j] == PHASE_OUT)
        return;
    Vec2 to = vec2_sub(world->centre[j], world->centre[i]);
    double ahead = vec2_dot(to, travel), passed = -extent(world, i, vec2_scale(travel, -1)) - extent(world, j, travel);
    if (vec2_dot(to, to) > SIGHT * SIGHT)
        return;
    if (ahead < 0)
        look_behind(world, i, j, travel, drive);
    if (ahead < passed)
        return;
    Sight sight = look_at(world, i, j);
    if (fabs(sight.lateral) > SIGHT / 2 || !yield_sees(world, i, j))
        return;
    bool meets = faces(world, j, &sight);
    if (ahead > 0 && sight.gap <= PASSING_LEAST && gives_way(world, i, j)) {
        drive->gives_way = true;
        drive->meets = drive->meets || meets;
    }
    /* A chair that faces this person and makes way by rolling back is passed, not followed. */
    double offset = sight.coming < STANDING || meets ? pass_offset(world, i, &sight) : 0;
    drive->around = fabs(offset) > fabs(drive->around) ? offset : drive->around;
    drive->heeded = speed_past(world, i, j, &sight, drive->heeded);
    if (makes_room(world, i, j, &sight)) {
        drive->heeded = real_min(drive->heeded, 0);
        if (!(drive->room_by > 0)) /* otherwise chairs that wait for one another in a circle would wait for ever */
            drive->stalled = 0;
    }
}

/* Considers all people in sight, in the order of the cells. */
static void look_around(const World *world, size_t i, Drive *drive, Vec2 travel) {
    const CellGrid *grid = &world->walkers.cells;
    CellRange range = cell_grid_around(grid, world->centre[i], SIGHT + WALKERS_SKIN);
    drive->heeded = drive->behind = HUGE_VAL;
    drive->around = 0;
    drive->gives_way = drive->meets = false;
    for (int y = range.y0; y <= range.y1; y++) {
        uint32_t end;
        for (uint32_t s = cell_grid_row(grid, &range, y, &end); s < end; s++)
            heed(world, i, grid->who[s], travel, drive);
    }
}

/* Returns the swerve, m to the left, that leads to the wanted offset: less where the chair is off its path to that side
 * already. */
static double wanted_swerve(const Drive *drive) {
    double swerve = drive->around - drive->axle;
    return drive->around > 0 ? real_max(swerve, 0) : drive->around < 0 ? real_min(swerve, 0) : 0;
}

double yield_speed(const World *world, size_t i, Drive *drive, Vec2 travel, double speed) {
    if ((world->clock.step + i) % world->decision_steps == 0)
        look_around(world, i, drive, travel);
    /* A swerve needs distance, not time: a standing person does not move to one side. */
    const Profile *profile = world->house->people[i].profile;
    double moved = vec2_length(world->velocity[i]) * world->clock.dt, before = drive->aside;
    /* The front edge swerves no farther than is wanted. */
    double missing = wanted_swerve(drive) - before;
    drive->way_round = fabs(drive->around - drive->offset) / SWERVE + SETTLING;
    double slope = fabs(missing) / real_max(profile->length - profile->axle, 0.1);
    double change = real_min(SWERVE, slope) * moved;
    drive->aside += real_clamp(missing, -change, change);
    drive->swerve = moved > 0 ? (drive->aside - before) / moved : 0;
    return drive->gives_way ? BACK_OFF : real_min(speed, drive->heeded);
}
