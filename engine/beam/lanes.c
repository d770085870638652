#include "beam/lanes.h"

#include <math.h>
#include <string.h>

#include "base/memory.h"
#include "base/stop.h"

/* Each lane is one motion; the lanes' blocks are interleaved. While a lane is open or in contact and no event can
 * occur within a cell, it advances together with the others by vector instructions; otherwise motion_step advances
 * it alone. Both use the same arithmetic in the same order, so that the bits equal those of a motion alone. */
enum { LANES = 8 };

/* Aligned as a line of the cache: a vector across two lines takes twice as long. */
enum { LINE = LANES * sizeof(double) };
typedef double Pack __attribute__((vector_size(LINE), aligned(LINE)));

/* Half vectors, for comparisons, which more processors support. */
typedef double Half __attribute__((vector_size(LANES / 2 * sizeof(double)), aligned(8), may_alias));
typedef int64_t Mask __attribute__((vector_size(LANES / 2 * sizeof(int64_t)), aligned(8), may_alias));

typedef struct LaneVector {
    Pack *re, *im; /* (blocks) */
} LaneVector;

/* The part of a lane that changes with every hop. */
typedef struct LaneMoment {
    LaneVector z;
    Pack sine, cosine, value, rate; /* of the row that matters: tip deflection when open, force in contact */
    Pack phase, top;                /* s; N, largest contact force since the lane last stepped alone */
} LaneMoment;

typedef struct Lane {
    Rig rig; /* shares modes and regimes with the common rig */
    Motion motion;
    LanesRun *run;     /* NULL: idle */
    int cycle;         /* of the run */
    MotionPlace place; /* place when it last joined the pack */
} Lane;

typedef struct Lanes {
    const Rig *rig;
    size_t blocks;
    LaneMoment moments[2], *now, *next;
    LaneVector hop, row[2];                                   /* factor of a hop; row and its rate */
    Pack turn_sine, turn_cosine, omega, wave_a, wave_b, rest; /* of the drive; steady part of the row */
    Pack low, high;                                           /* an event occurs when the row leaves this range */
    Pack period;                                              /* s */
    Pack side, watched, offset; /* of the contact, 0: none, or peaks are not recorded; N */
    int64_t busy[LANES];        /* lanes in which an event occurs within the cell */
    Lane lane[LANES];
    double *memory;
} Lanes;

/* Advances all lanes by one cell into `next`; `busy` marks the lanes for which the result is invalid. */

static inline __attribute__((always_inline)) void hop_blocks(Lanes *lanes) {
    const LaneVector from = lanes->now->z, to = lanes->next->z, hop = lanes->hop;
    const LaneVector first = lanes->row[0], second = lanes->row[1];
    const size_t blocks = lanes->blocks;
    Pack value[REGIME_WIDTH] = {{0}}, rate[REGIME_WIDTH] = {{0}};
    for (size_t j = 0; j < blocks; j += REGIME_WIDTH) {
#pragma GCC unroll 4 /* the sums stay in registers */
        for (size_t q = 0; q < REGIME_WIDTH; q++) {
            const Pack a = from.re[j + q], b = from.im[j + q], c = hop.re[j + q], d = hop.im[j + q];
            const Pack re = a * c - b * d, im = a * d + b * c;
            value[q] += first.re[j + q] * re - first.im[j + q] * im;
            rate[q] += second.re[j + q] * re - second.im[j + q] * im;
            to.re[j + q] = re;
            to.im[j + q] = im;
        }
    }
    lanes->next->value = (value[0] + value[1]) + (value[2] + value[3]);
    lanes->next->rate = (rate[0] + rate[1]) + (rate[2] + rate[3]);
}

static inline __attribute__((always_inline)) void hop_all(Lanes *lanes, double cell) {
    const LaneMoment *now = lanes->now;
    LaneMoment *next = lanes->next;
    hop_blocks(lanes);
    next->sine = now->sine * lanes->turn_cosine + now->cosine * lanes->turn_sine;
    next->cosine = now->cosine * lanes->turn_cosine - now->sine * lanes->turn_sine;
    next->value = next->value + lanes->wave_a * next->sine + lanes->wave_b * next->cosine + lanes->rest;
    next->rate = next->rate + lanes->omega * (lanes->wave_a * next->cosine - lanes->wave_b * next->sine);
    next->phase = now->phase + cell;
}

#define HALF(pack_) (((const Half *)&(pack_))[half])

