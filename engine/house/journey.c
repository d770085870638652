/* A person who may take any exit takes the one that leads out first if nobody else is in the way. It is planned as if
 * all were open: let T be the time of that way, from t on, and o the time at which its exit opens. Where t + T >= o
 * nobody waits, and no other exit is sooner. Otherwise one is out at o, and sooner only by an exit that opens before o;
 * so only these are asked next, until nobody waits or T alone takes until the least time so far, since T does not fall
 * as exits are left out. For people on foot o is the last time at which an exit of those asked for opens: it is not
 * known by which of them their field leads out, and they are out by max(t + T, o) at the latest, which for the best
 * exit, asked for as the last to open, is its own time. Doors count, queues do not: how they change the choice on the
 * way is queue.c's. */
#include "house/journey.h"

#include <stdint.h>
#include <stdio.h>

#include "base/memory.h"
#include "base/parallel.h"
#include "base/stop.h"
#include "house/shake.h"
#include "route/narrowest.h"
#include "route/search.h"
#include "route/strength.h"

/* m: radius of a route's point for walkers, so that a crowd can pass it side by side. Assumed. */
static const double VIA_RADIUS = 1.5;

/* Itineraries -------------------------------------------------------------------------------------------------------*/

/* Returns the exit of a route while it is usable, otherwise any exit. */
static size_t exit_of(const House *house, const PlanRoute *route, double time) {
    size_t exit = route ? route->exit_index : SIZE_MAX;
    return exit != SIZE_MAX && house->plan.exits[exit].closes <= time ? SIZE_MAX : exit;
}

double journey_since(const House *house, double time) {
    double last = 0;
    for (size_t e = 0; e < house->plan.exit_count; e++)
        if (house->plan.exits[e].closes <= time)
            last = fmax(last, house->plan.exits[e].closes);
    return last;
}

static Itinerary *find_itinerary(const Journeys *journeys, const Profile *profile, const PlanRoute *route, double since,
                                 size_t via, double opens_before) {
    size_t legs = (route ? route->via.count : 0) - via + 1;
    for (size_t k = 0; k < journeys->itinerary_count; k++) {
        Itinerary *known = journeys->itineraries[k];
        if (!known->chosen && known->profile == profile && known->route == route && known->since == since &&
            known->opens_before == opens_before && known->leg_count == legs)
            return known;
    }
    return NULL;
}

static bool anything_usable(const House *house, const Goal *goal) {
    for (size_t e = 0; e < house->plan.exit_count; e++)
        if (field_exit_usable(goal, &house->plan, e))
            return true;
    return false;
}

/* Adds an itinerary of `legs` legs without fields and goals. */
static Itinerary *new_itinerary(Journeys *journeys, const Profile *profile, double since, size_t legs) {
    Itinerary *itinerary = memory_zeroed(1, sizeof *itinerary);
    *itinerary = (Itinerary){.profile = profile, .since = since, .leg_count = legs};
    itinerary->fields = memory_zeroed(legs, sizeof *itinerary->fields);
    itinerary->legs = memory_zeroed(legs, sizeof *itinerary->legs);
    for (size_t leg = 0; leg < legs; leg++)
        itinerary->legs[leg] = &itinerary->fields[leg];
    journeys->itineraries = memory_reserve(journeys->itineraries, &journeys->itinerary_capacity,
                                           journeys->itinerary_count + 1, sizeof(Itinerary *));
    journeys->itineraries[journeys->itinerary_count++] = itinerary;
    return itinerary;
}

