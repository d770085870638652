/* Tries changed houses, many at a time, and finds how small a change can be. */
#pragma once

#include <pthread.h>

#include "inquiry/suggest.h"
#include "inquiry/suggest_change.h"

/* One changed house, and what came of it. */
typedef struct Attempt {
    const Change *changes; /* (count) not owned */
    size_t count;
    bool planned_only; /* enough that everybody who was stuck has a way; otherwise everybody must come out */
    bool good;
    double time; /* s, until everybody was out */
} Attempt;

typedef struct Search {
    const SuggestTask *task;
    const House *base;
    bool *stuck;  /* (people) who had no way out in the base */
    bool by_plan; /* all who are not out had none: planning tells most of it */
    size_t tries, most;
    bool exhausted;
    pthread_mutex_t lock; /* of who reports progress */
    size_t reported;      /* tries reported */
    Arena arena;          /* holds lists of changes */
} Search;

/* Fills `good` and `time` of all, or of none when the tries are used up or it is stopped. False: of none. */
bool suggest_search_try(Search *search, Attempt *attempts, size_t count);

/* Reads the house that the task is about, with these options. */
bool suggest_search_open(const SuggestTask *task, House *house, const HouseOptions *options, Fault *fault);

/* Reads the house with its changes. False: there is none with them. */
bool suggest_search_read(const Search *search, const Attempt *attempt, House *house);

#define SUGGEST_SEARCH_WIDEST 1.5 /* m, of a door: a chair turns in it */

/* The widest that the door can be made, to the centimetre. False: no wider than it is. */
bool suggest_search_widest(const Plan *plan, size_t door, Change *widest);

/* A way of making the change that an element (a door at its widest, a piece away) stands for. */
typedef struct Variant {
    Change change;
    double time; /* s, until everybody was out with it */
} Variant;

enum { VARIANTS_MOST = 5 };

/* With `others` (count) made too: the least widening of the door; of a piece the least move, turns, standing up, as far
 * as they let everybody out. Returns how many. */
size_t suggest_search_variants(Search *search, const Change *others, size_t count, const Change *element,
                               Variant variants[VARIANTS_MOST]);
