/* Where and how hard a run, or many drivers, touch something, as rows. */
#pragma once

#include "experiment/danger.h"
#include "result/result.h"

/* Adds the places of a person to a table, one record each, worst first, at most RESULT_DANGER_MOST of them. */
void result_danger_add(ResultTable *table, const House *house, size_t person, const Danger *danger);

enum { RESULT_DANGER_MOST = 20 };

/* The places of all people: those that the drivers of a population touch, or without drivers (NULL) those of the run.
 */
ResultTable result_danger_places(const House *house, const Observation *observation, const Drivers *drivers);

/* The limits that the speeds, forces and energies are to be read beside, with their sources; the speeds at which a
 * chair of `mass` kg reaches them. */
ResultTable result_danger_limits(double mass);

/* Returns "a knock at 0.21 m/s", in the arena. */
const char *result_danger_words(double speed, Arena *arena);
