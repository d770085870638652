/* The record of each shake in a study of earthquakes: observables behind those that every run of a house has.
 *
 *     out.ID      1: the person is out, or the share of the crowd's members who are
 *     time.ID     s, until all of them are out
 *     toppled.ID  1: the piece of furniture fell in this shake
 *     blocks.ID   people whom the piece stops, those caught under it among them
 *     elsewhere   people who are stopped by something else: a wall, a door, other people
 *     caught      people on whom something fell
 *
 * A piece stops somebody when it is what has fallen next to the place where they stick, within the width that they
 * would need there; when nothing has, when it is what the place is called after. */
#pragma once

#include "house/house.h"
#include "house/observation.h"
#include "study/experiment.h"

/* Indices among the experiment's observables. */
typedef struct ShakeRecord {
    size_t party_count; /* people of the plan, then crowds */
    size_t piece_count;
    size_t out, time;       /* index for the first party; the others follow */
    size_t toppled, blocks; /* index for the first piece */
    size_t elsewhere, caught;
    size_t count; /* number of all observables */
} ShakeRecord;

/* Describes a record behind the first `usual` observables. */
ShakeRecord shake_record_of(const Plan *plan, size_t usual);

/* Describes the shake observables in (count); texts live in the arena. */
void shake_record_describe(const ShakeRecord *record, const Plan *plan, Observable *observables, Arena *arena);

/* Fills the observables of a house, in whose plan `before` nothing had fallen. */
void shake_record_observe(const ShakeRecord *record, const Plan *before, const House *house,
                          const Observation *observation, double *observed);
