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
    double *place;         /* (freedoms / 2) m along the beam, of the nodes, ascending */
    double *frequency;     /* (count) omega, rad/s, ascending */
    double *shape;         /* (count x freedoms) phi, 1/sqrt(kg), one mode after another */
    double *damping;       /* (count x count) 1/s: 2 zeta omega on the diagonal, and dashpots */
    double *tip, *shaker;  /* (count) phi at these places, 1/sqrt(kg) */
    double tip_compliance; /* m/N, static, of the finite-element mesh */
    double residual;       /* m/N, part of the compliance that the omitted modes carry */
} Modes;

/* Reduces a mesh to its `boundary` freedoms (boundary_count, each once) and `fixed` fixed-interface modes (fewer if
 * there are fewer) and stores the lowest `count` natural modes. Returns false, with nothing to clear, if the
 * eigenproblem has no solution. */
bool modes_reduce(Modes *modes, const ElementMesh *mesh, const size_t *boundary, size_t boundary_count, size_t fixed,
                  size_t count);

/* Computes the modes of a beam with its springs, masses, dashpots and damping. Returns false as above, or if the
 * beam is not supported. */
bool modes_of_beam(Modes *modes, const Beam *beam);

/* Gives the modes the signs at the tip that those of a similar beam have: a mode and its negative are one. */
void modes_align(Modes *modes, const Modes *like);

void modes_clear(Modes *modes);

/* Largest residual compliance as a fraction of the contact's own, 1/k; the contact stiffness has a relative error of
 * this size. */
#define MODES_RESIDUAL_MOST 0.01
