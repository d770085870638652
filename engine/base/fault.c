#include "base/fault.h"

#include "base/memory.h"
#include "base/text.h"

/* The bytes of the character of UTF-8 that begins the text; 0: there is none. */
static size_t character_size(const char *text) {
    const unsigned char *byte = (const unsigned char *)text;
    if (byte[0] < 0x80)
        return 1;
    size_t size = byte[0] >= 0xf0 ? 4 : byte[0] >= 0xe0 ? 3 : 2;
    unsigned long code = byte[0] & (0x7fu >> size);
    static const unsigned long least[] = {0, 0, 0x80, 0x800, 0x10000};
    for (size_t i = 1; i < size; i++) {
        if ((byte[i] & 0xc0) != 0x80)
            return 0;
        code = code << 6 | (byte[i] & 0x3f);
    }
    bool good = byte[0] >= 0xc0 && byte[0] < 0xf8 && code >= least[size] && code <= 0x10ffff &&
                !(code >= 0xd800 && code <= 0xdfff);
    return good ? size : 0;
}

/* A name may hold anything, and a longer one is cut anywhere: a fault stays one line of UTF-8 all the same. */
static void make_plain(char *line) {
    for (char *c = line; *c;) {
        size_t size = character_size(c);
        if (!size)
            *c = '?';
        else if ((unsigned char)*c < ' ' || *c == 127)
            *c = ' ';
        c += size ? size : 1;
    }
}

void fault_add(Fault *fault, const char *format, ...) {
    fault->total++;
    if (fault->count >= FAULT_MOST)
        return;
    Text line = {0};
    va_list arguments;
    va_start(arguments, format);
    text_vformat(&line, format, arguments);
    va_end(arguments);
    make_plain(line.text);
    fault->lines = memory_reserve(fault->lines, &fault->capacity, fault->count + 1, sizeof *fault->lines);
    fault->lines[fault->count++] = line.text;
}

void fault_clear(Fault *fault) {
    for (size_t i = 0; i < fault->count; i++)
        memory_free(fault->lines[i]);
    memory_free(fault->lines);
    *fault = (Fault){0};
}