/* Marks the lanes that switch, turn or peak within the cell; updates the peak force of the others. */
static inline __attribute__((always_inline)) void find_busy(Lanes *lanes, double cell, size_t half) {
    const LaneMoment *now = lanes->now;
    LaneMoment *next = lanes->next;
    Half begin = HALF(now->value), end = HALF(next->value);
    Half begin_rate = HALF(now->rate), end_rate = HALF(next->rate);
    Half high = HALF(lanes->high), low = HALF(lanes->low), watched = HALF(lanes->watched);
    Half push = HALF(lanes->side) * end - HALF(lanes->offset), top = HALF(now->top);
    Half bend = begin_rate - end_rate, reach = begin * bend + begin_rate * (end - begin - end_rate * cell);
    Mask higher = push > top;
    Mask outside = (end >= high) | (end <= low) | (begin >= high) | (begin <= low);
    Mask turns =
        (begin_rate * end_rate < 0) & (((bend > 0) & (reach >= high * bend)) | ((bend < 0) & (reach >= low * bend)));
    Mask peaks = (watched * begin_rate > 0) & (watched * end_rate < 0);
    Mask over = HALF(lanes->period) - HALF(now->phase) <= cell;
    ((Half *)&next->top)[half] = (Half)(((Mask)push & higher) | ((Mask)top & ~higher));
    ((Mask *)lanes->busy)[half] = outside | turns | peaks | over;
}

static inline __attribute__((always_inline)) void hop_and_look(Lanes *lanes, double cell) {
    hop_all(lanes, cell);
    find_busy(lanes, cell, 0);
    find_busy(lanes, cell, 1);
}

/* The same code compiled for wider vectors, chosen at run time. */
#if defined __x86_64__
__attribute__((target("avx512f,avx512dq"))) static void hop_eight(Lanes *lanes, double cell) {
    hop_and_look(lanes, cell);
}

__attribute__((target("avx2"))) static void hop_four(Lanes *lanes, double cell) {
    hop_and_look(lanes, cell);
}
#endif

static void hop_two(Lanes *lanes, double cell) {
    hop_and_look(lanes, cell);
}

static void hop_lanes(Lanes *lanes) {
    double cell = lanes->rig->cell;
#if defined __x86_64__
    if (__builtin_cpu_supports("avx512dq")) {
        hop_eight(lanes, cell);
        return;
    }
    if (__builtin_cpu_supports("avx2")) {
        hop_four(lanes, cell);
        return;
    }
#endif
    hop_two(lanes, cell);
}

/* Lanes and motions ------------------------------------------------------------------------------------------------ */

static RegimeRow row_of(const Motion *motion) {
    return motion_in_contact(motion->place) ? REGIME_FORCE : REGIME_TIP;
}

/* True if the motion can hop now and while its place stays the same. */
static bool can_hop(const Lanes *lanes, const Motion *motion) {
    const Rig *rig = motion->rig;
    bool touches = motion_in_contact(motion->place);
    double first = touches ? rig->first_contact : rig->first_free;
    return rig->cell == lanes->rig->cell && (first == rig->cell || motion->since >= rig->cell) &&
           (motion->place == MOTION_OPEN || (touches && rig->release == RELEASE_FORCE));
}

static void take_lane(const LaneMoment *moment, size_t l, RegimeRow row, RegimeVector z, MotionReading *reading,
                      size_t blocks) {
    for (size_t j = 0; j < blocks; j++) {
        z.re[j] = moment->z.re[j][l];
        z.im[j] = moment->z.im[j][l];
    }
    reading->sine = moment->sine[l];
    reading->cosine = moment->cosine[l];
    reading->value[row] = moment->value[l];
    reading->rate[row] = moment->rate[l];
}

/* Copies the lane from the pack to its motion, then advances to the event within the cell or to the cell's end. */
static void leave_pack(Lanes *lanes, size_t l) {
    const LaneMoment *now = lanes->now;
    Motion *motion = &lanes->lane[l].motion;
    RegimeRow row = row_of(motion);
    take_lane(now, l, row, motion->z, &motion->now, lanes->blocks);
    motion->phase = now->phase[l];
    if (lanes->watched[l] != 0) {
        double *peak = &motion->peak[lanes->side[l] > 0 ? 0 : 1];
        *peak = fmax(*peak, now->top[l]);
    }
    if (lanes->period[l] - motion->phase <= lanes->rig->cell) {
        motion_step(motion, lanes->period[l] - motion->phase);
    } else {
        MotionReading end = motion->now;
        take_lane(lanes->next, l, row, motion->next, &end, lanes->blocks);
        motion_step_known(motion, &end);
    }
}

