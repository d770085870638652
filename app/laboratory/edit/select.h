/* The selection, stored by ids, which stay the same while the plan changes. */
#pragma once

#include "laboratory/edit/editor_state.h"

/* Synchronises the selected ids with `selected`, which the owner may have set. */
void edit_select_sync(Editor *edit);

/* Change the selection. */
void edit_select_only(Editor *edit, const char *id); /* id NULL: clears the selection */
void edit_select_toggle(Editor *edit, const char *id);
void edit_select_prune(Editor *edit); /* removes ids of removed items from the selection */
void edit_select_within(Editor *edit, Box box, bool more);
void edit_select_all(Editor *edit);

/* Returns what of the selection cannot be moved now, "walls"; NULL: all of it can be moved. */
const char *edit_select_fixed(const Editor *edit);

bool edit_select_has(const Editor *edit, const char *id);

/* Convert between items of the displayed house and ids; "" or an item of kind 0: there is none. */
const char *edit_select_id(const Editor *edit, Item item);
Item edit_select_item(const Editor *edit, const char *id);

/* Returns the id of the item at a place, m; NULL: none. */
const char *edit_select_at(Editor *edit, Vec2 at);

/* Writes the name of an element: "bedroom door", "wardrobe", "wall between bedroom and corridor"; the second one for
 * the part of a wall of this plan that is nearest to a place, m; NULL: for the whole element. */
void edit_select_name(const Editor *edit, const char *id, char name[EDIT_NAME]);
void edit_select_name_at(const Editor *edit, const Plan *plan, const char *id, const Vec2 *at, char name[EDIT_NAME]);

/* Writes the name of a snap target, as SnapNames. */
void edit_select_snap_name(const Plan *plan, const char *id, Vec2 at, char name[SNAP_NAME]);

/* Returns a text with the names in place of the ids of what is being edited; memory_free it. */
char *edit_select_named(const Editor *edit, const char *text);

/* Writes the name of the selection: as edit_select_name, or "5 items". */
void edit_select_names(const Editor *edit, char name[EDIT_NAME]);
