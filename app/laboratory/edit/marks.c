/* What is to be seen of what is in the hand: lines, lengths, handles, what is snapped to, what does not fit. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "laboratory/house/session_parts.h"
#include "plan/plan_geometry.h"

static const double FARTHEST_GAP = 5.0; /* m: what is farther from a piece is not told */
static const double LEAST_TOLD = 0.005; /* m: shorter lengths are not */

static EditMark *add_mark(HouseSession *live, EditMarkKind kind, const char *words) {
    Editor *edit = &live->edit;
    edit->marks = memory_reserve(edit->marks, &edit->mark_capacity, edit->mark_count + 1, sizeof *edit->marks);
    EditMark *mark = &edit->marks[edit->mark_count++];
    *mark = (EditMark){.kind = kind, .words = words ? arena_text(&edit->words, words) : NULL};
    return mark;
}

static void add_points(HouseSession *live, EditMarkKind kind, const Vec2 *points, size_t count, const char *words) {
    EditMark *mark = add_mark(live, kind, words);
    mark->count = count < LABORATORY_MARK_POINTS ? count : LABORATORY_MARK_POINTS;
    memcpy(mark->points, points, mark->count * sizeof *points);
}

void edit_marks_line(HouseSession *live, Vec2 from, Vec2 to) {
    add_points(live, MARK_LINE, (Vec2[]){from, to}, 2, NULL);
}

void edit_marks_outline(HouseSession *live, const Vec2 *points, size_t count) {
    add_points(live, MARK_OUTLINE, points, count, NULL);
}

void edit_marks_length(HouseSession *live, Vec2 from, Vec2 to) {
    char words[32];
    double length = vec2_distance(from, to);
    if (length < LEAST_TOLD)
        return;
    snprintf(words, sizeof words, "%.2f m", length);
    add_points(live, MARK_DIMENSION, (Vec2[]){from, to}, 2, words);
}

/* Doors ----------------------------------------------------------------------------------------------------------- */

void edit_marks_door(HouseSession *live, const Plan *plan, const Door *door) {
    const Vec2 *ends = plan->walls[door->wall_index].points.at + door->segment;
    Vec2 from, to;
    plan_geometry_door_ends(plan, door, &from, &to);
    edit_marks_line(live, from, to);
    edit_marks_length(live, ends[0], from);
    edit_marks_length(live, from, to);
    edit_marks_length(live, to, ends[1]);
}

/* Furniture -------------------------------------------------------------------------------------------------------- */

void edit_marks_piece(HouseSession *live, const Furniture *piece) {
    Vec2 corners[4];
    plan_geometry_corners(piece, corners);
    edit_marks_outline(live, corners, 4);
    for (int i = 0; i < 4; i++) {
        Vec2 a = corners[i], b = corners[(i + 1) % 4], out = vec2_scale(vec2_left(vec2_unit(vec2_sub(b, a))), -1);
        Vec2 middle = vec2_scale(vec2_add(a, b), 0.5);
        double gap = snap_piece_gap(draft_plan(live->draft), middle, out, &piece->id, 1);
        if (gap <= FARTHEST_GAP)
            edit_marks_length(live, middle, vec2_along(middle, gap, out));
    }
}

/* What is held ----------------------------------------------------------------------------------------------------- */

static void show_wall(HouseSession *live, const Wall *wall) {
    const Editor *edit = &live->edit;
    const Vec2 *at = wall->points.at;
    size_t s = edit->grip.index, last = wall->points.count - 1;
    bool closed = vec2_distance(at[0], at[last]) < 1e-9;
    if (edit->grip.grip == GRIP_SEGMENT)
        s++; /* of the pieces beside it, and itself */
    size_t first = s >= 2 && edit->grip.grip == GRIP_SEGMENT ? s - 2 : s > 0 ? s - 1 : 0;
    for (size_t i = first; i <= s && i < last; i++)
        edit_marks_length(live, at[i], at[i + 1]);
    if (closed && edit->grip.grip == GRIP_POINT && s == 0)
        edit_marks_length(live, at[last - 1], at[last]);
}

static void show_person(HouseSession *live, const Person *person) {
    edit_marks_line(live, person->at, vec2_along(person->at, 0.5, snap_heading(person->heading)));
}

