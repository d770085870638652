/* The pictures of a beam: beam.png, .svg and .pdf in --out, `--frames` and `--movie`. */
#pragma once

#include "beam/beam_cycle.h"
#include "options/options.h"

/* Checks that the options fit together, before anything is computed. Returns 0, or an exit code after an error on
 * standard error. */
int beam_frames_check(const Options *options);

/* Writes the pictures and films that the options ask for, with progress. Ctrl-C keeps complete files. False: an error
 * was printed. */
bool beam_frames_write(const Beam *beam, const Rig *rig, const Response *response, const Options *options);
