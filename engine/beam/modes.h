/* Natural modes of a beam by component mode synthesis.
 *
 * Craig and Bampton (1968): the freedoms are split into boundary and interior; the reduced coordinates are the boundary
 * freedoms themselves, each with the shape that the beam takes statically (constraint modes), and the lowest natural
 * modes with the boundary held (fixed-interface modes). The reduced masses and stiffnesses are then diagonalised once
 * more, so that the free beam is a set of single oscillators
 *
 *     q_i'' + 2 zeta omega_i q_i' + omega_i^2 q_i = phi_i(shaker) F sin(omega t) - phi_i(tip) R,
 *
 * R the force of the joint, phi mass-normalised. A dashpot on the beam couples them: row and column of `damping`. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "beam/beam.h"
#include "beam/element.h"

typedef struct Modes {
    size_t count, freedoms;
    double *place;         /* (freedoms / 2) m along the beam, of the nodes, rising */
    double *frequency;     /* (count) omega, rad/s, rising */
    double *shape;         /* (count x freedoms) phi, 1/sqrt(kg), a mode after the other */
    double *damping;       /* (count x count) 1/s: 2 zeta omega on the diagonal, and dashpots */
    double *tip, *shaker;  /* (count) phi there, 1/sqrt(kg) */
    double tip_compliance; /* m/N, static, of the elements */
    double residual;       /* m/N, the part of it that the modes left out would have had */
} Modes;

/* The natural modes of a mesh reduced to its `boundary` freedoms (boundary_count, each once) and `fixed`
 * fixed-interface modes (or as many as there are); the lowest `count` are kept. False: LAPACK found no modes, and
 * nothing is kept. */
bool modes_reduce(Modes *modes, const ElementMesh *mesh, const size_t *boundary, size_t boundary_count, size_t fixed,
                  size_t count);

/* The modes of a beam, its springs, masses and dashpots on it, damped as it says. False: as above, or nothing holds
 * it. */
bool modes_of_beam(Modes *modes, const Beam *beam);

void modes_clear(Modes *modes);

/* How large the compliance that the modes lack may be beside the contact's own, 1/k: beyond it, a contact is too
 * soft or too stiff by that much. */
#define MODES_RESIDUAL_MOST 0.01
