/* Turns mouse and key events into calls of the editor. */
#pragma once

#include "laboratory/edit/editor.h"
#include "window/window_state.h"

/* True during a gesture or with a tool other than Select: then letters and digits go to the editor. */
bool plan_input_listens(const Window *window);

/* Handles Return, Backspace, Tab and Escape while the editor listens; true if the key was used. */
bool plan_input_key(Window *window, const SdlWindowEvent *event);

/* Stores a key that types text until its text arrives, which the editor may use; false: it types none, or the editor
 * does not listen. plan_input_apply_text passes the text (NULL: none came) to the editor; false: handle the stored key
 * now. */
bool plan_input_store_key(Window *window, const SdlWindowEvent *event);
bool plan_input_apply_text(Window *window, const char *text);

/* Passes text without a key, as input methods send it, to the editor; true if it was used. */
bool plan_input_type(Window *window, const char *text);

/* Does an editing action; false: it is another action, or it concerns the view because nothing is selected. */
bool plan_input_do(Window *window, Action action, int mods);

/* Puts a place of the plan, m, in the middle of the view, and a tool's pointer there unless the mouse is on the view.
 */
void plan_input_look_at(Window *window, Tab *tab, Vec2 at);

/* Handles what the mouse has done over the view since the last frame. */
void plan_input_mouse(Window *window, const UiGrab *grab);

/* Begins to change a number by a slider: the whole drag is one step of undo. */
void plan_input_hold_number(Window *window, const char *name);

/* Pauses playback during a gesture; call it once per frame. */
void plan_input_hold_clock(Window *window);

/* Cancels the gesture and returns to the Select tool. */
void plan_input_reset(Window *window);

/* Advances the editor's animation by wall time, s, or by one frame if there is no display. */
void plan_input_animate(Window *window, double seconds);

/* Words for what moves so, or ""; NULL: nothing does. */
const char *plan_input_animation(const Tab *tab);

/* How the step would be called that is undone, or done, next: "Undo: Move wardrobe (f3)", "Can't undo". */
const char *plan_input_step_label(Window *window, Action action);
