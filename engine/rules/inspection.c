#include "rules/inspection.h"

#include <ctype.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include "base/text.h"
#include "plan/plan_geometry.h"
#include "rules/places.h"
#include "rules/turnround.h"

static const double NEAR = 1.0;        /* m: a chair that is stopped this near to a corridor is stopped in it */
static const double STRAIGHT = 0.98;   /* 1: a stretch of a way is drawn as a line if it is so much of its length */
static const double LATCH_DEPTH = 0.3; /* m, before the wall, that is free beside a latch: assumed */

typedef struct Inspecting {
    Inspection *inspection;
    const House *house;
    Outline walls; /* of the walls alone */
    RuleWays ways;
    Doorway *doorways;      /* (door_count) */
    TurningPlace *turnings; /* (2 x room_count) circle and square; size NAN: not measured yet */
    Places places;          /* for squares of places_side m, those of the rule before */
    double places_side;     /* m; 0: none were looked for */
    const Stop *stop;
} Inspecting;

/* Places ------------------------------------------------------------------------------------------------------------
 */

/* Returns " (bath)", or "". */
static const char *room_words(const Plan *plan, size_t room, Arena *arena) {
    if (room == SIZE_MAX)
        return "";
    const char *name = *plan->rooms[room].name ? plan->rooms[room].name : plan->rooms[room].id;
    return text_in_arena(arena, " (%s)", name);
}

static void name_places(Inspecting *inspecting) {
    Inspection *inspection = inspecting->inspection;
    const Plan *plan = &inspecting->house->plan;
    const Corridors *corridors = &inspecting->inspection->corridors;
    inspecting->inspection->first_door = corridors->count;
    inspecting->inspection->first_room = corridors->count + plan->door_count;
    inspection->place_count = inspecting->inspection->first_room + plan->room_count;
    inspection->places = memory_zeroed(inspection->place_count + 1, sizeof *inspection->places);
    RulePlace *place = inspection->places;
    for (size_t p = 0; p < inspection->place_count; p++)
        place[p].grade = -1;
    for (size_t c = 0; c < corridors->count; c++, place++) {
        const Corridor *corridor = &corridors->list[c];
        place->name = text_in_arena(&inspection->arena, "corridor c%zu%s", c + 1,
                                    room_words(plan, corridor->room, &inspection->arena));
        place->at = corridor->widths[corridor->narrowest].at;
    }
    for (size_t d = 0; d < plan->door_count; d++, place++) {
        Vec2 from, to;
        plan_geometry_door_ends(plan, &plan->doors[d], &from, &to);
        place->name = text_in_arena(&inspection->arena, "door %s", plan->doors[d].id);
        place->at = vec2_scale(vec2_add(from, to), 0.5);
    }
    for (size_t r = 0; r < plan->room_count; r++, place++) {
        Box box = box_empty();
        for (size_t i = 0; i < plan->rooms[r].outline.count; i++)
            box = box_include(box, plan->rooms[r].outline.at[i]);
        bool named = *plan->rooms[r].name;
        place->name = text_in_arena(&inspection->arena, named ? "room %s (%s)" : "room %s", plan->rooms[r].id,
                                    plan->rooms[r].name);
        place->at = vec2_scale(vec2_add(box.low, box.high), 0.5);
    }
}

/* Notes which corridors, doors and rooms the way of each person passes. */
static void note_passages(Inspecting *inspecting) {
    const House *house = inspecting->house;
    size_t people = house->person_count;
    inspecting->inspection->person_count = people;
    inspecting->inspection->passed_by =
        memory_zeroed((inspecting->inspection->place_count + 1) * (people + 1), sizeof(bool));
    for (size_t w = 0; w < inspecting->ways.count; w++) {
        const RuleWay *way = &inspecting->ways.ways[w];
        if (way->person == SIZE_MAX)
            continue;
        for (size_t i = 0; i + 1 < way->count; i++) {
            size_t corridor = corridor_at(&inspecting->inspection->corridors, way->at[i]);
            size_t room = i % 10 ? SIZE_MAX : ways_room(&house->plan, way->at[i]);
            if (corridor != SIZE_MAX)
                inspecting->inspection->passed_by[corridor * people + way->person] = true;
            if (room != SIZE_MAX)
                inspecting->inspection->passed_by[(inspecting->inspection->first_room + room) * people + way->person] =
                    true;
            for (size_t d = 0; d < house->plan.door_count; d++)
                if (ways_meet(way->at[i], way->at[i + 1], inspecting->doorways[d].from, inspecting->doorways[d].to))
                    inspecting->inspection->passed_by[(inspecting->inspection->first_door + d) * people + way->person] =
                        true;
        }
    }
}

