/* The smallest changes that let everybody out of a house in which somebody does not get out.
 *
 * What may be changed: a door is widened, within the stretch of wall that is free beside it; a piece of furniture is
 * moved within its room, turned by a quarter, or stood up where it lies. Walls stay where they are, locked doors locked
 * and exits as they open. How large a change is, is measured in metres:
 *
 *     widening      by how much the opening grows
 *     moving        how far the piece is carried
 *     turning       how far its corners go: 2 sin(angle / 2) of half its diagonal
 *     standing up   how much floor it gives back: its height
 *
 * and several together by their sum. Method: everything is changed at once as far as it goes (doors as wide as their
 * walls let them be, all furniture gone); when that is not enough, nothing is. What alone is enough is then found by
 * halving the lot as long as a half is enough. When nothing alone is, things are put back one by one as long as
 * everybody still gets out; what is left is needed together. Each change is then made as small as it can be, to 1 cm,
 * by bisection, and what is proposed has been run to the end with everybody out. */
#pragma once

#include <signal.h>
#include <stdbool.h>
#include <stddef.h>

#include "base/fault.h"
#include "base/memory.h"
#include "house/house.h"

enum {
    SUGGEST_TRIES = 1000, /* houses tried, at most, unless the task says otherwise */
    SUGGEST_MOST = 12,    /* suggestions */
};

typedef struct Suggestion {
    const char *words;           /* "Widen door d2 from 0.75 m to 0.79 m" */
    const char *const *settings; /* (setting_count) NAME=VALUE, which make the house so */
    size_t setting_count;
    double size; /* m */
    double time; /* s, until everybody is out then */
} Suggestion;

/* Zero is an empty list. Texts live in the arena; suggest_clear releases all. */
typedef struct SuggestList {
    bool out_already; /* everybody gets out as it is: nothing is suggested */
    double time;      /* s, when the last one got out as it is, or the run ended */
    Suggestion list[SUGGEST_MOST];
    size_t count;       /* smallest first */
    const char **notes; /* (note_count) sentences: what was tried, what cannot be changed, and why */
    size_t note_count, note_capacity;
    size_t tries;   /* houses */
    bool exhausted; /* the tries were used up: there may be others */
    bool stopped;   /* before it was complete */
    Arena arena;
} SuggestList;

typedef struct SuggestTask {
    const char *path; /* of the house */
    const char *text; /* of its file, which need not be on the disk; NULL: what is there */
    const HouseOptions *options;
    size_t most_tries; /* 0: SUGGEST_TRIES */
    int jobs;          /* threads */
    const volatile sig_atomic_t *stop;
    void (*progress)(void *context, size_t tries); /* so far; from one thread at a time; NULL: none */
    void *context;
} SuggestTask;

/* Looks for them, on any thread; the same answer for any number of jobs. False: the house cannot be read, faults say
 * why. */
bool suggest_find(SuggestList *list, const SuggestTask *task, Fault *fault);
void suggest_clear(SuggestList *list);
