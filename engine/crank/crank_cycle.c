#include "crank/crank_cycle.h"

#include <math.h>
#include <string.h>

#include "base/memory.h"
#include "base/parallel.h"

/* Distance of a neighbour, in the scales of the states' errors: near enough that it is one, and far enough that the
 * errors of the steps do not matter beside it. */
static const double BESIDE = 1e-5, BESIDE_BOTH = 3e-5;

static const TraceColumn columns[CRANK_COLUMNS] = {
    [CRANK_TIME] = {"time", "s"},
    [CRANK_ANGLE] = {"angle", "deg"},
    [CRANK_ALONG] = {"along", "m"},
    [CRANK_ALONG_RATE] = {"along_rate", "m/s"},
    [CRANK_ACROSS] = {"across", "m"},
    [CRANK_UP] = {"up", "m"},
    [CRANK_FORCE] = {"force", "N"},
    [CRANK_SLIDER] = {"slider", "m"},
    [CRANK_SLIDER_OFF] = {"slider_off", "m"},
};

/* A turn and its neighbours. */
typedef struct Motion {
    Turn turn;
    size_t states, tangents, sides; /* neighbours of each tangent: 1 or 2 */
    Turn *near;                     /* (tangents x sides) */
    double *length;                 /* (tangents) of the tangent; its neighbour is BESIDE away */
    double *direction;              /* (tangents x states) at the beginning of the revolution, of length 1 */
} Motion;

static double beside(const Motion *motion) {
    return motion->sides == 1 ? BESIDE : BESIDE_BOTH;
}

static size_t states_of(const void *given) {
    return 2 * ((const Tree *)given)->coordinates;
}

static double period_of(const void *given) {
    return ((const Tree *)given)->period;
}

static double rest_tip(const void *given) {
    return CRANK_REST * ((const Tree *)given)->clearance;
}

static double rest_state(const void *given) {
    const Tree *tree = given;
    Turn turn = turn_create(tree, TURN_FINE);
    return CRANK_REST * (tree->clearance > 0 ? tree->clearance / turn.scale[0] : 1);
}

void crank_cycle_state(const Turn *turn, double *state) {
    double ideal[TREE_STATES_MOST];
    tree_ideal(turn->tree, 0, turn->tree->omega, ideal);
    for (size_t i = 0; i < 2 * turn->tree->coordinates; i++)
        state[i] = (turn->state[i] - ideal[i]) / turn->scale[i];
}

void crank_cycle_set_state(Turn *turn, const double *state) {
    double own[TREE_STATES_MOST];
    tree_ideal(turn->tree, 0, turn->tree->omega, own);
    for (size_t i = 0; i < 2 * turn->tree->coordinates; i++)
        own[i] += turn->scale[i] * state[i];
    turn_set_state(turn, own);
}

/* Puts the neighbours of a tangent beside the turn, which is at the beginning of a revolution. */
static void place_neighbours(Motion *motion, size_t index) {
    double state[TREE_STATES_MOST], moved[TREE_STATES_MOST];
    const double *direction = motion->direction + index * motion->states;
    crank_cycle_state(&motion->turn, state);
    for (size_t side = 0; side < motion->sides; side++) {
        double by = side ? -beside(motion) : beside(motion);
        for (size_t i = 0; i < motion->states; i++)
            moved[i] = state[i] + by * direction[i];
        Turn *turn = &motion->near[index * motion->sides + side];
        *turn = motion->turn;
        turn->unwatched = true;
        crank_cycle_set_state(turn, moved);
    }
}

static void *create(const void *given, size_t tangents, const Stop *stop) {
    Motion *motion = memory_zeroed(1, sizeof *motion);
    const Tree *tree = given;
    motion->turn = turn_create(tree, TURN_FINE);
    motion->turn.stop = stop;
    motion->states = states_of(given);
    motion->tangents = tangents;
    motion->sides = tangents == 1 ? 1 : 2;
    motion->near = memory_zeroed(tangents * motion->sides + 1, sizeof *motion->near);
    motion->length = memory_zeroed(tangents + 1, sizeof *motion->length);
    motion->direction = memory_zeroed(tangents * motion->states + 1, sizeof *motion->direction);
    return motion;
}

static void destroy(void *own) {
    Motion *motion = own;
    memory_free(motion->near);
    memory_free(motion->length);
    memory_free(motion->direction);
    memory_free(motion);
}

static void copy(void *to_own, const void *from_own) {
    Motion *to = to_own;
    const Motion *from = from_own;
    to->turn = from->turn;
    memcpy(to->near, from->near, from->tangents * from->sides * sizeof *from->near);
    memcpy(to->length, from->length, from->tangents * sizeof *from->length);
    memcpy(to->direction, from->direction, from->tangents * from->states * sizeof *from->direction);
}

