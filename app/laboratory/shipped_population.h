/* Reading the population that a command line or a house names. */
#pragma once

#include "plan/plan.h"
#include "plan/population.h"

/* Reads a population: an id of the shipped ones; or a file, a name with a / or ending in .json, relative to the folder
 * of the file `beside` (NULL: as it stands); "": manual-jp. Errors about the name begin with the place in `drivers`.
 * Returns false after an error. */
bool shipped_population_read(Population *population, const PlanDrivers *drivers, const char *beside, Fault *fault);
