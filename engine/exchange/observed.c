#include "exchange/observed.h"

#include <stdlib.h>
#include <string.h>

#include "base/parameters.h"
#include "base/text.h"
#include "exchange/table.h"

enum {
    LARGEST_FILE = 64 * 1024 * 1024, /* bytes: half a day of ten people at 25 rows per second */
    MOST_PEOPLE = 1000,
};

#define LONGEST_TIME 1e6 /* s */

enum { COLUMN_TIME, COLUMN_X, COLUMN_Y, COLUMN_PERSON, COLUMNS };

static const struct {
    const char *name, *other; /* both names are understood */
    const char *unit;         /* NULL: text */
    double farthest;
} known[COLUMNS] = {[COLUMN_TIME] = {"time", "t", "s", LONGEST_TIME},
                    [COLUMN_X] = {"x", "x", "m", PARAMETER_FARTHEST},
                    [COLUMN_Y] = {"y", "y", "m", PARAMETER_FARTHEST},
                    [COLUMN_PERSON] = {"person", "id", NULL, 0}};

typedef struct Row {
    double time; /* s */
    Vec2 at;     /* m */
    size_t locus;
    int line;
} Row;

typedef struct Reader {
    TableReader table;
    bool head;              /* the row of names has been read */
    int column_of[COLUMNS]; /* column in the file, or -1 */
    int fields;             /* number of columns in the heading */
    double numbers[COLUMNS];
    const char *person;
    bool good; /* all values of this row are valid */
    Row *rows; /* (row_count) */
    size_t row_count, row_capacity, loci_capacity;
    ObservedLoci loci; /* without points until the whole file is read */
} Reader;

/* The head -------------------------------------------------------------------------------------------------------- */

/* Returns the column that a name such as "time [s]" or "X" means, or -1; `unit` receives its unit, or "". */
static int find_column(const char *text, char unit[TABLE_SHOWN]) {
    size_t length = table_heading(text, unit);
    for (int c = 0; c < COLUMNS; c++)
        for (int other = 0; other <= 1; other++) {
            const char *name = other ? known[c].other : known[c].name;
            if (strlen(name) == length && strncasecmp(text, name, length) == 0)
                return c;
        }
    return -1;
}

static void read_name(Reader *reader, TablePlace place, int index, const char *text) {
    char unit[TABLE_SHOWN];
    int column = find_column(text, unit);
    if (column < 0)
        return;
    if (reader->column_of[column] >= 0)
        table_fault(&reader->table, place, "a second column is named", text, ", must be one");
    else if (known[column].unit && *unit && strcmp(unit, known[column].unit) != 0)
        fault_add(reader->table.fault, "%s:%d:%d: %s is in %s, must be in %s", reader->table.path, place.line,
                  place.column, known[column].name, unit, known[column].unit);
    reader->column_of[column] = index;
}

/* Adds one error for all columns that the heading lacks. */
static void check_head(Reader *reader, TablePlace begin) {
    const char *lacking[COLUMNS];
    size_t count = 0;
    Text list = {0};
    for (int c = 0; c < COLUMN_PERSON; c++)
        if (reader->column_of[c] < 0)
            lacking[count++] = known[c].name;
    for (size_t i = 0; i < count; i++)
        text_format(&list, "%s\"%s\"", i == 0 ? "" : i + 1 == count ? " and " : ", ", lacking[i]);
    if (count)
        fault_add(reader->table.fault,
                  "%s:%d:%d: the heading lacks the column%s %s, the first row must name time, x and y",
                  reader->table.path, begin.line, begin.column, count > 1 ? "s" : "", list.text);
    memory_free(list.text);
}

static void end_head(Reader *reader, TablePlace begin, int fields) {
    reader->head = true;
    reader->fields = fields;
    if (reader->good) /* otherwise a name that cannot be read may be the one that lacks */
        check_head(reader, begin);
}

/* Rows ------------------------------------------------------------------------------------------------------------ */

static void take_field(void *context, TablePlace place, int index, const char *text) {
    Reader *reader = context;
    if (index == 0) {
        reader->good = true;
        reader->person = "";
    }
    if (!text)
        reader->good = false;
    else if (!reader->head)
        read_name(reader, place, index, text);
    else if (index == reader->column_of[COLUMN_PERSON])
        reader->person = arena_text(&reader->loci.arena, text);
    for (int c = 0; c < COLUMN_PERSON && reader->head && text; c++)
        if (index == reader->column_of[c] && !table_number(&reader->table, place, known[c].name, known[c].unit,
                                                           known[c].farthest, text, &reader->numbers[c]))
            reader->good = false;
}