static void state_of(const void *own, double *state) {
    const Motion *motion = own;
    crank_cycle_state(&motion->turn, state);
}

static void set_state(void *own, const double *state) {
    Motion *motion = own;
    crank_cycle_set_state(&motion->turn, state);
    for (size_t i = 0; i < motion->tangents; i++)
        place_neighbours(motion, i);
}

static void tangent_of(const void *own, size_t index, double *tangent) {
    const Motion *motion = own;
    double other[TREE_STATES_MOST];
    const Turn *near = motion->near + index * motion->sides;
    crank_cycle_state(near, tangent);
    crank_cycle_state(motion->sides == 1 ? &motion->turn : near + 1, other);
    double factor = motion->length[index] / ((double)motion->sides * beside(motion));
    for (size_t i = 0; i < motion->states; i++)
        tangent[i] = factor * (tangent[i] - other[i]);
}

static void set_tangent(void *own, size_t index, const double *tangent) {
    Motion *motion = own;
    double square = 0, *direction = motion->direction + index * motion->states;
    for (size_t i = 0; i < motion->states; i++)
        square += tangent[i] * tangent[i];
    motion->length[index] = sqrt(square);
    for (size_t i = 0; i < motion->states; i++)
        direction[i] = square > 0 ? tangent[i] / motion->length[index] : 0;
    place_neighbours(motion, index);
}

static void unit_tangents(void *own) {
    Motion *motion = own;
    for (size_t t = 0; t < motion->tangents; t++) {
        double unit[TREE_STATES_MOST] = {0};
        unit[t] = 1;
        set_tangent(motion, t, unit);
    }
}

static void run_neighbour(void *context, size_t index) {
    turn_cycle(&((Motion *)context)->near[index]);
}

/* A neighbour that cannot be followed makes the motion one that cannot. */
static CycleStatus run(void *own) {
    Motion *motion = own;
    size_t neighbours = motion->tangents * motion->sides;
    turn_cycle(&motion->turn);
    parallel_for(neighbours > 1 ? parallel_processors() : 1, neighbours, run_neighbour, motion);
    for (size_t i = 0; i < neighbours && motion->turn.status == CYCLE_GOOD; i++)
        motion->turn.status = motion->near[i].status;
    return motion->turn.status;
}

static CycleStatus status_of(const void *own) {
    return ((const Motion *)own)->turn.status;
}

static CycleTally tally_of(const void *own) {
    const Turn *turn = &((const Motion *)own)->turn;
    return (CycleTally){.switches = turn->switches,
                        .contact_time = turn->contact_time,
                        .touches = turn->touches,
                        .work = turn->evaluations,
                        .time = turn->tree->turns ? turn->past + turn->time : 0};
}

static double *peaks_of(void *own) {
    return ((Motion *)own)->turn.peak;
}

void crank_cycle_tip(const Turn *turn, double tip[2]) {
    TreePose pose = turn_pose(turn);
    tip[0] = tip[1] = 0;
    for (size_t i = 0; i < 3; i++) {
        double turned = pose.turn[2] * pose.across[i] - pose.turn[1] * pose.up[i];
        tip[0] += pose.apart[i] * pose.along[i];
        tip[1] += pose.apart_rate[i] * pose.along[i] + pose.apart[i] * turned;
    }
}

static void tip_of(const void *own, double *tip) {
    crank_cycle_tip(&((const Motion *)own)->turn, tip);
}

/* Advances to a part of the revolution: in time, or with a motor in angle, as near as steps can be that are long enough
 * to tell a switch from rounding. */
static void advance(Turn *turn, double part) {
    enum { TRIES = 6 };
    const Tree *tree = turn->tree;
    const double near = 1e-9 * tree->period; /* s */
    size_t cycle = turn->cycle, angle = tree->coordinates - 1;
    if (!tree->turns) {
        while (turn->cycle == cycle && turn->status == CYCLE_GOOD && turn->time < part * tree->period)
            turn_step(turn, part * tree->period - turn->time);
        return;
    }
    for (int i = 0; i < TRIES; i++) {
        double until = turn->time + (2 * M_PI * part - turn->state[angle]) / turn->state[tree->coordinates + angle];
        while (turn->cycle == cycle && turn->status == CYCLE_GOOD && turn->time < until - near)
            turn_step(turn, until - turn->time);
    }
}

