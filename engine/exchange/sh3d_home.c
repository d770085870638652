#include "exchange/sh3d_home.h"

#include <expat.h>
#include <stdlib.h>
#include <string.h>
#include <zip.h>

#include "base/text.h"

enum {
    LARGEST_XML = 64 * 1024 * 1024, /* bytes: a house with 100,000 walls has a quarter of this */
    HARMLESS = 1024 * 1024,         /* bytes: an unpacked size up to this is always accepted */
    MOST_SHRUNK = 200,              /* largest compression ratio; Home.xml of real homes shrinks about ten times */
    CHUNK = 65536,                  /* bytes */
    DEEPEST = 64,                   /* nesting depth: groups within groups */
    MOST = 2 * HOUSE_BUILDER_POINTS /* of each kind, on all storeys */
};

typedef struct Reader {
    Home *home;
    HouseBuilder *builder;
    XML_Parser parser;
    int depth;
    const char *levels[DEEPEST]; /* (depth) storeys of the open groups, or "" */
    bool in_room;                /* points belong to the last room */
} Reader;

/* Attributes ------------------------------------------------------------------------------------------------------ */

static const char *find(const XML_Char **attributes, const char *name) {
    for (; *attributes; attributes += 2)
        if (strcmp(attributes[0], name) == 0)
            return attributes[1];
    return NULL;
}

static const char *text(Reader *reader, const XML_Char **attributes, const char *name) {
    const char *value = find(attributes, name);
    return value ? arena_text(&reader->home->arena, value) : "";
}

/* Returns the attribute as a number; a value that is not a number is an error. */
static double number(Reader *reader, const XML_Char **attributes, const char *name, double fallback) {
    const char *value = find(attributes, name);
    if (!value)
        return fallback;
    char *end;
    double read = strtod(value, &end);
    if (!*value || *end || !(read > -1e12 && read < 1e12))
        house_builder_fail(reader->builder, "%s is \"%.40s\", must be a number below 1e12", name, value);
    return read;
}

static Vec2 place(Reader *reader, const XML_Char **attributes, const char *x, const char *y) {
    if (!find(attributes, x) || !find(attributes, y))
        house_builder_fail(reader->builder, "there is no %s or no %s", x, y);
    return vec2(number(reader, attributes, x, 0), number(reader, attributes, y, 0));
}

static const char *level_of(Reader *reader, const XML_Char **attributes) {
    const char *level = find(attributes, "level");
    return level ? arena_text(&reader->home->arena, level) : reader->depth > 0 ? reader->levels[reader->depth - 1] : "";
}

static bool is_room_for(Reader *reader, size_t count, const char *what) {
    return count < MOST || house_builder_fail(reader->builder, "more than %d %s, must be fewer", MOST, what);
}

/* Elements -------------------------------------------------------------------------------------------------------- */

static void begin_wall(Reader *reader, const XML_Char **attributes) {
    Home *home = reader->home;
    if (!is_room_for(reader, home->wall_count, "walls"))
        return;
    double height = number(reader, attributes, "height", 0), end = number(reader, attributes, "heightAtEnd", height);
    home->walls = memory_reserve(home->walls, &home->wall_capacity, home->wall_count + 1, sizeof *home->walls);
    home->walls[home->wall_count++] = (HomeWall){.level = level_of(reader, attributes),
                                                 .from = place(reader, attributes, "xStart", "yStart"),
                                                 .to = place(reader, attributes, "xEnd", "yEnd"),
                                                 .thickness = number(reader, attributes, "thickness", 0),
                                                 .height = end < height ? end : height,
                                                 .arc = number(reader, attributes, "arcExtent", 0)};
}

static bool is_true(const XML_Char **attributes, const char *name, bool fallback) {
    const char *value = find(attributes, name);
    return value ? strcmp(value, "true") == 0 : fallback;
}

static void begin_piece(Reader *reader, const XML_Char **attributes, bool opens) {
    Home *home = reader->home;
    if (!is_room_for(reader, home->piece_count, "pieces of furniture"))
        return;
    home->pieces = memory_reserve(home->pieces, &home->piece_capacity, home->piece_count + 1, sizeof *home->pieces);
    home->pieces[home->piece_count++] = (HomePiece){.level = level_of(reader, attributes),
                                                    .name = text(reader, attributes, "name"),
                                                    .catalog = text(reader, attributes, "catalogId"),
                                                    .centre = place(reader, attributes, "x", "y"),
                                                    .width = number(reader, attributes, "width", 0),
                                                    .depth = number(reader, attributes, "depth", 0),
                                                    .height = number(reader, attributes, "height", 0),
                                                    .elevation = number(reader, attributes, "elevation", 0),
                                                    .angle = number(reader, attributes, "angle", 0),
                                                    .opens = opens,
                                                    .visible = is_true(attributes, "visible", true),
                                                    .mirrored = is_true(attributes, "modelMirrored", false),
                                                    .sash = home->sash_count,
                                                    .line = reader->builder->line};
}

