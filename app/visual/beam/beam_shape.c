#include "visual/beam/beam_shape.h"

#include <math.h>
#include <string.h>

#include "base/memory.h"

enum { POINTS = 80 /* about this many make a smooth line */ };

static size_t node_count(const BeamShape *shape) {
    return shape->rig->modes.freedoms / 2;
}

/* Returns the points per element. */
static size_t piece_count(size_t nodes) {
    size_t elements = nodes - 1;
    return elements < POINTS ? (POINTS + elements - 1) / elements : 1;
}

BeamShape beam_shape_create(const Rig *rig) {
    BeamShape shape = {.rig = rig};
    size_t nodes = node_count(&shape), pieces = piece_count(nodes);
    shape.count = (nodes - 1) * pieces + 1;
    shape.place = memory_zeroed(shape.count, sizeof *shape.place);
    shape.deflection = memory_zeroed(shape.count, sizeof *shape.deflection);
    shape.state = memory_zeroed(rig->free.states, sizeof *shape.state);
    shape.freedoms = memory_zeroed(rig->modes.freedoms, sizeof *shape.freedoms);
    for (size_t i = 0; i < shape.count; i++) {
        const double *node = rig->modes.place + i / pieces;
        double part = (double)(i % pieces) / (double)pieces;
        shape.place[i] = part > 0 ? node[0] + part * (node[1] - node[0]) : node[0];
    }
    return shape;
}

void beam_shape_destroy(BeamShape *shape) {
    memory_free(shape->place);
    memory_free(shape->deflection);
    memory_free(shape->state);
    memory_free(shape->freedoms);
    *shape = (BeamShape){0};
}

/* Interpolates within the element from node `left` on: Hermite's cubic of the deflections and slopes at its ends. */
static double element_deflection_at(const BeamShape *shape, size_t left, double place) {
    const double *ends = shape->rig->modes.place + left, *w = shape->freedoms + 2 * left;
    double length = ends[1] - ends[0], s = (place - ends[0]) / length, r = 1 - s;
    return w[0] * r * r * (1 + 2 * s) + w[1] * length * s * r * r + w[2] * s * s * (1 + 2 * r) -
           w[3] * length * r * s * s;
}

void beam_shape_set(BeamShape *shape, const Motion *motion) {
    const Modes *modes = &shape->rig->modes;
    motion_state(motion, shape->state);
    memset(shape->freedoms, 0, modes->freedoms * sizeof *shape->freedoms);
    for (size_t i = 0; i < modes->count; i++) {
        double q = shape->state[i] / modes->frequency[i];
        for (size_t f = 0; f < modes->freedoms; f++)
            shape->freedoms[f] += q * modes->shape[i * modes->freedoms + f];
    }
    size_t nodes = node_count(shape), pieces = piece_count(nodes);
    for (size_t i = 0; i < shape->count; i++) {
        size_t node = i / pieces;
        shape->deflection[i] =
            node * pieces == i ? shape->freedoms[2 * node] : element_deflection_at(shape, node, shape->place[i]);
    }
}

double beam_shape_at(const BeamShape *shape, double place) {
    size_t left = 0;
    while (left + 2 < node_count(shape) && shape->rig->modes.place[left + 1] <= place)
        left++;
    return element_deflection_at(shape, left, place);
}

double beam_shape_reach(const BeamShape *shape) {
    double reach = 0;
    for (size_t i = 0; i < shape->count; i++)
        reach = fmax(reach, fabs(shape->deflection[i]));
    return reach;
}
