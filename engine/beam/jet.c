#include "beam/jet.h"

#include <math.h>

enum { STEPS_MOST = 100 /* halving alone needs some fifty */ };

/* Newton's steps, halved brackets where they leave it. */
double jet_rise(const Jet *jet, double low, double high) {
    Jet rate = jet_rate(jet);
    double at = low - jet_value(jet, low) / jet_value(&rate, low);
    for (int i = 0; i < STEPS_MOST && high - low > JET_RESOLUTION; i++) {
        if (!(at > low && at < high))
            at = low + (high - low) / 2;
        double value = jet_value(jet, at);
        if (value < 0)
            low = at;
        else
            high = at;
        double next = at - value / jet_value(&rate, at);
        if (fabs(next - at) <= JET_RESOLUTION)
            return fmin(fmax(next, low), high);
        at = next;
    }
    return high;
}
