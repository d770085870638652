#include "visual/house/house_scene.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "result/census.h"
#include "result/source_line.h"
#include "visual/house/crowd_scene.h"
#include "visual/house/people_scene.h"
#include "visual/house/plan_scene.h"
#include "result/grade.h"
#include "result/headline.h"
#include "result/house.h"
#include "result/jam.h"
#include "result/names.h"
#include "result/tight.h"

#define MOST 0.95       /* share of a crowd that is most of it */
#define LOST_LEAST 0.05 /* s: less lost time is not told */

static bool is_crowd(const Census *census) {
    return census->people > PEOPLE_SCENE_INDIVIDUALS;
}

/* Returns what the first tight place costs: the same place and number as its row and its disc. */
static const char *most_lost(Scene *scene, const House *house, const Observation *observation) {
    Tight tight[TIGHT_MOST];
    if (!tight_places(house, observation, tight))
        return "no tight place";
    const char *name = jam_name(house, &observation->hazards[tight->hazard], &scene->arena);
    if (tight->peak_force > 0)
        return scene_text(scene, "touches %s%s, %.0f N", name[0] && name[1] ? "the " : "", name, /* "B": a person */
                          tight->peak_force);
    if (tight->lost_time >= LOST_LEAST)
        return scene_text(scene, "most time lost: %s, %s", name, headline_duration(tight->lost_time, &scene->arena));
    const char *gap = tight_to_spare(tight->clearance, &scene->arena);
    return gap ? scene_text(scene, "tightest: %s, %s to spare", name, gap) : "no tight place";
}

static int compare_times(const void *a, const void *b) {
    double left = *(const double *)a, right = *(const double *)b;
    return (left > right) - (left < right);
}

/* Returns when most of a crowd that leaves is out: its last one may be one walking frame. "" if somebody stays, or if
 * most are all. */
static const char *most_out(Scene *scene, const Observation *observation, const Census *census) {
    size_t count = 0;
    if (!census->people || census->stuck != SIZE_MAX || census->interrupted)
        return "";
    double *times = memory_zeroed(observation->person_count, sizeof *times);
    for (size_t i = 0; i < observation->person_count; i++)
        if (observation->people[i].completed)
            times[count++] = observation->people[i].time;
    qsort(times, count, sizeof *times, compare_times);
    size_t most = (size_t)ceil(MOST * (double)count);
    const char *text = most < count ? scene_text(scene, "%.0f %% out in %s \u00b7 ", 100 * MOST,
                                                 headline_duration(times[most - 1], &scene->arena))
                                    : "";
    memory_free(times);
    return text;
}

/* Returns who of a crowd is the last one out: "the last is with a walking frame". */
static const char *last_out(Scene *scene, const House *house, const Observation *observation) {
    size_t last = census_last(observation);
    return last == SIZE_MAX ? "" : scene_text(scene, "last out: %s", names_profile(house->people[last].profile->name));
}

/* A crowd that leaves is told by when most are out and who is the last; contacts and means stand in the report. */
static void format_crowd(Scene *scene, const House *house, const Observation *observation, const Census *census) {
    bool alone = house->plan.run.routes == ROUTES_ALONE && house->plan.route_count > 1;
    if (!census->people || census->stuck != SIZE_MAX || census->interrupted || alone)
        return;
    scene->title =
        scene_text(scene, "All %zu out in %s", census->people, headline_duration(observation->time, &scene->arena));
    scene->detail =
        scene_text(scene, "%s%s", most_out(scene, observation, census), last_out(scene, house, observation));
}

static void format_answer(Scene *scene, const House *house, const Observation *observation, const Census *census) {
    scene->name = arena_text(&scene->arena, *house->plan.name ? house->plan.name : "house");
    scene->note = source_line_is_assumed(&house->plan) ? arena_text(&scene->arena, house->plan.note) : "";
    scene->clock = observation->time > 0 ? scene_text(scene, "0 to %.1f s", observation->time) : "";
    Headline headline = headline_make(house, observation, census, &scene->arena);
    bool few = census->people && census->stuck == SIZE_MAX && census->people <= PEOPLE_SCENE_INDIVIDUALS;
    bool alone = few && census->people > 1 && house->plan.run.routes == ROUTES_ALONE && house->plan.route_count > 1;
    scene->title =
        alone ? scene_text(scene, "All %zu get out", census->people) : names_text(house, headline.title, &scene->arena);
    scene->detail =
        !few    ? scene_text(scene, "%s%s", most_out(scene, observation, census),
                             names_text(house, headline.detail, &scene->arena))
        : alone ? scene_text(scene, "each alone, slowest %s \u00b7 %s",
                             headline_duration(observation->time, &scene->arena), most_lost(scene, house, observation))
                : scene_text(scene, "%s%s", most_lost(scene, house, observation),
                             names_text(house, headline_backwards(house, observation, &scene->arena), &scene->arena));
    scene->title_role = headline.role;
    if (is_crowd(census))
        format_crowd(scene, house, observation, census);
}

