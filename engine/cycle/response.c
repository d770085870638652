#include "cycle/response.h"

#include <math.h>

#include "base/digest.h"
#include "base/memory.h"
#include "base/stop.h"
#include "base/real.h"

/* Fraction of the state's length: a return this close starts Newton's iteration, and the orbit must then be as
 * close. A chaotic motion sometimes returns this close, but to an orbit that is unstable. */
static const double NEAR_RETURN = 0.05;

/* Per cycle: a tangent that grows faster excludes a nearby stable orbit, so Newton's iteration, by far the longest
 * part, is skipped. */
static const double GROWS = 0.1;

/* The time of the 0-1 test grows with the square of the cycles; it uses only the last ones. */
enum { ZERO_ONE_CYCLES = 4000 };

/* Fraction of the state's length: a motion this close to an orbit has settled on it. */
static const double SETTLED = 1e-3;

const char *response_verdict_name(ResponseVerdict verdict) {
    static const char *const names[] = {"periodic", "chaotic", "unresolved", "chatters", "diverged", "interrupted"};
    return names[verdict];
}

/* A motion and the data for its verdict. */
typedef struct Watch {
    CycleMotion motion;
    const Stop *stop;
    double *growth; /* (analysed.count) logarithm of the tangent's growth in each cycle */
    size_t growth_capacity;
    Section analysed; /* since the transient */
} Watch;

static bool goes_on(const Watch *watch) {
    return cycle_status(&watch->motion) == CYCLE_GOOD && !stop_requested(watch->stop);
}

static void pass_transient(Watch *watch, int cycles) {
    double growth = 0;
    for (int i = 0; i < cycles && goes_on(watch); i++) {
        cycle_run(&watch->motion);
        chaos_renew_tangents(&watch->motion, &growth);
    }
    double *peak = watch->motion.cycle.kind->peaks(watch->motion.own);
    peak[0] = peak[1] = 0;
}

/* Records the cycle that has just ended. */
static void note_cycle(Watch *watch) {
    if (cycle_status(&watch->motion) != CYCLE_GOOD)
        return;
    size_t at = watch->analysed.count;
    section_add(&watch->analysed, &watch->motion);
    watch->growth = memory_reserve(watch->growth, &watch->growth_capacity, at + 1, sizeof *watch->growth);
    watch->growth[at] = 0;
    chaos_renew_tangents(&watch->motion, &watch->growth[at]);
}

/* Adds one cycle to the trace, in as many parts as it has samples. */
static void trace_cycle(Trace *trace, CycleMotion *motion, size_t cycle) {
    const CycleKind *kind = motion->cycle.kind;
    double period = cycle_period(motion->cycle), *row = memory_zeroed(kind->column_count, sizeof *row);
    for (int part = 0; part < kind->samples; part++) {
        row[0] = (double)cycle * period + period * part / kind->samples;
        kind->sample(motion->own, part, row);
        trace_add(trace, row);
    }
    memory_free(row);
    cycle_run(motion);
}

static void record(Response *response, Watch *watch, int cycles) {
    CycleMotion *motion = &watch->motion;
    const CycleKind *kind = motion->cycle.kind;
    CycleTally before = kind->tally(motion->own);
    response->digest = DIGEST_START;
    response->start = memory_zeroed(motion->states, sizeof *response->start);
    kind->state(motion->own, response->start);
    for (int i = 0; i < cycles && goes_on(watch); i++) {
        if (i < RESPONSE_TRACE_CYCLES)
            trace_cycle(&response->trace, motion, (size_t)i);
        else
            cycle_run(motion);
        if (cycle_status(motion) == CYCLE_GOOD)
            section_add(&response->section, motion);
        for (size_t side = 0; cycle_status(motion) == CYCLE_GOOD && side < CYCLE_SIDES; side++)
            kind->peaks(motion->own)[side] = response->section.peak[2 * (response->section.count - 1) + side];
        note_cycle(watch);
    }
    const Section *section = &response->section;
    for (size_t i = 0; i < section->count * section->states; i++)
        response->digest = digest_mix(response->digest, section->state[i]);
    response->peaks = section_peaks(section);
    CycleTally after = kind->tally(motion->own);
    double seen = fmax(1, (double)section->count);
    response->switches = (double)(after.switches - before.switches) / seen;
    response->contact_share = (after.contact_time - before.contact_time) / (seen * cycle_period(motion->cycle));
    response->grazes = after.grazes - before.grazes;
}

/* Replaces an orbit found with a multiple of its period by the orbit with its own period. Returns false if
 * interrupted. */
static bool reduce_period(Orbit *orbit, Cycle cycle, const Stop *stop) {
    for (size_t period = 1; period < orbit->period; period++) {
        Orbit shorter;
        OrbitAnswer answer =
            orbit->period % period ? ORBIT_NONE : orbit_find(&shorter, cycle, orbit->point, period, stop);
        if (answer == ORBIT_INTERRUPTED)
            return false;
        if (answer == ORBIT_NONE)
            continue;
        if (orbit_distance(&shorter, cycle, orbit->point) < SETTLED) {
            orbit_clear(orbit);
            *orbit = shorter;
            return true;
        }
        orbit_clear(&shorter);
    }
    return true;
}

