#include "house/track.h"

#include "base/real.h"
#include "plan/plan_geometry.h"
#include "route/doorway.h"
#include "route/foresight.h"
#include "route/pace.h"
#include "space/passage.h"

/* points to either side over which the curvature of a path is averaged: about 0.1 m */
enum { CURVATURE_SPAN = 2 };
/* m: shorter steps are not rolled. */
static const double TOO_SHORT = 0.005;

static TrackPoint *add_point(Track *track, size_t *capacity, TrackPoint point) {
    track->points = memory_reserve(track->points, capacity, track->count + 1, sizeof *track->points);
    if (track->count) {
        const TrackPoint *before = &track->points[track->count - 1];
        point.s = before->s + vec2_distance(before->at, point.at);
    }
    track->points[track->count] = point;
    return &track->points[track->count++];
}

/* Limits the speed from the end to the start: v^2 - v_c^2 = 2 a_d L. A change of direction ends at rest. */
static void decelerate(Track *track, const Profile *profile) {
    for (size_t i = track->count; i-- > 1;) {
        TrackPoint *here = &track->points[i - 1];
        const TrackPoint *next = &track->points[i];
        bool rest = i + 1 < track->count && track->points[i + 1].direction != next->direction;
        double end = rest || next->direction == 0 ? 0 : next->speed;
        double braking = profile->deceleration;
        if (profile->driving == DRIVING_DRIVER)
            braking =
                fmin(pace_braking(profile, here->clearance), pace_in_bend(pace_turning(profile), here->curvature));
        double reach = sqrt(end * end + 2 * braking * (next->s - here->s));
        if (here->direction != 0 || next->direction != 0)
            here->speed = fmin(here->speed, fmax(reach, next->direction == 0 ? 0 : 1e-3));
    }
}

/* Measures the whole track, and where it last crosses the exit. */
static void mark_exit(Track *track, const Exit *exit) {
    track->length = track->exit_s = track->points[track->count - 1].s;
    for (size_t i = 0; i + 1 < track->count; i++)
        if (plan_geometry_leads_out(exit, track->points[i].at, track->points[i + 1].at))
            track->exit_s = track->points[i].s;
}

static void mark_doors(Track *track, const Plan *plan, const Profile *profile) {
    int *doors = memory_zeroed(track->count, sizeof *doors), next_door = -1;
    DoorwayPlace *places = memory_zeroed(track->count, sizeof *places);
    for (size_t i = 0; i < track->count; i++)
        places[i] = (DoorwayPlace){track->points[i].at, vec2_heading(track->points[i].heading)};
    doorway_mark(doors, places, track->count, plan, profile);
    for (size_t i = track->count; i-- > 0;) {
        track->points[i].door = doors[i];
        next_door = doors[i] >= 0 ? (int)i : next_door;
        track->points[i].next_door = next_door;
    }
    memory_free(doors);
    memory_free(places);
}

/* Measures width and room at every point, across the body's middle. */
static void measure(Track *track, const House *house, double middle) {
    for (size_t i = 0; i < track->count; i++) {
        TrackPoint *point = &track->points[i];
        Vec2 along = vec2_heading(point->heading);
        Passage passage = passage_at(&house->outline, vec2_along(point->at, middle, along), along);
        point->room_left = passage.left;
        point->room_right = passage.right;
        point->width = passage_width(passage);
    }
}

/* The driver -------------------------------------------------------------------------------------------------- */

/* Finds the points to either side of i on the same part, at most CURVATURE_SPAN away; returns their distance, m. */
static double span(const Track *track, size_t i, size_t *a, size_t *b) {
    const TrackPoint *points = track->points;
    *a = *b = i;
    for (int k = 0; k < CURVATURE_SPAN; k++) {
        if (*a > 0 && points[*a].direction == points[i].direction && points[*a - 1].direction == points[i].direction)
            --*a;
        if (*b + 1 < track->count && points[*b + 1].direction == points[i].direction)
            ++*b;
    }
    return points[*b].s - points[*a].s;
}

static void bend(Track *track) {
    size_t a, b;
    for (size_t i = 0; i < track->count; i++) {
        double length = span(track, i, &a, &b);
        double turn = vec2_wrap_angle(track->points[b].heading - track->points[a].heading);
        bool rolls = track->points[i].direction != 0 && length > 0;
        track->points[i].curvature = rolls ? turn / length : 0;
    }
    for (size_t i = 0; i < track->count; i++) {
        double length = span(track, i, &a, &b);
        double change = track->points[b].curvature - track->points[a].curvature;
        track->points[i].bending = track->points[i].direction != 0 && length > 0 ? change / length : 0;
    }
}

