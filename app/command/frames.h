/* `--frames`, `--movie` and the raised picture: draws a run by OpenGL without a screen, picture by picture. */
#pragma once

#include "options/options.h"
#include "visual/house/house_scene.h"
#include "report/report_motion.h"
#include "draw/scene.h"

/* True if the options ask for any of these pictures. */
bool frames_wanted(const Options *options);

/* Checks that the options fit together, before anything is simulated. Returns 0, or an exit code after an error on
 * standard error. */
int frames_check(const Options *options);

/* Facts beside the answer in each picture. */
typedef struct FramesFacts {
    const Grade *letters; /* (person_count), or NULL */
    const Scene *drivers; /* or NULL */
} FramesFacts;

/* Writes --out's frames/frame-00001.png and so on, the film, and with --view raised the last picture as raised.png,
 * with progress; `facts` are shown in each picture. Ctrl-C keeps complete files. False: an error was
 * printed. */
bool frames_write(const House *house, const Observation *observation, Before before, const FramesFacts *facts,
                  const Options *options);

/* Draws the end of the run in the raised view, without plots, in the theme paper; memory_free(picture->pixels). False:
 * an error was printed. */
bool frames_draw_raised(const House *house, const Observation *observation, const Options *options,
                        RaisedPicture *picture);
