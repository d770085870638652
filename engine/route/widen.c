#include "route/widen.h"

#include <string.h>

#include "base/memory.h"
#include "plan/plan_geometry.h"
#include "route/settle.h"
#include "route/disc_route.h"
#include "space/outline.h"

/* How much width a place lacks can be told from the body's lack of room there only roughly: more room lets a chair
 * turn elsewhere, and a disc has to pass between the points of a grid. So the door is widened about its middle in a
 * copy of the plan, and the question is asked again: first at the estimate, then wider until the answer is yes, then
 * between the last no and that yes. That a wider door never hinders is true of the exact problem; the widths in between
 * that are not tried are taken to follow it. */

#define CENTIMETRES 100.0 /* 1/m */
#define AT_DOOR 0.015     /* m, by which the width of a passage differs from that of the door in it, at most */

static const int further[] = {0, 2, 6, 14}; /* cm, beyond the estimate */

typedef enum WidenAnswer { WIDEN_YES, WIDEN_NO, WIDEN_INTERRUPTED } WidenAnswer;

/* Somebody on the way through goals. */
typedef struct Passenger {
    const Rectangle *body; /* NULL: a disc */
    double radius;         /* m, of the disc */
    const Goal *goals;     /* (goal_count) */
    size_t goal_count;
} Passenger;

static WidenAnswer ask(const RouteQuery *query, const Passenger *who) {
    if (stop_requested(query->stop))
        return WIDEN_INTERRUPTED;
    SearchTrack track = {0};
    DecideAnswer answer = DECIDE_NONE;
    if (who->body)
        answer = settle_quickly(query, who->body, who->goals, who->goal_count, &track);
    else if (disc_route_find(&track, query, who->goals, who->goal_count, who->radius))
        answer = DECIDE_FOUND;
    search_track_clear(&track);
    if (answer == DECIDE_INTERRUPTED || (!who->body && stop_requested(query->stop)))
        return WIDEN_INTERRUPTED;
    return answer == DECIDE_FOUND || answer == DECIDE_SEARCHED ? WIDEN_YES : WIDEN_NO;
}

/* True if a door, `width` cm wide, lies within its segment of the wall, beside the other doors there. */
static bool has_room(const Plan *plan, const Door *door, int width) {
    const Points *points = &plan->walls[door->wall_index].points;
    double length = vec2_distance(points->at[door->segment], points->at[door->segment + 1]);
    double half = width / CENTIMETRES / 2;
    for (size_t d = 0; d < plan->door_count; d++) {
        const Door *other = &plan->doors[d];
        bool beside = other != door && other->wall_index == door->wall_index && other->segment == door->segment;
        if (beside && fabs(other->at - door->at) < half + other->width / 2)
            return false;
    }
    return door->at - half >= 0 && door->at + half <= length;
}

/* Asks whether somebody gets out if a door has a width, cm. */
static WidenAnswer ask_with(const RouteQuery *query, size_t door, int width, const Passenger *who) {
    if (!has_room(query->plan, &query->plan->doors[door], width))
        return WIDEN_NO;
    Door *doors = memory_zeroed(query->plan->door_count, sizeof *doors);
    memcpy(doors, query->plan->doors, query->plan->door_count * sizeof *doors);
    doors[door].width = width / CENTIMETRES;
    Plan plan = *query->plan;
    plan.doors = doors;
    Outline outline = {0};
    Fault fault = {0};
    WidenAnswer answer = WIDEN_NO;
    if (outline_build(&outline, &plan, &fault)) {
        FreeSpace space;
        freespace_build(&space, &outline, query->space->cell);
        RouteQuery wider = *query;
        wider.plan = &plan;
        wider.space = &space;
        wider.fields = fields_create();
        wider.any = wider.whether = true;
        answer = ask(&wider, who);
        fields_destroy(wider.fields);
        freespace_free(&space);
        outline_free(&outline);
    }
    fault_clear(&fault);
    memory_free(doors);
    return answer;
}

int widen_door_at(const Blockage *blockage, const RouteQuery *query) {
    int door = blockage->has > 0 ? outline_door_at(query->plan, blockage->at) : -1;
    return door >= 0 && fabs(blockage->has - query->plan->doors[door].width) <= AT_DOOR ? door : -1;
}

static bool widen_door(Blockage *blockage, const RouteQuery *query, const Passenger *who) {
    int door = widen_door_at(blockage, query);
    if (door < 0)
        return true;
    const double slack = 1e-6; /* cm */
    double width = query->plan->doors[door].width;
    int no = (int)floor(width * CENTIMETRES + slack), yes = 0;
    int estimate = (int)ceil((width + blockage->needs - blockage->has) * CENTIMETRES - slack);
    for (size_t i = 0; i < sizeof further / sizeof *further && !yes; i++) {
        int tried = (estimate > no ? estimate : no + 1) + further[i];
        WidenAnswer answer = ask_with(query, (size_t)door, tried, who);
        if (answer == WIDEN_INTERRUPTED)
            return false;
        *(answer == WIDEN_YES ? &yes : &no) = tried;
    }
    while (yes > no + 1) {
        int tried = (yes + no) / 2;
        WidenAnswer answer = ask_with(query, (size_t)door, tried, who);
        if (answer == WIDEN_INTERRUPTED)
            return false;
        *(answer == WIDEN_YES ? &yes : &no) = tried;
    }
    if (yes) {
        blockage->needs = yes / CENTIMETRES;
        blockage->estimated = false;
    }
    return true;
}

bool widen_to_drive(Blockage *blockage, const RouteQuery *query, const Rectangle *body, const Goal *goals,
                    size_t goal_count) {
    return widen_door(blockage, query, &(Passenger){body, 0, goals, goal_count});
}

bool widen_to_go(Blockage *blockage, const RouteQuery *query, double radius, const Goal *goals, size_t goal_count) {
    return widen_door(blockage, query, &(Passenger){NULL, radius, goals, goal_count});
}
