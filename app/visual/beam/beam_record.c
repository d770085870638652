#include "visual/beam/beam_record.h"

#include <math.h>

#include "base/memory.h"
#include "beam/beam_cycle.h"

#define MILLI 1000.0 /* per m and per s, for plots */

/* Samples are dense enough for smooth lines: at least so many per cycle, and per period of a clearly visible mode; but
 * at most SAMPLES_MOST in total. */
enum { SAMPLES = 400, MODE = 5, MODE_SAMPLES = 20, SAMPLES_MOST = 100000 };

enum { LOOKS = 200 /* per cycle, at most, at which the deflection of the whole beam is evaluated */ };

/* Following ---------------------------------------------------------------------------------------------------------*/

static double period_of(const BeamRecord *record) {
    return record->motion.rig->period;
}

/* Moves to the start of a cycle. */
static void begin_cycle(BeamRecord *record, size_t cycle) {
    const Section *section = &record->response->section;
    const double *state = cycle ? section->state + (cycle - 1) * section->states : record->response->start;
    motion_set_state(&record->motion, state);
    record->motion.cycle = cycle;
}

static void advance_until(Motion *motion, double phase) {
    while (motion->status == CYCLE_GOOD && motion->phase < phase)
        motion_step(motion, phase - motion->phase);
}

/* Finds the cycle of a time, and the phase in the cycle. */
static size_t cycle_at(const BeamRecord *record, double time, double *phase) {
    double period = period_of(record), last = (double)(record->cycles - 1);
    double cycle = fmax(0, fmin(floor(time / period), last));
    *phase = fmax(0, fmin(time - cycle * period, period));
    return (size_t)cycle;
}

void beam_record_seek(BeamRecord *record, double time) {
    double phase;
    begin_cycle(record, cycle_at(record, time, &phase));
    advance_until(&record->motion, phase);
}

/* Impacts -----------------------------------------------------------------------------------------------------------*/

/* Returns the side of the stop that the tip touches; 0: none. */
static int side_of(MotionPlace place) {
    static const int sides[MOTION_PLACES] = {
        [MOTION_UPPER] = 1, [MOTION_UPPER_LEAVING] = 1, [MOTION_LOWER] = -1, [MOTION_LOWER_LEAVING] = -1};
    return sides[place];
}

static double *peak_of(Motion *motion, int side) {
    return &motion->peak[side > 0 ? 0 : 1];
}

static void begin_impact(BeamRecord *record, double time, int side) {
    record->impacts =
        memory_reserve(record->impacts, &record->impact_capacity, record->impact_count + 1, sizeof *record->impacts);
    record->impacts[record->impact_count++] = (BeamImpact){.begin = time, .end = HUGE_VAL, .side = side};
    *peak_of(&record->motion, side) = 0;
}

/* Updates the impacts after a step from the side `before`. */
static void note_step(BeamRecord *record, int before, double time) {
    int now = side_of(record->motion.place);
    BeamImpact *last = record->impact_count ? &record->impacts[record->impact_count - 1] : NULL;
    if (last && before) {
        last->peak = *peak_of(&record->motion, before);
        record->largest = fmax(record->largest, last->peak);
        last->end = now == before ? HUGE_VAL : time;
    }
    if (now && now != before)
        begin_impact(record, time, now);
}

/* Updates the largest deflection of the beam. */
static void note_reach(BeamRecord *record, BeamShape *shape) {
    beam_shape_set(shape, &record->motion);
    record->reach = fmax(record->reach, beam_shape_reach(shape));
    record->tip_reach = fmax(record->tip_reach, fabs(motion_deflection(&record->motion)));
}

/* Advances through all cycles once. */
static void advance_all(BeamRecord *record) {
    double period = period_of(record);
    Motion *motion = &record->motion;
    BeamShape shape = beam_shape_create(motion->rig);
    int side = 0;
    for (size_t cycle = 0; cycle < record->cycles; cycle++) {
        double looked = 0;
        begin_cycle(record, cycle);
        note_step(record, side, (double)cycle * period);
        side = side_of(motion->place);
        while (motion->status == CYCLE_GOOD && motion->phase < period) {
            motion_step(motion, period - motion->phase);
            note_step(record, side, (double)cycle * period + motion->phase);
            side = side_of(motion->place);
            if (motion->phase < looked)
                continue;
            note_reach(record, &shape);
            looked = motion->phase + period / LOOKS;
        }
    }
    beam_shape_destroy(&shape);
}

