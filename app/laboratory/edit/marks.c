#include "laboratory/edit/marks.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "laboratory/edit/gesture.h"
#include "laboratory/edit/handle.h"
#include "laboratory/edit/measure.h"
#include "laboratory/edit/select.h"
#include "plan/plan_geometry.h"

static const double FARTHEST_GAP = 5.0; /* m: larger gaps next to a piece are not shown */
static const double LEAST_TOLD = 0.005; /* m: shorter lengths are not displayed */

static EditMark *add_mark(Editor *edit, EditMarkKind kind, const char *text) {
    edit->marks = memory_reserve(edit->marks, &edit->mark_capacity, edit->mark_count + 1, sizeof *edit->marks);
    EditMark *mark = &edit->marks[edit->mark_count++];
    *mark = (EditMark){.kind = kind, .text = text ? arena_text(&edit->mark_texts, text) : NULL};
    return mark;
}

static void add_points(Editor *edit, EditMarkKind kind, const Vec2 *points, size_t count, const char *text) {
    EditMark *mark = add_mark(edit, kind, text);
    mark->count = count < LABORATORY_MARK_POINTS ? count : LABORATORY_MARK_POINTS;
    memcpy(mark->points, points, mark->count * sizeof *points);
}

void edit_marks_line(Editor *edit, Vec2 from, Vec2 to) {
    add_points(edit, MARK_LINE, (Vec2[]){from, to}, 2, NULL);
}

void edit_marks_outline(Editor *edit, const Vec2 *points, size_t count) {
    add_points(edit, MARK_OUTLINE, points, count, NULL);
}

void edit_marks_length(Editor *edit, Vec2 from, Vec2 to) {
    char text[32];
    double length = vec2_distance(from, to);
    if (length < LEAST_TOLD)
        return;
    snprintf(text, sizeof text, "%.2f m", length);
    add_points(edit, MARK_DIMENSION, (Vec2[]){from, to}, 2, text);
}

void edit_marks_exit(Editor *edit, Vec2 from, Vec2 to) {
    add_points(edit, MARK_EXIT, (Vec2[]){from, to}, 2, NULL);
}

void edit_marks_ring(Editor *edit, const Vec2 *points, size_t count, const char *text) {
    add_points(edit, MARK_RING, points, count, text);
}

void edit_marks_start(Editor *edit, Vec2 at) {
    add_points(edit, MARK_START, &at, 1, NULL);
}

void edit_marks_place(Editor *edit, Vec2 at) {
    add_points(edit, MARK_PLACE, &at, 1, NULL);
}

static void copy_marks(Editor *edit, const EditMark *marks, size_t count) {
    for (size_t i = 0; i < count; i++)
        *add_mark(edit, marks[i].kind, NULL) = marks[i];
}

/* Doors ----------------------------------------------------------------------------------------------------------- */

/* Adds the leaf of a hinged door, open, and the quarter circle of its edge. */
static void add_leaf(Editor *edit, const Plan *plan, const Door *door, Vec2 from, Vec2 to) {
    enum { ARC = 12 };
    bool at_start = door->hinge == HINGE_START;
    Vec2 left = vec2_left(vec2_unit(vec2_sub(to, from))), hinge = at_start ? from : to, latch = at_start ? to : from;
    Vec2 out = door->swing == SWING_LEFT ? left : vec2_scale(left, -1), along = vec2_unit(vec2_sub(latch, hinge));
    Vec2 root = vec2_along(hinge, plan->walls[door->wall_index].thickness / 2, out), leaf[ARC + 2] = {root};
    for (int i = 0; i <= ARC; i++) {
        Vec2 way = vec2_heading(M_PI / 2 * i / ARC);
        leaf[ARC + 1 - i] = vec2_along(vec2_along(root, door->width * way.x, along), door->width * way.y, out);
    }
    add_points(edit, MARK_SWING, leaf, ARC + 2, NULL);
}

void edit_marks_door(Editor *edit, const Plan *plan, const Door *door) {
    const Vec2 *ends = plan->walls[door->wall_index].points.at + door->segment;
    Vec2 from, to;
    plan_geometry_door_ends(plan, door, &from, &to);
    edit_marks_line(edit, from, to);
    if (door->kind == DOOR_HINGED)
        add_leaf(edit, plan, door, from, to);
    edit_marks_length(edit, ends[0], from);
    edit_marks_length(edit, from, to);
    edit_marks_length(edit, to, ends[1]);
}

/* Furniture -------------------------------------------------------------------------------------------------------- */

void edit_marks_piece(Editor *edit, const Furniture *piece) {
    Vec2 corners[4];
    plan_geometry_corners(piece, corners);
    edit_marks_outline(edit, corners, 4);
    for (int i = 0; i < 4; i++) {
        Vec2 a = corners[i], b = corners[(i + 1) % 4], out = vec2_scale(vec2_left(vec2_unit(vec2_sub(b, a))), -1);
        Vec2 middle = vec2_scale(vec2_add(a, b), 0.5);
        double gap = snap_piece_gap(draft_plan(edit->draft), middle, out, &piece->id, 1);
        if (gap <= FARTHEST_GAP)
            edit_marks_length(edit, middle, vec2_along(middle, gap, out));
    }
}

/* The dragged item
 * ----------------------------------------------------------------------------------------------------- */

