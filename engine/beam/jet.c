#include "beam/jet.h"

#include <math.h>

enum { STEPS_MOST = 100 /* bisection alone needs about fifty */ };

/* Newton's method with bisection where a step leaves the bracket. A step of d leaves an error of about y'' d^2 / 2
 * y'. */
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
