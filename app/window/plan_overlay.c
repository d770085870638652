#include "window/plan_overlay.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "draw/caption.h"
#include "window/plan_input.h"
#include "window/selected_name.h"

/* Design points. */
#define OUTER 6.0 /* of a frame of what is selected, and of what lies within it */
#define INNER 3.0
#define LINE 3.0
#define GUIDE 1.5
#define EXIT_LINE 8.0
#define GAP_LINE 4.0
#define DASH 7.0
#define DASH_GAP 5.0
#define TICK 6.0
#define DIAMOND 7.0
#define CROSS 14.0 /* half of the length of its lines */
#define HANDLE 6.0 /* half of its side */
#define PAD 5.0
#define EDGE 5.0   /* of the view, for the frame of what has the focus */
#define ASIDE 14.0 /* from the pointer */
#define HAND 30.0  /* from the pointer to the middle of what a click does */

enum { LABELS_MOST = 96, PLACES = 5 /* that a label tries */ };

/* Boxes of the labels placed so far, and of the picture's tags; no label covers another. */
typedef struct Labels {
    Box boxes[LABELS_MOST];
    size_t count;
} Labels;

static Vec2 on_page(const Window *window, const Tab *tab, Vec2 metres) {
    return vec2_add(window->frame.view.low, view_layers_point(&tab->view_layers, metres));
}

static size_t points_of(const Window *window, const Tab *tab, const EditMark *mark,
                        Vec2 points[LABORATORY_MARK_POINTS]) {
    for (size_t i = 0; i < mark->count; i++)
        points[i] = on_page(window, tab, mark->points[i]);
    return mark->count;
}

/* Small dialogs ---------------------------------------------------------------------------------------------------- */

static bool overlap(Box a, Box b) {
    return a.low.x < b.high.x && b.low.x < a.high.x && a.low.y < b.high.y && b.low.y < a.high.y;
}

static bool is_free(const Labels *labels, Box box) {
    for (size_t i = 0; i < labels->count; i++)
        if (overlap(labels->boxes[i], box))
            return false;
    return true;
}

/* Returns the box, moved so that it lies within another. */
static Box kept_within(Box box, Box bounds) {
    Vec2 by = {fmax(0, bounds.low.x - box.low.x) - fmax(0, box.high.x - bounds.high.x),
               fmax(0, bounds.low.y - box.low.y) - fmax(0, box.high.y - bounds.high.y)};
    return (Box){vec2_add(box.low, by), vec2_add(box.high, by)};
}

static void claim(Labels *labels, Box box) {
    if (labels->count < LABELS_MOST)
        labels->boxes[labels->count++] = box;
}

/* Claims the places of the note and of the picture's tags: exits, tight places and what is in the way stay readable
 * during a gesture.
 */
static void claim_tags(const Window *window, const ViewLayers *layers, Labels *labels) {
    const Layout *layouts[] = {&layers->still, &layers->moving};
    claim(labels, window->note);
    for (int l = 0; l < 2 && layers->painted; l++)
        for (size_t i = 0; i < layouts[l]->caption_count; i++) {
            Box box = caption_box(&layouts[l]->captions[i]);
            if (layouts[l]->captions[i].shape != LABEL_BARE)
                claim(labels,
                      (Box){vec2_add(box.low, window->frame.view.low), vec2_add(box.high, window->frame.view.low)});
        }
}

/* Claims the box round what is being dragged: the lengths stand about it. */
static void claim_dragged(const Window *window, const Tab *tab, const GestureView *gesture, Labels *labels) {
    Vec2 points[LABORATORY_MARK_POINTS];
    Box box = box_empty();
    for (size_t i = 0; i < gesture->mark_count && gesture->active; i++) {
        const EditMark *mark = &gesture->marks[i];
        size_t count = mark->kind == MARK_OUTLINE ? points_of(window, tab, mark, points) : 0;
        for (size_t p = 0; p < count; p++)
            box = box_include(box, points[p]);
    }
    if (box_width(box) >= 0)
        claim(labels, box_expand(box, HANDLE));
}

/* True if the picture has a name there, without a ground of its own. */
static bool hides_name(const Window *window, const ViewLayers *layers, Box box) {
    const Layout *layout = &layers->still;
    Box in_view = {vec2_sub(box.low, window->frame.view.low), vec2_sub(box.high, window->frame.view.low)};
    for (size_t i = 0; i < layout->caption_count && layers->painted; i++)
        if (layout->captions[i].shape == LABEL_BARE && overlap(in_view, caption_box(&layout->captions[i])))
            return true;
    return false;
}

