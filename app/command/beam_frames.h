/* The pictures of a beam: beam.png, .svg and .pdf in --out, `--frames` and `--movie`. */
#pragma once

#include "beam/response.h"
#include "options/options.h"

/* Says on standard error what of the options does not go together, before anything is computed; 0 or an exit code. */
int beam_frames_check(const Options *options);

/* Writes what the options ask for, with progress on standard error when that is a terminal. Ctrl-C keeps what is
 * complete. False: said on standard error. */
bool beam_frames_write(const Beam *beam, const Rig *rig, const Response *response, const Options *options);
