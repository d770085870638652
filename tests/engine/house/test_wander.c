/* Tests how far drivers stray from their line in a corridor: the spread of both ends of the body. */

#include <math.h>
#include <stdio.h>

#include "case.h"
#include "check.h"
#include "house/journey.h"
#include "house/phase.h"
#include "house/step.h"
#include "house/world.h"
#include "route/pace.h"

/* The spread over all drivers and the last of the way: root mean squares about the mean. */
typedef struct Spread {
    double front, rear; /* m, of the corners' offsets across the way */
    double speed;       /* m/s, mean */
} Spread;

/* Drives from x = 1 m, and looks from `from` m to 17 m. */
static Spread stray(size_t drivers, double width, double from, const char *const *settings) {
    House house;
    json_t *plan = case_corridor(width);
    case_add_person(plan, "manual-chair", 1, 0, 0);
    case_made(&house, plan, -1, settings);
    Journeys journeys = journey_plan_all(&house, NULL, 1, NULL);
    const Profile *profile = house.people[0].profile;
    Spread spread = {0};
    double count = 0, middle = 0;
    for (size_t driver = 1; driver <= drivers; driver++) {
        house.driver = driver;
        World world = world_create(&house, journeys.of, NULL);
        while (phase_any_active(&world)) {
            step_world(&world, NULL);
            Vec2 at = world_reference(&world, 0);
            if (at.x < from || at.x > 17 || world.clock.step % 100)
                continue;
            double front = at.y + (profile->length - profile->axle) * sin(world.heading[0]);
            double rear = at.y - profile->axle * sin(world.heading[0]);
            middle += front;
            spread.front += front * front;
            spread.rear += rear * rear;
            spread.speed += vec2_length(world.velocity[0]);
            count++;
        }
        world_destroy(&world);
    }
    journey_free_all(&journeys);
    house_free(&house);
    middle /= count; /* of a wide corridor the plan may lead beside the middle */
    return (Spread){sqrt(spread.front / count - middle * middle), sqrt(spread.rear / count - middle * middle),
                    spread.speed / count};
}

/* The front corner errs by alpha v, the rear one by 0.83 of it. */
TEST(both_ends_of_a_chair_err_as_the_law_says) {
    const char *const law[] = {"profile.manual-chair.drive.caution=3.5", NULL};
    Spread spread = stray(400, 0.9, 8, law);
    double expected = 0.4 / (2 * 3.5) * spread.speed;
    printf("front corner %.2f mm of %.2f mm, rear %.3f of it, at %.3f m/s\n", 1000 * spread.front, 1000 * expected,
           spread.rear / spread.front, spread.speed);
    CHECK_NEAR(spread.front, expected, 0.05 * expected);
    CHECK_NEAR(spread.rear / spread.front, 0.83, 0.03);
}

/* By sight alone, without a reaction time, it is sqrt(K / K_p) = 3.5 times as far, of which 0.93 is reached after 13 m
 * of way, in a corridor that is wide enough for that. */
LONG_TEST(without_the_personal_space_a_chair_errs_further) {
    const char *const blind[] = {"profile.manual-chair.drive.caution=4.5", "profile.manual-chair.drive.reaction=0",
                                 "run.ring=\"off\"", NULL};
    const char *const sees[] = {"profile.manual-chair.drive.caution=4.5", "profile.manual-chair.drive.reaction=0",
                                NULL};
    Spread without = stray(400, 2.0, 14, blind), with = stray(400, 1.0, 8, sees);
    CHECK_NEAR(without.speed, with.speed, 0.01);
    double ratio = without.front / with.front;
    printf("without the personal space %.2f times as far\n", ratio);
    CHECK(ratio >= 3.0 && ratio <= 3.7);
}

/* Returns how far to the left the front edge goes, m, in the mean over the drivers, where the plan of the corner has
 * turned most over the last metre, and that turn, rad. */
static double front_in_bend(size_t drivers, const char *drift, double *turned) {
    char setting[64];
    snprintf(setting, sizeof setting, "profile.manual-chair.drive.drift=%s", drift);
    const char *const settings[] = {setting, NULL};
    House house;
    case_house(&house, "corner-1.80-1.80", -1, settings);
    Journeys journeys = journey_plan_all(&house, NULL, 1, NULL);
    double sum = 0, angle = 0;
    for (size_t driver = 1; driver <= drivers; driver++) {
        house.driver = driver;
        World world = world_create(&house, journeys.of, NULL);
        double most = 0, front = 0;
        while (phase_any_active(&world)) {
            step_world(&world, NULL);
            const Drive *drive = &world.drive[0];
            if (fabs(drive->turned) <= fabs(most))
                continue;
            most = drive->turned;
            front =
                drive->offset + vec2_wrap_angle(world.heading[0] - journeys.of[0].track.points[drive->index].heading) *
                                    (house.people[0].profile->length - house.people[0].profile->axle);
        }
        sum += front;
        angle += most;
        world_destroy(&world);
    }
    journey_free_all(&journeys);
    house_free(&house);
    *turned = angle / (double)drivers;
    return sum / (double)drivers;
}

/* The same drivers, with and without the slip: the front edge goes outwards by the slip, which the axle follows late.
 */
TEST(a_turning_chair_slips_outwards) {
    double turned, same;
    double slipping = front_in_bend(40, "0.05", &turned), firm = front_in_bend(40, "0", &same);
    double slip = (slipping - firm) / turned;
    printf("slip %.4f m/rad in a turn of %.2f rad\n", slip, turned);
    CHECK(turned > 0.5);
    CHECK_NEAR(turned, same, 0.02);
    CHECK_NEAR(slip, -0.05, 0.01);
}

/* Turns round on the spot, and compares the heading at the end of that with the nominal driver's. */
TEST(turns_on_the_spot_end_with_an_error) {
    const char *const settings[] = {"profile.manual-chair.drive.spot_error=4", NULL};
    House house;
    json_t *plan = case_corridor(2.0);
    case_add_person(plan, "manual-chair", 5, 0, 180);
    case_made(&house, plan, -1, settings);
    Journeys journeys = journey_plan_all(&house, NULL, 1, NULL);
    const Track *track = &journeys.of[0].track;
    double sum = 0, squares = 0, nominal = 0;
    size_t drivers = 400;
    CHECK(track->count > 1 && track->points[1].direction == 0);
    for (size_t driver = 0; driver <= drivers; driver++) {
        house.driver = driver;
        World world = world_create(&house, journeys.of, NULL);
        while (phase_any_active(&world) && track->points[world.drive[0].index + 1].direction == 0)
            step_world(&world, NULL);
        double heading = world.heading[0];
        if (driver == 0) /* who makes no error; the turn still goes on for a moment */
            nominal = heading;
        double error = vec2_wrap_angle(heading - nominal);
        sum += error;
        squares += error * error;
        world_destroy(&world);
    }
    journey_free_all(&journeys);
    house_free(&house);
    double mean = sum / (double)drivers, deviation = sqrt(squares / (double)drivers - mean * mean);
    printf("errors of the heading: mean %.2f degrees, deviation %.2f\n", degrees(mean), degrees(deviation));
    CHECK_NEAR(mean, 0, radians(0.8));
    CHECK_NEAR(deviation, radians(4), radians(0.4));
}
