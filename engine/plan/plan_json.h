/* Elements of a house file as JSON values: operations of a draft that are common to all kinds. Arguments are borrowed,
 * and results are new. */
#pragma once

#include <jansson.h>
#include <stdbool.h>
#include <stddef.h>

#include "base/fault.h"
#include "base/vec2.h"

/* Returns the text of a member, or "". */
const char *plan_json_text(const json_t *element, const char *member);

/* Return a point and a list of points in the form of a file. */
json_t *plan_json_point(Vec2 point);
json_t *plan_json_points(const Vec2 *points, size_t count);

/* Returns the element displaced by `by` m; a door stays where it is on its wall. */
json_t *plan_json_moved(json_t *element, Vec2 by);

/* Returns the element with a member replaced (steals the value; NULL: without the member). */
json_t *plan_json_with(json_t *element, const char *member, json_t *value);

/* Returns the element with every reference to `from` replaced by `to`: as its id, its wall, its exit, among its people.
 * NULL `to`: without that name. Returns the same value if there is no reference. */
json_t *plan_json_renamed(json_t *element, const char *from, const char *to);

/* True if this is an empty list. */
bool plan_json_is_empty(const json_t *list);

/* Reads the pieces of a clipboard: an object of lists of elements, each an object with an id. NULL: an error. */
json_t *plan_json_read(const char *text, Fault *fault);