/* Returns the greatest curvature at a point and of the steps to and from it: over the longer way that a point's own
 * curvature is taken from, a short bend looks wider than it is, and would be taken faster than the chair can turn. */
static double sharpest(const Track *track, size_t i) {
    double most = fabs(track->points[i].curvature);
    for (size_t k = i > 0 ? i : 1; k <= i + 1 && k < track->count; k++) {
        const TrackPoint *from = &track->points[k - 1], *to = &track->points[k];
        double length = to->s - from->s;
        if (to->direction != 0 && length >= TOO_SHORT)
            most = fmax(most, fabs(vec2_wrap_angle(to->heading - from->heading)) / length);
    }
    return most;
}

/* Returns the change of the curvature at a point from the step to it to the one from it, rad/m2. */
static double own_bending(const Track *track, size_t i) {
    if (i == 0 || i + 1 >= track->count)
        return 0;
    const TrackPoint *before = &track->points[i - 1], *here = before + 1, *next = here + 1;
    double first = here->s - before->s, second = next->s - here->s;
    if (here->direction == 0 || next->direction != here->direction || fmin(first, second) < TOO_SHORT)
        return 0;
    double slope_before = vec2_wrap_angle(here->heading - before->heading) / first;
    double slope = vec2_wrap_angle(next->heading - here->heading) / second;
    return 2 * (slope - slope_before) / (first + second);
}

/* The step from a point to the next one. */
typedef struct Step {
    const House *house;
    const TrackPoint *point;
    double middle; /* m, of the body, ahead of the axle */
} Step;

static double width_in_step(const void *context, double part) {
    const Step *step = context;
    const TrackPoint *point = step->point, *next = point + 1;
    Vec2 along = vec2_heading(point->heading + part * vec2_wrap_angle(next->heading - point->heading));
    Vec2 at = vec2_along(point->at, part, vec2_sub(next->at, point->at));
    return passage_width(passage_at(&step->house->outline, vec2_along(at, step->middle, along), along));
}

/* Limits the speed at every point by the passage that the driver sees, and lowers its width to the least of that. */
static void look_ahead_and_behind(Track *track, const House *house, const Inhabitant *person, double middle) {
    enum { NUMBERS = 5 };
    const Profile *profile = person->profile;
    size_t count = track->count;
    double turning = pace_turning(profile);
    double *left = memory_zeroed(NUMBERS * count, sizeof *left), *right = left + count, *heading = right + count,
           *step = heading + count, *edge = step + count;
    for (size_t i = 0; i < count; i++) {
        const TrackPoint *point = &track->points[i];
        left[i] = point->room_left;
        right[i] = point->room_right;
        heading[i] = point->heading;
        step[i] = i + 1 < count ? point[1].s - point->s : 0;
        if (step[i] > 0)
            edge[i] = foresight_edge(point->width, point[1].width, width_in_step, &(Step){house, point, middle});
    }
    Foresight foresight = {left, right, heading, step, edge, count};
    for (size_t i = 0; i < count; i++) {
        TrackPoint *point = &track->points[i];
        double in_bend = pace_in_bend(turning, point->curvature);
        point->width = foresight_width(&foresight, i);
        point->speed = foresight_speed(&foresight, i, profile, person->speed,
                                       fmin(pace_starting(profile, point->clearance), in_bend),
                                       fmin(pace_braking(profile, point->clearance), in_bend));
    }
    memory_free(left);
}

static double driver_speed(const Profile *profile, const Agility *agility, const Track *track, size_t i) {
    const TrackPoint *point = &track->points[i];
    double own = own_bending(track, i) * (PACE_MOMENT / PACE_OWN_MOMENT);
    double bending = fmax(fabs(point->bending), fabs(own));
    return pace_at(profile, agility, point->speed, point->clearance, sharpest(track, i), bending, point->direction);
}

/* Returns the clearance of the part of the body ahead of the axle on its left (`side` 1) or its right (-1), m, up to
 * the personal space's reach. */
static double side_clearance(const House *house, const Profile *profile, const TrackPoint *point, int side) {
    double ahead = profile->length - profile->axle, quarter = profile->width / 4;
    Vec2 axis = vec2_heading(point->heading);
    Vec2 middle = vec2_along(vec2_along(point->at, ahead / 2, axis), side * quarter, vec2_left(axis));
    return freespace_clearance(&house->space, middle, axis, ahead / 2, quarter, profile->space_reach, NULL);
}

