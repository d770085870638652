/* The natural frequencies of a beam as what a fit compares: without its joint and its drive, at rest. Parameters are
 * the numbers of a beam file. */
#pragma once

#include <stdbool.h>

#include "base/fault.h"
#include "beam/beam.h"
#include "study/experiment.h"

enum { BEAM_FREQUENCIES = 8 /* observables frequency_1 to frequency_8, Hz; NAN: the model has fewer modes */ };

/* Opens the experiment of a beam, which must outlive it. */
void beam_frequencies_open(Experiment *experiment, const Beam *beam);
