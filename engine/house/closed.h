/* The house with the lines of exits that have closed as walls. Such a line bars the way (phase.h), also to another
 * exit. A chair's way that does not cross one is planned without them, so that they take no room beside it, and so is a
 * field for people on foot that leads nowhere across one. Nobody plans round the line of an exit that opens later. */
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
} ClosedLayout;

/* Layouts by time, each built when first asked for. Opaque; safe for several threads. */
typedef struct ClosedLayouts ClosedLayouts;

ClosedLayouts *closed_layouts_create(void);
/* Destroys them; every field must have been released. Accepts NULL. */
void closed_layouts_destroy(ClosedLayouts *layouts);

/* Returns the layout of a house, always the same one, at a time, s, when an exit closes. It lives as long as
 * `layouts`. NULL if GEOS cannot unite its solids. */
const ClosedLayout *closed_layout(ClosedLayouts *layouts, const House *house, double since);

/* Returns the exit closed by `since` whose line a step crosses; SIZE_MAX: none. A step that begins on a line does not
 * cross it, as in phase_hold. */
size_t closed_between(const Plan *plan, double since, Vec2 from, Vec2 to);

/* Returns the first exit closed by `since` whose line a route crosses; SIZE_MAX: none. */
size_t closed_on_route(const Plan *plan, double since, const Route *route);

/* True if the points of a track from `first` on cross such a line. */
bool closed_on_track(const Plan *plan, double since, const Track *track, size_t first);

/* True if paths of a floor field, from any place, cross the line of an exit that has closed after `after`, up to
 * `since`. */
bool closed_on_field(const Plan *plan, double after, double since, const FloorField *field);
