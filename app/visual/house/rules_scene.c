#include "visual/house/rules_scene.h"

#include <stdint.h>
#include <string.h>

#include "result/source_line.h"
#include "visual/house/house_scene.h"
#include "visual/house/plan_picture.h"
#include "visual/house/plan_scene.h"

/* Design points. */
#define LINE_WIDTH 2.5
#define CROSS_WIDTH 4.0
#define TEXT_SIZE 15.0

#define CROSS_HALF 0.14 /* m */
#define SAME 0.02       /* m: lines whose ends are nearer than this are one */
#define KEEP_SIGN 6.0   /* weight against being covered by labels */
#define DISC_OPACITY 0.10

#define TICK "\xe2\x9c\x93"
#define DOT "\xc2\xb7"
#define CROSS "\xe2\x9c\x97"

enum { ROWS_MOST = 16 };

/* True if the two findings are about one line on the plan. */
static bool is_same_line(const Finding *a, const Finding *b) {
    bool same = vec2_distance(a->from, b->from) < SAME && vec2_distance(a->to, b->to) < SAME;
    bool turned = vec2_distance(a->from, b->to) < SAME && vec2_distance(a->to, b->from) < SAME;
    return a->place == b->place && (same || turned);
}

/* A line on the plan, and what all sets say of it. */
typedef struct Dimension {
    const Finding *first; /* the one that decides: the most lenient failure or, without one, the most demanding rule */
    size_t passes, fails;
} Dimension;

static bool decides(const Finding *finding, const Finding *before) {
    bool fails = finding->verdict == RULE_FAILS, failed = before->verdict == RULE_FAILS;
    return fails != failed ? fails
           : fails         ? finding->requires < before->requires
                           : finding->requires > before->requires;
}

static Dimension *collect(const Inspection *inspection, size_t *count) {
    Dimension *dimensions = memory_zeroed(inspection->finding_count + 1, sizeof *dimensions);
    *count = 0;
    for (size_t i = 0; i < inspection->finding_count; i++) {
        const Finding *finding = &inspection->findings[i];
        size_t d = 0;
        if (!finding->drawn || finding->verdict == RULE_OPEN)
            continue;
        while (d < *count && !is_same_line(dimensions[d].first, finding))
            d++;
        if (d == *count)
            dimensions[(*count)++].first = finding;
        else if (decides(finding, dimensions[d].first))
            dimensions[d].first = finding;
        dimensions[d].passes += finding->verdict == RULE_PASSES;
        dimensions[d].fails += finding->verdict == RULE_FAILS;
    }
    return dimensions;
}

static void add_shape(Scene *scene, const Finding *finding, Role role) {
    Vec2 middle = vec2_scale(vec2_add(finding->from, finding->to), 0.5);
    Vec2 along = vec2_scale(vec2_sub(finding->to, finding->from), 0.5), across = vec2_left(along);
    if (finding->rule->what == RULE_TURNING_CIRCLE) {
        Primitive *disc = scene_add_discs(scene, role, vec2_length(along), &middle, 1);
        disc->fill_opacity = DISC_OPACITY;
    } else if (finding->rule->what == RULE_TURNING_SQUARE) {
        Vec2 corners[] = {vec2_add(finding->from, across), vec2_sub(finding->from, across),
                          vec2_sub(finding->to, across), vec2_add(finding->to, across)};
        scene_add_polygon(scene, role, corners, 4)->fill_opacity = DISC_OPACITY;
    }
}

/* Returns the role of what decides: a quiet one where its number was not read in its source. */
static Role role_of(const Dimension *dimension) {
    return dimension->first->status != STATUS_READ ? ROLE_DIM_TEXT : dimension->fails ? ROLE_ERROR : ROLE_EXIT;
}

/* Returns " · 76 %", the share of the drivers whose chair can be driven through the place; "" where none were tried. */
static const char *drivers_share(Scene *scene, const Inspection *inspection, const Finding *finding) {
    const RulePlace *place = finding->place == SIZE_MAX ? NULL : &inspection->places[finding->place];
    if (!place || !place->drivers)
        return "";
    return scene_text(scene, " " DOT " %.0f %%",
                      100 * (double)(place->drivers - place->refused) / (double)place->drivers);
}

