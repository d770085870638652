/* The plans of all people before the house begins to move, and again when an exit has closed: for a chair a route and
 * its track, for a walker the floor fields that lead from each point of the route to the next. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "base/stop.h"
#include "route/fields.h"
#include "house/closed.h"
#include "house/house.h"
#include "route/recall.h"
#include "route/floor_field.h"
#include "route/route.h"
#include "house/track.h"

/* The plan of one person. */
typedef struct Journey {
    Route route;                   /* of a walker only answer, blockage and exit, SIZE_MAX for any exit */
    Track track;                   /* of a chair; empty without a path */
    const FloorField *const *legs; /* (leg_count) of a walker, in order; not owned */
    size_t leg_count;
    double since; /* s, of a walker's legs: they cross no line of an exit that has closed by then */
    size_t via;   /* index in the route's points of the first one of this journey */
    bool kept;    /* True if no path was found when it was last planned again, so that it is the former one */
} Journey;

/* The fields shared by people of one profile with one route, from some time on. */
typedef struct Itinerary {
    const Profile *profile;
    const PlanRoute *route;     /* NULL: no route, the quickest exit */
    double since;               /* s: exits closed by then do not count */
    double opens_before;        /* s: exits that open at that time or later do not count; 0: all count */
    bool has_exit;              /* False if all exits are closed */
    bool chosen;                /* True if it leads to one exit, which a person has chosen on the way */
    const ClosedLayout *layout; /* in which the fields are, since a closed line is in the way; NULL: in the house */
    FloorField *fields;         /* (leg_count) */
    const FloorField **legs;    /* (leg_count) into fields */
    size_t leg_count;
} Itinerary;

typedef struct Journeys {
    Journey *of; /* (count) by person */
    size_t count;
    Itinerary **itineraries; /* (itinerary_count) */
    size_t itinerary_count, itinerary_capacity;
    Fields *fields;        /* shared by the searches of chairs */
    bool borrowed;         /* the fields belong to another */
    ClosedLayouts *closed; /* for ways that the lines of closed exits bar */
    bool brief;            /* as in a RouteQuery, for all plans */
    Recall *recall;        /* as in a RouteQuery; not owned */
} Journeys;

/* The state of a person whose path is planned again. */
typedef struct Whereabouts {
    size_t person;
    Vec2 at;        /* m, the reference point */
    double heading; /* rad */
    size_t via;     /* index of the next of the route's points */
    double start;   /* s, end of the delay */
} Whereabouts;

/* Plans the journeys of all people, on up to `jobs` threads; person i takes part when `part` is NULL or part[i]. Once
 * `stop` (may be NULL) is requested, the journeys not yet planned are ROUTE_INTERRUPTED. journey_free_all releases the
 * journeys. */
Journeys journey_plan_all(const House *house, const bool *part, int jobs, const Stop *stop);
Journeys journey_plan_briefly(const House *house, const bool *part, int jobs, const Stop *stop);

/* Plans with the answers kept for this and other houses (NULL: none), and with fields that other journeys use as well
 * (NULL: with fields of their own); both must outlive the journeys, and the fields no house that is asked about. */
Journeys journey_plan_recalling(const House *house, const bool *part, bool brief, Recall *recall, Fields *fields,
                                int jobs, const Stop *stop);
void journey_free_all(Journeys *journeys);

/* Returns the sense of the frame (frame.h) in which the first chair of `part` is planned for; -1: there is none. Chairs
 * of the same sense wait for the same frame and fields. */
int journey_sense(const House *house, const bool *part);

/* Plans on one thread, with fewer searches, to decide whether there is any way: each chair's path is the first free
 * one that is found, and the journeys after the first person without one are ROUTE_INTERRUPTED. */
Journeys journey_plan_any(const House *house, const bool *part, const Stop *stop);

/* Gives a profile the strength that every way takes, as far as it has less (strength.h). */
void journey_suffice(Profile *profile);

/* Plans for the drivers of another house on the same plan: each follows the route that `known` has, planned for
 * a body that is at least as large, at a speed of their own. Paper's chairs and walkers are planned for. */
Journeys journey_follow(const Journeys *known, const House *house, const bool *part, int jobs, const Stop *stop);

typedef enum JourneyAnswer { JOURNEY_POSSIBLE, JOURNEY_IMPOSSIBLE, JOURNEY_INTERRUPTED } JourneyAnswer;

/* Tells whether every person who takes part has a path out. */
JourneyAnswer journey_possible(const House *house, const bool *part, const Stop *stop);

/* Does the same for `count` people in the middle of a run, at `time`; other people have no journey. */
Journeys journey_plan_from(const House *house, const Whereabouts *places, size_t count, double time, bool brief,
                           int jobs, const Stop *stop);

/* Plans again from `time` on for `count` moving people: to the exit of their route while that is usable, otherwise to
 * the one by which they are out first. Their former journeys are released; with `keep`, those of chairs only where a
 * new path is found, and it is not told why there is none. */
void journey_plan_again(Journeys *journeys, const House *house, const Whereabouts *places, size_t count, double time,
                        bool keep, int jobs, const Stop *stop);

/* Returns the last time up to `time`, s, and at least 0, at which an exit has closed: paths do not change before the
 * next closing. */
double journey_since(const House *house, double time);

/* Computes the fields of one profile to each of `count` exits that are open at `time`, unless they are there. */
void journey_lead_to(Journeys *journeys, const House *house, const Profile *profile, const size_t *exits, size_t count,
                     double time, int jobs, const Stop *stop);

/* Returns the one leg, an array of one field, from any place to an exit for people of the profile at that time, if
 * journey_lead_to has computed it, otherwise NULL. Owned by the journeys. */
const FloorField *const *journey_leg_to(const Journeys *journeys, const House *house, const Profile *profile,
                                        size_t exit, double time);
