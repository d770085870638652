#include "route/narrowest.h"

#include "base/real.h"
#include "route/smooth.h"

/* No point of the body moves farther than the axle does, plus the turn times the distance of the farthest corner. So on
 * a motion between two clearances a and b that moves no point by more than m, none is below (a + b - m) / 2. Where that
 * is not enough, the motion is halved, down to FINEST; where the clearance stays the same, as along a wall, to NEAR. */

/* 1: the length of the longest cubic between two poses, for that of the line between them. */
static const double DETOUR = 1.05;
static const double NEAR = 0.02;     /* m */
static const double LEVEL = 1e-6;    /* m: clearances that differ by less are the same */
static const double FINEST = 0.0002; /* m */

/* A part of the motion from a pose to the next one, between two shares of it, and the clearances there. */
typedef struct Stretch {
    double begin, end;     /* 1 */
    double before, behind; /* m */
    double moved;          /* m, by which no point of the body moves more */
} Stretch;

typedef struct Look {
    const FreeSpace *space;
    const Rectangle *body;
    const Pose *from, *to;
    double turn;  /* rad */
    double least; /* m */
    Vec2 at;      /* m */
} Look;

static void look_between(Look *look, Stretch all) {
    if ((all.before + all.behind - all.moved) / 2 >= look->least || all.moved < FINEST)
        return;
    double part = (all.begin + all.end) / 2, heading = look->from->heading + part * look->turn;
    Vec2 place = look->to->direction ? smooth_between(look->from, look->to, look->to->direction, part) : look->from->at;
    double clearance = search_clearance(look->space, look->body, place, heading, ROUTE_CLEARANCE_REACH, NULL);
    if (clearance < look->least) {
        look->least = clearance;
        look->at = place;
    }
    if (all.moved < NEAR && fabs(all.before - clearance) < LEVEL && fabs(all.behind - clearance) < LEVEL)
        return;
    look_between(look, (Stretch){all.begin, part, all.before, clearance, all.moved / 2});
    look_between(look, (Stretch){part, all.end, clearance, all.behind, all.moved / 2});
}

double narrowest_on(const FreeSpace *space, const Rectangle *body, const Pose *poses, size_t count, Vec2 *at) {
    double least = ROUTE_CLEARANCE_REACH, radius = search_farthest(body);
    *at = poses[0].at;
    for (size_t i = 0; i < count; i++) {
        if (poses[i].clearance < least) {
            least = poses[i].clearance;
            *at = poses[i].at;
        }
    }
    Look look = {.space = space, .body = body, .least = least, .at = *at};
    for (size_t i = 1; i < count; i++) {
        look.from = &poses[i - 1];
        look.to = &poses[i];
        look.turn = vec2_wrap_angle(look.to->heading - look.from->heading);
        double moved = DETOUR * vec2_distance(look.from->at, look.to->at) + fabs(look.turn) * radius;
        look_between(&look, (Stretch){0, 1, look.from->clearance, look.to->clearance, moved});
    }
    *at = look.at;
    return look.least;
}
