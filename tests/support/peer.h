/* The same reduced beam, integrated step by step by CVODE with root-finding: what the exact motion is measured against.
 */
#pragma once

#include <stddef.h>

#include "beam/motion.h"

typedef struct Peer Peer;

/* From a state (omega q, q') at phase 0, outside the walls; Adams' method, `tolerance` relative. peer_destroy it. */
Peer *peer_create(const Rig *rig, const double *state, double tolerance);
void peer_destroy(Peer *peer);

/* Goes on to the end of the cycle. */
void peer_cycle(Peer *peer);

/* (2 n) sqrt(J) */
const double *peer_state(const Peer *peer);

/* Switches since the start. */
size_t peer_switches(const Peer *peer);
