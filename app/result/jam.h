/* The places where a crowd loses time, named by the exit, door or room they are at: what is touched there, a wall or
 * another person, says little. */
#pragma once

#include "base/memory.h"
#include "house/observation.h"

/* A place of a jam: of its exit, its door and its room the first one that is given names it. */
typedef struct JamPlace {
    const Exit *exit;  /* the exit it is at, or NULL */
    const Door *door;  /* the door it is at, or the nearest one of the same surroundings, or NULL */
    const char *room;  /* the name of the room it is in, or NULL; NULL at an exit or a door */
    const char *thing; /* a piece of furniture, as the danger names it, or NULL */
    bool nameless;     /* True if nothing of these is there */
} JamPlace;

JamPlace jam_place(const Plan *plan, const Hazard *hazard);

/* True if two dangerous points are at one place. */
bool jam_is_same(const Plan *plan, const Hazard *a, const Hazard *b);

/* Returns the name of a dangerous point: in a crowd that of its place, "exit w1", "shop 18 door", "street 2, shop 18
 * door"; among few people that of the thing, see names_thing. */
const char *jam_name(const House *house, const Hazard *hazard, Arena *arena);

/* Returns when a jam is worst: the middle of the seconds in which the people near it lose most time, s. Those who have
 * not set off yet do not count. */
double jam_worst(const House *house, const Observation *observation, const Hazard *hazard);
