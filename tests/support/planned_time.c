#include "planned_time.h"

#include "route/pace.h"
#include "house/track.h"
#include "plan/plan_geometry.h"

/* Returns the time of a motion over `length` m between two speeds, m/s; from rest to rest it accelerates and
 * decelerates. */
static double time_of(const Profile *profile, double length, double before, double after) {
    if (before + after > 0)
        return 2 * length / (before + after);
    double a = profile->acceleration, d = PACE_PLANNED * profile->deceleration;
    return sqrt(2 * length * (a + d) / (a * d));
}

/* Returns the part of the way from one place to another at which an exit's line is crossed. */
static double part_before(const Exit *exit, Vec2 from, Vec2 to) {
    Vec2 along = vec2_sub(exit->to, exit->from);
    double before = fabs(vec2_cross(along, vec2_sub(from, exit->from)));
    double after = fabs(vec2_cross(along, vec2_sub(to, exit->from)));
    return before + after > 0 ? before / (before + after) : 1;
}

double planned_time(const House *house, const Profile *profile, const Route *route) {
    const Exit *exit = &house->plan.exits[route->exit];
    Inhabitant person = {.profile = profile, .at = route->poses[0].at, .speed = profile->free_speed};
    Track track = {0};
    track_build_driver(&track, house, &person, route);
    double time = 0, speed = 0, result = 0;
    int rolled = 0; /* direction of the last motion that was not a turn on the spot */
    for (size_t i = 1; i < track.count; i++) {
        const TrackPoint *from = &track.points[i - 1], *to = &track.points[i];
        double length = to->s - from->s;
        if (to->direction == 0) {
            time += fabs(vec2_wrap_angle(to->heading - from->heading)) / profile->turn_rate;
            speed = 0;
            continue;
        }
        time += rolled != 0 && rolled != to->direction ? profile->reversing_time : 0;
        rolled = to->direction;
        bool rests = i + 1 < track.count && track.points[i + 1].direction != to->direction;
        double before = fmin(speed, from->speed);
        speed = rests ? 0 : fmin(to->speed, sqrt(before * before + 2 * profile->acceleration * length));
        double duration = length > 0 ? time_of(profile, length, before, speed) : 0;
        if (plan_geometry_leads_out(exit, from->at, to->at))
            result = time + part_before(exit, from->at, to->at) * duration;
        time += duration;
    }
    track_free(&track);
    return result > 0 ? result : time;
}
