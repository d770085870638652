/* The neck of a round body's way: the narrowest place of the widest way out. */
#pragma once

#include "route/field.h"
#include "route/route.h"

typedef struct Neck {
    Vec2 at;      /* m, middle of the passage */
    double width; /* m, distance between the two obstacles there */
} Neck;

typedef enum NeckAnswer {
    NECK_FOUND,
    NECK_NONE, /* even a body of twice the grid's cell cannot pass */
    NECK_INTERRUPTED,
} NeckAnswer;

/* Finds the neck on the way from the query's start through all goals in order. The body's own size does not count. */
NeckAnswer neck_find(Neck *neck, const RouteQuery *query, const Goal *goals, size_t goal_count);
