/* The facts of a beam's response as rows, for `run`, `run --json` and the window's panel. */
#pragma once

#include "beam/beam_cycle.h"
#include "result/result.h"

/* One record of the drive and the motion: periodic or chaotic, and what that rests on. The beam may go before it. */
ResultTable result_beam_motion(const Beam *beam, const Response *response);

/* One record of forces, contact and modes. */
ResultTable result_beam_forces(const Rig *rig, const Response *response);
