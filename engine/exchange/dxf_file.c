#include "exchange/dxf_file.h"

#include <errno.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "base/text.h"
#include "exchange/code_page.h"

enum {
    LARGEST_FILE = 64 * 1024 * 1024, /* bytes: the plan of a hospital has about 20 MB */
    MOST_ENTITIES = 500000,
    MOST_VERTICES = 1000000,
    MOST_LAYERS = 1000,
    MOST_BLOCKS = 20000,
    LONGEST_NAME = 255, /* bytes */
    FROZEN = 1,         /* flags of a layer, a polyline: */
    CLOSED = 1,
    NO_LINES = 16 | 64, /* a mesh, not a line */
    CONTROLS = 16,      /* flag of a vertex that only guides a curve */
};

/* A drawing is a sequence of line pairs: a group code, and the value on the next line. */
typedef struct Group {
    int code;
    char *value;
} Group;

typedef struct Reader {
    DxfFile *file;
    HouseBuilder *builder;
    char *at, *end; /* the text not yet read */
    Group group;    /* the group read last */
    int line;       /* line number of `group` */
    int next_line;
    bool ended;      /* the group 0 EOF has been read */
    uint64_t given;  /* bits of the group codes below 64 that the entity or vertex has given */
    int open_line;   /* line of the x of a LWPOLYLINE's point whose y is still to come; 0: none */
    DxfVertex spare; /* receives values after an error */
} Reader;

static bool fail(Reader *reader, const char *what, const char *detail) {
    reader->builder->line = reader->line;
    return house_builder_fail(reader->builder, "%s%.60s", what, detail);
}

/* Groups ---------------------------------------------------------------------------------------------------------- */

/* Returns the next line without surrounding spaces, or NULL at the end. String functions are avoided because some of
 * them read all the remaining text. */
static char *next_line(Reader *reader) {
    char *begin = reader->at;
    if (begin == reader->end)
        return NULL;
    char *feed = memchr(begin, '\n', (size_t)(reader->end - begin)), *end = feed ? feed : reader->end;
    reader->at = feed ? feed + 1 : end;
    reader->line = reader->next_line++;
    while (end > begin && (end[-1] == '\r' || end[-1] == ' '))
        end--;
    *end = 0;
    return begin + strspn(begin, " \t");
}

static bool group_is(const Reader *reader, int code, const char *value) {
    return reader->group.code == code && strcmp(reader->group.value, value) == 0;
}

/* Reads the next group. False at the group 0 EOF, where the text ends without one, or after an error. */
static bool next_group(Reader *reader) {
    if (reader->builder->failed || reader->ended)
        return false;
    char *code = next_line(reader), *end;
    if (!code)
        return false;
    if (!*code && !*reader->at) /* blank lines at the end */
        return false;
    long number = strtol(code, &end, 10);
    if (!*code || *end || number < -10 || number > 2000)
        return fail(reader, "no DXF drawing: there must be a group code, not ", code);
    char *value = next_line(reader);
    if (!value)
        return fail(reader, "the drawing is cut off within a group, must end with the group 0 EOF", "");
    reader->group = (Group){(int)number, value};
    if (number >= 0 && number < 64)
        reader->given |= (uint64_t)1 << number;
    reader->ended = group_is(reader, 0, "EOF");
    return !reader->ended;
}

/* Returns the value as a number within the limits of a plan. */
static double real(Reader *reader) {
    char *end;
    double number = strtod(reader->group.value, &end);
    if (end == reader->group.value || *end || !(fabs(number) < 1e12))
        fail(reader, "must be a number below 1e12, not ", reader->group.value);
    return fabs(number) < 1e12 ? number : 0;
}

static int whole(Reader *reader) {
    return (int)real_clamp(real(reader), -1e9, 1e9);
}

static const char *name(Reader *reader) {
    if (strlen(reader->group.value) > LONGEST_NAME)
        reader->group.value[LONGEST_NAME] = 0;
    return reader->group.value;
}

/* Layers ---------------------------------------------------------------------------------------------------------- */

static size_t find_layer(Reader *reader, const char *name) {
    DxfFile *file = reader->file;
    unsigned hash = 2166136261u;
    for (const char *c = name; *c; c++)
        hash = (hash ^ (unsigned char)*c) * 16777619u;
    for (size_t l = 0; l < file->layer_count; l++)
        if (file->layers[l].hash == hash && strcmp(file->layers[l].name, name) == 0)
            return l;
    if (file->layer_count == MOST_LAYERS) {
        fail(reader, "more than 1000 layers, must be fewer", "");
        return 0;
    }
    file->layers = memory_reserve(file->layers, &file->layer_capacity, file->layer_count + 1, sizeof *file->layers);
    file->layers[file->layer_count] = (DxfLayer){.name = name, .hash = hash};
    return file->layer_count++;
}

