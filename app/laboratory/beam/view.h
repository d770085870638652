/* The running beam in the layers of a picture: what stays, and what moves. How much deflections are magnified is chosen
 * for the room that the record has for each cycle, so that it changes seldom and every time looks the same again. */
#pragma once

#include "visual/beam/beam_scene.h"
#include "laboratory/beam/tape.h"

typedef struct BeamView {
    Scene still, moving;
    unsigned parts; /* BEAM_SCENE_... */
    Camera camera;
    BeamSight sight; /* at the time that is shown */
    BeamScale scale;
    BeamShape shape;
    unsigned serial; /* of the part that is drawn; 0: nothing is */
} BeamView;

/* Moves to a recorded time. True: what stays is another picture. */
bool beam_view_show(BeamView *view, const BeamTape *tape, double time);

/* Makes the static layer again when the beam is displayed next. */
void beam_view_renew(BeamView *view);

void beam_view_close(BeamView *view);
