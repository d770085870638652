/* Sound by SDL: one voice, mono, without clicks where it begins, ends or runs dry. Without a device there is a plain
 * sentence and silence. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

typedef struct Sound Sound;

enum {
    SOUND_RATE = 44100, /* samples a second */
    SOUND_MESSAGE = 200,
};

/* NULL: `message` says why there is none. */
Sound *sound_open(char message[SOUND_MESSAGE]);

/* Ends with what is queued faded out; NULL is none. */
void sound_close(Sound *sound);

/* How many samples are wanted now, so that it does not run dry before the next frame but follows what is shown. */
size_t sound_room(Sound *sound);

/* Queues samples, -1 to 1 (what is louder is cut, what is no number is silence); what has no room is left out. */
void sound_feed(Sound *sound, const float *samples, size_t count);

/* Fades out and forgets what is queued: paused, or gone to another time. */
void sound_hush(Sound *sound);
