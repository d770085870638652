#include "rules/turnround.h"

#include <math.h>

#include "rules/surroundings.h"

static const double ALONG = 0.7;    /* 1, least cosine of the angle between way and wall, before and after a turn */
static const double BESIDE = 1.5;   /* m, of the way beside the obstacle's end that are measured: assumed */
static const double SAME = 0.3;     /* m: ends of obstacles that are nearer than this are one */
static const double OPENING = 0.05; /* m, beside the opening of a door */

enum { EACH = 5 /* steps of a way between two places that are measured */ };

/* A way back: where the line across the obstacle meets it again. */
typedef struct Back {
    size_t step;     /* of the way */
    Vec2 at;         /* m */
    double distance; /* m, along the line */
} Back;

/* Finds where the ray from `from` first meets the way between two of its steps; its distance, or `reach` if nowhere. */
static Back meet_way(const RuleWay *way, size_t first, size_t last, Vec2 from, Vec2 along, double reach) {
    Back back = {.distance = reach};
    for (size_t j = first; j + 1 < last; j++) {
        Vec2 step = vec2_sub(way->at[j + 1], way->at[j]), to = vec2_sub(way->at[j], from);
        double across = vec2_cross(along, step);
        if (across == 0)
            continue;
        double s = vec2_cross(to, step) / across, t = vec2_cross(to, along) / across;
        if (t >= 0 && t <= 1 && s > 0 && s < back.distance)
            back = (Back){.step = j, .at = vec2_along(from, s, along), .distance = s};
    }
    return back;
}

static bool leads_through_door(const Plan *plan, const RuleWay *way, size_t first, size_t last) {
    for (size_t i = first; i <= last; i += EACH)
        if (ways_in_opening(plan, way->at[i], OPENING))
            return true;
    return false;
}

static Vec2 direction_at(const RuleWay *way, size_t i) {
    return vec2_unit(vec2_sub(way->at[i + 1], way->at[i]));
}

/* Measures from wall to wall through a place, along a line in both directions. */
static TurnWidth measure_width(Surroundings *near, Vec2 at, Vec2 along) {
    surroundings_look(near, at, TURNROUND_WIDEST);
    double ahead = surroundings_ray(near, at, along, TURNROUND_WIDEST, SEE_WALLS);
    double behind = surroundings_ray(near, at, vec2_scale(along, -1), TURNROUND_WIDEST, SEE_WALLS);
    return (TurnWidth){fmin(ahead + behind, TURNROUND_WIDEST), vec2_along(at, -behind, along),
                       vec2_along(at, ahead, along)};
}

static void note_turn(TurnRounds *turns, const TurnRound *turn) {
    size_t t = 0;
    while (t < turns->count && vec2_distance(turns->list[t].end, turn->end) > SAME)
        t++;
    if (t == turns->count) {
        turns->list = memory_reserve(turns->list, &turns->capacity, turns->count + 1, sizeof *turns->list);
        turns->list[turns->count++] = *turn;
        return;
    }
    for (int k = 0; k < TURN_PARTS; k++)
        if (turn->parts[k].width < turns->list[t].parts[k].width)
            turns->list[t].parts[k] = turn->parts[k];
}

/* Notes the turn, if there is one, in which the way comes back on the other side of the wall in the direction `across`,
 * a unit vector. */
static void look_across(TurnRounds *turns, const House *house, Surroundings *near, const RuleWay *way, size_t i,
                        Vec2 across, double narrower) {
    Vec2 at = way->at[i], forth = direction_at(way, i);
    surroundings_look(near, at, TURNROUND_WIDEST);
    double here = surroundings_ray(near, at, across, TURNROUND_WIDEST, SEE_WALLS);
    if (here >= TURNROUND_WIDEST)
        return;
    Vec2 face = vec2_along(at, here, across);
    Back back = meet_way(way, i + 1, way->count, face, across, narrower + TURNROUND_WIDEST);
    if (back.distance >= narrower + TURNROUND_WIDEST)
        return;
    Vec2 along = vec2_left(across);
    along = vec2_dot(along, forth) < 0 ? vec2_scale(along, -1) : along;
    if (vec2_dot(direction_at(way, back.step), along) > -ALONG)
        return;
    TurnRound turn = {.parts[TURN_BEFORE] = measure_width(near, at, across),
                      .parts[TURN_AFTER] = measure_width(near, back.at, across)};
    turn.narrow = vec2_dot(vec2_sub(turn.parts[TURN_AFTER].from, face), across);
    Vec2 middle = vec2_along(face, turn.narrow / 2, across);
    Back round = meet_way(way, i + 1, back.step, middle, along, BESIDE + TURNROUND_WIDEST);
    if (turn.narrow <= 0 || turn.narrow >= narrower || round.distance >= BESIDE + TURNROUND_WIDEST ||
        leads_through_door(&house->plan, way, i, back.step))
        return;
    turn.parts[TURN_AT] = measure_width(near, round.at, along);
    turn.end = turn.parts[TURN_AT].from;
    double beside = vec2_dot(vec2_sub(turn.end, middle), along);
    if (beside >= 0 && beside <= BESIDE)
        note_turn(turns, &turn);
}

TurnRounds turnround_find(const House *house, const Outline *walls, const RuleWays *ways, double narrower) {
    TurnRounds turns = {0};
    Surroundings near = {.outline = walls};
    for (size_t w = 0; w < ways->count; w++) {
        const RuleWay *way = &ways->ways[w];
        for (size_t i = 0; i + EACH < way->count; i += EACH) {
            Vec2 wall = way->at[i];
            surroundings_look(&near, wall, TURNROUND_WIDEST);
            if (!surroundings_nearest(&near, way->at[i], TURNROUND_WIDEST, SEE_WALLS, &wall))
                continue;
            Vec2 across = vec2_unit(vec2_sub(way->at[i], wall));
            if (fabs(vec2_dot(across, direction_at(way, i))) > ALONG)
                continue;
            look_across(&turns, house, &near, way, i, across, narrower);
            look_across(&turns, house, &near, way, i, vec2_scale(across, -1), narrower);
        }
    }
    surroundings_clear(&near);
    return turns;
}