static void sample(void *own, int part, double *row) {
    Motion *motion = own;
    const Tree *tree = motion->turn.tree;
    TreePose pose = turn_pose(&motion->turn);
    double tip[2];
    crank_cycle_tip(&motion->turn, tip);
    row[CRANK_ANGLE] = pose.theta * 180 / M_PI;
    row[CRANK_ALONG] = tip[0];
    row[CRANK_ALONG_RATE] = tip[1];
    row[CRANK_ACROSS] = row[CRANK_UP] = 0;
    for (size_t i = 0; i < 3; i++) {
        row[CRANK_ACROSS] += pose.apart[i] * pose.across[i];
        row[CRANK_UP] += pose.apart[i] * pose.up[i];
    }
    row[CRANK_FORCE] = turn_force(&motion->turn);
    row[CRANK_SLIDER] = motion->turn.state[0];
    row[CRANK_SLIDER_OFF] = motion->turn.state[0] - tree_ideal_slider(tree, pose.theta);
    if (part + 1 == CRANK_SAMPLES)
        return; /* the revolution is ended with the neighbours */
    double until = (double)(part + 1) / CRANK_SAMPLES;
    advance(&motion->turn, until);
    for (size_t i = 0; i < motion->tangents * motion->sides; i++)
        advance(&motion->near[i], until); /* the same steps, so that their errors are alike */
}

/* Saved are the state, the place and the step. */
static size_t saved_size(const void *given) {
    return states_of(given) + 2;
}

static void save(const void *own, double *saved) {
    const Motion *motion = own;
    memcpy(saved, motion->turn.state, motion->states * sizeof *saved);
    saved[motion->states] = motion->turn.place;
    saved[motion->states + 1] = motion->turn.step;
}

static void restore(void *own, const double *saved) {
    Motion *motion = own;
    turn_restore(&motion->turn, saved, (BallPlace)saved[motion->states], saved[motion->states + 1]);
    for (size_t i = 0; i < motion->tangents; i++)
        place_neighbours(motion, i);
}

/* Runs motions by coarser steps, as sweeps do: the statistics of many motions do not need the steps of an answer. */
static void many(const void *given, CycleRun *runs, size_t count, const Stop *stop) {
    for (size_t i = 0; i < count; i++) {
        CycleRun *run = &runs[i];
        Turn turn = turn_create(given, TURN_QUICK);
        turn.stop = stop;
        crank_cycle_set_state(&turn, run->start);
        for (run->recorded = 0; run->recorded < run->cycles && !stop_requested(stop); run->recorded++) {
            double tip[2];
            turn.peak[0] = turn.peak[1] = 0;
            if (turn_cycle(&turn) != CYCLE_GOOD)
                break;
            crank_cycle_tip(&turn, tip);
            run->deflection[run->recorded] = tip[0];
            run->velocity[run->recorded] = tip[1];
            memcpy(run->peak + CYCLE_SIDES * run->recorded, turn.peak, sizeof turn.peak);
        }
        run->status = turn.status;
        crank_cycle_state(&turn, run->end);
    }
}

const CycleKind crank_cycle = {
    .columns = columns,
    .column_count = CRANK_COLUMNS,
    .samples = CRANK_SAMPLES,
    .closing = 1e-9,
    .cycles_least = 200,
    .cycles_most = 1600,
    .dear = CRANK_DEAR,
    .lanes = CRANK_LANES,
    .lane_cycles = CRANK_LANE_CYCLES,
    .lane_apart = 100,
    .together = 1,
    .states = states_of,
    .period = period_of,
    .rest_tip = rest_tip,
    .rest_state = rest_state,
    .create = create,
    .destroy = destroy,
    .copy = copy,
    .state = state_of,
    .set_state = set_state,
    .tangent = tangent_of,
    .set_tangent = set_tangent,
    .unit_tangents = unit_tangents,
    .run = run,
    .status = status_of,
    .tally = tally_of,
    .peaks = peaks_of,
    .tip = tip_of,
    .sample = sample,
    .saved_size = saved_size,
    .save = save,
    .restore = restore,
    .many = many,
};

Cycle crank_cycle_of(const Tree *tree) {
    return (Cycle){&crank_cycle, tree};
}

/* Revolutions in which a joint without clearance settles, and evaluations until it is given up: some seconds. */
enum { IDEAL_TURNS = 20, IDEAL_WORK = 20000000 };

double crank_cycle_ideal_force(const Crank *crank, const Stop *stop) {
    Crank tight = *crank;
    tight.clearance = tight.start_along = tight.start_across = tight.start_up = 0;
    Tree tree = tree_of(&tight);
    Turn turn = turn_create(&tree, TURN_QUICK);
    turn.stop = stop;
    turn.evaluations_most = IDEAL_WORK;
    int done = 0;
    for (; done < IDEAL_TURNS && turn.status == CYCLE_GOOD && !stop_requested(stop); done++) {
        turn.peak[0] = 0;
        turn_cycle(&turn);
    }
    return done == IDEAL_TURNS && turn.status == CYCLE_GOOD ? turn.peak[0] : (double)NAN;
}
