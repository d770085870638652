/* The pictures that `run` of a beam writes to --out. */
#pragma once

#include "beam/beam_cycle.h"
#include "options/options.h"
#include "exchange/measured.h"

typedef struct BeamFiles {
    PlotChoice plots;
    Measured measured; /* --measured, or empty */
} BeamFiles;

/* Reads the options for pictures and the measured points, before anything is computed. False: an error was printed on
 * standard error, and beam_files_end must not be called. */
bool beam_files_begin(BeamFiles *files, const Options *options);

/* Writes plot-NAME.png, .svg, .pdf and .csv to --out, if there is one. False: an error was printed. */
bool beam_files_write(const BeamFiles *files, const Response *response, const Beam *beam, const Options *options);
void beam_files_end(BeamFiles *files);
