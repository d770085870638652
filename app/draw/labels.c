#include "draw/labels.h"

#include "draw/caption.h"
#include "draw/mask.h"
#include "draw/text.h"

#define GAP 9.0           /* design points, between a point and a label next to it: half a line's width and some air */
#define WIDEST 480.0      /* design points: longer texts are shortened */
#define AIR 3.0           /* design points, left free around a label, also within the outline of its object */
#define RING_STEP 12.0    /* design points, from one ring of candidate places to the next */
#define LABEL_WEIGHT 10.0 /* overlapping labels are worse than anything but leaving the page */
#define DISTANCE_COST 4.0 /* design points: a distance of 20 costs as much as hiding 80 of a locus */
#define TURNED_COST 200.0 /* turned text is harder to read */
#define SMALLER_COST 40.0
#define CROSSING_COST 6.0  /* per design point of wall between a label and its point */
#define OPTIONAL_MOST 0.35 /* mean weight under an optional label; above it the label is left out */

enum {
    RINGS = 9,       /* of candidate places: out to about 100 design points */
    DIRECTIONS = 16, /* per ring */
    RASTER = 12,     /* candidate places per side inside an outline */
};

/* Returns the points of a primitive at its top, on the page. */
static Vec2 *to_page(const Layout *layout, const Primitive *primitive) {
    Vec2 *page = memory_zeroed(primitive->count, sizeof *page);
    for (size_t i = 0; i < primitive->count; i++)
        page[i] = layout_raised(layout, primitive->points[i], primitive->base + primitive->height);
    return page;
}

static void mark_primitive(Mask *mask, const Layout *layout, const Primitive *primitive) {
    Vec2 *points = to_page(layout, primitive);
    double weight = primitive->keep_clear;
    switch (primitive->kind) {
    case PRIMITIVE_POLYGON:
        mask_mark_rings(mask, points, primitive->starts, primitive->ring_count, weight);
        break;
    case PRIMITIVE_LINE:
    case PRIMITIVE_DIMENSION:
        for (size_t i = 0; i + 1 < primitive->count; i++)
            mask_mark_line(mask, points[i], points[i + 1], primitive->width, weight);
        break;
    case PRIMITIVE_DISC:
    case PRIMITIVE_BALL:
        for (size_t i = 0; i < primitive->count; i++)
            mask_mark_box(mask, box_around(points[i], primitive->radius * layout->metre), weight);
        break;
    case PRIMITIVE_WHEEL:
    case PRIMITIVE_TICK:
    case PRIMITIVE_LABEL:
        break;
    }
    memory_free(points);
}

/* True if the outline contains the point, even-odd. */
static bool outline_holds(const Vec2 *outline, size_t count, Vec2 p) {
    bool inside = false;
    for (size_t i = 0, j = count - 1; i < count; j = i++) {
        Vec2 a = outline[i], b = outline[j];
        if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x))
            inside = !inside;
    }
    return inside;
}

static bool outline_holds_box(const Vec2 *outline, size_t count, Box box) {
    Vec2 probes[] = {box.low, box.high, {box.low.x, box.high.y}, {box.high.x, box.low.y}};
    for (size_t i = 0; i < sizeof probes / sizeof *probes; i++)
        if (!outline_holds(outline, count, probes[i]))
            return false;
    return true;
}

/* The best place so far. */
typedef struct Choice {
    Caption caption;
    double cost;
} Choice;

/* Skips the mask if `extra` alone exceeds the best cost. */
static void consider(Choice *best, const Mask *mask, Caption caption, double extra) {
    if (extra >= best->cost)
        return;
    double cost = mask_cost(mask, box_expand(caption_box(&caption), AIR)) + extra;
    if (cost < best->cost)
        *best = (Choice){caption, cost};
}

/* Considers places inside the outline, horizontal or turned; among equals the one nearest to `at` wins. */
static void consider_inside(Choice *best, const Mask *mask, Caption caption, const Vec2 *outline, size_t count, Vec2 at,
                            double extra) {
    Box box = box_empty();
    for (size_t i = 0; i < count; i++)
        box = box_include(box, outline[i]);
    for (int turned = 0; turned <= 1; turned++)
        for (int i = -1; i < RASTER * RASTER; i++) {
            Vec2 part = vec2((i % RASTER + 0.5) / RASTER, (double)(i / RASTER) / RASTER + 0.5 / RASTER);
            caption.turned = turned;
            caption.centre =
                i < 0 ? at : vec2(box.low.x + part.x * box_width(box), box.low.y + part.y * box_height(box));
            double away = extra + turned * TURNED_COST + DISTANCE_COST * vec2_distance(caption.centre, at);
            if (away < best->cost && outline_holds_box(outline, count, box_expand(caption_box(&caption), AIR)))
                consider(best, mask, caption, away);
        }
}

/* Considers the point itself and the places on the rings around it. */
static void consider_around(Choice *best, const Mask *mask, Caption caption, Vec2 at, bool on_it, int rings) {
    caption.centre = at;
    if (on_it)
        consider(best, mask, caption, 0);
    for (int ring = 0; ring < rings; ring++)
        for (int i = 0; i < DIRECTIONS; i++) {
            Vec2 way = vec2_heading(2 * M_PI * i / DIRECTIONS);
            double reach = GAP + ring * RING_STEP, away = DISTANCE_COST * reach;
            if (away >= best->cost)
                return;
            Vec2 step = {way.x * (reach + caption.extent.x / 2), way.y * (reach + caption.extent.y / 2)};
            caption.centre = vec2_add(at, step);
            double crossing = CROSSING_COST * mask_line_cost(mask, at, caption.centre);
            consider(best, mask, caption, away + crossing);
        }
}