/* True if a handle would hide letters of a tag, such as why somebody cannot pass; what is held is always seen. */
static bool hides_tag(const Window *window, const ViewLayers *layers, const EditMark *mark, Vec2 at) {
    const Layout *layouts[] = {&layers->still, &layers->moving};
    Box box = box_around(vec2_sub(at, window->frame.view.low), HANDLE + INNER);
    for (int l = 0; l < 2 && layers->painted && mark->kind == MARK_HANDLE && !mark->active; l++)
        for (size_t i = 0; i < layouts[l]->caption_count; i++)
            if (layouts[l]->captions[i].shape == LABEL_TAG && overlap(box, caption_box(&layouts[l]->captions[i])))
                return true;
    return false;
}

/* Steps down from a label's middle to its places, in heights of the label. */
static const double near_steps[PLACES] = {0, 1, -1, 2, -2};
static const double pointer_steps[PLACES] = {0, -1, -2, 3, 4}; /* but the places under the pointer */

/* Places a label at its middle, or above or below that if another label is there. Returns false if one is everywhere:
 * then the box is the last one that was tried. */
static bool place_label(const Window *window, const Labels *labels, Vec2 middle, const double steps[PLACES], Vec2 size,
                        Box *box) {
    Vec2 half = vec2_scale(size, 0.5);
    for (int i = 0; i < PLACES; i++) {
        Vec2 at = vec2_add(middle, vec2(0, steps[i] * (size.y + 2)));
        *box = kept_within((Box){vec2_sub(at, half), vec2_add(at, half)}, box_expand(window->frame.view, -EDGE));
        if (is_free(labels, *box))
            return true;
    }
    return false;
}

static Vec2 label_size(Window *window, const char *text) {
    return vec2_add(ui_extent(window->ui, UI_BOLD, text), vec2(2 * PAD, 2));
}

static void write_in(Window *window, Box box, Role ground, const char *text) {
    ui_draw_box(window->ui, box, ground, 1);
    ui_draw_text(window->ui, UI_BOLD, ROLE_PAPER, vec2(box.low.x + PAD, (box.low.y + box.high.y) / 2), 0, text);
}

/* Writes a label unless others are everywhere about its place. */
static void write_label(Window *window, Labels *labels, Vec2 middle, Role ground, const char *text) {
    Box box;
    if (!place_label(window, labels, middle, near_steps, label_size(window, text), &box))
        return;
    claim(labels, box);
    write_in(window, box, ground, text);
}

/* Lines ------------------------------------------------------------------------------------------------------------ */

/* Clips a line to a box; false: it lies outside. */
static bool clip(Box box, Vec2 *a, Vec2 *b) {
    Vec2 way = vec2_sub(*b, *a);
    const double p[] = {-way.x, way.x, -way.y, way.y};
    const double q[] = {a->x - box.low.x, box.high.x - a->x, a->y - box.low.y, box.high.y - a->y};
    double from = 0, to = 1;
    for (int i = 0; i < 4; i++) {
        if (p[i] == 0 && q[i] < 0)
            return false;
        if (p[i] < 0)
            from = fmax(from, q[i] / p[i]);
        if (p[i] > 0)
            to = fmin(to, q[i] / p[i]);
    }
    Vec2 begin = *a;
    *a = vec2_along(begin, from, way);
    *b = vec2_along(begin, to, way);
    return from < to;
}

static void draw_dashes(Window *window, Vec2 a, Vec2 b) {
    if (!clip(box_expand(window->frame.view, DASH), &a, &b))
        return;
    double length = vec2_distance(a, b);
    Vec2 way = vec2_scale(vec2_sub(b, a), 1 / fmax(length, 1e-9));
    for (double at = 0; at < length; at += DASH + DASH_GAP)
        ui_draw_line(window->ui, vec2_along(a, at, way), vec2_along(a, fmin(at + DASH, length), way), ROLE_TEXT, GUIDE);
}

static void draw_guide(Window *window, const Vec2 *points, size_t count) {
    for (size_t i = 0; i + 1 < count; i++)
        draw_dashes(window, points[i], points[i + 1]);
}

/* Draws a line in two colours, so that it is visible on any background. */
static void draw_twice(Window *window, const Vec2 *points, size_t count, bool closed, Role role, double width) {
    ui_draw_polyline(window->ui, points, count, closed, ROLE_PAPER, 2 * width);
    ui_draw_polyline(window->ui, points, count, closed, role, width);
}

