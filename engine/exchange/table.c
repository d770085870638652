#include "exchange/table.h"

#include <csv.h>
#include <ctype.h>
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "base/text.h"

typedef struct Reading {
    const TableReader *reader;
    TablePlace at;    /* place of the current byte */
    TablePlace begin; /* place of the current field */
    bool begun;       /* part of the field has been read */
    int field;
    TablePlace row_begin;
} Reading;

void table_fault(const TableReader *reader, TablePlace place, const char *what, const char *text, const char *wanted) {
    fault_add(reader->fault, "%s:%d:%d: %s%s%.*s%s%s", reader->path, place.line, place.column, what, text ? " \"" : "",
              TABLE_SHOWN, text ? text : "", text ? "\"" : "", wanted);
}

size_t table_heading(const char *text, char unit[TABLE_SHOWN]) {
    size_t begin = strcspn(text, "[(");
    begin += text[begin] != 0;
    size_t length = strcspn(text + begin, "])");
    length = length < TABLE_SHOWN ? length : TABLE_SHOWN - 1;
    memcpy(unit, text + begin, length);
    unit[length] = 0;
    return strcspn(text, " [(");
}

bool table_row_fits(const TableReader *reader, TablePlace begin, int fields, int heading) {
    if (fields == heading)
        return true;
    fault_add(reader->fault, "%s:%d:%d: the row has %d column%s, must have %d, like the heading", reader->path,
              begin.line, begin.column, fields, fields == 1 ? "" : "s", heading);
    return false;
}

bool table_number(const TableReader *reader, TablePlace place, const char *name, const char *unit, double farthest,
                  const char *text, double *value) {
    char *end, what[TABLE_SHOWN + 8], wanted[TABLE_SHOWN + 64];
    *value = strtod(text, &end);
    bool plain = *text && !*end && text[strspn(text, "+-.0123456789eE")] == 0;
    snprintf(what, sizeof what, "%.*s is", TABLE_SHOWN, name);
    snprintf(wanted, sizeof wanted, ", must be a number from %g to %g %.*s", -farthest, farthest, TABLE_SHOWN, unit);
    if (plain && fabs(*value) <= farthest)
        return true;
    if (!plain && text[strspn(text, "+-,0123456789")] == 0 && strchr(text, ','))
        table_fault(reader, place, what, text, ", must have a decimal point");
    else
        table_fault(reader, place, what, text, wanted);
    return false;
}

static void take_field(void *bytes, size_t size, void *context) {
    Reading *reading = context;
    const TableReader *reader = reading->reader;
    const char *text = bytes;
    if (!reading->begun)
        reading->begin = reading->at;
    if (reading->field == 0)
        reading->row_begin = reading->begin;
    reader->take_field(reader->context, reading->begin, reading->field, strlen(text) == size ? text : NULL);
    if (strlen(text) != size)
        table_fault(reader, reading->begin, "the file contains a zero byte", NULL, ", must be text");
    reading->field++;
    reading->begun = false;
}

static void end_row(int terminator, void *context) {
    Reading *reading = context;
    (void)terminator;
    reading->reader->end_row(reading->reader->context, reading->row_begin, reading->field);
    reading->field = 0;
}

/* Returns the separator that is most frequent in the first row. */
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

/* Parses byte by byte to know the place of each field, which libcsv does not report. */
static void read_text(Reading *reading, const char *text, size_t size) {
    struct csv_parser parser;
    csv_init(&parser, CSV_STRICT | CSV_STRICT_FINI | CSV_APPEND_NULL);
    csv_set_delim(&parser, (unsigned char)find_separator(text));
    bool good = true;
    for (size_t i = 0; i < size && good; i++) {
        if (!reading->begun && !isspace((unsigned char)text[i])) {
            reading->begun = true;
            reading->begin = reading->at;
        }
        good = csv_parse(&parser, text + i, 1, take_field, end_row, reading) == 1;
        if (good && text[i] == '\n')
            reading->at = (TablePlace){reading->at.line + 1, 1};
        else if (good &&
                 ((unsigned char)text[i] & 0xc0) != 0x80) /* count characters, not continuation bytes of UTF-8 */
            reading->at.column++;
    }
    if (!good)
        table_fault(reading->reader, reading->at, "the file is not CSV: a quotation mark within a field", NULL,
                    ", must be doubled");
    else if (csv_fini(&parser, take_field, end_row, reading) != 0)
        table_fault(reading->reader, reading->begin, "the file is not CSV: the quotation mark is not closed", NULL, "");
    csv_free(&parser);
}

TablePlace table_read(const TableReader *reader, size_t largest) {
    static const char mark[] = "\xef\xbb\xbf"; /* byte order mark of UTF-8, which some editors write */
    Reading reading = {.reader = reader, .at = {1, 1}, .row_begin = {1, 1}};
    size_t size = 0;
    char *text = text_read_file(reader->path, largest, &size);
    if (!text) {
        fault_add(reader->fault, "%s:1:1: cannot be read: %s", reader->path, text_read_reason(errno));
        return reading.at;
    }
    size_t skip = strncmp(text, mark, strlen(mark)) == 0 ? strlen(mark) : 0;
    read_text(&reading, text + skip, size - skip);
    memory_free(text);
    return reading.at;
}