/* Finds or adds the locus of a person. */
static size_t find_locus(Reader *reader, int line) {
    ObservedLoci *loci = &reader->loci;
    size_t last = reader->row_count ? reader->rows[reader->row_count - 1].locus : 0;
    if (loci->count && strcmp(loci->loci[last].person, reader->person) == 0)
        return last;
    for (size_t i = 0; i < loci->count; i++)
        if (strcmp(loci->loci[i].person, reader->person) == 0)
            return i;
    loci->loci = memory_reserve(loci->loci, &reader->loci_capacity, loci->count + 1, sizeof *loci->loci);
    loci->loci[loci->count] = (ObservedLocus){.person = reader->person, .line = line};
    return loci->count++;
}

static void end_row(void *context, TablePlace begin, int fields) {
    Reader *reader = context;
    if (!reader->head) {
        end_head(reader, begin, fields);
    } else if (table_row_fits(&reader->table, begin, fields, reader->fields) && reader->good &&
               reader->loci.count <= MOST_PEOPLE) {
        Row row = {.time = reader->numbers[COLUMN_TIME],
                   .at = {reader->numbers[COLUMN_X], reader->numbers[COLUMN_Y]},
                   .locus = find_locus(reader, begin.line),
                   .line = begin.line};
        reader->rows = memory_reserve(reader->rows, &reader->row_capacity, reader->row_count + 1, sizeof row);
        reader->rows[reader->row_count++] = row;
    }
}

/* The file -------------------------------------------------------------------------------------------------------- */

static int compare_rows(const void *a, const void *b) {
    const Row *p = a, *q = b;
    if (p->locus != q->locus)
        return (p->locus > q->locus) - (p->locus < q->locus);
    return p->time != q->time ? (p->time > q->time) - (p->time < q->time) : (p->line > q->line) - (p->line < q->line);
}

static void sort_rows(Reader *reader) {
    if (reader->row_count)
        qsort(reader->rows, reader->row_count, sizeof *reader->rows, compare_rows);
    for (size_t r = 1; r < reader->row_count; r++) {
        const Row *row = &reader->rows[r], *before = row - 1;
        if (row->locus == before->locus && row->time == before->time)
            fault_add(reader->table.fault, "%s:%d:1: time %g s repeats line %d, must differ", reader->table.path,
                      row->line, row->time, before->line);
    }
}

static void fill_loci(Reader *reader) {
    const Row *row = reader->rows, *end = row + reader->row_count;
    for (size_t i = 0; i < reader->loci.count; i++) {
        ObservedLocus *observed = &reader->loci.loci[i];
        size_t count = 0;
        while (row + count < end && row[count].locus == i)
            count++;
        if (count < 2)
            fault_add(reader->table.fault, "%s:%d:1: %s has only one place, must have at least two", reader->table.path,
                      observed->line, *observed->person ? observed->person : "the person");
        observed->locus.points = memory_zeroed(count, sizeof *observed->locus.points);
        observed->locus.times = memory_zeroed(count, sizeof *observed->locus.times);
        for (; observed->locus.count < count; row++) {
            observed->locus.points[observed->locus.count] = row->at;
            observed->locus.times[observed->locus.count++] = row->time;
        }
    }
}

static void check_whole(Reader *reader, size_t before, TablePlace end) {
    const TableReader *table = &reader->table;
    if (table->fault->total != before)
        return;
    if (!reader->head)
        fault_add(table->fault, "%s:1:1: empty, the first row must name time, x and y", table->path);
    else if (!reader->row_count)
        fault_add(table->fault, "%s:%d:1: the table has no places, it must have at least two", table->path, end.line);
    else if (reader->loci.count > MOST_PEOPLE)
        fault_add(table->fault, "%s:%d:1: the table has too many people, must have at most %d", table->path,
                  reader->loci.loci[MOST_PEOPLE].line, MOST_PEOPLE);
}

bool observed_read(ObservedLoci *loci, const char *path, Fault *fault) {
    size_t before = fault->total;
    Reader reader = {.table = {.path = path, .fault = fault, .take_field = take_field, .end_row = end_row},
                     .column_of = {-1, -1, -1, -1}};
    reader.table.context = &reader;
    reader.loci.path = arena_text(&reader.loci.arena, path);
    TablePlace end = table_read(&reader.table, LARGEST_FILE);
    check_whole(&reader, before, end);
    if (fault->total == before)
        sort_rows(&reader);
    if (fault->total == before)
        fill_loci(&reader);
    memory_free(reader.rows);
    if (fault->total != before) {
        observed_free(&reader.loci);
        return false;
    }
    observed_free(loci);
    *loci = reader.loci;
    return true;
}

void observed_free(ObservedLoci *loci) {
    for (size_t i = 0; i < loci->count; i++)
        locus_free(&loci->loci[i].locus);
    memory_free(loci->loci);
    arena_clear(&loci->arena);
    *loci = (ObservedLoci){0};
}
