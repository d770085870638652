#include "base/fault.h"

#include <stdarg.h>
#include <stdio.h>

#include "base/memory.h"

void fault_add(Fault *fault, const char *format, ...) {
    fault->total++;
    if (fault->count >= FAULT_MOST)
        return;
    va_list arguments, again;
    va_start(arguments, format);
    va_copy(again, arguments);
    int length = vsnprintf(NULL, 0, format, arguments);
    va_end(arguments);
    size_t size = length > 0 ? (size_t)length + 1 : 1;
    char *line = memory_allocate(size, 1);
    vsnprintf(line, size, format, again);
    va_end(again);
    for (char *c = line; *c; c++) /* a name in a file may hold anything; a fault stays one line of plain text */
        if ((unsigned char)*c < ' ' || *c == 127)
            *c = ' ';
    fault->lines = memory_reserve(fault->lines, &fault->capacity, fault->count + 1, sizeof *fault->lines);
    fault->lines[fault->count++] = line;
}

void fault_clear(Fault *fault) {
    for (size_t i = 0; i < fault->count; i++)
        memory_free(fault->lines[i]);
    memory_free(fault->lines);
    *fault = (Fault){0};
}
