/* Finds the smallest changes to a house with which all people can leave, if some cannot.
 *
 * Possible changes: a door is widened, within the free stretch of wall next to it; a piece of furniture is moved within
 * its room, turned by a quarter, or stood up where it lies. Walls, locked doors and opening times of exits do not
 * change. The size of a change is measured in metres:
 *
 *     widening      increase of the opening
 *     moving        distance of the piece
 *     turning       distance of its corners: 2 sin(angle / 2) times half its diagonal
 *     standing up   floor length gained: its height
 *
 * and several changes by their sum. Method: first everything is changed at once as far as possible (doors as wide as
 * their walls allow, all furniture removed); if that is not enough, there is no solution. Single sufficient changes are
 * then found by halving the set as long as a half is sufficient. If no single change is, the changes are undone one by
 * one as long as all people still leave; the remaining ones are needed together. Each change is then minimised by
 * bisection, to 1 cm, and every suggestion has been run to the end with all people out. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "base/fault.h"
#include "base/memory.h"
#include "base/stop.h"
#include "house/house.h"
#include "plan/work.h"

enum {
    SUGGEST_TRIES = 1000, /* largest number of houses tried, unless the task sets it */
    SUGGEST_MOST = 12,    /* suggestions */
};

typedef struct Suggestion {
    const char *text;            /* "Widen door d2 from 0.75 m to 0.79 m" */
    const char *const *settings; /* (setting_count) NAME=VALUE, the settings of the change */
    size_t setting_count;
    double size;            /* m */
    double time;            /* s, until all people are out with the change */
    bool works[PLAN_WORKS]; /* kinds of work that it needs */
} Suggestion;

/* A zeroed list is empty. Texts live in the arena; suggest_clear releases everything. */
typedef struct SuggestList {
    bool out_already; /* True if all people leave the unchanged house: nothing is suggested */
    double time;      /* s, when the last person left the unchanged house, or the run ended */
    Suggestion list[SUGGEST_MOST];
    size_t count;       /* smallest first */
    const char **notes; /* (note_count) sentences: attempts, impossible changes, and reasons */
    size_t note_count, note_capacity;
    size_t tries;   /* number of houses tried */
    bool exhausted; /* True if the tries were used up: there may be other suggestions */
    bool stopped;   /* True if interrupted: there may be other suggestions, and out_already is not known */
    Arena arena;
} SuggestList;

typedef struct SuggestTask {
    const char *path; /* path of the house */
    const char *text; /* text of its file, which need not be on disk; NULL: the file is read */
    const HouseOptions *options;
    size_t most_tries; /* 0: SUGGEST_TRIES */
    int jobs;          /* number of threads */
    const Stop *stop;
    void (*progress)(void *context,
                     size_t tries); /* number of tries so far; called from one thread at a time; NULL: none */
    void *context;
} SuggestTask;

/* Searches on any thread, with the same result for any number of jobs. Returns false after an error if the house cannot
 * be read. */
bool suggest_find(SuggestList *list, const SuggestTask *task, Fault *fault);
void suggest_clear(SuggestList *list);
