#include "route/narrowest.h"

#include "base/real.h"
#include "route/smooth.h"

/* No point of the body moves farther than the axle does, plus the turn times the distance of the farthest corner. So on
 * a motion between two clearances a and b that moves no point by more than m, none is below (a + b - m) / 2. Where that
 * is not enough, the body is looked at NEAR apart, or TURNED. */

/* 1: the length of the longest cubic between two poses, for that of the line between them. */
static const double DETOUR = 1.05;
static const double NEAR = 0.02;    /* m */
static const double TURNED = 0.002; /* rad */
/* 1: of a part, so that rounding does not decide how many there are. */
static const double SAME = 1e-6;

double narrowest_on(const FreeSpace *space, const Rectangle *body, const Pose *poses, size_t count, Vec2 *at) {
    double least = ROUTE_CLEARANCE_REACH, radius = search_farthest(body);
    *at = poses[0].at;
    for (size_t i = 0; i < count; i++) {
        if (poses[i].clearance < least) {
            least = poses[i].clearance;
            *at = poses[i].at;
        }
    }
    for (size_t i = 1; i < count; i++) {
        const Pose *from = &poses[i - 1], *to = &poses[i];
        double turn = vec2_wrap_angle(to->heading - from->heading), length = vec2_distance(from->at, to->at);
        double moved = DETOUR * length + fabs(turn) * radius;
        if ((from->clearance + to->clearance - moved) / 2 >= least)
            continue;
        int parts = (int)ceil(real_max(length / NEAR, fabs(turn) / TURNED) - SAME);
        for (int k = 1; k < parts; k++) {
            double part = (double)k / parts;
            Vec2 place = to->direction ? smooth_between(from, to, to->direction, part) : from->at;
            double clearance =
                search_clearance(space, body, place, from->heading + part * turn, real_max(least, 0), NULL);
            if (clearance < least) {
                least = clearance;
                *at = place;
            }
        }
    }
    return least;
}
