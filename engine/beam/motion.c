#include "beam/motion.h"

#include <assert.h>
#include <math.h>
#include <string.h>

#include "base/memory.h"

/* Places ---------------------------------------------------------------------------------------------------------- */

/* A switch comes when sign y(row) + offset, below 0 before, reaches 0; the offset is the clearance, times k for a
 * force, `side` times. */
typedef struct Way {
    RegimeRow row;
    int sign, side;
    MotionPlace to;
} Way;

enum { WAYS = 2 };

/* By the release, by the place. A place has one way or two. */
static const Way ways[2][MOTION_PLACES][WAYS] =
    {
        [RELEASE_FORCE] =
            {
                [MOTION_OPEN] = {{REGIME_TIP, 1, -1, MOTION_UPPER}, {REGIME_TIP, -1, -1, MOTION_LOWER}},
                [MOTION_UPPER] = {{REGIME_FORCE, -1, 1, MOTION_UPPER_LEAVING}},
                [MOTION_LOWER] = {{REGIME_FORCE, 1, 1, MOTION_LOWER_LEAVING}},
                [MOTION_UPPER_LEAVING] = {{REGIME_FORCE, 1, -1, MOTION_UPPER}, {REGIME_TIP, -1, 1, MOTION_OPEN}},
                [MOTION_LOWER_LEAVING] = {{REGIME_FORCE, -1, -1, MOTION_LOWER}, {REGIME_TIP, 1, 1, MOTION_OPEN}},
            },
        [RELEASE_GAP] =
            {
                [MOTION_OPEN] = {{REGIME_TIP, 1, -1, MOTION_UPPER}, {REGIME_TIP, -1, -1, MOTION_LOWER}},
                [MOTION_UPPER] = {{REGIME_TIP, -1, 1, MOTION_OPEN}},
                [MOTION_LOWER] = {{REGIME_TIP, 1, 1, MOTION_OPEN}},
            },
};

/* Of the wall in whose contact the place is. */
static double side_of(MotionPlace place) {
    return place == MOTION_UPPER ? 1 : place == MOTION_LOWER ? -1 : 0;
}

static const Regime *regime_of(const Motion *motion) {
    return motion_in_contact(motion->place) ? &motion->rig->contact : &motion->rig->free;
}

static const RigSteady *steady_of(const Motion *motion) {
    return motion_in_contact(motion->place) ? &motion->rig->steady_contact : &motion->rig->steady_free;
}

static double offset_of(const Rig *rig, const Way *way) {
    return way->side * rig->clearance * (way->row == REGIME_FORCE ? rig->stiffness : 1);
}

/* The state ------------------------------------------------------------------------------------------------------- */

/* Points into the motion's memory. */
static void lay_out(Motion *motion) {
    size_t states = motion->rig->free.states;
    double *at = motion->memory;
    RegimeVector *const vectors[] = {&motion->z, &motion->next, &motion->factor, &motion->trial, &motion->trial_factor};
    for (size_t v = 0; v < sizeof vectors / sizeof *vectors; v++, at += 2 * states)
        *vectors[v] = (RegimeVector){at, at + states};
    motion->state = at;
    motion->tangent = (RegimeVector){at + states, at + (1 + motion->tangents) * states};
}

Motion motion_create(const Rig *rig, size_t tangents) {
    Motion motion = {.rig = rig, .tangents = tangents};
    size_t states = rig->free.states;
    motion.memory_size = states * (11 + 2 * tangents);
    motion.memory = memory_allocate(motion.memory_size, sizeof *motion.memory);
    lay_out(&motion);
    double *rest = memory_allocate(states, sizeof *rest);
    motion_set_state(&motion, rest);
    memory_free(rest);
    return motion;
}

void motion_destroy(Motion *motion) {
    memory_free(motion->memory);
    *motion = (Motion){0};
}

