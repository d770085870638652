/* Sound by SDL: one mono voice, without clicks where it begins, ends or runs dry. Without a device there is a message
 * and silence. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

typedef struct Sound Sound;

enum {
    SOUND_RATE = 44100, /* samples a second */
    SOUND_MESSAGE = 200,
};

/* Opens the device. NULL: `message` says why there is none. */
Sound *sound_open(char message[SOUND_MESSAGE]);

/* Fades the queued samples out and closes the device; NULL is allowed. */
void sound_close(Sound *sound);

/* Returns how many samples to feed now: enough to last until the next frame, few enough to follow the view. */
size_t sound_room(Sound *sound);

/* Queues samples, -1 to 1 (louder ones are clipped, NAN is silence); those beyond the capacity are dropped. */
void sound_feed(Sound *sound, const float *samples, size_t count);

/* Fades out and drops the queued samples, for a pause or a jump in time. */
void sound_hush(Sound *sound);
