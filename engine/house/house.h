/* Everything about a house that is given: the plan, who lives in it, and what follows from the two once and for all. A
 * world moves in it and never changes it. A house that has been read stays where it is: its parts point at one another.
 */
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
    const PlanRoute *route; /* NULL: none, the quickest exit */
    Vec2 at;                /* m, the reference point */
    double heading;         /* rad */
    double delay;           /* s */
    double speed;           /* m/s, free speed */
    const Furniture *under; /* the piece that fell on them in a shake, or NULL */
} Inhabitant;

/* The mass centre of somebody who stands at the start, m. */
static inline Vec2 house_centre(const Inhabitant *person) {
    double ahead = person->profile->driving == DRIVING_DRIVER ? person->profile->mass_centre : 0;
    return vec2_along(person->at, ahead, vec2_heading(person->heading));
}

typedef struct House {
    Plan plan;
    Profile *profiles; /* (profile_count), the ones that are named */
    size_t profile_count;
    Inhabitant *people; /* (person_count) by id, so that the order in the file does not matter */
    size_t person_count;
    uint64_t seed;
    Outline outline;
    FreeSpace space;
    ObstacleGrid obstacles; /* empty when nobody walks */
    Arena arena;
} House;

typedef struct HouseOptions {
    const char *profiles;        /* directory of the shipped profiles; NAME.json beside the house file comes first */
    const char *const *settings; /* (setting_count) NAME=VALUE */
    size_t setting_count;
    uint64_t seed; /* for crowds: who stands where and how fast they are */
    int driving;   /* Driving for everybody, or -1: each profile's own */
    bool shake;    /* the seed's earthquake comes before anybody moves (shake.h) */
} HouseOptions;

/* Reads a house file and the profiles it names. False: faults say where and what, and the house is as it was. */
bool house_read(House *house, const char *path, const HouseOptions *options, Fault *fault);

/* The same of a house file's `text`, ended by 0, which need not be on the disk: faults are of `path`, and profiles
 * beside it come first. */
bool house_read_text(House *house, const char *path, const char *text, const HouseOptions *options, Fault *fault);

void house_free(House *house);

/* The place of an id among house->people, members of crowds included, or SIZE_MAX. */
size_t house_find_person(const House *house, const char *id);

/* As plan_parameter, of the profiles too: "profile.manual-chair.width". */
const Parameter *house_parameter(const House *house, const char *name, const void **object, const char *place,
                                 Fault *fault);