/* True if the tangent grew in the last quarter of the record. */
static bool tangent_grows(const Watch *watch) {
    size_t count = watch->analysed.count, last = count / 4 > 0 ? count / 4 : 1;
    double sum = 0;
    for (size_t i = count - last; i < count; i++)
        sum += watch->growth[i];
    return sum > GROWS * (double)last;
}

/* Finds the stable orbit near the motion. */
static OrbitAnswer find_orbit(Response *response, const Watch *watch) {
    const Section *seen = &watch->analysed;
    Cycle cycle = watch->motion.cycle;
    double rest = cycle_rest_state(cycle);
    if (tangent_grows(watch))
        return ORBIT_NONE;
    for (size_t period = 1; period <= ORBIT_PERIOD_MOST && period < seen->count; period++) {
        Orbit orbit;
        OrbitAnswer answer = section_return(seen, period, rest) > NEAR_RETURN
                                 ? ORBIT_NONE
                                 : orbit_find(&orbit, cycle, section_last(seen), period, watch->stop);
        if (answer == ORBIT_INTERRUPTED)
            return ORBIT_INTERRUPTED;
        if (answer == ORBIT_NONE)
            continue;
        if (orbit_is_stable(&orbit) && orbit_distance(&orbit, cycle, section_last(seen)) < NEAR_RETURN) {
            bool whole = reduce_period(&orbit, cycle, watch->stop);
            if (whole)
                response->orbit = orbit;
            else
                orbit_clear(&orbit);
            return whole ? ORBIT_GOOD : ORBIT_INTERRUPTED;
        }
        orbit_clear(&orbit);
    }
    return ORBIT_NONE;
}

static ResponseVerdict bad_verdict(const CycleMotion *motion) {
    return cycle_status(motion) == CYCLE_CHATTERS ? RESPONSE_CHATTERS : RESPONSE_DIVERGED;
}

static bool is_chaotic(const Response *response) {
    return response->exponent.value - 3 * response->exponent.error > 0 && response->zero_one > RESPONSE_ZERO_ONE_LEAST;
}

static void note_orbit(Response *response, Cycle cycle) {
    response->settled = orbit_distance(&response->orbit, cycle, response->section.state) < SETTLED;
    response->exponent = (ChaosExponent){real_log(response->orbit.largest) / (double)response->orbit.period, 0};
    response->zero_one = NAN;
}

/* Forgets the exponent and the 0-1 test of fewer cycles than the verdict needs. */
static ResponseVerdict interrupt(Response *response) {
    response->exponent = (ChaosExponent){NAN, NAN};
    response->zero_one = NAN;
    return RESPONSE_INTERRUPTED;
}

/* Continues, doubling the number of cycles each time, until a verdict is reached. */
static ResponseVerdict decide(Response *response, Watch *watch) {
    const CycleKind *kind = watch->motion.cycle.kind;
    for (size_t cycles = kind->cycles_least;; cycles *= 2) {
        switch (watch->analysed.count > 1 ? find_orbit(response, watch) : ORBIT_NONE) {
        case ORBIT_GOOD:
            note_orbit(response, watch->motion.cycle);
            return RESPONSE_PERIODIC;
        case ORBIT_INTERRUPTED:
            return interrupt(response);
        case ORBIT_NONE:
            break;
        }
        if (is_chaotic(response))
            return RESPONSE_CHAOTIC;
        if (cycles > kind->cycles_most)
            return RESPONSE_UNRESOLVED;
        while (watch->analysed.count < cycles && goes_on(watch)) {
            cycle_run(&watch->motion);
            note_cycle(watch);
        }
        if (cycle_status(&watch->motion) != CYCLE_GOOD)
            return bad_verdict(&watch->motion);
        if (watch->analysed.count < cycles)
            return interrupt(response);
        response->exponent = chaos_exponent(watch->growth, watch->analysed.count);
        size_t last = watch->analysed.count < ZERO_ONE_CYCLES ? watch->analysed.count : ZERO_ONE_CYCLES;
        response->zero_one = chaos_zero_one(watch->analysed.deflection + watch->analysed.count - last, last);
    }
}

void response_run(Response *response, Cycle cycle, int transient, int cycles, const double *start, const Stop *stop) {
    *response = (Response){.verdict = RESPONSE_INTERRUPTED, .exponent = {NAN, NAN}, .zero_one = NAN};
    trace_init(&response->trace, cycle.kind->columns, cycle.kind->column_count);
    Watch watch = {.motion = cycle_create(cycle, 1), .stop = stop};
    if (start)
        cycle.kind->set_state(watch.motion.own, start);
    pass_transient(&watch, transient);
    record(response, &watch, cycles);
    if (cycle_status(&watch.motion) != CYCLE_GOOD)
        response->verdict = bad_verdict(&watch.motion);
    else if (response->section.count == (size_t)cycles)
        response->verdict = decide(response, &watch);
    response->cycles = watch.analysed.count;
    cycle_destroy(&watch.motion);
    response->analysed = watch.analysed;
    memory_free(watch.growth);
}

void response_clear(Response *response) {
    memory_free(response->start);
    section_clear(&response->section);
    section_clear(&response->analysed);
    trace_clear(&response->trace);
    orbit_clear(&response->orbit);
}
