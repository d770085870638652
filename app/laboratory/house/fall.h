/* Furniture that falls in the window after an edit: until it rests, and the house that is drawn has it so, it is drawn
 * with what moves. Nothing that is simulated knows of it. */
#pragma once

#include "visual/house/furniture_fall.h"

typedef struct HouseSession HouseSession;

typedef struct HouseFall {
    bool wanted;           /* the owner animates the falls */
    FurnitureFall *pieces; /* (count) */
    size_t count, capacity;
    size_t drawn;    /* of them, by the film: all or none */
    Arena arena;     /* holds their ids */
    Furniture *seen; /* (seen_count) the furniture of the draft as it was looked at last, */
    size_t seen_count, seen_capacity;
    Arena seen_arena;  /* which holds its ids, */
    uint64_t revision; /* and the draft's then */
    bool noted;
    char words[48];
} HouseFall;

/* Takes notice of what an edit has changed, and of what has come to its end. */
void house_fall_follow(HouseSession *session);

/* A shake of this seed has just been made of the draft: pieces with these ids (count) fall, all others stand, or lie,
 * at once as they do in the draft. */
void house_fall_shake(HouseSession *session, uint64_t seed, const char *const *ids, size_t count);

/* Moves on by so many s on the wall. */
void house_fall_move(HouseSession *session, double seconds);

/* "shaking (seed 3)", "" for other falls; NULL: all rests. */
const char *house_fall_words(const HouseSession *session);

/* Returns how many pieces are drawn at a time, s; none at a time before the edit. */
size_t house_fall_count(const HouseSession *session, double time);

/* Returns the fall that is drawn for this id; NULL: none. */
const FurnitureFall *house_fall_find(HouseSession *session, const char *id);
void house_fall_clear(HouseSession *session);
