#include "house/place.h"

#include "base/real.h"

/* The track between two points: a step begins at point i; u from 0 to 1 is the part of its length l that is done.
 * The heading is the cubic polynomial with the headings and their slopes k at both ends,
 *
 *     h(u) = h0 + (3 u^2 - 2 u^3) (h1 - h0) + l ((u - 2 u^2 + u^3) k0 + (u^3 - u^2) k1),
 *
 * so that the turn rate that is fed forward, k v, brings the chair to the heading of every point. The slope at a point
 * is that of the parabola through it and both its neighbours, at most STEEPEST times that of either step, so that no
 * heading is beyond those of both ends (Fritsch and Carlson 1980); a part of the path ends with the slope of its last
 * step. Between the points the path is the cubic that the plan has been tried with (smooth_between): of its line it is
 *
 *     y(u) = l ((u - 2 u^2 + u^3) a0 + (u^3 - u^2) a1)
 *
 * to the left, with the angles a of the direction of travel at both ends from that line, taken as small. The speed
 * changes evenly by time, v^2 = v0^2 + u (v1^2 - v0^2), and a change of direction ends at rest. */

/* 1: with at most this slope at its ends a cubic rises or falls all the way. */
static const double STEEPEST = 3;

int place_direction(const Track *track, size_t index) {
    return track->points[index + 1 < track->count ? index + 1 : index].direction;
}

static bool changes_after(const Track *track, size_t index) {
    return index + 2 < track->count && track->points[index + 2].direction != track->points[index + 1].direction;
}

/* The length of a step, m, and the mean slope of the heading in it, rad/m. */
typedef struct Step {
    double length, slope;
} Step;

static Step step_from(const TrackPoint *here) {
    double length = here[1].s - here->s;
    return (Step){length, length > 0 ? vec2_wrap_angle(here[1].heading - here->heading) / length : 0};
}

/* Returns the slope of the heading between two steps of one part, rad/m. */
static double slope_between(Step first, Step second) {
    double length = first.length + second.length;
    if (first.slope * second.slope <= 0 || !(length > 0))
        return 0;
    double most = STEEPEST * real_min(fabs(first.slope), fabs(second.slope));
    return real_clamp((first.slope * second.length + second.slope * first.length) / length, -most, most);
}

static void find_heading(const Track *track, size_t i, double part, Place *place) {
    const TrackPoint *here = place->here, *next = place->next;
    Step step = next == here ? (Step){0, 0} : step_from(here);
    double turn = step.slope * step.length, u = part, v = 1 - part;
    double begin = step.slope, end = step.slope;
    if (i > 0 && here->direction == next->direction)
        begin = slope_between(step_from(here - 1), step);
    if (i + 2 < track->count && here[2].direction == next->direction)
        end = slope_between(step, step_from(next));
    place->heading = here->heading + (3 - 2 * u) * u * u * turn + step.length * (u * v * v * begin - u * u * v * end);
    place->curvature = 6 * u * v * step.slope + v * (1 - 3 * u) * begin + u * (3 * u - 2) * end;
    place->bending = (6 * (1 - 2 * u) * step.slope + (6 * u - 4) * begin + (6 * u - 2) * end);
    place->bending = step.length > 0 ? place->bending / step.length : 0;
}

/* Returns how far the path is to the left of the line between the two points, m. */
static double bulge(const Place *place, int direction, double length, double part) {
    Vec2 out = vec2_scale(vec2_heading(place->here->heading), direction);
    Vec2 in = vec2_scale(vec2_heading(place->next->heading), direction);
    double a = vec2_cross(place->along, out), b = vec2_cross(place->along, in), u = part, v = 1 - part;
    return length * u * v * (v * a - u * b);
}

static void find_averages(double part, Place *place) {
    const TrackPoint *here = place->here, *next = place->next;
    double share = here->direction == next->direction ? part : 1; /* another part bends otherwise */
    place->even = here->curvature + share * (next->curvature - here->curvature);
    place->even_bending = here->bending + share * (next->bending - here->bending);
}

static void find_speed(const Track *track, size_t i, double part, Place *place) {
    double begin = place->here->speed, length = place->next->s - place->here->s;
    double end = changes_after(track, i) ? 0 : place->next->speed;
    place->speed = sqrt(real_max(begin * begin + part * (end * end - begin * begin), 0));
    place->hurry = length > 0 ? (end * end - begin * begin) / (2 * length) : 0;
}

/* Returns the direction in which a person has rolled to a point, before any turns on the spot; 0: not yet. */
static int rolled_to(const Track *track, size_t index) {
    while (index > 0 && track->points[index].direction == 0)
        index--;
    return index > 0 ? track->points[index].direction : 0;
}

void place_pass(const Track *track, const Profile *profile, Drive *drive) {
    int before = place_direction(track, drive->index);
    drive->index++;
    int after = place_direction(track, drive->index);
    if (before != after) {
        drive->pause = rolled_to(track, drive->index) * after < 0 ? profile->reversing_time : 0;
        drive->best_turn = HUGE_VAL;
        drive->stalled = 0;
    }
}

/* Returns how far before a change of direction it counts as reached, m: whose speed falls off from there on by its
 * response comes to rest on it. */
static double arrival(const Profile *profile, double speed) {
    return speed > PLACE_SLOWEST ? speed * profile->speed_response : PLACE_ARRIVED;
}

Place place_find(const Track *track, const Profile *profile, Vec2 at, double speed, Drive *drive) {
    Place place;
    for (;;) {
        place.here = &track->points[drive->index];
        place.next = drive->index + 1 < track->count ? place.here + 1 : place.here;
        Vec2 way = vec2_sub(place.next->at, place.here->at);
        double length = vec2_length(way);
        bool last = place.next == place.here;
        int direction = place_direction(track, drive->index);
        place.along = length > 0 ? vec2_scale(way, 1 / length)
                                 : vec2_scale(vec2_heading(place.here->heading), direction < 0 ? -1 : 1);
        double done = vec2_dot(vec2_sub(at, place.here->at), place.along);
        bool cusp = changes_after(track, drive->index);
        if (!last && direction != 0 && done >= length - (cusp ? arrival(profile, speed) : 0)) {
            place_pass(track, profile, drive);
            continue;
        }
        double part = length > 0 ? real_clamp(done / length, 0, 1) : 0;
        find_heading(track, drive->index, part, &place);
        find_averages(part, &place);
        if (done < 0) /* before the beginning of a part */
            place.curvature = place.bending = place.even = place.even_bending = 0;
        find_speed(track, drive->index, part, &place);
        double behind = drive->retreats && drive->index == 0 ? place.here->s - drive->retreat_to : 0;
        drive->s = place.here->s + real_max(done, -behind);
        drive->offset = vec2_cross(place.along, vec2_sub(at, place.here->at)) - bulge(&place, direction, length, part);
        return place;
    }
}
