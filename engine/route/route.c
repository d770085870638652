#include "route/route.h"

#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include "base/memory.h"
#include "base/real.h"
#include "route/blockage.h"
#include "route/settle.h"
#include "route/fit.h"
#include "route/frame.h"
#include "route/narrowest.h"
#include "route/search.h"
#include "route/smooth.h"
#include "route/disc_route.h"
#include "route/start.h"
#include "route/widen.h"

/* m: a chair that crosses the exit's line continues straight for this distance, as far as the space is free. */
#define BEYOND_EXIT 0.3
#define BEYOND_CLEARANCE 0.1 /* m, clearance from obstacles in front of the door */

/* The straightened end of a path: candidate lengths, m; step, m; clearance, m; largest curvature, 1/m. */
static const double end_lengths[] = {4, 3, 2, 1};
#define END_STEP 0.05
#define END_CLEARANCE 0.08
#define END_CURVATURE 1.5

#define SAME_PLACE 0.5 /* m: largest distance between two findings about one obstacle */

/* m: amounts by which bodies are smaller on every side to find where the true body sticks: the first, doubled up to the
 * last, and how near to the least one the answer is. */
#define SMALLER 0.03
#define SMALLEST 0.12
#define SMALLER_BY 0.004

#define FIT_MOST 0.1 /* m: a body with this margin has room enough */
#define SHALLOW 0.05 /* m: a body that lacks less margin than this is told by how much */
#define DEEPEST 0.2  /* m: a body that lacks more needs another passage, not a wider one */

typedef struct Legs {
    Goal *goals; /* (count) */
    size_t count;
} Legs;

static Legs legs_make(const RouteQuery *query) {
    Legs legs = {memory_zeroed(query->via_count + 1, sizeof(Goal)), query->via_count + 1};
    for (size_t i = 0; i < query->via_count; i++)
        legs.goals[i] = (Goal){.at = query->via[i], .radius = query->profile->length / 2, .exit = SIZE_MAX};
    legs.goals[query->via_count] = field_exit_goal(query->exit, query->time, query->opens_before);
    return legs;
}

/* Forgets what an interrupted search has found so far: it may differ from the answer. */
static void interrupt(Route *route) {
    size_t exit = route->exit;
    route_free(route);
    *route = (Route){.answer = ROUTE_INTERRUPTED, .exit = exit};
}

/* True if there is a usable exit. Otherwise the route names the closed one. */
static bool exit_usable(const RouteQuery *query, const Goal *goal, Route *route) {
    for (size_t e = 0; e < query->plan->exit_count; e++)
        if (field_exit_usable(goal, query->plan, e))
            return true;
    route->answer = ROUTE_NO_EXIT;
    route->blockage = (Blockage){.at = query->at};
    size_t exit = query->exit < query->plan->exit_count ? query->exit : 0;
    if (query->plan->exit_count > 0) {
        const Exit *closed = &query->plan->exits[exit];
        route->blockage.at = vec2_scale(vec2_add(closed->from, closed->to), 0.5);
        snprintf(route->blockage.what, sizeof route->blockage.what, "exit %s", closed->id);
    } else {
        snprintf(route->blockage.what, sizeof route->blockage.what, "no exit");
    }
    return false;
}

/* Returns the pose at which a body that comes straight from `from` crosses the exit: at a right angle, 2 cm behind the
 * line, as far from its ends as before, at most in the middle. */
static Pose straight_out(const Exit *exit, const Rectangle *body, const Pose *from) {
    const double hair = 0.02; /* m */
    Vec2 along = vec2_unit(vec2_sub(exit->to, exit->from)), out = vec2_left(along);
    double length = vec2_distance(exit->from, exit->to);
    double margin = fmin(body->half_width + END_CLEARANCE, length / 2);
    double at = vec2_dot(vec2_sub(from->at, exit->from), along);
    at = fmax(margin, fmin(length - margin, at));
    if (vec2_dot(out, vec2_heading(from->heading)) < 0)
        out = vec2_scale(out, -1);
    return (Pose){vec2_along(vec2_along(exit->from, at, along), hair, out), real_atan2(out.y, out.x), 0, 1};
}

