#include "peer.h"

#include <cvode/cvode.h>
#include <math.h>
#include <nvector/nvector_serial.h>
#include <stdio.h>
#include <stdlib.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include "base/memory.h"

struct Peer {
    const Rig *rig;
    MotionPlace place;
    SUNContext context;
    N_Vector state;
    SUNNonlinearSolver solver;
    void *cvode;
    size_t cycle, switches;
};

static void must(bool good) {
    if (good)
        return;
    fprintf(stderr, "CVODE failed\n");
    exit(1);
}

static double wall_of(MotionPlace place) {
    return place == MOTION_UPPER || place == MOTION_UPPER_LEAVING ? 1 : -1;
}

/* Returns the tip's depth in the wall, m, and the contact law's force there, N. */
static double push_of(const Peer *peer, const double *x, double *depth) {
    const Rig *rig = peer->rig;
    size_t n = rig->modes.count;
    double deflection = 0, velocity = 0;
    for (size_t i = 0; i < n; i++) {
        deflection += rig->modes.tip[i] * x[i] / rig->modes.frequency[i];
        velocity += rig->modes.tip[i] * x[n + i];
    }
    *depth = wall_of(peer->place) * deflection - rig->clearance;
    return rig->stiffness * *depth + rig->damping * wall_of(peer->place) * velocity;
}

static int rates(realtype time, N_Vector state, N_Vector rate, void *data) {
    const Peer *peer = data;
    const Modes *modes = &peer->rig->modes;
    size_t n = modes->count;
    const double *x = N_VGetArrayPointer(state);
    double *out = N_VGetArrayPointer(rate), depth, drive = peer->rig->force * sin(peer->rig->omega * time);
    double push = push_of(peer, x, &depth);
    double tip = motion_in_contact(peer->place) ? -wall_of(peer->place) * push : 0;
    for (size_t i = 0; i < n; i++) {
        out[i] = modes->frequency[i] * x[n + i];
        out[n + i] = -modes->frequency[i] * x[i] + modes->shaker[i] * drive + modes->tip[i] * tip;
        for (size_t j = 0; j < n; j++)
            out[n + i] -= modes->damping[i * n + j] * x[n + j];
    }
    return 0;
}

/* Each function rises through 0 at a switch; released at zero force. */
static int roots(realtype time, N_Vector state, realtype *out, void *data) {
    (void)time;
    const Peer *peer = data;
    double depth, push = push_of(peer, N_VGetArrayPointer(state), &depth);
    switch (peer->place) {
    case MOTION_OPEN:
        out[1] = depth; /* of the lower wall: wall_of */
        out[0] = -depth - 2 * peer->rig->clearance;
        break;
    case MOTION_UPPER:
    case MOTION_LOWER:
        out[0] = -push;
        out[1] = -1;
        break;
    default:
        out[0] = push;
        out[1] = -depth;
        break;
    }
    return 0;
}

Peer *peer_create(const Rig *rig, const double *state, double tolerance) {
    Peer *peer = memory_zeroed(1, sizeof *peer);
    peer->rig = rig;
    must(SUNContext_Create(NULL, &peer->context) == 0);
    peer->state = N_VNew_Serial((sunindextype)rig->free.states, peer->context);
    for (size_t i = 0; i < rig->free.states; i++)
        N_VGetArrayPointer(peer->state)[i] = state[i];
    peer->cvode = CVodeCreate(CV_ADAMS, peer->context);
    must(CVodeInit(peer->cvode, rates, 0, peer->state) == CV_SUCCESS);
    must(CVodeSStolerances(peer->cvode, tolerance, tolerance * 1e-3) == CV_SUCCESS);
    peer->solver = SUNNonlinSol_FixedPoint(peer->state, 0, peer->context);
    must(CVodeSetNonlinearSolver(peer->cvode, peer->solver) == CV_SUCCESS);
    must(CVodeSetUserData(peer->cvode, peer) == CV_SUCCESS);
    must(CVodeRootInit(peer->cvode, 2, roots) == CV_SUCCESS);
    must(CVodeSetRootDirection(peer->cvode, (int[]){1, 1}) == CV_SUCCESS);
    CVodeSetNoInactiveRootWarn(peer->cvode);
    CVodeSetMaxNumSteps(peer->cvode, 1000000);
    return peer;
}

void peer_destroy(Peer *peer) {
    CVodeFree(&peer->cvode);
    SUNNonlinSolFree(peer->solver);
    N_VDestroy(peer->state);
    SUNContext_Free(&peer->context);
    memory_free(peer);
}

static MotionPlace next_place(MotionPlace place, bool first) {
    switch (place) {
    case MOTION_OPEN:
        return first ? MOTION_UPPER : MOTION_LOWER;
    case MOTION_UPPER:
        return MOTION_UPPER_LEAVING;
    case MOTION_LOWER:
        return MOTION_LOWER_LEAVING;
    case MOTION_UPPER_LEAVING:
        return first ? MOTION_UPPER : MOTION_OPEN;
    default:
        return first ? MOTION_LOWER : MOTION_OPEN;
    }
}

void peer_cycle(Peer *peer) {
    double end = (double)++peer->cycle * peer->rig->period, time = 0;
    while (time < end) {
        int which[2], done = CVode(peer->cvode, end, peer->state, &time, CV_NORMAL);
        must(done >= 0);
        if (done != CV_ROOT_RETURN)
            return;
        CVodeGetRootInfo(peer->cvode, which);
        peer->place = next_place(peer->place, which[0] != 0);
        peer->switches++;
        must(CVodeReInit(peer->cvode, time, peer->state) == CV_SUCCESS);
    }
}

const double *peer_state(const Peer *peer) {
    return N_VGetArrayPointer(peer->state);
}

size_t peer_switches(const Peer *peer) {
    return peer->switches;
}
