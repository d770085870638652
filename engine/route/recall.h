/* Keeps how chairs were decided to drive, so that an edit elsewhere in the house costs no search: see recall.c. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "route/fit.h"
#include "route/route.h"
#include "route/search.h"
#include "space/reads.h"

/* A question and all that its answer depends on besides the free space and the times to its goals. */
typedef struct RecallQuestion {
    const RouteQuery *query;
    const Rectangle *body;
    const Goal *goals; /* (goal_count) */
    size_t goal_count;
    double radius; /* m, of the disc whose times to the goals are read */
    double depth;  /* m */
    bool coarsely;
} RecallQuestion;

typedef struct RecallAnswer {
    int decided;       /* what the asker wants to know */
    SearchTrack track; /* owned */
    size_t *pins;      /* (goal_count of the question) not owned */
    FitPlace tightest; /* if it is known */
    bool has_tightest;
} RecallAnswer;

/* The reads of one search: in its own copy of the free space, and in the times to each goal. */
typedef struct RecallWatch {
    FreeSpace space;
    Reads reads;
    Reads *times; /* (goal_count) */
} RecallWatch;

/* Opaque; safe for several threads. It holds at most RECALL_MOST_BYTES, of which those that were not asked for longest
 * are forgotten first. */
typedef struct Recall Recall;

Recall *recall_create(void);
void recall_destroy(Recall *recall);

/* Finds the answer to a question. Returns false if none is kept that still holds; otherwise the track is new, for the
 * caller to clear, and the pins are filled in. */
bool recall_find(Recall *recall, const RecallQuestion *question, RecallAnswer *answer);

/* Begins to note what is read for a question: the search must use watch->space and watch->times. */
void recall_watch(RecallWatch *watch, const RecallQuestion *question);

/* Keeps a copy of an answer with what was read for it, and ends the watch. NULL: nothing is kept. */
void recall_keep(Recall *recall, const RecallQuestion *question, RecallWatch *watch, const RecallAnswer *answer);

#define RECALL_MOST_BYTES ((size_t)96 << 20)

/* Returns the number of questions that were answered so far by a kept answer. */
size_t recall_found(Recall *recall);