void motion_copy(Motion *to, const Motion *from) {
    assert(to->rig == from->rig && to->memory_size == from->memory_size);
    double *memory = to->memory;
    memcpy(memory, from->memory, from->memory_size * sizeof *memory);
    *to = *from;
    to->memory = memory;
    lay_out(to);
}

/* Adds the steady part, `times` times. */
static void add_steady(const Motion *motion, double times, RegimeVector z) {
    const RigSteady *steady = steady_of(motion);
    double sine = times * motion->now.sine, cosine = times * motion->now.cosine, rest = times * side_of(motion->place);
    for (size_t j = 0; j < regime_of(motion)->blocks; j++) {
        z.re[j] += sine * steady->sine.re[j] + cosine * steady->cosine.re[j] + rest * steady->rest.re[j];
        z.im[j] += sine * steady->sine.im[j] + cosine * steady->cosine.im[j] + rest * steady->rest.im[j];
    }
}

/* The row's value (order 0), rate or second rate, of blocks at phase with this sine and cosine. */
static double measure(const Motion *motion, RegimeRow row, int order, RegimeVector z, double sine, double cosine) {
    const RigSteady *steady = steady_of(motion);
    const Regime *regime = regime_of(motion);
    double omega = motion->rig->omega, a = steady->row_sine[row], b = steady->row_cosine[row];
    double own = regime_measure(regime->blocks, regime->row[row][order], z);
    switch (order) {
    case 0:
        return own + a * sine + b * cosine + side_of(motion->place) * steady->row_rest[row];
    case 1:
        return own + omega * (a * cosine - b * sine);
    default:
        return own - omega * omega * (a * sine + b * cosine);
    }
}

/* Is this row asked for in the place the motion is in? */
static bool row_matters(const Motion *motion, RegimeRow row) {
    const Way *way = ways[motion->rig->release][motion->place];
    return way[0].row == row || (way[1].sign && way[1].row == row) ||
           (row == REGIME_FORCE && motion_in_contact(motion->place));
}

static void read_rows(const Motion *motion, RegimeVector z, double phase, MotionReading *reading) {
    sincos(motion->rig->omega * phase, &reading->sine, &reading->cosine);
    for (RegimeRow row = 0; row < REGIME_ROWS; row++)
        if (row_matters(motion, row)) {
            reading->value[row] = measure(motion, row, 0, z, reading->sine, reading->cosine);
            reading->rate[row] = measure(motion, row, 1, z, reading->sine, reading->cosine);
        }
}

void motion_state(const Motion *motion, double *state) {
    memcpy(motion->next.re, motion->z.re, regime_of(motion)->blocks * sizeof(double));
    memcpy(motion->next.im, motion->z.im, regime_of(motion)->blocks * sizeof(double));
    add_steady(motion, 1, motion->next);
    regime_state(regime_of(motion), motion->next, state);
}

/* Where the tip is, by its state alone. */
static MotionPlace tell_place(const Rig *rig, const double *state) {
    size_t n = rig->modes.count;
    double deflection = 0, velocity = 0;
    for (size_t i = 0; i < n; i++) {
        deflection += rig->modes.tip[i] * state[i] / rig->modes.frequency[i];
        velocity += rig->modes.tip[i] * state[n + i];
    }
    double up = deflection > 0 || (deflection == 0 && velocity >= 0) ? 1 : -1;
    double depth = up * deflection - rig->clearance;
    if (depth < 0 || (depth == 0 && rig->clearance > 0))
        return MOTION_OPEN;
    bool pushes = rig->release == RELEASE_GAP || rig->stiffness * depth + rig->damping * up * velocity >= 0;
    return up > 0 ? (pushes ? MOTION_UPPER : MOTION_UPPER_LEAVING) : (pushes ? MOTION_LOWER : MOTION_LOWER_LEAVING);
}

