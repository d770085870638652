/* The pictures of a beam: beam.png, .svg and .pdf in --out, `--frames` and `--movie`. */
#pragma once

#include "beam/beam_cycle.h"
#include "exchange/measured.h"
#include "options/options.h"

/* Checks that the options fit together, before anything is computed. Returns 0, or an exit code after an error on
 * standard error. */
int beam_frames_check(const Options *options);

/* Writes the pictures and films that the options ask for, with progress. Ctrl-C keeps complete files. False: an error
 * was printed. */
bool beam_frames_write(const Beam *beam, const Rig *rig, const Response *response, const Options *options);

/* The plots that `run` of a beam writes to --out. */
typedef struct BeamFrames {
    PlotChoice plots;
    Measured measured; /* --measured, or empty */
} BeamFrames;

/* Reads the options for pictures and the measured points, before anything is computed. False: an error was printed on
 * standard error, and beam_frames_plots_end must not be called. */
bool beam_frames_plots_begin(BeamFrames *files, const Options *options);

/* Writes plot-NAME.png, .svg, .pdf and .csv to --out, if there is one. False: an error was printed. */
bool beam_frames_plots_write(const BeamFrames *files, const Response *response, const Beam *beam,
                             const Options *options);
void beam_frames_plots_end(BeamFrames *files);