/* Returns a row's value with its unit, as the terminal and the report have it. */
static const char *value_of(Scene *scene, const ResultTable *table, size_t record, const char *key) {
    const char *value = result_value_and_unit(result_find(table, record, key), &scene->arena);
    return value ? arena_text(&scene->arena, value) : "-";
}

/* In a crowd distances mean nothing, and the places are ranked by the time that is lost there. */
static void list_hazards(Scene *scene, const House *house, const Observation *observation, bool crowd) {
    Tight tight[TIGHT_MOST];
    size_t count = tight_places(house, observation, tight);
    if (count)
        scene_add_row(scene, ROW_HEADING, crowd ? "Jams: time lost by all" : "Tight places");
    for (size_t i = 0; i < count; i++) {
        const Hazard *hazard = &observation->hazards[tight[i].hazard];
        bool pushed = !crowd && tight[i].peak_force > 0;
        const char *mark = scene_text(scene, "%zu", i + 1);
        const char *cost = pushed ? scene_text(scene, "%.0f N", tight[i].peak_force)
                                  : headline_duration(tight[i].lost_time, &scene->arena);
        const char *gap = tight_to_spare(tight[i].clearance, &scene->arena);
        SceneRow *row = scene_add_row(scene, ROW_DISC, jam_name(house, hazard, &scene->arena));
        row->role = people_scene_danger(hazard);
        row->mark = mark;
        row->cells[1] = crowd || !gap ? cost : gap;
        row->cells[2] = crowd || !gap ? NULL : cost;
    }
}

/* Returns where a person starts, and, if somebody starts in the same room who leaves by another exit, where to. */
static const char *name_start(Scene *scene, const House *house, const Observation *observation, size_t i) {
    const Plan *plan = &house->plan;
    const char *room = names_room(plan, house->people[i].at);
    size_t exit = observation->people[i].exit;
    if (!room || exit >= plan->exit_count)
        return room;
    for (size_t k = 0; k < house->person_count; k++) {
        size_t other = observation->people[k].exit;
        const char *beside = names_room(plan, house->people[k].at);
        if (observation->people[k].took_part && other < plan->exit_count && other != exit && beside &&
            strcmp(beside, room) == 0)
            return scene_text(scene, "%s, to %s", room, plan->exits[exit].id);
    }
    return room;
}

static void list_person(Scene *scene, const House *house, const Observation *observation, size_t i) {
    const Inhabitant *person = &house->people[i];
    const PersonObservation *observed = &observation->people[i];
    const char *room = name_start(scene, house, observation, i);
    const char *profile = names_profile(person->profile->name);
    const char *who = !room ? profile : house->profile_count > 1 ? scene_text(scene, "%s, %s", room, profile) : room;
    ResultTable table = {0};
    result_house_add_person(&table, house, observation, i);
    const char *result = observed->completed ? headline_duration(observed->time, &scene->arena)
                                             : value_of(scene, &table, 0, "completed");
    result_clear(&table);
    LocusLook look = people_scene_look(house, i);
    SceneRow *row = scene_add_row(scene, ROW_LINE, who);
    row->role = look.role;
    row->style = look.style;
    row->width = look.width;
    row->mark = names_person(house, i, &scene->arena);
    row->cells[1] = result;
}

static void list_people(Scene *scene, const House *house, const Observation *observation) {
    scene_add_row(scene, ROW_HEADING, "People");
    for (size_t i = 0; i < house->person_count; i++)
        if (observation->people[i].took_part)
            list_person(scene, house, observation, i);
}

static void add_key(Scene *scene, const char *meaning, LocusLook look) {
    SceneRow *row = scene_add_row(scene, ROW_LINE, meaning);
    row->role = look.role;
    row->style = look.style;
    row->width = look.width;
}

static void list_key(Scene *scene, const House *house, const Observation *observation) {
    if (house->person_count > PEOPLE_SCENE_SEVERAL || observation->time <= 0)
        return;
    scene_add_row(scene, ROW_HEADING, "Key");
    add_key(scene, "personal space", PEOPLE_SCENE_SPACE);
    add_key(scene, "personal space, compressed", PEOPLE_SCENE_PRESSED);
}

/* Returns the box of the plan and of all bodies during the run, also outside the door. */
static Box whole_box(const House *house, const Observation *observation) {
    Box box = house->outline.box;
    for (size_t i = 0; i < observation->trace.rows; i++) {
        const double *row = trace_row(&observation->trace, i);
        const Profile *profile = house->people[(size_t)row[TRACE_PERSON]].profile;
        Vec2 at = vec2(row[TRACE_X], row[TRACE_Y]);
        box = box_include(box, at);
        box = box_include(box, vec2_along(at, profile->length - profile->axle, vec2_heading(row[TRACE_HEADING])));
    }
    return box_expand(box, HOUSE_SCENE_MARGIN);
}

bool house_scene_begin(Scene *scene, const House *house, const Observation *observation, const Census *census) {
    *scene = (Scene){.grid = HOUSE_SCENE_GRID, .top = PLAN_SCENE_CUT};
    scene->box = whole_box(house, observation);
    return house_scene_add_answer(scene, house, observation, census);
}