void motion_set_state(Motion *motion, const double *state) {
    motion->place = tell_place(motion->rig, state);
    motion->status = MOTION_GOOD;
    motion->phase = 0;
    motion->now.sine = 0;
    motion->now.cosine = 1;
    motion->cycle_switches = 0;
    regime_blocks(regime_of(motion), state, motion->z);
    add_steady(motion, -1, motion->z);
    read_rows(motion, motion->z, motion->phase, &motion->now);
}

static RegimeVector tangent_blocks(const Motion *motion, size_t index) {
    size_t from = index * motion->rig->free.states;
    return (RegimeVector){motion->tangent.re + from, motion->tangent.im + from};
}

void motion_tangent(const Motion *motion, size_t index, double *tangent) {
    regime_state(regime_of(motion), tangent_blocks(motion, index), tangent);
}

void motion_set_tangent(Motion *motion, size_t index, const double *tangent) {
    regime_blocks(regime_of(motion), tangent, tangent_blocks(motion, index));
}

void motion_unit_tangents(Motion *motion) {
    double *unit = memory_allocate(motion->rig->free.states, sizeof *unit);
    for (size_t t = 0; t < motion->tangents; t++) {
        unit[t] = 1;
        motion_set_tangent(motion, t, unit);
        unit[t] = 0;
    }
    memory_free(unit);
}

double motion_deflection(const Motion *motion) {
    return measure(motion, REGIME_TIP, 0, motion->z, motion->now.sine, motion->now.cosine);
}

double motion_velocity(const Motion *motion) {
    return measure(motion, REGIME_TIP, 1, motion->z, motion->now.sine, motion->now.cosine);
}

/* N, of the wall that is touched on the tip, towards the clearance, from the row's value. */
static double push_of(const Motion *motion, double value) {
    double side = side_of(motion->place);
    return side * value - motion->rig->stiffness * motion->rig->clearance;
}

double motion_force(const Motion *motion) {
    return motion_in_contact(motion->place) ? -side_of(motion->place) * push_of(motion, motion->now.value[REGIME_FORCE])
                                            : 0;
}

/* Switches -------------------------------------------------------------------------------------------------------- */

/* A function of the time since the motion's phase: sign y + offset, or its rate (order 1). */
typedef struct Curve {
    const Motion *motion;
    RegimeRow row;
    int order;
    double sign, offset;
} Curve;

/* The curve and its rate, `time` s on. */
static double follow(const Curve *curve, double time, double *rate) {
    const Motion *motion = curve->motion;
    const Regime *regime = regime_of(motion);
    double sine, cosine;
    RegimeVector z = motion->trial;
    regime_propagator(regime, time, motion->trial_factor);
    memcpy(z.re, motion->z.re, regime->blocks * sizeof *z.re);
    memcpy(z.im, motion->z.im, regime->blocks * sizeof *z.im);
    regime_advance(regime->blocks, motion->trial_factor.re, motion->trial_factor.im, z.re, z.im);
    sincos(motion->rig->omega * (motion->phase + time), &sine, &cosine);
    *rate = curve->sign * measure(motion, curve->row, curve->order + 1, z, sine, cosine);
    return curve->sign * measure(motion, curve->row, curve->order, z, sine, cosine) + curve->offset;
}

/* s: switches are located to this; beyond it, rounding decides. */
static const double SWITCH_RESOLUTION = 1e-15;

/* Where the curve, below 0 at `low` and not below at `high`, rises through 0: Newton's steps, halved brackets where
 * they leave it. */
static double find_root(const Curve *curve, double low, double high) {
    double at = low + (high - low) / 2;
    for (int i = 0; i < 100 && high - low > SWITCH_RESOLUTION; i++) {
        double rate, value = follow(curve, at, &rate);
        if (value < 0)
            low = at;
        else
            high = at;
        double next = at - value / rate;
        if (!(next > low && next < high))
            next = fabs(next - at) <= SWITCH_RESOLUTION ? at : low + (high - low) / 2;
        if (fabs(next - at) <= SWITCH_RESOLUTION)
            return next;
        at = next;
    }
    return high;
}

