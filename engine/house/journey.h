/* What everybody intends before the house begins to move, and again when an exit has closed: a chair a route and how to
 * follow it, somebody on foot the distance fields that lead from one point of the way to the next. */
#pragma once

#include <signal.h>
#include <stdbool.h>
#include <stddef.h>

#include "route/fields.h"
#include "house/house.h"
#include "route/floor_field.h"
#include "route/route.h"
#include "house/track.h"

/* What is planned for one person. */
typedef struct Journey {
    Route route;                   /* of a walker only answer, blockage and exit, SIZE_MAX for any */
    Track track;                   /* of a chair; empty when there is no way */
    const FloorField *const *legs; /* (leg_count) of a walker, one after another; not owned */
    size_t leg_count;
    size_t via; /* of the route's points, the first one of this journey */
} Journey;

/* The fields that people of one profile with one route share, from some time on. */
typedef struct Itinerary {
    const Profile *profile;
    const PlanRoute *route;  /* NULL: none, the quickest exit */
    double since;            /* s: exits closed by then do not count */
    bool again;              /* made while people were on the way: exits that are not open yet come last */
    bool has_exit;           /* otherwise all exits are closed */
    FloorField *fields;      /* (leg_count) */
    const FloorField **legs; /* (leg_count) into fields */
    size_t leg_count;
} Itinerary;

typedef struct Journeys {
    Journey *of; /* (count) by person */
    size_t count;
    Itinerary **itineraries; /* (itinerary_count) */
    size_t itinerary_count, itinerary_capacity;
    Fields *fields; /* that the chairs' searches share */
    bool brief;     /* all that are planned: as in a RouteQuery */
} Journeys;

/* Where somebody is who plans anew. */
typedef struct Whereabouts {
    size_t person;
    Vec2 at;        /* m, the reference point */
    double heading; /* rad */
    size_t via;     /* of the route's points, the next one */
    double start;   /* s, when the delay is over */
} Whereabouts;

/* Plans everybody's journey, on up to `jobs` threads, until `stop` (may be NULL) is set; person i takes part when
 * `part` is NULL or part[i]. journey_free_all releases it. */
Journeys journey_plan_all(const House *house, const bool *part, int jobs, const volatile sig_atomic_t *stop);
Journeys journey_plan_briefly(const House *house, const bool *part, int jobs, const volatile sig_atomic_t *stop);
void journey_free_all(Journeys *journeys);

/* Has everybody of them a way out? */
bool journey_possible(const House *house, const bool *part, const volatile sig_atomic_t *stop);

/* The same for `count` people in the middle of a run, at `time`; nobody else has a journey. */
Journeys journey_plan_from(const House *house, const Whereabouts *places, size_t count, double time, bool brief,
                           int jobs, const volatile sig_atomic_t *stop);

/* Plans again from `time` on for `count` people who are on the way: to the exit of their route while that is usable,
 * otherwise to the quickest. What they had before is released. */
void journey_plan_again(Journeys *journeys, const House *house, const Whereabouts *places, size_t count, double time,
                        int jobs, const volatile sig_atomic_t *stop);
