/* The frame in which the routes of a plan are searched: see frame.c. */
#pragma once

#include <stdbool.h>

#include "plan/plan.h"
#include "space/freespace.h"
#include "space/outline.h"

/* A congruent copy of a plan. Names and ids are the plan's own, so that the plan must outlive the frame; elements have
 * the same indices as in the plan. A frame must not move, since its parts point at one another. */
typedef struct RouteFrame {
    Vec2 origin;   /* m, in the plan */
    Vec2 axis;     /* unit vector of the frame's x axis, in the plan */
    double angle;  /* degree, of that vector */
    bool mirrored; /* True if the frame's y axis points to the right of its x axis */
    double parts;  /* 1/m, to which places are rounded */
    Plan plan;     /* the copy, without rooms, overrides and background */
    Outline outline;
    FreeSpace space;
} RouteFrame;

/* Returns the sense in which the frame of a plan lies for a query, 0 to FRAME_SENSES - 1: which way along the longest
 * wall its x axis points, and whether it is mirrored; with FRAME_EXACT if the start is next to an exit's line, on one
 * side of which it must stay. The person starts at `at` with a heading (rad), passes the points `via` (via_count) and
 * takes `exit` (SIZE_MAX: any). */
int frame_sense(const Plan *plan, Vec2 at, double heading, const Vec2 *via, size_t via_count, size_t exit);

enum { FRAME_LAYS = 8, FRAME_EXACT = FRAME_LAYS, FRAME_SENSES = 2 * FRAME_LAYS };

/* Builds the frame of a plan in a sense, in memory that is not in use; frame_free releases it. Returns false, with
 * nothing to release, if GEOS cannot unite the solids of the copy. */
__attribute__((warn_unused_result)) bool frame_build(RouteFrame *frame, const Plan *plan, int sense);
void frame_free(RouteFrame *frame);

/* Convert a place and a heading (rad) of the plan to the frame. Both are rounded, and the heading is in (-pi, pi]. */
Vec2 frame_place(const RouteFrame *frame, Vec2 at);
double frame_heading(const RouteFrame *frame, double heading);

/* Convert a place and a heading of the frame to the plan. */
Vec2 frame_place_in_plan(const RouteFrame *frame, Vec2 at);
double frame_heading_in_plan(const RouteFrame *frame, double heading);
