/* The running crank in the layers of a picture: static and moving. Magnifications follow from what was recorded up to
 * each revolution, so they change seldom, and every time always looks the same. */
#pragma once

#include "laboratory/crank/tape.h"
#include "laboratory/machine/picture.h"
#include "visual/crank/crank_scene.h"

typedef struct CrankView {
    CrankSight sight;
    CrankScale scale;
    double *values; /* (capacity) what came before the moment, for the loupe and the polar diagram */
    size_t capacity;
} CrankView;

/* Draws a recorded time into the picture. True: the static layer has changed. */
bool crank_view_show(CrankView *view, MachinePicture *picture, const CrankTape *tape, double time);

void crank_view_close(CrankView *view);