/* Adds an itinerary without fields, from the route's point `via` on. */
static void add_itinerary(Journeys *journeys, const House *house, const Profile *profile, const PlanRoute *route,
                          double since, size_t via, double opens_before) {
    size_t points = route ? route->via.count : 0;
    Itinerary *itinerary = new_itinerary(journeys, profile, since, points - via + 1);
    itinerary->route = route;
    itinerary->opens_before = opens_before;
    for (size_t leg = 0; leg < itinerary->leg_count; leg++) {
        Goal *goal = &itinerary->fields[leg].goal;
        *goal = field_exit_goal(exit_of(house, route, since), since, opens_before);
        if (via + leg < points) {
            goal->at = route->via.at[via + leg];
            goal->radius = fmax(profile->length / 2, VIA_RADIUS);
        }
    }
    itinerary->has_exit = anything_usable(house, &itinerary->fields[itinerary->leg_count - 1].goal);
}

/* Planning ----------------------------------------------------------------------------------------------------------*/

typedef struct Planning {
    const House *house;
    const Whereabouts *places; /* (count) */
    double time;               /* s, now */
    const Stop *stop;
    Journeys *journeys;
    bool again;             /* True if people are moving already */
    bool keep;              /* True to keep the former journey of a chair without a new path */
    bool whether;           /* as in a RouteQuery, with all_or_none */
    bool all_or_none;       /* True to stop at the first person without a path; on one thread */
    bool failed;            /* True if a person has no path */
    bool interrupted;       /* True if the path of a person is not known; both are set only with all_or_none */
    size_t first_itinerary; /* index of the first itinerary without fields */
    const Journeys *known;  /* routes for drivers to follow; NULL: none */
    Recall *recall;         /* of the journeys; NULL: none */
    Fields *fields;         /* of another, for the journeys to share; NULL: they have their own */
} Planning;

/* m: largest overlap of a moving chair with an obstacle. */
static const double PRESSED = 0.05;

static double since_of(const Planning *planning, const Whereabouts *place) {
    return journey_since(planning->house, fmax(place->start, planning->time));
}

static const Plan *plan_of(const House *house, const ClosedLayout *layout) {
    return layout ? &layout->plan : &house->plan;
}

static const FreeSpace *space_of(const House *house, const ClosedLayout *layout) {
    return layout ? &layout->space : &house->space;
}

/* Computes the fields, in place of former ones, in the house or in the layout of closed lines. */
static void lead_walkers(Itinerary *itinerary, const House *house) {
    for (size_t leg = 0; leg < itinerary->leg_count; leg++) {
        Goal goal = itinerary->fields[leg].goal;
        floor_field_clear(&itinerary->fields[leg]);
        floor_field_init(&itinerary->fields[leg], plan_of(house, itinerary->layout), space_of(house, itinerary->layout),
                         itinerary->profile->width / 2, itinerary->profile->free_speed, &goal);
    }
}

static void make_fields(void *context, size_t index) {
    Planning *planning = context;
    const House *house = planning->house;
    Itinerary *itinerary = planning->journeys->itineraries[planning->first_itinerary + index];
    bool barred = false;
    if (stop_requested(planning->stop))
        return; /* they are not part of the question */
    lead_walkers(itinerary, house);
    for (size_t leg = 0; leg < itinerary->leg_count; leg++)
        barred |= closed_on_field(&house->plan, -HUGE_VAL, itinerary->since, &itinerary->fields[leg]);
    if (!barred)
        return;
    itinerary->layout = closed_layout(planning->journeys->closed, house, itinerary->since);
    lead_walkers(itinerary, house);
}

static double set_off(const Planning *planning, const Whereabouts *place) {
    return fmax(place->start, planning->time);
}

/* Returns the last time at which one of the exits opens that open before a time (0: at any); below 0: there is none. */
static double last_opening(const Planning *planning, const Whereabouts *place, double before) {
    const House *house = planning->house;
    Goal goal = field_exit_goal(SIZE_MAX, since_of(planning, place), before);
    double last = -1;
    for (size_t e = 0; e < house->plan.exit_count; e++)
        if (field_exit_usable(&goal, &house->plan, e))
            last = fmax(last, house->plan.exits[e].opens);
    return last;
}

/* Asks for less: only for exits that open before `opens`. False: such exits cannot lead out sooner than `end`, there
 * are none, or the person does not choose. */
