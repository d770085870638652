/* A session of the House laboratory that runs: waits, choices, numbers and pictures of it. */
#pragma once

#include "laboratory/house/session.h"

/* Opens houses/NAME.json with settings (setting_count) and a route (NULL: all); the session is closed with `close`. */
void *running_house_open(const char *name, const char *const *settings, size_t setting_count, const char *route);

/* Closes a session, and checks that this does not wait for its work. */
void running_house_close_at_once(void *session);

/* Returns the time of a steady clock, s. */
double running_house_clock(void);

/* Lets other threads work for 2 ms. */
void running_house_rest(void);

/* Updates the session at a time, s, until no work remains; returns all change flags. */
unsigned running_house_finish(void *session, double time);

/* Finds an option of a choice: returns the index of the choice, and `place` is the index of the option. */
size_t running_house_find_choice(void *session, const char *name, const char *option, size_t *place);
void running_house_choose(void *session, const char *name, const char *option);

/* Sets a number; false: it was refused, and the reason is printed. */
bool running_house_set(void *session, const char *name, double value);

/* Returns the row of a number; NULL: none. */
const PanelParameter *running_house_parameter(void *session, const char *name);

/* Returns the digest of a run without a window; settings end with NULL, or are NULL. */
uint64_t running_house_digest_of(const char *name, const char *const *settings, const char *route, int driving);

/* Add the primitives of a scene as text. */
void running_house_add_scene(Text *text, const Scene *scene);

/* Returns the input of a painter as text: the whole static and moving layers. */
char *running_house_picture_at(void *session, double time);