/* Adds the path from one pose to another on a cubic, forwards. Returns false if it is too curved or not free. */
static bool connect(SearchTrack *track, const RouteQuery *query, const Rectangle *body, const Pose *from,
                    const Pose *to) {
    int pieces = (int)ceil(vec2_distance(from->at, to->at) / END_STEP);
    Pose before = *from;
    for (int i = 1; i <= pieces; i++) {
        Vec2 at = smooth_between(from, to, 1, (double)i / pieces);
        Vec2 ahead = smooth_between(from, to, 1, (double)(i + 1) / pieces);
        Vec2 way = vec2_sub(i < pieces ? ahead : at, before.at);
        Pose pose = {at, i < pieces ? real_atan2(way.y, way.x) : to->heading, 0, 1};
        double turn = fabs(vec2_wrap_angle(pose.heading - before.heading));
        double clearance = search_clearance(query->space, body, at, pose.heading, END_CLEARANCE, NULL);
        if (turn > END_CURVATURE * vec2_length(way) || clearance < END_CLEARANCE)
            return false;
        pose.heading = before.heading + vec2_wrap_angle(pose.heading - before.heading);
        search_track_add(track, pose);
        before = pose;
    }
    return true;
}

/* Replaces the last metres by a path straight out where there is room: the search crosses the exit at any angle. Poses
 * up to `first` stay unchanged. */
static void straighten_end(SearchTrack *track, const RouteQuery *query, const Rectangle *body, size_t first) {
    for (size_t t = 0; t < sizeof end_lengths / sizeof *end_lengths; t++) {
        double left = 0;
        size_t index = track->count - 1;
        while (index > first && left < end_lengths[t] && track->poses[index].direction == 1) {
            left += vec2_distance(track->poses[index].at, track->poses[index - 1].at);
            index--;
        }
        if (left < end_lengths[t])
            continue;
        SearchTrack tail = {0};
        Pose out = straight_out(&query->plan->exits[track->exit], body, &track->poses[index]);
        bool good = connect(&tail, query, body, &track->poses[index], &out);
        if (good) {
            track->count = index + 1;
            for (size_t i = 0; i < tail.count; i++)
                search_track_add(track, tail.poses[i]);
        }
        search_track_clear(&tail);
        if (good)
            return;
    }
}

/* Continues a track that has crossed the exit straight to BEYOND_EXIT behind the line, as far as the space is free. */
static void go_beyond_exit(SearchTrack *track, const RouteQuery *query, const Rectangle *body) {
    const int steps = 6;
    const Exit *exit = &query->plan->exits[track->exit];
    Pose pose = track->poses[track->count - 1];
    double passed = fabs(vec2_cross(vec2_unit(vec2_sub(exit->to, exit->from)), vec2_sub(pose.at, exit->from)));
    double step = (BEYOND_EXIT - passed) / steps;
    double clearance = search_clearance(query->space, body, pose.at, pose.heading, 2 * BEYOND_CLEARANCE, NULL);
    for (int i = 0; i < steps && step > 0; i++) {
        pose.at = vec2_along(pose.at, pose.direction * step, vec2_heading(pose.heading));
        double ahead = search_clearance(query->space, body, pose.at, pose.heading, 2 * BEYOND_CLEARANCE, NULL);
        if (ahead < fmin(clearance, BEYOND_CLEARANCE) || clearance + ahead < step)
            return;
        clearance = ahead;
        search_track_add(track, pose);
    }
}

/* Ends a track with its first pose behind the exit's line, whatever the length of the motion that crosses it; returns
 * the index of that pose. */
static size_t end_behind_exit(SearchTrack *track, const Plan *plan) {
    Goal goal = {.exit = track->exit, .time = -HUGE_VAL};
    size_t crossed, index = track->count - 1;
    while (index > 1 && !field_goal_reached(&goal, plan, track->poses[index - 1].at, track->poses[index].at, &crossed))
        index--;
    track->count = index + 1;
    return index;
}

/* True if a smoothed track still crosses the exit for which it was searched. */
static bool crosses_exit(const SearchTrack *track, const Plan *plan) {
    Goal goal = {.exit = track->exit, .time = -HUGE_VAL};
    size_t exit;
    for (size_t i = 1; i < track->count; i++)
        if (field_goal_reached(&goal, plan, track->poses[i - 1].at, track->poses[i].at, &exit))
            return true;
    return false;
}

