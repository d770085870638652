#include "laboratory/beam/tape.h"

#include <math.h>
#include <string.h>

#include "experiment/beam_numbers.h"

enum {
    LOOKS = 16,   /* times per cycle at which the deflection is measured */
    SHRINKS = 16, /* cycles with a smaller extent before the room shrinks */
};

static const double SPARE = 1.25; /* 1, ratio of room to extent */
static const double SMALL = 0.5;  /* 1, the room shrinks if the extent is below this share of it */

/* A rig whose modes and regimes are shared by parts; it is released with the last part that uses it. */
typedef struct BeamModes {
    Rig rig;
    Beam beam; /* the beam from which the rig was built */
    size_t users;
} BeamModes;

/* Parts -------------------------------------------------------------------------------------------------------------*/

static void release_modes(BeamModes *modes) {
    if (--modes->users)
        return;
    rig_clear(&modes->rig);
    memory_free(modes);
}

/* Returns the modes of a beam, shared with `like` if the cells would be the same. NULL: a fault. */
static BeamModes *find_modes(const BeamPart *like, const Beam *beam, const char *place, Fault *fault) {
    BeamModes *modes = like ? like->modes : NULL;
    bool same = modes && beam_numbers_same_rig(&modes->beam, beam) && beam_numbers_followed(beam, &modes->rig);
    if (same && modes->rig.cell < modes->rig.period / RIG_CELLS && modes->rig.cell < 1 / beam->frequency / RIG_CELLS) {
        modes->users++;
        return modes;
    }
    modes = memory_zeroed(1, sizeof *modes);
    *modes = (BeamModes){.beam = *beam, .users = 1};
    if (beam_check(beam, place, fault) && rig_build(&modes->rig, beam, place, fault))
        return modes;
    memory_free(modes);
    return NULL;
}

static BeamPart *make_part(BeamTape *tape, const Beam *beam, Fault *fault) {
    const BeamPart *like = tape->next ? tape->next : tape->part_count ? tape->parts[tape->part_count - 1] : NULL;
    BeamModes *modes = find_modes(like, beam, tape->place, fault);
    if (!modes)
        return NULL;
    BeamPart *part = memory_zeroed(1, sizeof *part);
    *part = (BeamPart){.beam = *beam, .modes = modes, .serial = ++tape->part_serial};
    part->rig = rig_share(&modes->rig, beam->frequency, beam->force, beam->clearance);
    return part;
}

static void free_part(BeamPart *part) {
    if (!part)
        return;
    rig_clear_shared(&part->rig);
    release_modes(part->modes);
    memory_free(part);
}

/* Forgets the oldest part with its cycles. */
static void forget_part(BeamTape *tape) {
    free_part(tape->parts[0]);
    tape->part_count--;
    memmove(tape->parts, tape->parts + 1, tape->part_count * sizeof(BeamPart *));
    if (tape->first < tape->parts[0]->first)
        tape->first = tape->parts[0]->first;
}

static BeamCycle *slot(const BeamTape *tape, size_t cycle) {
    return &tape->cycles[cycle % (BEAM_TAPE_CYCLES + 1)];
}

const BeamPart *beam_tape_part(const BeamTape *tape, size_t cycle) {
    size_t p = tape->part_count;
    while (p > 1 && tape->parts[p - 1]->first > cycle)
        p--;
    return p ? tape->parts[p - 1] : tape->next;
}

const BeamCycle *beam_tape_cycle(const BeamTape *tape, size_t cycle) {
    return slot(tape, cycle);
}

double beam_tape_begin(const BeamTape *tape, size_t cycle) {
    const BeamPart *part = beam_tape_part(tape, cycle);
    return cycle == tape->front ? tape->front_time : part->begin + (double)(cycle - part->first) * part->rig.period;
}

