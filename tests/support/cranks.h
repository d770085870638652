/* Cranks for tests: the shipped one with settings, and its energy by an independent formula. */
#pragma once

#include "crank/turn.h"

/* Settings of a crank that friction alone brakes, as a motor's crank whose motor's slope is set to 0; and its energy,
 * J, after 0.02 s from the angle 0.3 at 60 rad/s. */
#define CRANKS_RUBBING                                                                                                 \
    "drive.frequency=10,joint.clearance=1e-4,joint.damping=0,coupler.damping_ratio=0,crank.tilt=17.188733853924695,"   \
    "slider.damping=0,universal.damping=0,support.damping_ratio=0,drive.motor=1,joint.release=gap,joint.friction=0.1"
#define CRANKS_RUBBED 4.1940811787

/* Reads assets/cranks/ssc.json with settings, ended by NULL, which must be valid. */
Crank cranks_read(const char *const *settings);

/* Returns the tree of the shipped crank with settings, "NAME=VALUE,NAME=VALUE". */
Tree cranks_tree(const char *settings);

/* Returns the energy, J, of coupler, slider and bearing block in a state, by quadrature along the rod; gravity's is 0
 * at the guide, and the contact's spring is left out. */
double cranks_energy(const Tree *tree, const double *state);
/* Its kinetic part. */
double cranks_kinetic_energy(const Tree *tree, const double *state);

/* Returns that energy and those of a crank that turns freely and of the spring of a ball in contact. */
double cranks_whole_energy(const Tree *tree, const double *state, BallPlace place);