size_t inspection_place(const Inspection *inspection, const House *house, const char *what, Vec2 at) {
    for (size_t d = 0; d < house->plan.door_count; d++)
        if (strcmp(what, inspection->places[inspection->first_door + d].name) == 0)
            return inspection->first_door + d;
    double best = NEAR;
    size_t found = SIZE_MAX;
    for (size_t c = 0; c < inspection->corridors.count; c++) {
        const Corridor *corridor = &inspection->corridors.list[c];
        for (size_t i = 0; i < corridor->count; i++) {
            double distance = vec2_distance(corridor->widths[i].at, at);
            found = distance < best ? c : found;
            best = fmin(best, distance);
        }
    }
    size_t room = found == SIZE_MAX ? ways_room(&house->plan, at) : SIZE_MAX;
    return room != SIZE_MAX ? inspection->first_room + room : found;
}

/* Plans the ways of the chairs, and notes where they are stopped. */
static void note_chairs(Inspecting *inspecting, int jobs, const Stop *stop) {
    const House *house = inspecting->house;
    bool *part = memory_zeroed(house->person_count + 1, sizeof *part);
    for (size_t i = 0; i < house->person_count; i++)
        part[i] = house->people[i].profile->driving != DRIVING_WALKER &&
                  plan_find_person(&house->plan, house->people[i].id) != SIZE_MAX;
    Journeys journeys = journey_plan_all(house, part, jobs, stop);
    for (size_t i = 0; i < house->person_count; i++) {
        const Route *route = &journeys.of[i].route;
        if (!part[i])
            continue;
        inspecting->inspection->interrupted |= route->answer == ROUTE_INTERRUPTED;
        bool stuck = route->answer == ROUTE_CANNOT_PASS;
        size_t at = stuck ? inspection_place(inspecting->inspection, house, route->blockage.what, route->blockage.at)
                          : SIZE_MAX;
        for (size_t p = 0; p < inspecting->inspection->place_count; p++)
            inspecting->inspection->places[p].chairs +=
                inspecting->inspection->passed_by[p * house->person_count + i] || p == at;
        if (at == SIZE_MAX)
            continue;
        RulePlace *place = &inspecting->inspection->places[at];
        if (!place->stopped++) {
            place->who = arena_text(&inspecting->inspection->arena, house->people[i].id);
            place->blockage = route->blockage;
        }
        place->carried += route->fits;
    }
    journey_free_all(&journeys);
    memory_free(part);
}

/* Where a rule holds ------------------------------------------------------------------------------------------------
 */

static bool holds_word(const char *text, const char *word) {
    size_t length = strlen(word);
    for (; *text; text++) {
        size_t i = 0;
        while (i < length && tolower((unsigned char)text[i]) == tolower((unsigned char)word[i]))
            i++;
        if (i == length)
            return true;
    }
    return false;
}

static bool is_room(const Plan *plan, size_t room, const char *word) {
    return room != SIZE_MAX && (holds_word(plan->rooms[room].name, word) || holds_word(plan->rooms[room].id, word));
}

static bool in_rooms(const RuleWhere *where, const Plan *plan, const size_t rooms[2]) {
    bool in = !*where->room, out = false;
    for (int k = 0; k < 2; k++) {
        in |= is_room(plan, rooms[k], where->room);
        out |= *where->not_room && is_room(plan, rooms[k], where->not_room);
    }
    return in && !out;
}

