#include "laboratory/edit/handle.h"

#include "laboratory/edit/select.h"
#include "plan/plan_geometry.h"

static const double ARM = 0.45; /* m, distance of the rotation handle from the piece or the person */

typedef struct Handles {
    EditHandle *list;
    size_t count;
    const char *id;
    DraftList of;
} Handles;

static void add(Handles *handles, EditGrip grip, size_t index, Vec2 at) {
    if (handles->count < EDIT_HANDLES)
        handles->list[handles->count++] = (EditHandle){grip, handles->id, handles->of, index, at};
}

static Vec2 middle(Vec2 a, Vec2 b) {
    return vec2_scale(vec2_add(a, b), 0.5);
}

static void add_points(Handles *handles, const Points *points, size_t count) {
    for (size_t i = 0; i < count; i++)
        add(handles, GRIP_POINT, i, points->at[i]);
}

/* Adds the handles of a wall. The first point of a closed wall is also its last point. */
static void add_wall(Handles *handles, const Wall *wall) {
    const Points *points = &wall->points;
    bool closed = points->count > 3 && vec2_distance(points->at[0], points->at[points->count - 1]) < 1e-9;
    add_points(handles, points, points->count - closed);
    for (size_t s = 0; s + 1 < points->count; s++)
        add(handles, GRIP_SEGMENT, s, middle(points->at[s], points->at[s + 1]));
}

static void add_door(Handles *handles, const Plan *plan, const Door *door) {
    Vec2 from, to;
    plan_geometry_door_ends(plan, door, &from, &to);
    add(handles, GRIP_MIDDLE, 0, middle(from, to));
    add(handles, GRIP_EDGE, 0, from);
    add(handles, GRIP_EDGE, 1, to);
}

static void add_piece(Handles *handles, const Furniture *piece) {
    Furniture standing = *piece;
    standing.toppled = false;
    Vec2 corners[4];
    plan_geometry_corners(&standing, corners);
    add(handles, GRIP_MIDDLE, 0, piece->centre);
    for (size_t i = 0; i < 4; i++)
        add(handles, GRIP_CORNER, i, corners[i]);
    Vec2 front = snap_heading(piece->angle - 90);
    add(handles, GRIP_TURN, 0, vec2_along(piece->centre, piece->size.y / 2 + ARM, front));
}

static void add_person(Handles *handles, const Plan *plan, const Person *person) {
    add(handles, GRIP_MIDDLE, 0, person->at);
    add(handles, GRIP_TURN, 0, vec2_along(person->at, 2 * ARM, snap_heading(person->heading)));
    const PlanRoute *route = plan_route_of(plan, person->id);
    if (!route)
        return;
    *handles = (Handles){handles->list, handles->count, route->id, DRAFT_ROUTES};
    add_points(handles, &route->via, route->via.count);
}

static void add_exit(Handles *handles, const Exit *exit) {
    add(handles, GRIP_POINT, 0, exit->from);
    add(handles, GRIP_POINT, 1, exit->to);
    add(handles, GRIP_MIDDLE, 0, middle(exit->from, exit->to));
}

size_t edit_handle_list(const Editor *edit, const Plan *plan, EditHandle *handles) {
    Handles made = {.list = handles};
    size_t index;
    if (edit->id_count != 1 || edit_select_fixed(edit))
        return 0;
    made.id = edit->ids[0];
    made.of = draft_find(edit->draft, made.id, &index);
    switch (made.of) {
    case DRAFT_WALLS:
        if (index < plan->wall_count)
            add_wall(&made, &plan->walls[index]);
        break;
    case DRAFT_DOORS:
        if (index < plan->door_count)
            add_door(&made, plan, &plan->doors[index]);
        break;
    case DRAFT_FURNITURE:
        if (index < plan->furniture_count)
            add_piece(&made, &plan->furniture[index]);
        break;
    case DRAFT_ROOMS:
        if (index < plan->room_count)
            add_points(&made, &plan->rooms[index].outline, plan->rooms[index].outline.count);
        break;
    case DRAFT_EXITS:
        if (index < plan->exit_count)
            add_exit(&made, &plan->exits[index]);
        break;
    case DRAFT_PEOPLE:
        if (index < plan->person_count)
            add_person(&made, plan, &plan->people[index]);
        break;
    default:
        break;
    }
    return made.count;
}

bool edit_handle_at(const Editor *edit, const Pointer *pointer, EditHandle *handle) {
    EditHandle handles[EDIT_HANDLES];
    size_t count = edit_handle_list(edit, draft_plan(edit->draft), handles);
    double nearest = pointer->reach;
    for (size_t i = 0; i < count; i++) {
        double distance = vec2_distance(handles[i].at, pointer->at);
        if (distance > nearest)
            continue;
        nearest = distance;
        *handle = handles[i];
    }
    return count && nearest < pointer->reach;
}
