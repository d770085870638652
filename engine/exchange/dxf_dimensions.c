#include "exchange/dxf_dimensions.h"

#include <math.h>
#include <string.h>

#include "base/real.h"

static const double MAJORITY = 2.0 / 3; /* 1: share of the dimensions that must agree */
static const double NEAR = 3;           /* 1: largest distance of a text from its line, in heights of the text */
static const double ALONG = 0.02;       /* 1: sine of the largest angle between a text and its line */

enum {
    KIND = 7, /* part of a dimension's flags */
    LINEAR = 0,
    ALIGNED = 1,
    MOST_TEXTS = 500, /* each is compared with all lines */
    MOST_LINES = 20000,
    LEAST_TEXTS = 2, /* a single text beside a line may be chance */
    LEAST_BARE = 2   /* a single number without a unit may be chance, where the header says another unit */
};

typedef struct Votes {
    const PlanUnit *header; /* the unit that a plausible header says, or NULL */
    size_t count[PLAN_SIZE_UNITS], all;
    size_t named[PLAN_SIZE_UNITS]; /* votes of texts that name their unit */
    DxfEvidence first[PLAN_SIZE_UNITS];
} Votes;

static bool is_equal(const LengthText *length, double measured) {
    return !length->has_unit && fabs(length->value / measured - 1) < 0.015;
}

/* Returns the unit that makes a written length of a measured one. A bare number may be in mm, cm or m. */
static const PlanUnit *unit_of(const LengthText *length, double measured) {
    static const double written[] = {0.001, 0.01, 1};
    const PlanUnit *unit = length->has_unit ? plan_size_unit_of(measured, length->value) : NULL;
    for (size_t w = 0; w < sizeof written / sizeof *written && !length->has_unit && !unit; w++)
        unit = plan_size_unit_of(measured, length->value * written[w]);
    return unit;
}

/* Counts a dimension that shows the length that it measures: it agrees with the header. */
static void agree(Votes *votes) {
    if (!votes->header)
        return;
    votes->count[votes->header - plan_size_units]++;
    votes->all++;
}

static void vote(Votes *votes, const char *text, const LengthText *length, double measured) {
    if (is_equal(length, measured)) {
        agree(votes);
        return;
    }
    const PlanUnit *unit = unit_of(length, measured);
    if (!unit)
        return;
    size_t u = (size_t)(unit - plan_size_units);
    DxfEvidence *first = &votes->first[u];
    if (!first->unit) {
        first->unit = unit;
        first->measured = measured;
        length_text_plain(first->text, text, measured);
    }
    votes->count[u]++;
    votes->named[u] += length->has_unit;
    votes->all++;
}

/* Returns the unit of most votes, if at least `least` dimensions agree on it; no unit if all of these only agree with
 * the header. */
static DxfEvidence count_votes(const Votes *votes, size_t least) {
    for (size_t u = 0; u < PLAN_SIZE_UNITS; u++) {
        bool contradicts = votes->header && votes->header != &plan_size_units[u];
        size_t needed = contradicts && !votes->named[u] && least < LEAST_BARE ? LEAST_BARE : least;
        if (votes->count[u] >= needed && (double)votes->count[u] >= MAJORITY * (double)votes->all)
            return votes->first[u];
    }
    return (DxfEvidence){.unit = NULL};
}

/* Dimensions ------------------------------------------------------------------------------------------------------ */

static double measure(const DxfEntity *dimension) {
    int kind = dimension->flags & KIND;
    Vec2 across = vec2_sub(dimension->to, dimension->from);
    double length = kind == LINEAR    ? fabs(vec2_dot(across, vec2_heading(radians(dimension->turned))))
                    : kind == ALIGNED ? vec2_length(across)
                                      : 0;
    return length > 0 ? length : kind <= ALIGNED ? dimension->measured : 0;
}

/* Returns the text that a dimension shows: its own, or that of its block. */
static const char *shown(const DxfFile *file, const DxfEntity *dimension) {
    if (*dimension->text && strcmp(dimension->text, "<>") != 0)
        return dimension->text;
    const DxfBlock *block = *dimension->block ? dxf_file_block(file, dimension->block) : NULL;
    for (size_t e = 0; block && e < block->count; e++)
        if (file->entities[block->first + e].kind == DXF_TEXT)
            return file->entities[block->first + e].text;
    return "";
}

static void ask_dimensions(const DxfFile *file, Votes *votes) {
    for (size_t e = file->model; e < file->model + file->model_count; e++) {
        const DxfEntity *entity = &file->entities[e];
        LengthText length;
        double measured = entity->kind == DXF_DIMENSION && !entity->on_paper ? measure(entity) : 0;
        const char *text = measured > 0 ? shown(file, entity) : "";
        if (measured > 0 && !*text)
            agree(votes);
        else if (measured > 0 && length_text_read(text, measured, &length))
            vote(votes, text, &length, measured);
    }
}

/* Exploded dimensions --------------------------------------------------------------------------------------------- */

/* Returns the length of the nearest line along a text, or 0. */
static double line_beside(const DxfFile *file, const DxfEntity *text) {
    Vec2 along = vec2_heading(radians(text->turned));
    double nearest = NEAR * text->radius, length = 0;
    for (size_t e = file->model; e < file->model + file->model_count; e++) {
        const DxfEntity *line = &file->entities[e];
        if (line->kind != DXF_LINES || line->vertex_count != 2 || line->on_paper)
            continue;
        Vec2 a = file->vertices[line->vertex].at, b = file->vertices[line->vertex + 1].at;
        double distance = vec2_distance(text->at, vec2_nearest_on_segment(text->at, a, b));
        if (!(distance <= nearest) || /* also if the text has no place */
            fabs(vec2_cross(vec2_unit(vec2_sub(b, a)), along)) > ALONG)
            continue;
        nearest = distance;
        length = vec2_distance(a, b);
    }
    return length;
}

static void ask_texts(const DxfFile *file, Votes *votes) {
    size_t texts = 0;
    for (size_t e = file->model; e < file->model + file->model_count && texts < MOST_TEXTS; e++) {
        const DxfEntity *entity = &file->entities[e];
        LengthText length;
        if (entity->kind != DXF_TEXT || entity->on_paper || !length_text_read(entity->text, 0, &length) ||
            !length.has_unit)
            continue;
        texts++;
        double measured = line_beside(file, entity);
        if (measured > 0)
            vote(votes, entity->text, &length, measured);
    }
}

DxfEvidence dxf_dimensions_ask(const DxfFile *file, const PlanUnit *header) {
    Votes votes = {.header = header};
    ask_dimensions(file, &votes);
    if (votes.all || file->model_count > MOST_LINES)
        return count_votes(&votes, 1);
    ask_texts(file, &votes);
    return count_votes(&votes, LEAST_TEXTS);
}