/* Where a row that first rises (`way` 1) and then falls within the step, or the other way round (-1), turns. */
static double find_turn(const Motion *motion, RegimeRow row, double way, double step) {
    Curve rate = {motion, row, 1, -way, 0};
    return find_root(&rate, 0, step);
}

/* The time of a way's switch within a step, or HUGE_VAL. From the values and rates at both ends. */
static double find_switch(Motion *motion, const Way *way, double step, const MotionReading *next) {
    double sign = way->sign, offset = offset_of(motion->rig, way);
    Curve curve = {motion, way->row, 0, sign, offset};
    double begin = sign * motion->now.value[way->row] + offset, begin_rate = sign * motion->now.rate[way->row];
    double end = sign * next->value[way->row] + offset, end_rate = sign * next->rate[way->row];
    double rate;
    if (begin >= 0 && end >= 0) { /* a switch was just here: has it been left since? */
        if (begin_rate >= 0)
            return 0;
        if (end_rate <= 0) /* still leaving, or out and back and turned again */
            return begin <= end ? 0 : HUGE_VAL;
        double turn = find_turn(motion, way->row, -sign, step);
        return follow(&curve, turn, &rate) < 0 ? find_root(&curve, turn, step) : 0;
    }
    if (end >= 0)
        return find_root(&curve, 0, step);
    if (begin >= 0 || begin_rate <= 0 || end_rate >= 0 || begin + begin_rate * step < 0)
        return HUGE_VAL;
    double turn = find_turn(motion, way->row, sign, step), top = follow(&curve, turn, &rate);
    if (motion->place == MOTION_OPEN && fabs(top) <= MOTION_GRAZE * motion->rig->clearance)
        motion->grazes++;
    return top >= 0 ? find_root(&curve, 0, turn) : HUGE_VAL;
}

/* The force's largest value within the step that is being made. */
static void note_peak(Motion *motion, double step, const MotionReading *end) {
    double side = side_of(motion->place);
    const MotionReading *begin = &motion->now;
    double *peak = &motion->peak[side > 0 ? 0 : 1];
    *peak = fmax(*peak, fmax(push_of(motion, begin->value[REGIME_FORCE]), push_of(motion, end->value[REGIME_FORCE])));
    if (side * begin->rate[REGIME_FORCE] > 0 && side * end->rate[REGIME_FORCE] < 0) {
        double rate, turn = find_turn(motion, REGIME_FORCE, side, step);
        Curve force = {motion, REGIME_FORCE, 0, 1, 0};
        *peak = fmax(*peak, push_of(motion, follow(&force, turn, &rate)));
    }
}

/* What the jump of the force at a switch does to a tangent: the force of the dashpot comes or goes. */
static void jump_tangent(const Rig *rig, double damping, double *tangent) {
    size_t n = rig->modes.count;
    double deflection = 0;
    for (size_t i = 0; i < n; i++)
        deflection += rig->modes.tip[i] * tangent[i] / rig->modes.frequency[i];
    for (size_t i = 0; i < n; i++)
        tangent[n + i] -= damping * rig->modes.tip[i] * deflection;
}

