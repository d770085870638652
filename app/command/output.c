#include "command/output.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "base/file_write.h"
#include "base/memory.h"
#include "base/text.h"
#include "command/progress.h"
#include "draw/text.h"
#include "paint/paint_cairo.h"

void output_warn_of_fonts(void) {
    if (!text_has_fonts())
        fprintf(stderr, "clearance: no font is installed, so that pictures show boxes instead of letters; "
                        "apt-get install fonts-dejavu-core\n");
}

void output_text(const Text *text) {
    if (text->text)
        fputs(text->text, stdout);
}

/* What the first call of output_directory has made. */
static struct {
    char path[OUTPUT_PATH]; /* "": nothing */
    size_t there;           /* bytes of it that were there before */
} made;

/* Returns the length, with its slash, of the folder above the first `length` bytes of a path. */
static size_t above(const char *path, size_t length) {
    while (length && path[length - 1] == '/')
        length--;
    while (length && path[length - 1] != '/')
        length--;
    return length;
}

/* Returns how many bytes of a path name what is there. */
static size_t is_there(const char *path) {
    size_t length = strlen(path);
    char *part = text_copy(path);
    while (length && access(part, F_OK) != 0) {
        length = above(path, length);
        part[length] = 0;
    }
    memory_free(part);
    return length;
}

bool output_directory(const char *path) {
    if (!path)
        return true;
    bool fits = strlen(path) + OUTPUT_NAME < OUTPUT_PATH;
    if (fits && !*made.path) {
        made.there = is_there(path);
        snprintf(made.path, sizeof made.path, "%s", path);
    }
    int error = fits ? text_make_folder(path) : ENAMETOOLONG;
    if (error)
        output_failed(path, error);
    else
        output_warn_of_fonts();
    return !error;
}

void output_withdraw(void) {
    for (size_t length = strlen(made.path); length > made.there; length = above(made.path, length)) {
        made.path[length] = 0;
        rmdir(made.path); /* which leaves a folder that is not empty */
    }
}

void output_failed(const char *path, int error) {
    fprintf(stderr, "clearance: %s cannot be written: %s\n", path, file_write_reason(error));
}

bool output_tell_interrupted(bool told) {
    bool interrupted = progress_interrupted();
    if (interrupted && !told)
        fprintf(stderr, "clearance: interrupted; a film ends early, other files written so far are complete, and the "
                        "rest is missing\n");
    return told || interrupted;
}

PlotSheet output_sheet(const Options *options, const char *source) {
    return (PlotSheet){options->width, options->height, options->theme, source};
}

bool output_stills(const Scene *scene, const Options *options) {
    char path[OUTPUT_PATH];
    int error = 0;
    for (CairoFileKind kind = CAIRO_FILE_PNG; kind <= CAIRO_FILE_PDF && !error; kind++) {
        snprintf(path, sizeof path, "%s/plan.%s", options->out, cairo_file_endings[kind]);
        error = paint_cairo_file(kind, scene, path, options->width, options->height, options->theme);
    }
    if (error)
        output_failed(path, error);
    return !error;
}
