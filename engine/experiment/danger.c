#include "experiment/danger.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#include "base/memory.h"
#include "house/world.h"

#define SPECIFICATION "ISO/TS 15066:2016, tables A.2 and A.3, from published approximations; itself unread"

const DangerLimit danger_limits[DANGER_LIMITS] = {
    {"hand", 140, 280, 75e3, "read second-hand", SPECIFICATION},
    {"forearm", 160, 320, 40e3, "read second-hand", SPECIFICATION},
    {"lower leg", 130, 260, 60e3, "read second-hand", SPECIFICATION},
    {"thigh, knee", 220, 440, 50e3, "read second-hand", SPECIFICATION},
};

const char danger_caveat[] = "These are pain limits of healthy adults beside robots, and preliminary ones. They do "
                             "not protect people who cannot feel their legs or hands.";

const char *danger_word(double speed) {
    return speed >= DANGER_BLOW ? "blow" : speed >= DANGER_KNOCK ? "knock" : "touch";
}

double danger_clamp_speed(double force, double mass, double stiffness) {
    return force / sqrt(mass * stiffness);
}

/* A run of one driver as one person. */
typedef struct Run {
    const Touch *touches; /* (count) */
    size_t count;
    bool hands; /* True if the driver has hands at the rims */
    size_t driver;
} Run;

/* A place while it gathers touches. */
typedef struct Gathered {
    DangerPlace place;
    double *speeds; /* (runs) m/s, the fastest touch of each run; NAN: none */
    size_t touched; /* runs */
} Gathered;

typedef struct Gathering {
    const House *house;
    Gathered *of; /* (count) */
    size_t count, capacity;
    size_t run_count, driver_count;
} Gathering;

static Gathered *find_place(Gathering *gathering, const Touch *touch) {
    for (size_t p = 0; p < gathering->count; p++) {
        const DangerPlace *place = &gathering->of[p].place;
        if ((place->part == PART_HAND) == (touch->part == PART_HAND) &&
            vec2_distance(place->at, touch->at) <= DANGER_NEAR)
            return &gathering->of[p];
    }
    gathering->of = memory_reserve(gathering->of, &gathering->capacity, gathering->count + 1, sizeof *gathering->of);
    Gathered *new = &gathering->of[gathering->count++];
    *new = (Gathered){.place = {.at = touch->at,
                                .part = touch->part,
                                .fastest = -1,
                                .by = memory_zeroed(gathering->driver_count, sizeof *new->place.by)},
                      .speeds = memory_zeroed(gathering->run_count, sizeof *new->speeds)};
    for (size_t r = 0; r < gathering->run_count; r++)
        new->speeds[r] = (double)NAN;
    return new;
}

static void name_place(const House *house, DangerPlace *place, const Touch *touch) {
    if (touch->other >= 0)
        snprintf(place->what, sizeof place->what, "person %s", house->people[touch->other].id);
    else
        outline_place_name(&house->outline, &house->plan, touch->at, place->what, sizeof place->what);
}

static void gather(Gathering *gathering, size_t run, size_t driver, const Touch *touch) {
    Gathered *gathered = find_place(gathering, touch);
    DangerPlace *place = &gathered->place;
    bool first = isnan(gathered->speeds[run]);
    gathered->touched += first;
    place->by[driver] = true;
    gathered->speeds[run] = first ? touch->speed : fmax(gathered->speeds[run], touch->speed);
    place->energy += touch->energy;
    place->impulse = fmax(place->impulse, touch->impulse);
    place->squeeze = fmax(place->squeeze, touch->squeeze);
    if (touch->speed <= place->fastest)
        return;
    place->fastest = touch->speed;
    place->part = touch->part;
    place->mass = touch->mass;
    place->at = touch->at;
    name_place(gathering->house, place, touch);
}

static int falling(double a, double b) {
    return (a < b) - (a > b);
}

static int by_danger(const void *a, const void *b) {
    const DangerPlace *one = a, *other = b;
    int hands = (one->part == PART_HAND) - (other->part == PART_HAND);
    int energy = falling(one->energy, other->energy), share = falling(one->share.value, other->share.value);
    int speed = falling(one->speed95, other->speed95);
    return hands ? hands : energy ? energy : share ? share : speed;
}

static Danger rank(const House *house, const Run *runs, size_t count, size_t drivers) {
    Gathering gathering = {.house = house, .run_count = count, .driver_count = drivers};
    size_t with_hands = 0, met = 0;
    for (size_t r = 0; r < count; r++) {
        bool meets = false;
        for (size_t t = 0; t < runs[r].count; t++) {
            gather(&gathering, r, runs[r].driver, &runs[r].touches[t]);
            meets |= runs[r].touches[t].part == PART_HAND;
        }
        with_hands += runs[r].hands;
        met += meets;
    }
    Danger danger = {.places = memory_zeroed(gathering.count, sizeof *danger.places),
                     .count = gathering.count,
                     .drivers = count,
                     .hands = montecarlo_share(met, with_hands)};
    for (size_t p = 0; p < gathering.count; p++) {
        Gathered *gathered = &gathering.of[p];
        gathered->place.share = montecarlo_share(gathered->touched, count);
        gathered->place.speed95 = montecarlo_distribution(gathered->speeds, count).high;
        gathered->place.energy /= (double)count;
        danger.places[p] = gathered->place;
        memory_free(gathered->speeds);
    }
    memory_free(gathering.of);
    qsort(danger.places, danger.count, sizeof *danger.places, by_danger);
    return danger;
}

Danger danger_of_drivers(const House *house, const Drivers *drivers, size_t person) {
    size_t all = drivers->count * drivers->person_count, count = 0;
    Run *runs = memory_zeroed(all, sizeof *runs);
    for (size_t r = 0; r < all; r++)
        if (drivers->runs[r].varies && (person == SIZE_MAX || r % drivers->person_count == person))
            runs[count++] =
                (Run){drivers->touches[r], drivers->touch_counts[r], drivers->runs[r].hands, r / drivers->person_count};
    Danger danger = rank(house, runs, count, drivers->count);
    memory_free(runs);
    return danger;
}

Danger danger_of_run(const House *house, const Observation *observation, size_t person) {
    Touch *own = memory_zeroed(observation->touch_count, sizeof *own);
    Run run = {.touches = own, .hands = house->people[person].profile->hands > 0};
    for (size_t t = 0; t < observation->touch_count; t++)
        if (observation->touches[t].person == person)
            own[run.count++] = observation->touches[t];
    Danger danger = rank(house, &run, 1, 1);
    memory_free(own);
    return danger;
}

void danger_free(Danger *danger) {
    for (size_t p = 0; p < danger->count; p++)
        memory_free(danger->places[p].by);
    memory_free(danger->places);
    *danger = (Danger){0};
}