static void begin_sash(Reader *reader, const XML_Char **attributes) {
    Home *home = reader->home;
    if (!home->piece_count || !is_room_for(reader, home->sash_count, "sashes"))
        return;
    home->sashes = memory_reserve(home->sashes, &home->sash_capacity, home->sash_count + 1, sizeof *home->sashes);
    home->sashes[home->sash_count++] = (HomeSash){.x_axis = number(reader, attributes, "xAxis", 0),
                                                  .y_axis = number(reader, attributes, "yAxis", 0),
                                                  .width = number(reader, attributes, "width", 1),
                                                  .start = number(reader, attributes, "startAngle", 0),
                                                  .end = number(reader, attributes, "endAngle", 0)};
    home->pieces[home->piece_count - 1].sash_count++;
}

static void begin_room(Reader *reader, const XML_Char **attributes) {
    Home *home = reader->home;
    if (!is_room_for(reader, home->room_count, "rooms"))
        return;
    home->rooms = memory_reserve(home->rooms, &home->room_capacity, home->room_count + 1, sizeof *home->rooms);
    home->rooms[home->room_count++] = (HomeRoom){
        .level = level_of(reader, attributes), .name = text(reader, attributes, "name"), .point = home->point_count};
    reader->in_room = true;
}

static void begin_point(Reader *reader, const XML_Char **attributes) {
    Home *home = reader->home;
    if (!reader->in_room || !is_room_for(reader, home->point_count, "points of rooms"))
        return;
    home->points = memory_reserve(home->points, &home->point_capacity, home->point_count + 1, sizeof *home->points);
    home->points[home->point_count++] = place(reader, attributes, "x", "y");
    home->rooms[home->room_count - 1].point_count++;
}

static void begin_level(Reader *reader, const XML_Char **attributes) {
    Home *home = reader->home;
    if (!is_room_for(reader, home->level_count, "storeys"))
        return;
    home->levels = memory_reserve(home->levels, &home->level_capacity, home->level_count + 1, sizeof *home->levels);
    home->levels[home->level_count++] = (HomeLevel){.id = text(reader, attributes, "id"),
                                                    .name = text(reader, attributes, "name"),
                                                    .elevation = number(reader, attributes, "elevation", 0)};
}

static void begin_other(Reader *reader, const char *name) {
    Home *home = reader->home;
    home->polylines += strcmp(name, "polyline") == 0;
    home->labels += strcmp(name, "label") == 0;
    home->dimensions += strcmp(name, "dimensionLine") == 0;
    home->pictures += strcmp(name, "backgroundImage") == 0;
}

static void stop(Reader *reader) {
    XML_StopParser(reader->parser, XML_FALSE);
}

static void XMLCALL begin(void *context, const XML_Char *name, const XML_Char **attributes) {
    Reader *reader = context;
    reader->builder->line = (int)XML_GetCurrentLineNumber(reader->parser);
    if (reader->depth == 0 && strcmp(name, "home") != 0)
        house_builder_fail(reader->builder, "Home.xml begins with <%.40s>, must begin with <home>", name);
    else if (reader->depth == DEEPEST)
        house_builder_fail(reader->builder, "Home.xml is nested too deeply, must be at most %d deep", DEEPEST);
    else if (strcmp(name, "wall") == 0)
        begin_wall(reader, attributes);
    else if (strcmp(name, "doorOrWindow") == 0)
        begin_piece(reader, attributes, true);
    else if (strcmp(name, "pieceOfFurniture") == 0 || strcmp(name, "light") == 0 || strcmp(name, "shelfUnit") == 0)
        begin_piece(reader, attributes, false);
    else if (strcmp(name, "sash") == 0)
        begin_sash(reader, attributes);
    else if (strcmp(name, "room") == 0)
        begin_room(reader, attributes);
    else if (strcmp(name, "point") == 0)
        begin_point(reader, attributes);
    else if (strcmp(name, "level") == 0)
        begin_level(reader, attributes);
    else
        begin_other(reader, name);
    if (reader->builder->failed) {
        stop(reader);
        return;
    }
    reader->levels[reader->depth] = strcmp(name, "furnitureGroup") == 0 ? level_of(reader, attributes) : "";
    reader->depth++;
}

static void XMLCALL end(void *context, const XML_Char *name) {
    Reader *reader = context;
    reader->depth--;
    reader->in_room &= strcmp(name, "room") != 0;
}

/* Refuses entities: an entity can expand without end or read another file, and homes have none. */
static void XMLCALL declare_entity(void *context, const XML_Char *name, int is_parameter, const XML_Char *value,
                                   int value_length, const XML_Char *base, const XML_Char *system,
                                   const XML_Char *public, const XML_Char *notation) {
    (void)is_parameter, (void)value, (void)value_length, (void)base, (void)system, (void)public, (void)notation;
    Reader *reader = context;
    reader->builder->line = (int)XML_GetCurrentLineNumber(reader->parser);
    house_builder_fail(reader->builder, "Home.xml declares the entity \"%.40s\", must declare none", name);
    stop(reader);
}