static bool ask_for_sooner(const Planning *planning, const Whereabouts *place, double opens, double end,
                           double *before) {
    const Inhabitant *person = &planning->house->people[place->person];
    bool chooses = exit_of(planning->house, person->route, since_of(planning, place)) == SIZE_MAX;
    if (planning->all_or_none || !chooses || !(opens > end) || !(last_opening(planning, place, opens) >= 0))
        return false;
    *before = opens;
    return true;
}

/* Returns the question for a person's way to the exits that open before a time; `layout`: that with closed lines as
 * walls, or NULL for the house. */
static RouteQuery ask(const Planning *planning, const Whereabouts *place, double before, const ClosedLayout *layout) {
    const House *house = planning->house;
    const Inhabitant *person = &house->people[place->person];
    const PlanRoute *route = person->route;
    double since = since_of(planning, place);
    return (RouteQuery){.plan = plan_of(house, layout),
                        .space = space_of(house, layout),
                        .profile = person->profile,
                        .at = place->at,
                        .heading = place->heading,
                        .via = route && route->via.count ? route->via.at + place->via : NULL,
                        .via_count = route ? route->via.count - place->via : 0,
                        .exit = exit_of(house, route, since),
                        .time = since,
                        .opens_before = before,
                        .pressed = planning->again ? PRESSED : 0,
                        .most_reversals = house->plan.run.reversals,
                        .brief = planning->journeys->brief || planning->keep,
                        .any = planning->all_or_none,
                        .whether = planning->whether,
                        .fields = layout ? layout->fields : planning->journeys->fields,
                        .recall = planning->journeys->recall,
                        .stop = planning->stop};
}

static Itinerary *itinerary_of(const Planning *planning, const Whereabouts *place, double before) {
    const Inhabitant *person = &planning->house->people[place->person];
    return find_itinerary(planning->journeys, person->profile, person->route, since_of(planning, place), place->via,
                          before);
}

/* Returns about how long a person walks from a place, s; HUGE_VAL without a way. */
static double walking_time(const Itinerary *itinerary, Vec2 at, double speed) {
    double time = itinerary->has_exit ? floor_field_time(itinerary->legs[0], at) : HUGE_VAL;
    for (size_t leg = 1; leg < itinerary->leg_count; leg++)
        time += floor_field_time(itinerary->legs[leg], itinerary->legs[leg - 1]->goal.at);
    return time * itinerary->legs[0]->speed / speed;
}

static void plan_walk(const Planning *planning, const Whereabouts *place, Journey *journey) {
    const Itinerary *itinerary = NULL;
    double now = set_off(planning, place), least = HUGE_VAL, before = 0, opens, end;
    do {
        const Itinerary *other = itinerary_of(planning, place, before);
        opens = last_opening(planning, place, before);
        end = now + walking_time(other, place->at, planning->house->people[place->person].speed);
        if (!itinerary || fmax(end, opens) < least) /* without any way the first one, to all exits, tells why */
            itinerary = other;
        least = fmin(least, fmax(end, opens));
    } while (end < least && ask_for_sooner(planning, place, opens, end, &before));
    journey->legs = itinerary->legs;
    journey->since = itinerary->since;
    journey->leg_count = itinerary->leg_count;
    journey->route.exit = itinerary->fields[itinerary->leg_count - 1].goal.exit;
    journey->route.answer = itinerary->has_exit ? ROUTE_FOUND : ROUTE_NO_EXIT;
    if (least < HUGE_VAL)
        journey->route.fits = journey->route.drivable = true;
    else if (itinerary->has_exit)
        journey->route.answer = ROUTE_CANNOT_PASS;
}

