/* Pieces of a draft on a clipboard. */
#pragma once

#include "plan/draft.h"

/* Pieces of a house as text, for a clipboard: {"format": "clearance-pieces", "version": 1, "walls": [...], ...} of the
 * elements with these ids (id_count), with the doors of walls. New; memory_free it. NULL: there are none. */
char *draft_clip_copy(const Draft *draft, const char *const *ids, size_t id_count);

/* Adds pieces, moved by so much, with new ids, in an open step. Their ids go to `ids` (a new array of texts that live
 * as long as the elements; memory_free the array). False: faults say what is wrong with the text, nothing has changed.
 */
bool draft_clip_paste(Draft *draft, const char *text, Vec2 by, const char ***ids, size_t *id_count, Fault *fault);