static Caption label_caption(Layout *layout, const Primitive *label, Vec2 at, double size) {
    double widest = fmin(WIDEST, layout->frame.high.x - layout->frame.low.x - 2 * AIR);
    const char *text = caption_shortened(layout, label->text, size, label->bold, widest);
    Caption caption = {.text = text,
                       .centre = at,
                       .extent = text_extent(text, size, label->bold),
                       .size = size,
                       .bold = label->bold,
                       .halo = label->shape == LABEL_BARE,
                       .role = label->edge,
                       .fill = label->fill,
                       .pointed = at};
    caption_shape(&caption, label->shape, label->fill);
    return caption;
}

/* Chooses the best place: inside the label's outline, as large as possible, otherwise around its point. */
static Choice choose_place(const Mask *mask, Layout *layout, const Primitive *label) {
    Choice best = {.cost = HUGE_VAL};
    Vec2 *points = to_page(layout, label);
    Caption large = label_caption(layout, label, points[0], label->size);
    Caption small = label_caption(layout, label, points[0], LAYOUT_SMALLEST_TEXT);
    if (label->count > 1) {
        consider_inside(&best, mask, large, points + 1, label->count - 1, points[0], 0);
        consider_inside(&best, mask, small, points + 1, label->count - 1, points[0], SMALLER_COST);
    }
    if (best.cost == HUGE_VAL && (label->count == 1 || (!label->optional && !label->close))) {
        large.leader = label->leader;
        large.fill = label->shape == LABEL_BARE ? ROLE_PAPER : large.fill;
        consider_around(&best, mask, large, points[0], label->shape == LABEL_DISC, label->close ? 1 : RINGS);
    }
    memory_free(points);
    return best;
}

/* True if the labelled point lies outside the picture, as when the view shows a part of the house. */
static bool is_away(const Layout *layout, const Primitive *label) {
    return !box_holds(layout->frame, layout_point(layout, label->points[0]));
}

/* Moves a caption into a box. */
static void clamp_within(Caption *caption, Box room) {
    Box box = caption_box(caption);
    Vec2 half = vec2_scale(vec2_sub(box.high, box.low), 0.5);
    caption->centre.x = real_clamp(caption->centre.x, room.low.x + half.x + AIR, room.high.x - half.x - AIR);
    caption->centre.y = real_clamp(caption->centre.y, room.low.y + half.y + AIR, room.high.y - half.y - AIR);
}

static void place_label(Mask *mask, Layout *layout, const Primitive *label) {
    if (is_away(layout, label))
        return;
    Choice best = choose_place(mask, layout, label);
    clamp_within(&best.caption, layout->frame);
    Box box = caption_box(&best.caption);
    double most = OPTIONAL_MOST * box_width(box) * box_height(box);
    if (best.cost == HUGE_VAL || (label->optional && mask_cost(mask, box) > most))
        return;
    best.caption.leader &= vec2_distance(best.caption.centre, best.caption.pointed) > 1;
    if (best.caption.leader)
        mask_mark_line(mask, best.caption.centre, best.caption.pointed, 2, 1);
    mask_mark_box(mask, box, LABEL_WEIGHT);
    Caption *caption = caption_add(layout, best.caption.text, best.caption.size, best.caption.bold, (Vec2){0});
    *caption = best.caption;
}

/* Places a label on its point or next to it, within the frame and below the texts above the plan. */
static void place_fixed(Layout *layout, const Primitive *label) {
    if (is_away(layout, label))
        return;
    Vec2 at = layout_raised(layout, label->points[0], label->base);
    Caption *caption = caption_add(layout, label->text, label->size, label->bold, at);
    *caption = label_caption(layout, label, at, label->size);
    Vec2 half = vec2_scale(caption->extent, 0.5);
    if (label->count > 1) {
        Vec2 way = vec2_unit(vec2_sub(layout_raised(layout, label->points[1], label->base), at));
        caption->centre = vec2_add(at, vec2(way.x * (half.x + GAP), way.y * (half.y + GAP)));
    }
    Box room = {{layout->frame.low.x, layout->plan.low.y - AIR}, layout->frame.high};
    clamp_within(caption, room);
}

static bool has_free_labels(const Scene *scene) {
    for (size_t i = 0; i < scene->count; i++)
        if (scene->primitives[i].kind == PRIMITIVE_LABEL && !scene->primitives[i].fixed)
            return true;
    return false;
}

void labels_place(Layout *layout, const Scene *scene) {
    size_t fixed = layout->caption_count;
    for (size_t i = 0; i < scene->count; i++)
        if (scene->primitives[i].kind == PRIMITIVE_LABEL && scene->primitives[i].fixed)
            place_fixed(layout, &scene->primitives[i]);
    if (!has_free_labels(scene))
        return;
    Mask mask;
    mask_init(&mask, layout->plan);
    for (size_t i = fixed; i < layout->caption_count; i++)
        mask_mark_box(&mask, caption_box(&layout->captions[i]), LABEL_WEIGHT);
    for (size_t i = 0; i < scene->count; i++)
        if (scene->primitives[i].keep_clear > 0)
            mark_primitive(&mask, layout, &scene->primitives[i]);
    for (size_t i = 0; i < scene->count; i++)
        if (scene->primitives[i].kind == PRIMITIVE_LABEL && !scene->primitives[i].fixed)
            place_label(&mask, layout, &scene->primitives[i]);
    mask_clear(&mask);
}