static bool at_door(const RuleWhere *where, const Plan *plan, const Doorway *doorway) {
    const Door *door = &plan->doors[doorway->door];
    bool kind = where->kind == KIND_ANY || (where->kind == KIND_HINGED) == (door->kind == DOOR_HINGED);
    bool place = where->doors == DOORS_ALL || (where->doors == DOORS_ENTRANCE) == doorway->entrance;
    kind &= where->kind == KIND_ANY || door->kind != DOOR_OPENING;
    kind &= where->closer == CLOSER_ANY || (where->closer == CLOSER_WITH) == door->closer;
    bool deep = where->space_least <= 0 && where->space_below >= 100;
    for (int k = 0; k < 2; k++)
        deep |= doorway->spaces[k] >= where->space_least - INSPECTION_TOLERANCE &&
                doorway->spaces[k] < where->space_below - INSPECTION_TOLERANCE;
    return kind && place && deep && in_rooms(where, plan, doorway->rooms);
}

/* Findings ----------------------------------------------------------------------------------------------------------
 */

static void add_finding(Inspection *inspection, Finding finding) {
    inspection->findings = memory_reserve(inspection->findings, &inspection->finding_capacity,
                                          inspection->finding_count + 1, sizeof *inspection->findings);
    inspection->findings[inspection->finding_count++] = finding;
    inspection->counts[finding.verdict]++;
}

static int verdict_of(double has, double least) {
    return has >= least - INSPECTION_TOLERANCE ? RULE_PASSES : RULE_FAILS;
}

static Finding begin_finding(const RuleSet *set, const Rule *rule, size_t place) {
    return (Finding){.set = set,
                     .rule = rule,
                     .place = place,
                     .status = rule->status,
                     .requires = rule->least >= 0 ? rule->least : rule->most,
                     .has = NAN,
                     .furnished = NAN};
}

static void add_unknown(Inspection *inspection, const RuleSet *set, const Rule *rule, size_t place, const char *why) {
    Finding finding = begin_finding(set, rule, place);
    finding.verdict = RULE_OPEN;
    finding.why = why;
    add_finding(inspection, finding);
}

/* Returns how the verdict on a corridor is known: where a rail stands out, by the number for rails, too. */
static int corridor_status(const Rule *rule, const Corridor *corridor) {
    bool rails = false;
    for (size_t i = 0; i < corridor->count && rule->rails.each_side > 0; i++)
        rails |= corridor->widths[i].rails[0] > 0 || corridor->widths[i].rails[1] > 0;
    return rails && rule->rails.status > rule->status ? rule->rails.status : rule->status;
}

/* Holds a corridor that is too narrow against the stretch that a rule allows at a pillar. */
static void allow_pillar(Finding *finding, const Corridor *corridor) {
    const Rule *rule = finding->rule;
    double stretch = corridor_narrow_stretch(corridor, rule->least - INSPECTION_TOLERANCE, rule->rails.each_side);
    if (rule->pillar.least <= 0 || stretch > rule->pillar.longest + INSPECTION_TOLERANCE)
        return;
    finding->requires = rule->pillar.least;
    finding->verdict = verdict_of(finding->has, rule->pillar.least);
    finding->why = "at a pillar";
}

/* Holds the longest stretch without a place for turning against what is asked for. The texts do not say whether a way
 * that is shorter, and has no place at all, needs one. */
static void hold_stretch(Finding *finding, const PlacesStretch *stretch, double square, double each, Arena *arena) {
    const char *size = text_in_arena(arena, "%.2f m by %.2f m", square, square);
    finding->at_most = true;
    finding->requires = each;
    finding->has = stretch->longest;
    finding->from = stretch->from;
    finding->to = stretch->to;
    finding->drawn = stretch->longest > 0 && vec2_distance(stretch->from, stretch->to) > STRAIGHT * stretch->longest;
    finding->verdict = stretch->longest <= each + INSPECTION_TOLERANCE ? RULE_PASSES : RULE_FAILS;
    finding->why = text_in_arena(arena, "way without a place of %s", size);
    if (finding->verdict == RULE_FAILS || stretch->any)
        return;
    finding->verdict = RULE_OPEN;
    finding->why = text_in_arena(arena, "no place of %s, but the way is shorter than %g m", size, each);
}

