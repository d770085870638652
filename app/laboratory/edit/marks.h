/* The marks of a gesture: lines, lengths, handles, snaps, gaps. */
#pragma once

#include "laboratory/edit/editor_state.h"

/* Add marks to the displayed gesture; all places are m. */
void edit_marks_line(Editor *edit, Vec2 from, Vec2 to);
void edit_marks_outline(Editor *edit, const Vec2 *points, size_t count);
void edit_marks_length(Editor *edit, Vec2 from, Vec2 to);
void edit_marks_piece(Editor *edit, const Furniture *piece); /* also marks the free space around the piece */
void edit_marks_door(Editor *edit, const Plan *plan, const Door *door);
void edit_marks_exit(Editor *edit, Vec2 from, Vec2 to); /* a band */
void edit_marks_ring(Editor *edit, const Vec2 *points, size_t count, const char *text);
void edit_marks_start(Editor *edit, Vec2 at); /* the first point of what is drawn */
void edit_marks_place(Editor *edit, Vec2 at); /* the place that arrows move */
void edit_marks_snap(Editor *edit);           /* the snap of the gesture's target */
void edit_marks_dragged(Editor *edit);        /* the dragged item */

/* Makes all marks, with those of the preview (NULL: none), and those that `rest` adds; `idle` is the text while there
 * is no gesture. The result is valid until the next call. */
const GestureView *edit_marks_make(Editor *edit, const EditPreview *preview, void (*rest)(Editor *edit),
                                   const char *idle);
