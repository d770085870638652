/* One fixed step of the moving house.
 *
 * Source: Miura, Takimoto and Kubodera, "Development of a simulation method for evacuation by wheelchair using Distinct
 * Element Method". Equation of motion of each element
 *
 *     m u'' + c u' + k u = F1 + F2 + F3 + F4
 *
 *     F1  contact with other elements      F3  driving force towards the target speed
 *     F2  contact with obstacles           F4  m v_t^2 / R, centripetal force in a corner (driving `miura`)
 *
 * where the springs and dashpots of the left side are those of the contacts, of the body and of the personal space.
 * For the driver the turning of the body is integrated as well, and the wheels hold it sideways.
 *
 * A step reads the frozen state of all people, then moves all people: semi-implicit Euler. Chairs are few, and each has
 * a shape and a planned path; their forces are computed one by one (ride.h, drive.h). Walkers are many and round; they
 * are computed in slots (walkers.h). */
#pragma once

#include <stddef.h>

#include "house/world.h"

typedef enum StepStatus { STEP_OK, STEP_DIVERGED } StepStatus;

/* Advances the world by house->plan.run.dt. Returns STEP_DIVERGED if a number was no longer finite or a person was
 * thrown out of the house; `*who` (may be NULL) is then that person, who stands where the last good step ended and has
 * phase PHASE_STUCK, and SIZE_MAX otherwise. */
StepStatus step_world(World *world, size_t *who);
