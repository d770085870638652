/* The ball of the coupler in the socket of the crank: a clearance in space, one wall all round.
 *
 *     OPEN -(|d| = c, outwards)-> CONTACT -(F = 0)-> LEAVING -(|d| = c, inwards)-> OPEN
 *                                    ^------(F rises through 0)---'
 *
 * In contact the wall pushes the ball towards the socket's middle by F = k (|d| - c) + c_d |d|'. Released at zero
 * force, the spring has not yet recovered: the ball flies free inside the wall until it is out of it or is touched
 * again. Without a dashpot, or released at the gap, it is OPEN at once. Without clearance the joint is a spring and a
 * dashpot to both sides, F = -(k d + c_d d'), always.
 *
 * Friction, where there is any, acts at the ball's point R_b n: F_t = -mu F v / sqrt(v^2 + v_0^2), with its moment
 * about the ball's middle and, opposite, on the crank. v is the slip there, n = d / |d|. Both forces act at the two
 * centres, which are d apart: exact for F, some hundredths for the moment of friction. */
#pragma once

#include "crank/tree.h"

typedef enum BallPlace {
    BALL_OPEN,
    BALL_CONTACT,
    BALL_LEAVING,
} BallPlace;

/* What the joint does in a pose. */
typedef struct BallReading {
    double distance, rate; /* m, m/s: |d| and its rate */
    double push;           /* N, k (|d| - c) + c_d |d|', whether or not it acts; without clearance |k d + c_d d'| */
} BallReading;

BallReading ball_read(const Tree *tree, const TreePose *pose);

/* The same for d and d' (m, m/s). */
BallReading ball_read_vector(const Tree *tree, const double *apart, const double *apart_rate);

/* Computes the joint's force (N) and moment (N m) on the ball, in the world. */
void ball_push(const Tree *tree, const TreePose *pose, BallPlace place, double *force, double *moment);

/* Returns the place that a state of this reading is in. */
BallPlace ball_place(const Tree *tree, const BallReading *reading);