static void measure_sides(Track *track, const House *house, const Profile *profile) {
    for (size_t i = 0; i < track->count; i++) {
        track->points[i].left = side_clearance(house, profile, &track->points[i], 1);
        track->points[i].right = side_clearance(house, profile, &track->points[i], -1);
    }
}

static void look_for_necks(Track *track) {
    for (size_t i = 0; i < track->count; i++) {
        TrackPoint *point = &track->points[i];
        point->narrow = point->clearance;
        for (size_t k = i + 1; k < track->count && track->points[k].s <= point->s + TRACK_FORESIGHT; k++)
            point->narrow = fmin(point->narrow, track->points[k].clearance);
    }
}

/* True if a part of the path begins at pose i - 1 or ends at pose i, which is not the last. */
static bool is_at_joint(const Route *route, size_t i) {
    int direction = route->poses[i].direction;
    return i == 1 || route->poses[i - 1].direction != direction || route->poses[i + 1].direction != direction;
}

/* Takes over the poses of a route. A step that is too short to be rolled is turned on the spot where a part of the path
 * begins or ends, and left out elsewhere; one that bends more sharply than the chair can roll is turned on the spot. */
static void take_poses(Track *track, const Profile *profile, const Route *route) {
    size_t capacity = 0;
    for (size_t i = 0; i < route->count; i++) {
        const Pose *pose = &route->poses[i];
        int direction = pose->direction;
        if (i > 0 && i + 1 < route->count && direction != 0) {
            TrackPoint *last = &track->points[track->count - 1];
            double length = vec2_distance(last->at, pose->at);
            double turn = fabs(vec2_wrap_angle(pose->heading - last->heading));
            bool sharp = turn > length * pace_sharpest(profile);
            if (length < TOO_SHORT && !sharp && !is_at_joint(route, i)) {
                last->clearance = fmin(last->clearance, pose->clearance);
                continue;
            }
            if (length < TOO_SHORT || sharp)
                direction = 0;
        }
        add_point(track, &capacity,
                  (TrackPoint){.at = pose->at,
                               .heading = pose->heading,
                               .direction = direction,
                               .clearance = pose->clearance,
                               .corner = -1,
                               .door = -1});
    }
    track->points[0].direction = track->points[track->count > 1].direction;
}

void track_build_driver(Track *track, const House *house, const Inhabitant *person, const Route *route) {
    const Profile *profile = person->profile;
    take_poses(track, profile, route);
    double middle = profile->length / 2 - profile->axle;
    measure(track, house, middle);
    bend(track);
    look_ahead_and_behind(track, house, person, middle);
    Agility agility = pace_agility(profile);
    for (size_t i = 0; i < track->count; i++)
        track->points[i].speed = driver_speed(profile, &agility, track, i);
    look_for_necks(track);
    if (house_ring(house) == RING_STEERS)
        measure_sides(track, house, profile);
    decelerate(track, profile);
    mark_doors(track, &house->plan, person->profile);
    mark_exit(track, &house->plan.exits[route->exit]);
}

/* The paper's round body --------------------------------------------------------------------------------------- */

/* Lowers each width to the least within FORESIGHT_REACH. */
static void look_ahead(Track *track) {
    double *width = memory_zeroed(track->count, sizeof *width);
    for (size_t i = 0, first = 0; i < track->count; i++) {
        double s = track->points[i].s;
        while (track->points[first].s < s - FORESIGHT_REACH)
            first++;
        width[i] = HUGE_VAL;
        for (size_t k = first; k < track->count && track->points[k].s <= s + FORESIGHT_REACH; k++)
            width[i] = fmin(width[i], track->points[k].width);
    }
    for (size_t i = 0; i < track->count; i++)
        track->points[i].width = width[i];
    memory_free(width);
}

/* m: distance between points. */
static const double SPACING = 0.05;
/* m: the last leg ends this far beyond the exit's line. */
static const double BEYOND_EXIT = 0.1;
/* rad: smaller turns of the shortest path are not corners of a passage. */
static const double SMALLEST_CORNER = 0.15;
/* m: nearer bends of the shortest path belong to one corner. */
static const double SAME_CORNER = 0.25;
/* m: bends about nearer centres do, too: the two edges of a wall's end. */
static const double SAME_CENTRE = 0.2;
/* m: least width of a corner's arc, beyond the body, when the middle of the passage is not free. */
static const double LEAST_SPARE = 0.02;