/* Draws a cross with a free middle, so that what lies there stays visible. */
static void draw_cross(Window *window, Vec2 at) {
    for (int i = 0; i < 4; i++) {
        Vec2 way = vec2_heading(M_PI / 2 * i);
        const Vec2 arm[] = {vec2_along(at, CROSS / 4, way), vec2_along(at, CROSS, way)};
        draw_twice(window, arm, 2, false, ROLE_CHAIR, LINE);
    }
}

/* Draws a dimension line with an end mark at each of its points. */
static void draw_dimension(Window *window, const Vec2 *points, size_t count) {
    for (size_t i = 0; i + 1 < count; i++) {
        Vec2 way = vec2_sub(points[i + 1], points[i]);
        double length = vec2_length(way);
        if (length < 1)
            continue;
        Vec2 across = vec2_scale(vec2(-way.y, way.x), TICK / length);
        const Vec2 ends[] = {points[i], points[i + 1]};
        draw_twice(window, ends, 2, false, ROLE_TEXT, GUIDE);
        for (int end = 0; end < 2; end++)
            ui_draw_line(window->ui, vec2_sub(ends[end], across), vec2_add(ends[end], across), ROLE_TEXT, GUIDE);
    }
}

static void draw_handle(Window *window, const EditMark *mark, Vec2 at) {
    Role role = mark->active ? ROLE_CHAIR : ROLE_PAPER;
    if (mark->round) {
        ui_draw_disc(window->ui, at, HANDLE + 3, ROLE_PAPER);
        ui_draw_disc(window->ui, at, HANDLE + 1.5, ROLE_TEXT);
        ui_draw_disc(window->ui, at, HANDLE - 1, role);
        return;
    }
    const Vec2 half = {HANDLE, HANDLE};
    Box box = {vec2_sub(at, half), vec2_add(at, half)};
    ui_draw_box(window->ui, box_expand(box, 1.5), ROLE_PAPER, 1);
    ui_draw_box(window->ui, box, ROLE_TEXT, 1);
    ui_draw_box(window->ui, box_expand(box, -2), role, 1);
}

/* Marks ------------------------------------------------------------------------------------------------------------ */

static bool is_wrong(const GestureView *gesture) {
    return gesture->active ? gesture->refusal != NULL : gesture->preview_refused || gesture->preview_warns;
}

static void draw_mark(Window *window, const EditMark *mark, const Vec2 *points, size_t count, bool wrong) {
    switch (mark->kind) {
    case MARK_OUTLINE:
    case MARK_LINE:
        draw_twice(window, points, count, mark->kind == MARK_OUTLINE, wrong ? ROLE_ERROR : ROLE_CHAIR, LINE);
        break;
    case MARK_EXIT:
        draw_twice(window, points, count, false, ROLE_EXIT, EXIT_LINE);
        break;
    case MARK_RING:
        for (size_t i = 0; i < count; i += 2)
            draw_twice(window, (Vec2[]){points[i], points[(i + 1) % count]}, 2, false, ROLE_EXIT, GUIDE * 2);
        break;
    case MARK_SWING:
        draw_twice(window, points, count, false, ROLE_DOOR, GUIDE);
        break;
    case MARK_GUIDE:
        draw_guide(window, points, count);
        break;
    case MARK_DIMENSION:
        draw_dimension(window, points, count);
        break;
    case MARK_SNAP:
    case MARK_START:
        ui_draw_diamond(window->ui, points[0], DIAMOND + 2, ROLE_PAPER);
        ui_draw_diamond(window->ui, points[0], DIAMOND, ROLE_TEXT);
        break;
    case MARK_PLACE:
        draw_cross(window, points[0]);
        break;
    case MARK_HANDLE:
        draw_handle(window, mark, points[0]);
        break;
    case MARK_GAP:
        draw_twice(window, points, count, count > 2, ROLE_ERROR, GAP_LINE);
        break;
    }
}

/* Returns the offset from the middle of a line to the middle of its label, which lies next to the line. */
static Vec2 beside(Vec2 a, Vec2 b, double half) {
    Vec2 across = vec2_left(vec2_unit(vec2_sub(b, a)));
    if (across.y > 0 || (across.y == 0 && across.x < 0))
        across = vec2_scale(across, -1);
    return vec2(across.x * half, across.y * ASIDE * 1.3);
}

static Box around(Vec2 middle, Vec2 size) {
    Vec2 half = vec2_scale(size, 0.5);
    return (Box){vec2_sub(middle, half), vec2_add(middle, half)};
}