static void give_poses(Route *route, const SearchTrack *track) {
    route->answer = ROUTE_FOUND;
    route->fits = route->drivable = true;
    route->reversals = track->reversals;
    route->exit = track->exit;
    route->poses = track->poses;
    route->count = track->count;
    for (size_t i = 1; i < track->count; i++)
        route->length += vec2_distance(track->poses[i - 1].at, track->poses[i].at);
}

/* Smooths a searched track and stores it in the route. */
static void answer_drive(Route *route, const RouteQuery *query, const Rectangle *body, SearchTrack *track, size_t *pins,
                         size_t leg_count) {
    straighten_end(track, query, body, leg_count > 1 ? pins[leg_count - 2] : 0);
    pins[leg_count - 1] = end_behind_exit(track, query->plan);
    go_beyond_exit(track, query, body);
    SearchTrack searched = {.reversals = track->reversals, .direction = track->direction, .exit = track->exit};
    for (size_t i = 0; i < track->count; i++)
        search_track_add(&searched, track->poses[i]);
    smooth_track(track, query->space, body, pins, leg_count - 1);
    if (!crosses_exit(track, query->plan)) {
        /* Pinned at the pose just across the line, the track cannot miss the line. */
        search_track_clear(track);
        *track = searched;
        searched = (SearchTrack){0};
        smooth_track(track, query->space, body, pins, leg_count);
    }
    search_track_clear(&searched);
    give_poses(route, track);
}

static Rectangle shrunk(const Rectangle *body, double by) {
    Rectangle smaller = *body;
    smaller.half_length = fmax(body->half_length - by, 0.01);
    smaller.half_width = fmax(body->half_width - by, 0.01);
    smaller.ahead = fmin(body->ahead, smaller.half_length);
    return smaller;
}

/* Finds where the true body sticks on the way of one that is smaller on every side, by `least` m and as little more as
 * is needed, unless the place is a door: that is widened by trying. The blockage stays empty if there is no such way.
 * Returns false if interrupted. */
static bool stick(Blockage *blockage, const RouteQuery *query, const Legs *legs, const Rectangle *body, double least) {
    double no = 0, yes = 0, by = SMALLER;
    while (yes > 0 ? yes - no > SMALLER_BY && widen_door_at(blockage, query) < 0 : by <= SMALLEST) {
        Rectangle smaller = shrunk(body, least + by);
        SearchTrack track = {0};
        DecideAnswer answer = settle_quickly(query, &smaller, legs->goals, legs->count, &track);
        bool passes = answer == DECIDE_FOUND || answer == DECIDE_SEARCHED;
        if (passes) {
            blockage_of_track(blockage, query, body, &track);
            if (blockage->needs <= blockage->has) /* the true body has room at every pose, but hardly any */
                blockage->needs = blockage->has + 2 * (least + by);
        }
        search_track_clear(&track);
        if (answer == DECIDE_INTERRUPTED)
            return false;
        *(passes ? &yes : &no) = by;
        by = yes > 0 ? (yes + no) / 2 : 2 * by;
    }
    return true;
}

/* Explains a body that fits but cannot be driven: where a slightly smaller body passes, the true one sticks. Returns
 * false if interrupted. */
static bool explain_not_drivable(Route *route, const RouteQuery *query, const Legs *legs, const Rectangle *body,
                                 double margin, const FitPlace *tightest) {
    Blockage stuck = {0};
    FitPlace place = *tightest;
    /* A body that cannot be carried through cannot be driven through. */
    bool whole = stick(&stuck, query, legs, body, fmax(-margin - FIT_RESOLUTION, 0));
    if (whole && !*stuck.what && !(tightest->margin < -FIT_RESOLUTION))
        whole = fit_margin(query, body, legs->goals, legs->count, 0, FIT_MOST, &place) == FIT_KNOWN;
    if (whole && !*stuck.what)
        blockage_of_fit(&stuck, query, body, &place);
    route->blockage = stuck;
    return whole;
}

/* Raises the required width to that for driving: where a smaller body that can be driven through sticks at the same
 * obstacle, it tells how much wider the place must be. Returns false if interrupted. */