static void read_layers(Reader *reader) {
    size_t layer = SIZE_MAX;
    bool more = next_group(reader);
    while (more && !group_is(reader, 0, "ENDSEC")) {
        if (reader->group.code == 0)
            layer = SIZE_MAX;
        bool begins = group_is(reader, 0, "LAYER");
        while ((more = next_group(reader)) && begins && reader->group.code != 0) {
            if (reader->group.code == 2)
                layer = find_layer(reader, name(reader));
            else if (layer != SIZE_MAX && ((reader->group.code == 70 && (whole(reader) & FROZEN)) ||
                                           (reader->group.code == 62 && whole(reader) < 0)))
                reader->file->layers[layer].hidden = true;
        }
    }
}

/* Entities -------------------------------------------------------------------------------------------------------- */

static DxfVertex *add_vertex(Reader *reader, DxfEntity *entity) {
    DxfFile *file = reader->file;
    if (file->vertex_count == MOST_VERTICES) {
        fail(reader, "more than 1000000 points, must be fewer", "");
        return &reader->spare;
    }
    file->vertices =
        memory_reserve(file->vertices, &file->vertex_capacity, file->vertex_count + 1, sizeof *file->vertices);
    if (!entity->vertex_count)
        entity->vertex = file->vertex_count;
    entity->vertex_count++;
    return &file->vertices[file->vertex_count++];
}

static DxfVertex *last_vertex(Reader *reader, DxfEntity *entity) {
    return entity->vertex_count ? &reader->file->vertices[entity->vertex + entity->vertex_count - 1]
                                : add_vertex(reader, entity);
}

/* Stores groups that mean the same in all entities. */
static void take_common(Reader *reader, DxfEntity *entity) {
    switch (reader->group.code) {
    case 8:
        entity->layer = find_layer(reader, name(reader));
        break;
    case 67:
        entity->on_paper = whole(reader) == 1;
        break;
    case 230:
        entity->mirrored = real(reader) < 0;
        break;
    }
}

/* Returns the start or the end of a LINE. */
static DxfVertex *line_vertex(Reader *reader, DxfEntity *entity, size_t index) {
    while (entity->vertex_count < 2 && !reader->builder->failed)
        add_vertex(reader, entity);
    return entity->vertex_count < 2 ? &reader->spare : &reader->file->vertices[entity->vertex + index];
}

static void take_line(Reader *reader, DxfEntity *entity) {
    switch (reader->group.code) {
    case 10:
    case 11:
        line_vertex(reader, entity, reader->group.code == 11)->at.x = real(reader);
        break;
    case 20:
    case 21:
        line_vertex(reader, entity, reader->group.code == 21)->at.y = real(reader);
        break;
    case 230: /* a LINE gives its coordinates in world axes */
        entity->mirrored = false;
        break;
    }
}

/* Adds an error if the last point of a LWPOLYLINE has no y. */
static void end_point(Reader *reader) {
    if (!reader->open_line)
        return;
    reader->line = reader->open_line;
    fail(reader, "the point has no group 20 (its y), must have one", "");
}

static void take_lwpolyline(Reader *reader, DxfEntity *entity) {
    switch (reader->group.code) {
    case 10:
        end_point(reader);
        add_vertex(reader, entity)->at.x = real(reader);
        reader->open_line = reader->line;
        break;
    case 20:
        if (!reader->open_line)
            fail(reader, "the point has no group 10 (its x), must have one before this y", "");
        last_vertex(reader, entity)->at.y = real(reader);
        reader->open_line = 0;
        break;
    case 42:
        last_vertex(reader, entity)->bulge = real(reader);
        break;
    case 43:
        entity->width = fabs(real(reader));
        break;
    case 70:
        entity->closed = whole(reader) & CLOSED;
        break;
    }
}

static void take_polyline(Reader *reader, DxfEntity *entity) {
    if (reader->group.code == 70) {
        entity->closed = whole(reader) & CLOSED;
        entity->kind = whole(reader) & NO_LINES ? DXF_OTHER : DXF_LINES;
    } else if (reader->group.code == 40) {
        entity->width = fabs(real(reader));
    }
}

/* Where the number of a group code is stored. */
typedef struct Place {
    int code;
    size_t offset; /* offset of a double in the entity */
} Place;

