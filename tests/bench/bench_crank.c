/* Compares the slider crank with CVODE (Adams, root-finding) on the same equations in one process: revolutions per
 * second and the error of a revolution, and the time of one evaluation of the right side. */

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "bench.h"
#include "crank_peer.h"

enum { TURNS = 3, REVOLUTIONS = 10, EVALUATIONS = 200000 };

/* Returns the root mean square of the coordinates' errors, in 0.1 mm. */
static double error_of(const Turn *exact, const double *state) {
    double sum = 0;
    size_t count = exact->tree->coordinates;
    for (size_t i = 0; i < count; i++)
        sum += pow((state[i] - exact->state[i]) / exact->scale[i], 2);
    return sqrt(sum / (double)count);
}

static void measure_turn(const Tree *tree, const Turn *exact, double tolerance) {
    double seconds[TURNS], error = 0;
    size_t evaluations = 0;
    for (int k = 0; k < TURNS; k++) {
        Turn turn = turn_create(tree, tolerance);
        double begin = bench_now();
        for (int i = 0; i < REVOLUTIONS; i++) {
            turn_cycle(&turn);
            if (i == 0) {
                error = error_of(exact, turn.state);
                evaluations = turn.evaluations;
            }
        }
        seconds[k] = bench_now() - begin;
    }
    printf("turn,  tolerance %.0e: error %.1e, %zu evaluations, %.1f revolutions/s\n", tolerance, error, evaluations,
           REVOLUTIONS / bench_median(seconds, TURNS));
}

static void measure_peer(const Tree *tree, const Turn *exact, double tolerance) {
    double seconds[TURNS], error = 0;
    size_t evaluations = 0;
    for (int k = 0; k < TURNS; k++) {
        CrankPeer *peer = crank_peer_create(tree, tolerance);
        double begin = bench_now();
        for (int i = 0; i < REVOLUTIONS; i++) {
            crank_peer_cycle(peer);
            if (i == 0) {
                error = error_of(exact, crank_peer_state(peer));
                evaluations = crank_peer_evaluations(peer);
            }
        }
        seconds[k] = bench_now() - begin;
        crank_peer_destroy(peer);
    }
    printf("CVODE, tolerance %.0e: error %.1e, %zu evaluations, %.1f revolutions/s\n", tolerance, error, evaluations,
           REVOLUTIONS / bench_median(seconds, TURNS));
}

static void measure_right_side(const Tree *tree, const Turn *turn) {
    double seconds[TURNS], state[TREE_STATES_MOST], rates[TREE_STATES_MOST], force[3], moment[3];
    memcpy(state, turn->state, sizeof state);
    for (int k = 0; k < TURNS; k++) {
        double begin = bench_now();
        for (int i = 0; i < EVALUATIONS; i++) {
            TreePose pose = tree_pose(tree, 0, state);
            ball_push(tree, &pose, BALL_CONTACT, force, moment);
            tree_rates(tree, &pose, state, force, moment, rates);
            state[0] += 1e-20 * rates[0];
        }
        seconds[k] = bench_now() - begin;
    }
    printf("right side: %.3f us\n", 1e6 * bench_median(seconds, TURNS) / EVALUATIONS);
}

int main(int count, char **words) {
    char path[1000];
    Crank crank = {0};
    Fault fault = {0};
    snprintf(path, sizeof path, "%s/assets/cranks/ssc.json", count > 1 ? words[1] : ".");
    if (!crank_read(&crank, path, NULL, 0, &fault)) {
        fprintf(stderr, "%s\n", fault.lines[0]);
        return 1;
    }
    Tree tree = tree_of(&crank);
    Turn exact = turn_create(&tree, 1e-12);
    turn_cycle(&exact);
    printf("700 rpm, 0.25 mm, first revolution: %zu switches\n", exact.switches);
    measure_right_side(&tree, &exact);
    measure_turn(&tree, &exact, 1e-6);
    measure_turn(&tree, &exact, 1e-8);
    measure_peer(&tree, &exact, 1e-6);
    measure_peer(&tree, &exact, 1e-8);
    crank_free(&crank);
    return 0;
}
