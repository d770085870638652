#include "fuzz.h"

#include <ftw.h>
#include <jansson.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

const char *fuzz_file(const uint8_t *data, size_t size) {
    static int file = -1;
    static char path[32];
    if (file < 0) {
        file = memfd_create("fuzz", MFD_CLOEXEC);
        snprintf(path, sizeof path, "/proc/self/fd/%d", file);
    }
    fuzz_expect(ftruncate(file, 0) == 0 && pwrite(file, data, size, 0) == (ssize_t)size, "the input is written");
    return path;
}

static char folder[FUZZ_PATH / 2];

static int remove_entry(const char *path, const struct stat *status, int kind, struct FTW *walk) {
    (void)status, (void)kind, (void)walk;
    return remove(path);
}

static void remove_folder(void) {
    nftw(folder, remove_entry, 8, FTW_DEPTH | FTW_PHYS);
}

const char *fuzz_folder(void) {
    const char *parent = getenv("TMPDIR");
    if (*folder)
        return folder;
    snprintf(folder, sizeof folder, "%s/clearance-fuzz-XXXXXX", parent ? parent : "/tmp");
    fuzz_expect(mkdtemp(folder), "a folder is made");
    atexit(remove_folder);
    return folder;
}

void fuzz_write(char path[FUZZ_PATH], const char *name, const uint8_t *data, size_t size) {
    snprintf(path, FUZZ_PATH, "%s/%s", fuzz_folder(), name);
    unlink(path);
    if (!size)
        return;
    FILE *file = fopen(path, "w");
    fuzz_expect(file && fwrite(data, 1, size, file) == size && fclose(file) == 0, "the input is written");
}

const char *fuzz_source(const char *name) {
    static char path[4096];
    const char *source = getenv("CLEARANCE_SOURCE");
    snprintf(path, sizeof path, "%s/%s", source ? source : ".", name);
    return path;
}

uint8_t fuzz_take(const uint8_t **data, size_t *size) {
    if (!*size)
        return 0;
    --*size;
    return *(*data)++;
}

void fuzz_expect(bool good, const char *what) {
    if (good)
        return;
    fprintf(stderr, "does not hold: %s\n", what);
    abort();
}

void fuzz_expect_faults(bool good, Fault *fault, const char *place) {
    fuzz_expect(good == (fault->total == 0), "a fault for each failure, and none besides");
    for (size_t i = 0; i < fault->count; i++) {
        const char *line = fault->lines[i];
        int end = 0, row, column;
        json_t *text = json_string(line);
        fuzz_expect(text, "a fault is UTF-8");
        json_decref(text);
        for (const char *c = line; *c; c++)
            fuzz_expect((unsigned char)*c >= ' ' && *c != 127, "a fault is one line");
        fuzz_expect(strncmp(line, place, strlen(place)) == 0, "a fault begins with its place");
        if (*place == '/')
            fuzz_expect(sscanf(line + strlen(place), ":%d:%d: %n", &row, &column, &end) == 2 && end > 0 && row > 0 &&
                            column > 0,
                        "a fault has a line and a column");
    }
    fault_clear(fault);
}
