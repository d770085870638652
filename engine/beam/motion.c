#include "beam/motion.h"

#include <assert.h>
#include <math.h>
#include <string.h>

#include "base/memory.h"
#include "beam/jet.h"

/* Like fmin and fmax, but inlined. */
static inline double least(double a, double b) {
    return a < b ? a : b;
}

static inline double largest(double a, double b) {
    return a > b ? a : b;
}

/* Places ---------------------------------------------------------------------------------------------------------- */

/* A switch occurs when sign y(row) + offset rises through 0; the offset is the clearance (times k for a force) times
 * `side`. */
typedef struct Way {
    RegimeRow row;
    int sign, side;
    MotionPlace to;
} Way;

enum { WAYS = 2 };

/* Indexed by release rule and place; one or two possible switches each. */
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

/* Returns the larger number of blocks of the two regimes. */
static size_t room_of(const Rig *rig) {
    return rig->free.blocks > rig->contact.blocks ? rig->free.blocks : rig->contact.blocks;
}

/* Sets the pointers into the motion's memory. */
static void lay_out(Motion *motion) {
    size_t room = room_of(motion->rig);
    double *at = motion->memory;
    RegimeVector *const vectors[] = {&motion->z, &motion->next, &motion->factor, &motion->trial};
    for (size_t v = 0; v < sizeof vectors / sizeof *vectors; v++, at += 2 * room)
        *vectors[v] = (RegimeVector){at, at + room};
    motion->tangent = (RegimeVector){at, at + motion->tangents * room};
}

Motion motion_create(const Rig *rig, size_t tangents) {
    Motion motion = {.rig = rig, .tangents = tangents};
    size_t states = rig->free.states;
    motion.memory_size = room_of(rig) * (8 + 2 * tangents);
    motion.memory = memory_zeroed(motion.memory_size, sizeof *motion.memory);
    lay_out(&motion);
    double *rest = memory_zeroed(states, sizeof *rest);
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
    if (from->z.re != from->memory) {
        RegimeVector next = to->z;
        to->z = to->next;
        to->next = next;
    }
}

/* Adds `times` times the steady part. */
static void add_steady(const Motion *motion, double times, RegimeVector z) {
    const RigSteady *steady = steady_of(motion);
    double sine = times * motion->now.sine, cosine = times * motion->now.cosine,
           rest = times * motion_side(motion->place);
    for (size_t j = 0; j < regime_of(motion)->blocks; j++) {
        z.re[j] += sine * steady->sine.re[j] + cosine * steady->cosine.re[j] + rest * steady->rest.re[j];
        z.im[j] += sine * steady->sine.im[j] + cosine * steady->cosine.im[j] + rest * steady->rest.im[j];
    }
}

/* Computes the row's value and rate from blocks, given sine and cosine of the drive's phase. */
static void measure(const Motion *motion, RegimeRow row, RegimeVector z, MotionReading *reading) {
    const RigSteady *steady = steady_of(motion);
    const Regime *regime = regime_of(motion);
    double a = steady->row_sine[row], b = steady->row_cosine[row];
    reading->value[row] = regime_measure(regime->blocks, regime->row[row][0], z) + a * reading->sine +
                          b * reading->cosine + motion_side(motion->place) * steady->row_rest[row];
    reading->rate[row] = regime_measure(regime->blocks, regime->row[row][1], z) +
                         motion->rig->omega * (a * reading->cosine - b * reading->sine);
}

/* True if the row is needed in the motion's present place. */
static bool row_matters(const Motion *motion, RegimeRow row) {
    const Way *way = ways[motion->rig->release][motion->place];
    return way[0].row == row || (way[1].sign && way[1].row == row) ||
           (row == REGIME_FORCE && motion_in_contact(motion->place));
}

/* Computes sine and cosine of the drive `time` s later. */
static void read_drive(const Motion *motion, double time, MotionReading *reading) {
    *reading = motion->now;
    rig_turn_drive(motion->rig, time, &reading->sine, &reading->cosine);
}

/* Computes sine, cosine and the needed rows from blocks `time` s later. */
static void read_rows(const Motion *motion, RegimeVector z, double time, MotionReading *reading) {
    read_drive(motion, time, reading);
    for (RegimeRow row = 0; row < REGIME_ROWS; row++)
        if (row_matters(motion, row))
            measure(motion, row, z, reading);
}

