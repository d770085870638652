/* A beam seen from the side as scenes, in metres of the drawing: along the beam a metre is a metre, across it only the
 * deflection is magnified, so that the bending is well seen. The tip in its clearance, which moves least, is shown once
 * more in a loupe, magnified further.
 *
 *                        drive                  ===             +---------------+  ground
 *                          v                    stop            |      ===      |  the contact's spring
 *     pivot  (@)===========|===================(tip)   --->     |      ---   :  |  stop
 *             z           [#]                   stop            |  ===( O )  :  |  clearance
 *            ===           z armature           ===             |      ---   :  |
 *                         === suspension                        |      ===      |
 *                                                               +---------------+                                  */
#pragma once

#include "beam/response.h"
#include "draw/scene.h"
#include "visual/beam/beam_record.h"

/* One of the two drawings of the joint: beside the beam, or in the loupe. */
typedef struct BeamJoint {
    Vec2 middle;   /* m, where the undeflected tip is */
    double factor; /* 1, the deflection is magnified by */
    double ball;   /* m, radius of the ball at the tip */
    double ground; /* m, from the middle to what holds the stops */
    double half;   /* m, of a stop's length */
    bool loupe;
} BeamJoint;

enum { BEAM_JOINTS = 2 };

/* What of it is drawn. */
enum {
    BEAM_SCENE_LOUPE = 1,
    BEAM_SCENE_FORCES = 2,
    BEAM_SCENE_NAMES = 4,
    BEAM_SCENE_SOURCES = 8, /* below each name its other numbers, and where they come from */
    BEAM_SCENE_ALL = 15,
};

/* How it is drawn. */
typedef struct BeamScale {
    unsigned parts;               /* BEAM_SCENE_...: all, unless the caller says otherwise */
    double length;                /* m, of the beam */
    double half;                  /* m, half of the beam's thickness, as drawn */
    bool to_scale;                /* the thickness is the beam's */
    bool stops;                   /* they are within the picture */
    BeamJoint joint[BEAM_JOINTS]; /* at the beam, whose deflection is magnified as here, and in the loupe */
} BeamScale;

/* For a beam whose points move by at most `reach` m, the tip by `tip_reach` m. */
BeamScale beam_scene_scale(const Beam *beam, double reach, double tip_reach);

/* The answer, the name and what must be said; `slow`: so many times slower, or 0 for a still picture. */
void beam_scene_labels(Scene *scene, const Beam *beam, const Rig *rig, const Response *response, const BeamScale *scale,
                       double slow);

/* What must be seen; `alone`: with nothing round it, where words below the loupe would find room. */
Box beam_scene_box(const BeamScale *scale, bool alone);

/* How much larger deflections are drawn, for a picture that has no words round it. */
void beam_scene_magnified(Scene *scene, const BeamScale *scale);

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
