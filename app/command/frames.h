/* `--frames`, `--movie` and the raised picture: a run drawn by OpenGL without a screen, picture by picture. */
#pragma once

#include "options/options.h"
#include "visual/house/house_scene.h"
#include "report/report_motion.h"

/* Do the options ask for any of it? */
bool frames_wanted(const Options *options);

/* Says on standard error what of the options does not go together, before anything is simulated; 0 or an exit code. */
int frames_check(const Options *options);

/* Writes --out's frames/frame-00001.png and so on, the film, and with --view raised the last picture as raised.png,
 * with progress on standard error when that is a terminal. Ctrl-C keeps what is complete. False: said on standard
 * error. */
bool frames_write(const House *house, const Observation *observation, Before before, const Options *options);

/* Draws the end of the run in the raised view, the house alone, on paper; memory_free(picture->pixels). False: said on
 * standard error. */
bool frames_draw_raised(const House *house, const Observation *observation, const Options *options,
                        RaisedPicture *picture);