/* A corner of the path: the start and the end have no radius and no side. */
typedef struct Turning {
    Vec2 centre;
    double side;    /* +1: the centre is on the left of the path, -1: on the right */
    double in, out; /* m, radii */
    double widths[2];
    Vec2 leg; /* unit direction of the leg that follows */
} Turning;

/* Returns the obstacle's convex corner about which the shortest path turns at `at`: of the nearby corners the one that
 * points most against `inwards`, the direction to the inside half-way through the turn; of the two edges of a wall's
 * end this is the one about which most of the turn is made. */
static Vec2 turning_centre(const House *house, Vec2 at, Vec2 inwards, double radius) {
    enum { MOST = 256 };
    int items[MOST];
    size_t found = broadphase_query(house->outline.broadphase, box_around(at, 2 * radius), items, MOST);
    Vec2 best = vec2_along(at, radius, inwards);
    double most = 0;
    for (size_t i = 0; i < found && i < MOST; i++) {
        size_t item = (size_t)items[i];
        if (item < house->outline.face_count)
            continue;
        const Corner *corner = &house->outline.corners[item - house->outline.face_count];
        Vec2 to = vec2_sub(corner->at, at), outwards = vec2_unit(vec2_sub(corner->in, corner->out));
        double against = -vec2_dot(outwards, inwards);
        bool at_hand = vec2_dot(to, inwards) > 0 && vec2_length(to) < radius + SAME_CORNER;
        if (outline_planned(corner->presence) && at_hand && against > most) {
            most = against;
            best = corner->at;
        }
    }
    return best;
}

/* Returns the end of the last leg: a step beyond the middle of the exit, or the end of the shortest path when that is
 * not free. */
static Vec2 way_out(const House *house, const Inhabitant *person, const Route *route) {
    const Exit *exit = &house->plan.exits[route->exit];
    const Pose *end = &route->poses[route->count - 1];
    Vec2 middle = vec2_scale(vec2_add(exit->from, exit->to), 0.5);
    Vec2 across = vec2_left(vec2_unit(vec2_sub(exit->to, exit->from)));
    if (vec2_dot(across, vec2_heading(end->heading)) < 0)
        across = vec2_scale(across, -1);
    Vec2 beyond = vec2_along(middle, BEYOND_EXIT, across);
    double radius = person->profile->width / 2;
    bool free =
        freespace_distance(&house->space, middle) >= radius && freespace_distance(&house->space, beyond) >= radius;
    return free ? beyond : end->at;
}

/* Returns the turning of the shortest path from pose `first` to pose `last`, by `total` rad. */
static Turning turning_of(const House *house, const Inhabitant *person, const Route *route, size_t first, size_t last,
                          double total) {
    double side = total > 0 ? 1 : -1;
    Vec2 inwards = vec2_scale(vec2_left(vec2_heading(route->poses[first].heading + total / 2)), side);
    Vec2 middle = route->poses[(first + last) / 2].at;
    return (Turning){.centre = turning_centre(house, middle, inwards, person->profile->width / 2), .side = side};
}

/* Finds the corners of the shortest path: runs of bends to the same side. */
static size_t find_turnings(const House *house, const Inhabitant *person, const Route *route, Turning *turnings) {
    size_t count = 0;
    size_t begun = 0;  /* first pose of the last turning */
    double turned = 0; /* rad, its angle */
    turnings[count++] = (Turning){.centre = route->poses[0].at};
    for (size_t i = 1; i + 1 < route->count;) {
        double turn = vec2_wrap_angle(route->poses[i + 1].heading - route->poses[i].heading);
        if (fabs(turn) < 1e-6) {
            i++;
            continue;
        }
        size_t end = i + 1;
        double total = turn, straight = 0;
        for (size_t k = i + 1; k + 1 < route->count && straight < SAME_CORNER; k++) {
            double more = vec2_wrap_angle(route->poses[k + 1].heading - route->poses[k].heading);
            straight += vec2_distance(route->poses[k].at, route->poses[k + 1].at);
            if (more * turn < 0)
                break;
            if (fabs(more) > 1e-6) {
                total += more;
                straight = 0;
                end = k + 1;
            }
        }
        if (fabs(total) >= SMALLEST_CORNER) {
            Turning turning = turning_of(house, person, route, i, end, total);
            Turning *last = &turnings[count - 1];
            if (last->side == turning.side && vec2_distance(last->centre, turning.centre) <= SAME_CENTRE) {
                *last = turning_of(house, person, route, begun, end, turned + total);
                turned += total;
            } else {
                turnings[count++] = turning;
                begun = i;
                turned = total;
            }
        }
        i = end;
    }
    turnings[count++] = (Turning){.centre = way_out(house, person, route)};
    return count;
}

