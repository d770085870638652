/* The running beam in the layers of a picture: static and moving. The magnification of deflections follows from the
 * room that the record has for each cycle, so it changes seldom, and every time always looks the same. */
#pragma once

#include "visual/beam/beam_scene.h"
#include "laboratory/beam/tape.h"

typedef struct BeamView {
    Scene still, moving;
    unsigned parts; /* BEAM_SCENE_... */
    Camera camera;
    BeamSight sight; /* sight at the displayed time */
    BeamScale scale;
    BeamShape shape;
    unsigned serial; /* serial of the drawn part; 0: none */
} BeamView;

/* Moves to a recorded time. True: the static layer has changed. */
bool beam_view_show(BeamView *view, const BeamTape *tape, double time);

/* Rebuilds the static layer when the beam is displayed next. */
void beam_view_renew(BeamView *view);

void beam_view_close(BeamView *view);