void motion_state(const Motion *motion, double *state) {
    memcpy(motion->next.re, motion->z.re, regime_of(motion)->blocks * sizeof(double));
    memcpy(motion->next.im, motion->z.im, regime_of(motion)->blocks * sizeof(double));
    add_steady(motion, 1, motion->next);
    regime_state(regime_of(motion), motion->next, state);
}

/* Returns the place of the tip as its state alone determines it. */
static MotionPlace classify_place(const Rig *rig, const double *state) {
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
    motion->place = classify_place(motion->rig, state);
    motion->status = CYCLE_GOOD;
    motion->phase = motion->since = 0;
    motion->now.sine = 0;
    motion->now.cosine = 1;
    motion->cycle_switches = 0;
    regime_blocks(regime_of(motion), state, motion->z);
    add_steady(motion, -1, motion->z);
    read_rows(motion, motion->z, 0, &motion->now);
}

/* The place, the time since the last switch, the reading, the blocks. */
enum { SAVED_BLOCKS = 2 + (int)(sizeof(MotionReading) / sizeof(double)) };

size_t motion_saved_size(const Rig *rig) {
    return SAVED_BLOCKS + 2 * room_of(rig);
}

void motion_save(const Motion *motion, double *saved) {
    size_t blocks = regime_of(motion)->blocks;
    assert(motion->phase == 0);
    saved[0] = motion->place;
    saved[1] = motion->since;
    memcpy(saved + 2, &motion->now, sizeof motion->now);
    memcpy(saved + SAVED_BLOCKS, motion->z.re, blocks * sizeof *saved);
    memcpy(saved + SAVED_BLOCKS + blocks, motion->z.im, blocks * sizeof *saved);
}

void motion_restore(Motion *motion, const double *saved) {
    motion->place = (MotionPlace)saved[0];
    motion->status = CYCLE_GOOD;
    motion->phase = 0;
    motion->since = saved[1];
    motion->cycle_switches = 0;
    memcpy(&motion->now, saved + 2, sizeof motion->now);
    size_t blocks = regime_of(motion)->blocks;
    memcpy(motion->z.re, saved + SAVED_BLOCKS, blocks * sizeof *saved);
    memcpy(motion->z.im, saved + SAVED_BLOCKS + blocks, blocks * sizeof *saved);
}

static RegimeVector tangent_blocks(const Motion *motion, size_t index) {
    size_t from = index * room_of(motion->rig);
    return (RegimeVector){motion->tangent.re + from, motion->tangent.im + from};
}

void motion_tangent(const Motion *motion, size_t index, double *tangent) {
    regime_state(regime_of(motion), tangent_blocks(motion, index), tangent);
}

void motion_set_tangent(Motion *motion, size_t index, const double *tangent) {
    regime_blocks(regime_of(motion), tangent, tangent_blocks(motion, index));
}

void motion_unit_tangents(Motion *motion) {
    double *unit = memory_zeroed(motion->rig->free.states, sizeof *unit);
    for (size_t t = 0; t < motion->tangents; t++) {
        unit[t] = 1;
        motion_set_tangent(motion, t, unit);
        unit[t] = 0;
    }
    memory_free(unit);
}

static MotionReading read_tip(const Motion *motion) {
    MotionReading reading = motion->now;
    measure(motion, REGIME_TIP, motion->z, &reading);
    return reading;
}

double motion_deflection(const Motion *motion) {
    return read_tip(motion).value[REGIME_TIP];
}

double motion_velocity(const Motion *motion) {
    return read_tip(motion).rate[REGIME_TIP];
}

/* Returns the contact force on the tip towards the middle of the clearance, N, from the row's value. */
static double push_of(const Motion *motion, double value) {
    return motion_side(motion->place) * value - motion->rig->stiffness * motion->rig->clearance;
}

double motion_force(const Motion *motion) {
    return motion_in_contact(motion->place)
               ? -motion_side(motion->place) * push_of(motion, motion->now.value[REGIME_FORCE])
               : 0;
}

/* Switches -------------------------------------------------------------------------------------------------------- */

/* The function sign y + offset of a row of a motion. */
typedef struct Curve {
    const Motion *motion;
    RegimeRow row;
    double sign, offset;
} Curve;