void edit_marks_held(HouseSession *live) {
    const Editor *edit = &live->edit;
    const Plan *plan = draft_plan(live->draft);
    size_t i;
    DraftList list = draft_find(live->draft, edit->held, &i);
    if (list == DRAFT_WALLS && i < plan->wall_count)
        show_wall(live, &plan->walls[i]);
    else if (list == DRAFT_DOORS && i < plan->door_count)
        edit_marks_door(live, plan, &plan->doors[i]);
    else if (list == DRAFT_FURNITURE && i < plan->furniture_count)
        edit_marks_piece(live, &plan->furniture[i]);
    else if (list == DRAFT_PEOPLE && i < plan->person_count)
        show_person(live, &plan->people[i]);
    else if (list == DRAFT_EXITS && i < plan->exit_count)
        edit_marks_length(live, plan->exits[i].from, plan->exits[i].to);
}

/* The rest -------------------------------------------------------------------------------------------------------- */

static void add_snap(HouseSession *live, const Snap *snap) {
    for (size_t i = 0; i < snap->guide_count; i++)
        add_points(live, MARK_GUIDE, snap->guides[i], 2, NULL);
    if (*snap->words)
        add_points(live, MARK_SNAP, &snap->at, 1, snap->words);
}

static void add_handles(HouseSession *live) {
    const Editor *edit = &live->edit;
    EditHandle handles[EDIT_HANDLES];
    size_t count = edit_handle_list(live, draft_plan(live->draft), handles);
    for (size_t i = 0; i < count; i++) {
        EditMark *mark = add_mark(live, MARK_HANDLE, NULL);
        mark->points[0] = handles[i].at;
        mark->count = 1;
        mark->round = handles[i].grip == GRIP_TURN;
        mark->held = edit->gesture ? handles[i].grip == edit->grip.grip && handles[i].index == edit->grip.index
                                   : (int)i == edit->handle;
    }
}

/* Where the next thing would begin. */
static void add_hover(HouseSession *live) {
    const Editor *edit = &live->edit;
    bool faces = edit->tool == TOOL_AREA || edit->tool == TOOL_MEASURE || edit->tool == TOOL_FURNITURE;
    if (edit->tool == TOOL_SELECT || !edit->seen)
        return;
    SnapAsk ask = {.at = edit->hand.at,
                   .reach = edit->hand.reach,
                   .free = edit->hand.free,
                   .faces = faces,
                   .doors = edit->tool == TOOL_EXIT,
                   .along = NAN};
    Snap snap = snap_point(draft_plan(live->draft), &ask);
    add_snap(live, &snap);
}

/* "0.78 m: 0.08 m to spare" */
static void add_measures(HouseSession *live) {
    const Editor *edit = &live->edit;
    double width = edit_measure_chair(live);
    for (size_t i = 0; i < edit->measure_count; i++) {
        char words[96];
        Vec2 ends[2] = {edit->measures[i].from, edit->measures[i].to};
        edit_measure_say(vec2_distance(ends[0], ends[1]), width, words, sizeof words);
        add_points(live, MARK_DIMENSION, ends, 2, words);
    }
}

static void say(HouseSession *live) {
    Editor *edit = &live->edit;
    memory_free(edit->doing.text);
    edit->doing = (Text){0};
    const char *trouble = edit->tool == TOOL_IMAGE ? edit_image_trouble(live) : NULL;
    if (edit->gesture)
        edit->gesture->say(live, &edit->doing);
    else if (trouble)
        text_add(&edit->doing, trouble);
    else if (edit->tool == TOOL_IMAGE && !draft_plan(live->draft)->background.image)
        text_add(&edit->doing, "name the picture's file first, in the panel");
    else if (edit->tool == TOOL_ROUTE && !edit_way_person(live))
        text_add(&edit->doing, "place somebody first, whose route it is");
    else if (edit->tool == TOOL_DOOR && !draft_plan(live->draft)->wall_count)
        text_add(&edit->doing, "draw a wall first, for the door to be in");
    else
        text_add(&edit->doing, house_editor.tools[edit->tool].strip);
}

const GestureView *edit_marks_make(HouseSession *live) {
    Editor *edit = &live->edit;
    edit->mark_count = 0;
    arena_clear(&edit->words);
    add_measures(live);
    if (edit->gesture)
        edit->gesture->show(live);
    if (!edit->gesture || edit->held)
        add_handles(live);
    if (edit->gesture)
        add_snap(live, &edit->snap);
    else
        add_hover(live);
    say(live);
    edit->shown = (GestureView){.active = edit->gesture,
                                .doing = edit->doing.text ? edit->doing.text : "",
                                .refusal = edit->gesture ? edit->refusal : NULL,
                                .marks = edit->marks,
                                .mark_count = edit->mark_count,
                                .fields = edit->fields,
                                .field_count = edit->gesture ? edit->field_count : 0,
                                .field = edit->field,
                                .typed = edit->typed,
                                .wrong = *edit->wrong ? edit->wrong : NULL};
    return &edit->shown;
}