static bool ask_for_driving(Route *route, const RouteQuery *query, const Legs *legs, const Rectangle *body,
                            double margin, const FitPlace *tightest) {
    Blockage fit = route->blockage;
    bool whole = explain_not_drivable(route, query, legs, body, margin, tightest);
    double more = route->blockage.needs - route->blockage.has;
    bool same = strcmp(route->blockage.what, fit.what) == 0 && vec2_distance(route->blockage.at, fit.at) < SAME_PLACE;
    if (same && fit.has > 0 && more > fit.needs - fit.has)
        fit.needs = fit.has + more;
    route->blockage = fit;
    return whole;
}

/* Estimates where a chair sticks, and how much width it needs there. Returns false if interrupted. */
static bool estimate(Route *route, const RouteQuery *query, const Legs *legs, const Rectangle *body,
                     const FitPlace *tightest) {
    if (route->fits)
        return explain_not_drivable(route, query, legs, body, tightest->margin, tightest);
    FitPlace place = *tightest;
    if (!(place.margin > -HUGE_VAL)) {
        if (!blockage_of_disc(&route->blockage, query, body->half_width, legs->goals, legs->count))
            return false;
        if (route->blockage.needs > route->blockage.has)
            return true; /* it is too narrow for the body's width, whatever its length */
        route->blockage.needs = route->blockage.has = 0;
        if (fit_margin(query, body, legs->goals, legs->count, -DEEPEST, 0, &place) != FIT_KNOWN)
            return false;
        if (!(place.margin > -HUGE_VAL))
            return true;
    }
    blockage_of_fit(&route->blockage, query, body, &place);
    return query->brief || ask_for_driving(route, query, legs, body, place.margin, &place);
}

/* Fills in the skids with which a chair that fits gets out. Returns false if interrupted. */
static bool try_skids(Route *route, const RouteQuery *query, const Legs *legs, const Rectangle *body) {
    if (!route->fits || !(query->profile->skid_time > 0))
        return true;
    SearchTrack track = {0};
    SearchAnswer answer = decide_with_skids(query, body, legs->goals, legs->count, &track);
    if (answer == SEARCH_FOUND)
        route->blockage.skid = track.skid;
    search_track_clear(&track);
    return answer != SEARCH_INTERRUPTED;
}

/* Explains a chair without a path, with what is tried where that is possible. Returns false if interrupted. */
static bool explain_drive(Route *route, const RouteQuery *query, const Legs *legs, const Rectangle *body,
                          const FitPlace *tightest) {
    return estimate(route, query, legs, body, tightest) &&
           (query->brief || (widen_to_drive(&route->blockage, query, body, legs->goals, legs->count) &&
                             try_skids(route, query, legs, body)));
}

/* Fills in the clearances of the poses. */
static void measure(SearchTrack *track, const RouteQuery *query, const Rectangle *body) {
    for (size_t i = 0; i < track->count; i++) {
        Pose *pose = &track->poses[i];
        pose->clearance = search_clearance(query->space, body, pose->at, pose->heading, ROUTE_CLEARANCE_REACH, NULL);
    }
}

static void search_drive(Route *route, const RouteQuery *query, const Legs *legs, const Rectangle *body) {
    size_t *pins = memory_zeroed(legs->count, sizeof *pins);
    SearchTrack track = {0};
    FitPlace tightest;
    bool whole = true;
    double depth = query->whether ? 0 : SHALLOW;
    switch (settle_way(query, body, legs->goals, legs->count, depth, &track, pins, &tightest)) {
    case DECIDE_FOUND:
        go_beyond_exit(&track, query, body);
        measure(&track, query, body);
        give_poses(route, &track);
        break;
    case DECIDE_SEARCHED:
        answer_drive(route, query, body, &track, pins, legs->count);
        break;
    case DECIDE_NONE:
        route->fits = true;
        whole = query->whether || query->rolls || explain_drive(route, query, legs, body, &tightest);
        break;
    case DECIDE_TOO_NARROW:
        whole = query->whether || query->rolls || explain_drive(route, query, legs, body, &tightest);
        break;
    case DECIDE_INTERRUPTED:
        whole = false;
        break;
    }
    if (!whole)
        interrupt(route);
    memory_free(pins);
}