/* Returns the Taylor polynomial about the cut nearest to `time` s from now; `*middle` receives the cut's time. */
static Jet follow(const Curve *curve, double time, double *middle) {
    static const double inverse[] = {1. / 2, 1. / 6, 1. / 12, 1. / 20, 1. / 30, 1. / 42, 1. / 56, 1. / 72};
    const Motion *motion = curve->motion;
    const Regime *regime = regime_of(motion);
    const RigSteady *steady = steady_of(motion);
    size_t cut = regime_nearest_cut(regime, time);
    double sine = motion->now.sine, cosine = motion->now.cosine, omega = motion->rig->omega;
    *middle = regime_cut_time(regime, cut);
    rig_turn_drive(motion->rig, *middle, &sine, &cosine);
    Jet jet;
    regime_advance(regime->blocks, regime_hop(regime, cut), motion->z, motion->trial);
    regime_expand(regime, curve->row, motion->trial, jet.term);
    double a = curve->sign * steady->row_sine[curve->row], b = curve->sign * steady->row_cosine[curve->row];
    double term = a * sine + b * cosine, next = omega * (a * cosine - b * sine);
    for (int m = 0; m < REGIME_TERMS; m++) {
        jet.term[m] = curve->sign * jet.term[m] + term;
        double after = -omega * omega * term * inverse[m];
        term = next;
        next = after;
    }
    jet.term[0] += curve->offset + curve->sign * motion_side(motion->place) * steady->row_rest[curve->row];
    return jet;
}

/* Returns the time at which the curve (or `turning` times its rate, if not 0), negative at `low` and not negative at
 * `high`, rises through 0, starting at `guess`; `*value`, unless NULL, receives the curve there. */
static double find_root(const Curve *curve, double turning, double low, double high, double guess, double *value) {
    double part = curve->motion->rig->cell / (double)regime_of(curve->motion)->cuts;
    for (;;) {
        double middle;
        Jet jet = follow(curve, guess > low && guess < high ? guess : low + (high - low) / 2, &middle);
        Jet sought = turning != 0 ? jet_rate(&jet, turning) : jet;
        double left = largest(low - middle, -part), right = least(high - middle, part);
        guess = -sought.term[0] / sought.term[1];
        if (high - low > JET_RESOLUTION && left + middle > low && jet_value(&sought, left) >= 0) {
            high = left + middle;
        } else if (high - low > JET_RESOLUTION && right + middle < high && jet_value(&sought, right) < 0) {
            low = right + middle;
        } else {
            double at = jet_rise(&sought, left, right, guess);
            if (value)
                *value = jet_value(&jet, at);
            return middle + at;
        }
        guess += middle;
    }
}

/* Returns the root of the cubic through the values and rates at both ends of a step; the cubic is negative at the
 * start. */
static double guess_root(double step, double begin, double begin_rate, double end, double end_rate) {
    double a = begin_rate * step, b = end_rate * step, rise = end - begin;
    double at = begin / (begin - end);
    for (int i = 0; i < 2; i++) {
        double square = 3 * rise - 2 * a - b, cube = a + b - 2 * rise;
        double value = begin + at * (a + at * (square + at * cube)), rate = a + at * (2 * square + 3 * at * cube);
        at = least(largest(at - value / rate, 0), 1);
    }
    return at * step;
}

/* Returns the extremum of a curve that rises and then falls within the step (`way` 1) or falls and then rises (-1),
 * and its value. */
static double find_turn(const Curve *curve, double way, double step, const MotionReading *end, double *value) {
    double begin = curve->motion->now.rate[curve->row];
    return find_root(curve, -way, 0, step, step * begin / (begin - end->rate[curve->row]), value);
}

