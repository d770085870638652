#include "crank_peer.h"

#include <cvode/cvode.h>
#include <math.h>
#include <nvector/nvector_serial.h>
#include <stdio.h>
#include <stdlib.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include "base/memory.h"

struct CrankPeer {
    const Tree *tree;
    BallPlace place;
    SUNContext context;
    N_Vector state, tolerances;
    SUNNonlinearSolver solver;
    void *cvode;
    size_t cycle, switches, evaluations;
};

static void must(bool good) {
    if (good)
        return;
    fprintf(stderr, "CVODE failed\n");
    exit(1);
}

static int rates(realtype time, N_Vector state, N_Vector rate, void *data) {
    CrankPeer *peer = data;
    const double *x = N_VGetArrayPointer(state);
    double force[3], moment[3];
    TreePose pose = tree_pose(peer->tree, time, x);
    ball_push(peer->tree, &pose, peer->place, force, moment);
    tree_rates(peer->tree, &pose, x, force, moment, N_VGetArrayPointer(rate));
    peer->evaluations++;
    return 0;
}

/* Each function rises through 0 at a switch. */
static int roots(realtype time, N_Vector state, realtype *out, void *data) {
    const CrankPeer *peer = data;
    TreePose pose = tree_pose(peer->tree, time, N_VGetArrayPointer(state));
    BallReading reading = ball_read(peer->tree, &pose);
    double gap = peer->tree->stiffness * (reading.distance - peer->tree->clearance);
    bool by_gap = peer->tree->release == CRANK_RELEASE_GAP;
    if (peer->place == BALL_CONTACT)
        out[0] = by_gap ? -gap : -reading.push;
    else
        out[0] = peer->place == BALL_OPEN ? gap : reading.push;
    out[1] = peer->place == BALL_LEAVING ? -gap : -1;
    return 0;
}

CrankPeer *crank_peer_create(const Tree *tree, double tolerance) {
    CrankPeer *peer = memory_zeroed(1, sizeof *peer);
    double start[TREE_STATES_MOST];
    Turn scaled = turn_create(tree, tolerance);
    peer->tree = tree;
    tree_start(tree, start);
    must(SUNContext_Create(NULL, &peer->context) == 0);
    peer->state = N_VNew_Serial((sunindextype)(2 * tree->coordinates), peer->context);
    peer->tolerances = N_VClone(peer->state);
    for (size_t i = 0; i < 2 * tree->coordinates; i++) {
        N_VGetArrayPointer(peer->state)[i] = start[i];
        N_VGetArrayPointer(peer->tolerances)[i] = tolerance * scaled.scale[i];
    }
    peer->cvode = CVodeCreate(CV_ADAMS, peer->context);
    must(CVodeInit(peer->cvode, rates, 0, peer->state) == CV_SUCCESS);
    must(CVodeSVtolerances(peer->cvode, 0, peer->tolerances) == CV_SUCCESS);
    peer->solver = SUNNonlinSol_FixedPoint(peer->state, 0, peer->context);
    must(CVodeSetNonlinearSolver(peer->cvode, peer->solver) == CV_SUCCESS);
    must(CVodeSetUserData(peer->cvode, peer) == CV_SUCCESS);
    must(CVodeRootInit(peer->cvode, 2, roots) == CV_SUCCESS);
    must(CVodeSetRootDirection(peer->cvode, (int[]){1, 1}) == CV_SUCCESS);
    CVodeSetNoInactiveRootWarn(peer->cvode);
    CVodeSetMaxNumSteps(peer->cvode, 1000000);
    return peer;
}

void crank_peer_destroy(CrankPeer *peer) {
    CVodeFree(&peer->cvode);
    SUNNonlinSolFree(peer->solver);
    N_VDestroy(peer->state);
    N_VDestroy(peer->tolerances);
    SUNContext_Free(&peer->context);
    memory_free(peer);
}

/* Advances to a time or to a switch before it; true at a switch. */
static bool advance(CrankPeer *peer, double end, double *time) {
    int which[2], done = CVode(peer->cvode, end, peer->state, time, CV_NORMAL);
    must(done >= 0);
    if (done != CV_ROOT_RETURN)
        return false;
    CVodeGetRootInfo(peer->cvode, which);
    if (peer->place == BALL_OPEN || (peer->place == BALL_LEAVING && which[0]))
        peer->place = BALL_CONTACT;
    else
        peer->place =
            peer->place == BALL_CONTACT && peer->tree->release == CRANK_RELEASE_FORCE ? BALL_LEAVING : BALL_OPEN;
    peer->switches++;
    must(CVodeReInit(peer->cvode, *time, peer->state) == CV_SUCCESS);
    return true;
}

void crank_peer_set_state(CrankPeer *peer, const double *state) {
    for (size_t i = 0; i < 2 * peer->tree->coordinates; i++)
        N_VGetArrayPointer(peer->state)[i] = state[i];
    TreePose pose = tree_pose(peer->tree, 0, state);
    BallReading reading = ball_read(peer->tree, &pose);
    peer->place = ball_place(peer->tree, &reading);
    must(CVodeReInit(peer->cvode, 0, peer->state) == CV_SUCCESS);
}

void crank_peer_until(CrankPeer *peer, double time) {
    double reached = 0;
    while (advance(peer, time, &reached))
        continue;
}

void crank_peer_cycle(CrankPeer *peer) {
    crank_peer_until(peer, (double)++peer->cycle * peer->tree->period);
}

double crank_peer_switch(CrankPeer *peer) {
    double time = 0;
    must(advance(peer, 1e9, &time));
    return time;
}

const double *crank_peer_state(const CrankPeer *peer) {
    return N_VGetArrayPointer(peer->state);
}

BallPlace crank_peer_place(const CrankPeer *peer) {
    return peer->place;
}

size_t crank_peer_switches(const CrankPeer *peer) {
    return peer->switches;
}

size_t crank_peer_evaluations(const CrankPeer *peer) {
    return peer->evaluations;
}
