/* Functions of Laboratory for pictures in which nothing can be selected. */
#pragma once

#include "laboratory/laboratory.h"

Item machine_item_pick(const void *context, Vec2 at, double time, Item below);
Item machine_item_next(const void *context, Item item, int step);
void machine_item_select(void *context, Item item);
Item machine_item_selected(void *context);
const char *machine_item_name(void *context, Item item);
size_t machine_item_outline(void *context, Item item, double time, Vec2 *points);