/* Adds a line with the number that it has in the list, a tick or a cross, and the share of drivers. */
static void add_dimension(Scene *scene, const Inspection *inspection, const Dimension *dimension, size_t number) {
    const Finding *finding = dimension->first;
    bool fails = dimension->fails > 0;
    Role role = role_of(dimension);
    Vec2 middle = vec2_scale(vec2_add(finding->from, finding->to), 0.5);
    add_shape(scene, finding, role);
    scene_add_dimension(scene, role, LINE_WIDTH, finding->from, finding->to)->keep_clear = KEEP_SIGN;
    Primitive *tag = scene_add_label(
        scene, ROLE_TEXT, TEXT_SIZE, middle,
        scene_text(scene, "%zu %s%s", number, fails ? CROSS : TICK, drivers_share(scene, inspection, finding)));
    tag->shape = LABEL_TAG;
    tag->fill = role;
    tag->leader = true;
}

static void add_stop(Scene *scene, const RulePlace *place) {
    Vec2 at = place->blockage.at;
    for (int sign = -1; sign <= 1; sign += 2) {
        Vec2 arm = vec2(CROSS_HALF, sign * CROSS_HALF);
        Vec2 ends[] = {vec2_sub(at, arm), vec2_add(at, arm)};
        scene_add_line(scene, ROLE_ERROR, CROSS_WIDTH, ends, 2)->keep_clear = KEEP_SIGN;
    }
    Primitive *tag = scene_add_label(
        scene, ROLE_TEXT, TEXT_SIZE, at,
        scene_text(scene, "%zu of %zu chairs get through", place->chairs - place->stopped, place->chairs));
    tag->fill = ROLE_ERROR;
    tag->shape = LABEL_TAG;
    tag->bold = tag->leader = true;
}

/* Returns the place's name without the words in brackets, which have no room in the list. */
static const char *name_of(Scene *scene, const Inspection *inspection, const Finding *finding) {
    if (finding->place == SIZE_MAX)
        return "the house";
    const char *name = inspection->places[finding->place].name;
    const char *bracket = strstr(name, " (");
    return scene_text(scene, "%.*s", (int)(bracket ? (size_t)(bracket - name) : strlen(name)), name);
}

/* Adds the list: what each place has, and what the rule that decides requires; in the quiet role where that number was
 * not read in its source. */
static void add_list(Scene *scene, const Inspection *inspection, const Dimension *dimensions, size_t count) {
    SceneRow *head = scene_add_row(scene, ROW_HEADING, "Measured, m");
    head->cells[1] = "has";
    head->cells[2] = "must have";
    for (size_t d = 0; d < count && d < ROWS_MOST; d++) {
        const Finding *finding = dimensions[d].first;
        SceneRow *row = scene_add_row(scene, ROW_DISC, name_of(scene, inspection, finding));
        bool read = finding->status == STATUS_READ;
        row->role = role_of(&dimensions[d]);
        row->mark = scene_text(scene, "%zu", d + 1);
        const char *limit = scene_text(scene, finding->at_most ? "\xe2\x89\xa4 %g" : "%.3f", finding->requires);
        row->cells[1] = scene_text(scene, finding->at_most ? "%.1f" : "%.3f", finding->has);
        row->cells[2] = scene_text(scene, read ? "%s %s" : "(%s) %s", limit, dimensions[d].fails ? CROSS : TICK);
    }
    if (count > ROWS_MOST)
        scene_add_row(scene, ROW_PLAIN, scene_text(scene, "and %zu more", count - ROWS_MOST));
    scene_add_row(scene, ROW_PLAIN, "source not read")->cells[2] = "( )";
    if (inspection->population)
        scene_add_row(scene, ROW_PLAIN, scene_text(scene, "of %zu drivers get through", inspection->driver_count))
            ->cells[2] = "%";
}

void rules_scene_make(Scene *scene, const House *house, const Inspection *inspection, const char *title,
                      const char *detail) {
    size_t count;
    Dimension *dimensions = collect(inspection, &count);
    plan_picture_bare(scene, house);
    scene->grid = HOUSE_SCENE_GRID;
    scene->title = scene_text(scene, "%s", title);
    scene->detail = scene_text(scene, "%s", detail);
    scene->title_role =
        inspection->counts[RULE_FAILS] || inspection_legal_impassable(inspection) ? ROLE_ERROR : ROLE_TEXT;
    scene->name = scene_text(scene, "%s", house->plan.name);
    scene->note = source_line_is_assumed(&house->plan) ? scene_text(scene, "%s", house->plan.note) : "";
    for (size_t p = 0; p < inspection->place_count; p++)
        if (inspection->places[p].stopped)
            add_stop(scene, &inspection->places[p]);
    for (size_t d = 0; d < count; d++)
        add_dimension(scene, inspection, &dimensions[d], d + 1);
    plan_scene_tags(scene, house, NULL);
    plan_scene_names(scene, house);
    add_list(scene, inspection, dimensions, count);
    memory_free(dimensions);
}