/* Into the next place: the state stays, its blocks are the other regime's. */
static void change_place(Motion *motion, MotionPlace to) {
    const Rig *rig = motion->rig;
    MotionPlace from = motion->place;
    if (to == MOTION_OPEN && rig->clearance == 0)
        to = from == MOTION_UPPER || from == MOTION_UPPER_LEAVING ? MOTION_LOWER : MOTION_UPPER;
    bool again =
        (from == MOTION_UPPER_LEAVING && to == MOTION_UPPER) || (from == MOTION_LOWER_LEAVING && to == MOTION_LOWER);
    double jump = (motion_in_contact(to) && !again ? rig->damping : 0) -
                  (motion_in_contact(from) && rig->release == RELEASE_GAP ? rig->damping : 0);
    double *state = motion->state;
    motion->switches++;
    if (++motion->cycle_switches > MOTION_SWITCHES_MOST)
        motion->status = MOTION_CHATTERS;
    const Regime *before = regime_of(motion);
    motion_state(motion, state);
    motion->place = to;
    const Regime *after = regime_of(motion);
    regime_blocks(after, state, motion->z);
    add_steady(motion, -1, motion->z);
    for (size_t t = 0; t < motion->tangents; t++) {
        regime_state(before, tangent_blocks(motion, t), state);
        jump_tangent(rig, jump, state);
        regime_blocks(after, state, tangent_blocks(motion, t));
    }
    read_rows(motion, motion->z, motion->phase, &motion->now);
}

/* Stepping -------------------------------------------------------------------------------------------------------- */

/* Moves blocks and tangents on; `next` has the moved blocks. */
static void go_on(Motion *motion, double step, RegimeVector factor, const MotionReading *end) {
    size_t blocks = regime_of(motion)->blocks;
    memcpy(motion->z.re, motion->next.re, blocks * sizeof(double));
    memcpy(motion->z.im, motion->next.im, blocks * sizeof(double));
    for (size_t t = 0; t < motion->tangents; t++) {
        RegimeVector tangent = tangent_blocks(motion, t);
        regime_advance(blocks, factor.re, factor.im, tangent.re, tangent.im);
    }
    motion->contact_time += motion_in_contact(motion->place) ? step : 0;
    motion->phase += step;
    motion->now = *end;
}

/* Puts the blocks `step` s on into `next`, by the factor that it returns, and reads them. */
static RegimeVector move_blocks(Motion *motion, double step, MotionReading *end) {
    const Regime *regime = regime_of(motion);
    RegimeVector factor = motion->factor;
    if (step == motion->rig->cell)
        factor = steady_of(motion)->hop;
    else
        regime_propagator(regime, step, factor);
    memcpy(motion->next.re, motion->z.re, regime->blocks * sizeof(double));
    memcpy(motion->next.im, motion->z.im, regime->blocks * sizeof(double));
    regime_advance(regime->blocks, factor.re, factor.im, motion->next.re, motion->next.im);
    read_rows(motion, motion->next, motion->phase + step, end);
    return factor;
}

/* The way whose switch comes first within the step, or NULL, and when. */
static const Way *first_switch(Motion *motion, double step, const MotionReading *end, double *when) {
    const Way *first = NULL, *way = ways[motion->rig->release][motion->place];
    *when = HUGE_VAL;
    for (int w = 0; w < WAYS && way[w].sign; w++) {
        double at = find_switch(motion, &way[w], step, end);
        if (at < *when) {
            *when = at;
            first = &way[w];
        }
    }
    return first;
}

double motion_step(Motion *motion, double longest) {
    double step = fmin(motion->rig->cell, longest), when;
    MotionReading end;
    RegimeVector factor = move_blocks(motion, step, &end);
    const Way *first = first_switch(motion, step, &end, &when);
    if (first) {
        step = when;
        factor = move_blocks(motion, step, &end);
    }
    if (motion_in_contact(motion->place))
        note_peak(motion, step, &end);
    go_on(motion, step, factor, &end);
    if (first)
        change_place(motion, first->to);
    return step;
}

MotionStatus motion_cycle(Motion *motion) {
    double period = motion->rig->period;
    while (motion->status == MOTION_GOOD && motion->phase < period)
        motion_step(motion, period - motion->phase);
    if (motion->status == MOTION_GOOD && !isfinite(motion->z.re[0] + motion->now.value[REGIME_TIP]))
        motion->status = MOTION_DIVERGED;
    motion->phase = 0;
    motion->now.sine = 0;
    motion->now.cosine = 1;
    motion->cycle++;
    motion->cycle_switches = 0;
    return motion->status;
}