/* Returns the time of a switch within a step, or HUGE_VAL, from the values and rates at both ends. */
static double find_switch(Motion *motion, const Way *way, double step, const MotionReading *next) {
    double sign = way->sign, offset = offset_of(motion->rig, way);
    Curve curve = {motion, way->row, sign, offset};
    double top;
    double begin = sign * motion->now.value[way->row] + offset, begin_rate = sign * motion->now.rate[way->row];
    double end = sign * next->value[way->row] + offset, end_rate = sign * next->rate[way->row];
    if (begin >= 0 && (begin_rate > 0 || (begin_rate == 0 && end > 0)))
        return 0;
    if (end >= 0) {
        if (begin >= 0 && begin_rate == 0)
            return HUGE_VAL;                  /* the tip rests there */
        if (begin_rate < 0 && end_rate > 0) { /* leaves, as just after a switch, and returns */
            double turn = find_turn(&curve, -1, step, next, &top);
            return top < 0 ? find_root(&curve, 0, turn, step, step, NULL) : 0;
        }
        if (begin >= 0) /* still leaving, or has left, returned and turned again */
            return begin <= end ? 0 : HUGE_VAL;
        return find_root(&curve, 0, 0, step, guess_root(step, begin, begin_rate, end, end_rate), NULL);
    }
    double bend = begin_rate - end_rate; /* the extremum lies below the intersection of the end tangents */
    if (begin >= 0 || begin_rate <= 0 || end_rate >= 0 ||
        begin * bend + begin_rate * (end - begin - end_rate * step) < 0)
        return HUGE_VAL;
    double turn = find_turn(&curve, 1, step, next, &top);
    if (motion->place == MOTION_OPEN && fabs(top) <= MOTION_GRAZE * motion->rig->clearance)
        motion->grazes++;
    return top >= 0 ? find_root(&curve, 0, 0, turn, turn, NULL) : HUGE_VAL;
}

/* Updates the force's largest value within the present step. */
static void note_peak(Motion *motion, double step, const MotionReading *end) {
    double side = motion_side(motion->place);
    const MotionReading *begin = &motion->now;
    double *peak = &motion->peak[side > 0 ? 0 : 1];
    *peak =
        largest(*peak, largest(push_of(motion, begin->value[REGIME_FORCE]), push_of(motion, end->value[REGIME_FORCE])));
    if (side * begin->rate[REGIME_FORCE] > 0 && side * end->rate[REGIME_FORCE] < 0) {
        Curve force = {motion, REGIME_FORCE, side, -motion->rig->stiffness * motion->rig->clearance};
        double push;
        find_turn(&force, 1, step, end, &push);
        *peak = largest(*peak, push);
    }
}

/* Computes z += times what. */
static void add(size_t blocks, double times, RegimeVector what, RegimeVector z) {
    for (size_t j = 0; j < blocks; j++) {
        z.re[j] += times * what.re[j];
        z.im[j] += times * what.im[j];
    }
}

/* Transforms the tangents at a switch: the force of the dashpot, which appears or disappears, jumps by `damping`
 * times the velocity. */
static void change_tangents(Motion *motion, const RigChange *change, const Regime *before, const Regime *after,
                            double damping) {
    for (size_t t = 0; t < motion->tangents; t++) {
        RegimeVector tangent = tangent_blocks(motion, t), changed = motion->trial;
        double deflection = regime_measure(before->blocks, before->row[REGIME_TIP][0], tangent);
        rig_change_blocks(change, before, after, tangent, changed);
        add(after->blocks, -damping * deflection, after->push, changed);
        memcpy(tangent.re, changed.re, after->blocks * sizeof(double));
        memcpy(tangent.im, changed.im, after->blocks * sizeof(double));
    }
}

/* Changes between free and contact: the state is continuous, its blocks are those of the other regime. */
static void change_regime(Motion *motion, MotionPlace to, double damping) {
    const Rig *rig = motion->rig;
    bool touches = motion_in_contact(to);
    const RigChange *change = touches ? &rig->touch : &rig->leave;
    const Regime *before = touches ? &rig->free : &rig->contact, *after = touches ? &rig->contact : &rig->free;
    double side = motion_side(touches ? to : motion->place);
    RegimeVector z = motion->next;
    rig_change_blocks(change, before, after, motion->z, z);
    add(after->blocks, motion->now.sine, change->sine, z);
    add(after->blocks, motion->now.cosine, change->cosine, z);
    add(after->blocks, side, change->rest, z);
    motion->next = motion->z;
    motion->z = z;
    change_tangents(motion, change, before, after, damping);
}

