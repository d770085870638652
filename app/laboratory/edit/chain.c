#include "laboratory/edit/chain.h"

#include <math.h>
#include <stdio.h>

#include "laboratory/edit/enclosure.h"
#include "laboratory/edit/field.h"
#include "laboratory/edit/gesture.h"
#include "laboratory/edit/marks.h"
#include "laboratory/edit/measure.h"
#include "laboratory/edit/select.h"

static const double SAME = 1e-6; /* m: points closer than this coincide */

/* The properties of a tool's chain. */
typedef struct ChainKind {
    const char *begin;  /* format of the text before the first point: x and y, m */
    const char *line;   /* format of the text about the next segment: length, m, and angle, degree */
    const char *name;   /* name of the undo step */
    size_t least, most; /* number of points; most 0: unlimited */
    bool closes;        /* clicking the first point again closes the chain */
    bool thick;         /* each segment has a thickness */
    bool places;        /* each point is typed as x and y */
    bool faces;         /* the points snap to wall faces */
    const EditGesture *gesture;
} ChainKind;

static const EditGesture wall, room, route, measure;

static const ChainKind kinds[EDIT_TOOLS] = {
    [TOOL_WALL] = {.begin = "Wall from x %.2f m, y %.2f m. Arrows move it, Enter begins there.",
                   .line = "Wall: %.2f m, %.4g degrees.",
                   .name = "Draw walls",
                   .least = 2,
                   .closes = true,
                   .thick = true,
                   .gesture = &wall},
    [TOOL_AREA] = {.begin = "Room from x %.2f m, y %.2f m. Arrows move it, Enter begins there.",
                   .line = "Room: %.2f m, %.4g degrees.",
                   .name = "Draw room",
                   .least = 3,
                   .closes = true,
                   .faces = true,
                   .gesture = &room},
    [TOOL_ROUTE] = {.begin = "Route from x %.2f m, y %.2f m. Arrows move it, Enter begins there.",
                    .name = "Draw route",
                    .least = 1,
                    .places = true,
                    .gesture = &route},
    [TOOL_MEASURE] = {.begin = "Distance from x %.2f m, y %.2f m. Arrows move it, Enter begins there.",
                      .line = "Distance: %.2f m, %.4g degrees.",
                      .name = "",
                      .least = 2,
                      .most = 2,
                      .faces = true,
                      .gesture = &measure},
};

static const ChainKind *kind_of(const Editor *edit) {
    return &kinds[edit->tool];
}

enum { FIELD_LENGTH, FIELD_ANGLE, FIELD_THICKNESS };
enum { FIELD_X, FIELD_Y };

static const char *const place_names[] = {"x", "y"}, *const place_units[] = {"m", "m"};
static const char *const line_names[] = {"length", "angle", "thickness"}, *const line_units[] = {"m", "degree", "m"};

static bool is_placed(const Editor *edit) {
    return !edit->chain.count || kind_of(edit)->places;
}

static Vec2 last_point(const Editor *edit) {
    return edit->chain.points[edit->chain.count - 1];
}

/* Returns the direction of the last segment, degree; NAN: there is none. */
static double last_angle(const Editor *edit) {
    const EditChain *chain = &edit->chain;
    if (chain->count < 2)
        return NAN;
    return snap_angle(vec2_sub(chain->points[chain->count - 1], chain->points[chain->count - 2]));
}

static void list_fields(Editor *edit) {
    if (is_placed(edit))
        edit_field_list(edit, place_names, place_units, 2);
    else
        edit_field_list(edit, line_names, line_units, kind_of(edit)->thick ? 3 : 2);
}

void edit_chain_begin(Editor *edit, bool keys) {
    const ChainKind *kind = kind_of(edit);
    edit_gesture_begin(edit, kind->gesture, kind->name, keys);
    edit->now.amount = edit->wall_thickness;
    list_fields(edit);
    edit_gesture_update(edit);
}

void edit_chain_clear(Editor *edit) {
    EditChain *chain = &edit->chain;
    memory_free(chain->points);
    memory_free(chain->amount);
    *chain = (EditChain){0};
}

/* The elements that result ----------------------------------------------------------------------------------------- */

static json_t *point(Vec2 at) {
    return json_pack("[o, o]", json_number(at.x), json_number(at.y));
}

static json_t *list_of(const Vec2 *points, size_t count) {
    json_t *list = json_array();
    for (size_t i = 0; i < count; i++)
        json_array_append_new(list, point(points[i]));
    return list;
}

/* Lists the points of the chain, with the floating one. */
static json_t *list_points(const Editor *edit) {
    const EditChain *chain = &edit->chain;
    json_t *list = list_of(chain->points, chain->count);
    if (chain->floating)
        json_array_append_new(list, point(edit->now.at));
    return list;
}

