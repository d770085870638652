#include "exchange/dxf_unit.h"

#include <math.h>
#include <stdlib.h>

#include "base/text.h"
#include "exchange/dxf_dimensions.h"
#include "exchange/wall_faces.h"

static const double LEAF_LEAST = 0.55, LEAF_MOST = 1.35;              /* m: range of the usual door leaf */
static const double SWING_LEAST = M_PI / 4, SWING_MOST = 0.75 * M_PI; /* rad, range of a door's arc */
static const double USUAL = 0.07;                                     /* m: thinnest wall of which a plan may consist */

enum { ARCHITECTURAL = 4, ENGINEERING = 3 /* $LUNITS: the drawing's unit is the inch */ };

typedef struct Sizes {
    Vec2 plan;   /* extent of the walls */
    double leaf; /* median radius of the doors' arcs; 0: no doors */
} Sizes;

/* Header ---------------------------------------------------------------------------------------------------------- */

static const struct {
    int code; /* $INSUNITS */
    PlanUnit unit;
} codes[] = {
    {4, {"mm", 0.001}},  {5, {"cm", 0.01}}, {6, {"m", 1}},        {1, {"inch", 0.0254}},
    {2, {"ft", 0.3048}}, {14, {"dm", 0.1}}, {10, {"yd", 0.9144}}, {7, {"km", 1000}},
};

static const PlanUnit *said_unit(const DxfFile *file) {
    static const PlanUnit inch = {"inch", 0.0254};
    for (size_t c = 0; c < sizeof codes / sizeof *codes; c++)
        if (codes[c].code == file->unit)
            return &codes[c].unit;
    return file->notation == ARCHITECTURAL || file->notation == ENGINEERING ? &inch : NULL;
}

/* Sizes ----------------------------------------------------------------------------------------------------------- */

static Vec2 size_of(const DxfShapes *shapes) {
    Box box = box_empty();
    for (size_t s = 0; s < shapes->count; s++)
        for (size_t i = 0; i < shapes->list[s].count && shapes->list[s].role == DXF_WALLS; i++)
            box = box_include(box, shapes->points[shapes->list[s].point + i]);
    return vec2_sub(box.high, box.low);
}

static int compare(const void *a, const void *b) {
    const double *p = a, *q = b;
    return *p < *q ? -1 : *p > *q;
}

static double middle_leaf(const DxfShapes *shapes) {
    double *radii = memory_zeroed(shapes->count, sizeof *radii), middle = 0;
    size_t count = 0;
    for (size_t s = 0; s < shapes->count; s++) {
        const DxfShape *shape = &shapes->list[s];
        if (shape->role == DXF_DOORS && shape->arc && shape->sweep > SWING_LEAST && shape->sweep < SWING_MOST)
            radii[count++] = vec2_distance(shapes->points[shape->point], shape->centre);
    }
    if (count) {
        qsort(radii, count, sizeof *radii, compare);
        middle = radii[count / 2];
    }
    memory_free(radii);
    return middle;
}

static bool is_possible(const Sizes *sizes, double metres) {
    double leaf = sizes->leaf * metres;
    return plan_size_is_plausible(fmax(sizes->plan.x, sizes->plan.y) * metres) &&
           (leaf == 0 || (leaf >= LEAF_LEAST && leaf <= LEAF_MOST));
}

/* Lists the walls' lines, in the drawing's unit. */
static WallLines list_walls(const DxfShapes *shapes) {
    WallLines lines = {0};
    for (size_t s = 0; s < shapes->count; s++) {
        const DxfShape *shape = &shapes->list[s];
        const Vec2 *points = shapes->points + shape->point;
        for (size_t i = 0; i + 1 < shape->count && shape->role == DXF_WALLS && !shape->width; i++)
            wall_chains_append(&lines, (WallLine){points[i], points[i + 1], 0, 0});
    }
    return lines;
}

/* Lists the units in the report, for someone to choose among. */
static void list_units(const DxfShapes *shapes, const Sizes *sizes, ImportReport *report) {
    WallLines lines = list_walls(shapes);
    double walls[PLAN_SIZE_UNITS];
    for (size_t u = 0; u < PLAN_SIZE_UNITS; u++)
        walls[u] = wall_faces_likely(&lines, plan_size_units[u].metres);
    memory_free(lines.list);
    plan_size_list(report, sizes->plan, sizes->leaf, walls);
}

