#include "beam/section.h"

#include <assert.h>
#include <math.h>

#include "base/memory.h"

void section_add(Section *section, Motion *motion) {
    size_t states = section->states = motion->rig->free.states, at = section->count++, count = section->count;
    section->state = memory_reserve(section->state, &section->state_capacity, count * states, sizeof(double));
    section->deflection = memory_reserve(section->deflection, &section->deflection_capacity, count, sizeof(double));
    section->velocity = memory_reserve(section->velocity, &section->velocity_capacity, count, sizeof(double));
    section->peak = memory_reserve(section->peak, &section->peak_capacity, 2 * count, sizeof(double));
    motion_state(motion, section->state + at * states);
    section->deflection[at] = motion_deflection(motion);
    section->velocity[at] = motion_velocity(motion);
    for (size_t side = 0; side < 2; side++) {
        section->peak[2 * at + side] = motion->peak[side];
        motion->peak[side] = 0;
    }
}

void section_clear(Section *section) {
    memory_free(section->state);
    memory_free(section->deflection);
    memory_free(section->velocity);
    memory_free(section->peak);
    *section = (Section){0};
}

SectionPeaks section_peaks(const Section *section) {
    SectionPeaks peaks = {.min = HUGE_VAL};
    double sum = 0;
    for (size_t i = 0; i < 2 * section->count; i++) {
        double peak = section->peak[i];
        if (peak <= 0)
            continue;
        peaks.min = fmin(peaks.min, peak);
        peaks.max = fmax(peaks.max, peak);
        sum += peak;
        peaks.count++;
    }
    peaks.mean = peaks.count ? sum / (double)peaks.count : 0;
    peaks.min = peaks.count ? peaks.min : 0;
    return peaks;
}

double section_return(const Section *section, size_t lag) {
    assert(lag < section->count);
    const double *last = section_last(section), *before = last - lag * section->states;
    double apart = 0, size = 0;
    for (size_t i = 0; i < section->states; i++) {
        apart += (last[i] - before[i]) * (last[i] - before[i]);
        size += last[i] * last[i];
    }
    return size > 0 ? sqrt(apart / size) : 0;
}
