/* The fixed data of a house: the plan, the people, and everything derived from the two in advance. A world moves in a
 * house and never changes it. A house must not move after it has been read, since its parts point at one another. */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "space/freespace.h"
#include "space/outline.h"
#include "plan/plan.h"
#include "plan/profile.h"
#include "space/obstacle_grid.h"

/* One person of the plan, or of a crowd. */
typedef struct Inhabitant {
    const char *id;
    const Profile *profile;
    const PlanRoute *route; /* NULL: no route, the quickest exit */
    Vec2 at;                /* m, the reference point */
    double heading;         /* rad */
    double delay;           /* s */
    double speed;           /* m/s, free speed */
    const Furniture *under; /* the piece that fell on the person in a shake, or NULL */
} Inhabitant;

/* Returns the mass centre of a person at the start, m. */
static inline Vec2 house_centre(const Inhabitant *person) {
    double ahead = person->profile->driving == DRIVING_DRIVER ? person->profile->mass_centre : 0;
    return vec2_along(person->at, ahead, vec2_heading(person->heading));
}

typedef struct House {
    Plan plan;
    Profile *profiles; /* (profile_count), the profiles in use */
    size_t profile_count;
    Inhabitant *people; /* (person_count) ordered by id, so that the order in the file does not matter */
    size_t person_count;
    uint64_t seed;
    size_t driver; /* 0: the nominal one, who makes no errors of steering */
    Outline outline;
    FreeSpace space;
    ObstacleGrid obstacles; /* empty without walkers */
    Arena arena;
} House;

/* Returns what the personal space does to drivers: RING_PUSHES, RING_STEERS or RING_OFF. RING_AUTO: drivers are steered
 * by it. Among people on foot it still pushes the nominal driver: steered chairs wedge in a neck more often. */
static inline int house_ring(const House *house) {
    int ring = house->plan.run.ring;
    bool crowded = house->obstacles.begin != NULL;
    return ring != RING_AUTO ? ring : house->driver == 0 && crowded ? RING_PUSHES : RING_STEERS;
}

typedef struct HouseOptions {
    const char *profiles; /* directories of profiles, one a line, the first that has NAME.json decides; that in the
                             folder of the house file takes precedence */
    const char *const *settings; /* (setting_count) NAME=VALUE */
    size_t setting_count;
    uint64_t seed; /* for crowds: determines positions and speeds */
    int driving;   /* Driving for all people, or -1: as in each profile */
    bool shake;    /* True if the seed's earthquake happens before the start (shake.h) */
} HouseOptions;

/* Reads a house file and its profiles. Returns false after an error, with the house unchanged. */
bool house_read(House *house, const char *path, const HouseOptions *options, Fault *fault);

/* Does the same with a house file's `text`, ended by 0, which need not be on disk: errors name `path`, and profiles in
 * its folder take precedence. */
bool house_read_text(House *house, const char *path, const char *text, const HouseOptions *options, Fault *fault);

void house_free(House *house);

/* Returns the index of an id in house->people, including members of crowds, or SIZE_MAX. */
size_t house_find_person(const House *house, const char *id);

/* Works as plan_parameter, including the profiles: "profile.manual-chair.width". */
const Parameter *house_parameter(const House *house, const char *name, const void **object, const char *place,
                                 Fault *fault);
