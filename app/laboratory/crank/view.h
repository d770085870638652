/* The running crank in the layers of a picture: static and moving. Magnifications follow from what was recorded up to
 * each revolution, so they change seldom, and every time always looks the same. */
#pragma once

#include "laboratory/crank/tape.h"
#include "visual/crank/crank_scene.h"

typedef struct CrankView {
    Scene still, moving;
    unsigned parts; /* CRANK_SCENE_... */
    CrankSight sight;
    Camera camera;
    CrankScale scale;
    unsigned serial; /* of the drawn part; 0: none */
    double *values;  /* (capacity) what came before the moment, for the loupe and the polar diagram */
    size_t capacity;
} CrankView;

/* Moves to a recorded time. True: the static layer has changed. */
bool crank_view_show(CrankView *view, const CrankTape *tape, double time);

/* Rebuilds the static layer when the crank is displayed next. */
void crank_view_renew(CrankView *view);

void crank_view_close(CrankView *view);
