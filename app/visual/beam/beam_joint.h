/* The tip of a beam between its stops, as primitives of a scene. */
#pragma once

#include "visual/beam/beam_scene.h"

/* In beam lengths: the thickness of a stop, and of its mount. */
#define BEAM_JOINT_DEPTH 0.011
#define BEAM_JOINT_GROUND 0.016

/* Returns the position of a tip deflected by this many m, m of the drawing. */
Vec2 beam_joint_tip(const BeamJoint *joint, double deflection);

/* Adds the fixed part: the mounts of the stops; in the loupe also the size of the clearance. */
void beam_joint_still(Scene *scene, const Beam *beam, const BeamScale *scale, const BeamJoint *joint);

/* Adds the stops, displaced where the tip presses them, below the tip; and above it the force of an impact. */
void beam_joint_stops(Scene *scene, const Beam *beam, const BeamScale *scale, const BeamJoint *joint,
                      double deflection);
void beam_joint_contact(Scene *scene, const Beam *beam, const BeamScale *scale, const BeamJoint *joint,
                        double deflection, const BeamMoment *moment);
