#include "cycle/survival.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "base/order.h"
#include "base/parallel.h"
#include "base/random.h"
#include "cycle/orbit.h"

enum { CHUNK = 100 /* cycles between two looks at whether a lane has settled */, TOGETHER_MOST = 16 /* lanes */ };

static const double SPREAD = 1e-6; /* of a state's length */
static const double NEAR_ORBIT = 0.05;
static const double ALIKE = 1e-3; /* of a peak: orbits whose largest peaks differ by less are one */

/* A lane: where it is, and what it did. */
typedef struct Lane {
    double *state, *peak; /* (states), (cycles) N, largest of each cycle */
    size_t used;          /* cycles before it settled */
    bool settled, failed;
    SurvivalAttractor attractor;
} Lane;

typedef struct Watch {
    Cycle cycle;
    const SurvivalTask *task;
    Lane *lanes;
} Watch;

/* Certifies the orbit that a lane is on; false: none near is stable. */
static bool certify(const Watch *watch, Lane *lane, size_t period) {
    Orbit orbit;
    if (orbit_settle(&orbit, watch->cycle, lane->state, period, NEAR_ORBIT, watch->task->stop) != ORBIT_GOOD)
        return false;
    lane->attractor = (SurvivalAttractor){
        .period = orbit.period, .peak = orbit_peak(&orbit, watch->cycle, watch->task->stop), .largest = orbit.largest};
    orbit_clear(&orbit);
    return true;
}

/* Takes in the next cycles of a lane. */
static void take_in(const Watch *watch, Lane *lane, const CycleRun *run) {
    for (size_t i = 0; i < run->recorded; i++)
        lane->peak[lane->used + i] = fmax(run->peak[CYCLE_SIDES * i], run->peak[CYCLE_SIDES * i + 1]);
    if (run->status != CYCLE_GOOD) {
        lane->failed = true;
        return;
    }
    Cycle cycle = watch->cycle;
    int period = section_period(run->deflection, run->velocity, run->recorded, 2 * M_PI / cycle_period(cycle),
                                cycle.kind->rest_tip(cycle.given));
    lane->settled = period > 0 && certify(watch, lane, (size_t)period);
    if (!lane->settled)
        lane->used += run->recorded;
}

static bool goes_on(const Watch *watch, const Lane *lane) {
    return !lane->settled && !lane->failed && lane->used < watch->task->cycles;
}

static void watch_group(void *context, size_t group) {
    const Watch *watch = context;
    size_t together = watch->cycle.kind->together;
    size_t states = cycle_states(watch->cycle), first = group * together, last = first + together;
    last = last < watch->task->lanes ? last : watch->task->lanes;
    size_t room = 4 * CHUNK + states;
    double *memory = memory_zeroed(together * room, sizeof *memory);
    for (size_t left = 1; left && !stop_requested(watch->task->stop);) {
        CycleRun runs[TOGETHER_MOST] = {0};
        Lane *whose[TOGETHER_MOST];
        left = 0;
        for (size_t i = first; i < last; i++) {
            Lane *lane = &watch->lanes[i];
            if (!goes_on(watch, lane))
                continue;
            double *own = memory + left * room;
            size_t ahead = watch->task->cycles - lane->used;
            whose[left] = lane;
            runs[left++] = (CycleRun){.start = lane->state,
                                      .cycles = ahead < CHUNK ? ahead : CHUNK,
                                      .peak = own,
                                      .deflection = own + 2 * CHUNK,
                                      .velocity = own + 3 * CHUNK,
                                      .end = own + 4 * CHUNK};
        }
        cycle_many(watch->cycle, runs, left, watch->task->stop);
        for (size_t i = 0; i < left && !stop_requested(watch->task->stop); i++) {
            memcpy(whose[i]->state, runs[i].end, states * sizeof *runs[i].end);
            take_in(watch, whose[i], &runs[i]);
        }
    }
    memory_free(memory);
}

/* Results -----------------------------------------------------------------------------------------------------------
 */

static void note_attractor(Survival *survival, const SurvivalAttractor *reached) {
    for (size_t i = 0; i < survival->attractor_count; i++) {
        SurvivalAttractor *known = &survival->attractors[i];
        if (known->period == reached->period && fabs(known->peak - reached->peak) <= ALIKE * known->peak) {
            known->lanes++;
            return;
        }
    }
    if (survival->attractor_count < SURVIVAL_ATTRACTORS_MOST) {
        survival->attractors[survival->attractor_count] = *reached;
        survival->attractors[survival->attractor_count++].lanes = 1;
    }
}

/* Returns after how many cycles a lane has a peak of at least `level`; HUGE_VAL: not. */
static double wait_of(const Lane *lane, size_t apart, double level) {
    for (size_t i = apart; i < lane->used; i++)
        if (lane->peak[i] >= level)
            return (double)(i + 1 - apart);
    return HUGE_VAL;
}

