/* Places for the labels of a plan: near what they name, and where they hide as little as possible. What must stay
 * visible is marked on a coarse mask; each label in turn takes the cheapest of some places around its point and marks
 * it for those that follow. The same scene and page give the same places. */
#pragma once

#include "draw/layout.h"

/* Adds a caption for every label of the scene that finds a place; the plan's place on the page must be set. */
void labels_place(Layout *layout, const Scene *scene);
