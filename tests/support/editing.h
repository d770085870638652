/* A house that is edited in a session, by a pointer and keys. */
#pragma once

#include "laboratory/edit/editor.h"
#include "laboratory/house/session.h"

#define EDITING_REACH 0.05 /* m, of the pointer */

/* A house file: a room of 4 m by 3 m with a door, an exit below it, a person on a route, a wardrobe and the room's
 * outline. */
extern const char editing_small_house[];

/* Opens houses/NAME.json; NULL: a new house. The session is closed with `close`. */
void *editing_open(const char *name);

/* Opens a house file of this text, and waits for its run. */
void *editing_open_text(const char *text);

/* Returns a pointer at a place, m. */
Pointer editing_pointer(double x, double y);

/* Move the pointer, press and release its button, at a place, m. */
void editing_move(void *session, double x, double y);
void editing_press(void *session, double x, double y);
void editing_release(void *session, double x, double y);
void editing_click(void *session, double x, double y);
void editing_drag(void *session, double x, double y, double to_x, double to_y);

/* Types characters one by one; | is Enter, > is Tab, < is Backspace, ~ is Escape. */
void editing_keys(void *session, const char *text);

/* Sets a number; false: it was refused. */
bool editing_set(void *session, const char *name, double value);

/* Returns a copy of the house's text; memory_free it. */
char *editing_text(void *session);

/* Undoes all steps, checks that this restores the text, releases the text and closes the session. */
void editing_undo_all(void *session, char *before);

/* Prints the faults, clears them, and returns `good`. */
bool editing_succeeds(bool good, Fault *fault);
