#include "exchange/measured.h"

#include <assert.h>
#include <math.h>
#include <string.h>

#include "base/text.h"
#include "exchange/table.h"

enum { LARGEST_FILE = 16 * 1024 * 1024 /* bytes: a minute of an oscilloscope at 10 kHz */ };

#define LARGEST 1e15 /* in any unit */

typedef struct Reader {
    TableReader table;
    const MeasuredKind *kinds; /* (kind_count) */
    size_t kind_count;
    int column_of[MEASURED_KINDS]; /* column in the file, or -1 */
    double scale[MEASURED_KINDS];  /* from the unit of the file to the unit of the kind */
    double row[MEASURED_KINDS];
    bool head; /* the row of names has been read */
    int fields;
    bool good;     /* all values of this row are valid */
    size_t before; /* number of errors before */
    Measured measured;
} Reader;

/* The head -------------------------------------------------------------------------------------------------------- */

static bool is_called(const char *text, size_t length, const char *name) {
    return name && strlen(name) == length && strncasecmp(text, name, length) == 0;
}

static const char *last_part(const char *name) {
    const char *dot = strrchr(name, '.');
    return dot ? dot + 1 : name;
}

/* Returns the index of the kind that a heading names, or kind_count. */
static size_t find_kind(const Reader *reader, const char *text, size_t length) {
    for (size_t k = 0; k < reader->kind_count; k++) {
        const MeasuredKind *kind = &reader->kinds[k];
        if (is_called(text, length, kind->name) || is_called(text, length, kind->other) ||
            is_called(text, length, last_part(kind->name)))
            return k;
    }
    return reader->kind_count;
}

/* Returns the number of `wanted` in one `unit`, or 0 if the units are unrelated. */
static double unit_scale(const char *unit, const char *wanted) {
    static const struct {
        const char *prefix;
        double scale;
    } prefixes[] = {{"m", 1e-3}, {"k", 1e3}, {"u", 1e-6}, {"\u00B5", 1e-6}, {"\u03BC", 1e-6}};
    if (!*unit || strcmp(unit, wanted) == 0)
        return 1;
    for (size_t p = 0; p < sizeof prefixes / sizeof *prefixes; p++) {
        size_t length = strlen(prefixes[p].prefix);
        if (strcmp(wanted, "1") != 0 && strncmp(unit, prefixes[p].prefix, length) == 0 &&
            strcmp(unit + length, wanted) == 0)
            return prefixes[p].scale;
    }
    return 0;
}

/* Reports a name that is close to a known one as a probable typing error. */
static void fault_slip(Reader *reader, TablePlace place, const char *text, size_t length) {
    const char *names[MEASURED_KINDS];
    Arena arena = {0};
    char *name = arena_allocate(&arena, length + 1);
    memcpy(name, text, length);
    for (size_t k = 0; k < reader->kind_count; k++)
        names[k] = reader->kinds[k].name;
    const char *nearest = text_nearest(name, names, reader->kind_count);
    if (nearest)
        fault_add(reader->table.fault, "%s:%d:%d: unknown column \"%.*s\", did you mean %s?", reader->table.path,
                  place.line, place.column, TABLE_SHOWN, name, nearest);
    arena_clear(&arena);
}

static void read_name(Reader *reader, TablePlace place, int index, const char *text) {
    char unit[TABLE_SHOWN];
    size_t length = table_heading(text, unit), k = find_kind(reader, text, length);
    if (k == reader->kind_count) {
        fault_slip(reader, place, text, length);
        return;
    }
    reader->scale[k] = unit_scale(unit, reader->kinds[k].unit);
    if (reader->column_of[k] >= 0)
        table_fault(&reader->table, place, "a second column is named", text, ", must be one");
    else if (reader->scale[k] == 0)
        fault_add(reader->table.fault, "%s:%d:%d: %s is in %s, must be in %s", reader->table.path, place.line,
                  place.column, reader->kinds[k].name, unit, reader->kinds[k].unit);
    else
        reader->measured.column_count++;
    reader->column_of[k] = index;
}