static void add(Editor *edit, DraftList list, json_t *element) {
    snprintf(edit->added_id, EDIT_NAME, "%s", draft_add(edit->draft, list, element));
}

static void add_wall(Editor *edit, const Vec2 *points, size_t count, double thickness) {
    if (count < 2)
        return;
    json_t *element = json_pack("{s:o, s:o}", "points", list_of(points, count), "thickness", json_number(thickness));
    add(edit, DRAFT_WALLS, element);
}

/* Makes one wall for each run of segments of equal thickness. */
static void make_wall(Editor *edit) {
    const EditChain *chain = &edit->chain;
    size_t count = chain->count + chain->floating, first = 0;
    Vec2 *points = memory_zeroed(count, sizeof *points);
    for (size_t i = 0; i < count; i++)
        points[i] = i < chain->count ? chain->points[i] : edit->now.at;
    for (size_t i = 1; i < count; i++) { /* each segment has the thickness of its second point */
        double thickness = i < chain->count ? chain->amount[i] : edit->now.amount;
        double next = i + 1 < chain->count ? chain->amount[i + 1] : i + 1 < count ? edit->now.amount : -1;
        if (thickness == next)
            continue;
        add_wall(edit, points + first, i + 1 - first, thickness);
        first = i;
    }
    memory_free(points);
}

static void make_room(Editor *edit) {
    json_t *outline = list_points(edit);
    if (json_array_size(outline) < 3)
        json_decref(outline);
    else
        add(edit, DRAFT_ROOMS, json_pack("{s:o}", "outline", outline));
}

bool edit_chain_room_here(Editor *edit) {
    Vec2 points[LABORATORY_MARK_POINTS];
    Fault fault = {0};
    edit_gesture_cancel(edit);
    size_t count = enclosure_find(draft_plan(edit->draft), edit->pointer.at, points, LABORATORY_MARK_POINTS);
    for (size_t i = 0; i < count; i++)
        points[i] = vec2(snap_tidy(points[i].x), snap_tidy(points[i].y));
    if (count < 3)
        return false;
    edit_gesture_begin_step(edit, kinds[TOOL_AREA].name);
    add(edit, DRAFT_ROOMS, json_pack("{s:o}", "outline", list_of(points, count)));
    bool made = edit_gesture_end_step(edit, &fault);
    if (made)
        edit_select_only(edit, edit->added_id);
    fault_clear(&fault);
    return made;
}

/* Routes ---------------------------------------------------------------------------------------------------------- */

const char *edit_chain_route_person(const Editor *edit) {
    const Plan *plan = edit->gesture ? &edit->plan_before : draft_plan(edit->draft);
    for (size_t i = edit->id_count; i > 0; i--) {
        size_t person = plan_find_person(plan, edit->ids[i - 1]);
        if (person != SIZE_MAX)
            return plan->people[person].id;
    }
    return plan->person_count ? plan->people[0].id : NULL;
}

/* Returns the exit at the pointer; NULL: none. */
static const char *exit_at(const Editor *edit) {
    for (size_t e = 0; e < edit->plan_before.exit_count; e++) {
        const Exit *exit = &edit->plan_before.exits[e];
        if (vec2_distance(edit->now.at, vec2_nearest_on_segment(edit->now.at, exit->from, exit->to)) <=
            edit->pointer.reach)
            return exit->id;
    }
    return NULL;
}

static void find_exit(Editor *edit) {
    const char *exit = exit_at(edit);
    snprintf(edit->chain.exit, EDIT_NAME, "%s", exit ? exit : "");
}

static void make_route(Editor *edit) {
    EditChain *chain = &edit->chain;
    const char *person = edit_chain_route_person(edit);
    if (!person)
        return;
    json_t *via = list_of(chain->points, chain->count);
    if (chain->floating && !*chain->exit)
        json_array_append_new(via, point(edit->now.at));
    const PlanRoute *route = plan_route_of(&edit->plan_before, person);
    const char *id = route ? route->id : draft_add(edit->draft, DRAFT_ROUTES, json_pack("{s:[s]}", "people", person));
    draft_set(edit->draft, id, "via", via);
    if (*chain->exit)
        draft_set_text(edit->draft, id, "exit", chain->exit);
}

/* Following ------------------------------------------------------------------------------------------------------- */

