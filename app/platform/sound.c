#include "platform/sound.h"

#include <SDL.h>
#include <math.h>
#include <stdio.h>

#include "base/memory.h"

enum {
    DEVICE = 1024,     /* samples per request of the device */
    WANTED = 4 * 1024, /* samples to keep queued: 93 ms, several frames of a slow machine */
    ROOM = 2 * WANTED,
    PATIENCE = 500, /* ms that the device may take to play the rest */
    FADE = 256,     /* samples: 6 ms, from silence to full and back */
};

struct Sound {
    SDL_AudioDeviceID device;
    float queue[ROOM];   /* a ring */
    size_t first, count; /* of the queued samples */
    float value;         /* the last sample taken from the queue */
    int gain;            /* 0 to FADE */
    bool falling;        /* fading to silence, whatever is queued */
};

/* Returns the next sample to play. If the queue runs dry, the last sample is held and faded to silence before the next
 * one is taken, so that there is no jump. */
static float next_sample(Sound *sound) {
    if (!sound->count && sound->gain)
        sound->falling = true;
    if (sound->falling) {
        sound->gain -= sound->gain > 0;
        sound->falling = sound->gain > 0;
    } else if (sound->count) {
        sound->value = sound->queue[sound->first];
        sound->first = (sound->first + 1) % ROOM;
        sound->count--;
        sound->gain += sound->gain < FADE;
    }
    return sound->value * (float)sound->gain / FADE;
}

/* Runs on SDL's thread, with the device locked. */
static void play(void *context, Uint8 *stream, int bytes) {
    float *samples = (float *)(void *)stream;
    for (int i = 0; i < bytes / (int)sizeof *samples; i++)
        samples[i] = next_sample(context);
}

Sound *sound_open(char message[SOUND_MESSAGE]) {
    Sound *sound = memory_zeroed(1, sizeof *sound);
    SDL_AudioSpec wanted = {.freq = SOUND_RATE,
                            .format = AUDIO_F32SYS,
                            .channels = 1,
                            .samples = DEVICE,
                            .callback = play,
                            .userdata = sound};
    bool ready = SDL_InitSubSystem(SDL_INIT_AUDIO) == 0;
    if (ready)
        sound->device = SDL_OpenAudioDevice(NULL, 0, &wanted, NULL, 0);
    if (sound->device) {
        SDL_PauseAudioDevice(sound->device, 0);
        return sound;
    }
    snprintf(message, SOUND_MESSAGE, "Sound is not available: %s", SDL_GetError());
    if (ready)
        SDL_QuitSubSystem(SDL_INIT_AUDIO);
    memory_free(sound);
    return NULL;
}

static bool is_heard(Sound *sound) {
    SDL_LockAudioDevice(sound->device);
    bool heard = sound->gain > 0;
    SDL_UnlockAudioDevice(sound->device);
    return heard;
}

void sound_close(Sound *sound) {
    if (!sound)
        return;
    sound_hush(sound);
    for (int waited = 0; waited < PATIENCE && is_heard(sound); waited += 5)
        SDL_Delay(5);
    SDL_CloseAudioDevice(sound->device); /* the device plays the samples it has taken */
    SDL_QuitSubSystem(SDL_INIT_AUDIO);
    memory_free(sound);
}

size_t sound_room(Sound *sound) {
    SDL_LockAudioDevice(sound->device);
    size_t room = sound->count < WANTED ? WANTED - sound->count : 0;
    SDL_UnlockAudioDevice(sound->device);
    return room;
}

void sound_feed(Sound *sound, const float *samples, size_t count) {
    SDL_LockAudioDevice(sound->device);
    for (size_t i = 0; i < count && sound->count < ROOM; i++) {
        float sample = isnan(samples[i]) ? 0 : fminf(fmaxf(samples[i], -1), 1);
        sound->queue[(sound->first + sound->count++) % ROOM] = sample;
    }
    SDL_UnlockAudioDevice(sound->device);
}

void sound_hush(Sound *sound) {
    SDL_LockAudioDevice(sound->device);
    sound->count = 0;
    sound->falling = sound->gain > 0;
    SDL_UnlockAudioDevice(sound->device);
}
