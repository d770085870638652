/* The plans of a house over time: the edits that were made while people moved in it. */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "base/memory.h"

/* A plan that applies from a time on. */
typedef struct HouseEpoch {
    double time; /* s; 0 for the first epoch */
    const char *text;
    uint64_t revision; /* revision of the draft with that text */
} HouseEpoch;

/* At least one epoch; a zeroed history is empty. */
typedef struct HouseHistory {
    HouseEpoch *at; /* (count) in order of time */
    size_t count;
    Arena arena;
} HouseHistory;

/* Starts a history with one plan. */
void house_history_begin(HouseHistory *history, const char *text, uint64_t revision);

/* Applies another plan from a time on, and removes later epochs. Nothing changes if the last plan before that time
 * is the same. */
void house_history_change(HouseHistory *history, double time, const char *text, uint64_t revision);

/* Copies the history into an arena. */
const HouseEpoch *house_history_copy(const HouseEpoch *epochs, size_t count, Arena *arena);

bool house_history_same(const HouseEpoch *a, size_t a_count, const HouseEpoch *b, size_t b_count);
void house_history_clear(HouseHistory *history);
