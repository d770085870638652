#include "base/fault.h"

#include "base/memory.h"
#include "base/visible.h"

void fault_add(Fault *fault, const char *format, ...) {
    fault->total++;
    if (fault->count >= FAULT_MOST)
        return;
    va_list arguments;
    va_start(arguments, format);
    char *line = visible_printed(format, arguments);
    va_end(arguments);
    fault->lines = memory_reserve(fault->lines, &fault->capacity, fault->count + 1, sizeof *fault->lines);
    fault->lines[fault->count++] = line;
}

void fault_clear(Fault *fault) {
    for (size_t i = 0; i < fault->count; i++)
        memory_free(fault->lines[i]);
    memory_free(fault->lines);
    *fault = (Fault){0};
}