size_t beam_tape_cycle_at(const BeamTape *tape, double time, double *phase) {
    size_t p = tape->part_count;
    while (p > 1 && tape->parts[p - 1]->begin > time)
        p--;
    const BeamPart *part = tape->parts[p - 1];
    double cycles = fmax(0, floor((time - part->begin) / part->rig.period));
    size_t last = tape->front > tape->first ? tape->front - 1 : tape->first;
    size_t cycle = cycles < (double)(last - part->first) ? part->first + (size_t)cycles : last;
    cycle = cycle < tape->first ? tape->first : cycle;
    while (cycle < last && beam_tape_begin(tape, cycle + 1) <= time)
        cycle++;
    *phase = fmax(0, fmin(time - beam_tape_begin(tape, cycle), beam_tape_part(tape, cycle)->rig.period));
    return cycle;
}

/* Recording ---------------------------------------------------------------------------------------------------------*/

/* Saves the motion at the beginning of the front's cycle. */
static void note_front(BeamTape *tape) {
    BeamCycle *cycle = slot(tape, tape->front);
    size_t size = motion_saved_size(tape->motion.rig);
    if (cycle->saved_size != size) {
        memory_free(cycle->saved);
        cycle->saved = memory_zeroed(size, sizeof *cycle->saved);
        cycle->saved_size = size;
    }
    motion_save(&tape->motion, cycle->saved);
    cycle->deflection = motion_deflection(&tape->motion);
    cycle->velocity = motion_velocity(&tape->motion);
}

/* Begins the next part, with the carried motion or at rest. */
static void begin_part(BeamTape *tape) {
    BeamPart *part = tape->next;
    part->first = tape->front;
    part->begin = tape->front_time;
    motion_destroy(&tape->motion);
    tape->motion = motion_create(&part->rig, 0);
    double *state = memory_zeroed(part->rig.free.states, sizeof *state);
    if (beam_carry_apply(&tape->carry, &part->rig.modes, state))
        motion_set_state(&tape->motion, state);
    memory_free(state);
    if (tape->part_count == BEAM_TAPE_PARTS)
        forget_part(tape);
    tape->parts[tape->part_count++] = part;
    tape->next = NULL;
    tape->status = CYCLE_GOOD;
    note_front(tape);
}

/* Returns the largest deflection of the beam's nodes, m. */
static double reach_of(const Motion *motion, double *state) {
    const Modes *modes = &motion->rig->modes;
    double reach = 0;
    motion_state(motion, state);
    for (size_t node = 0; node < modes->freedoms / 2; node++) {
        double deflection = 0;
        for (size_t i = 0; i < modes->count; i++)
            deflection += state[i] / modes->frequency[i] * modes->shape[i * modes->freedoms + 2 * node];
        reach = fmax(reach, fabs(deflection));
    }
    return reach;
}

/* Follows the motion as motion_cycle does, step by step, and measures its extent. */
static void follow_cycle(BeamTape *tape, BeamCycle *cycle) {
    Motion *motion = &tape->motion;
    double period = motion->rig->period, looked = 0;
    double *state = memory_zeroed(motion->rig->free.states, sizeof *state);
    cycle->extent = (BeamExtent){0};
    motion->peak[0] = motion->peak[1] = 0;
    while (motion->status == CYCLE_GOOD && motion->phase < period) {
        motion_step(motion, period - motion->phase);
        cycle->extent.speed = fmax(cycle->extent.speed, fabs(motion_velocity(motion)));
        cycle->extent.tip_reach = fmax(cycle->extent.tip_reach, fabs(motion_deflection(motion)));
        if (motion->phase < looked)
            continue;
        cycle->extent.reach = fmax(cycle->extent.reach, reach_of(motion, state));
        looked = motion->phase + period / LOOKS;
    }
    memory_free(state);
    memcpy(cycle->peak, motion->peak, sizeof cycle->peak);
    cycle->extent.force = fmax(cycle->peak[0], cycle->peak[1]);
    tape->status = motion_end_cycle(motion);
}

static double room_for(double before, double now, double lately) {
    return now > before ? SPARE * now : lately < SMALL * before ? SPARE * lately : before;
}

static BeamExtent extent_joined(BeamExtent a, BeamExtent b) {
    return (BeamExtent){fmax(a.reach, b.reach), fmax(a.tip_reach, b.tip_reach), fmax(a.speed, b.speed),
                        fmax(a.force, b.force)};
}

