/* Which plan a house had from when on: what was edited while people were in it. */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "base/memory.h"

/* A plan from some time on. */
typedef struct HouseEpoch {
    double time; /* s; 0 of the first */
    const char *text;
    uint64_t revision; /* of the draft that has that text */
} HouseEpoch;

/* One epoch at least; zero is none yet. */
typedef struct HouseHistory {
    HouseEpoch *at; /* (count) in rising order */
    size_t count;
    Arena arena;
} HouseHistory;

/* One plan from the beginning on. */
void house_history_begin(HouseHistory *history, const char *text, uint64_t revision);

/* Another plan from a time on: what was to come after it is forgotten. Nothing changes when the last plan before then
 * is the same. */
void house_history_change(HouseHistory *history, double time, const char *text, uint64_t revision);

/* The same history, kept by an arena. */
const HouseEpoch *house_history_copy(const HouseEpoch *epochs, size_t count, Arena *arena);

bool house_history_same(const HouseEpoch *a, size_t a_count, const HouseEpoch *b, size_t b_count);
void house_history_clear(HouseHistory *history);