static void update_place(Editor *edit) {
    Vec2 from = edit->chain.count ? last_point(edit) : edit->pointer.at;
    Vec2 at = edit_gesture_snap(
        edit, (SnapAsk){.along = NAN, .faces = kind_of(edit)->faces, .from = edit->chain.count ? &from : NULL});
    edit_field_typed(edit, FIELD_X, &at.x);
    edit_field_typed(edit, FIELD_Y, &at.y);
    edit_field_show(edit, FIELD_X, at.x);
    edit_field_show(edit, FIELD_Y, at.y);
    edit->now.at = at;
}

/* Returns the next point of the pointer. */
static Vec2 pointer_point(Editor *edit) {
    Vec2 from = last_point(edit);
    return edit_gesture_snap(edit, (SnapAsk){.from = &from,
                                             .along = last_angle(edit),
                                             .own = edit->chain.points,
                                             .own_count = edit->chain.count,
                                             .closes = kind_of(edit)->closes,
                                             .faces = kind_of(edit)->faces});
}

static void update_line(Editor *edit) {
    Vec2 from = last_point(edit), at = pointer_point(edit);
    double length = vec2_distance(from, at), angle = snap_angle(vec2_sub(at, from));
    if (length < SAME || edit->keys)
        angle = isfinite(last_angle(edit)) ? last_angle(edit) : 0;
    if (edit->chain.proposed) {
        length = edit->fields[FIELD_LENGTH].value;
        angle = edit->fields[FIELD_ANGLE].value;
    } else if (edit->keys && !edit_field_any(edit)) {
        length = 0;
    }
    bool typed = edit_field_typed(edit, FIELD_LENGTH, &length);
    typed |= edit_field_typed(edit, FIELD_ANGLE, &angle);
    edit_field_typed(edit, FIELD_THICKNESS, &edit->now.amount);
    if (typed || edit->chain.proposed || edit->keys) {
        at = vec2_along(from, length, snap_heading(angle));
        at = vec2(snap_tidy(at.x), snap_tidy(at.y));
        if (kind_of(edit)->closes && vec2_distance(at, edit->chain.points[0]) < SAME)
            at = edit->chain.points[0]; /* equal to the last bit */
        edit->snap = (Snap){.at = at};
    }
    edit->now.at = at;
    edit_field_show(edit, FIELD_LENGTH, length);
    edit_field_show(edit, FIELD_ANGLE, angle);
    edit_field_show(edit, FIELD_THICKNESS, edit->now.amount);
}

static void update(Editor *edit) {
    if (edit->chain.proposed && !edit->keys &&
        vec2_distance(edit->pointer.at, edit->chain.proposed_at) > edit->pointer.reach)
        edit->chain.proposed = false;
    if (is_placed(edit))
        update_place(edit);
    else
        update_line(edit);
    if (edit->tool == TOOL_ROUTE)
        find_exit(edit);
    edit->chain.floating = !edit->chain.count || vec2_distance(edit->now.at, last_point(edit)) >= SAME;
}

/* Placing points -------------------------------------------------------------------------------------------------- */

/* Completes the chain with the points placed so far. */
static bool finish(Editor *edit) {
    const ChainKind *kind = kind_of(edit);
    if (edit->chain.count < kind->least && !*edit->chain.exit) {
        edit_gesture_cancel(edit);
        return true;
    }
    edit->chain.floating = false;
    if (!edit->gesture->make) {
        edit_measure_store(edit, edit->chain.points[0], edit->chain.points[1]);
        edit_gesture_cancel(edit);
        return true;
    }
    *edit->added_id = 0;
    if (!edit_gesture_end(edit))
        return false;
    if (edit->tool != TOOL_ROUTE && *edit->added_id)
        edit_select_only(edit, edit->added_id);
    return true;
}

static void add_point(Editor *edit) {
    EditChain *chain = &edit->chain;
    chain->points = memory_reserve(chain->points, &chain->capacity, chain->count + 1, sizeof *chain->points);
    chain->amount = memory_reserve(chain->amount, &chain->amount_capacity, chain->count + 1, sizeof *chain->amount);
    chain->points[chain->count] = edit->now.at;
    chain->amount[chain->count++] = edit->now.amount;
}

/* Proposes the next point: the same length again, a quarter turn to the right. */
static void propose(Editor *edit, bool keys) {
    double length = vec2_distance(edit->chain.points[edit->chain.count - 2], last_point(edit));
    double angle = remainder(last_angle(edit) - 90, 360);
    list_fields(edit);
    edit->chain.proposed = keys;
    edit->chain.proposed_at = edit->pointer.at;
    edit->fields[FIELD_LENGTH].value = snap_tidy(length);
    edit->fields[FIELD_ANGLE].value = angle <= -180 ? 180 : snap_tidy(angle);
}

