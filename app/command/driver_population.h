/* The population of drivers that the command line asks for. */
#pragma once

#include "options/options.h"
#include "plan/population.h"

/* Reads the population of --population: an id of the shipped ones, or a file; "manual-jp" if none is named. Returns
 * false after an error. */
bool driver_population_read(Population *population, const Options *options, Fault *fault);
