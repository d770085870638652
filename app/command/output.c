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

bool output_directory(const char *path) {
    if (!path)
        return true;
    int error = strlen(path) + OUTPUT_NAME < OUTPUT_PATH ? text_make_folder(path) : ENAMETOOLONG;
    if (error)
        output_failed(path, error);
    else
        output_warn_of_fonts();
    return !error;
}

/* Returns the length of the folder above the first `length` bytes of a path, without the slash that ends it. */
static size_t above(const char *path, size_t length) {
    while (length && path[length - 1] == '/')
        length--;
    while (length && path[length - 1] != '/')
        length--;
    return length;
}

size_t output_is_there(const char *path) {
    size_t length = strlen(path);
    char *part = text_copy(path);
    while (length && access(part, F_OK) != 0) {
        length = above(path, length);
        part[length] = 0;
    }
    memory_free(part);
    return length;
}

void output_withdraw(const char *path, size_t there) {
    char *part = text_copy(path);
    for (size_t length = strlen(path); length > there; length = above(path, length)) {
        part[length] = 0;
        rmdir(part); /* which leaves a folder that is not empty */
    }
    memory_free(part);
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
    static const char *const endings[] = {[CAIRO_FILE_PNG] = "png", [CAIRO_FILE_SVG] = "svg", [CAIRO_FILE_PDF] = "pdf"};
    char path[OUTPUT_PATH];
    int error = 0;
    for (CairoFileKind kind = CAIRO_FILE_PNG; kind <= CAIRO_FILE_PDF && !error; kind++) {
        snprintf(path, sizeof path, "%s/plan.%s", options->out, endings[kind]);
        error = paint_cairo_file(kind, scene, path, options->width, options->height, options->theme);
    }
    if (error)
        output_failed(path, error);
    return !error;
}
