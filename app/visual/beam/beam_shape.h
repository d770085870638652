/* The bent beam: the deflection at points along it, from the state of its modes, by the cubics of its elements. */
#pragma once

#include <stddef.h>

#include "beam/motion.h"

typedef struct BeamShape {
    const Rig *rig;
    size_t count;       /* points, from end to end */
    double *place;      /* (count) m along the beam, rising */
    double *deflection; /* (count) m, up */
    double *state;      /* (states) sqrt(J) */
    double *freedoms;   /* (freedoms) m and rad, of the nodes */
} BeamShape;

/* Makes a beam at rest; the rig must outlive it. beam_shape_destroy releases it. */
BeamShape beam_shape_create(const Rig *rig);
void beam_shape_destroy(BeamShape *shape);

/* Sets the shape of a motion. */
void beam_shape_set(BeamShape *shape, const Motion *motion);

/* Returns the deflection, m, at a place, m along the beam. */
double beam_shape_at(const BeamShape *shape, double place);

/* Returns the largest deflection of any point, m, of either sign. */
double beam_shape_reach(const BeamShape *shape);