/* Explains a disc without a path, with what is tried where that is possible. Returns false if interrupted. */
static bool explain_round(Route *route, const RouteQuery *query, const Legs *legs, const Rectangle *disc) {
    Blockage *blockage = &route->blockage;
    if (!blockage_of_disc(blockage, query, disc->half_width, legs->goals, legs->count) ||
        (!query->brief && !widen_to_go(blockage, query, disc->half_width, legs->goals, legs->count)))
        return false;
    if (!(blockage->needs > blockage->has)) /* it is wide enough by less than the search resolves */
        blockage->needs = blockage->has = 0;
    return true;
}

static void search_round(Route *route, const RouteQuery *query, const Legs *legs, const Rectangle *disc) {
    SearchTrack track = {0};
    if (disc_route_find(&track, query, legs->goals, legs->count, disc->half_width)) {
        if (track.count > 1)
            track.poses[0].heading = track.poses[1].heading;
        give_poses(route, &track);
        return;
    }
    search_track_clear(&track);
    if (stop_requested(query->stop) || (!query->whether && !explain_round(route, query, legs, disc)))
        interrupt(route);
}

/* Lets a route begin with the straight way from `at` to its first pose. */
static void begin_at(Route *route, Vec2 at, int direction) {
    size_t capacity = route->count;
    route->poses = memory_reserve(route->poses, &capacity, route->count + 1, sizeof *route->poses);
    memmove(route->poses + 1, route->poses, route->count * sizeof *route->poses);
    route->count++;
    route->poses[0].at = at;
    route->poses[1].direction = direction;
    route->length += vec2_distance(at, route->poses[1].at);
    if (route->count > 2 && route->poses[2].direction != direction)
        route->reversals++;
}

static void drive(Route *route, const RouteQuery *query) {
    Rectangle body = search_body(query->profile);
    Legs legs = legs_make(query);
    RouteQuery from = *query;
    if (exit_usable(query, &legs.goals[legs.count - 1], route)) {
        bool presses =
            query->pressed > 0 && search_clearance(query->space, &body, query->at, query->heading, 0, NULL) < 0;
        int clears = presses ? start_go_clear(query, &body, &from.at) : 0;
        if (clears || start_ease_off(query, &body, &from.at))
            search_drive(route, &from, &legs, &body);
        else
            blockage_of_start(&route->blockage, query, &body);
        if (clears && route->count)
            begin_at(route, query->at, clears);
    }
    memory_free(legs.goals);
}

static void go_round(Route *route, const RouteQuery *query) {
    double radius = query->profile->width / 2;
    Rectangle disc = {radius, radius, 0};
    Legs legs = legs_make(query);
    RouteQuery from = *query;
    if (query->pressed > 0)
        start_push_off(query->space, radius, &from.at);
    if (exit_usable(query, &legs.goals[legs.count - 1], route)) {
        if (freespace_distance(query->space, from.at) < 0 ||
            freespace_exact(query->space, from.at, radius, NULL) < radius)
            blockage_of_start(&route->blockage, query, &disc);
        else
            search_round(route, &from, &legs, &disc);
    }
    memory_free(legs.goals);
}

/* Returns the clearance at a pose on a query's path, m. */
static double clearance_at(const RouteQuery *query, bool round, const Pose *pose) {
    double radius = query->profile->width / 2;
    Rectangle body = search_body(query->profile);
    if (round)
        return freespace_exact(query->space, pose->at, radius + ROUTE_CLEARANCE_REACH, NULL) - radius;
    return search_clearance(query->space, &body, pose->at, pose->heading, ROUTE_CLEARANCE_REACH, NULL);
}

/* Carries the poses of a route from the frame to the plan, moved by what the query was rounded, so that a path begins
 * exactly where it was asked for. */
static void leave_with_poses(Route *route, const RouteFrame *frame, const RouteQuery *framed, const RouteQuery *query,
                             bool round) {
    Vec2 moved = vec2_sub(query->at, frame_place_in_plan(frame, framed->at));
    double turned = query->heading - frame_heading_in_plan(frame, framed->heading);
    for (size_t i = 0; i < route->count; i++) {
        Pose *pose = &route->poses[i];
        bool start = i == 0 && vec2_distance(pose->at, framed->at) <= 0;
        bool ahead = i == 0 && fabs(pose->heading - framed->heading) <= 0;
        pose->at = start ? query->at : vec2_add(frame_place_in_plan(frame, pose->at), moved);
        pose->heading = ahead ? query->heading : frame_heading_in_plan(frame, pose->heading) + turned;
        pose->clearance = clearance_at(query, round, pose);
    }
}

