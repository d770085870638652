/* Tests of a driver's strength, and of how hard a touch is. */

#include <math.h>
#include <stdio.h>

#include "case.h"
#include "check.h"
#include "house/run.h"
#include "house/touch.h"

LONG_TEST(a_weak_driver_plans_for_the_strength_that_there_is) {
    double last = HUGE_VAL;
    static const int pushes[] = {20, 30, 60, 100};
    for (int p = 0; p < 4; p++) {
        House house;
        char setting[60];
        snprintf(setting, sizeof setting, "profile.manual-chair.push=%d", pushes[p]);
        case_house(&house, "ube-techno-house", -1, (const char *const[]){setting, NULL});
        Observation observation = case_run(&house, 1);
        CHECK(observation.completed);
        for (size_t i = 0; i < observation.person_count; i++)
            CHECK(observation.people[i].impact <= 0.05);
        CHECK(observation.time <= last * 1.001);
        last = observation.time;
        observation_free(&observation);
        house_free(&house);
    }
}

TEST(an_impact_has_the_mass_that_resists_it) {
    Profile chair = {.driving = DRIVING_DRIVER, .length = 1.1, .width = 0.63, .axle = 0.28, .mass = 80.2};
    chair.mass_centre = 0.15;
    chair.radius_of_gyration = 0.35;
    Vec2 axis = {1, 0};
    CHECK_NEAR(touch_mass(&chair, axis, vec2(0.67, 0), vec2(-1, 0)), 80.2, 1e-9); /* head on */
    /* A front corner sideways, 0.82 m ahead of the axle: m (k^2 + c^2) / 0.82^2. */
    CHECK_NEAR(touch_mass(&chair, axis, vec2(0.67, 0.315), vec2(0, -1)), 17.3, 0.02 * 17.3);
    Sense sense = {0};
    touch_begin(&sense, &chair, axis, vec2(0.67, 0.1), vec2(-1, 0), 0.1); /* it leaves */
    CHECK_NEAR(sense.impact, 0, 0);
    touch_begin(&sense, &chair, axis, vec2(0.67, 0), vec2(-1, 0), -0.3);
    CHECK_NEAR(sense.impact, 0.3, 0);
    CHECK_NEAR(sense.energy, 80.2 * 0.09 / 2, 1e-9); /* 3.6 J */
    CHECK(sense.part == PART_FRONT);
}

TEST(switches_of_the_paper_s_chair_change_its_run) {
    double times[3];
    const char *const switches[3] = {"run.lateral=\"on\"", "run.centripetal=\"off\"", "run.lateral=\"off\""};
    for (int w = 0; w < 3; w++) {
        House house;
        case_house(&house, "corner-1.20-1.20", DRIVING_MIURA, (const char *const[]){switches[w], NULL});
        Observation observation = case_run(&house, 1);
        times[w] = observation.people[0].completed ? observation.people[0].time : HUGE_VAL;
        observation_free(&observation);
        house_free(&house);
    }
    printf("miura %.2f s, without F4 %.2f s, without lateral control %.2f s\n", times[0], times[1], times[2]);
    CHECK(fabs(times[1] - times[0]) < 0.2); /* s: F4 hardly matters */
    CHECK(times[1] != times[0]);
}
