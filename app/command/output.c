#include "command/output.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>

#include "base/file_write.h"
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
