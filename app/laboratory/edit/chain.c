/* Draws chains of points: walls, exits, outlines of rooms, routes, measured distances. */
#include <math.h>

#include "laboratory/edit/editor_state.h"

static const double SAME = 1e-6; /* m: points closer than this coincide */

/* The properties of a tool's chain. */
typedef struct ChainKind {
    const char *what;   /* "wall" */
    const char *name;   /* name of the undo step */
    size_t least, most; /* number of points; most 0: unlimited */
    bool closes;        /* clicking the first point again closes the chain */
    bool thick;         /* each segment has a thickness */
    bool places;        /* each point is typed as x and y */
    bool faces, doors;  /* the points snap to wall faces, to doors */
    const EditGesture *gesture;
} ChainKind;

static const EditGesture wall, leave, room, route, measure;

static const ChainKind kinds[EDIT_TOOLS] = {
    [TOOL_WALL] = {.what = "wall", .name = "Draw walls", .least = 2, .closes = true, .thick = true, .gesture = &wall},
    [TOOL_EXIT] = {.what = "exit", .name = "Draw exit", .least = 2, .most = 2, .doors = true, .gesture = &leave},
    [TOOL_AREA] = {.what = "room", .name = "Draw room", .least = 3, .closes = true, .faces = true, .gesture = &room},
    [TOOL_ROUTE] = {.what = "route", .name = "Draw route", .least = 1, .places = true, .gesture = &route},
    [TOOL_MEASURE] = {.what = "distance", .name = "", .least = 2, .most = 2, .faces = true, .gesture = &measure},
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
    edit_gesture_follow(edit);
}

void edit_chain_clear(Editor *edit) {
    EditChain *chain = &edit->chain;
    memory_free(chain->points);
    memory_free(chain->amount);
    *chain = (EditChain){0};
}

/* Following ------------------------------------------------------------------------------------------------------- */

static void follow_place(Editor *edit) {
    Vec2 from = edit->chain.count ? last_point(edit) : edit->pointer.at;
    Vec2 at = edit_gesture_snap(edit, (SnapAsk){.along = NAN,
                                                .faces = kind_of(edit)->faces,
                                                .doors = kind_of(edit)->doors,
                                                .from = edit->chain.count ? &from : NULL});
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
                                             .faces = kind_of(edit)->faces,
                                             .doors = kind_of(edit)->doors});
}

static void follow_line(Editor *edit) {
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

static void follow(Editor *edit) {
    if (edit->chain.proposed && !edit->keys &&
        vec2_distance(edit->pointer.at, edit->chain.proposed_at) > edit->pointer.reach)
        edit->chain.proposed = false;
    if (is_placed(edit))
        follow_place(edit);
    else
        follow_line(edit);
    if (edit->tool == TOOL_ROUTE)
        edit_way_find_exit(edit);
    edit->chain.floating = !edit->chain.count || vec2_distance(edit->now.at, last_point(edit)) >= SAME;
}

/* Placing points -------------------------------------------------------------------------------------------------- */

/* Completes the chain with the points placed so far. */
static bool finish(Editor *edit) {
    const ChainKind *kind = kind_of(edit);
    if (edit->chain.count < kind->least && !*edit->chain.exit) {
        edit_gesture_drop(edit);
        return true;
    }
    edit->chain.floating = false;
    if (!edit->gesture->make) {
        edit_measure_keep(edit, edit->chain.points[0], edit->chain.points[1]);
        edit_gesture_drop(edit);
        return true;
    }
    *edit->made = 0;
    if (!edit_gesture_end(edit))
        return false;
    if (edit->tool != TOOL_ROUTE && *edit->made)
        edit_select_only(edit, edit->made);
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

static bool put(Editor *edit, bool keys) {
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
    edit_gesture_follow(edit);
    return true;
}

static bool back(Editor *edit) {
    EditChain *chain = &edit->chain;
    if (chain->count <= 1) {
        edit_gesture_drop(edit);
        return true;
    }
    chain->count--;
    chain->proposed = false;
    list_fields(edit);
    edit_gesture_follow(edit);
    return true;
}

static bool escape(Editor *edit) {
    *edit->chain.exit = 0;
    return finish(edit) || (edit_gesture_drop(edit), true);
}

static void release(Editor *edit, bool moved) {
    if (moved)
        put(edit, false);
}

/* Texts and marks ------------------------------------------------------------------------------------------------- */

static void say(Editor *edit, Text *words) {
    const ChainKind *kind = kind_of(edit);
    if (!edit->chain.count) {
        text_format(words, "%s begins at x %.2f, y %.2f m: Enter puts it there", kind->what, edit->now.at.x,
                    edit->now.at.y);
        return;
    }
    if (kind->places) {
        text_format(words, "%s by %zu points: click the next one, or the exit; Enter ends it", kind->what,
                    edit->chain.count);
        return;
    }
    text_format(words, "%s %.2f m, %g degrees: %s", kind->what, vec2_distance(last_point(edit), edit->now.at),
                edit->fields[FIELD_ANGLE].value,
                edit->chain.proposed ? "Enter draws it, a number changes it, Escape ends"
                : kind->most         ? "click the other end, or type the length"
                : edit->chain.count < kind->least
                    ? "click, or type the length and Enter; Tab for the angle"
                    : "click, or type the length; Enter or Escape ends, Backspace takes back");
}

static void show(Editor *edit) {
    const ChainKind *kind = kind_of(edit);
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
        .follow = follow, .make = make_, .put = put, .back = back, .escape = escape, .release = release, .say = say,   \
        .show = show, .end = edit_chain_clear,                                                                         \
    }
static const EditGesture wall = CHAIN(edit_wall_make), leave = CHAIN(edit_way_make_exit),
                         room = CHAIN(edit_way_make_room), route = CHAIN(edit_way_make_route), measure = CHAIN(NULL);