static void find_room(BeamTape *tape, BeamCycle *cycle) {
    const BeamExtent *now = &cycle->extent;
    size_t part_first = tape->parts[tape->part_count - 1]->first;
    BeamExtent before = {0}, lately = {HUGE_VAL, HUGE_VAL, HUGE_VAL, HUGE_VAL};
    if (tape->front > tape->first)
        before = slot(tape, tape->front - 1)->room;
    if (tape->front >= part_first + SHRINKS && tape->front >= tape->first + SHRINKS) {
        lately = *now;
        for (size_t back = 1; back < SHRINKS; back++)
            lately = extent_joined(lately, slot(tape, tape->front - back)->extent);
    }
    cycle->room = (BeamExtent){
        room_for(before.reach, now->reach, lately.reach), room_for(before.tip_reach, now->tip_reach, lately.tip_reach),
        room_for(before.speed, now->speed, lately.speed), room_for(before.force, now->force, lately.force)};
}

bool beam_tape_advance(BeamTape *tape) {
    if (tape->next)
        begin_part(tape);
    if (tape->status != CYCLE_GOOD)
        return false;
    BeamCycle *cycle = slot(tape, tape->front);
    follow_cycle(tape, cycle);
    if (tape->status != CYCLE_GOOD)
        return false;
    find_room(tape, cycle);
    const BeamPart *part = tape->parts[tape->part_count - 1];
    tape->front++;
    tape->front_time = part->begin + (double)(tape->front - part->first) * part->rig.period;
    if (tape->front - tape->first > BEAM_TAPE_CYCLES)
        tape->first++;
    while (tape->part_count > 1 && tape->parts[1]->first <= tape->first)
        forget_part(tape);
    note_front(tape);
    return true;
}

/* Changes -----------------------------------------------------------------------------------------------------------*/

/* Stores the motion at the beginning of a cycle as the carried motion. */
static void take_along(BeamTape *tape, size_t cycle) {
    const BeamPart *part = beam_tape_part(tape, cycle);
    double *state = memory_zeroed(part->rig.free.states, sizeof *state);
    Motion motion = motion_create(&part->rig, 0);
    motion_restore(&motion, slot(tape, cycle)->saved);
    motion_state(&motion, state);
    beam_carry_store(&tape->carry, &part->rig.modes, state);
    motion_destroy(&motion);
    memory_free(state);
}

static void cut(BeamTape *tape, size_t cycle) {
    tape->front_time = beam_tape_begin(tape, cycle);
    tape->version += cycle < tape->front;
    while (tape->part_count && tape->parts[tape->part_count - 1]->first >= cycle)
        free_part(tape->parts[--tape->part_count]);
    tape->front = cycle;
}

bool beam_tape_change(BeamTape *tape, const Beam *beam, size_t cycle, Fault *fault) {
    BeamPart *part = make_part(tape, beam, fault);
    if (!part)
        return false;
    if (cycle < tape->front || !tape->next) { /* otherwise the motion is carried already */
        take_along(tape, cycle);
        cut(tape, cycle);
    }
    free_part(tape->next);
    tape->next = part;
    if (!tape->part_count)
        begin_part(tape);
    return true;
}

bool beam_tape_restart(BeamTape *tape, const Beam *beam, Fault *fault) {
    BeamPart *part = make_part(tape, beam, fault);
    if (!part)
        return false;
    while (tape->part_count)
        free_part(tape->parts[--tape->part_count]);
    free_part(tape->next);
    beam_carry_clear(&tape->carry);
    tape->next = part;
    tape->first = tape->front = 0;
    tape->front_time = 0;
    tape->version++;
    begin_part(tape);
    return true;
}

bool beam_tape_open(BeamTape *tape, const Beam *beam, const char *place, Fault *fault) {
    *tape = (BeamTape){.place = place};
    tape->cycles = memory_zeroed(BEAM_TAPE_CYCLES + 1, sizeof *tape->cycles);
    if (beam_tape_restart(tape, beam, fault))
        return true;
    memory_free(tape->cycles);
    return false;
}

