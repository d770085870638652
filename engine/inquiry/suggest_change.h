/* One change to a house that may let somebody out: what it is, how large, as settings and in words. */
#pragma once

#include "plan/plan.h"

typedef enum ChangeKind {
    CHANGE_WIDEN, /* a door */
    CHANGE_MOVE,  /* a piece of furniture, and so on */
    CHANGE_TURN,
    CHANGE_RAISE,
    CHANGE_AWAY, /* as if it were not there: no change to be made, but what shows whether one may help */
} ChangeKind;

enum { CHANGE_SETTINGS_MOST = 5 };

typedef struct Change {
    ChangeKind kind;
    size_t index; /* of the door, or the piece */
    double width; /* m, of the door then */
    double at;    /* m, of its middle then */
    Vec2 by;      /* m, that the piece is moved */
    double angle; /* degree, that it is turned */
} Change;

/* The free stretch of wall in which a door lies, m along its segment: up to other doors and to walls that meet it. */
void suggest_change_room(const Plan *plan, size_t door, double *low, double *high);

/* The door so wide, about its middle as far as there is room. */
Change suggest_change_widen(const Plan *plan, size_t door, double width);

/* The piece moved so far into that direction (rad), to the millimetre. */
Change suggest_change_move(size_t piece, double far, double direction);

/* Does the piece, moved or turned, stand nowhere where it did not stand before in walls, doorways and other pieces, and
 * in the same room? */
bool suggest_change_stands_free(const Plan *plan, const Change *change);

double suggest_change_size(const Plan *plan, const Change *change); /* m */

/* Its NAME=VALUEs, at most CHANGE_SETTINGS_MOST; the texts live in the arena. Returns how many. */
size_t suggest_change_settings(const Plan *plan, const Change *change, const char **settings, Arena *arena);

/* "Widen door d2 from 0.75 m to 0.79 m" */
const char *suggest_change_words(const Plan *plan, const Change *change, Arena *arena);
