/* The slider crank, cut at its clearance: slider, universal joint and elastic coupler are an open tree, the bearing
 * block stands on its springs, the crank turns, and the joint's force closes the loop. Plain ordinary differential
 * equations.
 *
 * The coupler's frame R = Rz(alpha) Ry(beta) has e1 from the slider C to the ball B, e2 level, e3 across. A point of
 * the rod, xi from C, lies in that frame at
 *
 *     rho = (xi (1 + a / L), sum eta_n phi_n, sum zeta_n phi_n),   phi_n = sin(n pi xi / L).
 *
 * This is Craig and Bampton's reduction with the end's translation as its boundary, exact for a uniform slender rod:
 * constraint modes are the rotations alpha and beta and the stretch a, fixed-interface modes are the sines. The ball is
 * at l e1, l = L + a - sum (n pi)^2 / (4 L) (eta_n^2 + zeta_n^2): bending draws the ends together, and through that the
 * axial force stiffens or softens bending. The rod's own mass does not take part in that, consistently, so that energy
 * is conserved.
 *
 * Coordinates q, in this order: s, alpha, beta, [a], eta_1.., zeta_1.., u_x, u_y, u_z, [theta]; a state is (q, q').
 * theta, the crank's angle, is one of them only with a motor: J theta'' = kappa (Omega - theta') + m e g sin theta +
 * moment. Otherwise it is Omega t. u is counted from rest under weight. The centrifugal force of an unbalance on the
 * support is left out. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "base/real.h"
#include "crank/crank.h"

enum {
    TREE_SINES = 2 * CRANK_MODES_MOST, /* bending coordinates */
    TREE_ROD_MOST = 4 + TREE_SINES,    /* coordinates of slider and coupler */
    TREE_MOST = TREE_ROD_MOST + 4,     /* coordinates */
    TREE_STATES_MOST = 2 * TREE_MOST,
};

/* Constants of the equations. */
typedef struct Tree {
    size_t bending, axial;   /* modes in each plane; 0 or 1 */
    size_t rod, coordinates; /* slider and coupler; all */
    bool turns;              /* theta is a coordinate: with a motor */

    double length, mass; /* m, kg, of the rod */
    double end_mass, slider_mass;
    double slider_damping, universal_damping;
    double axial_stiffness, axial_damping;                                   /* N/m, N s/m */
    double sine_stiffness[CRANK_MODES_MOST], sine_damping[CRANK_MODES_MOST]; /* of eta_n and zeta_n */
    double mean[CRANK_MODES_MOST];                                           /* 1, c_n: mean of phi_n */
    double lever[CRANK_MODES_MOST];                                          /* 1, d_n: mean of phi_n xi / L */
    double slope[CRANK_MODES_MOST];                                          /* 1/m, phi_n' at the ball */
    double shortening[CRANK_MODES_MOST];                                     /* 1/m, (n pi)^2 / (2 L), or 0 */

    double support_mass, support_stiffness[3], support_damping[3];
    double radius, axis[3]; /* m, of the pin; place of the crank's axis at rest */
    double tilt_sine, tilt_cosine;
    double inertia, motor, unbalance_weight; /* kg m2, N m s/rad, N m */
    double omega, period;                    /* rad/s, s */
    double gravity;                          /* m/s2 */

    double clearance, stiffness, damping; /* m, N/m, N s/m */
    int release;                          /* CrankRelease */
    double start[3], start_velocity;      /* m, of the ball in its socket, in the rod's axes; m/s, of the slider */
    double friction, slip_speed, ball_radius;
} Tree;

Tree tree_of(const Crank *crank);

/* Natural frequencies, Hz, of bending mode n (from 0) of the coupler between its ends, and of the support along axis 0
 * to 2, without damping. */
double tree_bending_frequency(const Tree *tree, size_t n);
double tree_support_frequency(const Tree *tree, size_t axis);

/* The crank's pin. */
typedef struct TreePin {
    double at[3], rate[3]; /* m, m/s, without u */
    double arm[3];         /* m, d at / d theta */
} TreePin;

TreePin tree_pin(const Tree *tree, double theta, double theta_rate);

/* Where everything is: all that geometry says of a state. */
typedef struct TreePose {
    double theta, theta_rate;
    SineCosine alpha, beta;
    double along[3], across[3], up[3]; /* e1, e2, e3 in the world */
    double turn[3];                    /* rad/s, angular velocity in the rod's frame */
    double end_turn[2];                /* rad/s, by which bending turns the ball, about e2 and e3 */
    double span, span_rate;            /* m, m/s: l */
    double span_rest;                  /* m/s2, what l'' has beside a'' and the second derivatives of eta and zeta */
    double column[TREE_SINES];         /* 1, d l / d eta_n, then zeta_n */
    TreePin pin;
    double apart[3], apart_rate[3]; /* m, m/s: d = B - P in the world */
} TreePose;

/* Returns the pose of a state (2 x coordinates). `time` (s) gives the angle unless the crank turns by itself. */
TreePose tree_pose(const Tree *tree, double time, const double *state);

/* Computes the rates of the state (2 x coordinates) under a force (N) and a moment (N m) on the ball, in the world, of
 * which the opposites act on the crank. */
void tree_rates(const Tree *tree, const TreePose *pose, const double *state, const double *force, const double *moment,
                double *rates);

/* Computes d'', m/s2, from the pose and the rates of its state. */
void tree_apart_acceleration(const Tree *tree, const TreePose *pose, const double *rates, double *acceleration);

/* Returns the slider's place, m, of the rigid mechanism without clearance. */
double tree_ideal_slider(const Tree *tree, double theta);

/* Computes the state of the rigid mechanism without clearance at an angle (rad) and its rate; everything that bends is
 * straight and at rest. */
void tree_ideal(const Tree *tree, double theta, double theta_rate, double *state);

/* Computes the state at which the tree's crank starts: the ideal one at angle 0 and the drive's speed, the ball moved
 * in its socket and the slider faster as given. */
void tree_start(const Tree *tree, double *state);
