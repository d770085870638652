#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/file_write.h"
#include "base/text.h"
#include "command/command.h"
#include "command/house_file.h"
#include "command/output.h"
#include "paint/paint_cairo.h"
#include "exchange/walkable.h"
#include "house/house.h"
#include "visual/house/plan_picture.h"

/* The kinds of pictures. */
static const CairoFileKind kinds[] = {
    [EXPORT_SVG] = CAIRO_FILE_SVG, [EXPORT_PDF] = CAIRO_FILE_PDF, [EXPORT_PNG] = CAIRO_FILE_PNG};

static const char *ending_of(ExportFormat format) {
    return format == EXPORT_WKT ? "wkt" : cairo_file_endings[kinds[format]];
}

static bool is_folder(const char *path) {
    struct stat status;
    return stat(path, &status) == 0 && S_ISDIR(status.st_mode);
}

/* Returns --out, or the name of the house with another ending in the folder --out or next to the house. */
static const char *path_of(const Options *options, const char *format, Text *path) {
    const char *file = options->files[0], *slash = strrchr(file, '/'), *name = slash ? slash + 1 : file;
    const char *dot = strrchr(name, '.');
    int length = dot && dot > name ? (int)(dot - name) : (int)strlen(name);
    if (options->out && !is_folder(options->out))
        text_add(path, options->out);
    else if (options->out)
        text_format(path, "%s/%.*s.%s", options->out, length, name, format);
    else
        text_format(path, "%.*s%.*s.%s", (int)(name - file), file, length, name, format);
    return path->text;
}

/* Chooses the format: that of --to, or else the one that the name of --out ends with. False: an error was printed. */
static bool choose_format(const Options *options, ExportFormat *format) {
    const char *out = options->out;
    *format = options->format;
    if (options_given(options, "--to") || !out || is_folder(out) || file_write_is_direct(out))
        return true;
    const char *slash = strrchr(out, '/'), *dot = strrchr(slash ? slash : out, '.');
    for (ExportFormat f = 0; f < EXPORT_FORMATS; f++)
        if (!dot || strcasecmp(dot + 1, ending_of(f)) == 0) {
            *format = f;
            return true;
        }
    fprintf(stderr,
            "clearance: %s ends in none of .wkt, .svg, .pdf and .png; name the format with --to " EXPORT_WORDS "\n",
            out);
    return false;
}

static int write_wkt(const char *wkt, const char *path) {
    if (path)
        return file_write_bytes(path, wkt, strlen(wkt));
    return fputs(wkt, stdout) < 0 ? errno : 0;
}

static int write_picture(const House *house, const Options *options, ExportFormat format, const char *path) {
    Scene scene = {0};
    output_warn_of_fonts();
    plan_picture_make(&scene, house, false);
    int error = paint_cairo_file(kinds[format], &scene, path, options->width, options->height, options->theme);
    scene_clear(&scene);
    return error;
}

/* True, after an error on standard error, if the file exists: files are never overwritten, but pipes and devices are
 * written. */
static bool is_there(const char *path) {
    bool there = path && access(path, F_OK) == 0 && !file_write_is_direct(path);
    if (there)
        fprintf(stderr, "clearance: %s exists and is not overwritten; choose another file with --out\n", path);
    return there;
}

/* Reads the plan and writes the picture or the walkable area. Returns the exit code. */
static int export_to(const Options *options, ExportFormat format, const char *path) {
    bool picture = format != EXPORT_WKT;
    House house = {.seed = 0};
    Fault fault = {0};
    char *wkt = NULL;
    bool good = plan_read(&house.plan, options->files[0], options->settings, options->setting_count, &fault);
    if (good && picture)
        good = outline_build(&house.outline, &house.plan, &fault);
    else if (good)
        good = (wkt = walkable_wkt(&house.plan, &fault));
    int code = good ? EXIT_ANSWERED : house_file_report(&fault);
    int error = !good ? 0 : picture ? write_picture(&house, options, format, path) : write_wkt(wkt, path);
    if (error) {
        output_failed(path ? path : "standard output", error);
        code = EXIT_WRONG_INPUT;
    }
    memory_free(wkt);
    house_free(&house);
    return code;
}

int command_export(const Options *options) {
    ExportFormat format;
    if (!choose_format(options, &format))
        return EXIT_WRONG_INPUT;
    Text text = {0};
    const char *path = options->out || format != EXPORT_WKT ? path_of(options, ending_of(format), &text) : NULL;
    int code = is_there(path) ? EXIT_WRONG_INPUT : export_to(options, format, path);
    if (code == EXIT_ANSWERED && path && !file_write_is_direct(path))
        printf("written to %s\n", path);
    memory_free(text.text);
    return code;
}