/* Follows a known route with another body, which is at most as large. */
static void follow(const Planning *planning, const Whereabouts *place, Journey *journey) {
    const House *house = planning->house;
    const Inhabitant *person = &house->people[place->person];
    Rectangle body = search_body(person->profile);
    journey->route = planning->known->of[place->person].route;
    Route *route = &journey->route;
    Pose *poses = memory_zeroed(route->count, sizeof *poses);
    for (size_t p = 0; p < route->count; p++) {
        poses[p] = route->poses[p];
        poses[p].clearance =
            search_clearance(&house->space, &body, poses[p].at, poses[p].heading, ROUTE_CLEARANCE_REACH, NULL);
    }
    route->poses = poses;
    if (route->count > 0)
        route->narrowest = narrowest_on(&house->space, &body, poses, route->count, &route->narrowest_at);
    strength_test(route, person->profile, false);
    if (route->answer == ROUTE_FOUND)
        track_build_driver(&journey->track, house, person, route);
}

static Route ride(const Planning *planning, const Whereabouts *place, double before, const ClosedLayout *layout) {
    RouteQuery query = ask(planning, place, before, layout);
    Rectangle body = search_body(query.profile);
    if (layout && search_clearance(query.space, &body, query.at, query.heading, 0, NULL) < -query.pressed)
        query.pressed = query.profile->length; /* the exit has closed under the body, which goes back from its line */
    return query.profile->driving == DRIVING_MIURA ? strength_round(&query) : strength_drive(&query);
}

/* Takes back a route from a place that even so crosses a closed line, under which the body stands. */
static void refuse_closed(Route *route, Vec2 at, const Plan *plan, double since) {
    size_t exit = route->count ? closed_between(plan, since, at, route->poses[0].at) : SIZE_MAX;
    if (exit == SIZE_MAX)
        exit = closed_on_route(plan, since, route);
    if (exit == SIZE_MAX)
        return;
    const Exit *closed = &plan->exits[exit];
    Blockage blockage = {.at = vec2_scale(vec2_add(closed->from, closed->to), 0.5)};
    snprintf(blockage.what, sizeof blockage.what, "closed exit %s", closed->id);
    size_t aim = route->exit;
    route_free(route);
    *route = (Route){.answer = ROUTE_CANNOT_PASS, .fits = true, .exit = aim, .blockage = blockage};
}

/* Plans a chair's way to the exits that open before a time. */
static void plan_ride_before(const Planning *planning, const Whereabouts *place, double before, Journey *journey) {
    const House *house = planning->house;
    const Inhabitant *person = &house->people[place->person];
    double since = since_of(planning, place);
    bool miura = person->profile->driving == DRIVING_MIURA;
    journey->route = ride(planning, place, before, NULL);
    if (closed_on_route(&house->plan, since, &journey->route) != SIZE_MAX) {
        const ClosedLayout *layout = closed_layout(planning->journeys->closed, house, since);
        route_free(&journey->route);
        journey->route = ride(planning, place, before, layout);
        refuse_closed(&journey->route, place->at, &house->plan, since);
    }
    if (journey->route.answer != ROUTE_FOUND)
        return;
    if (miura)
        track_build_miura(&journey->track, house, person, &journey->route);
    else
        track_build_driver(&journey->track, house, person, &journey->route);
}

static void release(Journey *journey) {
    route_free(&journey->route);
    track_free(&journey->track);
}

static void plan_ride(const Planning *planning, const Whereabouts *place, Journey *journey) {
    const House *house = planning->house;
    const Profile *profile = house->people[place->person].profile;
    double now = set_off(planning, place), least = HUGE_VAL, before = 0;
    bool more = true;
    for (bool first = true; more; first = false) {
        Journey other = {.via = place->via};
        plan_ride_before(planning, place, before, &other);
        bool found = other.route.answer == ROUTE_FOUND, interrupted = other.route.answer == ROUTE_INTERRUPTED;
        double opens = found ? house->plan.exits[other.route.exit].opens : 0;
        double end = found ? now + track_time(&other.track, &house->plan, profile) : HUGE_VAL;
        bool better = first || interrupted || fmax(end, opens) < least;
        release(better ? journey : &other);
        *journey = better ? other : *journey;
        least = fmin(least, fmax(end, opens));
        more = found && end < least && ask_for_sooner(planning, place, opens, end, &before);
    }
}

