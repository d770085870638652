#include "laboratory/live_save.h"

#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "beam/beam.h"
#include "house/plan.h"

enum { FILE_WORD = 1 /* of a command: "run", FILE, ... */ };

/* The values of all --set, in their order: how many. */
static size_t list_settings(const char *const *words, size_t count, const char **settings) {
    size_t found = 0;
    for (size_t i = 0; i + 1 < count; i++)
        if (strcmp(words[i], "--set") == 0)
            settings[found++] = words[++i];
    return found;
}

/* The file that is open, by whatever name, is not written over. */
static bool is_same_file(const char *from, const char *to, Fault *fault) {
    char *a = realpath(from, NULL), *b = realpath(to, NULL);
    bool same = a && b && strcmp(a, b) == 0;
    free(a);
    free(b);
    if (same)
        fault_add(fault, "%s: this is the file that is open, a copy must have another name", to);
    return same;
}

static bool say(int error, const char *path, Fault *fault) {
    if (error)
        fault_add(fault, "%s: %s", path, strerror(error));
    return !error;
}

bool live_save_house(const char *const *words, size_t count, const char *path, Fault *fault) {
    const char **settings = memory_allocate(count, sizeof *settings);
    size_t setting_count = list_settings(words, count, settings);
    Plan plan = {0};
    bool good = !is_same_file(words[FILE_WORD], path, fault) &&
                plan_read(&plan, words[FILE_WORD], settings, setting_count, fault) &&
                say(plan_write(&plan, path), path, fault);
    plan_free(&plan);
    memory_free(settings);
    return good;
}

bool live_save_beam(const char *const *words, size_t count, const char *path, Fault *fault) {
    const char **settings = memory_allocate(count, sizeof *settings);
    size_t setting_count = list_settings(words, count, settings);
    Beam beam = {0};
    bool good = !is_same_file(words[FILE_WORD], path, fault) &&
                beam_read(&beam, words[FILE_WORD], settings, setting_count, fault) &&
                say(beam_write(&beam, path), path, fault);
    beam_free(&beam);
    memory_free(settings);
    return good;
}
