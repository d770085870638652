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
    double peak; /* N */
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

static void find_rates(const Peer *peer, double time, const double *x, double *out) {
    const Modes *modes = &peer->rig->modes;
    size_t n = modes->count;
    double depth, drive = peer->rig->force * sin(peer->rig->omega * time);
    double push = push_of(peer, x, &depth);
    double tip = motion_in_contact(peer->place) ? -wall_of(peer->place) * push : 0;
    for (size_t i = 0; i < n; i++) {
        out[i] = modes->frequency[i] * x[n + i];
        out[n + i] = -modes->frequency[i] * x[i] + modes->shaker[i] * drive + modes->tip[i] * tip;
        for (size_t j = 0; j < n; j++)
            out[n + i] -= modes->damping[i * n + j] * x[n + j];
    }
}

static int rates(realtype time, N_Vector state, N_Vector rate, void *data) {
    find_rates(data, time, N_VGetArrayPointer(state), N_VGetArrayPointer(rate));
    return 0;
}

/* Returns the rate at which the contact law's force changes, N/s. */
static double push_rate(const Peer *peer, double time, const double *x) {
    double rate[PEER_STATES_MOST], depth;
    find_rates(peer, time, x, rate);
    return push_of(peer, rate, &depth) + peer->rig->stiffness * peer->rig->clearance; /* it is linear but for that */
}

/* Each of the first two functions rises through 0 at a switch; released at zero force. The third one does where the
 * force is greatest. */
static int roots(realtype time, N_Vector state, realtype *out, void *data) {
    const Peer *peer = data;
    const double *x = N_VGetArrayPointer(state);
    double depth, push = push_of(peer, x, &depth);
    out[2] = motion_in_contact(peer->place) ? -push_rate(peer, time, x) : -1;
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
    must(CVodeRootInit(peer->cvode, 3, roots) == CV_SUCCESS);
    must(CVodeSetRootDirection(peer->cvode, (int[]){1, 1, 1}) == CV_SUCCESS);
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

static void note_push(Peer *peer) {
    double depth, push = push_of(peer, N_VGetArrayPointer(peer->state), &depth);
    if (motion_in_contact(peer->place) && push > peer->peak)
        peer->peak = push;
}

void peer_cycle(Peer *peer) {
    double end = (double)++peer->cycle * peer->rig->period, time = 0;
    peer->peak = 0;
    note_push(peer);
    while (time < end) {
        int which[3], done = CVode(peer->cvode, end, peer->state, &time, CV_NORMAL);
        must(done >= 0);
        if (done != CV_ROOT_RETURN)
            return;
        CVodeGetRootInfo(peer->cvode, which);
        if (which[2])
            note_push(peer);
        if (!which[0] && !which[1])
            continue;
        peer->place = next_place(peer->place, which[0] != 0);
        peer->switches++;
        if (peer->rig->damping == 0 && peer->place != MOTION_OPEN && !motion_in_contact(peer->place))
            peer->place = MOTION_OPEN; /* the force is 0 where the tip leaves the wall: it never flies free inside */
        note_push(peer);
        must(CVodeReInit(peer->cvode, time, peer->state) == CV_SUCCESS);
    }
}

const double *peer_state(const Peer *peer) {
    return N_VGetArrayPointer(peer->state);
}

double peer_peak(const Peer *peer) {
    return peer->peak;
}

/* Returns where the law puts a tip that is released at zero force. */
static MotionPlace find_place(Peer *peer, const double *x) {
    static const MotionPlace sides[][2] = {{MOTION_UPPER, MOTION_UPPER_LEAVING}, {MOTION_LOWER, MOTION_LOWER_LEAVING}};
    for (int side = 0; side < 2; side++) {
        double depth;
        peer->place = sides[side][0];
        double push = push_of(peer, x, &depth);
        if (depth > 0)
            return sides[side][push <= 0];
    }
    return MOTION_OPEN;
}

void peer_move(Peer *peer, const double *state, size_t cycle) {
    for (size_t i = 0; i < peer->rig->free.states; i++)
        N_VGetArrayPointer(peer->state)[i] = state[i];
    peer->place = find_place(peer, state);
    peer->cycle = cycle;
    must(CVodeReInit(peer->cvode, (double)cycle * peer->rig->period, peer->state) == CV_SUCCESS);
}

size_t peer_switches(const Peer *peer) {
    return peer->switches;
}
