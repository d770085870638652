#include "platform/recovery.h"

#include <dirent.h>
#include <errno.h>
#include <jansson.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/file_write.h"
#include "base/memory.h"
#include "base/text.h"
#include "platform/settings.h"

enum { FOUND_MOST = 50, ABOUT_LARGEST = 1 << 16 /* bytes */, STAT_LARGEST = 4096 };

struct Recovery {
    char *folder, *path, *about;
};

/* Processes -------------------------------------------------------------------------------------------------------- */

/* Returns when a process started, in the system's ticks; 0: there is no such process. */
static unsigned long long began(long process) {
    enum { STARTED = 22 /* field of /proc/PID/stat */ };
    char name[64];
    size_t size;
    snprintf(name, sizeof name, "/proc/%ld/stat", process);
    char *text = text_read_file(name, STAT_LARGEST, &size), *at = text ? strrchr(text, ')') : NULL;
    for (int field = 2; at && field < STARTED; field++)
        at = strchr(at + 1, ' ');
    unsigned long long ticks = at ? strtoull(at, NULL, 10) : 0;
    memory_free(text);
    return ticks;
}

/* True if the process that wrote files of this name is still alive. */
static bool is_alive(const char *name) {
    long process;
    unsigned long long start;
    if (sscanf(name, "%ld-%llu", &process, &start) != 2 || process <= 0)
        return false;
    return (kill((pid_t)process, 0) == 0 || errno == EPERM) && began(process) == start;
}

/* Places ----------------------------------------------------------------------------------------------------------- */

static char *join(const char *folder, const char *name, const char *ending) {
    Text text = {0};
    text_format(&text, "%s/%s%s", folder, name, ending);
    return text.text;
}

Recovery *recovery_create(void) {
    char *state = settings_state_folder(), name[64];
    char *folder = state ? join(state, "recovery", "") : NULL;
    memory_free(state);
    if (!folder || text_make_folder(folder) != 0) {
        memory_free(folder);
        return NULL;
    }
    Recovery *recovery = memory_zeroed(1, sizeof *recovery);
    snprintf(name, sizeof name, "%ld-%llu", (long)getpid(), began((long)getpid()));
    *recovery = (Recovery){folder, join(folder, name, ".json"), join(folder, name, ".about")};
    return recovery;
}

void recovery_destroy(Recovery *recovery) {
    memory_free(recovery->folder);
    memory_free(recovery->path);
    memory_free(recovery->about);
    memory_free(recovery);
}

const char *recovery_path(const Recovery *recovery) {
    return recovery->path;
}

/* Writing ---------------------------------------------------------------------------------------------------------- */

static int write_about(const char *path, const RecoveryAbout *about) {
    json_t *json = json_pack("{s:s*,s:s,s:I,s:I}", "path", about->origin, "name", about->name, "edits",
                             (json_int_t)about->edits, "when", (json_int_t)about->when);
    char *line = json ? json_dumps(json, JSON_COMPACT | JSON_SORT_KEYS) : NULL;
    int error = line ? file_write_bytes(path, line, strlen(line)) : EILSEQ;
    free(line);
    json_decref(json);
    return error;
}

int recovery_write(Recovery *recovery, const char *text, const RecoveryAbout *about) {
    int error = file_write_bytes(recovery->path, text, strlen(text));
    return error ? error : write_about(recovery->about, about);
}

void recovery_remove(Recovery *recovery) {
    unlink(recovery->path);
    unlink(recovery->about);
}

/* Finding ---------------------------------------------------------------------------------------------------------- */

static char *copy_of(const char *text) {
    return text ? text_copy(text) : NULL;
}

static int64_t time_of(const char *path) {
    struct stat status;
    return path && stat(path, &status) == 0 ? (int64_t)status.st_mtime : 0;
}

/* Reads the .about file; if that is missing or broken, takes the time from the house file. */
static void read_about(RecoveryFound *found) {
    size_t size;
    char *text = text_read_file(found->about_path, ABOUT_LARGEST, &size);
    json_t *json = text ? json_loads(text, 0, NULL) : NULL;
    const char *name = json_string_value(json_object_get(json, "name"));
    json_int_t edits = json_integer_value(json_object_get(json, "edits"));
    json_int_t when = json_integer_value(json_object_get(json, "when"));
    found->origin = copy_of(json_string_value(json_object_get(json, "path")));
    found->name = copy_of(name ? name : "a house");
    found->edits = edits > 0 ? (size_t)edits : 0;
    found->when = when > 0 ? when : time_of(found->path);
    found->origin_when = time_of(found->origin);
    json_decref(json);
    memory_free(text);
}

static bool ends_with(const char *name, const char *ending, size_t *stem) {
    size_t length = strlen(name), size = strlen(ending);
    *stem = length - size;
    return length > size && strcmp(name + *stem, ending) == 0;
}

static RecoveryFound found_of(const Recovery *recovery, const char *name, size_t stem) {
    char *begin = memory_zeroed(stem + 1, 1);
    memcpy(begin, name, stem);
    RecoveryFound found = {.path = join(recovery->folder, begin, ".json"),
                           .about_path = join(recovery->folder, begin, ".about")};
    memory_free(begin);
    read_about(&found);
    return found;
}

static int by_time(const void *a, const void *b) {
    const RecoveryFound *first = a, *second = b;
    int later = (first->when < second->when) - (first->when > second->when);
    return later ? later : strcmp(first->path, second->path);
}

RecoveryFound *recovery_find(const Recovery *recovery, size_t *count) {
    RecoveryFound *found = memory_zeroed(FOUND_MOST, sizeof *found);
    DIR *folder = opendir(recovery->folder);
    const struct dirent *entry;
    size_t stem;
    *count = 0;
    while (folder && *count < FOUND_MOST && (entry = readdir(folder)))
        if (ends_with(entry->d_name, ".json", &stem) && !is_alive(entry->d_name))
            found[(*count)++] = found_of(recovery, entry->d_name, stem);
    if (folder)
        closedir(folder);
    qsort(found, *count, sizeof *found, by_time);
    return found;
}

void recovery_free_found(RecoveryFound *found, size_t count) {
    for (size_t i = 0; i < count; i++) {
        memory_free(found[i].path);
        memory_free(found[i].about_path);
        memory_free(found[i].origin);
        memory_free(found[i].name);
    }
    memory_free(found);
}

bool recovery_adopt(Recovery *recovery, const RecoveryFound *found) {
    if (rename(found->path, recovery->path) != 0)
        return false;
    rename(found->about_path, recovery->about);
    return true;
}

void recovery_forget(const RecoveryFound *found) {
    unlink(found->path);
    unlink(found->about_path);
}
