#include "cycle/response.h"

#include <math.h>
#include <string.h>

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

/* Cycles from whose work that of all planned ones is foreseen, and by how much it may be overrated. */
enum { FORESEEN = 2, DEARER = 2 };

/* The time of the 0-1 test grows with the square of the cycles; it uses only the last ones. */
enum { ZERO_ONE_CYCLES = 4000 };

const char *response_verdict_name(ResponseVerdict verdict) {
    static const char *const names[] = {"periodic", "quasi-periodic", "chaotic",   "transient",  "undetermined",
                                        "chatters", "diverged",       "too stiff", "interrupted"};
    return names[verdict];
}

const char *response_name(const Response *response) {
    return response->verdict == RESPONSE_PERIODIC && !response->peaks.count ? "without contact"
                                                                            : response_verdict_name(response->verdict);
}

bool response_is_told(ResponseVerdict verdict) {
    return verdict < RESPONSE_UNDETERMINED;
}

/* Per cycle: exponents below it are 0. */
static const double ROUNDING = 1e-9;

/* A motion and the data for its verdict. */
typedef struct Watch {
    CycleMotion motion;
    const Stop *stop;
    size_t planned;   /* cycles of the transient and of the record */
    size_t work_most; /* of the motion, until it is given up; 0: it is not */
    double *growth;   /* (analysed.count) logarithm of the tangent's growth in each cycle */
    size_t growth_capacity;
    Section analysed; /* since the transient */
    Section early;    /* of the transient */
    double early_growth;
} Watch;

/* True if the motion has taken all the work that it may, or its first cycles show that it will. */
static bool is_spent(const Watch *watch) {
    const CycleMotion *motion = &watch->motion;
    double work = (double)motion->cycle.kind->tally(motion->own).work;
    size_t done = watch->early.count + watch->analysed.count;
    if (done >= FORESEEN)
        work = fmax(work, work / (double)done * (double)watch->planned / DEARER);
    return watch->work_most && work > (double)watch->work_most;
}

static bool goes_on(const Watch *watch) {
    return cycle_status(&watch->motion) == CYCLE_GOOD && !is_spent(watch) && !stop_requested(watch->stop);
}

/* Returns how many of `cycles` of this work each are run: all unless they are dear. */
static size_t affordable(const CycleKind *kind, double work, size_t cycles) {
    double dear = (double)kind->dear;
    return dear > 0 && work > dear ? (size_t)fmax(1, dear / work * (double)cycles) : cycles;
}

