/* Cranks for tests: the shipped one with settings, and its energy by an independent formula. */
#pragma once

#include "crank/turn.h"

/* Reads assets/cranks/ssc.json with settings, ended by NULL, which must be valid. */
Crank cranks_read(const char *const *settings);

/* Returns the tree of the shipped crank with settings, "NAME=VALUE,NAME=VALUE". */
Tree cranks_tree(const char *settings);

/* Returns the energy, J, of coupler, slider and bearing block in a state, by quadrature along the rod; gravity's is 0
 * at the guide, and the contact's spring is left out. */
double cranks_energy(const Tree *tree, const double *state);
/* Its kinetic part. */
double cranks_kinetic_energy(const Tree *tree, const double *state);
