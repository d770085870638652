#include "exchange/timed.h"

#include <math.h>
#include <string.h>
#include <strings.h>

#include "exchange/table.h"

enum { LARGEST_FILE = 1024 * 1024 /* bytes */ };

static const double LONGEST = 1e5; /* s */

typedef enum Column { COLUMN_ROUTE, COLUMN_TIME, COLUMN_DEVIATION, COLUMNS } Column;

static const char *const names[COLUMNS] = {"route", "time", "deviation"};

typedef struct Reader {
    TableReader table;
    Timed *timed;
    int column_of[COLUMNS]; /* -1: none */
    bool head;              /* the row of names has been read */
    int fields;             /* number of columns in the heading */
    bool good;              /* all values of this row are valid */
    TimedRun row;
    const char *path; /* in the arena */
} Reader;

static void read_name(Reader *reader, TablePlace place, int index, const char *text) {
    char unit[TABLE_SHOWN];
    size_t length = table_heading(text, unit);
    for (int c = 0; c < COLUMNS; c++) {
        if (strlen(names[c]) != length || strncasecmp(text, names[c], length) != 0)
            continue;
        if (reader->column_of[c] >= 0)
            table_fault(&reader->table, place, "a second column is named", text, ", must be one");
        else if (c != COLUMN_ROUTE && *unit && strcmp(unit, "s") != 0)
            table_fault(&reader->table, place, "the unit is", unit, ", must be s");
        reader->column_of[c] = index;
    }
}

static void read_number(Reader *reader, TablePlace place, Column column, const char *text, double *value) {
    bool empty = !*text && column == COLUMN_DEVIATION;
    *value = NAN;
    if (empty)
        return;
    if (!table_number(&reader->table, place, names[column], "s", LONGEST, text, value)) {
        reader->good = false;
    } else if (!(*value > 0)) {
        table_fault(&reader->table, place, column == COLUMN_TIME ? "time is" : "deviation is", text,
                    ", must be more than 0");
        reader->good = false;
    }
}

static void read_cell(Reader *reader, TablePlace place, int index, const char *text) {
    if (index == reader->column_of[COLUMN_ROUTE]) {
        reader->row.route = arena_text(&reader->timed->arena, text);
        reader->good &= *text != 0;
        if (!*text)
            table_fault(&reader->table, place, "the route has no name", NULL, ", must be an id of the house");
    }
    if (index == reader->column_of[COLUMN_TIME])
        read_number(reader, place, COLUMN_TIME, text, &reader->row.time);
    if (index == reader->column_of[COLUMN_DEVIATION])
        read_number(reader, place, COLUMN_DEVIATION, text, &reader->row.deviation);
}

static void take_field(void *context, TablePlace place, int index, const char *text) {
    Reader *reader = context;
    if (index == 0) {
        reader->row =
            (TimedRun){.route = NULL, .time = NAN, .deviation = NAN, .path = reader->path, .line = place.line};
        reader->good = true;
    }
    if (!text)
        reader->good = false;
    else if (reader->head)
        read_cell(reader, place, index, text);
    else
        read_name(reader, place, index, text);
}

static void end_row(void *context, TablePlace begin, int fields) {
    Reader *reader = context;
    Timed *timed = reader->timed;
    if (!reader->head) {
        reader->head = true;
        reader->fields = fields;
        if (!reader->good) /* a name that cannot be read may be the one that lacks */
            return;
        if (reader->column_of[COLUMN_ROUTE] < 0 || reader->column_of[COLUMN_TIME] < 0)
            fault_add(reader->table.fault, "%s:%d:%d: the first row must name route and time", reader->table.path,
                      begin.line, begin.column);
        return;
    }
    if (table_row_fits(&reader->table, begin, fields, reader->fields) && reader->good) {
        timed->runs = memory_reserve(timed->runs, &timed->capacity, timed->count + 1, sizeof *timed->runs);
        timed->runs[timed->count++] = reader->row;
    }
}

bool timed_read(Timed *timed, const char *path, Fault *fault) {
    size_t before = fault->total, count = timed->count;
    Reader reader = {.table = {.path = path, .fault = fault, .take_field = take_field, .end_row = end_row},
                     .timed = timed,
                     .path = arena_text(&timed->arena, path),
                     .column_of = {-1, -1, -1}};
    reader.table.context = &reader;
    TablePlace end = table_read(&reader.table, LARGEST_FILE);
    if (fault->total == before && !reader.head)
        fault_add(fault, "%s:1:1: empty, the first row must name route and time", path);
    else if (fault->total == before && timed->count == count)
        fault_add(fault, "%s:%d:1: the table has no runs, it must have at least one", path, end.line);
    if (fault->total == before)
        return true;
    timed->count = count;
    return false;
}

void timed_free(Timed *timed) {
    memory_free(timed->runs);
    arena_clear(&timed->arena);
    *timed = (Timed){0};
}