static void take_numbers(Reader *reader, DxfEntity *entity, const Place *places, size_t count) {
    for (size_t i = 0; i < count; i++)
        if (places[i].code == reader->group.code)
            *(double *)((char *)entity + places[i].offset) = real(reader);
}

static void take_arc(Reader *reader, DxfEntity *entity) {
    static const Place places[] = {{10, offsetof(DxfEntity, at.x)},
                                   {20, offsetof(DxfEntity, at.y)},
                                   {50, offsetof(DxfEntity, start)},
                                   {51, offsetof(DxfEntity, end)}};
    take_numbers(reader, entity, places, sizeof places / sizeof *places);
    if (reader->group.code == 40)
        entity->radius = fabs(real(reader));
}

static void take_insert(Reader *reader, DxfEntity *entity) {
    static const Place places[] = {{10, offsetof(DxfEntity, at.x)},      {20, offsetof(DxfEntity, at.y)},
                                   {41, offsetof(DxfEntity, scale.x)},   {42, offsetof(DxfEntity, scale.y)},
                                   {44, offsetof(DxfEntity, spacing.x)}, {45, offsetof(DxfEntity, spacing.y)},
                                   {50, offsetof(DxfEntity, turned)}};
    take_numbers(reader, entity, places, sizeof places / sizeof *places);
    if (reader->group.code == 2)
        entity->block = name(reader);
    else if (reader->group.code == 70)
        entity->columns = whole(reader);
    else if (reader->group.code == 71)
        entity->rows = whole(reader);
}

static void take_dimension(Reader *reader, DxfEntity *entity) {
    static const Place places[] = {{13, offsetof(DxfEntity, from.x)},   {23, offsetof(DxfEntity, from.y)},
                                   {14, offsetof(DxfEntity, to.x)},     {24, offsetof(DxfEntity, to.y)},
                                   {42, offsetof(DxfEntity, measured)}, {50, offsetof(DxfEntity, turned)}};
    take_numbers(reader, entity, places, sizeof places / sizeof *places);
    if (reader->group.code == 1)
        entity->text = name(reader);
    else if (reader->group.code == 2)
        entity->block = name(reader);
    else if (reader->group.code == 70)
        entity->flags = whole(reader);
}

static void take_text(Reader *reader, DxfEntity *entity) {
    static const Place places[] = {{10, offsetof(DxfEntity, at.x)},
                                   {20, offsetof(DxfEntity, at.y)},
                                   {40, offsetof(DxfEntity, radius)},
                                   {50, offsetof(DxfEntity, turned)}};
    take_numbers(reader, entity, places, sizeof places / sizeof *places);
    if (reader->group.code == 1)
        entity->text = name(reader);
}

typedef void Take(Reader *reader, DxfEntity *entity);

/* A group that must be given, as the DXF reference states no default value. */
typedef struct Need {
    int code;
    const char *what;
} Need;

enum { NEEDS_MOST = 5 };

/* A text or a dimension needs nothing: it is not part of the plan, and without its points it says no unit. */
static const struct {
    const char *type;
    DxfKind kind;
    Take *take;
    Need needs[NEEDS_MOST]; /* ended by a group 0 if there are fewer */
} types[] = {
    {"LINE",
     DXF_LINES,
     take_line,
     {{10, "x of its start"}, {20, "y of its start"}, {11, "x of its end"}, {21, "y of its end"}}},
    {"LWPOLYLINE", DXF_LINES, take_lwpolyline, {{0}}},
    {"POLYLINE", DXF_LINES, take_polyline, {{0}}},
    {"ARC",
     DXF_ARC,
     take_arc,
     {{10, "x of its centre"},
      {20, "y of its centre"},
      {40, "its radius"},
      {50, "its start angle"},
      {51, "its end angle"}}},
    {"CIRCLE", DXF_ARC, take_arc, {{10, "x of its centre"}, {20, "y of its centre"}, {40, "its radius"}}},
    {"INSERT", DXF_INSERT, take_insert, {{10, "x of its place"}, {20, "y of its place"}}},
    {"TEXT", DXF_TEXT, take_text, {{0}}},
    {"MTEXT", DXF_TEXT, take_text, {{0}}},
    {"DIMENSION", DXF_DIMENSION, take_dimension, {{0}}},
};
enum { TYPES = sizeof types / sizeof *types };

