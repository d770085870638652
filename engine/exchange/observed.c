#include "exchange/observed.h"

#include <csv.h>
#include <ctype.h>
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/parameters.h"
#include "base/text.h"

enum {
    LARGEST_FILE = 64 * 1024 * 1024, /* bytes: half a day of ten people, 25 rows a second */
    MOST_PEOPLE = 1000,
    SHOWN = 40, /* characters of the file in a fault */
};

#define LONGEST_TIME 1e6 /* s */

enum { COLUMN_TIME, COLUMN_X, COLUMN_Y, COLUMN_PERSON, COLUMNS };

static const struct {
    const char *name, *other; /* both are understood */
    const char *unit;         /* NULL: words */
    double farthest;
} known[COLUMNS] = {[COLUMN_TIME] = {"time", "t", "s", LONGEST_TIME},
                    [COLUMN_X] = {"x", "x", "m", PARAMETER_FARTHEST},
                    [COLUMN_Y] = {"y", "y", "m", PARAMETER_FARTHEST},
                    [COLUMN_PERSON] = {"person", "id", NULL, 0}};

typedef struct Place {
    int line, column; /* from 1 */
} Place;

typedef struct Row {
    double time; /* s */
    Vec2 at;     /* m */
    size_t locus;
    int line;
} Row;

typedef struct Reader {
    const char *path;
    Fault *fault;
    Place at;               /* of the byte that is read */
    Place begin;            /* of the field that is read */
    bool begun;             /* has something of it been seen? */
    bool head;              /* has the row of names been read? */
    int column_of[COLUMNS]; /* in the file, or -1 */
    int field, fields;      /* the present one; how many the head has */
    Place row_begin;
    double numbers[COLUMNS];
    const char *person;
    bool good; /* is all of this row? */
    Row *rows; /* (row_count) */
    size_t row_count, row_capacity, loci_capacity;
    ObservedLoci loci; /* without points until all is read */
} Reader;

static void fault_at(Reader *reader, Place place, const char *what, const char *text, const char *wanted) {
    fault_add(reader->fault, "%s:%d:%d: %s%s%.*s%s%s", reader->path, place.line, place.column, what, text ? " \"" : "",
              SHOWN, text ? text : "", text ? "\"" : "", wanted);
    reader->good = false;
}

/* The head -------------------------------------------------------------------------------------------------------- */

/* The column that a name like "time [s]" or "X" means, or -1; its unit, "" without one. */
static int find_column(const char *text, char unit[SHOWN]) {
    size_t length = strcspn(text, " [(");
    const char *from = text + strcspn(text, "[(");
    snprintf(unit, SHOWN, "%.*s", (int)strcspn(from + (*from != 0), "])"), from + (*from != 0));
    for (int c = 0; c < COLUMNS; c++)
        for (int other = 0; other <= 1; other++) {
            const char *name = other ? known[c].other : known[c].name;
            if (strlen(name) == length && strncasecmp(text, name, length) == 0)
                return c;
        }
    return -1;
}

static void read_name(Reader *reader, const char *text) {
    char unit[SHOWN];
    int column = find_column(text, unit);
    if (column < 0)
        return;
    if (reader->column_of[column] >= 0)
        fault_at(reader, reader->begin, "there is a second column", text, ", must be one");
    else if (known[column].unit && *unit && strcmp(unit, known[column].unit) != 0)
        fault_add(reader->fault, "%s:%d:%d: %s is in %s, must be in %s", reader->path, reader->begin.line,
                  reader->begin.column, known[column].name, unit, known[column].unit);
    reader->column_of[column] = reader->field;
}

static void end_head(Reader *reader) {
    reader->head = true;
    reader->fields = reader->field;
    for (int c = 0; c < COLUMN_PERSON; c++)
        if (reader->column_of[c] < 0)
            fault_at(reader, reader->row_begin, "there is no column", known[c].name,
                     ", the first row must name time, x and y");
}

/* Rows ------------------------------------------------------------------------------------------------------------ */

static void read_number(Reader *reader, int column, const char *text) {
    char *end, what[32], wanted[64];
    double value = strtod(text, &end);
    bool plain = *text && !*end && text[strspn(text, "+-.0123456789eE")] == 0;
    snprintf(what, sizeof what, "%s is", known[column].name);
    snprintf(wanted, sizeof wanted, ", must be a number from %g to %g %s", -known[column].farthest,
             known[column].farthest, known[column].unit);
    if (!plain && text[strspn(text, "+-,0123456789")] == 0 && strchr(text, ','))
        fault_at(reader, reader->begin, what, text, ", must have a decimal point");
    else if (!plain || !(fabs(value) <= known[column].farthest))
        fault_at(reader, reader->begin, what, text, wanted);
    reader->numbers[column] = value;
}

static void read_field(void *bytes, size_t size, void *context) {
    Reader *reader = context;
    const char *text = bytes;
    if (!reader->begun)
        reader->begin = reader->at;
    if (reader->field == 0) {
        reader->row_begin = reader->begin;
        reader->good = true;
        reader->person = "";
    }
    if (strlen(text) != size)
        fault_at(reader, reader->begin, "there is a byte 0", NULL, ", must be text");
    else if (!reader->head)
        read_name(reader, text);
    else if (reader->field == reader->column_of[COLUMN_PERSON])
        reader->person = arena_text(&reader->loci.arena, text);
    for (int c = 0; c < COLUMN_PERSON && reader->head && strlen(text) == size; c++)
        if (reader->field == reader->column_of[c])
            read_number(reader, c, text);
    reader->field++;
    reader->begun = false;
}

