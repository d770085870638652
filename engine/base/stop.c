#include "base/stop.h"

bool stop_requested(const Stop *stop) {
    return stop && __atomic_load_n(&stop->requested, __ATOMIC_RELAXED);
}

void stop_request(Stop *stop) {
    __atomic_store_n(&stop->requested, 1, __ATOMIC_RELAXED);
}

void stop_withdraw(Stop *stop) {
    __atomic_store_n(&stop->requested, 0, __ATOMIC_RELAXED);
}
