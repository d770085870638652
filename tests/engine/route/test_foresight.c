/* Tests of the passage that a driver sees, on a straight path through one narrow part. */

#include "check.h"

#include <math.h>
#include <string.h>

#include "plan/profile.h"
#include "route/foresight.h"
#include "route/pace.h"

enum { MOST = 400 };

#define LENGTH 4.0     /* m, of the path */
#define BEGINS 1.937   /* m along it, of the narrow part */
#define ENDS 2.063     /* m */
#define NARROW 0.04    /* m, more than the body, in the narrow part */
#define WIDE 1.5       /* m, of the passage elsewhere */
#define STARTING 0.4   /* m/s2 */
#define BRAKING 0.6    /* m/s2 */
#define THIN_WALL 0.01 /* m */

typedef struct Path {
    double left[MOST], right[MOST], heading[MOST], step[MOST], edge[MOST], s[MOST];
    Foresight foresight;
} Path;

static Profile chair(void) {
    return (Profile){.width = 0.63, .free_speed = 0.69, .steering_time = 0.4, .creep = 0.05};
}

static double width_at(const Profile *profile, double s) {
    return s >= BEGINS && s <= ENDS ? profile->width + NARROW : WIDE;
}

/* Places `step` m apart, the first one at `first` m. */
static void make_path(Path *path, const Profile *profile, double first, double step) {
    memset(path, 0, sizeof *path);
    size_t count = 0;
    for (double s = first; s <= LENGTH; s += step, count++) {
        path->s[count] = s;
        path->step[count] = step;
        path->left[count] = path->right[count] = width_at(profile, s) / 2;
        path->edge[count] = 0.5;
        if (s < BEGINS && s + step >= BEGINS)
            path->edge[count] = (BEGINS - s) / step;
        if (s <= ENDS && s + step > ENDS)
            path->edge[count] = (ENDS - s) / step;
    }
    path->foresight = (Foresight){path->left, path->right, path->heading, path->step, path->edge, count};
}

TEST(the_narrow_part_is_as_long_as_it_is_wherever_the_places_lie) {
    static const double steps[] = {0.05, 0.043, 0.025, 0.11}, firsts[] = {0, 0.011, 0.023};
    Profile profile = chair();
    double slow = pace_in_passage(&profile, profile.free_speed, profile.width + NARROW);
    static Path path;
    CHECK_NEAR(slow, NARROW / profile.steering_time, 1e-12);
    for (size_t i = 0; i < sizeof steps / sizeof *steps; i++)
        for (size_t k = 0; k < sizeof firsts / sizeof *firsts; k++) {
            make_path(&path, &profile, firsts[k], steps[i]);
            for (size_t p = 0; p < path.foresight.count; p++) {
                double ahead = BEGINS - FORESIGHT_REACH - path.s[p], behind = path.s[p] - ENDS - FORESIGHT_REACH;
                double beyond = fmax(ahead, behind), most = ahead > 0 ? BRAKING : STARTING;
                double speed = foresight_speed(&path.foresight, p, &profile, profile.free_speed, STARTING, BRAKING);
                if (beyond <= 0)
                    CHECK_NEAR(speed, slow, 1e-12);
                else if (beyond < steps[i])
                    CHECK_NEAR(speed, fmin(sqrt(slow * slow + 2 * most * beyond), profile.free_speed), 1e-12);
                else
                    CHECK(speed > slow);
                CHECK_NEAR(foresight_width(&path.foresight, p), beyond <= 0 ? profile.width + NARROW : WIDE, 1e-12);
            }
        }
}

/* Beside a thin wall that begins on the left where the one on the right has ended. */
TEST(the_room_on_both_sides_counts_together_while_the_body_does_not_turn) {
    Profile profile = chair();
    static Path path;
    make_path(&path, &profile, 0, 0.05);
    for (size_t p = 0; p < path.foresight.count; p++) {
        path.left[p] = fabs(path.s[p] - 2) < THIN_WALL ? 0.4 : WIDE / 2;
        path.right[p] = fabs(path.s[p] - 2.1) < THIN_WALL ? 0.3 : WIDE / 2;
        path.edge[p] = 0.5;
    }
    size_t middle = 41; /* at 2.05 m */
    CHECK_NEAR(foresight_width(&path.foresight, middle), 0.7, 1e-12);
    path.heading[middle] = 0.5;
    CHECK_NEAR(foresight_width(&path.foresight, middle), WIDE / 2 + 0.3, 1e-12);
}
