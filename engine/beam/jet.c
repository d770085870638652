#include "beam/jet.h"

#include <math.h>

enum { STEPS_MOST = 100 /* halving alone needs some fifty */ };

/* Newton's steps, halved brackets where they leave it. A step of d leaves an error of some y'' d^2 / 2 y'. */
double jet_rise(const Jet *jet, double low, double high, double guess) {
    Jet rate = jet_rate(jet, 1);
    double at = guess;
    for (int i = 0; i < STEPS_MOST && high - low > JET_RESOLUTION; i++) {
        if (!(at > low && at < high))
            at = low + (high - low) / 2;
        double value = jet_value(jet, at);
        if (value < 0)
            low = at;
        else
            high = at;
        double slope = jet_value(&rate, at), next = at - value / slope, step = next - at;
        if (step * step * fabs(jet->term[2]) <= JET_RESOLUTION / 8 * fabs(slope))
            return fmin(fmax(next, low), high);
        at = next;
    }
    return high;
}
