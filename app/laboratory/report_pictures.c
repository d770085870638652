#include "laboratory/report_pictures.h"

/* Design points: with these widths letters are as large in all pictures of a page. */
#define WIDTH 1027.0
#define WIDTH_OF_TWO 498.0
#define HIGHEST 1000.0
#define NARROWEST 360.0

#define FAR_WIDER 2.2 /* 1, width by height from which on pictures stand one below the other */

static Vec2 size_of(Box box, double width) {
    double ratio = (box.high.y - box.low.y) / (box.high.x - box.low.x);
    return width * ratio <= HIGHEST ? vec2(width, width * ratio) : vec2(fmax(HIGHEST / ratio, NARROWEST), HIGHEST);
}

void report_pictures_add(Document *document, Scene *scene, const char *caption, const char *alternative) {
    Vec2 size = size_of(scene->box, WIDTH);
    scene->bare = true;
    document_add_figures(document);
    document_add_scene(document, scene, size, caption, alternative);
}

void report_pictures_add_beside(Document *document, Scene *scenes, size_t count, Box box, const char *const *captions) {
    bool below = box.high.x - box.low.x > FAR_WIDER * (box.high.y - box.low.y);
    Vec2 size = size_of(box, below ? WIDTH : WIDTH_OF_TWO);
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
