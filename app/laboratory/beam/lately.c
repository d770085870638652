#include "laboratory/beam/lately.h"

#include <string.h>

MachineLately beam_lately_look(const BeamTape *tape) {
    double deflection[MACHINE_ANSWER_LATELY], velocity[MACHINE_ANSWER_LATELY], peak[2 * MACHINE_ANSWER_LATELY];
    const BeamPart *part = tape->parts[tape->part_count - 1];
    size_t first = part->first > tape->first ? part->first : tape->first;
    MachineLately lately = {.cycles = tape->front - part->first};
    size_t count = tape->front - first < MACHINE_ANSWER_LATELY ? tape->front - first : MACHINE_ANSWER_LATELY;
    for (size_t i = 0; i < count; i++) {
        const BeamCycle *cycle = beam_tape_cycle(tape, tape->front - count + i);
        const BeamCycle *next = beam_tape_cycle(tape, tape->front - count + i + 1);
        deflection[i] = next->deflection;
        velocity[i] = next->velocity;
        memcpy(peak + 2 * i, cycle->peak, sizeof cycle->peak);
    }
    size_t last = count / 2; /* assumed settled part of a motion that settles */
    lately.peaks = section_peaks(&(Section){.count = count - last, .peak = peak + 2 * last});
    lately.period = section_period(deflection, velocity, count, part->rig.omega, rig_rest_deflection(&part->rig));
    return lately;
}

const char *beam_lately_error(const BeamTape *tape, Arena *arena) {
    if (tape->status == CYCLE_CHATTERS)
        return text_in_arena(arena,
                             "In cycle %zu the tip switches more than %d times, and the run ends: use more contact "
                             "damping, a softer contact or a larger gap",
                             tape->front + 1, MOTION_SWITCHES_MOST);
    return text_in_arena(arena,
                         "In cycle %zu the motion grows without bound, and the run ends: use more damping of the "
                         "modes, less force or another shaker frequency",
                         tape->front + 1);
}
