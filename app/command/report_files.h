/* Writes documents as files: report.html and report.pdf of --report, and other pages. */
#pragma once

#include "options/options.h"
#include "exchange/observed.h"
#include "house/house.h"
#include "house/observation.h"
#include "report/report_basis.h"
#include "report/report_drivers.h"

/* True if --report, --out and --observed fit together; otherwise an error was printed. */
bool report_files_possible(const Options *options);

/* Reads --observed, if there is one, and checks it against the house. False: errors were added to `fault`. */
bool report_files_read_observed(ObservedLoci *observed, const House *house, const Options *options, Fault *fault);

/* Writes the report that the options ask for, of a run of `route` (SIZE_MAX: all) or of a comparison. False: an error
 * was printed. */
bool report_files_write_run(const House *house, const Observation *observation, const ObservedLoci *observed,
                            const ReportedDrivers *drivers, const Options *options, size_t route);
bool report_files_write_comparison(const House houses[2], const Observation observations[2],
                                   const PairedDrivers *drivers, const Options *options);

/* Returns the command line as text that a shell reads back; memory_free it. */
char *report_files_command(const Options *options);

/* Returns the origin of a document: program, command and time. */
Making report_files_making(const Options *options, const char *command);

/* Writes OUT/NAME.html and .pdf. False: an error was printed. */
bool report_files_write(const Document *document, const char *name, const Options *options);
