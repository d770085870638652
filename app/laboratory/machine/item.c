#include "laboratory/machine/item.h"

Item machine_item_pick(const void *context, Vec2 at, double time, Item below) {
    (void)context, (void)at, (void)time, (void)below;
    return (Item){0};
}

Item machine_item_next(const void *context, Item item, int step) {
    (void)context, (void)item, (void)step;
    return (Item){0};
}

void machine_item_select(void *context, Item item) {
    (void)context, (void)item;
}

Item machine_item_selected(void *context) {
    (void)context;
    return (Item){0};
}

const char *machine_item_name(void *context, Item item) {
    (void)context, (void)item;
    return "";
}

size_t machine_item_outline(void *context, Item item, double time, Vec2 *points) {
    (void)context, (void)item, (void)time, (void)points;
    return 0;
}
