/* One try of grading: whether a body that is grown all round finds a way. */
#pragma once

#include "base/stop.h"
#include "house/house.h"
#include "house/journey.h"

typedef struct GradeTry {
    bool found, fits;
    double holds;      /* m, growth that this way has room for, at least, */
    int reversals;     /* with so many changes of direction */
    bool blocked;      /* True if it is known what blocks it: */
    bool weak;         /* True if there is a way, but not for the driver's strength, */
    Blockage blockage; /* which this tells; the texts are its own */
} GradeTry;

/* Plans a person's way with the body grown by `growth` m and at most `reversals` changes of direction; the axle stays
 * where it is. */
GradeTry grade_try_growth(const House *house, size_t person, double growth, int reversals, const Stop *stop);
