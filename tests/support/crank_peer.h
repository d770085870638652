/* Integrates a slider crank step by step by CVODE with root-finding, as a reference for the turn. The right side is the
 * tree's; steps, switches and their location are CVODE's. */
#pragma once

#include "crank/turn.h"

typedef struct CrankPeer CrankPeer;

/* Starts at the tree's start; Adams' method with a relative and scaled `tolerance`. crank_peer_destroy releases it. */
CrankPeer *crank_peer_create(const Tree *tree, double tolerance);
void crank_peer_destroy(CrankPeer *peer);

/* Begins at time 0 with a state (2 x coordinates), in the place that the state determines. */
void crank_peer_set_state(CrankPeer *peer, const double *state);

/* Advances to a time, s since the start. */
void crank_peer_until(CrankPeer *peer, double time);
/* Advances to the end of the revolution. */
void crank_peer_cycle(CrankPeer *peer);
/* Advances to the next switch and returns its time, s, since the start. */
double crank_peer_switch(CrankPeer *peer);

const double *crank_peer_state(const CrankPeer *peer);
BallPlace crank_peer_place(const CrankPeer *peer);
size_t crank_peer_switches(const CrankPeer *peer);
size_t crank_peer_evaluations(const CrankPeer *peer);