/* Returns the places for turning of a side; those of one side are looked for once. */
static const Places *find_places(Inspecting *inspecting, double side) {
    if (inspecting->places_side != side) {
        places_free(&inspecting->places);
        inspecting->places = places_find(inspecting->house, &inspecting->ways, side, inspecting->stop);
        inspecting->places_side = side;
        inspecting->inspection->interrupted |= inspecting->places.interrupted;
    }
    return &inspecting->places;
}

/* Holds a corridor that is too narrow against the width that a rule allows with places for turning. */
static void allow_places(Finding *finding, Inspecting *inspecting, size_t corridor) {
    const RulePlaces *allowed = &finding->rule->places;
    if (allowed->least <= 0)
        return;
    if (verdict_of(finding->has, allowed->least) == RULE_FAILS) {
        finding->requires = allowed->least;
        finding->why = "with places for turning";
        return;
    }
    PlacesStretch stretch = places_stretch(find_places(inspecting, allowed->square - INSPECTION_TOLERANCE),
                                           &inspecting->ways, &inspecting->inspection->corridors, corridor);
    hold_stretch(finding, &stretch, allowed->square, allowed->each, &inspecting->inspection->arena);
}

static void inspect_corridor(Inspecting *inspecting, const RuleSet *set, const Rule *rule, size_t c) {
    const Corridor *corridor = &inspecting->inspection->corridors.list[c];
    double allowed = rule->rails.each_side;
    const CorridorWidth *narrowest = &corridor->widths[corridor_narrowest_between_rails(corridor, allowed)];
    Vec2 across = vec2_unit(vec2_sub(narrowest->to, narrowest->from));
    Finding finding = begin_finding(set, rule, c);
    finding.status = corridor_status(rule, corridor);
    finding.has = corridor_width_between_rails(narrowest, allowed);
    finding.furnished = corridor->furnished < finding.has - INSPECTION_TOLERANCE ? corridor->furnished : (double)NAN;
    finding.from = narrowest->from;
    finding.to = narrowest->to;
    if (allowed > 0) {
        finding.from = vec2_along(finding.from, fmax(narrowest->rails[0] - allowed, 0), across);
        finding.to = vec2_along(finding.to, -fmax(narrowest->rails[1] - allowed, 0), across);
    }
    finding.drawn = true;
    finding.verdict = verdict_of(finding.has, rule->least);
    if (finding.verdict == RULE_FAILS)
        allow_pillar(&finding, corridor);
    if (finding.verdict == RULE_FAILS)
        allow_places(&finding, inspecting, c);
    add_finding(inspecting->inspection, finding);
}

static void inspect_place(Inspecting *inspecting, const RuleSet *set, const Rule *rule, size_t c) {
    Inspection *inspection = inspecting->inspection;
    PlacesStretch stretch = places_stretch(find_places(inspecting, rule->least - INSPECTION_TOLERANCE),
                                           &inspecting->ways, &inspection->corridors, c);
    Finding finding = begin_finding(set, rule, c);
    hold_stretch(&finding, &stretch, rule->least, rule->each, &inspection->arena);
    add_finding(inspection, finding);
}

static void inspect_corridors(Inspecting *inspecting, const RuleSet *set, const Rule *rule) {
    const Corridors *corridors = &inspecting->inspection->corridors;
    if (!corridors->count)
        add_unknown(inspecting->inspection, set, rule, SIZE_MAX, "no way in this house leads through a corridor");
    for (size_t c = 0; c < corridors->count; c++) {
        if (!in_rooms(&rule->where, &inspecting->house->plan, (size_t[2]){corridors->list[c].room, SIZE_MAX}))
            continue;
        if (rule->what == RULE_TURNING_PLACE)
            inspect_place(inspecting, set, rule, c);
        else
            inspect_corridor(inspecting, set, rule, c);
    }
}