/* Adds an error at the line where the entity or vertex begins if one of its groups is missing. */
static void check_needs(Reader *reader, int line, const char *type, const Need needs[NEEDS_MOST]) {
    for (size_t n = 0; n < NEEDS_MOST && needs[n].code; n++) {
        if (reader->given & (uint64_t)1 << needs[n].code)
            continue;
        reader->builder->line = line;
        house_builder_fail(reader->builder, "the %s has no group %d (%s), must have one", type, needs[n].code,
                           needs[n].what);
    }
}

/* Reads a vertex of the preceding POLYLINE; stops at the next group 0. */
static bool read_vertex(Reader *reader, DxfEntity *polyline) {
    static const Need needs[NEEDS_MOST] = {{10, "its x"}, {20, "its y"}};
    DxfVertex vertex = {.bulge = 0};
    int line = reader->line;
    bool guides = false, more;
    reader->given = 0;
    while ((more = next_group(reader)) && reader->group.code != 0) {
        if (reader->group.code == 10)
            vertex.at.x = real(reader);
        else if (reader->group.code == 20)
            vertex.at.y = real(reader);
        else if (reader->group.code == 42)
            vertex.bulge = real(reader);
        else if (reader->group.code == 70)
            guides = whole(reader) & CONTROLS;
    }
    if ((more || reader->ended) && !guides && polyline->kind == DXF_LINES) /* a face of a mesh has no place */
        check_needs(reader, line, "VERTEX", needs);
    if (!guides)
        *add_vertex(reader, polyline) = vertex;
    return more;
}

/* Reads an entity; starts at a group 0 and stops at the next. */
static bool read_entity(Reader *reader) {
    DxfFile *file = reader->file;
    size_t type = 0;
    while (type < TYPES && strcmp(types[type].type, reader->group.value) != 0)
        type++;
    if (file->entity_count == MOST_ENTITIES)
        return fail(reader, "more than 500000 entities, must be fewer", "");
    file->entities =
        memory_reserve(file->entities, &file->entity_capacity, file->entity_count + 1, sizeof *file->entities);
    DxfEntity *entity = &file->entities[file->entity_count++];
    *entity = (DxfEntity){.kind = type < TYPES ? types[type].kind : DXF_OTHER,
                          .type = name(reader),
                          .block = "",
                          .text = "",
                          .at = {NAN, NAN},
                          .from = {NAN, NAN},
                          .to = {NAN, NAN},
                          .scale = {1, 1},
                          .end = 360,
                          .columns = 1,
                          .rows = 1,
                          .line = reader->line};
    bool more;
    reader->given = 0;
    reader->open_line = 0;
    while ((more = next_group(reader)) && reader->group.code != 0) {
        take_common(reader, entity);
        if (type < TYPES)
            types[type].take(reader, entity);
    }
    if (type < TYPES && (more || reader->ended)) { /* a drawing that is cut off has another error */
        end_point(reader);
        check_needs(reader, entity->line, types[type].type, types[type].needs);
    }
    bool holds = strcmp(entity->type, "POLYLINE") == 0;
    while (more && holds && group_is(reader, 0, "VERTEX"))
        more = read_vertex(reader, entity);
    return more;
}

/* Reads entities up to the one called `end`, and stops there. */
static bool read_entities(Reader *reader, const char *end) {
    bool more = reader->group.code == 0 || next_group(reader);
    while (more && !group_is(reader, 0, end) && !group_is(reader, 0, "ENDSEC"))
        more = reader->group.code == 0 ? read_entity(reader) : next_group(reader);
    return more;
}

/* Sections -------------------------------------------------------------------------------------------------------- */

/* Reads a block; starts at the group 0 of BLOCK. */
static bool read_block(Reader *reader) {
    DxfFile *file = reader->file;
    if (file->block_count == MOST_BLOCKS)
        return fail(reader, "more than 20000 blocks, must be fewer", "");
    DxfBlock block = {.name = "", .first = file->entity_count};
    bool more;
    while ((more = next_group(reader)) && reader->group.code != 0) {
        if (reader->group.code == 2)
            block.name = name(reader);
        else if (reader->group.code == 10)
            block.base.x = real(reader);
        else if (reader->group.code == 20)
            block.base.y = real(reader);
    }
    more = more && read_entities(reader, "ENDBLK");
    block.count = file->entity_count - block.first;
    file->blocks = memory_reserve(file->blocks, &file->block_capacity, file->block_count + 1, sizeof *file->blocks);
    file->blocks[file->block_count++] = block;
    return more;
}

static void read_blocks(Reader *reader) {
    bool more = next_group(reader);
    while (more && !group_is(reader, 0, "ENDSEC"))
        more = group_is(reader, 0, "BLOCK") ? read_block(reader) : next_group(reader);
}

