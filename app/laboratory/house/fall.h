/* Animates the fall of furniture after an edit, in the window only. A piece is drawn with the moving layer until it
 * rests and the drawn house contains its new position. The simulation does not depend on it. */
#pragma once

#include "visual/house/furniture_fall.h"

typedef struct HouseSession HouseSession;

typedef struct HouseFall {
    bool wanted;           /* the owner animates the falls */
    FurnitureFall *pieces; /* (count) */
    size_t count, capacity;
    size_t drawn;    /* number of pieces that the film draws as falling: all or none */
    Arena arena;     /* holds the ids of the pieces */
    Furniture *seen; /* (seen_count) the draft's furniture at the last look, */
    size_t seen_count, seen_capacity;
    Arena seen_arena;  /* the arena of its ids, */
    uint64_t revision; /* and the draft's revision at the last look */
    bool noted;
    char text[48];
} HouseFall;

/* Begins the falls caused by the last edit, and removes the falls that have ended. */
void house_fall_update(HouseSession *session);

/* Animates an earthquake of this seed that was just made in the draft: the pieces with these ids (count) fall, all
 * other pieces take their position in the draft at once. */
void house_fall_shake(HouseSession *session, uint64_t seed, const char *const *ids, size_t count);

/* Advances the animation by a number of seconds of real time. */
void house_fall_advance(HouseSession *session, double seconds);

/* Returns "shaking (seed 3)", "" for other falls; NULL: all pieces rest. */
const char *house_fall_text(const HouseSession *session);

/* Returns how many pieces are drawn at a time, s; none at a time before the edit. */
size_t house_fall_count(const HouseSession *session, double time);

/* Returns the fall that is drawn for this id; NULL: none. */
const FurnitureFall *house_fall_find(HouseSession *session, const char *id);
void house_fall_clear(HouseSession *session);
