#include "route/foresight.h"

#include <math.h>
#include <stdbool.h>

#include "base/real.h"
#include "base/vec2.h"
#include "route/pace.h"

/* The rays across the body's middle jump at the jambs of a door: the passage is a step function of the way. If it were
 * taken only at the places of the path, the narrow part would be as long as those happen to lie, to a step at either
 * end, which takes half a second where a door is passed at 0.1 m/s. So the jumps have their exact places (`edge`), and
 * the speed is the same whatever the places of the path:
 *
 *     v(s)^2 = min over the passages, at distance d from s, of v(W)^2 + 2 a max(0, d - FORESIGHT_REACH)
 *
 * where only those at most a step beyond the reach are looked at, since the passes over the path (speeds.c, track.c)
 * limit what comes farther ahead. */

static const double PARALLEL = 0.349; /* rad, 20 degrees */
/* m: widths that differ by more than this from one place to the next change somewhere between them at once. */
static const double JUMP = 0.05;
/* 1: where widths do not jump, each place stands for half of the steps beside it. */
static const double EDGE = 0.5;

enum { HALVINGS = 6 /* which find a jump to 1/64 of a step */ };

double foresight_edge(double here, double next, ForesightWidth width, const void *context) {
    if (fabs(here - next) < JUMP)
        return EDGE;
    double low = 0, high = 1;
    for (int i = 0; i < HALVINGS; i++) {
        double part = (low + high) / 2;
        *((width(context, part) < (here + next) / 2) == (here < next) ? &low : &high) = part;
    }
    return (low + high) / 2;
}

/* The least of what is seen so far from one place. */
typedef struct Least {
    double width, left, right; /* m */
} Least;

static inline void take(const Foresight *foresight, size_t from, size_t place, Least *least) {
    double left = foresight->left[place], right = foresight->right[place];
    if (!(real_min(left, right) < HUGE_VAL))
        return;
    least->width = real_min(least->width, left + right);
    if (fabs(vec2_wrap_angle(foresight->heading[place] - foresight->heading[from])) < PARALLEL) {
        least->left = real_min(least->left, left);
        least->right = real_min(least->right, right);
    }
}

static double width_of(const Least *least) {
    return real_min(least->width, least->left + least->right);
}

/* Takes what is seen within the reach on one side (-1: behind). Returns the place after those, or the last one there
 * is, and in *beyond how much farther away than the reach it begins, m; infinite if there is none. */
static size_t look(const Foresight *foresight, size_t from, int side, Least *least, double *beyond) {
    double passed = 0; /* m, from the place to the last one that was taken */
    size_t here = from;
    *beyond = HUGE_VAL;
    while (side > 0 ? here + 1 < foresight->count : here > 0) {
        size_t step = side > 0 ? here : here - 1;
        double part = side > 0 ? foresight->edge[step] : 1 - foresight->edge[step];
        double begins = passed + part * foresight->step[step];
        here = side > 0 ? here + 1 : here - 1;
        if (begins > FORESIGHT_REACH) {
            *beyond = begins - FORESIGHT_REACH;
            break;
        }
        passed += foresight->step[step];
        take(foresight, from, here, least);
    }
    return here;
}

double foresight_width(const Foresight *foresight, size_t place) {
    Least least = {HUGE_VAL, HUGE_VAL, HUGE_VAL};
    double beyond;
    take(foresight, place, place, &least);
    look(foresight, place, 1, &least, &beyond);
    look(foresight, place, -1, &least, &beyond);
    return width_of(&least);
}

/* Returns the speed at a place from which what is next, and narrower than `width` m, begins `beyond` m beyond the
 * reach.
 */
static double towards(const Foresight *foresight, size_t from, size_t next, Least least, double width, double beyond,
                      double acceleration, const Profile *profile, double free) {
    if (!(beyond < HUGE_VAL))
        return free;
    take(foresight, from, next, &least);
    double narrower = width_of(&least);
    if (!(narrower < width))
        return free;
    double speed = pace_in_passage(profile, free, narrower);
    return sqrt(speed * speed + 2 * acceleration * beyond);
}

double foresight_speed(const Foresight *foresight, size_t place, const Profile *profile, double free, double starting,
                       double braking) {
    Least least = {HUGE_VAL, HUGE_VAL, HUGE_VAL};
    double ahead, behind;
    take(foresight, place, place, &least);
    size_t next = look(foresight, place, 1, &least, &ahead), last = look(foresight, place, -1, &least, &behind);
    double width = width_of(&least);
    double speed = pace_in_passage(profile, free, width);
    speed = real_min(speed, towards(foresight, place, next, least, width, ahead, braking, profile, free));
    return real_min(speed, towards(foresight, place, last, least, width, behind, starting, profile, free));
}