static void read_header(Reader *reader) {
    int *number = NULL;
    while (next_group(reader) && !group_is(reader, 0, "ENDSEC")) {
        if (number && reader->group.code == 70)
            *number = whole(reader);
        if (reader->group.code == 9)
            number = strcmp(reader->group.value, "$INSUNITS") == 0 ? &reader->file->unit
                     : strcmp(reader->group.value, "$LUNITS") == 0 ? &reader->file->notation
                                                                   : NULL;
    }
}

/* Reads a section; starts at the name of SECTION. */
static void read_section(Reader *reader) {
    DxfFile *file = reader->file;
    const char *section = reader->group.value;
    if (strcmp(section, "HEADER") == 0) {
        read_header(reader);
    } else if (strcmp(section, "TABLES") == 0) {
        read_layers(reader);
    } else if (strcmp(section, "BLOCKS") == 0) {
        read_blocks(reader);
    } else if (strcmp(section, "ENTITIES") == 0 && !file->model_count) {
        file->model = file->entity_count;
        read_entities(reader, "ENDSEC");
        file->model_count = file->entity_count - file->model;
    }
}

static int compare_blocks(const void *a, const void *b) {
    const DxfBlock *p = a, *q = b;
    int order = strcasecmp(p->name, q->name);
    if (order || p->first != q->first)
        return order ? order : p->first < q->first ? -1 : 1;
    return p->count < q->count ? -1 : p->count > q->count; /* an empty block shares its first entity with the next */
}

static bool read_sections(Reader *reader) {
    bool any = false;
    while (next_group(reader))
        if (group_is(reader, 0, "SECTION") && next_group(reader) && reader->group.code == 2) {
            any = true;
            read_section(reader);
        }
    if (reader->builder->failed)
        return false;
    if (any && !reader->ended)
        return fail(reader, "the drawing is cut off, must end with the group 0 EOF", "");
    if (reader->file->block_count) /* an empty list is NULL */
        qsort(reader->file->blocks, reader->file->block_count, sizeof *reader->file->blocks, compare_blocks);
    reader->line = 1;
    return any || fail(reader, "no DXF drawing: it has no SECTION", "");
}

/* Converts the text to UTF-8: drawings from before 2007 are in the code page that they name, for instance ANSI_932
 * in Japan. */
static void convert(DxfFile *file, size_t *size) {
    char page[16] = "1252";
    const char *says = strstr(file->text, "$DWGCODEPAGE");
    if (code_page_is_utf8(file->text, *size))
        return;
    if (says)
        sscanf(says, "$DWGCODEPAGE 3 ANSI_%15[0-9]", page);
    char *text = code_page_convert(file->text, size, page);
    memory_free(file->text);
    file->text = text;
}

bool dxf_file_read(DxfFile *file, HouseBuilder *builder) {
    size_t size;
    file->text = text_read_file(builder->path, LARGEST_FILE, &size);
    if (!file->text)
        return house_builder_fail(builder, "cannot be read: %s", text_read_reason(errno));
    Reader reader = {.file = file, .builder = builder, .line = 1, .next_line = 1};
    if (strncmp(file->text, "AutoCAD Binary DXF", strlen("AutoCAD Binary DXF")) == 0)
        return fail(&reader, "a binary DXF drawing: save it as a text (ASCII) DXF", "");
    if (strncmp(file->text, "AC10", 4) == 0)
        return fail(&reader, "a DWG drawing: save it as a text (ASCII) DXF", "");
    if (memchr(file->text, 0, size))
        return fail(&reader, "no DXF drawing: there is a byte 0", "");
    convert(file, &size);
    reader.end = file->text + size;
    reader.at = file->text + (strncmp(file->text, "\xef\xbb\xbf", 3) == 0 ? 3 : 0);
    find_layer(&reader, "0"); /* layer "0" exists even if the file does not name it */
    bool good = read_sections(&reader);
    builder->line = 1;
    return good;
}

void dxf_file_clear(DxfFile *file) {
    memory_free(file->text);
    memory_free(file->entities);
    memory_free(file->vertices);
    memory_free(file->blocks);
    memory_free(file->layers);
    *file = (DxfFile){0};
}

const DxfBlock *dxf_file_block(const DxfFile *file, const char *name) {
    size_t low = 0, high = file->block_count;
    while (low < high) {
        size_t middle = low + (high - low) / 2;
        int order = strcasecmp(file->blocks[middle].name, name);
        if (order == 0)
            return &file->blocks[middle];
        if (order < 0)
            low = middle + 1;
        else
            high = middle;
    }
    return NULL;
}
