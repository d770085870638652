/* The Poincare section: a motion seen once a cycle of the drive, at phase 0 (stroboscopic), and each cycle's largest
 * force on either side of the joint. */
#pragma once

#include <stddef.h>

#include "beam/motion.h"

typedef struct Section {
    size_t count, states;
    double *state;                 /* (count x states) sqrt(J) */
    double *deflection, *velocity; /* (count) of the tip, m and m/s */
    double *peak;                  /* (count x 2) N, on the upper and the lower side; 0: not touched in that cycle */
    size_t state_capacity, deflection_capacity, velocity_capacity, peak_capacity;
} Section;

/* Adds the motion as it is, at phase 0, and the peaks since the last addition, which begin anew. Zero is an empty
 * section. */
void section_add(Section *section, Motion *motion);

void section_clear(Section *section);

/* Of the peaks of both sides, those that touched. */
typedef struct SectionPeaks {
    double min, max, mean; /* N */
    size_t count;          /* 0: nothing touched */
} SectionPeaks;

SectionPeaks section_peaks(const Section *section);

/* |x_last - x_(last - lag)| / |x_last|, of `rest` at least (rig_rest_state); lag below the count. */
double section_return(const Section *section, size_t lag, double rest);

enum {
    SECTION_PERIOD_MOST = 16, /* cycles */
    SECTION_NONE = 0,         /* not periodic within the cycles that were seen */
    SECTION_UNTOLD = -1,      /* still settling, or too few cycles to say so */
};

/* Quickly told by how the tip returns: after how many cycles, 1 to SECTION_PERIOD_MOST, a motion repeats that was seen
 * at the end of each of `count` cycles (deflection, m; velocity, m/s) of a drive of `omega` rad/s, deflections below
 * `rest` (m) being none; else SECTION_NONE or SECTION_UNTOLD. Nothing is certified: orbit.h does that. */
int section_period(const double *deflection, const double *velocity, size_t count, double omega, double rest);

static inline const double *section_last(const Section *section) {
    return section->state + (section->count - 1) * section->states;
}
