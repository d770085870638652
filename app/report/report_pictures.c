#include "report/report_pictures.h"

#include "visual/house/house_scene.h"

/* Design points: with these widths text has the same size in all pictures of a page. */
#define WIDTH 1027.0
#define WIDTH_OF_TWO 498.0
#define HIGHEST 1000.0
#define NARROWEST 360.0
#define FOOT 48.0 /* kept for the scale */

#define FAR_WIDER 2.2 /* 1, width by height above which pictures stand one below the other */

/* Adds room for the scale below the plan if the plan has no margin. */
static Box with_foot(Box box, double width) {
    double metre = width / box_width(box);
    box.low.y -= fmax(0, FOOT / metre - HOUSE_SCENE_MARGIN);
    return box;
}

static Vec2 size_of(Box box, double width) {
    double ratio = box_height(box) / box_width(box);
    return width * ratio <= HIGHEST ? vec2(width, width * ratio) : vec2(fmax(HIGHEST / ratio, NARROWEST), HIGHEST);
}

void report_pictures_add(Document *document, Scene *scene, const char *caption, const char *alternative) {
    scene->box = with_foot(scene->box, WIDTH);
    scene->bare = true;
    Vec2 size = size_of(scene->box, WIDTH);
    document_add_figures(document);
    document_add_scene(document, scene, size, caption, alternative);
}

void report_pictures_add_beside(Document *document, Scene *scenes, size_t count, Box box, const char *const *captions) {
    bool below = box_width(box) > FAR_WIDER * box_height(box);
    double width = below ? WIDTH : WIDTH_OF_TWO;
    box = with_foot(box, width);
    Vec2 size = size_of(box, width);
    for (size_t s = 0; s < count; s++) {
        if (below || s % 2 == 0)
            document_add_figures(document);
        scenes[s].box = box;
        scenes[s].bare = true;
        document_add_scene(document, &scenes[s], size, captions[s],
                           document_text(document, "Plan, seen from above. %s", captions[s]));
    }
}

Box report_pictures_box(Box a, Box b) {
    return box_include(box_include(a, b.low), b.high);
}