/* Enters the next place. */
static void change_place(Motion *motion, MotionPlace to) {
    const Rig *rig = motion->rig;
    MotionPlace from = motion->place;
    if (to == MOTION_OPEN && rig->clearance == 0)
        to = from == MOTION_UPPER || from == MOTION_UPPER_LEAVING ? MOTION_LOWER : MOTION_UPPER;
    bool again =
        (from == MOTION_UPPER_LEAVING && to == MOTION_UPPER) || (from == MOTION_LOWER_LEAVING && to == MOTION_LOWER);
    double jump = (motion_in_contact(to) && !again ? rig->damping : 0) -
                  (motion_in_contact(from) && rig->release == RELEASE_GAP ? rig->damping : 0);
    motion->switches++;
    if (++motion->cycle_switches > MOTION_SWITCHES_MOST)
        motion->status = CYCLE_CHATTERS;
    if (motion_in_contact(from) != motion_in_contact(to))
        change_regime(motion, to, jump);
    else if (motion_in_contact(from))
        add(rig->contact.blocks, motion_side(from) - motion_side(to), rig->steady_contact.rest, motion->z);
    motion->place = to;
    motion->since = 0;
    read_rows(motion, motion->z, 0, &motion->now);
}

/* Stepping -------------------------------------------------------------------------------------------------------- */

/* Advances blocks and tangents; `next` has the advanced blocks. */
static void go_on(Motion *motion, double step, RegimeVector factor, const MotionReading *end) {
    size_t blocks = regime_of(motion)->blocks;
    RegimeVector z = motion->next;
    motion->next = motion->z;
    motion->z = z;
    for (size_t t = 0; t < motion->tangents; t++)
        regime_advance(blocks, factor, tangent_blocks(motion, t), tangent_blocks(motion, t));
    motion->since += step;
    motion->contact_time += motion_in_contact(motion->place) ? step : 0;
    motion->phase += step;
    motion->now = *end;
}

/* Computes the blocks `step` s later into `next` and returns their factor. */
static RegimeVector move_blocks(Motion *motion, double step) {
    const Regime *regime = regime_of(motion);
    RegimeVector factor = motion->factor;
    if (step == motion->rig->cell)
        factor = regime_hop(regime, regime->cuts);
    else
        regime_propagator(regime, step, factor);
    regime_advance(regime->blocks, factor, motion->z, motion->next);
    return factor;
}

/* Returns the switch that occurs first within the step, or NULL, and its time. */
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

/* Makes a step, whose end is given in `next` and `end`, or its part before the first switch. */
static double make_step(Motion *motion, double step, RegimeVector factor, MotionReading *end) {
    double when;
    const Way *first = first_switch(motion, step, end, &when);
    bool watched = motion_in_contact(motion->place) && !motion->unwatched;
    if (first) { /* the new place has other rows */
        step = when;
        factor = move_blocks(motion, step);
        if (watched)
            read_rows(motion, motion->next, step, end);
        else
            read_drive(motion, step, end);
    }
    if (watched)
        note_peak(motion, step, end);
    go_on(motion, step, factor, end);
    if (first)
        change_place(motion, first->to);
    return step;
}

double motion_step(Motion *motion, double longest) {
    const Rig *rig = motion->rig;
    double first = motion_in_contact(motion->place) ? rig->first_contact : rig->first_free;
    double step = least(least(rig->cell, largest(first, motion->since)), longest);
    MotionReading end;
    RegimeVector factor = move_blocks(motion, step);
    read_rows(motion, motion->next, step, &end);
    return make_step(motion, step, factor, &end);
}

double motion_step_known(Motion *motion, MotionReading *end) {
    const Regime *regime = regime_of(motion);
    return make_step(motion, motion->rig->cell, regime_hop(regime, regime->cuts), end);
}

CycleStatus motion_end_cycle(Motion *motion) {
    if (motion->status == CYCLE_GOOD && !isfinite(motion->z.re[0] + motion->now.value[REGIME_TIP]))
        motion->status = CYCLE_DIVERGED;
    motion->phase = 0;
    motion->now.sine = 0;
    motion->now.cosine = 1;
    motion->cycle++;
    motion->cycle_switches = 0;
    return motion->status;
}

CycleStatus motion_cycle(Motion *motion) {
    double period = motion->rig->period;
    while (motion->status == CYCLE_GOOD && motion->phase < period)
        motion_step(motion, period - motion->phase);
    return motion_end_cycle(motion);
}