const BeamImpact *beam_record_last_impact(const BeamRecord *record, double time, int side) {
    const BeamImpact *last = NULL;
    for (size_t i = 0; i < record->impact_count && record->impacts[i].end <= time; i++)
        if (record->impacts[i].side == side)
            last = &record->impacts[i];
    return last;
}

#define ALIKE 1e-6 /* 1: forces nearer than this count as equal, and the first is taken */

/* Finds the largest force or, without contact, the largest deflection. */
static void find_hardest(BeamRecord *record) {
    const Trace *trace = &record->response->trace;
    int column = record->largest > 0 ? BEAM_FORCE : BEAM_DEFLECTION;
    double most = 0;
    for (size_t row = 0; row < trace->rows; row++) {
        const double *values = trace_row(trace, row);
        if (fabs(values[column]) > most * (1 + ALIKE) && values[BEAM_TIME] < record->time) {
            most = fabs(values[column]);
            record->hardest = values[BEAM_TIME];
        }
    }
}

void beam_record_make(BeamRecord *record, const Rig *rig, const Response *response) {
    size_t whole = response->section.count;
    *record = (BeamRecord){.response = response, .motion = motion_create(rig, 0)};
    record->cycles = whole < RESPONSE_TRACE_CYCLES ? whole : RESPONSE_TRACE_CYCLES;
    record->time = (double)record->cycles * rig->period;
    advance_all(record);
    find_hardest(record);
}

/* Samples -----------------------------------------------------------------------------------------------------------*/

static void add_sample(BeamRecord *record, double time) {
    double phase;
    size_t cycle = cycle_at(record, time, &phase);
    if (cycle != record->motion.cycle || phase < record->motion.phase)
        begin_cycle(record, cycle);
    advance_until(&record->motion, phase);
    size_t at = record->sample_count++;
    record->times[at] = MILLI * time;
    record->displacement[at] = MILLI * motion_deflection(&record->motion);
    record->velocity[at] = motion_velocity(&record->motion);
    record->force[at] = motion_force(&record->motion);
}

/* Computes the Poincare section within the span. */
static void add_section(BeamRecord *record, BeamSpan span) {
    const Section *section = &record->response->section;
    for (size_t i = 0; i < record->cycles; i++) {
        double time = (double)(i + 1) * period_of(record);
        if (time < span.first || time > span.last)
            continue;
        size_t at = record->section_count++;
        record->section_times[at] = MILLI * time;
        record->section_displacement[at] = MILLI * section->deflection[i];
        record->section_velocity[at] = section->velocity[i];
    }
}

static void clear_samples(BeamRecord *record) {
    double **const columns[] = {&record->times,           &record->displacement,  &record->velocity,
                                &record->force,           &record->section_times, &record->section_displacement,
                                &record->section_velocity};
    for (size_t i = 0; i < sizeof columns / sizeof *columns; i++) {
        memory_free(*columns[i]);
        *columns[i] = NULL;
    }
    record->sample_count = record->section_count = 0;
}

/* Returns the number of samples taken every 1 / rate s. */
static double parts_of(const BeamRecord *record, BeamSpan span) {
    const Modes *modes = &record->motion.rig->modes;
    double seen = modes->frequency[modes->count < MODE ? modes->count - 1 : MODE - 1] / (2 * M_PI);
    double wanted = fmax(SAMPLES / period_of(record), MODE_SAMPLES * seen);
    return fmax(1, ceil(fmin(wanted, SAMPLES_MOST / (span.last - span.first)) / span.rate));
}

void beam_record_sample(BeamRecord *record, BeamSpan span) {
    clear_samples(record);
    double parts = parts_of(record, span);
    size_t room = (size_t)ceil((span.last - span.first) * span.rate * parts) + 2;
    record->times = memory_zeroed(room, sizeof *record->times);
    record->displacement = memory_zeroed(room, sizeof *record->displacement);
    record->velocity = memory_zeroed(room, sizeof *record->velocity);
    record->force = memory_zeroed(room, sizeof *record->force);
    record->section_times = memory_zeroed(record->cycles, sizeof *record->section_times);
    record->section_displacement = memory_zeroed(record->cycles, sizeof *record->section_displacement);
    record->section_velocity = memory_zeroed(record->cycles, sizeof *record->section_velocity);
    for (size_t i = 0;; i++) {
        double time = span.first + (double)i / parts / span.rate;
        if (!(time < span.last) || record->sample_count + 1 >= room)
            break;
        add_sample(record, time);
    }
    add_sample(record, span.last);
    add_section(record, span);
}

void beam_record_clear(BeamRecord *record) {
    clear_samples(record);
    memory_free(record->impacts);
    motion_destroy(&record->motion);
    *record = (BeamRecord){0};
}