static bool parse(Reader *reader, const char *bytes, int count, bool last) {
    if (XML_Parse(reader->parser, bytes, count, last) == XML_STATUS_OK)
        return true;
    if (reader->builder->failed)
        return false;
    reader->builder->failed = true;
    fault_add(reader->builder->fault, "%s:%lu:%lu: Home.xml: %s", reader->builder->path,
              (unsigned long)XML_GetCurrentLineNumber(reader->parser),
              (unsigned long)XML_GetCurrentColumnNumber(reader->parser) + 1,
              XML_ErrorString(XML_GetErrorCode(reader->parser)));
    return false;
}

/* The zip file ---------------------------------------------------------------------------------------------------- */

static bool unpack(Reader *reader, zip_file_t *entry) {
    char *bytes = memory_zeroed(CHUNK, 1);
    zip_int64_t got = 0, total = 0;
    bool good = true;
    while (good && (got = zip_fread(entry, bytes, CHUNK)) > 0) {
        total += got;
        good = total <= LARGEST_XML
                   ? parse(reader, bytes, (int)got, false)
                   : house_builder_fail(reader->builder, "Home.xml is larger than %d MB", LARGEST_XML / 1024 / 1024);
    }
    memory_free(bytes);
    if (good && got < 0) {
        reader->builder->line = 1;
        good = house_builder_fail(reader->builder, "Home.xml cannot be unpacked: %s",
                                  zip_error_strerror(zip_file_get_error(entry)));
    }
    return good && parse(reader, "", 0, true);
}

/* True if the size that the zip file states for Home.xml is acceptable. */
static bool check_size(HouseBuilder *builder, const zip_stat_t *status) {
    if (!(status->valid & ZIP_STAT_SIZE) || !(status->valid & ZIP_STAT_COMP_SIZE))
        return house_builder_fail(builder, "the zip file does not state the size of Home.xml");
    if (status->size > LARGEST_XML)
        return house_builder_fail(builder, "Home.xml is larger than %d MB", LARGEST_XML / 1024 / 1024);
    if (status->size > HARMLESS && status->size / MOST_SHRUNK > status->comp_size)
        return house_builder_fail(builder, "Home.xml is compressed more than %d times, unlike any home", MOST_SHRUNK);
    return true;
}

static bool read_entry(Reader *reader, zip_t *zip) {
    HouseBuilder *builder = reader->builder;
    zip_int64_t index = zip_name_locate(zip, "Home.xml", 0);
    if (index < 0 && zip_name_locate(zip, "Home", 0) >= 0)
        return house_builder_fail(builder, "Home.xml is missing: open the home in Sweet Home 3D 5.3 or "
                                           "newer and save it again");
    if (index < 0)
        return house_builder_fail(builder, "the file is not a Sweet Home 3D home: Home.xml is missing");
    zip_stat_t status;
    if (zip_stat_index(zip, (zip_uint64_t)index, 0, &status))
        return house_builder_fail(builder, "Home.xml cannot be unpacked: %s", zip_strerror(zip));
    if (!check_size(builder, &status))
        return false;
    zip_file_t *entry = zip_fopen_index(zip, (zip_uint64_t)index, 0);
    if (!entry)
        return house_builder_fail(builder, "Home.xml cannot be unpacked: %s", zip_strerror(zip));
    reader->parser = XML_ParserCreate(NULL);
    XML_SetUserData(reader->parser, reader);
    XML_SetElementHandler(reader->parser, begin, end);
    XML_SetEntityDeclHandler(reader->parser, declare_entity);
    bool good = unpack(reader, entry);
    XML_ParserFree(reader->parser);
    zip_fclose(entry);
    return good;
}

bool sh3d_home_read(Home *home, HouseBuilder *builder) {
    int code = 0;
    zip_t *zip = zip_open(builder->path, ZIP_RDONLY, &code);
    if (!zip) {
        zip_error_t error;
        zip_error_init_with_code(&error, code);
        house_builder_fail(builder, "the file is not a zip file, as Sweet Home 3D homes are: %s",
                           zip_error_strerror(&error));
        zip_error_fini(&error);
        return false;
    }
    Reader reader = {.home = home, .builder = builder};
    bool good = read_entry(&reader, zip);
    zip_discard(zip);
    builder->line = 1;
    return good;
}

void sh3d_home_clear(Home *home) {
    memory_free(home->walls);
    memory_free(home->pieces);
    memory_free(home->sashes);
    memory_free(home->rooms);
    memory_free(home->points);
    memory_free(home->levels);
    arena_clear(&home->arena);
    *home = (Home){0};
}