static SurvivalWait wait_for(const Lane *lanes, size_t count, size_t apart, double level) {
    double *wait = memory_zeroed(count, sizeof *wait);
    SurvivalWait result = {HUGE_VAL, HUGE_VAL, 0, 0};
    for (size_t i = 0; i < count; i++) {
        double cycles = wait_of(&lanes[i], apart, level);
        if (lanes[i].failed || (lanes[i].settled && isinf(cycles)))
            continue;
        wait[result.lanes++] = cycles;
        result.reached += isfinite(cycles);
    }
    qsort(wait, result.lanes, sizeof *wait, order_rising);
    if (result.lanes) {
        result.median = wait[(result.lanes - 1) / 2];
        result.most = wait[(size_t)ceil(0.95 * (double)result.lanes) - 1];
    }
    memory_free(wait);
    return result;
}

static void tell_peaks(Survival *survival, const Lane *lanes, size_t apart, const double *peaks) {
    size_t *used = memory_zeroed(survival->lanes, sizeof *used);
    for (size_t i = 0; i < survival->lanes; i++) {
        used[i] = lanes[i].used > apart ? lanes[i].used - apart : 0;
        for (size_t c = apart; c < lanes[i].used; c++)
            survival->largest = fmax(survival->largest, lanes[i].peak[c]);
    }
    survival->within[0] = wait_for(lanes, survival->lanes, apart, 0.95 * survival->largest);
    survival->within[1] = wait_for(lanes, survival->lanes, apart, 0.99 * survival->largest);
    if (survival->largest > 0)
        survival->extreme = extreme_estimate(peaks + apart, survival->lanes, survival->cycles, used, SURVIVAL_AHEAD);
    if (survival->extreme.high < survival->largest)
        survival->extreme.known = false; /* what was seen contradicts the extrapolation */
    if (survival->lanes * survival->cycles < SURVIVAL_AHEAD)
        survival->extreme.level = fmax(survival->extreme.level, survival->largest); /* it is among those ahead */
    memory_free(used);
}

/* Puts lanes at states of the second quarter of the section, evenly along it, each moved by a millionth of its length
 * at random: before, a motion may still remember its start, and later it may be on its way to an orbit. */
static void start_lanes(Lane *lanes, size_t count, const Section *section) {
    size_t first = section->count / 4, span = section->count / 2 - first;
    for (size_t i = 0; i < count; i++) {
        Random random = random_seed(1, i + 1);
        const double *from = section->state + (first + i * span / count) * section->states;
        double length = 0;
        for (size_t k = 0; k < section->states; k++)
            length += from[k] * from[k];
        length = sqrt(length / (double)section->states);
        for (size_t k = 0; k < section->states; k++)
            lanes[i].state[k] = from[k] + SPREAD * length * (2 * random_uniform(&random) - 1);
    }
}

SurvivalTask survival_task(const CycleKind *kind, int lanes, int jobs, const Stop *stop) {
    return (SurvivalTask){lanes == SURVIVAL_USUAL ? kind->lanes : (size_t)lanes, kind->lane_cycles, jobs, stop};
}

Survival survival_run(Cycle cycle, const Section *section, const SurvivalTask *task) {
    size_t states = cycle_states(cycle), apart = cycle.kind->lane_apart, together = cycle.kind->together, late = 0;
    Survival survival = {.lanes = task->lanes, .cycles = task->cycles};
    Lane *lanes = memory_zeroed(task->lanes, sizeof *lanes);
    double *place = memory_zeroed(task->lanes * states, sizeof *place),
           *peaks = memory_zeroed(task->lanes * (task->cycles + CHUNK), sizeof *peaks);
    for (size_t i = 0; i < task->lanes; i++) {
        lanes[i].state = place + i * states;
        lanes[i].peak = peaks + i * task->cycles;
    }
    start_lanes(lanes, task->lanes, section);
    Watch watch = {cycle, task, lanes};
    parallel_for(task->jobs, (task->lanes + together - 1) / together, watch_group, &watch);
    survival.whole = !stop_requested(task->stop);
    for (size_t i = 0; i < task->lanes; i++) {
        survival.settled += lanes[i].settled;
        survival.failed += lanes[i].failed;
        late += lanes[i].settled && lanes[i].used >= apart;
        survival.risk += lanes[i].used > apart ? (double)(lanes[i].used - apart) : 0;
        if (lanes[i].settled)
            note_attractor(&survival, &lanes[i].attractor);
    }
    survival.half_life = half_life_tell(late, survival.risk);
    tell_peaks(&survival, lanes, apart, peaks);
    memory_free(peaks);
    memory_free(place);
    memory_free(lanes);
    return survival;
}