static void pass_transient(Watch *watch, int cycles) {
    for (int i = 0; i < cycles && goes_on(watch); i++) {
        if (cycle_run(&watch->motion) == CYCLE_GOOD)
            section_add(&watch->early, &watch->motion);
        chaos_renew_tangents(&watch->motion, &watch->early_growth);
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

/* Adds one cycle of a record that began at `begin` s to the trace, in as many parts as it has samples; fewer when it
 * cannot be followed to its end. */
static void trace_cycle(Trace *trace, CycleMotion *motion, size_t cycle, double begin) {
    const CycleKind *kind = motion->cycle.kind;
    double period = cycle_period(motion->cycle), *row = memory_zeroed(kind->column_count, sizeof *row);
    for (int part = 0; part < kind->samples && cycle_status(motion) == CYCLE_GOOD; part++) {
        double time = kind->tally(motion->own).time;
        row[0] = time > 0 ? time - begin : (double)cycle * period + period * part / kind->samples;
        kind->sample(motion->own, part, row);
        trace_add(trace, row);
    }
    memory_free(row);
    cycle_run(motion);
}

/* Sets the numbers of the recorded cycles from the tallies before the first and after the last whole one. */
static void count_contacts(Response *response, const CycleTally *before, const CycleTally *after, double period) {
    double cycles = (double)response->section.count;
    double time = after->time > 0 ? after->time - before->time : cycles * period;
    bool any = cycles > 0;
    response->switches = any ? (double)(after->switches - before->switches) / cycles : (double)NAN;
    response->touches = any ? (double)(after->touches - before->touches) / cycles : (double)NAN;
    response->contact_share = any ? (after->contact_time - before->contact_time) / time : (double)NAN;
    response->grazes = after->grazes - before->grazes;
}

static void record(Response *response, Watch *watch, int cycles) {
    CycleMotion *motion = &watch->motion;
    const CycleKind *kind = motion->cycle.kind;
    CycleTally before = kind->tally(motion->own), after = before; /* a cycle that is not whole does not count */
    response->digest = DIGEST_START;
    response->start = memory_zeroed(motion->states, sizeof *response->start);
    kind->state(motion->own, response->start);
    for (int i = 0; i < cycles && goes_on(watch); i++) {
        if (i < RESPONSE_TRACE_CYCLES)
            trace_cycle(&response->trace, motion, (size_t)i, before.time);
        else
            cycle_run(motion);
        if (cycle_status(motion) == CYCLE_GOOD) {
            section_add(&response->section, motion);
            after = kind->tally(motion->own);
        }
        for (size_t side = 0; cycle_status(motion) == CYCLE_GOOD && side < CYCLE_SIDES; side++)
            kind->peaks(motion->own)[side] = response->section.peak[2 * (response->section.count - 1) + side];
        note_cycle(watch);
    }
    const Section *section = &response->section;
    for (size_t i = 0; i < section->count * section->states; i++)
        response->digest = digest_mix(response->digest, section->state[i]);
    response->peaks = section_peaks(section);
    count_contacts(response, &before, &after, cycle_period(motion->cycle));
    response->work = (double)kind->tally(motion->own).work / (double)(watch->early.count + section->count + 1);
}

/* True if the tangent grew in the last quarter of the record. */
static bool tangent_grows(const Watch *watch) {
    size_t count = watch->analysed.count, last = count / 4 > 0 ? count / 4 : 1;
    double sum = 0;
    for (size_t i = count - last; i < count; i++)
        sum += watch->growth[i];
    return sum > GROWS * (double)last;
}

/* Finds the stable orbit near the motion, of periods from `least` to `most`. */
static OrbitAnswer find_orbit(Response *response, const Watch *watch, size_t least, size_t most, double near) {
    const Section *seen = &watch->analysed;
    double rest = cycle_rest_state(watch->motion.cycle);
    if (tangent_grows(watch))
        return ORBIT_NONE;
    most = affordable(watch->motion.cycle.kind, response->work, most);
    for (size_t period = least; period <= most && period < seen->count; period++) {
        if (section_return(seen, period, rest) > near)
            continue;
        OrbitAnswer answer =
            orbit_settle(&response->orbit, watch->motion.cycle, section_last(seen), period, near, watch->stop);
        if (answer != ORBIT_NONE)
            return answer;
    }
    return ORBIT_NONE;
}

/* Returns the verdict on a motion that could not be followed for as many cycles as it needs. */
static ResponseVerdict bad_verdict(const Watch *watch) {
    switch (cycle_status(&watch->motion)) {
    case CYCLE_CHATTERS:
        return RESPONSE_CHATTERS;
    case CYCLE_DIVERGED:
        return RESPONSE_DIVERGED;
    case CYCLE_STIFF:
        return RESPONSE_STIFF;
    case CYCLE_INTERRUPTED:
        return RESPONSE_INTERRUPTED;
    case CYCLE_GOOD:
        break;
    }
    return is_spent(watch) ? RESPONSE_STIFF : RESPONSE_INTERRUPTED;
}

static bool is_chaotic(const Response *response) {
    return response->exponent.value - 3 * response->exponent.error > 0 && response->zero_one > RESPONSE_ZERO_ONE_LEAST;
}

/* True if neither order nor chaos grows: a torus, perhaps. */
static bool is_neutral(const Response *response) {
    return fabs(response->exponent.value) < RESPONSE_NEUTRAL &&
           fabs(response->exponent.value) <= fmax(3 * response->exponent.error, ROUNDING) &&
           fabs(response->zero_one) < RESPONSE_ZERO_ONE_REGULAR;
}

/* Sets K: of deflection and velocity, of every p-th cycle, until one is chaotic; otherwise the largest. */
static void test_zero_one(Response *response, const Section *seen) {
    static const size_t steps[] = {1, 2, 3, 4, 6, 8};
    const double *observed[] = {seen->deflection, seen->velocity};
    size_t count = seen->count < ZERO_ONE_CYCLES ? seen->count : ZERO_ONE_CYCLES;
    double *room = memory_zeroed(count, sizeof *room);
    response->zero_one = -HUGE_VAL;
    for (size_t s = 0; s < sizeof steps / sizeof *steps; s++)
        for (size_t o = 0; o < 2 && !(response->zero_one > RESPONSE_ZERO_ONE_LEAST); o++) {
            size_t taken = 0;
            for (size_t i = 0; i < count; i += steps[s])
                room[taken++] = observed[o][seen->count - count + i];
            double k = chaos_zero_one(room, taken);
            if (k > response->zero_one) {
                response->zero_one = k;
                response->zero_one_step = steps[s];
            }
        }
    memory_free(room);
}

static void note_orbit(Response *response, Cycle cycle, const Stop *stop) {
    response->settled = orbit_distance(&response->orbit, cycle, response->section.state, stop) < ORBIT_SETTLED;
    response->exponent = (ChaosExponent){real_log(response->orbit.largest) / (double)response->orbit.period, 0};
    response->orbit_peak = orbit_peak(&response->orbit, cycle, stop);
    response->image = orbit_image(&response->orbit, cycle, stop);
    response->zero_one = NAN;
}

/* True if the state is farther from all points (period x states) of an orbit than the fraction NEAR_RETURN of their
 * length. */
static bool is_away(const double *points, const Orbit *orbit, const double *state, double rest) {
    for (size_t p = 0; p < orbit->period; p++) {
        double apart = 0, size = 0;
        for (size_t k = 0; k < orbit->states; k++) {
            double at = points[p * orbit->states + k];
            apart += (state[k] - at) * (state[k] - at);
            size += at * at;
        }
        if (sqrt(apart) <= NEAR_RETURN * fmax(sqrt(size), rest))
            return false;
    }
    return true;
}

/* Returns how many of the states of the transient and the record came before the motion stayed near its orbit. */
static size_t count_away(const Response *response, const Watch *watch) {
    const Orbit *orbit = &response->orbit;
    Cycle cycle = watch->motion.cycle;
    double rest = cycle_rest_state(cycle), *points = memory_zeroed(orbit->period * orbit->states, sizeof *points);
    memcpy(points, orbit->point, orbit->states * sizeof *points);
    for (size_t p = 1; p < orbit->period; p++) {
        memcpy(points + p * orbit->states, points + (p - 1) * orbit->states, orbit->states * sizeof *points);
        if (orbit_map(cycle, points + p * orbit->states, 1, NULL, watch->stop) != ORBIT_GOOD)
            break;
    }
    size_t away = watch->early.count + watch->analysed.count;
    for (; away > 0; away--) {
        size_t last = away - 1;
        const Section *in = last < watch->early.count ? &watch->early : &watch->analysed;
        size_t at = last < watch->early.count ? last : last - watch->early.count;
        if (is_away(points, orbit, in->state + at * in->states, rest))
            break;
    }
    memory_free(points);
    return away;
}

/* Tells a motion that has settled on an orbit: periodic, unless it was chaotic long before. */
static ResponseVerdict tell_settled(Response *response, Watch *watch) {
    size_t away = count_away(response, watch), of_record = away > watch->early.count ? away - watch->early.count : 0;
    double growth = watch->early_growth;
    for (size_t i = 0; i < of_record; i++)
        growth += watch->growth[i];
    note_orbit(response, watch->motion.cycle, watch->stop);
    if (away < RESPONSE_TRANSIENT_LEAST || growth <= GROWS * (double)away)
        return RESPONSE_PERIODIC;
    response->wandering = watch->early;
    watch->early = (Section){0};
    section_join(&response->wandering, &watch->analysed, of_record);
    response->wandering.count = away;
    return RESPONSE_TRANSIENT;
}

/* Returns the second exponent of a motion that goes on from its last state. */
static ChaosExponent second_exponent(const Watch *watch, size_t cycles) {
    CycleMotion motion = cycle_create(watch->motion.cycle, 2, watch->stop);
    double *grown = memory_zeroed(cycles, sizeof *grown);
    size_t done = 0;
    watch->motion.cycle.kind->set_state(motion.own, section_last(&watch->analysed));
    watch->motion.cycle.kind->unit_tangents(motion.own);
    for (; done < cycles && cycle_status(&motion) == CYCLE_GOOD && !stop_requested(watch->stop); done++) {
        double growth[2] = {0};
        cycle_run(&motion);
        chaos_renew_tangents(&motion, growth);
        grown[done] = growth[1];
    }
    ChaosExponent second = done == cycles ? chaos_exponent(grown, cycles) : (ChaosExponent){NAN, NAN};
    memory_free(grown);
    cycle_destroy(&motion);
    return second;
}

/* Tells a motion that is not chaotic: a torus, or an orbit of a long period, as on one that is locked. */
static ResponseVerdict tell_torus(Response *response, const Watch *watch) {
    const Section *seen = &watch->analysed;
    Cycle cycle = watch->motion.cycle;
    switch (find_orbit(response, watch, ORBIT_PERIOD_MOST + 1, ORBIT_LOCKED_MOST, ORBIT_SETTLED)) {
    case ORBIT_GOOD:
        note_orbit(response, cycle, watch->stop);
        return stop_requested(watch->stop) ? RESPONSE_INTERRUPTED : RESPONSE_PERIODIC;
    case ORBIT_INTERRUPTED:
        return RESPONSE_INTERRUPTED;
    case ORBIT_NONE:
        break;
    }
    if (!is_neutral(response))
        return RESPONSE_UNDETERMINED;
    response->second = second_exponent(watch, cycle.kind->cycles_least);
    response->bands = shape_bands(seen);
    response->rotation = shape_rotation(seen, response->bands, 2 * M_PI / cycle_period(cycle));
    bool below = response->second.value < fmax(3 * response->second.error, RESPONSE_NEUTRAL);
    return stop_requested(watch->stop) ? RESPONSE_INTERRUPTED : below ? RESPONSE_QUASI_PERIODIC : RESPONSE_UNDETERMINED;
}

/* Forgets the orbit, and what was told from fewer cycles than the verdict needs. */
static ResponseVerdict interrupt(Response *response) {
    orbit_clear(&response->orbit);
    response->settled = false;
    response->orbit_peak = 0;
    response->image = ORBIT_IMAGE_NONE;
    response->exponent = response->second = (ChaosExponent){NAN, NAN};
    response->zero_one = NAN;
    response->rotation = (ShapeRotation){NAN, NAN};
    response->bands = 0;
    section_clear(&response->wandering);
    return RESPONSE_INTERRUPTED;
}

/* Continues, doubling the number of cycles each time, until a verdict is reached. */
static ResponseVerdict decide(Response *response, Watch *watch) {
    const CycleKind *kind = watch->motion.cycle.kind;
    for (size_t cycles = kind->cycles_least;; cycles *= 2) {
        ResponseVerdict verdict;
        switch (watch->analysed.count > 1 ? find_orbit(response, watch, 1, ORBIT_PERIOD_MOST, NEAR_RETURN)
                                          : ORBIT_NONE) {
        case ORBIT_GOOD:
            verdict = tell_settled(response, watch);
            return stop_requested(watch->stop) ? interrupt(response) : verdict;
        case ORBIT_INTERRUPTED:
            return interrupt(response);
        case ORBIT_NONE:
            break;
        }
        if (is_chaotic(response)) {
            response->bands = shape_bands(&watch->analysed);
            return RESPONSE_CHAOTIC;
        }
        bool last = cycles > kind->cycles_most;
        if (last || (cycles > 2 * kind->cycles_least && is_neutral(response))) {
            verdict = tell_torus(response, watch);
            if (verdict == RESPONSE_INTERRUPTED)
                return interrupt(response);
            if (last || verdict != RESPONSE_UNDETERMINED)
                return verdict;
        }
        while (watch->analysed.count < cycles && goes_on(watch)) {
            cycle_run(&watch->motion);
            note_cycle(watch);
        }
        if (watch->analysed.count < cycles) {
            verdict = bad_verdict(watch);
            if (verdict == RESPONSE_STIFF && cycles > kind->cycles_least)
                return RESPONSE_UNDETERMINED;
            return verdict == RESPONSE_INTERRUPTED ? interrupt(response) : verdict;
        }
        response->exponent = chaos_exponent(watch->growth, watch->analysed.count);
        test_zero_one(response, &watch->analysed);
    }
}

void response_run(Response *response, Cycle cycle, int transient, int cycles, const double *start, const Stop *stop) {
    *response = (Response){.verdict = RESPONSE_INTERRUPTED,
                           .exponent = {NAN, NAN},
                           .second = {NAN, NAN},
                           .zero_one = NAN,
                           .rotation = {NAN, NAN}};
    trace_init(&response->trace, cycle.kind->columns, cycle.kind->column_count);
    size_t planned = (size_t)transient + (size_t)cycles, most = cycle.kind->cycles_most;
    Watch watch = {.motion = cycle_create(cycle, 1, stop), .stop = stop, .planned = planned};
    watch.work_most = cycle.kind->dear * (planned > most ? planned : most);
    if (start)
        cycle.kind->set_state(watch.motion.own, start);
    pass_transient(&watch, transient);
    record(response, &watch, cycles);
    response->verdict = response->section.count == (size_t)cycles ? decide(response, &watch) : bad_verdict(&watch);
    response->cycles = watch.analysed.count;
    cycle_destroy(&watch.motion);
    response->analysed = watch.analysed;
    section_clear(&watch.early);
    memory_free(watch.growth);
}

bool response_is_quick(const Response *response) {
    return !response->survival.lanes &&
           (response->verdict == RESPONSE_CHAOTIC || response->verdict == RESPONSE_QUASI_PERIODIC ||
            response->verdict == RESPONSE_TRANSIENT || response->verdict == RESPONSE_UNDETERMINED);
}

void response_confirm(Response *response, Cycle cycle, const SurvivalTask *task) {
    if (!response_is_quick(response) || !task->lanes)
        return;
    bool settled = response->verdict == RESPONSE_TRANSIENT;
    SurvivalTask affordable_task = *task;
    affordable_task.cycles = affordable(cycle.kind, response->work, task->cycles);
    if (affordable_task.cycles <= cycle.kind->lane_apart) /* so few tell nothing */
        return;
    Survival survival = survival_run(cycle, settled ? &response->wandering : &response->analysed, &affordable_task);
    if (!survival.whole)
        return;
    response->survival = survival;
    if (survival.settled)
        response->verdict = RESPONSE_TRANSIENT;
}

Spectrum response_spectrum(const Response *response, size_t column, size_t samples, double frequency) {
    const Trace *trace = &response->trace;
    size_t cycles = trace->rows / samples, period = response->orbit.period;
    if (period && cycles >= period)
        cycles -= cycles % period;
    return spectrum_make(trace->values + column, cycles * samples, trace->width, 1 / (frequency * (double)samples));
}

void response_clear(Response *response) {
    memory_free(response->start);
    section_clear(&response->section);
    section_clear(&response->analysed);
    section_clear(&response->wandering);
    trace_clear(&response->trace);
    orbit_clear(&response->orbit);
}
