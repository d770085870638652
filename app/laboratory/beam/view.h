/* The running beam in the layers of a picture: static and moving. The magnification of deflections follows from the
 * room that the record has for each cycle, so it changes seldom, and every time always looks the same. */
#pragma once

#include "visual/beam/beam_scene.h"
#include "laboratory/beam/tape.h"
#include "laboratory/machine/picture.h"

typedef struct BeamView {
    BeamSight sight; /* sight at the displayed time */
    BeamScale scale;
    BeamShape shape;
} BeamView;

/* Draws a recorded time into the picture. True: the static layer has changed. */
bool beam_view_show(BeamView *view, MachinePicture *picture, const BeamTape *tape, double time);

void beam_view_close(BeamView *view);
