/* The pictures that `run` of a beam leaves in --out. */
#pragma once

#include "beam/response.h"
#include "options/options.h"
#include "exchange/measured.h"

typedef struct BeamFiles {
    PlotChoice plots;
    Measured measured; /* --measured, or empty */
} BeamFiles;

/* Takes what the options say of pictures and reads the measured points, before anything is computed. False: said on
 * standard error, and there is nothing to end. */
bool beam_files_begin(BeamFiles *files, const Options *options);

/* Writes plot-NAME.png, .svg, .pdf and .csv to --out, if there is one. False: said on standard error. */
bool beam_files_write(const BeamFiles *files, const Response *response, const Beam *beam, const Options *options);
void beam_files_end(BeamFiles *files);
