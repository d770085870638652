/* A beam seen from the side as scenes, in metres of the drawing: lengths along the beam are true, deflections across
 * it are magnified, so that the bending is visible. The tip in its clearance, which moves least, is shown a second
 * time in a loupe, magnified further.
 *
 *                        drive                  ===             +---------------+  ground
 *                          v                    stop            |      ===      |  the contact's spring
 *     pivot  (@)===========|===================(tip)   --->     |      ---   :  |  stop
 *             z           [#]                   stop            |  ===( O )  :  |  clearance
 *            ===           z armature           ===             |      ---   :  |
 *                         === suspension                        |      ===      |
 *                                                               +---------------+                                  */
#pragma once

#include "beam/beam_cycle.h"
#include "draw/scene.h"
#include "visual/beam/beam_record.h"

/* One of the two drawings of the joint: at the beam, or in the loupe. */
typedef struct BeamJoint {
    Vec2 middle;   /* m, the position of the undeflected tip */
    double factor; /* 1, the magnification of the deflection */
    double ball;   /* m, radius of the ball at the tip */
    double ground; /* m, from the middle to the mounts of the stops */
    double half;   /* m, length of a stop */
    bool loupe;
} BeamJoint;

enum { BEAM_JOINTS = 2 };

/* The parts that are drawn. */
enum {
    BEAM_SCENE_LOUPE = 1,
    BEAM_SCENE_FORCES = 2,
    BEAM_SCENE_NAMES = 4,
    BEAM_SCENE_SOURCES = 8, /* below each name the other numbers of the part and their provenance */
    BEAM_SCENE_ALL = 15,
};

/* The style of the drawing. */
typedef struct BeamScale {
    unsigned parts;               /* BEAM_SCENE_...: all by default */
    double length;                /* m, of the beam */
    double half;                  /* m, half of the beam's drawn thickness */
    bool to_scale;                /* true if that is the beam's real thickness */
    bool stops;                   /* true if they are within the picture */
    BeamJoint joint[BEAM_JOINTS]; /* at the beam, magnified like the beam, and in the loupe */
    Box loupe;                    /* m, its frame: no text lies across it */
} BeamScale;

/* Makes the style for a beam whose points move by at most `reach` m, the tip by `tip_reach` m. */
BeamScale beam_scene_scale(const Beam *beam, double reach, double tip_reach);

/* Adds the answer, the name and the caveats; `slow`: the slow-motion factor, or 0 for a still picture. */
void beam_scene_labels(Scene *scene, const Beam *beam, const Rig *rig, const Response *response, const BeamScale *scale,
                       double slow);

/* Returns the box that must be visible; `alone`: without surroundings in which text below the loupe would have room. */
Box beam_scene_box(const BeamScale *scale, bool alone);

/* Adds the magnification of the deflection, for a picture without texts around it. */
void beam_scene_magnified(Scene *scene, const BeamScale *scale);

/* Adds the fixed part: grounds, rest line, the clearance's size, names. */
void beam_scene_still(Scene *scene, const Beam *beam, const BeamScale *scale);

/* The state at one moment. */
typedef struct BeamMoment {
    double time;               /* s, since the end of the transient */
    size_t cycle;              /* of the drive, from 1 */
    double drive;              /* N, the shaker's force, up */
    double force;              /* N, contact force on the tip, up */
    double largest;            /* N, the largest contact force of the record */
    const BeamImpact *last[2]; /* the last impacts on the upper and the lower side, or NULL */
} BeamMoment;

void beam_scene_moving(Scene *scene, const Beam *beam, const BeamScale *scale, const BeamShape *shape,
                       const BeamMoment *moment);
