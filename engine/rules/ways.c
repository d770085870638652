#include "rules/ways.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

#include "plan/plan_geometry.h"
#include "route/route.h"

static const double WIDTH = 0.3; /* m, of the disc */

/* A profile of the disc, as quick everywhere, so that its way is the shortest. */
static Profile disc_profile(void) {
    return (Profile){.name = "disc",
                     .driving = DRIVING_MIURA,
                     .length = WIDTH,
                     .width = WIDTH,
                     .axle = WIDTH / 2,
                     .corner_radius = WIDTH / 2,
                     .free_speed = 1,
                     .minimum_speed = 1,
                     .steering_time = 1,
                     .acceleration = 1,
                     .deceleration = 1,
                     .turn_rate = 1};
}

bool ways_meet(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
    Vec2 ab = vec2_sub(b, a), cd = vec2_sub(d, c);
    double one = vec2_cross(ab, vec2_sub(c, a)), other = vec2_cross(ab, vec2_sub(d, a));
    double third = vec2_cross(cd, vec2_sub(a, c)), fourth = vec2_cross(cd, vec2_sub(b, c));
    return ((one <= 0 && other >= 0) || (one >= 0 && other <= 0)) &&
           ((third <= 0 && fourth >= 0) || (third >= 0 && fourth <= 0));
}

static bool is_inside(const Points *outline, Vec2 at) {
    bool inside = false;
    for (size_t i = 0, j = outline->count - 1; i < outline->count; j = i++) {
        Vec2 a = outline->at[i], b = outline->at[j];
        if ((a.y > at.y) != (b.y > at.y) && at.x < (b.x - a.x) * (at.y - a.y) / (b.y - a.y) + a.x)
            inside = !inside;
    }
    return inside;
}

size_t ways_room(const Plan *plan, Vec2 at) {
    for (size_t r = 0; r < plan->room_count; r++)
        if (plan->rooms[r].outline.count > 2 && is_inside(&plan->rooms[r].outline, at))
            return r;
    return SIZE_MAX;
}

bool ways_in_opening(const Plan *plan, Vec2 at, double beside) {
    for (size_t d = 0; d < plan->door_count; d++) {
        Vec2 from, to;
        plan_geometry_door_ends(plan, &plan->doors[d], &from, &to);
        Vec2 along = vec2_unit(vec2_sub(to, from)), place = vec2_unturn(vec2_sub(at, from), along);
        double half = plan->walls[plan->doors[d].wall_index].thickness / 2;
        if (fabs(place.y) <= half + beside && place.x >= -beside && place.x <= vec2_distance(from, to) + beside)
            return true;
    }
    return false;
}

/* Walks along the poses of a route and leaves a place each step. */
static RuleWay way_of_route(const Route *route) {
    RuleWay way = {.person = SIZE_MAX, .room = SIZE_MAX};
    size_t capacity = 0;
    double left = 0; /* m, to the next place */
    for (size_t i = 0; i + 1 < route->count; i++) {
        Vec2 from = route->poses[i].at, to = route->poses[i + 1].at;
        double length = vec2_distance(from, to), s = left;
        Vec2 along = vec2_unit(vec2_sub(to, from));
        for (; s < length; s += WAYS_STEP) {
            way.at = memory_reserve(way.at, &capacity, way.count + 1, sizeof *way.at);
            way.at[way.count++] = vec2_along(from, s, along);
        }
        left = s - length;
    }
    if (route->count) {
        way.at = memory_reserve(way.at, &capacity, way.count + 1, sizeof *way.at);
        way.at[way.count++] = route->poses[route->count - 1].at;
    }
    return way;
}

static void add_way(RuleWays *ways, const House *house, RouteQuery *query, size_t person) {
    Route route = route_round(query);
    ways->interrupted |= route.answer == ROUTE_INTERRUPTED;
    if (route.answer == ROUTE_FOUND) {
        RuleWay way = way_of_route(&route);
        way.person = person;
        way.room = ways_room(&house->plan, query->at);
        ways->ways[ways->count++] = way;
    }
    route_free(&route);
}

RuleWays ways_find(const House *house, const Stop *stop) {
    const Plan *plan = &house->plan;
    Profile profile = disc_profile();
    Fields *fields = fields_create();
    RuleWays ways = {.ways = memory_zeroed(house->person_count + plan->door_count + 1, sizeof *ways.ways)};
    RouteQuery query = {.plan = plan,
                        .space = &house->space,
                        .profile = &profile,
                        .exit = SIZE_MAX,
                        .brief = true,
                        .stop = stop,
                        .fields = fields};
    for (size_t i = 0; i < house->person_count && !ways.interrupted; i++) {
        const Inhabitant *person = &house->people[i];
        if (plan_find_person(plan, person->id) == SIZE_MAX) /* of a crowd */
            continue;
        query.at = person->at;
        query.exit = person->route ? person->route->exit_index : SIZE_MAX;
        query.via = person->route ? person->route->via.at : NULL;
        query.via_count = person->route ? person->route->via.count : 0;
        add_way(&ways, house, &query, i);
    }
    query.exit = SIZE_MAX;
    query.via_count = 0;
    for (size_t d = 0; d < plan->door_count && !ways.interrupted; d++) {
        Vec2 from, to;
        if (plan->doors[d].state == DOOR_LOCKED)
            continue;
        plan_geometry_door_ends(plan, &plan->doors[d], &from, &to);
        query.at = vec2_scale(vec2_add(from, to), 0.5);
        add_way(&ways, house, &query, SIZE_MAX);
    }
    fields_destroy(fields);
    return ways;
}

void ways_free(RuleWays *ways) {
    for (size_t i = 0; i < ways->count; i++)
        memory_free(ways->ways[i].at);
    memory_free(ways->ways);
    *ways = (RuleWays){0};
}
