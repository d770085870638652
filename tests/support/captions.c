#include "captions.h"

#include <string.h>

bool captions_overlap(Box a, Box b) {
    return a.low.x < b.high.x && b.low.x < a.high.x && a.low.y < b.high.y && b.low.y < a.high.y;
}

const Caption *captions_find(const Layout *layout, const char *text) {
    for (size_t i = 0; i < layout->caption_count; i++)
        if (strcmp(layout->captions[i].text, text) == 0)
            return &layout->captions[i];
    return NULL;
}
