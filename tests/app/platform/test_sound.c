#include "platform/sound.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/memory.h"
#include "base/text.h"
#include "check.h"
#include "desk.h"

enum { SAMPLES = 1 << 15, LARGEST = 1 << 26 };

/* Returns the mono floats that SDL's disk driver has written; memory_free them. */
static float *heard(size_t *count) {
    size_t size = 0;
    char *bytes = text_read_file(desk_path("sound.raw"), LARGEST, &size);
    CHECK(bytes);
    *count = size / sizeof(float);
    float *samples = memory_zeroed(*count + 1, sizeof *samples);
    if (bytes)
        memcpy(samples, bytes, *count * sizeof *samples);
    memory_free(bytes);
    return samples;
}

static Sound *open_disk(void) {
    desk_make();
    setenv("SDL_AUDIODRIVER", "disk", 1);
    setenv("SDL_DISKAUDIOFILE", desk_path("sound.raw"), 1);
    char message[SOUND_MESSAGE] = "";
    Sound *sound = sound_open(message);
    CHECK(sound);
    CHECK_TEXT(message, "");
    return sound;
}

/* Feeds a tone as fast as the device asks, for some time. */
static void play_tone(Sound *sound, int milliseconds) {
    static float samples[SAMPLES];
    static size_t at;
    for (int i = 0; i < milliseconds; i += 10) {
        size_t room = sound_room(sound);
        CHECK(room < SAMPLES);
        for (size_t s = 0; s < room; s++)
            samples[s] = cosf(2 * (float)M_PI * 220 * (float)(at++ % SOUND_RATE) / SOUND_RATE);
        sound_feed(sound, samples, room);
        usleep(10000);
    }
}

/* Measures loudness and the largest step between samples. */
static void check_heard(double loud, double jump) {
    size_t count;
    float *samples = heard(&count);
    double largest = 0, step = 0;
    for (size_t i = 0; i < count; i++) {
        CHECK(isfinite(samples[i]));
        largest = fmax(largest, fabsf(samples[i]));
        step = fmax(step, fabs((double)samples[i] - (i ? (double)samples[i - 1] : 0)));
    }
    CHECK(count > SOUND_RATE / 20);
    CHECK_NEAR(largest, loud, 0.01);
    CHECK(step <= jump);
    CHECK_NEAR(count ? samples[count - 1] : 1, 0, 1e-3);
    memory_free(samples);
}

TEST(a_tone_is_heard_without_clicks_though_it_begins_runs_dry_and_is_hushed) {
    Sound *sound = open_disk();
    play_tone(sound, 200);
    usleep(200000); /* the buffer runs empty */
    play_tone(sound, 200);
    sound_hush(sound);
    play_tone(sound, 200);
    sound_close(sound);
    check_heard(1, 2 * M_PI * 220 / SOUND_RATE * 1.3);
    desk_remove();
}

TEST(what_is_too_loud_or_no_number_is_cut) {
    Sound *sound = open_disk();
    static const float bad[] = {7, NAN, -INFINITY, INFINITY};
    float samples[1000];
    for (size_t i = 0; i < 1000; i++)
        samples[i] = bad[i % 4];
    for (int i = 0; i < 30; i++) {
        sound_feed(sound, samples, 1000);
        usleep(10000);
    }
    sound_close(sound);
    check_heard(1, 2);
    desk_remove();
}

TEST(what_has_no_room_is_left_out) {
    Sound *sound = open_disk();
    static const float silence[SAMPLES];
    size_t room = sound_room(sound);
    CHECK(room > 0 && room < SAMPLES);
    for (int i = 0; i < 10; i++)
        sound_feed(sound, silence, SAMPLES);
    CHECK(sound_room(sound) == 0);
    sound_hush(sound);
    CHECK(sound_room(sound) == room);
    sound_close(sound);
    desk_remove();
}

TEST(a_driver_that_plays_to_nobody_will_do) {
    setenv("SDL_AUDIODRIVER", "dummy", 1);
    char message[SOUND_MESSAGE] = "";
    Sound *sound = sound_open(message);
    CHECK(sound);
    play_tone(sound, 50);
    sound_close(sound);
    sound_close(NULL);
}

TEST(without_a_device_there_is_a_sentence) {
    setenv("SDL_AUDIODRIVER", "nothing", 1);
    char message[SOUND_MESSAGE] = "";
    CHECK(!sound_open(message));
    CHECK(strncmp(message, "Sound is not available: ", 24) == 0 && message[24]);
}
