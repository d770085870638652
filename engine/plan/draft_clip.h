/* Copies and pastes pieces of a draft through a clipboard. */
#pragma once

#include "plan/draft.h"

/* Returns pieces of a house as text, for a clipboard: {"format": "clearance-pieces", "version": 1, "walls": [...], ...}
 * with the elements of these ids (id_count) and the doors of walls. New; memory_free it. NULL: none. */
char *draft_clip_copy(const Draft *draft, const char *const *ids, size_t id_count);

/* Adds pieces, displaced by `by`, with new ids, in an open step. Their ids go to `ids` (a new array of texts that live
 * as long as the elements; memory_free the array). Returns false after an error in the text, with the draft unchanged.
 */
bool draft_clip_paste(Draft *draft, const char *text, Vec2 by, const char ***ids, size_t *id_count, Fault *fault);