/* Keeps those candidates in which walls that are drawn as two lines have a possible thickness, if there are any. */
static void ask_walls(const DxfShapes *shapes, bool possible[PLAN_SIZE_UNITS]) {
    WallLines lines = list_walls(shapes);
    bool likely[PLAN_SIZE_UNITS] = {false}, any = false;
    for (size_t u = 0; u < PLAN_SIZE_UNITS; u++)
        any |= likely[u] = possible[u] && wall_faces_likely(&lines, plan_size_units[u].metres) > 0;
    for (size_t u = 0; u < PLAN_SIZE_UNITS && any; u++)
        possible[u] = likely[u];
    memory_free(lines.list);
}

/* Choice ---------------------------------------------------------------------------------------------------------- */

static void note_header(ImportReport *report, const PlanUnit *said, const PlanUnit *chosen, Vec2 plan) {
    if (said && said->metres != chosen->metres)
        import_report_note(report,
                           "the file says that its unit is %s, which would make the plan %.4g m by %.4g m. Use --unit "
                           "to override",
                           said->name, plan.x * said->metres, plan.y * said->metres);
}

/* Marks the units that make a plan of possible size; returns their number. */
static size_t find_possible(const Sizes *sizes, bool possible[PLAN_SIZE_UNITS]) {
    size_t count = 0;
    for (size_t u = 0; u < PLAN_SIZE_UNITS; u++)
        count += possible[u] = is_possible(sizes, plan_size_units[u].metres);
    return count;
}

/* Chooses the unit that the dimensions say; `*good` is false after an error. Returns false if they say none. */
static bool choose_by_dimensions(const DxfFile *file, const Sizes *sizes, HouseBuilder *builder, const PlanUnit *header,
                                 double *metres, bool *good) {
    DxfEvidence evidence = dxf_dimensions_ask(file, header);
    if (!evidence.unit)
        return false;
    *metres = evidence.unit->metres;
    *good = is_possible(sizes, *metres);
    if (!*good) {
        bool possible[PLAN_SIZE_UNITS];
        find_possible(sizes, possible);
        Text why = {0};
        text_format(
            &why, "the dimensions say that the unit is %s: %s measures %.6g; this would make the plan %.4g m by %.4g m",
            evidence.unit->name, evidence.text, evidence.measured, sizes->plan.x * *metres, sizes->plan.y * *metres);
        plan_size_refuse(builder, why.text, sizes->plan, possible);
        memory_free(why.text);
        return true;
    }
    import_report_note(
        builder->report, "the unit is %s, as the dimensions say: %s measures %.6g; the plan is %.4g m by %.4g m",
        evidence.unit->name, evidence.text, evidence.measured, sizes->plan.x * *metres, sizes->plan.y * *metres);
    note_header(builder->report, said_unit(file), evidence.unit, sizes->plan);
    return true;
}

static bool refuse(HouseBuilder *builder, const PlanUnit *said, Vec2 plan, const bool possible[PLAN_SIZE_UNITS]) {
    Text why = {0};
    if (said)
        text_format(&why,
                    "the file says that its unit is %s, which would make the plan %.4g m by %.4g m, and nothing "
                    "else confirms it",
                    said->name, plan.x * said->metres, plan.y * said->metres);
    else
        text_add(&why, "the file does not say its unit, and nothing else does");
    bool good = plan_size_refuse(builder, why.text, plan, possible);
    memory_free(why.text);
    return good;
}