static bool confirm(Editor *edit, bool keys) {
    const ChainKind *kind = kind_of(edit);
    bool empty = keys && !edit_field_any(edit) && !edit->chain.proposed && edit->chain.count;
    if (empty)
        *edit->chain.exit = 0;
    if (empty || !edit->chain.floating || (*edit->chain.exit && !edit->refusal))
        return finish(edit);
    if (edit->refusal)
        return false;
    add_point(edit);
    if (kind->thick)
        edit->wall_thickness = edit->now.amount;
    size_t count = edit->chain.count;
    bool closed = kind->closes && count > 2 && vec2_distance(edit->now.at, edit->chain.points[0]) < SAME;
    if (closed && edit->tool == TOOL_AREA)
        edit->chain.count--;
    if (closed || count == kind->most)
        return finish(edit);
    if (count > 1 && !kind->places)
        propose(edit, keys);
    else
        list_fields(edit);
    edit_gesture_update(edit);
    return true;
}

/* Moves the end of the segment that is drawn by keys; a first point, or a place, is moved by its own numbers. */
static bool nudge(Editor *edit, Vec2 by) {
    if (is_placed(edit))
        return false;
    Vec2 way = vec2_sub(vec2_add(edit->now.at, by), last_point(edit));
    EditField *length = &edit->fields[FIELD_LENGTH], *angle = &edit->fields[FIELD_ANGLE];
    length->value = vec2_length(way) < SAME ? 0 : vec2_length(way);
    if (length->value > 0)
        angle->value = snap_angle(way);
    length->typed = angle->typed = length->moved = angle->moved = true;
    edit_gesture_update(edit);
    return true;
}

static bool back(Editor *edit) {
    EditChain *chain = &edit->chain;
    if (chain->count <= 1) {
        edit_gesture_cancel(edit);
        return true;
    }
    chain->count--;
    chain->proposed = false;
    list_fields(edit);
    edit_gesture_update(edit);
    return true;
}

static bool escape(Editor *edit) {
    *edit->chain.exit = 0;
    return finish(edit) || (edit_gesture_cancel(edit), true);
}

static void release(Editor *edit, bool moved) {
    if (moved)
        confirm(edit, false);
}

/* Texts and marks ------------------------------------------------------------------------------------------------- */

/* Returns the text that says what to do next. */
static const char *hint(const Editor *edit) {
    const ChainKind *kind = kind_of(edit);
    if (edit->chain.proposed)
        return "Press Enter to draw it, type a number to change it, or press Escape to end.";
    if (edit->keys && edit->chain.count < kind->least)
        return "Arrows move the end, or type the length; Enter draws it; Tab for the angle.";
    if (kind->most)
        return "Click the other end, or type the length.";
    if (edit->chain.count < kind->least)
        return "Click, or type the length and press Enter; Tab for the angle.";
    return "Click, or type the length; Enter or Escape ends, Backspace removes the last point.";
}

static void describe(Editor *edit, Text *text) {
    const ChainKind *kind = kind_of(edit);
    if (!edit->chain.count) {
        text_format(text, kind->begin, edit->now.at.x, edit->now.at.y);
    } else if (kind->places) {
        text_format(text, "Points of the route: %zu. Click the next point or the exit; press Enter to end.",
                    edit->chain.count);
    } else {
        text_format(text, kind->line, vec2_distance(last_point(edit), edit->now.at), edit->fields[FIELD_ANGLE].value);
        text_format(text, " %s", hint(edit));
    }
}

static void show(Editor *edit) {
    const ChainKind *kind = kind_of(edit);
    if (edit->chain.count)
        edit_marks_start(edit, edit->chain.points[0]);
    if (edit->keys)
        edit_marks_place(edit, edit->now.at);
    for (size_t i = 0; i + 1 < edit->chain.count; i++)
        edit_marks_line(edit, edit->chain.points[i], edit->chain.points[i + 1]);
    if (edit->chain.count && edit->chain.floating) {
        edit_marks_line(edit, last_point(edit), edit->now.at);
        edit_marks_length(edit, last_point(edit), edit->now.at);
    }
    if (kind->closes && edit->chain.count > 2)
        edit_marks_length(edit, edit->chain.points[edit->chain.count - 2], last_point(edit));
}

#define CHAIN(make_)                                                                                                   \
    {                                                                                                                  \
        .update = update, .make = make_, .confirm = confirm, .nudge = nudge, .back = back, .escape = escape,           \
        .release = release, .describe = describe, .show = show, .end = edit_chain_clear,                               \
    }
static const EditGesture wall = CHAIN(make_wall), room = CHAIN(make_room), route = CHAIN(make_route),
                         measure = CHAIN(NULL);
