/* The Poincare section: the state once per cycle (stroboscopic), and each cycle's largest
 * force on either side of the joint. */
#pragma once

#include <stddef.h>

#include "cycle/cycle.h"

typedef struct Section {
    size_t count, states;
    double *state;                 /* (count x states) */
    double *deflection, *velocity; /* (count) of the tip, m and m/s */
    double *peak;                  /* (count x 2) N, on the upper and the lower side; 0: no contact in that cycle */
    size_t state_capacity, deflection_capacity, velocity_capacity, peak_capacity;
} Section;

/* Adds the present state of the motion, at the end of a cycle, and the peaks since the last addition, and resets the
 * peaks. A zeroed section is empty. */
void section_add(Section *section, CycleMotion *motion);

/* Adds the first `count` states of another section, with what belongs to them. */
void section_join(Section *section, const Section *from, size_t count);

void section_clear(Section *section);

/* Peaks of both sides, contacts only. */
typedef struct SectionPeaks {
    double min, max, mean; /* N */
    size_t count;          /* 0: no contact */
} SectionPeaks;

SectionPeaks section_peaks(const Section *section);

/* Returns |x_last - x_(last - lag)| / |x_last|, with |x_last| at least `rest` (cycle_rest_state); lag is below the
 * count. */
double section_return(const Section *section, size_t lag, double rest);

enum {
    SECTION_PERIOD_MOST = 16, /* cycles */
    SECTION_NONE = 0,         /* not periodic within the record */
    SECTION_UNDECIDED = -1,   /* still settling, or the record is too short */
};

/* Estimates the period from the returns of the tip: the number of cycles, 1 to SECTION_PERIOD_MOST, after which a
 * motion repeats, given deflection (m) and velocity (m/s) at the end of each of `count` cycles of a drive of `omega`
 * rad/s; deflections below `rest` (m) count as none. Returns SECTION_NONE or SECTION_UNDECIDED otherwise. Nothing is
 * certified: orbit.h does that. */
int section_period(const double *deflection, const double *velocity, size_t count, double omega, double rest);

static inline const double *section_last(const Section *section) {
    return section->state + (section->count - 1) * section->states;
}
