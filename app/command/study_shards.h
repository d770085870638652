/* Studies over many machines: each runs one shard and keeps it in a file of its own in the common directory, then the
 * files are merged. */
#pragma once

#include "command/output.h"
#include "options/options.h"
#include "study/store.h"
#include "study/study.h"

/* Refuses options that contradict one another or have no effect; an error says which. */
bool study_shards_check(const Options *options, Fault *fault);

/* Writes the name of the file that keeps the results of this command: study.sqlite, or that of its shard. The numbers
 * of all shards have equally many digits, so that their files are listed in order. */
void study_shards_name(const Options *options, char name[OUTPUT_NAME]);

/* Takes the results of all shards in --out and prints what is missing. A file that cannot be used is told of on
 * standard error and left out. Returns 0; EXIT_OUR_FAULT if a run has two results, which `fault` names;
 * EXIT_WRONG_INPUT if there is nothing to merge. */
int study_shards_merge(const Options *options, Study *study, Store *store, Fault *fault);

/* Prints that the shard is done, or how far it is. Returns the exit code: that it is done is all that a scheduler needs
 * to know, whatever the answers of the runs. */
int study_shards_answer(const Options *options, const Study *study);

/* Prints a Slurm script, a line for GNU parallel, and how many runs a width of an interval needs. Returns the exit
 * code. */
int study_shards_print(const Options *options, const Study *study);
