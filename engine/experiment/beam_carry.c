#include "experiment/beam_carry.h"

#include <math.h>
#include <string.h>

#include "base/memory.h"

void beam_carry_store(BeamCarry *carry, const Modes *modes, const double *state) {
    beam_carry_clear(carry);
    carry->share = memory_zeroed(2 * modes->count, sizeof *carry->share);
    carry->modes = modes->count;
    for (size_t i = 0; i < modes->count; i++) {
        carry->share[2 * i] = modes->tip[i] * state[i] / modes->frequency[i];
        carry->share[2 * i + 1] = modes->tip[i] * state[modes->count + i];
        if (!isfinite(carry->share[2 * i] + carry->share[2 * i + 1]))
            carry->modes = 0;
    }
}

bool beam_carry_apply(const BeamCarry *carry, const Modes *modes, double *state) {
    if (!carry->modes)
        return false;
    memset(state, 0, 2 * modes->count * sizeof *state);
    for (size_t i = 0; i < modes->count && i < carry->modes; i++)
        if (modes->tip[i] != 0) {
            state[i] = carry->share[2 * i] / modes->tip[i] * modes->frequency[i];
            state[modes->count + i] = carry->share[2 * i + 1] / modes->tip[i];
        }
    return true;
}

void beam_carry_clear(BeamCarry *carry) {
    memory_free(carry->share);
    *carry = (BeamCarry){0};
}
