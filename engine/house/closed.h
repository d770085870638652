/* The house with the lines of closed exits as walls. Such a line holds whoever comes (phase.h), also on the way to
 * another exit; a way that crosses none is planned without them, so that they take no room beside it. */
#pragma once

#include <stdbool.h>

#include "house/house.h"
#include "house/track.h"
#include "route/fields.h"
#include "route/floor_field.h"
#include "route/route.h"

/* A plan in which closed lines are walls without thickness, named as the exits. */
typedef struct ClosedLayout {
    Plan plan; /* as the house's, which must outlive it */
    Outline outline;
    FreeSpace space;
    Fields *fields; /* for searches in it */
    double since;   /* s: the exits have closed by then */
} ClosedLayout;

/* Layouts by time, each built when first asked for. Opaque; safe for several threads. */
typedef struct ClosedLayouts ClosedLayouts;

ClosedLayouts *closed_layouts_create(void);
/* Destroys them; every field must have been released. Accepts NULL. */
void closed_layouts_destroy(ClosedLayouts *layouts);

/* Returns the layout of a house, always the same one, at a time, s, when an exit closes. It lives as long as
 * `layouts`. NULL if GEOS cannot unite its solids. */
const ClosedLayout *closed_layout(ClosedLayouts *layouts, const House *house, double since);

/* Returns the first exit closed by `since` whose line a route crosses; SIZE_MAX: none. */
size_t closed_on_route(const Plan *plan, double since, const Route *route);

/* True if the points of a track from `first` on, or the paths of a floor field from any place, cross such a line. */
bool closed_on_track(const Plan *plan, double since, const Track *track, size_t first);
bool closed_on_field(const Plan *plan, double since, const FloorField *field);