/* Chooses the only unit with possible sizes. */
static bool choose_by_sizes(const PlanUnit *said, const DxfShapes *shapes, const Sizes *sizes, HouseBuilder *builder,
                            double *metres) {
    bool possible[PLAN_SIZE_UNITS];
    size_t count = find_possible(sizes, possible), chosen = 0;
    list_units(shapes, sizes, builder->report);
    if (count > 1)
        ask_walls(shapes, possible);
    count = 0;
    for (size_t u = 0; u < PLAN_SIZE_UNITS; u++) {
        count += possible[u];
        chosen = possible[u] ? u : chosen;
    }
    if (count != 1)
        return refuse(builder, said, sizes->plan, possible);
    const PlanUnit *unit = &plan_size_units[chosen];
    *metres = unit->metres;
    double x = sizes->plan.x * unit->metres, y = sizes->plan.y * unit->metres;
    if (sizes->leaf > 0)
        import_report_note(builder->report,
                           "the unit is %s, as the doors say: the median leaf is %.4g m wide, the plan is %.4g m by "
                           "%.4g m. Use --unit to override",
                           unit->name, sizes->leaf * unit->metres, x, y);
    else
        import_report_note(builder->report,
                           "the unit is %s, as the walls and the size say: the plan is %.4g m by %.4g m. Use --unit to "
                           "override",
                           unit->name, x, y);
    note_header(builder->report, said, unit, sizes->plan);
    return true;
}

/* Returns false after an error: another unit is possible, and in the header's unit the walls that are drawn as two
 * lines are all thinner than usual or have no possible thickness. */
static bool walls_agree(const PlanUnit *said, const DxfShapes *shapes, const Sizes *sizes, HouseBuilder *builder) {
    bool possible[PLAN_SIZE_UNITS], other = false;
    find_possible(sizes, possible);
    WallLines lines = list_walls(shapes);
    double thickest = wall_faces_likely(&lines, said->metres);
    for (size_t u = 0; u < PLAN_SIZE_UNITS && thickest < USUAL; u++) {
        bool same = plan_size_units[u].metres == said->metres;
        possible[u] =
            possible[u] && (same ? thickest > 0 : wall_faces_likely(&lines, plan_size_units[u].metres) >= USUAL);
        other |= possible[u] && !same;
    }
    memory_free(lines.list);
    if (!other)
        return true;
    list_units(shapes, sizes, builder->report);
    double x = sizes->plan.x * said->metres, y = sizes->plan.y * said->metres;
    Text why = {0};
    if (thickest > 0)
        text_format(
            &why,
            "the file says that its unit is %s, which would make the plan %.4g m by %.4g m and all walls thinner "
            "than %.3g cm",
            said->name, x, y, USUAL * 100);
    else
        text_format(
            &why,
            "the file says that its unit is %s, which would make the plan %.4g m by %.4g m, and the distances of "
            "the lines are not those of a wall's faces",
            said->name, x, y);
    bool good = plan_size_refuse(builder, why.text, sizes->plan, possible);
    memory_free(why.text);
    return good;
}

/* Returns the unit of plan_size_units that equals the header's, if that makes a plan of possible size, or NULL. */
static const PlanUnit *plausible_header(const PlanUnit *said, const Sizes *sizes) {
    for (size_t u = 0; said && u < PLAN_SIZE_UNITS; u++)
        if (plan_size_units[u].metres == said->metres && is_possible(sizes, said->metres))
            return &plan_size_units[u];
    return NULL;
}

bool dxf_unit_choose(const DxfFile *file, const DxfShapes *shapes, HouseBuilder *builder, double *metres) {
    Sizes sizes = {size_of(shapes), middle_leaf(shapes)};
    const PlanUnit *said = said_unit(file);
    bool good = true, possible[PLAN_SIZE_UNITS];
    *metres = builder->options->unit > 0 ? builder->options->unit : 1;
    if (builder->options->unit > 0 || !(fmax(sizes.plan.x, sizes.plan.y) > 0) ||
        choose_by_dimensions(file, &sizes, builder, plausible_header(said, &sizes), metres, &good))
        return good;
    bool other = find_possible(&sizes, possible) > 0;
    if (!said || (other && !is_possible(&sizes, said->metres)))
        return choose_by_sizes(said, shapes, &sizes, builder, metres);
    if (!walls_agree(said, shapes, &sizes, builder))
        return false;
    *metres = said->metres;
    import_report_note(builder->report, "the unit is %s, as the file says: the plan is %.4g m by %.4g m", said->name,
                       sizes.plan.x * *metres, sizes.plan.y * *metres);
    return true;
}
