#include "window/view_layers.h"

void view_layers_fit(ViewLayers *view_layers, const Gl *gl, int width, int height, double unit, Theme theme) {
    if (view_layers->paint && view_layers->width == width && view_layers->height == height &&
        view_layers->unit == unit && view_layers->theme == theme)
        return;
    view_layers_clear(view_layers);
    view_layers->width = width;
    view_layers->height = height;
    view_layers->unit = unit;
    view_layers->theme = theme;
    view_layers->paint = paint_gl_create(gl, width, height, unit, theme);
}

void view_layers_clear(ViewLayers *view_layers) {
    if (view_layers->paint)
        paint_gl_destroy(view_layers->paint);
    layout_clear(&view_layers->still);
    layout_clear(&view_layers->added);
    layout_clear(&view_layers->moving);
    *view_layers = (ViewLayers){0};
}

void view_layers_take(ViewLayers *view_layers, Box taken) {
    Box now = view_layers->taken;
    if (now.low.x == taken.low.x && now.low.y == taken.low.y && now.high.x == taken.high.x &&
        now.high.y == taken.high.y)
        return;
    view_layers->taken = taken;
    view_layers_invalidate(view_layers);
}

void view_layers_invalidate(ViewLayers *view_layers) {
    view_layers->painted = false;
}

/* Removes the discs of all dangerous places but the first. */
static void drop_dangers(Layout *layout) {
    size_t kept = 0;
    for (size_t i = 0; i < layout->caption_count; i++) {
        const Caption *caption = &layout->captions[i];
        bool later = caption->shape == LABEL_DISC && *caption->text >= '2' && *caption->text <= '9';
        if (!later)
            layout->captions[kept++] = *caption;
    }
    layout->caption_count = kept;
}

/* Lays a scene out over the still layer. */
static void lay_over(ViewLayers *view_layers, Layout *layout, const Scene *scene) {
    layout_make_over(layout, &view_layers->still, scene);
    if (view_layers->plain)
        drop_dangers(layout);
}

static void paint_still(ViewLayers *view_layers, const Scene *scene) {
    Scene shown = *scene;
    shown.taken = view_layers->taken;
    shown.unscaled |= view_layers->plain;
    shown.quiet = view_layers->plain;
    shown.grid = view_layers->plain ? 0 : shown.grid;
    layout_clear(&view_layers->still);
    layout_make(&view_layers->still, &shown,
                vec2(view_layers->width / view_layers->unit, view_layers->height / view_layers->unit));
    if (view_layers->plain)
        drop_dangers(&view_layers->still);
    paint_gl_still(view_layers->paint, (Layer){&shown, &view_layers->still});
    view_layers->painted = true;
}

/* Adds a layer to the picture. */
static void add_more(ViewLayers *view_layers, const Scene *scene) {
    if (!scene->count)
        return;
    lay_over(view_layers, &view_layers->added, scene);
    paint_gl_add(view_layers->paint, (Layer){scene, &view_layers->added});
}

void view_layers_show(ViewLayers *view_layers, const Laboratory *laboratory, void *session, double time) {
    if (view_layers->painted && laboratory->is_unchanged && laboratory->is_unchanged(session, time))
        return;
    if (!view_layers->painted) {
        paint_still(view_layers, laboratory->still(session));
        laboratory->show(session,
                         laboratory->span(session).begin); /* back to the beginning, so that `added` holds everything */
        add_more(view_layers, laboratory->added(session));
    }
    if (!laboratory->show(session, time))
        paint_gl_rewind(view_layers->paint);
    add_more(view_layers, laboratory->added(session));
    lay_over(view_layers, &view_layers->moving, laboratory->moving(session));
    paint_gl_frame(view_layers->paint, (Layer){laboratory->moving(session), &view_layers->moving});
}

Vec2 view_layers_floor(const ViewLayers *view_layers, Vec2 at) {
    return view_floor(&view_layers->still.view, at);
}

Vec2 view_layers_point(const ViewLayers *view_layers, Vec2 metres) {
    return layout_point(&view_layers->still, metres);
}
