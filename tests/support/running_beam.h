/* A session of the Beam laboratory that runs: opening, playing, and digests of what it displays. */
#pragma once

#include "laboratory/laboratory.h"

#if defined __SANITIZE_ADDRESS__ || defined __SANITIZE_THREAD__
#define RUNNING_BEAM_SANITIZED true
#else
#define RUNNING_BEAM_SANITIZED false
#endif

/* Opens assets/beams/NAME.json with settings (count); the session is closed with `close`. */
void *running_beam_open(const char *name, const char *const *settings, size_t count);

/* Displays a time, s, or the end of the record if the time cannot be reached. */
void running_beam_show_at(void *session, double time);

/* Updates and displays the times from `from` to `to` at steps, s. */
void running_beam_play(void *session, double from, double to, double step);

/* Returns the digest of the displayed layers. */
uint64_t running_beam_digest_picture(void *session);

/* Returns the index of a plot by its name. */
size_t running_beam_find_plot(const char *name);

/* Returns the digest of the points of a plot that are drawn at a time, s. */
uint64_t running_beam_digest_plot(void *session, const char *name, double time);