/* Holds a turn against the width at it and before and after it; what lacks most decides. */
static void inspect_turn(Inspecting *inspecting, const RuleSet *set, const Rule *rule, const TurnRound *turn) {
    static const char *const names[TURN_PARTS] = {"before the turn", "at the turn", "after the turn"};
    Finding finding =
        begin_finding(set, rule, inspection_place(inspecting->inspection, inspecting->house, "", turn->end));
    bool instead = rule->turn.instead > 0 && verdict_of(turn->parts[TURN_AT].width, rule->turn.instead) == RULE_PASSES;
    double worst = HUGE_VAL;
    for (int k = 0; k < TURN_PARTS; k++) {
        double least = k != TURN_AT ? rule->least : instead ? rule->turn.instead : rule->turn.at_turn;
        double more = turn->parts[k].width - least;
        if (more >= worst || (instead && k != TURN_AT))
            continue;
        worst = more;
        finding.requires = least;
        finding.has = turn->parts[k].width;
        finding.from = turn->parts[k].from;
        finding.to = turn->parts[k].to;
        finding.why = names[k];
    }
    finding.at_least = finding.has >= TURNROUND_WIDEST - INSPECTION_TOLERANCE;
    finding.drawn = true;
    finding.verdict = verdict_of(finding.has, finding.requires);
    add_finding(inspecting->inspection, finding);
}

static void inspect_turns(Inspecting *inspecting, const RuleSet *set, const Rule *rule) {
    TurnRounds turns = turnround_find(inspecting->house, &inspecting->walls, &inspecting->ways, rule->turn.narrower);
    for (size_t t = 0; t < turns.count; t++)
        inspect_turn(inspecting, set, rule, &turns.list[t]);
    memory_free(turns.list);
}

static void inspect_clear(Inspecting *inspecting, const RuleSet *set, const Rule *rule, const Doorway *doorway) {
    Finding finding = begin_finding(set, rule, inspecting->inspection->first_door + doorway->door);
    finding.has = doorway->clear;
    finding.from = doorway->from;
    finding.to = doorway->to;
    finding.drawn = true;
    finding.verdict = verdict_of(finding.has, rule->least);
    add_finding(inspecting->inspection, finding);
}

/* Holds a space against what is asked for: first its depth, then its width beside the opening. */
static void inspect_space(Inspecting *inspecting, const RuleSet *set, const Rule *rule, const Doorway *doorway,
                          int side) {
    bool latch = rule->what == RULE_LATCH_SPACE;
    double depth = latch ? LATCH_DEPTH : rule->least, beyond = latch ? rule->least : rule->beyond;
    DoorwaySpace space = doorway_space(inspecting->house, doorway, side, depth, beyond, rule->at_hinge);
    bool deep = verdict_of(space.depth, depth) == RULE_PASSES, before = space.beyond > INSPECTION_TOLERANCE;
    Finding finding = begin_finding(set, rule, inspecting->inspection->first_door + doorway->door);
    bool beside = latch || (!deep && before && beyond > 0);
    finding.requires = beside ? beyond : depth;
    finding.has = beside ? fmax(space.beyond, 0) : space.depth;
    finding.why = beside ? (rule->at_hinge ? "beside the hinge" : "beside the latch") : "depth";
    finding.at_least = verdict_of(finding.has, finding.requires) == RULE_PASSES;
    finding.from = space.from;
    finding.to = space.to;
    finding.drawn = true;
    finding.verdict = verdict_of(finding.has, finding.requires);
    add_finding(inspecting->inspection, finding);
}

