#include "crank/turn.h"

#include <math.h>
#include <string.h>

#include "base/real.h"
#include "base/stop.h"
#include "crank/stepper.h"

/* Errors are measured by this length, m; by it over the coupler's length for angles; rates by the same per TIME_PART of
 * the contact's frequency with a mass of SCALE_MASS kg. */
static const double SCALE_LENGTH = 1e-4, SCALE_MASS = 0.1, TIME_PART = 0.1;
/* After a switch the first step is at most this part of 1 / omega of the ball's end in contact. */
static const double RESTART = 0.07;
/* A step is at most this part of a revolution. */
static const double STEP_MOST = 1.0 / 16;
/* A switch is located when the force or the spring's force of the gap is below this, N, or when the correction is, s.
 */
static const double LOCATED = 1e-9, INSTANT = 1e-17;
/* A peak is located when what a correction would add to it is below this, N. */
static const double PEAK_LOCATED = 1e-8;
/* A maximum on the path counts when it is above this part of the present peak: the path is not the step's exactly. */
static const double PEAK_NEAR = 0.99;
/* The revolution of a motor ends within this angle, rad. */
static const double ANGLE_LOCATED = 1e-14;
/* Bending or stretch that changes the coupler's length by more than this part of it is beyond what small bending
 * describes: such a motion does not come back. */
static const double BENT_MOST = 0.1;
/* Steps in a revolution are at most STEPS_ANY, and so many per radian of the fastest vibration, and never more than
 * STEPS_MOST, some seconds: a motion that needs more has large numbers, or parts too stiff or damped for its speed. */
static const double STEPS_ANY = 1e5, STEPS_PER_RADIAN = 100, STEPS_MOST = 1e6;
enum { SAMPLES = 8 /* of the path of a step */, CORRECTIONS_MOST = 20, HALVINGS = 50 };
enum { POLLED = 256 /* steps between two looks at whether the end is requested: some ms */ };

/* The equations with the ball in its place. */
static void rates_of(const void *system, double time, const double *state, double *rates) {
    const Turn *turn = system;
    double force[3], moment[3];
    TreePose pose = tree_pose(turn->tree, time, state);
    ball_push(turn->tree, &pose, turn->place, force, moment);
    tree_rates(turn->tree, &pose, state, force, moment, rates);
}

static Stepper stepper_of(const Turn *turn) {
    return (Stepper){2 * turn->tree->coordinates, turn->scale, turn->tolerance, rates_of, turn};
}

static void set_scales(Turn *turn) {
    const Tree *tree = turn->tree;
    size_t n = tree->coordinates;
    double per_second = TIME_PART * sqrt(tree->stiffness / SCALE_MASS);
    for (size_t i = 0; i < n; i++) {
        bool is_angle = i == 1 || i == 2 || (tree->turns && i == n - 1);
        turn->scale[i] = is_angle ? SCALE_LENGTH / tree->length : SCALE_LENGTH;
        turn->scale[n + i] = turn->scale[i] * per_second;
    }
}

static TurnBall ball_of(const Tree *tree, double time, const double *state, const double *rates) {
    TreePose pose = tree_pose(tree, time, state);
    TurnBall ball;
    memcpy(ball.apart, pose.apart, sizeof ball.apart);
    memcpy(ball.rate, pose.apart_rate, sizeof ball.rate);
    tree_apart_acceleration(tree, &pose, rates, ball.second);
    return ball;
}

/* Switch functions ------------------------------------------------------------------------------------------------- */

/* The spring's force of the gap, k (|d| - c), and the contact's whole force, with their rates: N, N/s. */
typedef struct Signal {
    double gap, gap_rate, push, push_rate;
} Signal;

