/* One change to a house that may let people out: its kind, its size, its settings and its text. */
#pragma once

#include "plan/plan.h"
#include "plan/work.h"

typedef enum ChangeKind {
    CHANGE_WIDEN, /* a door */
    CHANGE_MOVE,  /* a piece of furniture, as the following kinds */
    CHANGE_TURN,
    CHANGE_RAISE,
    CHANGE_AWAY, /* removes the piece: not a suggestion, but a test whether a change of the piece may help */
} ChangeKind;

enum { CHANGE_SETTINGS_MOST = 5 };

typedef struct Change {
    ChangeKind kind;
    size_t index; /* index of the door or the piece */
    double width; /* m, new width of the door */
    double at;    /* m, new position of the door's middle */
    Vec2 by;      /* m, displacement of the piece */
    double angle; /* degree, rotation of the piece */
} Change;

/* Finds the free stretch of wall around a door, m along its segment: up to other doors and to walls that meet it. */
void suggest_change_room(const Plan *plan, size_t door, double *low, double *high);

/* Returns the change to a door's width, about its middle as far as there is room. */
Change suggest_change_widen(const Plan *plan, size_t door, double width);

/* Returns the move of a piece by a distance in a direction (rad), rounded to a millimetre. */
Change suggest_change_move(size_t piece, double far, double direction);

/* Returns the first door from `door` on in whose open leaf a piece stands; door_count: there is none. */
size_t suggest_change_leaf(const Plan *plan, size_t piece, size_t door);

/* True if the moved or turned piece is in the same room and overlaps walls, doorways, open leaves and other pieces
 * nowhere where it did not before. */
bool suggest_change_stands_free(const Plan *plan, const Change *change);

double suggest_change_size(const Plan *plan, const Change *change); /* m */

/* Returns the kind of work that the change needs. */
PlanWork suggest_change_work(const Plan *plan, const Change *change);

/* Writes the settings NAME=VALUE of the change, at most CHANGE_SETTINGS_MOST; the texts live in the arena. Returns
 * their number. */
size_t suggest_change_settings(const Plan *plan, const Change *change, const char **settings, Arena *arena);

/* Returns "Widen door d2 from 0.75 m to 0.79 m". */
const char *suggest_change_words(const Plan *plan, const Change *change, Arena *arena);