/* Writes the length of a line on either side of it or about its far end where no name stands, else at the nearest free
 * place, else over a name. */
static void write_length(Window *window, const Tab *tab, Labels *labels, const Vec2 *line, const char *text) {
    Vec2 size = label_size(window, text), way = vec2_unit(vec2_sub(line[1], line[0]));
    Vec2 middle = vec2_scale(vec2_add(line[0], line[1]), 0.5), off = beside(line[0], line[1], size.x / 2 + 2);
    Vec2 above = vec2_add(middle, off), below = vec2_sub(middle, off);
    Vec2 beyond = vec2_along(line[1], (fabs(way.x) * size.x + fabs(way.y) * size.y) / 2 + TICK, way);
    Vec2 aside = vec2_scale(vec2_left(way), (fabs(way.x) * size.y + fabs(way.y) * size.x) / 2);
    const Box places[] = {around(above, size), around(below, size), around(beyond, size),
                          around(vec2_add(beyond, aside), size), around(vec2_sub(beyond, aside), size)};
    enum { COUNT = sizeof places / sizeof *places };
    Box view = box_expand(window->frame.view, -EDGE), box;
    bool is_open[COUNT], placed = false;
    for (int i = 0; i < COUNT; i++) {
        is_open[i] = box_holds(view, places[i].low) && box_holds(view, places[i].high) && is_free(labels, places[i]);
        if (!placed && is_open[i] && !hides_name(window, &tab->view_layers, places[i])) {
            box = places[i];
            placed = true;
        }
    }
    placed = placed || place_label(window, labels, above, near_steps, size, &box);
    for (int i = 0; i < COUNT && !placed; i++)
        if (is_open[i]) {
            box = places[i];
            placed = true;
        }
    if (!placed)
        return;
    claim(labels, box);
    write_in(window, box, ROLE_TEXT, text);
}

static void write_mark(Window *window, const Tab *tab, Labels *labels, const EditMark *mark, const Vec2 *points,
                       size_t count) {
    if (mark->kind == MARK_DIMENSION && count == 2) {
        write_length(window, tab, labels, points, mark->text);
        return;
    }
    double width = ui_extent(window->ui, UI_BOLD, mark->text).x;
    Vec2 middle = vec2_scale(vec2_add(points[(count - 1) / 2], points[count / 2]), 0.5);
    if (mark->kind == MARK_SNAP || mark->kind == MARK_HANDLE)
        middle = vec2_add(points[0], vec2(width / 2 + PAD + ASIDE, -ASIDE));
    if (mark->kind == MARK_RING)
        middle = vec2_add(points[0], vec2(width / 2 + PAD + 2, 0));
    Role ground = mark->kind == MARK_GAP ? ROLE_ERROR : mark->kind == MARK_RING ? ROLE_EXIT_TAG : ROLE_TEXT;
    write_label(window, labels, middle, ground, mark->text);
}

/* Draws lines first, then handles, then labels; a length that is among the words at the pointer is not written again.
 */
static void show_marks(Window *window, Tab *tab, const GestureView *gesture, const char *words, Labels *labels) {
    Vec2 points[LABORATORY_MARK_POINTS];
    for (int pass = 0; pass < 3; pass++)
        for (size_t i = 0; i < gesture->mark_count; i++) {
            const EditMark *mark = &gesture->marks[i];
            bool solid = mark->kind == MARK_HANDLE || mark->kind == MARK_SNAP || mark->kind == MARK_START ||
                         mark->kind == MARK_PLACE;
            if (!mark->count || (pass < 2 && solid != (pass == 1)) || (pass == 2 && !(mark->text && *mark->text)))
                continue;
            size_t count = points_of(window, tab, mark, points);
            if (pass < 2 && !hides_tag(window, &tab->view_layers, mark, points[0]))
                draw_mark(window, mark, points, count, is_wrong(gesture));
            else if (pass == 2 && !(words && mark->kind == MARK_DIMENSION && strstr(words, mark->text)))
                write_mark(window, tab, labels, mark, points, count);
        }
}

/* The selection ---------------------------------------------------------------------------------------------------- */

