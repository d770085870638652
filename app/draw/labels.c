#include "draw/labels.h"

#include "draw/caption.h"
#include "draw/mask.h"
#include "draw/text.h"

#define GAP 9.0            /* design points, between a point and a label next to it: half a line's width and some air */
#define WIDEST 480.0       /* design points: longer texts are shortened */
#define AIR 3.0            /* design points, left free around a label, also within the outline of its object */
#define RING_STEP 12.0     /* design points, from one ring of candidate places to the next */
#define LABEL_WEIGHT 10.0  /* overlapping labels are worse than anything but leaving the page */
#define DISTANCE_COST 4.0  /* design points: a distance of 20 costs as much as hiding 80 of a locus */
#define TURNED_COST 200.0  /* turned text is harder to read */
#define CROSSING_COST 6.0  /* per design point of wall between a label and its point */
#define OPTIONAL_MOST 0.35 /* mean weight under an optional label; above it the label is left out */
#define ROOM_MOST 0.02     /* the same for the name of a room: it lies on the bare floor */
#define ROOM_AIR 6.0       /* design points, left free around the name of a room */
#define BAR_AIR 6.0        /* around the scale bar */
#define LABEL_SMALLEST 0.7 /* of the size of a label that must not be too wide */
#define NAME_AREA 30000.0  /* square design points of the plan for each name in it */

