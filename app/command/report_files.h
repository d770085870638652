/* Documents as files: what --report writes, report.html and report.pdf, and other pages. */
#pragma once

#include "options/options.h"
#include "exchange/observed.h"
#include "house/house.h"
#include "house/observation.h"
#include "report/report_basis.h"

/* Do --report, --out and --observed go together? Otherwise says so on standard error. */
bool report_files_possible(const Options *options);

/* Reads --observed, if there is one, and holds it against the house. False: the faults. */
bool report_files_read_observed(ObservedLoci *observed, const House *house, const Options *options, Fault *fault);

/* Writes what was asked for, after a run of `route` (SIZE_MAX: all) and after a comparison; says on standard error what
 * cannot be written. */
bool report_files_write_run(const House *house, const Observation *observation, const ObservedLoci *observed,
                            const Options *options, size_t route);
bool report_files_write_comparison(const House houses[2], const Observation observations[2], const Options *options);

/* The command line, to be pasted, line by line; memory_free it. */
char *report_files_command(const Options *options);

/* How a document of this command came about. */
Making report_files_making(const Options *options, const char *command);

/* Writes OUT/NAME.html and .pdf; says on standard error what cannot be written. */
bool report_files_write(const Document *document, const char *name, const Options *options);