/* Writes a layer's tags that tell why somebody cannot pass again where a frame crosses them. */
static void show_reasons(Window *window, const Layout *layer, Box frame) {
    for (size_t i = 0; i < layer->caption_count; i++) {
        const Caption *caption = &layer->captions[i];
        Box box = caption_box(caption);
        Vec2 low = window->frame.view.low, middle = vec2_add(caption->centre, low);
        box = (Box){vec2_add(box.low, low), vec2_add(box.high, low)};
        if (caption->shape != LABEL_TAG || caption->fill != ROLE_ERROR || !overlap(box, frame))
            continue;
        ui_draw_box(window->ui, box, ROLE_ERROR, 1);
        ui_draw_text(window->ui, UI_BOLD, ROLE_PAPER, middle, 0.5, caption->text);
    }
}

static void frame_item(Window *window, Tab *tab, Item item) {
    Vec2 points[LABORATORY_OUTLINE_MOST];
    size_t count = item.kind ? tab->laboratory->outline(tab->session, item, tab_time(tab), points) : 0;
    for (size_t i = 0; i < count; i++)
        points[i] = on_page(window, tab, points[i]);
    if (!count)
        return;
    Box frame = box_empty();
    for (int line = 0; line < 2; line++)
        for (size_t i = 0, end; i < count; i = end + 1) {
            for (end = i; end < count && !isnan(points[end].x);)
                end++;
            ui_draw_polyline(window->ui, points + i, end - i, true, line ? ROLE_TEXT : ROLE_PAPER,
                             line ? INNER : OUTER);
        }
    for (size_t i = 0; i < count; i++)
        frame = box_include(frame, points[i]);
    for (int layer = 0; layer < 2 && tab->view_layers.painted; layer++)
        show_reasons(window, layer ? &tab->view_layers.moving : &tab->view_layers.still, box_expand(frame, OUTER));
}

static void show_selection(Window *window, Tab *tab) {
    Editor *editor = tab_editor(tab);
    Item last = tab->laboratory->selected(tab->session);
    size_t count = 0;
    const Item *items = editor ? editor_selection(editor, &count) : NULL;
    bool framed = false;
    for (size_t i = 0; i < count; i++) {
        framed |= item_same(items[i], last);
        frame_item(window, tab, items[i]);
    }
    if (!framed)
        frame_item(window, tab, last);
}

/* Typed numbers ---------------------------------------------------------------------------------------------------- */

static const char *field_text(Window *window, const GestureView *gesture, size_t index) {
    const EditField *field = &gesture->fields[index];
    if (index == gesture->field && *gesture->typed)
        return text_in_arena(&window->arena, "%s %s|", field->name, gesture->typed);
    const char *cursor = index == gesture->field ? "|" : "";
    if (isnan(field->value))
        return text_in_arena(&window->arena, "%s %s", field->name, cursor);
    return text_in_arena(&window->arena, "%s %.*f %s%s%s", field->name, *field->unit == 'm' ? 3 : 1, field->value,
                         field->unit, field->typed && !field->moved ? " (typed)" : "", cursor);
}

/* Returns where the fields of the gesture are shown: next to the pointer, or in the view's corner without one, since
 * what is placed by keys is in its middle. */
static Vec2 read_out_at(const Window *window) {
    Vec2 at = vec2_scale(window->mouse, 1 / window->unit);
    Box view = window->frame.view;
    if (box_holds(view, at))
        return vec2_add(at, vec2(ASIDE, ASIDE));
    return vec2(view.low.x, view.high.y); /* kept within the view */
}

static bool has_pointer(const Window *window) {
    return box_holds(window->frame.view, vec2_scale(window->mouse, 1 / window->unit));
}

static bool is_typed(const GestureView *gesture) {
    for (size_t i = 0; i < gesture->field_count; i++)
        if (gesture->fields[i].typed)
            return true;
    return *gesture->typed || gesture->typed_error;
}

static void show_read_out(Window *window, const GestureView *gesture, Labels *labels) {
    if (!gesture->field_count || (!is_typed(gesture) && (has_pointer(window) || !gesture->active)))
        return;
    double width = 0, height = ui_extent(window->ui, UI_BOLD, "0").y + 2;
    for (size_t i = 0; i < gesture->field_count; i++)
        width = fmax(width, ui_extent(window->ui, UI_BOLD, field_text(window, gesture, i)).x);
    if (gesture->typed_error)
        width = fmax(width, ui_extent(window->ui, UI_BODY, gesture->typed_error).x);
    size_t lines = gesture->field_count + (gesture->typed_error ? 1 : 0);
    Vec2 at = read_out_at(window), size = {width + 2 * PAD, height * (double)lines + 2 * PAD};
    Box box = kept_within((Box){at, vec2_add(at, size)}, box_expand(window->frame.view, -EDGE));
    claim(labels, box);
    ui_draw_box(window->ui, box, ROLE_PANEL, 1);
    ui_draw_frame(window->ui, box, gesture->typed_error ? ROLE_ERROR : ROLE_TEXT, 2);
    double y = box.low.y + PAD + height / 2;
    for (size_t i = 0; i < gesture->field_count; i++, y += height) {
        bool now = i == gesture->field;
        ui_draw_text(window->ui, now ? UI_BOLD : UI_BODY, now ? ROLE_TEXT : ROLE_DIM_TEXT, vec2(box.low.x + PAD, y), 0,
                     field_text(window, gesture, i));
    }
    if (gesture->typed_error)
        ui_draw_text(window->ui, UI_BODY, ROLE_ERROR, vec2(box.low.x + PAD, y), 0, gesture->typed_error);
}

