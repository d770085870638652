#include "exchange/import.h"

#include <string.h>
#include <strings.h>

#include "exchange/dxf.h"
#include "exchange/house_finish.h"
#include "exchange/sh3d.h"
#include "exchange/vadere.h"
#include "exchange/wkt.h"

/* Passes the contents of the file to the builder. False: an error, or the builder has failed. */
typedef bool Reader(HouseBuilder *builder);

typedef struct Format {
    const char *name;
    const char *ending;
    Reader *read;
} Format;

static const Format formats[] = {
    {"Sweet Home 3D", ".sh3d", sh3d_read},
    {"DXF drawing", ".dxf", dxf_read},
    {"WKT walkable area", ".wkt", wkt_read},
    {"Vadere scenario", ".scenario", vadere_read},
};
enum { FORMATS = sizeof formats / sizeof *formats };

double import_unit(const char *name) {
    static const struct {
        const char *name;
        double metres;
    } units[] = {{"mm", 0.001}, {"cm", 0.01}, {"m", 1}, {"inch", 0.0254}, {"in", 0.0254}, {"ft", 0.3048}};
    for (size_t u = 0; u < sizeof units / sizeof *units; u++)
        if (strcmp(name, units[u].name) == 0)
            return units[u].metres;
    return 0;
}

static const Format *find_format(const char *path) {
    size_t length = strlen(path);
    for (size_t f = 0; f < FORMATS; f++) {
        size_t ending = strlen(formats[f].ending);
        if (length > ending && strcasecmp(path + length - ending, formats[f].ending) == 0)
            return &formats[f];
    }
    return NULL;
}

bool import_is_file(const char *path) {
    return find_format(path);
}

bool import_read(Plan *plan, const char *path, const ImportOptions *options, ImportReport *report, Fault *fault) {
    const Format *format = find_format(path);
    if (!format) {
        fault_add(fault, "%s:1:1: the kind of file is unknown, the name must end in .sh3d, .dxf, .wkt or .scenario",
                  path);
        return false;
    }
    report->format = format->name;
    HouseBuilder builder;
    house_builder_init(&builder, path, options, report, fault);
    bool good = format->read(&builder) && house_finish_plan(&builder, plan);
    house_builder_clear(&builder);
    return good;
}
