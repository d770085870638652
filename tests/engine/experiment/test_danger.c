/* Tests of where and how hard people touch something, and of what that is compared with. */
#include "experiment/danger.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include "case.h"
#include "check.h"
#include "house/world.h"

/* 80 kg against a clamped hand: F / sqrt(m k) with 140 N at rest, 280 N in an impact, 75 N/mm. */
TEST(a_chair_reaches_the_limits_of_a_clamped_hand_at_6_and_11_cm_per_second) {
    const DangerLimit *hand = &danger_limits[0];
    CHECK(strcmp(hand->part, "hand") == 0 && strcmp(hand->status, "read second-hand") == 0);
    CHECK_NEAR(danger_clamp_speed(hand->still, 80, hand->stiffness), 0.0572, 1e-4);
    CHECK_NEAR(danger_clamp_speed(hand->impact, 80, hand->stiffness), 0.1143, 1e-4);
    CHECK(strcmp(danger_word(0.09), "touch") == 0 && strcmp(danger_word(0.1), "knock") == 0);
    CHECK(strcmp(danger_word(0.29), "knock") == 0 && strcmp(danger_word(0.3), "blow") == 0);
}

/* What a run notes touch by touch adds up to what it notes of the person. */
TEST(the_touches_of_a_run_are_those_of_its_people) {
    House house;
    case_house(&house, "corner-1.20-0.80", -1, case_touching);
    Observation observation = case_run(&house, 1);
    const PersonObservation *person = &observation.people[0];
    double speed = 0, energy = 0, impulse = 0, squeeze = 0;
    int bodies = 0;
    for (size_t t = 0; t < observation.touch_count; t++) {
        const Touch *touch = &observation.touches[t];
        CHECK(touch->person == 0 && touch->mass > 0 && touch->mass <= house.people[0].profile->mass + 1e-9);
        if (touch->part == PART_HAND)
            continue;
        bodies++;
        speed = fmax(speed, touch->speed);
        squeeze = fmax(squeeze, touch->squeeze);
        energy += touch->energy;
        impulse += touch->impulse;
    }
    printf("%d touches, %.3f m/s, %.3f J, %.1f N s, %.1f N\n", bodies, speed, energy, impulse, squeeze);
    CHECK(bodies > 0 && bodies == person->contacts);
    CHECK_NEAR(speed, person->impact, 1e-12);
    CHECK_NEAR(energy, person->energy, 1e-9);
    CHECK_NEAR(impulse, person->impulse, 1e-9);
    CHECK_NEAR(squeeze, person->squeeze, 1e-9);
    observation_free(&observation);
    house_free(&house);
}

static size_t hands_in_corridor(double width) {
    House house;
    json_t *plan = case_corridor(width);
    case_add_person(plan, "manual-chair", 14, 0, 0);
    case_made(&house, plan, -1, (const char *[]){"profile.manual-chair.hands=0.05", NULL});
    Observation observation = case_run(&house, 1);
    size_t hands = 0;
    for (size_t t = 0; t < observation.touch_count; t++)
        hands += observation.touches[t].part == PART_HAND;
    Danger danger = danger_of_run(&house, &observation, 0);
    CHECK(danger.drivers == 1 && danger.hands.all == 1 && danger.hands.good == (hands > 0));
    danger_free(&danger);
    observation_free(&observation);
    house_free(&house);
    return hands;
}

/* A hand takes 5 cm beside the rim; a chair of 0.63 m leaves 3.5 cm in 0.70 m, and 8.5 cm in 0.80 m. */
TEST(a_hand_meets_the_wall_where_there_is_less_room_than_it_takes) {
    CHECK(hands_in_corridor(0.70) == 2);
    CHECK(hands_in_corridor(0.80) == 0);
}

static Touch touch_at(double x, int part, double speed, double energy) {
    return (Touch){.at = {x, 0.5}, .part = part, .other = -1, .speed = speed, .mass = 80, .energy = energy};
}

/* Four drivers: two touch lightly at one place, one hard at another, one has a hand that meets something. */
TEST(places_stand_by_the_energy_that_a_run_is_expected_to_have_there) {
    House house;
    json_t *plan = case_corridor(1);
    case_add_person(plan, "manual-chair", 1, 0, 0);
    case_made(&house, plan, -1, NULL);
    Touch first[] = {touch_at(4, PART_SIDE, 0.2, 0.4), touch_at(4.1, PART_SIDE, 0.1, 0.1)};
    Touch second[] = {touch_at(4.2, PART_TAIL, 0.3, 0.9), touch_at(4.2, PART_HAND, 0.6, 14)};
    Touch third[] = {touch_at(9, PART_FRONT, 0.5, 10)};
    Touch *touches[] = {first, second, third, NULL};
    size_t counts[] = {2, 2, 1, 0};
    DriverRun runs[4];
    for (int k = 0; k < 4; k++)
        runs[k] = (DriverRun){.took_part = true, .varies = true, .completed = true, .hands = k < 3};
    Drivers drivers = {.count = 4, .person_count = 1, .runs = runs, .touches = touches, .touch_counts = counts};
    Danger danger = danger_of_drivers(&house, &drivers, 0);
    CHECK(danger.count == 3 && danger.drivers == 4);
    CHECK(danger.places[0].part == PART_FRONT && danger.places[2].part == PART_HAND);
    CHECK_NEAR(danger.places[0].energy, 10.0 / 4, 1e-12);
    CHECK_NEAR(danger.places[1].energy, 1.4 / 4, 1e-12);
    CHECK_NEAR(danger.places[1].share.value, 0.5, 1e-12);
    CHECK_NEAR(danger.places[1].fastest, 0.3, 1e-12);
    CHECK(danger.places[1].part == PART_TAIL && strncmp(danger.places[1].what, "wall ", 5) == 0);
    CHECK(danger.hands.good == 1 && danger.hands.all == 3);
    danger_free(&danger);
    house_free(&house);
}
