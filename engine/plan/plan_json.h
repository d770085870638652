/* Elements of a house file as JSON values: what a draft does with any of them alike. Values are borrowed, and those
 * that are given back are new. */
#pragma once

#include <jansson.h>
#include <stdbool.h>
#include <stddef.h>

#include "base/fault.h"
#include "base/vec2.h"

/* The text of a member, or "". */
const char *plan_json_text(const json_t *element, const char *member);

/* A point and a list of points, as a file has them. */
json_t *plan_json_point(Vec2 point);
json_t *plan_json_points(const Vec2 *points, size_t count);

/* The element, `by` m farther; a door stays where it is on its wall. */
json_t *plan_json_moved(const json_t *element, Vec2 by);

/* The element with another member (steals the value; NULL: without the member). */
json_t *plan_json_with(const json_t *element, const char *member, json_t *value);

/* The element with `to` wherever it names `from`: as its id, its wall, its exit, among its people. NULL `to`: without
 * that name. The same value again where it does not name it. */
json_t *plan_json_renamed(json_t *element, const char *from, const char *to);

/* Is this a list of texts that has nothing in it? */
bool plan_json_is_empty(const json_t *list);

/* The pieces of a clipboard: an object of lists of elements, each an object with an id. NULL: faults say what it is
 * not.
 */
json_t *plan_json_read(const char *text, Fault *fault);
