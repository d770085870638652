#include "exchange/house_finish.h"

#include <math.h>
#include <string.h>

#include "base/text.h"
#include "base/visible.h"
#include "exchange/repeated.h"

enum { NOTE_KINDS = 4 /* kinds of omitted elements that the note names */ };

static const double FAR = 1000; /* m: a plan whose centre is farther from its origin is moved there */

typedef void MovePoint(Vec2 *at, Vec2 by, void *context);

static void visit_points(Points *points, MovePoint *visit, Vec2 by, void *context) {
    for (size_t i = 0; i < points->count; i++)
        visit(&points->at[i], by, context);
}

/* Calls `visit` for each point of the plan. */
static void visit_all(Plan *plan, MovePoint *visit, Vec2 by, void *context) {
    for (size_t i = 0; i < plan->wall_count; i++)
        visit_points(&plan->walls[i].points, visit, by, context);
    for (size_t i = 0; i < plan->furniture_count; i++)
        visit(&plan->furniture[i].centre, by, context);
    for (size_t i = 0; i < plan->room_count; i++)
        visit_points(&plan->rooms[i].outline, visit, by, context);
    for (size_t i = 0; i < plan->exit_count; i++) {
        visit(&plan->exits[i].from, by, context);
        visit(&plan->exits[i].to, by, context);
    }
    for (size_t i = 0; i < plan->person_count; i++)
        visit(&plan->people[i].at, by, context);
    for (size_t i = 0; i < plan->crowd_count; i++)
        visit_points(&plan->crowds[i].area, visit, by, context);
    for (size_t i = 0; i < plan->route_count; i++)
        visit_points(&plan->routes[i].via, visit, by, context);
}

static void include_point(Vec2 *at, Vec2 by, void *context) {
    (void)by;
    Box *box = context;
    *box = box_include(*box, *at);
}

static void move_point(Vec2 *at, Vec2 by, void *context) {
    (void)context;
    *at = house_builder_rounded(vec2_add(*at, by));
}

/* Moves the plan near its origin: drawings may use the coordinates of a land survey. */
static bool bring_near(HouseBuilder *builder) {
    Box box = box_empty();
    visit_all(&builder->plan, include_point, vec2(0, 0), &box);
    Vec2 middle = vec2_scale(vec2_add(box.low, box.high), 0.5);
    if (fabs(middle.x) > FAR || fabs(middle.y) > FAR) {
        Vec2 by = vec2(-floor(box.low.x), -floor(box.low.y));
        visit_all(&builder->plan, move_point, by, NULL);
        import_report_note(builder->report, "the plan was moved by (%.10g, %.10g) m to the origin", by.x, by.y);
    }
    if (box_width(box) < PARAMETER_FARTHEST / 2 && box_height(box) < PARAMETER_FARTHEST / 2)
        return true;
    builder->line = 1;
    return house_builder_fail(builder, "the plan is %.4g m by %.4g m, must be less than %g m: is the unit right?",
                              box_width(box), box_height(box), PARAMETER_FARTHEST / 2);
}

static bool in_wall(const Wall *wall, Vec2 at) {
    for (size_t s = 0; s + 1 < wall->points.count; s++)
        if (vec2_distance(at, vec2_nearest_on_segment(at, wall->points.at[s], wall->points.at[s + 1])) <
            wall->thickness / 2)
            return true;
    return false;
}

static bool in_furniture(const Furniture *piece, Vec2 at) {
    Vec2 own = vec2_unturn(vec2_sub(at, piece->centre), vec2_heading(radians(piece->angle)));
    return fabs(own.x) < piece->size.x / 2 && fabs(own.y) < piece->size.y / 2;
}

static bool stands_free(const Plan *plan, Vec2 at) {
    bool is_free = true;
    for (size_t w = 0; w < plan->wall_count && is_free; w++)
        is_free = plan->walls[w].thickness == 0 || !in_wall(&plan->walls[w], at);
    for (size_t f = 0; f < plan->furniture_count && is_free; f++)
        is_free = !in_furniture(&plan->furniture[f], at);
    return is_free;
}

/* Removes a person from the routes and deletes routes that become empty. */
static void drop_from_routes(Plan *plan, const char *who) {
    size_t kept = 0;
    for (size_t r = 0; r < plan->route_count; r++) {
        Ids *people = &plan->routes[r].people;
        size_t left = 0;
        for (size_t i = 0; i < people->count; i++)
            if (strcmp(people->at[i], who) != 0)
                people->at[left++] = people->at[i];
        people->count = left;
        if (left)
            plan->routes[kept++] = plan->routes[r];
    }
    plan->route_count = kept;
}

static void drop_walled_in(HouseBuilder *builder) {
    Plan *plan = &builder->plan;
    size_t kept = 0;
    for (size_t p = 0; p < plan->person_count; p++) {
        if (stands_free(plan, plan->people[p].at))
            plan->people[kept++] = plan->people[p];
        else
            drop_from_routes(plan, plan->people[p].id);
    }
    import_report_leave(builder->report, plan->person_count - kept, "people who stand inside an obstacle");
    plan->person_count = kept;
}

static void note_what_lacks(HouseBuilder *builder) {
    const Plan *plan = &builder->plan;
    bool empty = !plan->person_count && !plan->crowd_count;
    if (!plan->exit_count)
        import_report_note(builder->report, "the house has no exit yet: add one where people leave%s",
                           empty ? ", and people" : "");
    else if (empty)
        import_report_note(builder->report, "the house has no people yet: add people");
}

/* Returns a note about the origin of the plan and its gaps, for later readers; the report has the full list. */
static const char *house_note(HouseBuilder *builder) {
    const ImportReport *report = builder->report;
    const char *slash = strrchr(builder->path, '/');
    size_t kinds = report->left_out_count, named = kinds > NOTE_KINDS ? NOTE_KINDS - 1 : kinds;
    Text note = {0};
    text_format(&note, "Imported from %s (%s)", slash ? slash + 1 : builder->path, report->format);
    for (size_t i = 0; i < named; i++)
        text_format(&note, "%s %s (%zu)", i ? "," : "; left out:", report->left_out[i].what, report->left_out[i].count);
    if (named < kinds)
        text_format(&note, " and %zu kinds more", kinds - named);
    char *line = visible_line(note.text);
    const char *kept = arena_text(&builder->plan.arena, line);
    memory_free(line);
    memory_free(note.text);
    return kept;
}

bool house_finish_plan(HouseBuilder *builder, Plan *plan) {
    builder->line = 1;
    if (!builder->failed && !builder->plan.wall_count)
        house_builder_fail(builder, "the file has no walls");
    if (builder->failed || !bring_near(builder))
        return false;
    drop_walled_in(builder);
    repeated_drop(builder);
    note_what_lacks(builder);
    builder->plan.note = house_note(builder);
    char *text = plan_text(&builder->plan);
    bool good = plan_read_text(plan, builder->path, text, NULL, 0, builder->fault);
    memory_free(text);
    if (good)
        repeated_compare_rooms(plan, builder->report);
    return good;
}