void beam_tape_close(BeamTape *tape) {
    while (tape->part_count)
        free_part(tape->parts[--tape->part_count]);
    free_part(tape->next);
    for (size_t i = 0; i <= BEAM_TAPE_CYCLES; i++)
        memory_free(tape->cycles[i].saved);
    memory_free(tape->cycles);
    motion_destroy(&tape->motion);
    beam_tape_close_sight(&tape->sampler);
    beam_carry_clear(&tape->carry);
    *tape = (BeamTape){0};
}

/* Looking at the record ------------------------------------------------------------------------------------------- */

void beam_tape_close_sight(BeamSight *sight) {
    motion_destroy(&sight->motion);
    *sight = (BeamSight){0};
}

/* Moves a sight to the beginning of a cycle. */
static void begin_sight(const BeamTape *tape, BeamSight *sight, size_t cycle) {
    const BeamPart *part = beam_tape_part(tape, cycle);
    if (sight->serial != part->serial) {
        beam_tape_close_sight(sight);
        sight->motion = motion_create(&part->rig, 0);
        sight->serial = part->serial;
    }
    sight->cycle = cycle;
    motion_restore(&sight->motion, slot(tape, cycle)->saved);
}

/* Returns the stop that the tip touches: 1 for the upper one, -1 for the lower one, 0 for none. */
static int side_of(MotionPlace place) {
    bool upper = place == MOTION_UPPER || place == MOTION_UPPER_LEAVING;
    return upper ? 1 : place == MOTION_OPEN ? 0 : -1;
}

static void follow_until(BeamSight *sight, double begin, double phase) {
    Motion *motion = &sight->motion;
    while (motion->status == CYCLE_GOOD && motion->phase < phase) {
        int side = side_of(motion->place), i = side > 0 ? 0 : 1;
        motion_step(motion, phase - motion->phase);
        if (!side || side_of(motion->place) == side)
            continue;
        sight->last[i] = (BeamImpact){.end = begin + motion->phase, .peak = motion->peak[i], .side = side};
        motion->peak[i] = 0;
    }
}

void beam_tape_seek(const BeamTape *tape, BeamSight *sight, double time) {
    double phase;
    size_t cycle = beam_tape_cycle_at(tape, time, &phase);
    const BeamPart *part = beam_tape_part(tape, cycle);
    begin_sight(tape, sight, cycle > part->first && cycle > tape->first ? cycle - 1 : cycle);
    memset(sight->last, 0, sizeof sight->last);
    sight->motion.peak[0] = sight->motion.peak[1] = 0;
    if (sight->cycle < cycle) {
        follow_until(sight, beam_tape_begin(tape, sight->cycle), part->rig.period);
        begin_sight(tape, sight, cycle);
    }
    follow_until(sight, beam_tape_begin(tape, cycle), phase);
}

static void take_sample(const Motion *motion, const BeamSamples *samples, size_t i) {
    if (samples->deflection)
        samples->deflection[i] = motion_deflection(motion);
    if (samples->velocity)
        samples->velocity[i] = motion_velocity(motion);
    if (samples->force)
        samples->force[i] = motion_force(motion);
}

void beam_tape_sample(BeamTape *tape, size_t cycle, const BeamSamples *samples) {
    BeamSight *sight = &tape->sampler;
    begin_sight(tape, sight, cycle);
    double period = sight->motion.rig->period;
    sight->motion.unwatched = true;
    for (size_t i = 0; i < samples->count; i++) {
        follow_until(sight, 0, period * (double)i / (double)samples->count);
        take_sample(&sight->motion, samples, i);
    }
}

void beam_tape_velocities(BeamTape *tape, double from, double to, double *velocity, size_t count) {
    BeamSight *sight = &tape->sampler;
    double phase;
    size_t at = SIZE_MAX;
    for (size_t i = 0; i < count; i++) {
        size_t cycle = beam_tape_cycle_at(tape, from + (to - from) * (double)i / (double)count, &phase);
        if (cycle != at)
            begin_sight(tape, sight, at = cycle);
        follow_until(sight, 0, phase);
        velocity[i] = motion_velocity(&sight->motion);
    }
}
