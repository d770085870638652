#include "command/output.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "draw/paint_cairo.h"

bool output_directory(const char *path) {
    char part[4096];
    snprintf(part, sizeof part, "%s", path);
    int error = 0;
    for (char *slash = part + 1; !error && *slash; slash++) {
        if (*slash != '/')
            continue;
        *slash = 0;
        error = mkdir(part, 0777) && errno != EEXIST ? errno : 0;
        *slash = '/';
    }
    if (!error)
        error = mkdir(part, 0777) && errno != EEXIST ? errno : 0;
    if (!error && access(part, W_OK | X_OK))
        error = errno;
    if (error)
        output_failed(path, error);
    return !error;
}

void output_failed(const char *path, int error) {
    fprintf(stderr, "clearance: %s cannot be written: %s\n", path, strerror(error));
}

bool output_stills(const Scene *scene, const Options *options) {
    char path[4096];
    snprintf(path, sizeof path, "%s/plan.png", options->out);
    int error = paint_cairo_png(scene, path, options->width, options->height, options->theme);
    if (!error) {
        snprintf(path, sizeof path, "%s/plan.svg", options->out);
        error = paint_cairo_svg(scene, path, options->width, options->height, options->theme);
    }
    if (error)
        output_failed(path, error);
    return !error;
}
