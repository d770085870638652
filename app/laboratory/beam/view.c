#include "laboratory/beam/view.h"

static bool same_joint(const BeamJoint *a, const BeamJoint *b) {
    return a->factor == b->factor && a->ground == b->ground;
}

static bool same_scale(const BeamScale *a, const BeamScale *b) {
    return a->parts == b->parts && a->stops == b->stops && same_joint(&a->joint[0], &b->joint[0]) &&
           same_joint(&a->joint[1], &b->joint[1]);
}

static void make_still(const BeamView *view, MachinePicture *picture, const Beam *beam) {
    Scene *still = machine_picture_begin(picture, beam_scene_box(&view->scale, true));
    beam_scene_magnified(still, &view->scale);
    beam_scene_still(still, beam, &view->scale);
}

/* Takes over the scale and the shape of a part and cycle. True: they have changed. */
static bool take_cycle(BeamView *view, MachinePicture *picture, const BeamPart *part, const BeamCycle *cycle) {
    BeamScale scale = beam_scene_scale(&part->beam, cycle->room.reach, cycle->room.tip_reach);
    scale.parts = picture->parts;
    if (picture->serial == part->serial && same_scale(&scale, &view->scale))
        return false;
    beam_shape_destroy(&view->shape);
    view->shape = beam_shape_create(&part->rig);
    view->scale = scale;
    picture->serial = part->serial;
    return true;
}

bool beam_view_show(BeamView *view, MachinePicture *picture, const BeamTape *tape, double time) {
    beam_tape_seek(tape, &view->sight, time);
    const Motion *motion = &view->sight.motion;
    const BeamPart *part = beam_tape_part(tape, view->sight.cycle);
    const BeamCycle *cycle = beam_tape_cycle(tape, view->sight.cycle);
    bool restarted = take_cycle(view, picture, part, cycle);
    if (restarted)
        make_still(view, picture, &part->beam);
    beam_shape_set(&view->shape, motion);
    BeamMoment moment = {.time = time,
                         .cycle = view->sight.cycle + 1,
                         .drive = part->beam.force * motion->now.sine,
                         .force = motion_force(motion),
                         .largest = cycle->room.force};
    for (int side = 0; side < 2; side++)
        moment.last[side] = view->sight.last[side].peak > 0 ? &view->sight.last[side] : NULL;
    scene_reset(&picture->moving);
    beam_scene_moving(&picture->moving, &part->beam, &view->scale, &view->shape, &moment);
    picture->moving.clock = NULL;
    return restarted;
}

void beam_view_close(BeamView *view) {
    beam_shape_destroy(&view->shape);
    beam_tape_close_sight(&view->sight);
}
