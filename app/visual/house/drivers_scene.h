/* Where the drivers of a population touch something, on the plan: a disc at each place, its area the share of drivers
 * who touch there, its shade the fastest impact, its letter the part of the chair: F front, S side, T tail.
 * Hands (H) that meet something are dashed rings of the same scale, below the discs. */
#pragma once

#include "draw/scene.h"
#include "experiment/drivers.h"

/* Adds them, and a list of the worst by energy (danger.h), to the scene of the house's plan. */
void drivers_scene_add(Scene *scene, const House *house, const Drivers *drivers);
