#include "laboratory/machine/picture.h"

#include "laboratory/machine/session.h"

Scene *machine_picture_begin(MachinePicture *picture, Box box) {
    Scene *still = &picture->still;
    scene_reset(still);
    still->bare = still->unscaled = true;
    still->box = box;
    still->camera = picture->camera;
    return still;
}

void machine_picture_close(MachinePicture *picture) {
    scene_clear(&picture->still);
    scene_clear(&picture->moving);
}

bool machine_picture_show(void *context, double time) {
    MachineSession *session = context;
    session->shown = time;
    bool restarted = session->draw(session, time);
    if (restarted)
        session->news |= LABORATORY_VIEW;
    return !restarted;
}

void machine_picture_set_camera(void *context, Camera camera) {
    MachineSession *session = context;
    session->picture.camera = camera;
    session->picture.serial = 0;
    session->draw(session, session->shown);
    session->news |= LABORATORY_VIEW;
}

void machine_picture_set_layers(void *context, unsigned layers) {
    MachineSession *session = context;
    session->picture.parts = layers & session->picture.all;
    session->draw(session, session->shown);
    session->news |= LABORATORY_VIEW;
}

const Scene *machine_picture_still(void *context) {
    return &((const MachineSession *)context)->picture.still;
}

const Scene *machine_picture_added(const void *context) {
    return &((const MachineSession *)context)->picture.added;
}

const Scene *machine_picture_moving(const void *context) {
    return &((const MachineSession *)context)->picture.moving;
}