static void show_wall(Editor *edit, const Wall *wall) {
    const Vec2 *at = wall->points.at;
    size_t s = edit->grip.index, last = wall->points.count - 1;
    bool closed = vec2_distance(at[0], at[last]) < 1e-9;
    if (edit->grip.grip == GRIP_SEGMENT)
        s++; /* labels the segment and its neighbours */
    size_t first = s >= 2 && edit->grip.grip == GRIP_SEGMENT ? s - 2 : s > 0 ? s - 1 : 0;
    for (size_t i = first; i <= s && i < last; i++)
        edit_marks_length(edit, at[i], at[i + 1]);
    if (closed && edit->grip.grip == GRIP_POINT && s == 0)
        edit_marks_length(edit, at[last - 1], at[last]);
}

static void show_person(Editor *edit, const Person *person) {
    edit_marks_line(edit, person->at, vec2_along(person->at, 0.5, snap_heading(person->heading)));
}

void edit_marks_dragged(Editor *edit) {
    const Plan *plan = draft_plan(edit->draft);
    size_t i;
    DraftList list = draft_find(edit->draft, edit->dragged_id, &i);
    if (list == DRAFT_WALLS && i < plan->wall_count)
        show_wall(edit, &plan->walls[i]);
    else if (list == DRAFT_DOORS && i < plan->door_count)
        edit_marks_door(edit, plan, &plan->doors[i]);
    else if (list == DRAFT_FURNITURE && i < plan->furniture_count)
        edit_marks_piece(edit, &plan->furniture[i]);
    else if (list == DRAFT_PEOPLE && i < plan->person_count)
        show_person(edit, &plan->people[i]);
    else if (list == DRAFT_EXITS && i < plan->exit_count)
        edit_marks_length(edit, plan->exits[i].from, plan->exits[i].to);
}

/* Snaps, measured distances, gesture ------------------------------------------------------------------------------ */

static void add_snap(Editor *edit, const Snap *snap) {
    for (size_t i = 0; i < snap->guide_count; i++)
        add_points(edit, MARK_GUIDE, snap->guides[i], 2, NULL);
    if (*snap->text)
        add_points(edit, MARK_SNAP, &snap->at, 1, snap->text);
}

void edit_marks_snap(Editor *edit) {
    add_snap(edit, &edit->snap);
}

static void add_handles(Editor *edit) {
    EditHandle handles[EDIT_HANDLES];
    size_t count = edit_handle_list(edit, draft_plan(edit->draft), handles);
    for (size_t i = 0; i < count; i++) {
        EditMark *mark = add_mark(edit, MARK_HANDLE, NULL);
        mark->points[0] = handles[i].at;
        mark->count = 1;
        mark->round = handles[i].grip == GRIP_TURN;
        mark->active = edit->gesture ? handles[i].grip == edit->grip.grip && handles[i].index == edit->grip.index
                                     : (int)i == edit->handle;
    }
}

/* Marks where the next item would begin. */
static void add_hover(Editor *edit) {
    bool faces = edit->tool == TOOL_AREA || edit->tool == TOOL_MEASURE || edit->tool == TOOL_FURNITURE;
    if (edit->tool == TOOL_SELECT || !edit->seen)
        return;
    SnapAsk ask = {.at = edit->pointer.at,
                   .reach = edit->pointer.reach,
                   .free = edit->pointer.free,
                   .faces = faces,
                   .along = NAN,
                   .names = edit_select_snap_name};
    Snap snap = snap_point(draft_plan(edit->draft), &ask);
    add_snap(edit, &snap);
}

/* Adds the measured distances: "0.78 m: 0.08 m to spare". */
static void add_measures(Editor *edit) {
    double width = edit_measure_chair(edit);
    for (size_t i = 0; i < edit->measure_count; i++) {
        char text[96];
        Vec2 ends[2] = {edit->measures[i].from, edit->measures[i].to};
        edit_measure_format(vec2_distance(ends[0], ends[1]), width, text, sizeof text);
        add_points(edit, MARK_DIMENSION, ends, 2, text);
    }
}

static void describe(Editor *edit, const char *idle) {
    memory_free(edit->doing.text);
    edit->doing = (Text){0};
    if (edit->gesture)
        edit->gesture->describe(edit, &edit->doing);
    else
        text_add(&edit->doing, idle);
}

const GestureView *edit_marks_make(Editor *edit, const EditPreview *preview, void (*rest)(Editor *edit),
                                   const char *idle) {
    edit->mark_count = 0;
    arena_clear(&edit->mark_texts);
    add_measures(edit);
    if (edit->gesture)
        edit->gesture->show(edit);
    if (!edit->gesture || edit->dragged_id)
        add_handles(edit);
    if (edit->gesture)
        add_snap(edit, &edit->snap);
    if (preview)
        copy_marks(edit, preview->marks, preview->mark_count);
    if (!edit->gesture && (!preview || (preview->begins && !preview->refused)))
        add_hover(edit);
    if (!edit->gesture)
        rest(edit);
    describe(edit, idle);
    edit->shown = (GestureView){.active = edit->gesture,
                                .doing = edit->doing.text ? edit->doing.text : "",
                                .refusal = edit->gesture ? edit->refusal : NULL,
                                .preview = preview && preview->words.used ? preview->words.text : NULL,
                                .preview_refused = preview && preview->refused,
                                .preview_warns = preview && preview->warns,
                                .marks = edit->marks,
                                .mark_count = edit->mark_count,
                                .fields = edit->fields,
                                .field_count = edit->gesture ? edit->field_count : 0,
                                .field = edit->field,
                                .typed = edit->typed,
                                .typed_error = *edit->typed_error ? edit->typed_error : NULL};
    return &edit->shown;
}
