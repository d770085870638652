/* What is done by mouse and keys to what can be edited: they become calls of its editor. */
#pragma once

#include "laboratory/edit/editor.h"
#include "window/window_state.h"

/* Is something in the hand, or a tool other than the one that selects? Then letters and digits are the editor's. */
bool plan_input_listens(const Window *window);

/* Return, Backspace, Tab, Escape while the editor listens; true: it was used. */
bool plan_input_key(Window *window, const SdlWindowEvent *event);

/* A key that types something waits for what it types, which may be the editor's; false: it types nothing, or nobody
 * listens. plan_input_apply_text gives the letters (NULL: none came) to the editor; false: the key that waited is to
 * be done now. */
bool plan_input_store_key(Window *window, const SdlWindowEvent *event);
bool plan_input_apply_text(Window *window, const char *text);

/* Letters that no key has announced, as an input method types them. */
bool plan_input_type(Window *window, const char *text);

/* False: the action is none of editing. */
bool plan_input_do(Window *window, Action action, int mods);

/* What the mouse has done over the view since the frame before. */
void plan_input_mouse(Window *window, const UiGrab *grab);

/* A number changes under the hand: all of it is one step. */
void plan_input_hold_number(Window *window, const char *name);

/* Once a frame: while something is in the hand the clock is held. */
void plan_input_hold_clock(Window *window);

/* Nothing is in the hand any more, and the tool is the one that selects. */
void plan_input_reset(Window *window);

/* Moves on what an edit has set moving: by so many s on the wall, or, without anybody to see it, by a frame. */
void plan_input_animate(Window *window, double seconds);

/* Words for what moves so, or ""; NULL: nothing does. */
const char *plan_input_animation(const Tab *tab);

/* How the step would be called that is undone, or done, next: "Undo: Move wardrobe (f3)", "Can't undo". */
const char *plan_input_step_label(Window *window, Action action);
