/* Chooses places for the labels of a plan: near their objects, where they hide as little as possible. Objects that
 * must stay visible are marked on a coarse mask; each label in turn takes the cheapest of several places around its
 * point and marks it for the labels that follow. The same scene and page give the same places. */
#pragma once

#include "draw/layout.h"

/* Adds a caption for every label of the scene that finds a place where it overlaps no other; the place of the plan on
 * the page must be set. `under`: the layer below, whose labels stay free, too, or NULL. */
void labels_place(Layout *layout, const Layout *under, const Scene *scene);