/* Inspects the spaces before a door on each side and for each approach that a way needs. */
static void inspect_spaces(Inspecting *inspecting, const RuleSet *set, const Rule *rule, const Doorway *doorway) {
    const Door *door = &inspecting->house->plan.doors[doorway->door];
    bool done[2] = {false, false};
    if (!doorway->use_count) {
        add_unknown(inspecting->inspection, set, rule, inspecting->inspection->first_door + doorway->door,
                    "no way comes to this door from 1 m before it");
        return;
    }
    if (door->kind == DOOR_OPENING && (rule->where.side || rule->what == RULE_LATCH_SPACE))
        return; /* nobody pulls or pushes */
    for (size_t u = 0; u < doorway->use_count; u++) {
        const DoorwayUse *use = &doorway->uses[u];
        bool pulls = door->kind == DOOR_HINGED && doorway_pulls(door, use->side);
        bool side =
            rule->where.side == SIDE_BOTH || (door->kind == DOOR_HINGED && (rule->where.side == SIDE_PULL) == pulls);
        bool approach = rule->where.approach == APPROACH_ANY || rule->where.approach == use->approach;
        if (!side || !approach || done[use->side > 0])
            continue;
        done[use->side > 0] = true;
        inspect_space(inspecting, set, rule, doorway, use->side);
    }
}

static void inspect_doors(Inspecting *inspecting, const RuleSet *set, const Rule *rule) {
    const Plan *plan = &inspecting->house->plan;
    for (size_t d = 0; d < plan->door_count; d++) {
        const Doorway *doorway = &inspecting->doorways[d];
        if (!at_door(&rule->where, plan, doorway) || plan->doors[d].state == DOOR_LOCKED)
            continue;
        if (rule->what == RULE_DOOR_CLEAR)
            inspect_clear(inspecting, set, rule, doorway);
        else
            inspect_spaces(inspecting, set, rule, doorway);
    }
}

/* True of a room through which a corridor leads for more than half a metre. */
static bool is_corridor(const Inspecting *inspecting, size_t room) {
    const size_t least = (size_t)(0.5 / WAYS_STEP);
    size_t places = 0;
    for (size_t c = 0; c < inspecting->inspection->corridors.count; c++)
        for (size_t i = 0; i < inspecting->inspection->corridors.list[c].count; i++)
            places +=
                ways_room(&inspecting->house->plan, inspecting->inspection->corridors.list[c].widths[i].at) == room;
    return places > least;
}

static void inspect_rooms(Inspecting *inspecting, const RuleSet *set, const Rule *rule) {
    const Plan *plan = &inspecting->house->plan;
    bool square = rule->what == RULE_TURNING_SQUARE;
    if (!plan->room_count)
        add_unknown(inspecting->inspection, set, rule, SIZE_MAX, "the plan has no rooms");
    for (size_t r = 0; r < plan->room_count; r++) {
        bool corridor = is_corridor(inspecting, r);
        if (corridor || plan->rooms[r].outline.count < 3 || !in_rooms(&rule->where, plan, (size_t[2]){r, SIZE_MAX}))
            continue;
        TurningPlace *turning = &inspecting->turnings[2 * r + square];
        if (isnan(turning->size))
            *turning = square ? turning_square(inspecting->house, r) : turning_circle(inspecting->house, r);
        Finding finding = begin_finding(set, rule, inspecting->inspection->first_room + r);
        finding.has = turning->size;
        finding.at_least = turning->size >= 2 * FREESPACE_FARTHEST - INSPECTION_TOLERANCE;
        finding.from = vec2_along(turning->at, -turning->size / 2, turning->axis);
        finding.to = vec2_along(turning->at, turning->size / 2, turning->axis);
        finding.drawn = turning->size > 0;
        finding.verdict = verdict_of(finding.has, rule->least);
        add_finding(inspecting->inspection, finding);
    }
}

static void inspect_rule(Inspecting *inspecting, const RuleSet *set, const Rule *rule) {
    switch (rule->what) {
    case RULE_CORRIDOR_WIDTH:
    case RULE_TURNING_PLACE:
        inspect_corridors(inspecting, set, rule);
        break;
    case RULE_DOOR_CLEAR:
    case RULE_MANOEUVRE:
    case RULE_LATCH_SPACE:
        inspect_doors(inspecting, set, rule);
        break;
    case RULE_TURN_ROUND:
        inspect_turns(inspecting, set, rule);
        break;
    case RULE_TURNING_CIRCLE:
    case RULE_TURNING_SQUARE:
        inspect_rooms(inspecting, set, rule);
        break;
    default:
        add_unknown(inspecting->inspection, set, rule, SIZE_MAX, "not in the plan");
    }
}

