/* Reading and running the house of a command line. */
#pragma once

#include "plan/population.h"
#include "options/options.h"
#include "house/house.h"
#include "house/observation.h"
#include "inquiry/grade.h"

/* Reads file `index` of the command line. False: errors were added to `fault`. */
bool house_file_read(House *house, const Options *options, size_t index, Fault *fault);

/* Prints every line of the fault on standard error, releases it and returns EXIT_WRONG_INPUT. */
int house_file_report(Fault *fault);

/* Runs the house as the options say, with progress. */
void house_file_run(Observation *observation, const House *house, const Options *options, size_t route);

/* Finds the letters of the grades that an answer tells without being asked: all are out, and they are few. `letters` is
 * (person_count), by memory_zeroed; NULL: none are told. Returns false, without letters, if interrupted. */
bool house_file_letters(Grade **letters, const House *house, const Observation *observation, const Options *options);

/* Returns how many drivers of a population to run: those of --drivers or, without it, those that the house asks for. */
size_t house_file_drivers(const Options *options, const Plan *plan);

/* Reads the population of --population or, without it, that of the house: an id of the shipped ones, or a file, which
 * the house names relative to its own folder; "manual-jp" if none is named. Returns false after an error. */
bool house_file_population(Population *population, const Options *options, const Plan *plan, Fault *fault);