/* Lists the names that the first row may have. */
static void fault_columns(const Reader *reader, TablePlace begin) {
    Text list = {0};
    for (size_t k = 0; k < reader->kind_count; k++)
        text_format(&list, "%s%s [%s]", k ? ", " : "", reader->kinds[k].name, reader->kinds[k].unit);
    fault_add(reader->table.fault, "%s:%d:%d: the first row must name two or more of %s", reader->table.path,
              begin.line, begin.column, list.text ? list.text : "nothing");
    memory_free(list.text);
}

static void end_head(Reader *reader, TablePlace begin, int fields) {
    Measured *measured = &reader->measured;
    reader->head = true;
    reader->fields = fields;
    if (measured->column_count < 2 && reader->table.fault->total == reader->before)
        fault_columns(reader, begin);
    measured->columns = memory_zeroed(measured->column_count + 1, sizeof *measured->columns);
    size_t column = 0;
    for (size_t k = 0; k < reader->kind_count && column < measured->column_count; k++)
        if (reader->column_of[k] >= 0 && reader->scale[k] != 0)
            measured->columns[column++].name = arena_text(&measured->arena, reader->kinds[k].name);
}

/* Rows ------------------------------------------------------------------------------------------------------------ */

static void read_value(Reader *reader, TablePlace place, size_t k, const char *text) {
    const MeasuredKind *kind = &reader->kinds[k];
    reader->row[k] = NAN;
    if (!*text)
        return;
    double value;
    if (table_number(&reader->table, place, kind->name, kind->unit, LARGEST, text, &value))
        reader->row[k] = value * reader->scale[k];
    else
        reader->good = false;
}

static void take_field(void *context, TablePlace place, int index, const char *text) {
    Reader *reader = context;
    if (index == 0)
        reader->good = true;
    if (!text)
        reader->good = false;
    else if (!reader->head)
        read_name(reader, place, index, text);
    for (size_t k = 0; k < reader->kind_count && reader->head && text; k++)
        if (index == reader->column_of[k])
            read_value(reader, place, k, text);
}

static void end_row(void *context, TablePlace begin, int fields) {
    Reader *reader = context;
    Measured *measured = &reader->measured;
    if (!reader->head) {
        end_head(reader, begin, fields);
    } else if (table_row_fits(&reader->table, begin, fields, reader->fields) && reader->good) {
        size_t column = 0;
        for (size_t k = 0; k < reader->kind_count && column < measured->column_count; k++) {
            if (reader->column_of[k] < 0 || reader->scale[k] == 0)
                continue;
            MeasuredColumn *filled = &measured->columns[column++];
            filled->values =
                memory_reserve(filled->values, &filled->capacity, measured->count + 1, sizeof *filled->values);
            filled->values[measured->count] = reader->row[k];
        }
        measured->count++;
    }
}

bool measured_read(Measured *measured, const char *path, const MeasuredKind *kinds, size_t kind_count, Fault *fault) {
    assert(kind_count <= MEASURED_KINDS);
    size_t before = fault->total;
    Reader reader = {.table = {.path = path, .fault = fault, .take_field = take_field, .end_row = end_row},
                     .kinds = kinds,
                     .kind_count = kind_count,
                     .before = before};
    reader.table.context = &reader;
    memset(reader.column_of, -1, sizeof reader.column_of);
    reader.measured.path = arena_text(&reader.measured.arena, path);
    TablePlace end = table_read(&reader.table, LARGEST_FILE);
    if (fault->total == before && !reader.head)
        fault_columns(&reader, (TablePlace){1, 1});
    else if (fault->total == before && !reader.measured.count)
        fault_add(fault, "%s:%d:1: the table has no points, it must have at least one", path, end.line);
    if (fault->total != before) {
        measured_free(&reader.measured);
        return false;
    }
    measured_free(measured);
    *measured = reader.measured;
    return true;
}

void measured_free(Measured *measured) {
    for (size_t c = 0; c < measured->column_count && measured->columns; c++)
        memory_free(measured->columns[c].values);
    memory_free(measured->columns);
    arena_clear(&measured->arena);
    *measured = (Measured){.count = 0};
}

const double *measured_find(const Measured *measured, const char *name) {
    for (size_t c = 0; measured && c < measured->column_count; c++)
        if (strcmp(measured->columns[c].name, name) == 0)
            return measured->columns[c].values;
    return NULL;
}
