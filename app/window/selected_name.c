#include "window/selected_name.h"

#include <math.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>

#include "draw/caption.h"

/* Design points. */
#define PAD 5.0
#define BESIDE 4.0 /* from the outline */
#define ASIDE 16.0 /* from it where the places beside it are taken, */
#define FAR 24.0   /* but no farther from its middle */
#define EDGE 8.0   /* of the view */

#define END 12.0 /* of a shifted label, over the thing */

enum { SHIFTS = 9, BRIEFS = 4 /* shorter forms of a name */, PLACES_MOST = 3 * SHIFTS + 2, OTHERS_MOST = 64 };

static bool overlap(Box a, Box b) {
    return a.low.x < b.high.x && b.low.x < a.high.x && a.low.y < b.high.y && b.low.y < a.high.y;
}

static Box on_page(const Window *window, const Caption *caption) {
    Box box = caption_box(caption);
    return (Box){vec2_add(box.low, window->frame.view.low), vec2_add(box.high, window->frame.view.low)};
}

/* True if the box lies in the view and over none of the texts there. */
static bool is_free(const Window *window, const ViewLayers *layers, Box box) {
    Box view = box_expand(window->frame.view, -EDGE);
    const Layout *layouts[] = {&layers->still, &layers->moving};
    if (!box_holds(view, box.low) || !box_holds(view, box.high) || overlap(box, window->note))
        return false;
    for (int l = 0; l < 2; l++)
        for (size_t i = 0; i < layouts[l]->caption_count; i++)
            if (overlap(box, on_page(window, &layouts[l]->captions[i])))
                return false;
    return true;
}

/* True if the picture has this name at the thing, as signs do: "EXIT porch until 7 s". */
static bool is_written(const Window *window, const ViewLayers *layers, Box thing, const char *name) {
    const Layout *layout = &layers->still;
    size_t length = strlen(name);
    for (size_t i = 0; i < layout->caption_count; i++) {
        const char *text = layout->captions[i].text;
        bool same = strcmp(text, name) == 0;
        bool sign = !same && strncasecmp(text, name, length) == 0 && (!text[length] || text[length] == ' ');
        if ((same || sign) && overlap(box_expand(thing, sign ? ASIDE : BESIDE), on_page(window, &layout->captions[i])))
            return true;
    }
    return false;
}

/* True if a place lies within an outline, whose parts have a point that is not a number between them. */
static bool holds(const Vec2 *points, size_t count, Vec2 at) {
    bool inside = false;
    for (size_t i = 0, begin = 0; i < count; i++) {
        bool last = i + 1 == count || isnan(points[i + 1].x);
        Vec2 a = points[i], b = points[last ? begin : i + 1];
        inside ^= (a.y > at.y) != (b.y > at.y) && at.x < a.x + (at.y - a.y) / (b.y - a.y) * (b.x - a.x);
        if (last)
            begin = (i += 1) + 1;
    }
    return inside;
}

/* Returns the box round the longest straight side of an outline. */
static Box longest_side(const Vec2 *points, size_t count) {
    Box longest = box_empty();
    double length = -1;
    for (size_t i = 1; i < count; i++)
        if (vec2_distance(points[i - 1], points[i]) > length) {
            length = vec2_distance(points[i - 1], points[i]);
            longest = box_include(box_include(box_empty(), points[i - 1]), points[i]);
        }
    return longest;
}

/* Returns the box round the selected thing in the view, or round its longest side where nothing of it lies in the
 * middle, as of walls round a house; empty: nothing is selected. */
static Box selected_box(const Window *window, const Tab *tab, Item item) {
    Vec2 points[LABORATORY_OUTLINE_MOST];
    size_t count = item.kind ? tab->laboratory->outline(tab->session, item, tab_time(tab), points) : 0;
    Box box = box_empty();
    for (size_t i = 0; i < count; i++) {
        points[i] = vec2_add(window->frame.view.low, view_layers_point(&tab->view_layers, points[i]));
        box = box_include(box, points[i]);
    }
    bool solid = !count || holds(points, count, vec2_scale(vec2_add(box.low, box.high), 0.5));
    return solid ? box : longest_side(points, count);
}

/* Returns the box of a label about a middle, moved sideways into the view. */
static Box around(const Window *window, Vec2 middle, Vec2 size) {
    Box view = box_expand(window->frame.view, -EDGE);
    Vec2 half = vec2_scale(size, 0.5);
    middle.x = fmax(fmin(middle.x, view.high.x - half.x), view.low.x + half.x);
    return (Box){vec2_sub(middle, half), vec2_add(middle, half)};
}

static double distance(Box box, Vec2 at) {
    return fmax(fmax(fmax(box.low.x - at.x, at.x - box.high.x), fmax(box.low.y - at.y, at.y - box.high.y)), 0);
}

/* Lists the middles of the other things of that kind. */
static size_t list_others(const Window *window, const Tab *tab, Item item, Vec2 others[OTHERS_MOST]) {
    size_t count = 0;
    for (size_t i = 0; count < OTHERS_MOST; i++) {
        Box box = i == item.index ? box_empty() : selected_box(window, tab, (Item){item.kind, i});
        if (box_width(box) >= 0)
            others[count++] = vec2_scale(vec2_add(box.low, box.high), 0.5);
        else if (!*tab->laboratory->item_name(tab->session, (Item){item.kind, i}))
            break;
    }
    return count;
}

