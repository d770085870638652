/* The items that tools can place: furniture of the catalogue, people of the profiles, kinds of doors. */
#pragma once

#include "laboratory/edit/editor_state.h"

/* Reads the catalogue and the names of the profiles, once. */
void edit_tool_items_stock(Editor *edit);
void edit_tool_items_clear(Editor *edit);

/* Returns the rows of the present tool (count), valid until the next call. */
const CatalogueRow *edit_tool_items_list(Editor *edit, size_t *count);