/* Sets a lane's part of a vector; blocks that the regime does not have are empty. */
static void set_vector(const Lanes *lanes, LaneVector vector, size_t l, size_t blocks, RegimeVector what) {
    for (size_t j = 0; j < lanes->blocks; j++) {
        vector.re[j][l] = j < blocks ? what.re[j] : 0;
        vector.im[j][l] = j < blocks ? what.im[j] : 0;
    }
}

/* Sets everything that depends on the place and the run. */
static void set_place(Lanes *lanes, size_t l) {
    const Motion *motion = &lanes->lane[l].motion;
    const Rig *rig = motion->rig;
    bool touches = motion_in_contact(motion->place);
    const Regime *regime = touches ? &rig->contact : &rig->free;
    const RigSteady *steady = touches ? &rig->steady_contact : &rig->steady_free;
    RegimeRow row = row_of(motion);
    set_vector(lanes, lanes->hop, l, regime->blocks, regime_hop(regime, regime->cuts));
    for (int order = 0; order < 2; order++)
        set_vector(lanes, lanes->row[order], l, regime->blocks, regime->row[row][order]);
    double side = motion_side(motion->place), offset = touches ? rig->stiffness * rig->clearance : 0;
    lanes->wave_a[l] = steady->row_sine[row];
    lanes->wave_b[l] = steady->row_cosine[row];
    lanes->rest[l] = side * steady->row_rest[row];
    lanes->high[l] = touches ? (side > 0 ? HUGE_VAL : -offset) : rig->clearance;
    lanes->low[l] = touches ? (side > 0 ? offset : -HUGE_VAL) : -rig->clearance;
    lanes->side[l] = side;
    lanes->offset[l] = offset;
    lanes->omega[l] = rig->omega;
    lanes->turn_sine[l] = rig->cell_sine;
    lanes->turn_cosine[l] = rig->cell_cosine;
    lanes->period[l] = rig->period;
}

/* Copies a motion into the next pack. */
static void join_pack(Lanes *lanes, size_t l) {
    const Motion *motion = &lanes->lane[l].motion;
    LaneMoment *next = lanes->next;
    RegimeRow row = row_of(motion);
    if (motion->place != lanes->lane[l].place)
        set_place(lanes, l);
    lanes->lane[l].place = motion->place;
    lanes->watched[l] = motion->unwatched ? 0 : lanes->side[l];
    for (size_t j = 0; j < lanes->blocks; j++) {
        next->z.re[j][l] = motion->z.re[j];
        next->z.im[j][l] = motion->z.im[j];
    }
    next->sine[l] = motion->now.sine;
    next->cosine[l] = motion->now.cosine;
    next->value[l] = motion->now.value[row];
    next->rate[l] = motion->now.rate[row];
    next->phase[l] = motion->phase;
    next->top[l] = lanes->side[l] * motion->now.value[row] - lanes->offset[l];
}

/* Makes the lane idle: no event can occur in it. */
static void make_idle(Lanes *lanes, size_t l) {
    LaneMoment *next = lanes->next;
    for (size_t j = 0; j < lanes->blocks; j++)
        next->z.re[j][l] = next->z.im[j][l] = 0;
    next->sine[l] = next->cosine[l] = next->value[l] = next->rate[l] = next->phase[l] = next->top[l] = 0;
    lanes->rest[l] = lanes->wave_a[l] = lanes->wave_b[l] = lanes->side[l] = lanes->watched[l] = 0;
    lanes->high[l] = lanes->period[l] = HUGE_VAL;
    lanes->low[l] = -HUGE_VAL;
}

/* Runs ------------------------------------------------------------------------------------------------------------- */

static void begin_run(Lanes *lanes, size_t l, LanesRun *run) {
    Lane *lane = &lanes->lane[l];
    *lane = (Lane){
        .rig = rig_share(lanes->rig, run->frequency, run->force, run->clearance), .run = run, .place = MOTION_PLACES};
    lane->motion = motion_create(&lane->rig, 0);
    lane->motion.unwatched = run->transient_cycles > 0;
    if (run->start)
        motion_set_state(&lane->motion, run->start);
    run->recorded = 0;
}

