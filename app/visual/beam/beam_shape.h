/* The bent beam: the deflection of each of its points, from the state of its modes, by the cubics of its elements. */
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

/* A beam at rest; the rig must outlive it. beam_shape_destroy releases it. */
BeamShape beam_shape_create(const Rig *rig);
void beam_shape_destroy(BeamShape *shape);

/* Makes it that of a motion. */
void beam_shape_set(BeamShape *shape, const Motion *motion);

/* m, the deflection at a place, m along the beam. */
double beam_shape_at(const BeamShape *shape, double place);

/* m, the largest deflection of any point, either way. */
double beam_shape_reach(const BeamShape *shape);
