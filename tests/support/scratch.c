#include "scratch.h"

#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/text.h"
#include "check.h"

void scratch_write(char path[SCRATCH_PATH], const char *text) {
    check_temporary(path, "scratch-XXXXXX");
    int file = mkstemp(path);
    FILE *out = file >= 0 ? fdopen(file, "w") : NULL;
    CHECK(out);
    for (; out && *text; text++)
        fputc(*text == '\'' ? '"' : *text, out);
    if (out)
        fclose(out);
}

void scratch_plan(Plan *plan, const char *members) {
    size_t size = strlen(members) + 64;
    char *text = memory_zeroed(size, 1), path[SCRATCH_PATH];
    snprintf(text, size, "{'format': 'clearance-house', 'version': 1, %s}", members);
    scratch_write(path, text);
    Fault fault = {0};
    *plan = (Plan){0};
    CHECK(plan_read(plan, path, NULL, 0, &fault));
    check_say(&fault);
    unlink(path);
    memory_free(text);
}

static int is_data(const struct dirent *entry) {
    static const char *const endings[] = {".json", ".csv", ".script", ".sh3d", ".dxf", ".wkt", ".scenario"};
    const char *end = strrchr(entry->d_name, '.');
    for (size_t e = 0; end && e < sizeof endings / sizeof *endings; e++)
        if (strcmp(end, endings[e]) == 0)
            return 1;
    return 0;
}

char **scratch_list(const char *directory, size_t *count) {
    struct dirent **entries = NULL;
    int found = scandir(scratch_source(directory), &entries, is_data, alphasort);
    *count = found > 0 ? (size_t)found : 0;
    CHECK(*count > 0);
    char **paths = memory_zeroed(*count, sizeof *paths);
    for (size_t i = 0; i < *count; i++) {
        size_t size = strlen(directory) + strlen(entries[i]->d_name) + 2;
        paths[i] = memory_zeroed(size, 1);
        snprintf(paths[i], size, "%s/%s", directory, entries[i]->d_name);
        free(entries[i]);
    }
    free(entries);
    return paths;
}

void scratch_free_list(char **paths, size_t count) {
    for (size_t i = 0; i < count; i++)
        memory_free(paths[i]);
    memory_free(paths);
}

const char *scratch_source(const char *path) {
    static char whole[4096];
    snprintf(whole, sizeof whole, "%s/%s", check_source(), path);
    return whole;
}

char *scratch_read(const char *path) {
    size_t size;
    char *text = text_read_file(path, 1 << 24, &size);
    return text ? text : memory_zeroed(1, 1);
}

void scratch_check_faults(const char *directory, void (*read)(const char *path, Fault *fault)) {
    CHECK(chdir(check_source()) == 0); /* the expected lines name files relative to it */
    size_t count, size = strlen(directory) + sizeof "/expected.txt";
    char **paths = scratch_list(directory, &count), *list = memory_zeroed(size, 1);
    snprintf(list, size, "%s/expected.txt", directory);
    char *expected = scratch_read(list);
    Text found = {0};
    text_add(&found, "");
    for (size_t i = 0; i < count; i++) {
        Fault fault = {0};
        read(paths[i], &fault);
        CHECK(fault.count);
        for (size_t l = 0; l < fault.count; l++) {
            text_add(&found, fault.lines[l]);
            text_add(&found, "\n");
        }
        fault_clear(&fault);
    }
    CHECK_TEXT(found.text, expected);
    memory_free(found.text);
    memory_free(expected);
    memory_free(list);
    scratch_free_list(paths, count);
}