/* Returns the common tangent of two turnings, from which the centres have the signed distances side * radius. */
static Vec2 tangent(const Turning *from, const Turning *to) {
    Vec2 between = vec2_sub(to->centre, from->centre);
    double sine = (to->side * to->in - from->side * from->out) / fmax(vec2_length(between), 1e-9);
    double angle = real_atan2(between.y, between.x) - real_asin(fmax(-1, fmin(1, sine)));
    return vec2_heading(angle);
}

/* True unless a turning is inside the other's circle, or the circles meet. */
static bool has_tangent(const Turning *from, const Turning *to) {
    return fabs(to->side * to->in - from->side * from->out) < vec2_distance(from->centre, to->centre);
}

static Vec2 leg_begin(const Turning *turning, Vec2 leg) {
    return vec2_along(turning->centre, -turning->side * turning->out, vec2_left(leg));
}

static Vec2 leg_end(const Turning *turning, Vec2 leg) {
    return vec2_along(turning->centre, -turning->side * turning->in, vec2_left(leg));
}

/* Finds W1 and W2 of every corner, and from them the radii, step by step towards the middle of the passage: the legs
 * turn with the radii, so both are iterated together. */
static void settle(const House *house, const Inhabitant *person, Turning *turnings, size_t count, const double *share) {
    double least = person->profile->width / 2 + LEAST_SPARE;
    for (int round = 0; round < 4; round++) {
        for (size_t i = 0; i + 1 < count; i++)
            turnings[i].leg = tangent(&turnings[i], &turnings[i + 1]);
        for (size_t i = 1; i + 1 < count; i++) {
            Turning *turning = &turnings[i];
            for (int after = 0; after < 2; after++) {
                Vec2 across = vec2_scale(vec2_left(turnings[after ? i : i - 1].leg), -turning->side);
                double width = passage_across(&house->outline, turning->centre, across);
                double radius = least + share[i] * fmax(width / 2 - least, 0);
                turning->widths[after] = width;
                *(after ? &turning->out : &turning->in) = radius;
            }
        }
    }
}

/* Returns the least distance of a leg from any obstacle. */
static double leg_freedom(const House *house, const Turning *from, const Turning *to) {
    Vec2 begin = leg_begin(from, from->leg), end = leg_end(to, from->leg);
    double length = vec2_distance(begin, end), least = HUGE_VAL;
    for (double s = 0; s <= length; s += SPACING)
        least = fmin(least, freespace_distance(&house->space, vec2_along(begin, s, from->leg)));
    return least;
}

/* Returns the least distance of the arc about a turning. */
static double arc_freedom(const House *house, const Turning *turning, Vec2 before, Vec2 after) {
    double turn = vec2_angle_between(before, after), least = HUGE_VAL;
    double heading = real_atan2(before.y, before.x);
    const int pieces = 12; /* 8 degrees each in a right-angle corner */
    for (int i = 0; i <= pieces && turn * turning->side > 0; i++) {
        double part = (double)i / pieces, radius = turning->in + part * (turning->out - turning->in);
        Vec2 out = vec2_scale(vec2_left(vec2_heading(heading + part * turn)), -turning->side);
        least = fmin(least, freespace_distance(&house->space, vec2_along(turning->centre, radius, out)));
    }
    return least;
}

static void lay_out(const House *house, const Inhabitant *person, Turning *turnings, size_t count) {
    enum { NARROWINGS = 12 };
    double *share = memory_zeroed(count, sizeof *share), radius = person->profile->width / 2;
    for (size_t i = 0; i < count; i++)
        share[i] = 1;
    for (int round = 0; round < NARROWINGS; round++) {
        bool free = true;
        settle(house, person, turnings, count, share);
        for (size_t i = 0; i + 1 < count; i++) {
            bool overlap =
                vec2_dot(vec2_sub(leg_end(&turnings[i + 1], turnings[i].leg), leg_begin(&turnings[i], turnings[i].leg)),
                         turnings[i].leg) < 0;
            if (overlap || !has_tangent(&turnings[i], &turnings[i + 1]) ||
                leg_freedom(house, &turnings[i], &turnings[i + 1]) < radius) {
                share[i] *= 0.75;
                share[i + 1] *= 0.75;
                free = false;
            }
            if (i > 0 && arc_freedom(house, &turnings[i], turnings[i - 1].leg, turnings[i].leg) < radius) {
                share[i] *= 0.75;
                free = false;
            }
        }
        if (free)
            break;
    }
    memory_free(share);
}

