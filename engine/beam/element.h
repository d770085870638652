/* Finite elements of a straight beam in bending: Euler-Bernoulli, Hermite cubics, consistent mass.
 *
 * Each node has a deflection w (m) and a slope w' (rad); freedom 2 i is the deflection of node i, 2 i + 1 its slope.
 * For an element of length l, with EI the bending stiffness and m the mass per length,
 *
 *          EI  | 12   6l   -12  6l  |             ml  | 156   22l   54   -13l |
 *     K = ---- | 6l   4ll  -6l  2ll |        M = ---- | 22l   4ll   13l  -3ll |
 *         l^3  | -12  -6l  12   -6l |             420 | 54    13l   156  -22l |
 *              | 6l   2ll  -6l  4ll |                 | -13l  -3ll  -22l  4ll |
 *
 * so that the relative error of a natural frequency falls as (beta l)^4 / 1440 (beta^4 = omega^2 m / EI). */
#pragma once

#include <stddef.h>

typedef struct ElementMesh {
    size_t nodes, freedoms;             /* freedoms = 2 nodes */
    double *place;                      /* (nodes) m along the beam, ascending */
    double *mass, *stiffness, *damping; /* (freedoms x freedoms), symmetric */
} ElementMesh;

/* Meshes a beam of `length` (m), bending stiffness (N m2) and mass per length (kg/m) with at least `elements`
 * elements and a node at each of `count` stations (m, from 0 to the length, in any order); stations within 1e-9 of
 * the length coincide. An element of a fraction s of the length reduces the precision of the lowest frequencies to
 * about 1e-16 / s^3. element_clear releases the mesh. */
void element_build(ElementMesh *mesh, double length, double bending_stiffness, double mass_per_length, size_t elements,
                   const double *stations, size_t station_count);

void element_clear(ElementMesh *mesh);

/* Returns the deflection freedom of the node nearest to a place; the next freedom is its slope. */
size_t element_deflection(const ElementMesh *mesh, double place);

/* These add a mass (kg) or inertia (kg m2), a spring to ground (N/m or N m/rad), or a dashpot to ground (N s/m or N
 * m s/rad) to a freedom. */
void element_add_mass(ElementMesh *mesh, size_t freedom, double mass);
void element_add_spring(ElementMesh *mesh, size_t freedom, double stiffness);
void element_add_dashpot(ElementMesh *mesh, size_t freedom, double damping);
