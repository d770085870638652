#include "window/scenery.h"

void scenery_fit(Scenery *scenery, const Gl *gl, int width, int height, double unit, Theme theme) {
    if (scenery->paint && scenery->width == width && scenery->height == height && scenery->unit == unit &&
        scenery->theme == theme)
        return;
    scenery_clear(scenery);
    scenery->width = width;
    scenery->height = height;
    scenery->unit = unit;
    scenery->theme = theme;
    scenery->paint = paint_gl_create(gl, width, height, unit, theme);
}

void scenery_clear(Scenery *scenery) {
    if (scenery->paint)
        paint_gl_destroy(scenery->paint);
    layout_clear(&scenery->still);
    layout_clear(&scenery->added);
    layout_clear(&scenery->moving);
    *scenery = (Scenery){0};
}

void scenery_forget(Scenery *scenery) {
    scenery->painted = false;
}

static void paint_still(Scenery *scenery, const Scene *scene) {
    layout_clear(&scenery->still);
    layout_make(&scenery->still, scene, vec2(scenery->width / scenery->unit, scenery->height / scenery->unit));
    paint_gl_still(scenery->paint, (Layer){scene, &scenery->still});
    scenery->painted = true;
}

/* Lays the layer over what stays. */
static void add_more(Scenery *scenery, const Scene *scene) {
    if (!scene->count)
        return;
    layout_make_over(&scenery->added, &scenery->still, scene);
    paint_gl_add(scenery->paint, (Layer){scene, &scenery->added});
}

void scenery_show(Scenery *scenery, const LiveKind *kind, void *live, double time) {
    if (scenery->painted && kind->rests && kind->rests(live, time))
        return;
    if (!scenery->painted) {
        paint_still(scenery, kind->still(live));
        kind->show(live, kind->span(live).begin); /* back, so that what is added next is all of it */
        add_more(scenery, kind->added(live));
    }
    if (!kind->show(live, time))
        paint_gl_rewind(scenery->paint);
    add_more(scenery, kind->added(live));
    layout_make_over(&scenery->moving, &scenery->still, kind->moving(live));
    paint_gl_frame(scenery->paint, (Layer){kind->moving(live), &scenery->moving});
}

Vec2 scenery_floor(const Scenery *scenery, Vec2 at) {
    return view_floor(&scenery->still.view, at);
}

Vec2 scenery_point(const Scenery *scenery, Vec2 metres) {
    return layout_point(&scenery->still, metres);
}