/* Notes whether all have a path. A person without one decides; the others are then not asked. */
static void note_answer(Planning *planning, RouteAnswer answer) {
    switch (answer) {
    case ROUTE_FOUND:
        break;
    case ROUTE_CANNOT_PASS:
    case ROUTE_NO_EXIT:
    case ROUTE_TOO_WEAK:
        planning->failed = true;
        break;
    case ROUTE_INTERRUPTED:
        planning->interrupted = !planning->failed;
        break;
    }
}

static void plan_journey(void *context, size_t k) {
    Planning *planning = context;
    const Whereabouts *place = &planning->places[k];
    const Inhabitant *person = &planning->house->people[place->person];
    Journey *journey = &planning->journeys->of[place->person], former = *journey;
    *journey = (Journey){.via = place->via};
    if (stop_requested(planning->stop) || planning->failed)
        journey->route = (Route){.answer = ROUTE_INTERRUPTED, .exit = SIZE_MAX};
    else if (person->under)
        journey->route = shake_route(&planning->house->plan, person);
    else if (person->profile->driving == DRIVING_WALKER)
        plan_walk(planning, place, journey);
    else if (planning->known && person->profile->driving == DRIVING_DRIVER)
        follow(planning, place, journey);
    else
        plan_ride(planning, place, journey);
    RouteAnswer answer = journey->route.answer;
    bool keeps = planning->keep && former.track.count && (answer == ROUTE_CANNOT_PASS || answer == ROUTE_TOO_WEAK);
    release(keeps ? journey : &former);
    if (keeps) {
        *journey = former;
        journey->kept = true;
    }
    if (planning->all_or_none)
        note_answer(planning, journey->route.answer);
}

static bool is_without_path(const Journey *journey) {
    return journey->legs && (journey->route.answer == ROUTE_CANNOT_PASS || journey->route.answer == ROUTE_NO_EXIT);
}

/* Takes back the answers of walkers that are not explained yet, after an interruption. */
static void leave_unexplained(const Planning *planning, const bool *explained, size_t count) {
    for (size_t k = 0; k < count; k++) {
        Journey *journey = &planning->journeys->of[planning->places[k].person];
        if (!explained[k] && is_without_path(journey))
            journey->route = (Route){.answer = ROUTE_INTERRUPTED, .exit = journey->route.exit};
    }
}

static const ClosedLayout *layout_of(const Journeys *journeys, const FloorField *const *legs) {
    for (size_t k = 0; k < journeys->itinerary_count; k++)
        if (journeys->itineraries[k]->legs == legs)
            return journeys->itineraries[k]->layout;
    return NULL;
}

/* Explains walkers without a path out. Walkers in the same part of the house are blocked at the same place, so that
 * each place is searched once. */
static void explain_walkers(const Planning *planning, size_t count) {
    const House *house = planning->house;
    bool *explained = memory_zeroed(count, sizeof *explained);
    for (size_t k = 0; k < count; k++) {
        const Whereabouts *place = &planning->places[k];
        Journey *journey = &planning->journeys->of[place->person];
        const Profile *profile = house->people[place->person].profile;
        if (explained[k] || !is_without_path(journey))
            continue;
        const ClosedLayout *layout = layout_of(planning->journeys, journey->legs);
        RouteQuery query = ask(planning, place, 0, layout);
        query.pressed = layout ? profile->width : 0; /* a line may have closed beside who stands there */
        Route route = route_round(&query);
        if (route.answer == ROUTE_INTERRUPTED) {
            leave_unexplained(planning, explained, count);
            break;
        }
        if (route.answer == ROUTE_FOUND) { /* there is a path, but only on the finer grid */
            route.blockage.at = route.narrowest_at;
            outline_place_name(query.space->outline, query.plan, route.blockage.at, route.blockage.what,
                               sizeof route.blockage.what);
        }
        Goal here = {.at = place->at, .radius = profile->width};
        FloorField part;
        floor_field_init(&part, query.plan, query.space, profile->width / 2, profile->free_speed, &here);
        for (size_t other = k; other < count; other++) {
            Journey *like = &planning->journeys->of[planning->places[other].person];
            if (other != k && (like->legs != journey->legs || like->route.answer != journey->route.answer ||
                               !(floor_field_time(&part, planning->places[other].at) < HUGE_VAL)))
                continue;
            explained[other] = true;
            like->route.fits = route.fits;
            like->route.blockage = route.blockage;
        }
        floor_field_clear(&part);
        route_free(&route);
    }
    memory_free(explained);
}

