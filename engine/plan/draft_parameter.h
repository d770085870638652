/* Sets numbers of a draft by their parameter names. */
#pragma once

#include "plan/draft.h"

/* Sets a parameter as `--set NAME=VALUE` does: "door.d1.width", "furniture.f3.centre.x", "run.dt", "profile.adult.mass"
 * (stored as an override). Returns false after an error if the name is unknown; draft_try checks the value. */
bool draft_parameter_set(Draft *draft, const char *name, json_t *value, Fault *fault);
