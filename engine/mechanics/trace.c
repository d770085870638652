#include "mechanics/trace.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/file_write.h"
#include "base/memory.h"

enum { CELL_LONGEST = 32 /* characters of a number or a separator */ };

void trace_init(Trace *trace, const TraceColumn *columns, size_t width) {
    *trace = (Trace){.columns = columns, .width = width};
}

void trace_clear(Trace *trace) {
    memory_free(trace->values);
    *trace = (Trace){0};
}

void trace_add(Trace *trace, const double *values) {
    trace->values =
        memory_reserve(trace->values, &trace->capacity, (trace->rows + 1) * trace->width, sizeof *trace->values);
    memcpy(trace->values + trace->rows * trace->width, values, trace->width * sizeof *values);
    trace->rows++;
}

int trace_write_csv(const Trace *trace, const char *path) {
    size_t room = sizeof "\r\n"; /* of the header; each row reserves room of its own */
    for (size_t c = 0; c < trace->width; c++)
        room += strlen(trace->columns[c].name) + strlen(trace->columns[c].unit) + CELL_LONGEST;
    room += trace->rows * trace->width * CELL_LONGEST;
    char *text = memory_zeroed(room, 1), *at = text;
    for (size_t c = 0; c < trace->width; c++)
        at += sprintf(at, "%s%s [%s]", c ? "," : "", trace->columns[c].name, trace->columns[c].unit);
    at += sprintf(at, "\r\n");
    for (size_t r = 0; r < trace->rows; r++) {
        for (size_t c = 0; c < trace->width; c++) {
            double value = trace_row(trace, r)[c];
            at += sprintf(at, "%s", c ? "," : "");
            at += isnan(value) ? 0 : snprintf(at, CELL_LONGEST, "%.9g", value);
        }
        at += sprintf(at, "\r\n");
    }
    int error = file_write_bytes(path, text, (size_t)(at - text));
    memory_free(text);
    return error;
}
