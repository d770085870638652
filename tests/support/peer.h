/* Integrates the same reduced beam step by step by CVODE with root-finding, as a reference for the exact motion. */
#pragma once

#include <stddef.h>

#include "beam/motion.h"

typedef struct Peer Peer;

enum { PEER_STATES_MOST = 128 };

/* Starts at a state (omega q, q') at phase 0, outside the walls; Adams' method, relative `tolerance`. peer_destroy
 * releases the result. */
Peer *peer_create(const Rig *rig, const double *state, double tolerance);
void peer_destroy(Peer *peer);

/* Advances to the end of the cycle. */
void peer_cycle(Peer *peer);

/* (2 n) sqrt(J) */
const double *peer_state(const Peer *peer);

/* N, the largest force of the last cycle, located where its rate is 0; 0: no contact */
double peer_peak(const Peer *peer);

/* Goes on from any state (omega q, q') at the end of so many cycles. */
void peer_move(Peer *peer, const double *state, size_t cycle);

/* Returns the number of switches since the start. */
size_t peer_switches(const Peer *peer);