Inspection inspection_make(const House *house, const RuleSets *sets, int jobs, const Stop *stop) {
    Inspection inspection = {.place_count = 0};
    const Plan *plan = &house->plan;
    Inspecting inspecting = {.inspection = &inspection, .house = house, .ways = ways_find(house, stop), .stop = stop};
    Plan bare = *plan;
    Fault fault = {0};
    bare.furniture_count = 0;
    inspection.interrupted = inspecting.ways.interrupted | !outline_build(&inspecting.walls, &bare, &fault);
    fault_clear(&fault);
    inspection.corridors = corridor_measure_all(house, &inspecting.walls, &inspecting.ways);
    inspecting.doorways = memory_zeroed(plan->door_count + 1, sizeof *inspecting.doorways);
    for (size_t d = 0; d < plan->door_count; d++)
        inspecting.doorways[d] = doorway_measure(house, &inspecting.ways, d);
    inspecting.turnings = memory_zeroed(2 * plan->room_count + 1, sizeof *inspecting.turnings);
    for (size_t i = 0; i < 2 * plan->room_count; i++)
        inspecting.turnings[i].size = NAN;
    name_places(&inspecting);
    note_passages(&inspecting);
    note_chairs(&inspecting, jobs, stop);
    for (size_t s = 0; s < sets->count && !inspection.interrupted; s++)
        for (size_t r = 0; r < sets->sets[s].count; r++)
            inspect_rule(&inspecting, &sets->sets[s], &sets->sets[s].rules[r]);
    memory_free(inspecting.doorways);
    memory_free(inspecting.turnings);
    places_free(&inspecting.places);
    outline_free(&inspecting.walls);
    ways_free(&inspecting.ways);
    return inspection;
}

void inspection_free(Inspection *inspection) {
    memory_free(inspection->places);
    memory_free(inspection->findings);
    memory_free(inspection->passed_by);
    corridor_free_all(&inspection->corridors);
    arena_clear(&inspection->arena);
    *inspection = (Inspection){.place_count = 0};
}

bool inspection_is_stopped(const RulePlace *place) {
    return place->stopped > 0 ||
           (place->refused > 0 && (double)place->refused >= INSPECTION_REFUSED * (double)place->drivers);
}

FindingGroup inspection_group(const Inspection *inspection, const Finding *finding) {
    bool stopped = finding->place != SIZE_MAX && inspection_is_stopped(&inspection->places[finding->place]);
    if (finding->verdict == RULE_OPEN)
        return GROUP_OPEN;
    if (finding->verdict == RULE_PASSES)
        return stopped ? GROUP_LEGAL_IMPASSABLE : GROUP_GOOD;
    return stopped ? GROUP_ILLEGAL_IMPASSABLE : GROUP_ILLEGAL;
}

static bool fails_there(const Inspection *inspection, const RuleSet *set, size_t place) {
    for (size_t i = 0; i < inspection->finding_count; i++) {
        const Finding *finding = &inspection->findings[i];
        if (finding->set == set && finding->place == place && finding->verdict == RULE_FAILS)
            return true;
    }
    return false;
}

/* True if the place stops more: chairs of the plan before drivers, then those whose source is known better, then more
 * drivers. */
static bool is_worse(const Inspection *inspection, const Finding *finding, const Finding *before) {
    const RulePlace *place = &inspection->places[finding->place], *other = &inspection->places[before->place];
    if ((place->stopped > 0) != (other->stopped > 0))
        return place->stopped > 0;
    if (finding->status != before->status)
        return finding->status < before->status;
    return (double)place->refused * (double)other->drivers > (double)other->refused * (double)place->drivers;
}

const Finding *inspection_legal_impassable(const Inspection *inspection) {
    const Finding *best = NULL;
    for (size_t i = 0; i < inspection->finding_count; i++) {
        const Finding *finding = &inspection->findings[i];
        if (inspection_group(inspection, finding) == GROUP_LEGAL_IMPASSABLE &&
            !fails_there(inspection, finding->set, finding->place) && (!best || is_worse(inspection, finding, best)))
            best = finding;
    }
    return best;
}
