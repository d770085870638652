/* The layers of a machine's picture, and those functions of a Laboratory that show them: their context is a
 * MachineSession, whose function `draw` draws the record at a time. */
#pragma once

#include "laboratory/laboratory.h"

typedef struct MachinePicture {
    Scene still, moving;
    Scene added;         /* always empty */
    unsigned parts, all; /* bits of the layers that are drawn, and of all that there are */
    Camera camera;
    unsigned serial; /* of the drawn part of the record; 0: none, and the static layer is drawn next time */
} MachinePicture;

/* Empties the static layer, which is drawn into this box, and returns it. */
Scene *machine_picture_begin(MachinePicture *picture, Box box);
void machine_picture_close(MachinePicture *picture);

bool machine_picture_show(void *context, double time);
void machine_picture_set_camera(void *context, Camera camera);
void machine_picture_set_layers(void *context, unsigned layers);
const Scene *machine_picture_still(void *context);
const Scene *machine_picture_added(const void *context);
const Scene *machine_picture_moving(const void *context);
