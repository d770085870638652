/* Tries changed houses, many at a time, and finds how small a change can be. */
#pragma once

#include <pthread.h>

#include "inquiry/suggest.h"
#include "inquiry/suggest_change.h"

/* One changed house, and its result. */
typedef struct Attempt {
    const Change *changes; /* (count) not owned */
    size_t count;
    bool planned_only; /* True if it suffices that all people who were stuck have a path; otherwise all people must
                          leave */
    bool good;
    double time; /* s, until all people were out */
} Attempt;

typedef struct Search {
    const SuggestTask *task;
    const House *base;
    bool *stuck;  /* (people) True for people without a path in the base */
    bool by_plan; /* True if all people who did not leave had no path: planning alone then decides most attempts */
    size_t tries, most;
    bool exhausted;
    pthread_mutex_t lock; /* protects progress reports */
    size_t reported;      /* tries reported */
    Arena arena;          /* memory of lists of changes */
} Search;

/* Fills in `good` and `time` of all attempts. Returns false, with none filled in, if the tries are used up or the
 * search is stopped. */
bool suggest_search_try(Search *search, Attempt *attempts, size_t count);

/* Reads the house of the task with these options. */
bool suggest_search_open(const SuggestTask *task, House *house, const HouseOptions *options, Fault *fault);

/* Reads the house with the changes of an attempt. Returns false if that house is invalid. */
bool suggest_search_read(const Search *search, const Attempt *attempt, House *house);

#define SUGGEST_SEARCH_WIDEST 1.5 /* m, of a door: a chair can turn in it */

/* Finds the largest width of the door, to the centimetre. Returns false if the door cannot be widened. */
bool suggest_search_widest(const Plan *plan, size_t door, Change *widest);

/* One variant of the change of an element (a door at its widest, a removed piece). */
typedef struct Variant {
    Change change;
    double time; /* s, until all people were out */
} Variant;

enum { VARIANTS_MOST = 5 };

/* Finds variants that let all people out together with `others` (count): the least widening of a door; the least move,
 * turns and standing up of a piece. Returns their number. */
size_t suggest_search_variants(Search *search, const Change *others, size_t count, const Change *element,
                               Variant variants[VARIANTS_MOST]);
