/* The job of `clearance fit`: what is fitted, and all that it stands on; and its rows of a house. */
#pragma once

#include "beam/beam.h"
#include "exchange/measured.h"
#include "exchange/observed.h"
#include "exchange/timed.h"
#include "house/house.h"
#include "options/options.h"
#include "study/fit.h"

typedef struct FitJob {
    const Options *options;
    bool is_beam;
    HouseOptions house_options;
    Beam beam;
    Timed timed;
    ObservedLoci *loci; /* (loci_count) of the files */
    size_t loci_count;
    Measured measured;
    Experiment *experiments; /* (experiment_count) of a house one for each measured route and for each measured locus;
                                of a beam motion and tones */
    size_t experiment_count, experiment_capacity;
    FitUnknown unknowns[FIT_UNKNOWNS_MOST];
    Fit fit;
    size_t row_capacity;
    Arena arena;
} FitJob;

void fit_house_add_row(FitJob *job, FitRow row);

/* Reads the house and what was measured in it, and adds the rows. Returns false after errors. */
bool fit_house_open(FitJob *job, Fault *fault);

/* Returns the free speed and the steering time of the first chair, which is what times alone can tell; NULL: nobody has
 * a chair. */
const char *fit_house_names(FitJob *job);

/* Releases the experiments and what was read. */
void fit_house_close(FitJob *job);
