#include "laboratory/save_file.h"

#include <string.h>
#include <unistd.h>

#include "base/file_write.h"
#include "base/memory.h"
#include "beam/beam.h"
#include "crank/crank.h"

enum { FILE_WORD = 1 /* index of FILE in a command: "run", FILE, ... */ };

/* Lists the values of all --set options in order; returns their number. */
static size_t list_settings(const char *const *words, size_t count, const char **settings) {
    size_t found = 0;
    for (size_t i = 0; i + 1 < count; i++)
        if (strcmp(words[i], "--set") == 0)
            settings[found++] = words[++i];
    return found;
}

/* True, with a fault, if the file exists: files are never overwritten, but pipes and devices are written. */
static bool is_there(const char *path, Fault *fault) {
    bool there = access(path, F_OK) == 0 && !file_write_is_direct(path);
    if (there)
        fault_add(fault, "%s exists already; choose another name for the copy", path);
    return there;
}

static bool say(int error, const char *path, Fault *fault) {
    if (error)
        fault_add(fault, "%s cannot be written: %s", path, file_write_reason(error));
    return !error;
}

bool save_file_house(const char *text, const char *path, Fault *fault) {
    return !is_there(path, fault) && say(file_write_bytes(path, text, strlen(text)), path, fault);
}

bool save_file_beam(const char *const *words, size_t count, const char *path, Fault *fault) {
    const char **settings = memory_zeroed(count, sizeof *settings);
    size_t setting_count = list_settings(words, count, settings);
    Beam beam = {0};
    bool good = !is_there(path, fault) && beam_read(&beam, words[FILE_WORD], settings, setting_count, fault) &&
                say(beam_write(&beam, path), path, fault);
    beam_free(&beam);
    memory_free(settings);
    return good;
}

bool save_file_crank(const char *const *words, size_t count, const char *path, Fault *fault) {
    const char **settings = memory_zeroed(count, sizeof *settings);
    size_t setting_count = list_settings(words, count, settings);
    Crank crank = {0};
    bool good = !is_there(path, fault) && crank_read(&crank, words[FILE_WORD], settings, setting_count, fault) &&
                say(crank_write(&crank, path), path, fault);
    crank_free(&crank);
    memory_free(settings);
    return good;
}