static void end_run(Lanes *lanes, size_t l) {
    Lane *lane = &lanes->lane[l];
    lane->run->status = lane->motion.status;
    if (lane->run->end)
        motion_state(&lane->motion, lane->run->end);
    motion_destroy(&lane->motion);
    rig_clear_shared(&lane->rig);
    lane->run = NULL;
}

/* Records the cycle that has just ended; false: the run ends with it. */
static bool note_cycle(Lane *lane) {
    LanesRun *run = lane->run;
    Motion *motion = &lane->motion;
    if (motion_end_cycle(motion) != CYCLE_GOOD)
        return false;
    if (lane->cycle >= run->transient_cycles) {
        size_t at = run->recorded++, states = motion->rig->free.states;
        if (run->peak)
            memcpy(run->peak + 2 * at, motion->peak, sizeof motion->peak);
        if (run->deflection)
            run->deflection[at] = motion_deflection(motion);
        if (run->velocity)
            run->velocity[at] = motion_velocity(motion);
        if (run->section)
            motion_state(motion, run->section + at * states);
    }
    motion->peak[0] = motion->peak[1] = 0;
    motion->unwatched = ++lane->cycle < run->transient_cycles;
    return lane->cycle < run->transient_cycles + run->cycles;
}

/* Advances a lane alone until it can hop with the others; false: its run has ended. */
static bool step_alone(const Lanes *lanes, Lane *lane) {
    Motion *motion = &lane->motion;
    const Rig *rig = motion->rig;
    for (;;) {
        if ((motion->phase >= rig->period || motion->status != CYCLE_GOOD) && !note_cycle(lane))
            return false;
        if (can_hop(lanes, motion) && rig->period - motion->phase > rig->cell)
            return true;
        motion_step(motion, rig->period - motion->phase);
    }
}

/* Advances a lane that has an event, and starts further runs in it when its own have ended. */
static void serve_lane(Lanes *lanes, size_t l, LanesRun **more, const LanesRun *last) {
    Lane *lane = &lanes->lane[l];
    bool goes_on = false;
    if (lane->run) {
        leave_pack(lanes, l);
        goes_on = step_alone(lanes, lane);
    }
    while (!goes_on) {
        if (lane->run)
            end_run(lanes, l);
        if (*more == last) {
            make_idle(lanes, l);
            return;
        }
        begin_run(lanes, l, (*more)++);
        goes_on = step_alone(lanes, lane);
    }
    join_pack(lanes, l);
}

static bool any_runs(const Lanes *lanes) {
    for (size_t l = 0; l < LANES; l++)
        if (lanes->lane[l].run)
            return true;
    return false;
}

static LaneVector take(double **at, size_t blocks) {
    LaneVector taken = {(Pack *)(void *)*at, (Pack *)(void *)(*at + blocks * LANES)};
    *at += 2 * blocks * LANES;
    return taken;
}

void lanes_run(const Rig *rig, LanesRun *runs, size_t count, const Stop *stop) {
    size_t blocks = rig->free.blocks > rig->contact.blocks ? rig->free.blocks : rig->contact.blocks;
    Lanes lanes = {.rig = rig, .blocks = blocks, .memory = memory_zeroed((10 * blocks + 1) * LANES, sizeof(double))};
    double *at = lanes.memory;
    while ((uintptr_t)at % LINE)
        at++;
    lanes.now = &lanes.moments[0];
    lanes.next = &lanes.moments[1];
    lanes.now->z = take(&at, blocks);
    lanes.next->z = take(&at, blocks);
    lanes.hop = take(&at, blocks);
    lanes.row[0] = take(&at, blocks);
    lanes.row[1] = take(&at, blocks);
    LanesRun *more = runs;
    for (size_t l = 0; l < LANES; l++)
        lanes.busy[l] = -1;
    do {
        for (size_t l = 0; l < LANES; l++)
            if (lanes.busy[l])
                serve_lane(&lanes, l, &more, runs + count);
        LaneMoment *next = lanes.next;
        lanes.next = lanes.now;
        lanes.now = next;
        hop_lanes(&lanes);
    } while (any_runs(&lanes) && !stop_requested(stop));
    for (size_t l = 0; l < LANES; l++)
        if (lanes.lane[l].run)
            end_run(&lanes, l);
    for (; more < runs + count; more++) {
        more->recorded = 0;
        more->status = CYCLE_GOOD;
    }
    memory_free(lanes.memory);
}
