#include "visual/beam/beam_joint.h"

#include "visual/machine/pieces.h"
#include "visual/beam/beam_text.h"

/* In beam lengths. */
#define SPRING_HALF 0.35 /* of half the length of a stop */
#define SPRING_PART 0.55 /* of a spring, from the stop to a force next to it */
#define DIMENSION_AT 0.056
#define DIMENSION_END 0.008
#define FORCE_MOST 0.115
#define BURST_MOST 0.040
#define SHAFT_HALF 0.008
#define TEXT_BESIDE 0.012
#define SMALL 0.55 /* 1, of the symbols at the beam, relative to those in the loupe */

/* Design points. */
#define NAME_TEXT 17.0
#define FORCE_TEXT 20.0
#define THIN 1.5
#define DIMENSION_WIDTH 2.0

Vec2 beam_joint_tip(const BeamJoint *joint, double deflection) {
    return vec2(joint->middle.x, joint->middle.y + joint->factor * deflection);
}

/* Returns the distance of an unloaded stop's face from the middle, m of the drawing. */
static double face_of(const BeamJoint *joint, const Beam *beam) {
    return joint->ball + joint->factor * beam->clearance;
}

/* Adds the distance to a stop, next to it. */
static void add_gap(Scene *scene, const Beam *beam, const BeamScale *scale, const BeamJoint *joint, int side) {
    double length = scale->length, x = joint->middle.x + DIMENSION_AT * length, end = x + DIMENSION_END * length;
    double rest = joint->middle.y + side * joint->ball, face = joint->middle.y + side * face_of(joint, beam);
    for (int i = 0; i < 2; i++) {
        double y = i ? face : rest;
        scene_add_line(scene, ROLE_DIM_TEXT, THIN, (Vec2[]){{joint->middle.x, y}, {end, y}}, 2)->style = LINE_DASHED;
    }
    scene_add_dimension(scene, ROLE_TEXT, DIMENSION_WIDTH, vec2(x, rest), vec2(x, face));
    Vec2 at = vec2(end, (rest + face) / 2), places[] = {at, vec2(end + length, at.y)};
    const char *text = beam->clearance < 1e-6 ? beam_text_quantity(scene, beam->clearance, "m")
                                              : scene_text(scene, "%.4g mm", 1000 * beam->clearance);
    Primitive *label = scene_add_label(scene, ROLE_TEXT, NAME_TEXT, at, text);
    scene_bind_label(scene, label, places, 2);
    label->bold = label->fixed = label->optional = true;
    label->apart = scale->loupe;
    if (side > 0 && beam->clearance >= 1e-6) /* once is enough where there is little room */
        label->brief = scene_text(scene, "%.4g", 1000 * beam->clearance);
}

void beam_joint_still(Scene *scene, const Beam *beam, const BeamScale *scale, const BeamJoint *joint) {
    Vec2 middle = joint->middle;
    for (int side = -1; side <= 1; side += 2) {
        double y = middle.y + side * joint->ground;
        machine_pieces_ground(scene, vec2(middle.x - 1.3 * joint->half, y), vec2(middle.x + 1.3 * joint->half, y),
                              side * BEAM_JOINT_GROUND * scale->length);
        if (joint->loupe && beam->clearance > 0)
            add_gap(scene, beam, scale, joint, side);
    }
    if (joint->loupe && beam->clearance == 0) {
        Vec2 at = vec2(middle.x + DIMENSION_AT * scale->length, middle.y), right = vec2(at.x + 1, at.y);
        Primitive *label = scene_add_label(scene, ROLE_TEXT, NAME_TEXT, at, "no clearance");
        scene_bind_label(scene, label, &right, 1);
        label->bold = label->fixed = true;
    }
}

void beam_joint_stops(Scene *scene, const Beam *beam, const BeamScale *scale, const BeamJoint *joint,
                      double deflection) {
    Vec2 middle = joint->middle;
    for (int side = -1; side <= 1; side += 2) {
        double face = joint->ball + joint->factor * fmax(beam->clearance, side * deflection);
        double back = face + BEAM_JOINT_DEPTH * scale->length;
        machine_pieces_spring(scene, vec2(middle.x, middle.y + side * back),
                              vec2(middle.x, middle.y + side * joint->ground), SPRING_HALF * joint->half);
        Box near = box_around(vec2(middle.x - joint->half, middle.y + side * face), 0);
        machine_pieces_block(scene, ROLE_WALL, box_include(near, vec2(middle.x + joint->half, middle.y + side * back)));
    }
}

/* Adds the present force of a stop, or its peak at the last touch, next to the stop. */
static void add_text(Scene *scene, const Beam *beam, const BeamScale *scale, const BeamJoint *joint,
                     const BeamMoment *moment, int side, bool touched) {
    const BeamImpact *last = moment->last[side > 0 ? 0 : 1];
    if (!touched && !last)
        return;
    double near = joint->middle.x + joint->half + TEXT_BESIDE * scale->length, far = near + scale->length;
    double beside = joint->middle.x + (DIMENSION_AT + DIMENSION_END) * scale->length;
    double face = face_of(joint, beam);
    double spring = joint->middle.y + side * (face + SPRING_PART * (joint->ground - face));
    double mount = joint->middle.y + side * joint->ground, first = touched ? near : beside;
    Vec2 outside = vec2((near + scale->loupe.high.x) / 2, side > 0 ? scale->loupe.high.y : scale->loupe.low.y);
    Vec2 right = vec2(touched ? scale->loupe.high.x : near, touched ? joint->middle.y : mount);
    double other = 2 * joint->middle.y - spring;
    Vec2 places[] = {{first, spring}, {far, spring},
                     {first, mount},  {far, mount},
                     outside,         {outside.x, outside.y + side * scale->length},
                     right,           {right.x + scale->length, right.y},
                     {first, other},  {far, other}};
    const char *text = touched ? beam_text_newtons(scene, fabs(moment->force), moment->largest)
                               : scene_text(scene, "last %s", beam_text_newtons(scene, last->peak, moment->largest));
    Primitive *label = scene_add_label(scene, ROLE_DIM_TEXT, touched ? FORCE_TEXT : NAME_TEXT, places[0], text);
    size_t count = sizeof places / sizeof *places;
    scene_bind_label(scene, label, places, touched ? count : count - 2);
    label->fixed = label->optional = true; /* a small picture has no room for it */
    label->apart = scale->loupe;
    if (touched) {
        label->bold = true;
        label->shape = LABEL_TAG;
        label->fill = ROLE_DANGER_MIDDLE;
    }
}

void beam_joint_contact(Scene *scene, const Beam *beam, const BeamScale *scale, const BeamJoint *joint,
                        double deflection, const BeamMoment *moment) {
    int side = moment->force < 0 ? 1 : -1;
    bool touched = moment->force != 0;
    if (touched) {
        double share = fabs(moment->force) / fmax(moment->largest, fabs(moment->force));
        double size = scale->length * (joint->loupe ? 1 : SMALL);
        Vec2 at = beam_joint_tip(joint, deflection);
        at.y += side * joint->ball;
        machine_pieces_star(scene, at, BURST_MOST * size * sqrt(share));
        machine_pieces_arrow(scene, ROLE_DANGER_MIDDLE, at, vec2(at.x, at.y - side * FORCE_MOST * size * share),
                             SHAFT_HALF * size);
    }
    for (int i = 0; i < 2 && joint->loupe; i++) /* the present force first */
        add_text(scene, beam, scale, joint, moment, i ? -side : side, touched && i == 0);
}
