/* A beam seen from the side as scenes, in metres of the drawing: along the beam a metre is a metre, across it only the
 * deflection is magnified, so that the clearance is well seen.
 *
 *                                      drive                           === ground
 *                                        ^                              z  the contact's spring
 *       pivot  (@)=======================|===========================  ---  stop
 *               z                       [#]                          (O)  clearance, magnified
 *              ===                       z  armature, suspension     ---
 *                                       ===                           z
 *                                                                    ===                                           */
#pragma once

#include "beam/response.h"
#include "draw/scene.h"
#include "laboratory/beam_record.h"

/* How it is drawn. */
typedef struct BeamScale {
    double length; /* m, of the beam */
    double factor; /* 1, the deflection is magnified by */
    double half;   /* m, half of the beam's thickness, as drawn */
    double ball;   /* m, radius of the ball at the tip */
    double gap;    /* m, the clearance, magnified */
    bool to_scale; /* the thickness is the beam's */
    bool stops;    /* they are within the picture */
} BeamScale;

/* For a beam whose points move by at most `reach` m. */
BeamScale beam_scene_scale(const Beam *beam, double reach);

/* m of the drawing, where the tip stands that is deflected by so many m. */
Vec2 beam_scene_tip(const BeamScale *scale, double deflection);

/* The answer, the name and what must be said; `slow`: so many times slower, or 0 for a still picture. */
void beam_scene_words(Scene *scene, const Beam *beam, const Rig *rig, const Response *response, const BeamScale *scale,
                      double slow);

/* What stays: grounds, rest line, the clearance's size, names. */
void beam_scene_still(Scene *scene, const Beam *beam, const BeamScale *scale);

/* What is there at one moment. */
typedef struct BeamMoment {
    double time;               /* s, since the end of the transient */
    size_t cycle;              /* of the drive, from 1 */
    double drive;              /* N, the shaker's force, up */
    double force;              /* N, of the joint on the tip, up */
    double largest;            /* N, that the joint's force ever is */
    const BeamImpact *last[2]; /* the last impacts on the upper and the lower side, or NULL */
} BeamMoment;

void beam_scene_moving(Scene *scene, const Beam *beam, const BeamScale *scale, const BeamShape *shape,
                       const BeamMoment *moment);
