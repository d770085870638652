/* The tip of a beam between its stops, as primitives of a scene. */
#pragma once

#include "visual/beam/beam_scene.h"

/* Of the beam's length: how thick a stop is, and what holds it. */
#define BEAM_JOINT_DEPTH 0.011
#define BEAM_JOINT_GROUND 0.016

/* m of the drawing, where the tip's middle stands that is deflected by so many m. */
Vec2 beam_joint_tip(const BeamJoint *joint, double deflection);

/* What stays: what holds the stops; in the loupe also the size of the clearance. */
void beam_joint_still(Scene *scene, const Beam *beam, const BeamScale *scale, const BeamJoint *joint);

/* The stops, pressed out where the tip is in them, below the tip; and above it the force of an impact. */
void beam_joint_stops(Scene *scene, const Beam *beam, const BeamScale *scale, const BeamJoint *joint,
                      double deflection);
void beam_joint_contact(Scene *scene, const Beam *beam, const BeamScale *scale, const BeamJoint *joint,
                        double deflection, const BeamMoment *moment);
