#include "platform/snapshot.h"

#include <math.h>
#include <string.h>
#include <unistd.h>

#include "base/file_write.h"
#include "base/json.h"
#include "base/memory.h"
#include "base/text.h"
#include "draw/layout.h"
#include "paint/paint_cairo.h"
#include "paint/png.h"
#include "platform/export.h"

enum { KINDS = 4 };

static const char *const endings[KINDS] = {"png", "svg", "pdf", "csv"};

/* Writes `what` as a file of a kind, an index into the endings. Returns 0 or errno. */
typedef int WriteKind(const void *what, int kind, const char *path);

static int write_note(const SnapshotNote *note, const char *path) {
    char *command = note->command_count ? export_command(note->command, note->command_count) : NULL;
    json_t *object = json_pack("{s:s?, s:s?, s:o, s:s, s:s?}", "shows", note->shows, "command", command, "time",
                               isnan(note->time) ? json_null() : json_number(note->time), "program",
                               "clearance " CLEARANCE_VERSION, "digest", note->digest);
    memory_free(command);
    char *line = json_line(object);
    Text text = {0};
    text_format(&text, "%s\n", line);
    int error = file_write_quickly(path, text.text, text.used);
    memory_free(line);
    memory_free(text.text);
    json_decref(object);
    return error;
}

/* Writes all kinds and the note; removes those written so far if one fails. */
static char *write_kinds(WriteKind *write, const void *what, int kinds, const char *folder, const char *name,
                         const SnapshotNote *note, Fault *fault) {
    const char *wanted[KINDS + 2] = {"json"};
    int kind_of[KINDS + 1], count = 1, error = 0;
    for (int kind = 0; kind < KINDS; kind++)
        if (kinds & 1 << kind) {
            kind_of[count] = kind;
            wanted[count++] = endings[kind];
        }
    char *base = export_free_name(folder, name, wanted);
    Text path = {0};
    for (int i = 0; i < count && !error; i++) {
        path.used = 0;
        text_format(&path, "%s.%s", base, wanted[i]);
        error = i ? write(what, kind_of[i], path.text) : write_note(note, path.text);
        if (error)
            fault_add(fault, "%s cannot be written: %s", path.text, file_write_reason(error));
        for (; error && i >= 0; i--) {
            path.used = 0;
            text_format(&path, "%s.%s", base, wanted[i]);
            unlink(path.text);
        }
    }
    memory_free(path.text);
    if (!error)
        return base;
    memory_free(base);
    return NULL;
}

static void paint_view(struct _cairo *cairo, Vec2 page, const void *what) {
    const SnapshotView *view = what;
    const Scene *over[] = {view->added, view->moving};
    Layout layouts[3] = {{.grid_count = 0}};
    Layer layers[3] = {{view->still, &layouts[0]}};
    size_t count = 1;
    layout_make(&layouts[0], view->still, page);
    for (size_t i = 0; i < sizeof over / sizeof *over; i++)
        if (over[i]) {
            layout_make_over(&layouts[count], &layouts[0], over[i]);
            layers[count] = (Layer){over[i], &layouts[count]};
            count++;
        }
    paint_cairo_layers(cairo, layers, count, view->theme);
    for (size_t i = 0; i < count; i++)
        layout_clear(&layouts[i]);
}

static int write_view(const void *what, int kind, const char *path) {
    const SnapshotView *view = what;
    if (kind == CAIRO_FILE_PNG && view->pixels)
        return snapshot_pixels(path, view->pixels, view->width, view->height);
    return cairo_file_write((CairoFileKind)kind, path, view->width, view->height,
                            layout_unit(view->width, view->height), paint_view, view);
}

char *snapshot_view(const SnapshotView *view, int kinds, const char *folder, const char *name, const SnapshotNote *note,
                    Fault *fault) {
    if (view->still->camera.kind == VIEW_RAISED && (kinds != SNAPSHOT_PNG || !view->pixels)) {
        fault_add(fault, "the raised view can only be written as PNG; use the plan for SVG and PDF");
        return NULL;
    }
    return write_kinds(write_view, view, kinds & ~SNAPSHOT_CSV, folder, name, note, fault);
}

/* A plot and its sheet. */
typedef struct PlotFile {
    const Plot *plot;
    const PlotSheet *sheet;
} PlotFile;

static int write_plot(const void *what, int kind, const char *path) {
    const PlotFile *file = what;
    if (kind > CAIRO_FILE_PDF)
        return plot_write_csv(file->plot, path);
    return plot_write_picture((CairoFileKind)kind, file->plot, path, file->sheet);
}

char *snapshot_plot(const Plot *plot, const PlotSheet *sheet, int kinds, const char *folder, const char *name,
                    const SnapshotNote *note, Fault *fault) {
    PlotFile file = {plot, sheet};
    return write_kinds(write_plot, &file, kinds, folder, name, note, fault);
}

int snapshot_pixels(const char *path, const unsigned char *pixels, int width, int height) {
    return png_write(path, pixels, width, height);
}
