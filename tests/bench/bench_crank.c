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

/* Error of the first revolution, 1, and revolutions per second. */
typedef struct Measured {
    double error, speed;
} Measured;

static Measured measure_turn(const Tree *tree, const Turn *exact, double tolerance) {
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
    Measured measured = {error, REVOLUTIONS / bench_median(seconds, TURNS)};
    printf("turn,  tolerance %.0e: error %.1e, %zu evaluations, %.1f revolutions/s\n", tolerance, error, evaluations,
           measured.speed);
    return measured;
}

static Measured measure_peer(const Tree *tree, const Turn *exact, double tolerance) {
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
    Measured measured = {error, REVOLUTIONS / bench_median(seconds, TURNS)};
    printf("CVODE, tolerance %.0e: error %.1e, %zu evaluations, %.1f revolutions/s\n", tolerance, error, evaluations,
           measured.speed);
    return measured;
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

/* Returns the speed at an error, between two measurements: a power law. */
static double speed_at(Measured a, Measured b, double error) {
    return a.speed * pow(b.speed / a.speed, log(error / a.error) / log(b.error / a.error));
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
    Measured quick = measure_turn(&tree, &exact, TURN_QUICK);
    Measured fine = measure_turn(&tree, &exact, TURN_FINE);
    Measured coarse_peer = measure_peer(&tree, &exact, 1e-6);
    Measured fine_peer = measure_peer(&tree, &exact, 1e-8);
    printf("at the same error the turn is %.2f and %.2f times as fast as CVODE\n",
           quick.speed / speed_at(coarse_peer, fine_peer, quick.error),
           speed_at(quick, fine, fine_peer.error) / fine_peer.speed);
    printf("live at 700 rpm, not slowed down: %.1f %% of a core; 121 speeds x 100 revolutions: %.0f s on two cores\n",
           100 * crank.frequency / quick.speed, 121 * 100 / (2 * quick.speed));
    crank_free(&crank);
    return 0;
}