static void plan_all(Planning *planning, size_t count, int jobs) {
    Journeys *journeys = planning->journeys;
    const House *house = planning->house;
    planning->first_itinerary = journeys->itinerary_count;
    for (size_t k = 0; k < count; k++) {
        const Whereabouts *place = &planning->places[k];
        const Inhabitant *person = &house->people[place->person];
        double before = 0;
        bool more = person->profile->driving == DRIVING_WALKER;
        while (more) {
            if (!itinerary_of(planning, place, before))
                add_itinerary(journeys, house, person->profile, person->route, since_of(planning, place), place->via,
                              before);
            more = ask_for_sooner(planning, place, last_opening(planning, place, before), set_off(planning, place),
                                  &before);
        }
    }
    parallel_for(jobs, journeys->itinerary_count - planning->first_itinerary, make_fields, planning);
    parallel_for(jobs, count, plan_journey, planning);
    if (!planning->all_or_none)
        explain_walkers(planning, count);
}

static Journeys plan_nothing(const House *house, bool brief, Fields *fields) {
    return (Journeys){.of = memory_zeroed(house->person_count, sizeof(Journey)),
                      .count = house->person_count,
                      .brief = brief,
                      .fields = fields ? fields : fields_create(),
                      .borrowed = fields,
                      .closed = closed_layouts_create()};
}

/* Plans for all people of `part`, from their start; `planning` holds the options. */
static Journeys plan_from_start(Planning *planning, const bool *part, bool brief, int jobs) {
    const House *house = planning->house;
    Journeys journeys = plan_nothing(house, brief, planning->fields);
    journeys.recall = planning->recall;
    Whereabouts *places = memory_zeroed(house->person_count, sizeof *places);
    size_t count = 0;
    for (size_t i = 0; i < house->person_count; i++)
        if (!part || part[i])
            places[count++] =
                (Whereabouts){i, house->people[i].at, house->people[i].heading, 0, house->people[i].delay};
    planning->places = places;
    planning->journeys = &journeys;
    plan_all(planning, count, jobs);
    memory_free(places);
    return journeys;
}

void journey_plan_again(Journeys *journeys, const House *house, const Whereabouts *places, size_t count, double time,
                        bool keep, int jobs, const Stop *stop) {
    Planning planning = {.house = house,
                         .places = places,
                         .time = time,
                         .stop = stop,
                         .journeys = journeys,
                         .again = true,
                         .keep = keep};
    plan_all(&planning, count, jobs);
}

Journeys journey_plan_all(const House *house, const bool *part, int jobs, const Stop *stop) {
    return plan_from_start(&(Planning){.house = house, .stop = stop}, part, false, jobs);
}

Journeys journey_plan_briefly(const House *house, const bool *part, int jobs, const Stop *stop) {
    return plan_from_start(&(Planning){.house = house, .stop = stop}, part, true, jobs);
}

Journeys journey_plan_recalling(const House *house, const bool *part, bool brief, Recall *recall, Fields *fields,
                                int jobs, const Stop *stop) {
    Planning planning = {.house = house, .stop = stop, .recall = recall, .fields = fields};
    return plan_from_start(&planning, part, brief, jobs);
}