static void add_straight(Track *track, size_t *capacity, Vec2 from, Vec2 to) {
    Vec2 along = vec2_sub(to, from);
    double length = vec2_length(along), heading = real_atan2(along.y, along.x);
    size_t pieces = (size_t)(length / SPACING) + 1;
    for (size_t i = 0; i <= pieces; i++)
        add_point(track, capacity,
                  (TrackPoint){.at = vec2_along(from, (double)i / (double)pieces, along),
                               .heading = heading,
                               .direction = 1,
                               .corner = -1});
}

static void add_corner(Track *track, size_t *capacity, const Turning *turning, Vec2 before, Vec2 after) {
    double turn = vec2_angle_between(before, after);
    double heading = real_atan2(before.y, before.x);
    TrackCorner *corner = &track->corners[track->corner_count];
    *corner = (TrackCorner){.centre = turning->centre,
                            .before = turning->widths[0],
                            .after = turning->widths[1],
                            .turn = turn,
                            .radius_in = turning->in,
                            .radius_out = turning->out};
    if (turn * turning->side > 0) {
        double length = fabs(turn) * (turning->in + turning->out) / 2;
        size_t pieces = (size_t)(length / SPACING) + 2;
        for (size_t i = 0; i <= pieces; i++) {
            double part = (double)i / (double)pieces, angle = heading + part * turn;
            double radius = turning->in + part * (turning->out - turning->in);
            Vec2 out = vec2_scale(vec2_left(vec2_heading(angle)), -turning->side);
            TrackPoint *point = add_point(track, capacity,
                                          (TrackPoint){.at = vec2_along(turning->centre, radius, out),
                                                       .heading = angle,
                                                       .curvature = turn / length,
                                                       .direction = 1,
                                                       .corner = (int)track->corner_count});
            if (i == 0)
                corner->from = point->s;
            corner->to = point->s;
        }
    }
    track->corner_count++;
}

void track_build_miura(Track *track, const House *house, const Inhabitant *person, const Route *route) {
    size_t capacity = 0;
    Turning *turnings = memory_zeroed(route->count + 1, sizeof *turnings);
    size_t count = find_turnings(house, person, route, turnings);
    lay_out(house, person, turnings, count);
    track->corners = memory_zeroed(count, sizeof *track->corners);
    for (size_t i = 0; i + 1 < count; i++) {
        add_straight(track, &capacity, leg_begin(&turnings[i], turnings[i].leg),
                     leg_end(&turnings[i + 1], turnings[i].leg));
        if (i + 2 < count)
            add_corner(track, &capacity, &turnings[i + 1], turnings[i].leg, turnings[i + 1].leg);
    }
    memory_free(turnings);
    measure(track, house, 0);
    look_ahead(track);
    for (size_t i = 0; i < track->count; i++) {
        TrackPoint *point = &track->points[i];
        point->speed = pace_in_passage(person->profile, person->speed, point->width);
        if (point->corner >= 0) /* the floor of the paper; never faster than the legs */
            point->speed = fmin(person->profile->minimum_speed, point->speed);
    }
    decelerate(track, person->profile);
    mark_doors(track, &house->plan, person->profile);
    mark_exit(track, &house->plan.exits[route->exit]);
}

double track_time(const Track *track, const Plan *plan, const Profile *profile) {
    double time = 0;
    for (size_t i = 1; i < track->count && track->points[i - 1].s < track->exit_s; i++) {
        const TrackPoint *before = &track->points[i - 1], *here = &track->points[i];
        double way = here->s - before->s, turn = fabs(vec2_wrap_angle(here->heading - before->heading));
        time += way > 0 ? 2 * way / fmax(before->speed + here->speed, profile->creep) : turn / profile->turn_rate;
        if (before->direction * here->direction < 0)
            time += profile->reversing_time;
        if (here->door >= 0)
            time += plan->doors[here->door].opening_time;
    }
    return time;
}

void track_free(Track *track) {
    memory_free(track->points);
    memory_free(track->corners);
    *track = (Track){0};
}