static double dot(const double *a, const double *b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static Signal signal_of(const Tree *tree, const TurnBall *ball) {
    double k = tree->stiffness, c = tree->damping;
    BallReading reading = ball_read_vector(tree, ball->apart, ball->rate);
    double away = real_max(reading.distance, 1e-300);
    double second = (dot(ball->rate, ball->rate) + dot(ball->apart, ball->second) - reading.rate * reading.rate) / away;
    Signal signal = {k * (reading.distance - tree->clearance), k * reading.rate, reading.push,
                     k * reading.rate + c * second};
    if (tree->clearance <= 0) {
        double product = 0;
        for (size_t i = 0; i < 3; i++)
            product += (k * ball->apart[i] + c * ball->rate[i]) * (k * ball->rate[i] + c * ball->second[i]);
        signal.push_rate = product / real_max(reading.push, 1e-300);
    }
    return signal;
}

/* A function that rises through 0 where the ball changes its place. */
typedef struct Watch {
    bool of_push; /* of the contact's force; otherwise of the gap */
    double sign;
    BallPlace next;
} Watch;

enum { WATCHES_MOST = 2 };

static size_t watches_of(const Turn *turn, Watch watches[WATCHES_MOST]) {
    const Tree *tree = turn->tree;
    bool by_gap = tree->release == CRANK_RELEASE_GAP || tree->damping <= 0;
    if (tree->clearance <= 0)
        return 0;
    switch (turn->place) {
    case BALL_OPEN:
        watches[0] = (Watch){false, 1, BALL_CONTACT};
        return 1;
    case BALL_CONTACT:
        watches[0] = (Watch){!by_gap, -1, by_gap ? BALL_OPEN : BALL_LEAVING};
        return 1;
    default:
        watches[0] = (Watch){false, -1, BALL_OPEN};
        watches[1] = (Watch){true, 1, BALL_CONTACT};
        return 2;
    }
}

static double watch_value(const Watch *watch, const Signal *signal) {
    return watch->sign * (watch->of_push ? signal->push : signal->gap);
}

static double watch_rate(const Watch *watch, const Signal *signal) {
    return watch->sign * (watch->of_push ? signal->push_rate : signal->gap_rate);
}

/* The path of a step ----------------------------------------------------------------------------------------------- */

/* The ball's path over a step: for each direction the polynomial of fifth degree in the part of the step, 0 to 1. */
typedef struct Path {
    double length; /* s */
    double factor[3][6];
} Path;

static Path path_between(const TurnBall *begin, const TurnBall *end, double length) {
    Path path = {.length = length};
    for (size_t i = 0; i < 3; i++) {
        double v0 = begin->rate[i] * length, a0 = begin->second[i] * length * length / 2;
        double v1 = end->rate[i] * length, a1 = end->second[i] * length * length / 2;
        double far = end->apart[i] - begin->apart[i] - v0 - a0, fast = v1 - v0 - 2 * a0, bent = a1 - a0;
        double *f = path.factor[i];
        f[0] = begin->apart[i], f[1] = v0, f[2] = a0;
        f[3] = 10 * far - 4 * fast + bent;
        f[4] = -15 * far + 7 * fast - 2 * bent;
        f[5] = 6 * far - 3 * fast + bent;
    }
    return path;
}

static Signal path_signal(const Path *path, const Tree *tree, double part) {
    TurnBall ball;
    double per = 1 / path->length;
    for (size_t i = 0; i < 3; i++) {
        const double *f = path->factor[i];
        ball.apart[i] = f[0] + part * (f[1] + part * (f[2] + part * (f[3] + part * (f[4] + part * f[5]))));
        ball.rate[i] = per * (f[1] + part * (2 * f[2] + part * (3 * f[3] + part * (4 * f[4] + part * 5 * f[5]))));
        ball.second[i] = per * per * (2 * f[2] + part * (6 * f[3] + part * (12 * f[4] + part * 20 * f[5])));
    }
    return signal_of(tree, &ball);
}

/* Returns the part of the step at which the function is 0 (`of_rate`: its rate), between two parts with values of
 * different signs. */
static double path_root(const Path *path, const Tree *tree, const Watch *watch, bool of_rate, double low, double high) {
    Signal signal = path_signal(path, tree, low);
    bool below = (of_rate ? watch_rate(watch, &signal) : watch_value(watch, &signal)) <= 0;
    for (int i = 0; i < HALVINGS && low < high; i++) {
        double middle = low + (high - low) / 2;
        if (middle <= low || middle >= high)
            break;
        signal = path_signal(path, tree, middle);
        if (((of_rate ? watch_rate(watch, &signal) : watch_value(watch, &signal)) <= 0) == below)
            low = middle;
        else
            high = middle;
    }
    return high;
}

/* Returns the first part of the step, at most `before`, at which the function rises through 0; `before` if none. The
 * samples are at j / SAMPLES. */
static double first_rise(const Path *path, const Tree *tree, const Watch *watch, const Signal samples[SAMPLES + 1],
                         double before) {
    double from = watch_value(watch, &samples[0]);
    if (from > 0 && watch_rate(watch, &samples[0]) > 0)
        return 0;
    for (int j = 1; j <= SAMPLES && (double)(j - 1) / SAMPLES < before; j++) {
        double low = (double)(j - 1) / SAMPLES, high = (double)j / SAMPLES;
        double to = watch_value(watch, &samples[j]), slope = watch_rate(watch, &samples[j - 1]);
        if (from <= 0 && to > 0)
            return real_min(before, path_root(path, tree, watch, false, low, high));
        bool may =
            from <= 0 && slope > 0 && watch_rate(watch, &samples[j]) < 0 && from + slope * path->length / SAMPLES > 0;
        if (may) {
            double top = path_root(path, tree, watch, true, low, high);
            Signal most = path_signal(path, tree, top);
            if (watch_value(watch, &most) > 0)
                return real_min(before, path_root(path, tree, watch, false, low, top));
        }
        from = to;
    }
    return before;
}

/* Steps ------------------------------------------------------------------------------------------------------------ */

/* A step that was tried from the present state. */
typedef struct Trial {
    double length, error; /* s, 1 */
    double state[TREE_STATES_MOST], rates[TREE_STATES_MOST];
    TurnBall ball;
} Trial;

/* Ends the motion if that is requested, or if it has taken all the steps that it may. */
static void watch_steps(Turn *turn) {
    bool spent = turn->evaluations_most && turn->evaluations > turn->evaluations_most;
    if (turn->status != CYCLE_GOOD)
        return;
    if (turn->cycle_steps++ % POLLED == 0 && stop_requested(turn->stop))
        turn->status = CYCLE_INTERRUPTED;
    else if (spent || (double)turn->cycle_steps > turn->steps_most)
        turn->status = CYCLE_STIFF;
}

static void try_step(Turn *turn, double length, Trial *trial) {
    watch_steps(turn);
    Stepper stepper = stepper_of(turn);
    trial->length = length;
    trial->error = stepper_try(&stepper, turn->time, length, turn->state, turn->rates, trial->state, trial->rates);
    trial->ball = ball_of(turn->tree, turn->time + length, trial->state, trial->rates);
    turn->evaluations += STEPPER_EVALUATIONS;
}

/* Repeats the step until the function is 0 at its end. */
static void locate(Turn *turn, const Watch *watch, double guess, double longest, Trial *trial) {
    double low = 0, high = longest, length = guess;
    for (int i = 0; i < CORRECTIONS_MOST; i++) {
        try_step(turn, length, trial);
        Signal signal = signal_of(turn->tree, &trial->ball);
        double value = watch_value(watch, &signal), rate = watch_rate(watch, &signal);
        if (fabs(value) < LOCATED)
            return;
        if (value > 0)
            high = length;
        else
            low = length;
        double better = length - value / rate;
        if (!(better > low && better < high))
            better = low + (high - low) / 2;
        if (fabs(better - length) < INSTANT)
            return;
        length = better;
    }
}

/* Locates the largest force between two parts of the step. */
static void locate_peak(Turn *turn, const Path *path, double low, double high) {
    static const Watch force = {true, 1, BALL_CONTACT};
    double part = path_root(path, turn->tree, &force, true, low, high), length = part * path->length;
    Signal most = path_signal(path, turn->tree, part);
    if (!(most.push > PEAK_NEAR * turn->peak[0]))
        return;
    double gap = 1e-3 * (high - low);
    double bend =
        (path_signal(path, turn->tree, part + gap).push_rate - path_signal(path, turn->tree, part - gap).push_rate) /
        (2 * gap * path->length);
    Trial trial;
    for (int i = 0; i < CORRECTIONS_MOST; i++) {
        try_step(turn, length, &trial);
        Signal signal = signal_of(turn->tree, &trial.ball);
        turn->peak[0] = real_max(turn->peak[0], signal.push);
        double better = real_clamp(length - signal.push_rate / bend, low * path->length, high * path->length);
        if (!(bend < 0) || fabs((better - length) * signal.push_rate) < PEAK_LOCATED)
            return;
        length = better;
    }
}

/* Notes the largest force of a step that was taken. */
static void watch_peak(Turn *turn, const Path *path, const Signal samples[SAMPLES + 1]) {
    turn->peak[0] = real_max(turn->peak[0], real_max(samples[0].push, samples[SAMPLES].push));
    for (int j = 1; j <= SAMPLES; j++)
        if (samples[j - 1].push_rate > 0 && samples[j].push_rate <= 0)
            locate_peak(turn, path, (double)(j - 1) / SAMPLES, (double)j / SAMPLES);
}

static double restart_step(const Tree *tree) {
    return RESTART * sqrt((tree->end_mass + tree->mass / 3) / tree->stiffness);
}

static void change_place(Turn *turn, BallPlace place) {
    turn->touches += place == BALL_CONTACT && turn->place == BALL_OPEN;
    turn->place = place;
    turn->switches++;
    turn->cycle_switches++;
    turn->step = real_min(turn->step, restart_step(turn->tree));
    rates_of(turn, turn->time, turn->state, turn->rates);
    turn->evaluations++;
    turn->ball = ball_of(turn->tree, turn->time, turn->state, turn->rates);
    if (turn->cycle_switches > TURN_SWITCHES_MOST)
        turn->status = CYCLE_CHATTERS;
}

/* Tries steps until one is accurate enough. */
static bool try_accurately(Turn *turn, double longest, Trial *trial) {
    double length = real_min(turn->step, longest);
    while (turn->status == CYCLE_GOOD) {
        try_step(turn, length, trial);
        if (turn->status != CYCLE_GOOD)
            break;
        double next = stepper_next(length, trial->error);
        if (trial->error <= 1) {
            turn->step = length < turn->step ? real_max(turn->step, next) : next;
            turn->step = real_min(turn->step, STEP_MOST * turn->tree->period);
            return true;
        }
        turn->step = length = next;
        if (!(length > 1e-15 * turn->tree->period))
            turn->status = CYCLE_DIVERGED;
    }
    return false;
}

/* Shortens a step over the end of a motor's revolution to that end. */
static void end_at_angle(Turn *turn, Trial *trial) {
    size_t angle = turn->tree->coordinates - 1;
    for (int i = 0; i < CORRECTIONS_MOST; i++) {
        double over = trial->state[angle] - 2 * M_PI;
        if ((i == 0 && over < 0) || fabs(over) < ANGLE_LOCATED)
            return;
        double better = trial->length - over / trial->rates[angle];
        if (!(better > 0) || fabs(better - trial->length) < INSTANT)
            return;
        try_step(turn, better, trial);
    }
}

/* True if the coupler is bent or stretched beyond what the equations describe. */
static bool is_bent(const Tree *tree, const double *state) {
    const double *stretch = state + 3, *bent = stretch + tree->axial;
    double shorter = 0;
    for (size_t n = 0; n < tree->bending; n++) {
        double eta = bent[n], zeta = bent[tree->bending + n];
        shorter += tree->slope[n] * tree->slope[n] / 4 * (eta * eta + zeta * zeta);
    }
    return shorter > BENT_MOST || (tree->axial && fabs(*stretch) > BENT_MOST * tree->length);
}

/* Returns how many steps a revolution may take. */
static double steps_most(const Tree *tree) {
    double fastest = tree->stiffness / (tree->end_mass + tree->mass / 3);
    if (tree->axial)
        fastest = real_max(fastest, tree->axial_stiffness / (tree->end_mass + tree->mass / 3));
    if (tree->bending)
        fastest = real_max(fastest, tree->sine_stiffness[tree->bending - 1] / (tree->mass / 2));
    return real_min(STEPS_MOST, STEPS_ANY + STEPS_PER_RADIAN * sqrt(fastest) * tree->period);
}

static void take(Turn *turn, const Trial *trial) {
    size_t states = 2 * turn->tree->coordinates;
    if (turn->place == BALL_CONTACT)
        turn->contact_time += trial->length;
    turn->time += trial->length;
    memcpy(turn->state, trial->state, states * sizeof(double));
    memcpy(turn->rates, trial->rates, states * sizeof(double));
    turn->ball = trial->ball;
    for (size_t i = 0; i < states; i++)
        if (!isfinite(turn->state[i]))
            turn->status = CYCLE_DIVERGED;
    if (is_bent(turn->tree, turn->state))
        turn->status = CYCLE_DIVERGED;
}

static void sample_path(const Turn *turn, const Path *path, const Trial *trial, Signal samples[SAMPLES + 1]) {
    samples[0] = signal_of(turn->tree, &turn->ball);
    for (int j = 1; j < SAMPLES; j++)
        samples[j] = path_signal(path, turn->tree, (double)j / SAMPLES);
    samples[SAMPLES] = signal_of(turn->tree, &trial->ball);
}

/* Ends the revolution when it is complete. */
static void end_revolution(Turn *turn) {
    const Tree *tree = turn->tree;
    size_t angle = tree->coordinates - 1;
    bool is_over =
        tree->turns ? turn->state[angle] >= 2 * M_PI - 2 * ANGLE_LOCATED : turn->time >= tree->period * (1 - 1e-15);
    if (is_over) {
        if (tree->turns)
            turn->state[angle] -= 2 * M_PI;
        turn->cycle++;
        turn->past += turn->time;
        turn_restore(turn, turn->state, turn->place, turn->step);
    } else if (tree->turns && turn->time > TURN_PERIODS_MOST * tree->period) {
        turn->status = CYCLE_DIVERGED;
    }
}

double turn_step(Turn *turn, double longest) {
    const Tree *tree = turn->tree;
    Trial trial;
    if (!tree->turns)
        longest = real_min(longest, tree->period - turn->time);
    if (!try_accurately(turn, longest, &trial))
        return 0;
    if (tree->turns)
        end_at_angle(turn, &trial);
    Path path = path_between(&turn->ball, &trial.ball, trial.length);
    Signal samples[SAMPLES + 1];
    sample_path(turn, &path, &trial, samples);
    Watch watches[WATCHES_MOST], *first = NULL;
    size_t count = watches_of(turn, watches);
    double part = 2;
    for (size_t i = 0; i < count; i++) {
        double rise = first_rise(&path, tree, &watches[i], samples, part);
        if (rise < part) {
            part = rise;
            first = &watches[i];
        }
    }
    if (first && part <= 0) {
        change_place(turn, first->next);
        return 0;
    }
    if (first) {
        locate(turn, first, part * trial.length, trial.length, &trial);
        path = path_between(&turn->ball, &trial.ball, trial.length);
        sample_path(turn, &path, &trial, samples);
    }
    if (turn->place == BALL_CONTACT && !turn->unwatched)
        watch_peak(turn, &path, samples);
    take(turn, &trial);
    if (first && turn->status == CYCLE_GOOD)
        change_place(turn, first->next);
    if (turn->status == CYCLE_GOOD)
        end_revolution(turn);
    return trial.length;
}

CycleStatus turn_cycle(Turn *turn) {
    for (size_t cycle = turn->cycle; turn->cycle == cycle && turn->status == CYCLE_GOOD;)
        turn_step(turn, HUGE_VAL);
    return turn->status;
}

void turn_restore(Turn *turn, const double *state, BallPlace place, double step) {
    const Tree *tree = turn->tree;
    memmove(turn->state, state, 2 * tree->coordinates * sizeof *state);
    turn->time = 0;
    turn->cycle_switches = 0;
    turn->cycle_steps = 0;
    turn->place = place;
    turn->step = step;
    rates_of(turn, 0, turn->state, turn->rates);
    turn->evaluations++;
    turn->ball = ball_of(tree, 0, turn->state, turn->rates);
}

void turn_set_state(Turn *turn, const double *state) {
    TreePose pose = tree_pose(turn->tree, 0, state);
    BallReading reading = ball_read(turn->tree, &pose);
    turn_restore(turn, state, ball_place(turn->tree, &reading), restart_step(turn->tree));
}

Turn turn_create(const Tree *tree, double tolerance) {
    Turn turn = {.tree = tree, .tolerance = tolerance, .steps_most = steps_most(tree)};
    double state[TREE_STATES_MOST];
    set_scales(&turn);
    tree_start(tree, state);
    turn_set_state(&turn, state);
    return turn;
}

double turn_force(const Turn *turn) {
    Signal signal = signal_of(turn->tree, &turn->ball);
    return turn->place == BALL_CONTACT ? real_max(signal.push, 0) : 0;
}

TreePose turn_pose(const Turn *turn) {
    return tree_pose(turn->tree, turn->time, turn->state);
}