/* Returns what a click does, or why it does nothing; NULL: no words, or the pointer is elsewhere. */
static const char *preview_words(const Window *window, const GestureView *gesture) {
    return !has_pointer(window) ? NULL : gesture->active ? gesture->refusal : gesture->preview;
}

/* True if the picture has this name already. */
static bool is_written(const Layout *layout, const char *name) {
    for (size_t i = 0; i < layout->caption_count; i++)
        if (strcmp(layout->captions[i].text, name) == 0)
            return true;
    return false;
}

/* Returns the place under the pointer, m on the floor. */
static Vec2 floor_at(const Window *window, const Tab *tab) {
    Vec2 at = vec2_sub(vec2_scale(window->mouse, 1 / window->unit), window->frame.view.low);
    return view_layers_floor(&tab->view_layers, at);
}

/* Returns the thing under the pointer while nothing is being done. */
static Item hovered_item(const Window *window, Tab *tab, const GestureView *gesture) {
    const int left = SDL_WINDOW_EVENT_LEFT;
    if (!has_pointer(window) || window->dialog != DIALOG_NONE || gesture->active || window->input.down[left] ||
        editor_tool(tab_editor(tab)) != TOOL_SELECT || !tab->view_layers.painted)
        return (Item){0};
    return tab->laboratory->pick(tab->session, floor_at(window, tab), tab_time(tab), (Item){0});
}

/* Returns the name of a thing at a place; NULL: it is written on the plan. */
static const char *unwritten_name(const Tab *tab, Item item, Vec2 at) {
    const Laboratory *laboratory = tab->laboratory;
    const char *name =
        laboratory->name_at ? laboratory->name_at(tab->session, item, at) : laboratory->item_name(tab->session, item);
    return !is_written(&tab->view_layers.still, name) ? name : NULL;
}

void plan_overlay_show(Window *window) {
    Tab *tab = window_tab(window);
    Editor *editor = tab_editor(tab);
    Labels labels = {.count = 0};
    show_selection(window, tab);
    *window->selected_name.text = 0;
    if (!editor)
        return;
    const GestureView *gesture = editor_gesture(editor);
    show_read_out(window, gesture, &labels); /* reserves its place before labels are placed */
    const char *words = preview_words(window, gesture);
    Item hovered = hovered_item(window, tab, gesture), selected = tab->laboratory->selected(tab->session);
    const char *name = words ? NULL : hovered.kind ? unwritten_name(tab, hovered, floor_at(window, tab)) : NULL;
    snprintf(window->hovered, sizeof window->hovered, "%s", name ? name : "");
    words = words ? words : name ? window->hovered : NULL; /* a copy: other names are asked for below */
    Vec2 above = vec2_add(vec2_scale(window->mouse, 1 / window->unit), vec2(0, -HAND)); /* never under the pointer */
    Box box = box_empty();
    claim_tags(window, &tab->view_layers, &labels); /* first, so that no exit or person is hidden by a name */
    if (words) {
        place_label(window, &labels, above, pointer_steps, label_size(window, words), &box);
        claim(&labels, box);
    }
    bool tagged = name && hovered.kind == selected.kind && hovered.index == selected.index;
    if (!gesture->active && !window->present && editor_tool(editor) == TOOL_SELECT && !tagged)
        selected_name_show(window);
    if (editor_tool(editor) == TOOL_SELECT)
        claim_dragged(window, tab, gesture, &labels);
    show_marks(window, tab, gesture, words, &labels);
    if (words)
        write_in(window, box, is_wrong(gesture) ? ROLE_ERROR : ROLE_TEXT, words);
    show_read_out(window, gesture, &labels); /* drawn again, over the labels' lines */
}
