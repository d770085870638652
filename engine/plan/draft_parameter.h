/* Numbers of a draft by the names that parameters have everywhere. */
#pragma once

#include "plan/draft.h"

/* Sets a parameter as `--set NAME=VALUE` does: "door.d1.width", "furniture.f3.centre.x", "run.dt", "profile.adult.mass"
 * (kept as an override). False: a fault says what there is instead; whether the value is right tells draft_try. */
bool draft_parameter_set(Draft *draft, const char *name, json_t *value, Fault *fault);
