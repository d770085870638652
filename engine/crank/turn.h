/* The motion of a slider crank, revolution by revolution: steps of order 8 from switch to switch of its joint.
 *
 * Within a place of the ball the equations are smooth. On each step the ball's path in its socket is known to fifth
 * order (place, velocity and acceleration at both ends): switches are first found on it, then the step is repeated to
 * the instant and corrected until |F| or k |gap| is below 1e-9 N; the largest force of a contact is located likewise. A
 * revolution ends at theta = 0 mod 2 pi. At a touch the force jumps by c_d |d|'; the state does not.
 *
 * A motion has diverged when a number is infinite or NaN, or when the coupler's bending or stretch changes its length
 * by a tenth, which small bending does not describe. It is too stiff when a revolution takes so many steps that it
 * would not end, or when it has taken all the work that it may.
 *
 * A turn is a plain value: an assignment copies it, and the copy goes on with the same bits. */
#pragma once

#include "crank/ball.h"
#include "cycle/cycle.h"

enum {
    TURN_SWITCHES_MOST = 5000, /* in a revolution: the motion stops there */
    TURN_PERIODS_MOST = 100,   /* until a motor that has not completed its revolution counts as diverged */
};

/* Tolerances: for answers, and for sweeps and the window. */
#define TURN_FINE 1e-8
#define TURN_QUICK 1e-6

/* The ball in its socket at one instant. */
typedef struct TurnBall {
    double apart[3], rate[3], second[3]; /* m, m/s, m/s2: d and its derivatives in the world */
} TurnBall;

typedef struct Turn {
    const Tree *tree;
    double tolerance; /* 1, of one step's scaled error */
    double scale[TREE_STATES_MOST];
    CycleStatus status;
    BallPlace place;
    size_t cycle; /* revolutions since the start */
    double time;  /* s, since the revolution began */
    double past;  /* s, of the revolutions before it */
    double state[TREE_STATES_MOST], rates[TREE_STATES_MOST];
    TurnBall ball;
    double step;        /* s, proposed */
    size_t cycle_steps; /* tried in this revolution */
    double steps_most;  /* in a revolution, until it counts as too stiff */

    size_t switches, cycle_switches; /* since the start; in this revolution */
    size_t touches;                  /* since the start */
    size_t evaluations;              /* of the right side, since the start */
    size_t evaluations_most;         /* until it counts as too stiff; 0: any number */
    double contact_time;             /* s, since the start */
    double peak[CYCLE_SIDES];        /* N, largest force since it was last reset; the second is 0: one wall all round */
    bool unwatched;                  /* the peak is not located, which saves time */
    const Stop *stop;                /* polled within a revolution; NULL: it is not */
} Turn;

/* Returns a turn at the start of the tree's crank, see tree_start. */
Turn turn_create(const Tree *tree, double tolerance);

/* Begins a revolution with a state (2 x coordinates), in the place that the state determines. */
void turn_set_state(Turn *turn, const double *state);

/* Begins a revolution where a turn ended one: its state, place and proposed step (s). It continues with the same bits.
 */
void turn_restore(Turn *turn, const double *state, BallPlace place, double step);

/* Advances to the next switch, to the end of a step, to the end of the revolution or by `longest` s, whichever is
 * first; returns the elapsed time. */
double turn_step(Turn *turn, double longest);

/* Advances to the end of the revolution. */
CycleStatus turn_cycle(Turn *turn);

/* Returns the joint's force on the ball, N, at least 0. */
double turn_force(const Turn *turn);

/* Returns the pose of the present state. */
TreePose turn_pose(const Turn *turn);
