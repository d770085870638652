/* Many drivers of a displayed house, computed after the nominal one: first a few, then all, as `run --drivers` does. */
#pragma once

#include "base/stop.h"
#include "draw/scene.h"
#include "experiment/drivers.h"

enum { CREW_STEPS = 2 /* 10 drivers, then 100 */ };

/* The drivers of one step, as the window shows them. */
typedef struct Crew {
    size_t count;      /* of drivers */
    uint64_t digest;   /* of their times and impacts */
    Scene scene;       /* band of paths and discs of touches */
    const char **said; /* (person_count) a line for each person, in the scene's arena; NULL: not of the population */
    size_t person_count;
} Crew;

/* Returns the number of drivers of a step: at last as many as the plan asks for, or 100. */
size_t crew_size(int step, const Plan *plan);

/* Runs the nominal driver and the drivers of a step. Returns false, with an empty crew, if it was stopped or, with a
 * fault, if the population cannot be read. crew_clear releases it. */
bool crew_make(Crew *crew, int step, const House *house, size_t route, int jobs, const Stop *stop, Fault *fault);
void crew_clear(Crew *crew);

/* Returns a digest of what drivers do: equal for equal bits. */
uint64_t crew_digest(const Drivers *drivers);