int journey_sense(const House *house, const bool *part) {
    for (size_t i = 0; i < house->person_count; i++) {
        const Inhabitant *person = &house->people[i];
        if (!part[i] || person->profile->driving != DRIVING_DRIVER)
            continue;
        const Points *via = person->route ? &person->route->via : &(Points){0};
        size_t exit = exit_of(house, person->route, journey_since(house, person->delay));
        return frame_sense(&house->plan, person->at, person->heading, via->at, via->count, exit);
    }
    return -1;
}

Journeys journey_plan_any(const House *house, const bool *part, const Stop *stop) {
    return plan_from_start(&(Planning){.house = house, .stop = stop, .all_or_none = true}, part, true, 1);
}

void journey_suffice(Profile *profile) {
    strength_suffice(profile);
}

Journeys journey_follow(const Journeys *known, const House *house, const bool *part, int jobs, const Stop *stop) {
    return plan_from_start(&(Planning){.house = house, .stop = stop, .known = known}, part, true, jobs);
}

const FloorField *const *journey_leg_to(const Journeys *journeys, const House *house, const Profile *profile,
                                        size_t exit, double time) {
    double since = journey_since(house, time);
    for (size_t k = 0; k < journeys->itinerary_count; k++) {
        const Itinerary *known = journeys->itineraries[k];
        if (known->chosen && known->profile == profile && known->since == since && known->fields[0].goal.exit == exit)
            return known->legs;
    }
    return NULL;
}

void journey_lead_to(Journeys *journeys, const House *house, const Profile *profile, const size_t *exits, size_t count,
                     double time, int jobs, const Stop *stop) {
    Planning planning = {
        .house = house, .stop = stop, .journeys = journeys, .first_itinerary = journeys->itinerary_count};
    for (size_t k = 0; k < count; k++) {
        if (journey_leg_to(journeys, house, profile, exits[k], time))
            continue;
        Itinerary *itinerary = new_itinerary(journeys, profile, journey_since(house, time), 1);
        itinerary->fields[0].goal = field_exit_goal(exits[k], time, 0);
        itinerary->chosen = itinerary->has_exit = true;
    }
    parallel_for(jobs, journeys->itinerary_count - planning.first_itinerary, make_fields, &planning);
}

JourneyAnswer journey_possible(const House *house, const bool *part, const Stop *stop) {
    Planning planning = {.house = house, .stop = stop, .all_or_none = true, .whether = true};
    Journeys journeys = plan_from_start(&planning, part, true, 1);
    journey_free_all(&journeys);
    return planning.failed ? JOURNEY_IMPOSSIBLE : planning.interrupted ? JOURNEY_INTERRUPTED : JOURNEY_POSSIBLE;
}

Journeys journey_plan_from(const House *house, const Whereabouts *places, size_t count, double time, bool brief,
                           int jobs, const Stop *stop) {
    Journeys journeys = plan_nothing(house, brief, NULL);
    journey_plan_again(&journeys, house, places, count, time, false, jobs, stop);
    return journeys;
}

void journey_free_all(Journeys *journeys) {
    for (size_t i = 0; i < journeys->count; i++)
        release(&journeys->of[i]);
    memory_free(journeys->of);
    for (size_t k = 0; k < journeys->itinerary_count; k++) {
        Itinerary *itinerary = journeys->itineraries[k];
        for (size_t leg = 0; leg < itinerary->leg_count; leg++)
            floor_field_clear(&itinerary->fields[leg]);
        memory_free(itinerary->fields);
        memory_free(itinerary->legs);
        memory_free(itinerary);
    }
    memory_free(journeys->itineraries);
    if (journeys->fields && !journeys->borrowed)
        fields_destroy(journeys->fields);
    closed_layouts_destroy(journeys->closed);
    *journeys = (Journeys){0};
}