/* True if the label is nearer to its own thing than to any other of that kind. */
static bool is_nearest(Box label, Vec2 own, const Vec2 *others, size_t count) {
    double apart = distance(label, own);
    for (size_t i = 0; i < count; i++)
        if (distance(label, others[i]) <= apart)
            return false;
    return true;
}

/* Lists places for a label, `gap` from the thing: beside it where it is long, over its middle last; above and below
 * also shifted, so that only the label's end stands there. Returns their number. */
static size_t list_places(Box thing, double gap, Vec2 size, Vec2 places[PLACES_MOST]) {
    static const double shifts[SHIFTS] = {0, 1, -1, 0.5, -0.5, 0.25, -0.25, 0.75, -0.75};
    Vec2 middle = vec2_scale(vec2_add(thing.low, thing.high), 0.5), half = vec2_scale(size, 0.5);
    bool tall = box_height(thing) > box_width(thing);
    double shift = fmax(half.x - END, 0);
    size_t count = 0;
    for (int part = 0; part < 3; part++) {
        bool beside = part == (tall ? 0 : 1), above = part == (tall ? 1 : 0);
        for (int side = 0; side < 2 && beside; side++)
            places[count++] = vec2(side ? thing.low.x - gap - half.x : thing.high.x + gap + half.x, middle.y);
        for (int s = 0; s < SHIFTS && above; s++) {
            double x = middle.x + shift * shifts[s];
            places[count++] = vec2(x, thing.low.y - gap - half.y);
            places[count++] = vec2(x, thing.high.y + gap + half.y);
        }
        for (int s = 0; s < SHIFTS && part == 2; s++)
            places[count++] = vec2(middle.x + shift * shifts[s], middle.y);
    }
    return count;
}

/* Places and shows a name at the selected thing; false: there is no room for it. */
static bool show_name(Window *window, Tab *tab, Item item, Box thing, const char *name) {
    Vec2 size = vec2_add(ui_extent(window->ui, UI_BOLD, name), vec2(2 * PAD, 2));
    Vec2 places[2 * PLACES_MOST], others[OTHERS_MOST], middle = vec2_scale(vec2_add(thing.low, thing.high), 0.5);
    size_t near_count = list_places(thing, BESIDE, size, places);
    size_t place_count = near_count + list_places(thing, ASIDE, size, places + near_count);
    size_t other_count = list_others(window, tab, item, others);
    for (size_t i = 0; i < place_count; i++) {
        Box box = around(window, places[i], size);
        bool is_far = i >= near_count && distance(box, middle) > FAR;
        if (is_far || !overlap(box, box_expand(thing, ASIDE + 1)) || !is_free(window, &tab->view_layers, box) ||
            !is_nearest(box, middle, others, other_count))
            continue;
        ui_draw_box(window->ui, box, ROLE_TEXT, 1);
        ui_draw_text(window->ui, UI_BOLD, ROLE_PAPER, vec2(box.low.x + PAD, places[i].y), 0, name);
        SelectedName *shown = &window->selected_name;
        shown->box = box;
        shown->pointed = middle;
        snprintf(shown->text, sizeof shown->text, "%s", name);
        return true;
    }
    return false;
}

/* Returns a name without the numbers in it: "bedroom door" of "bedroom 1 door". */
static const char *without_numbers(Window *window, const char *name) {
    char *text = arena_allocate(&window->arena, strlen(name) + 1), *to = text;
    while (*name) {
        size_t digits = *name == ' ' ? strspn(name + 1, "0123456789") : 0;
        if (digits && (name[digits + 1] == ' ' || !name[digits + 1]))
            name += digits + 1;
        else
            *to++ = *name++;
    }
    return text;
}

/* Lists shorter names for where there is little room: "washroom door", "bath door" and "door" of "washroom door to
 * bath", "washing machine" of "washing machine (f3)". Returns their number. */
static size_t list_briefs(Window *window, const char *name, const char *briefs[BRIEFS]) {
    static const char door[] = " door to ";
    const char *to = strstr(name, door), *id = strstr(name, " (");
    size_t count = 0;
    if (to) {
        briefs[count++] = text_in_arena(&window->arena, "%.*s door", (int)(to - name), name);
        briefs[count++] = text_in_arena(&window->arena, "%s door", to + strlen(door));
    } else if (id) {
        briefs[count++] = text_in_arena(&window->arena, "%.*s", (int)(id - name), name);
    }
    briefs[count] = without_numbers(window, count ? briefs[count - 1] : name);
    count++;
    if (strstr(name, " door"))
        briefs[count++] = "door";
    return count;
}

void selected_name_show(Window *window) {
    Tab *tab = window_tab(window);
    Item item = tab->laboratory->selected(tab->session);
    *window->selected_name.text = 0;
    if (!item.kind || !tab->view_layers.painted || box_height(window->frame.view) <= 0)
        return;
    const char *name = text_in_arena(&window->arena, "%s", tab->laboratory->item_name(tab->session, item));
    Box thing = selected_box(window, tab, item);
    if (!*name || !(box_width(thing) >= 0) || is_written(window, &tab->view_layers, thing, name))
        return;
    const char *briefs[BRIEFS];
    size_t count = list_briefs(window, name, briefs);
    bool shown = show_name(window, tab, item, thing, name);
    for (size_t i = 0; i < count && !shown; i++)
        shown = show_name(window, tab, item, thing, briefs[i]);
}