/* Plans by one of the two driving models in a frame of the plan, which the query's fields hold. A plan without a frame
 * is its own. */
static void answer_in_frame(Route *route, const RouteQuery *query, bool round) {
    int sense = frame_sense(query->plan, query->at, query->heading, query->via, query->via_count, query->exit);
    const RouteFrame *frame = fields_frame(query->fields, query->plan, sense);
    RouteQuery framed = *query;
    Vec2 *via = memory_zeroed(query->via_count, sizeof *via);
    if (frame) {
        for (size_t i = 0; i < query->via_count; i++)
            via[i] = frame_place(frame, query->via[i]);
        framed.plan = &frame->plan;
        framed.space = &frame->space;
        framed.via = via;
        framed.at = frame_place(frame, query->at);
        framed.heading = frame_heading(frame, query->heading);
    }
    if (round)
        go_round(route, &framed);
    else
        drive(route, &framed);
    memory_free(via);
    if (!frame)
        return;
    leave_with_poses(route, frame, &framed, query, round);
    Blockage *blockage = &route->blockage;
    if (*blockage->what)
        blockage->at = frame_place_in_plan(frame, blockage->at);
    if (blockage->posed) {
        blockage->middle = frame_place_in_plan(frame, blockage->middle);
        blockage->heading = frame_heading_in_plan(frame, blockage->heading);
    }
}

/* Finds where the path is narrowest; that of a round body at its poses. */
static void note_narrowest(Route *route, const RouteQuery *query, bool round) {
    Rectangle body = search_body(query->profile);
    route->narrowest = ROUTE_CLEARANCE_REACH;
    route->narrowest_at = route->poses[0].at;
    if (!round)
        route->narrowest = narrowest_on(query->space, &body, route->poses, route->count, &route->narrowest_at);
    for (size_t i = 0; round && i < route->count; i++)
        if (route->poses[i].clearance < route->narrowest) {
            route->narrowest = route->poses[i].clearance;
            route->narrowest_at = route->poses[i].at;
        }
}

/* Plans with fields of its own unless there are shared ones. */
static Route answer_with(const RouteQuery *query, bool round) {
    Route route = {.answer = ROUTE_CANNOT_PASS, .exit = query->exit};
    RouteQuery with = *query;
    if (!query->fields)
        with.fields = fields_create();
    answer_in_frame(&route, &with, round);
    if (route.count > 0)
        note_narrowest(&route, query, round);
    if (!query->fields)
        fields_destroy(with.fields);
    return route;
}

Route route_drive(const RouteQuery *query) {
    return answer_with(query, false);
}

Route route_round(const RouteQuery *query) {
    return answer_with(query, true);
}

const char *route_lack_unit(Lack lacks) {
    static const char *const units[] = {"m", "N", "N m"};
    return units[lacks];
}

void route_widths(const Blockage *blockage, char *text, size_t size) {
    const char *unit = route_lack_unit(blockage->lacks);
    if (blockage->lacks != LACK_WIDTH) {
        snprintf(text, size, "needs %.2g %s, has %.2g %s", blockage->needs, unit, blockage->has, unit);
        return;
    }
    const double centimetres = 100, slack = 1e-6; /* 1/m; cm, so that whole centimetres are preserved */
    double needs = ceil(blockage->needs * centimetres - slack) / centimetres;
    double has = floor(blockage->has * centimetres + slack) / centimetres;
    if (blockage->has > 0 && blockage->needs > blockage->has)
        snprintf(text, size, "needs %s %.2f m, has %.2f m%s%s", blockage->estimated ? "about" : "at least", needs, has,
                 *blockage->beside ? " beside " : "", blockage->beside);
    else
        snprintf(text, size, "%s", "");
}

void route_skids(const Blockage *blockage, char *text, size_t size) {
    const double centimetres = 100; /* 1/m */
    double skid = ceil(blockage->skid * centimetres - 1e-6) / centimetres;
    snprintf(text, size, blockage->skid > 0 ? "could pass with skids of %.2f m in all" : "", skid);
}

void route_free(Route *route) {
    memory_free(route->poses);
    *route = (Route){0};
}