enum {
    RINGS = 3,       /* of candidate places: out to about 33 design points */
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

/* What is placed already. */
typedef struct Places {
    Mask mask;
    Layout *layout;
    const Layout *under; /* the layer below, whose labels are claimed, too; or NULL */
    const Scene *scene;
    size_t names; /* of rooms and furniture, that still may be placed */
} Places;

static bool overlap(Box a, Box b) {
    return a.low.x < b.high.x && b.low.x < a.high.x && a.low.y < b.high.y && b.low.y < a.high.y;
}

static bool overlaps_any(const Layout *layout, Box box) {
    for (size_t i = 0; i < layout->caption_count; i++)
        if (overlap(box, caption_box(&layout->captions[i])))
            return true;
    for (size_t i = 0; i < layout->sample_count; i++) {
        const Sample *bar = &layout->samples[i];
        if (overlap(box, box_expand(box_include(box_include(box_empty(), bar->from), bar->to), BAR_AIR)))
            return true;
    }
    return false;
}

/* True if a label may lie there: it hides no other label and is not cut. */
static bool is_free(const Places *places, Box box) {
    Box frame = places->layout->frame;
    return box.low.x >= frame.low.x && box.low.y >= frame.low.y && box.high.x <= frame.high.x &&
           box.high.y <= frame.high.y && !overlap(box, places->layout->taken) && !overlaps_any(places->layout, box) &&
           (!places->under || !overlaps_any(places->under, box));
}

/* The best place so far. */
typedef struct Choice {
    Caption caption;
    double cost;
} Choice;

/* True if an optional label may not lie in the box because of what it hides there. */
static bool hides_too_much(const Places *places, const Primitive *label, Box box) {
    Box around = label->level ? box_expand(box, ROOM_AIR) : box;
    double most = (label->level ? ROOM_MOST : OPTIONAL_MOST) * box_width(around) * box_height(around);
    return label->optional && mask_cost(&places->mask, around) > most;
}

/* Skips the mask if `extra` alone exceeds the best cost. */
static void consider(Choice *best, const Places *places, const Primitive *label, Caption caption, double extra) {
    if (extra >= best->cost)
        return;
    Box box = caption_box(&caption);
    if (hides_too_much(places, label, box))
        return;
    double cost = mask_cost(&places->mask, box_expand(box, AIR)) + extra;
    if (cost >= best->cost || !is_free(places, box))
        return;
    *best = (Choice){caption, cost};
}

/* Considers places inside the outline, horizontal or turned; among equals the one nearest to `at` wins. */
static void consider_inside(Choice *best, const Places *places, const Primitive *label, Caption caption,
                            const Vec2 *outline, size_t count, Vec2 at) {
    Box box = box_empty();
    for (size_t i = 0; i < count; i++)
        box = box_include(box, outline[i]);
    for (int turned = 0; turned <= !label->level; turned++)
        for (int i = -1; i < RASTER * RASTER; i++) {
            Vec2 part = vec2((i % RASTER + 0.5) / RASTER, (double)(i / RASTER) / RASTER + 0.5 / RASTER);
            caption.turned = turned;
            caption.centre =
                i < 0 ? at : vec2(box.low.x + part.x * box_width(box), box.low.y + part.y * box_height(box));
            double away = turned * TURNED_COST + DISTANCE_COST * vec2_distance(caption.centre, at);
            if (away < best->cost && outline_holds_box(outline, count, box_expand(caption_box(&caption), AIR)))
                consider(best, places, label, caption, away);
        }
}

/* Considers the point itself and the places on the rings around it. */
static void consider_around(Choice *best, const Places *places, const Primitive *label, Caption caption, Vec2 at,
                            int rings) {
    caption.centre = at;
    if (label->shape == LABEL_DISC)
        consider(best, places, label, caption, 0);
    for (int ring = 0; ring < rings; ring++)
        for (int i = 0; i < DIRECTIONS; i++) {
            Vec2 way = vec2_heading(2 * M_PI * i / DIRECTIONS);
            double reach = GAP + ring * RING_STEP, away = DISTANCE_COST * reach;
            if (away >= best->cost)
                return;
            Vec2 step = {way.x * (reach + caption.extent.x / 2), way.y * (reach + caption.extent.y / 2)};
            caption.centre = vec2_add(at, step);
            double crossing = CROSSING_COST * mask_line_cost(&places->mask, at, caption.centre);
            consider(best, places, label, caption, away + crossing);
        }
}

static Caption label_caption(Layout *layout, const Primitive *label, Vec2 at, double size) {
    double widest = fmin(WIDEST, layout->frame.high.x - layout->frame.low.x - 2 * AIR);
    const char *text = caption_shortened(layout, label->text, size, label->bold, widest);
    Caption caption = {.text = arena_text(&layout->arena, text),
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

/* Chooses the best place: inside the label's outline, otherwise around its point. */
static Choice choose_place(const Places *places, const Primitive *label) {
    Choice best = {.cost = HUGE_VAL};
    Layout *layout = places->layout;
    Vec2 *points = to_page(layout, label);
    Caption caption = label_caption(layout, label, points[0], label->size);
    if (label->count > 1)
        consider_inside(&best, places, label, caption, points + 1, label->count - 1, points[0]);
    if (best.cost == HUGE_VAL && (label->count == 1 || (!label->optional && !label->close))) {
        caption.leader = label->leader;
        caption.fill = label->shape == LABEL_BARE ? ROLE_PAPER : caption.fill;
        consider_around(&best, places, label, caption, points[0], label->close ? 1 : RINGS);
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

/* True if the label is the name of a room or a piece, of which only as many are shown as the plan has room for. */
static bool is_name(const Primitive *label) {
    return label->count > 1 && (label->optional || label->close) && label->shape == LABEL_BARE;
}

static void place_label(Places *places, const Primitive *label) {
    Layout *layout = places->layout;
    if (is_away(layout, label) || (is_name(label) && !places->names))
        return;
    Choice best = choose_place(places, label);
    if (best.cost == HUGE_VAL)
        return;
    Box box = caption_box(&best.caption);
    places->names -= is_name(label);
    best.caption.leader &= vec2_distance(best.caption.centre, best.caption.pointed) > 1;
    if (best.caption.leader)
        mask_mark_line(&places->mask, best.caption.centre, best.caption.pointed, 2, 1);
    mask_mark_box(&places->mask, box, LABEL_WEIGHT);
    Caption *caption = caption_add(layout, best.caption.text, best.caption.size, best.caption.bold, (Vec2){0});
    *caption = best.caption;
}

/* Returns the label next to a point towards another one. */
static Caption beside(const Places *places, const Primitive *label, const char *text, size_t from, size_t to) {
    Layout *layout = places->layout;
    Primitive shown = *label;
    shown.text = text;
    Vec2 at = layout_raised(layout, label->points[from], label->base);
    Caption caption = label_caption(layout, &shown, at, label->size);
    Vec2 way = vec2_unit(vec2_sub(layout_raised(layout, label->points[to], label->base), at));
    Vec2 half = vec2_scale(caption.extent, 0.5);
    caption.centre = vec2_add(at, vec2(way.x * (half.x + GAP), way.y * (half.y + GAP)));
    return caption;
}

/* True if a box lies across the edge that a label keeps apart from. */
static bool is_across(const Layout *layout, const Primitive *label, Box box) {
    if (!box_width(label->apart))
        return false;
    Box apart = box_around(layout_point(layout, label->apart.low), 0);
    apart = box_include(apart, layout_point(layout, label->apart.high));
    return overlap(box, apart) && !(box_holds(apart, box.low) && box_holds(apart, box.high));
}

/* Moves a caption into the frame and below the texts above the plan. */
static void clamp_to_view(const Layout *layout, Caption *caption) {
    clamp_within(caption, (Box){{layout->frame.low.x, layout->plan.low.y - AIR}, layout->frame.high});
}

/* True if the caption of a label hides nothing where it stands. */
static bool stands_free(const Places *places, const Primitive *label, const Caption *caption) {
    Box box = caption_box(caption);
    return is_free(places, box) && !is_across(places->layout, label, box);
}

static double distance_to(Box box, Vec2 p) {
    return vec2_distance(p, vec2(real_clamp(p.x, box.low.x, box.high.x), real_clamp(p.y, box.low.y, box.high.y)));
}

/* True if no other label with several places has its point nearer to the caption of a label than this one has. An
 * optional label may stand anywhere: its places say what it belongs to. */
static bool is_at_own_point(const Places *places, const Primitive *label, const Caption *caption) {
    Box box = caption_box(caption);
    double own = distance_to(box, caption->pointed);
    for (size_t i = 0; !label->optional && i < places->scene->count; i++) {
        const Primitive *other = &places->scene->primitives[i];
        if (other->kind == PRIMITIVE_LABEL && other->fixed && other->count > 2 && other != label &&
            distance_to(box, layout_raised(places->layout, other->points[0], other->base)) < own)
            return false;
    }
    return true;
}

/* True if the caption of a label is free at a place, or after a move into the view that leaves its point bare. */
static bool fits_place(const Places *places, const Primitive *label, Caption *caption) {
    Vec2 place = caption->centre;
    clamp_to_view(places->layout, caption);
    return vec2_distance(caption->centre, place) <= GAP && stands_free(places, label, caption);
}

/* Finds the first free place of a label with several; false: there is none. */
static bool find_place(const Places *places, const Primitive *label, const char *text, Caption *caption) {
    for (size_t i = 1; text && i + 1 < label->count; i += 2) {
        *caption = beside(places, label, text, i, i + 1);
        caption->pointed = layout_raised(places->layout, label->points[0], label->base);
        if (fits_place(places, label, caption) && is_at_own_point(places, label, caption))
            return true;
    }
    return false;
}

/* Finds the free place nearest to the point of a label whose own places are all taken, if possible where no other
 * label's point is nearer, and in the direction of its first place; false: there is none. */
static bool find_nearby(const Places *places, const Primitive *label, const char *text, Caption *caption) {
    const Layout *layout = places->layout;
    Vec2 from = layout_raised(layout, label->points[1], label->base);
    Vec2 towards = vec2_sub(layout_raised(layout, label->points[2], label->base), from);
    Primitive shown = *label;
    shown.text = text;
    *caption = label_caption(places->layout, &shown, layout_raised(layout, label->points[0], label->base), label->size);
    Vec2 at = caption->pointed, half = vec2_scale(caption->extent, 0.5);
    for (int i = 0; i < 2 * RINGS * DIRECTIONS; i++) {
        int ring = i / DIRECTIONS % RINGS, turn = i % DIRECTIONS;
        int steps = turn % 2 ? (turn + 1) / 2 : -turn / 2; /* to both sides of the direction in turn */
        Vec2 way = vec2_heading(atan2(towards.y, towards.x) + 2 * M_PI * steps / DIRECTIONS);
        double reach = GAP + ring * RING_STEP;
        caption->centre = vec2_add(at, vec2(way.x * (half.x + reach), way.y * (half.y + reach)));
        bool second_round = i >= RINGS * DIRECTIONS;
        if (fits_place(places, label, caption) && (second_round || is_at_own_point(places, label, caption)))
            return true;
    }
    return false;
}

/* Returns the caption of a label on its point, with smaller letters where it would be too wide. */
static Caption caption_on_point(Layout *layout, const Primitive *label, Vec2 at) {
    Caption caption = label_caption(layout, label, at, label->size);
    Box box = caption_box(&caption);
    double part = label->widest > 0 ? fmin(label->widest * layout->metre / box_width(box), 1) : 1;
    return part < 1 ? label_caption(layout, label, at, label->size * fmax(part, LABEL_SMALLEST)) : caption;
}

/* Places a label on its point or next to it, within the frame and below the texts above the plan. */
static void place_fixed(Places *places, const Primitive *label) {
    Layout *layout = places->layout;
    if (is_away(layout, label))
        return;
    Vec2 at = layout_raised(layout, label->points[0], label->base);
    Caption caption =
        label->count == 2 ? beside(places, label, label->text, 0, 1) : caption_on_point(layout, label, at);
    const char *brief = label->brief ? label->brief : label->text;
    if (label->count > 2 && !find_place(places, label, label->text, &caption) &&
        !find_place(places, label, label->brief, &caption) &&
        (label->optional || !find_nearby(places, label, brief, &caption)))
        caption = beside(places, label, brief, 1, 2);
    clamp_to_view(layout, &caption);
    if (label->optional && !stands_free(places, label, &caption))
        return;
    *caption_add(layout, caption.text, caption.size, caption.bold, at) = caption;
}

static bool has_free_labels(const Scene *scene) {
    for (size_t i = 0; i < scene->count; i++)
        if (scene->primitives[i].kind == PRIMITIVE_LABEL && !scene->primitives[i].fixed)
            return true;
    return false;
}

void labels_place(Layout *layout, const Layout *under, const Scene *scene) {
    Places places = {.layout = layout, .under = under, .scene = scene};
    size_t fixed = layout->caption_count;
    for (size_t i = 0; i < scene->count; i++)
        if (scene->primitives[i].kind == PRIMITIVE_LABEL && scene->primitives[i].fixed &&
            !(scene->quiet && scene->primitives[i].note))
            place_fixed(&places, &scene->primitives[i]);
    if (!has_free_labels(scene))
        return;
    mask_init(&places.mask, layout->plan);
    places.names = (size_t)(box_width(layout->plan) * box_height(layout->plan) / NAME_AREA);
    for (size_t i = fixed; i < layout->caption_count; i++)
        mask_mark_box(&places.mask, caption_box(&layout->captions[i]), LABEL_WEIGHT);
    for (size_t i = 0; i < scene->count; i++)
        if (scene->primitives[i].keep_clear > 0)
            mark_primitive(&places.mask, layout, &scene->primitives[i]);
    for (size_t i = 0; i < scene->count; i++)
        if (scene->primitives[i].kind == PRIMITIVE_LABEL && !scene->primitives[i].fixed)
            place_label(&places, &scene->primitives[i]);
    mask_clear(&places.mask);
}