/* Who is meant, found or new. */
static size_t find_locus(Reader *reader) {
    ObservedLoci *loci = &reader->loci;
    size_t last = reader->row_count ? reader->rows[reader->row_count - 1].locus : 0;
    if (loci->count && strcmp(loci->loci[last].person, reader->person) == 0)
        return last;
    for (size_t i = 0; i < loci->count; i++)
        if (strcmp(loci->loci[i].person, reader->person) == 0)
            return i;
    loci->loci = memory_reserve(loci->loci, &reader->loci_capacity, loci->count + 1, sizeof *loci->loci);
    loci->loci[loci->count] = (ObservedLocus){.person = reader->person, .line = reader->row_begin.line};
    return loci->count++;
}

static void end_row(int terminator, void *context) {
    Reader *reader = context;
    (void)terminator;
    if (!reader->head) {
        end_head(reader);
    } else if (reader->field < reader->fields) {
        fault_add(reader->fault, "%s:%d:%d: the row has %d columns, must have %d", reader->path, reader->row_begin.line,
                  reader->row_begin.column, reader->field, reader->fields);
    } else if (reader->good && reader->loci.count <= MOST_PEOPLE) {
        Row row = {.time = reader->numbers[COLUMN_TIME],
                   .at = {reader->numbers[COLUMN_X], reader->numbers[COLUMN_Y]},
                   .locus = find_locus(reader),
                   .line = reader->row_begin.line};
        reader->rows = memory_reserve(reader->rows, &reader->row_capacity, reader->row_count + 1, sizeof row);
        reader->rows[reader->row_count++] = row;
    }
    reader->field = 0;
}

/* The file -------------------------------------------------------------------------------------------------------- */

/* The separator that the first row has most of. */
static char find_separator(const char *text) {
    const char separators[] = {',', ';', '\t'};
    size_t most = 0, counts[sizeof separators] = {0};
    for (const char *at = text; *at && *at != '\n' && *at != '\r'; at++)
        for (size_t s = 0; s < sizeof separators; s++)
            counts[s] += *at == separators[s];
    for (size_t s = 1; s < sizeof separators; s++)
        most = counts[s] > counts[most] ? s : most;
    return separators[most];
}

/* Byte by byte, so that each field's place is known; libcsv tells none. */
static void read_text(Reader *reader, const char *text, size_t size) {
    struct csv_parser parser;
    csv_init(&parser, CSV_STRICT | CSV_STRICT_FINI | CSV_APPEND_NULL);
    csv_set_delim(&parser, (unsigned char)find_separator(text));
    bool good = true;
    for (size_t i = 0; i < size && good; i++) {
        if (!reader->begun && !isspace((unsigned char)text[i])) {
            reader->begun = true;
            reader->begin = reader->at;
        }
        good = csv_parse(&parser, text + i, 1, read_field, end_row, reader) == 1;
        if (good && text[i] == '\n')
            reader->at = (Place){reader->at.line + 1, 1};
        else if (good && ((unsigned char)text[i] & 0xc0) != 0x80) /* not within a character of UTF-8 */
            reader->at.column++;
    }
    if (!good)
        fault_at(reader, reader->at, "not CSV: a quotation mark within a field", NULL, ", must be doubled");
    else if (csv_fini(&parser, read_field, end_row, reader) != 0)
        fault_at(reader, reader->begin, "not CSV: the quotation mark is not closed", NULL, "");
    csv_free(&parser);
}

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
            fault_add(reader->fault, "%s:%d:1: time %g s is that of line %d, must be another", reader->path, row->line,
                      row->time, before->line);
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
            fault_add(reader->fault, "%s:%d:1: there is one place only of %s, must be two or more", reader->path,
                      observed->line, *observed->person ? observed->person : "this person");
        observed->locus.points = memory_allocate(count, sizeof *observed->locus.points);
        observed->locus.times = memory_allocate(count, sizeof *observed->locus.times);
        for (; observed->locus.count < count; row++) {
            observed->locus.points[observed->locus.count] = row->at;
            observed->locus.times[observed->locus.count++] = row->time;
        }
    }
}

static void check_whole(Reader *reader, size_t before) {
    if (reader->fault->total != before)
        return;
    if (!reader->head)
        fault_add(reader->fault, "%s:1:1: empty, the first row must name time, x and y", reader->path);
    else if (!reader->row_count)
        fault_add(reader->fault, "%s:%d:1: there is no place, must be two or more", reader->path, reader->at.line);
    else if (reader->loci.count > MOST_PEOPLE)
        fault_add(reader->fault, "%s:%d:1: there are too many people, must be at most %d", reader->path,
                  reader->loci.loci[MOST_PEOPLE].line, MOST_PEOPLE);
}

bool observed_read(ObservedLoci *loci, const char *path, Fault *fault) {
    size_t before = fault->total, size = 0;
    char *text = text_read_file(path, LARGEST_FILE, &size);
    if (!text) {
        fault_add(fault, "%s:1:1: cannot be read: %s", path, strerror(errno));
        return false;
    }
    static const char mark[] = "\xef\xbb\xbf"; /* some editors begin UTF-8 with it */
    size_t skip = strncmp(text, mark, strlen(mark)) == 0 ? strlen(mark) : 0;
    Reader reader = {.path = path, .fault = fault, .at = {1, 1}, .column_of = {-1, -1, -1, -1}, .row_begin = {1, 1}};
    reader.loci.path = arena_text(&reader.loci.arena, path);
    read_text(&reader, text + skip, size - skip);
    check_whole(&reader, before);
    if (fault->total == before)
        sort_rows(&reader);
    if (fault->total == before)
        fill_loci(&reader);
    memory_free(text);
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