bool house_scene_add_answer(Scene *scene, const House *house, const Observation *observation, const Census *census) {
    bool crowd = is_crowd(census);
    format_answer(scene, house, observation, census);
    list_hazards(scene, house, observation, crowd);
    if (crowd)
        crowd_scene_list(scene, house, census);
    else
        list_people(scene, house, observation);
    list_key(scene, house, observation);
    return crowd;
}

static void add_ghost_label(Scene *scene, const Observation *now, const Observation *before) {
    Trail *trails = trail_list(now);
    people_scene_ghost_label(scene, before, trails, now->person_count, "before");
    trail_free_list(trails);
}

/* Adds the plan and the results on it without texts around it, and the comparison or NULL; with or without the names
 * of rooms, doors and furniture. */
static void add_house(Scene *scene, const House *house, const Observation *observation, const Census *census,
                      const Observation *before, bool names) {
    bool crowd = is_crowd(census);
    plan_scene_solids(scene, house);
    if (before)
        people_scene_ghost(scene, before);
    if (crowd)
        crowd_scene_ways(scene, house, observation, census);
    else
        people_scene_ways(scene, house, observation);
    plan_scene_tags(scene, house, crowd ? census->left : NULL);
    if (crowd)
        crowd_scene_labels(scene, house, observation, census);
    else
        people_scene_labels(scene, house, observation);
    if (before)
        add_ghost_label(scene, observation, before);
    if (names)
        plan_scene_names(scene, house);
}

void house_scene_add_before(Scene *scene, Before before) {
    if (!before.observation)
        return;
    const char *sentence = headline_sentence(before.house, before.observation, &scene->arena);
    const char *headline = names_text(before.house, sentence, &scene->arena), *words = "";
    if (before.letters)
        result_grade_add(&headline, &words, before.house, before.letters, &scene->arena);
    scene->detail = scene_text(scene, *scene->detail ? "%s: %s; now: %s" : "%s: %s", house_scene_before_name(before),
                               headline, scene->detail);
}

void house_scene_make_compared(Scene *scene, const House *house, const Observation *observation, Before before) {
    Census census = census_make(house, observation);
    house_scene_begin(scene, house, observation, &census);
    house_scene_add_before(scene, before);
    add_house(scene, house, observation, &census, before.observation, true);
    census_clear(&census);
}

void house_scene_make_small(Scene *scene, const House *house, const Observation *observation, Before before) {
    Census census = census_make(house, observation);
    house_scene_begin(scene, house, observation, &census);
    add_house(scene, house, observation, &census, before.observation, false);
    census_clear(&census);
}

void house_scene_make(Scene *scene, const House *house, const Observation *observation) {
    house_scene_make_compared(scene, house, observation, (Before){.house = NULL});
}

static bool boxes_overlap(Box a, Box b) {
    return a.high.x >= b.low.x && a.low.x <= b.high.x && a.high.y >= b.low.y && a.low.y <= b.high.y;
}

static Box box_of(const Vec2 *points, size_t count) {
    Box box = box_empty();
    for (size_t i = 0; i < count; i++)
        box = box_include(box, points[i]);
    return box;
}

static bool is_elsewhere(const Primitive *primitive, Box box) {
    if (primitive->kind == PRIMITIVE_LABEL)
        return !box_holds(box, primitive->points[0]);
    return !boxes_overlap(box_expand(box_of(primitive->points, primitive->count), primitive->radius), box);
}

/* Keeps only the visible rings of a primitive that unites thousands of bodies or places along a route. */
static void drop_rings(Scene *scene, Primitive *polygon, Box box) {
    Vec2 *points = arena_allocate(&scene->arena, polygon->count * sizeof *points);
    size_t *starts = arena_allocate(&scene->arena, (polygon->ring_count + 1) * sizeof *starts), kept = 0;
    for (size_t r = 0; r < polygon->ring_count; r++) {
        const Vec2 *ring = polygon->points + polygon->starts[r];
        size_t count = polygon->starts[r + 1] - polygon->starts[r];
        if (!boxes_overlap(box_of(ring, count), box))
            continue;
        memcpy(points + starts[kept], ring, count * sizeof *points);
        starts[kept + 1] = starts[kept] + count;
        kept++;
    }
    polygon->points = points;
    polygon->count = starts[kept];
    polygon->starts = starts;
    polygon->ring_count = kept;
}

void house_scene_make_detail(Scene *scene, const House *house, const Observation *observation, Box box) {
    Census census = census_make(house, observation);
    *scene = (Scene){.grid = HOUSE_SCENE_GRID, .box = box, .bare = true};
    add_house(scene, house, observation, &census, NULL, true);
    census_clear(&census);
    size_t kept = 0;
    for (size_t i = 0; i < scene->count; i++) {
        Primitive *primitive = &scene->primitives[i];
        if (is_elsewhere(primitive, box))
            continue;
        if (primitive->kind == PRIMITIVE_POLYGON && primitive->united)
            drop_rings(scene, primitive, box);
        scene->primitives[kept++] = *primitive;
    }
    scene->count = kept;
}
