#include "base/visible.h"

#include <stdio.h>
#include <string.h>

#include "base/memory.h"
#include "base/text.h"

bool visible_acts(uint32_t character) {
    static const struct {
        uint32_t first, last;
    } ranges[] = {
        {0x00, 0x08},     {0x0b, 0x1f},     {0x7f, 0x9f},       {0xad, 0xad},       {0x34f, 0x34f},
        {0x61c, 0x61c},   {0x115f, 0x1160}, {0x17b4, 0x17b5},   {0x180e, 0x180e},   {0x200b, 0x200f},
        {0x2028, 0x202e}, {0x2060, 0x206f}, {0x3164, 0x3164},   {0xfe00, 0xfe0f},   {0xfeff, 0xfeff},
        {0xffa0, 0xffa0}, {0xfff9, 0xfffb}, {0x1d173, 0x1d17a}, {0xe0000, 0xe007f}, {0xe0100, 0xe01ef},
    };
    for (size_t i = 0; i < sizeof ranges / sizeof *ranges; i++)
        if (character >= ranges[i].first && character <= ranges[i].last)
            return true;
    return false;
}

/* Returns the bytes of a character of UTF-8 by its first byte; 0: no character begins so. */
static size_t size_by_first(unsigned char byte) {
    return byte < 0x80 ? 1 : byte < 0xc2 ? 0 : byte < 0xe0 ? 2 : byte < 0xf0 ? 3 : byte < 0xf5 ? 4 : 0;
}

/* Reads a character; false: the bytes are not UTF-8. */
static bool decode(const unsigned char *bytes, size_t size, uint32_t *character) {
    static const uint32_t least[] = {0, 0, 0x80, 0x800, 0x10000};
    uint32_t code = size == 1 ? bytes[0] : bytes[0] & (0x7fu >> size);
    for (size_t i = 1; i < size; i++) {
        if ((bytes[i] & 0xc0) != 0x80)
            return false;
        code = code << 6 | (bytes[i] & 0x3f);
    }
    *character = code;
    return code >= least[size] && code <= 0x10ffff && !(code >= 0xd800 && code <= 0xdfff);
}

static void show_byte(char byte, char shown[VISIBLE_LETTER]) {
    snprintf(shown, VISIBLE_LETTER, "\\x%02x", (unsigned char)byte);
}

size_t visible_letter(const char *bytes, size_t size, char shown[VISIBLE_LETTER]) {
    const unsigned char *at = (const unsigned char *)bytes;
    size_t needed = size ? size_by_first(*at) : 0;
    uint32_t character = 0;
    if (!size)
        return 0;
    if (needed > size) {
        bool may_go_on = true;
        for (size_t i = 1; i < size; i++)
            may_go_on = may_go_on && (at[i] & 0xc0) == 0x80;
        if (may_go_on)
            return 0;
        needed = 0;
    }
    if (!needed || !decode(at, needed, &character)) {
        show_byte(*bytes, shown);
        return 1;
    }
    if (!visible_acts(character))
        snprintf(shown, VISIBLE_LETTER, "%.*s", (int)needed, bytes);
    else if (character < 0x10000)
        snprintf(shown, VISIBLE_LETTER, "\\u%04x", (unsigned)character);
    else
        snprintf(shown, VISIBLE_LETTER, "\\u%04x\\u%04x", (unsigned)(0xd800 + ((character - 0x10000) >> 10)),
                 (unsigned)(0xdc00 + ((character - 0x10000) & 0x3ff)));
    return needed;
}

static char *visible_copy(const char *text, bool one_line) {
    Text copy = {0};
    char shown[VISIBLE_LETTER];
    text_add(&copy, "");
    for (size_t left = strlen(text), taken; left > 0; text += taken, left -= taken) {
        taken = visible_letter(text, left, shown);
        if (!taken) { /* the text ends within a character */
            show_byte(*text, shown);
            taken = 1;
        } else if (one_line && (*text == '\n' || *text == '\t')) {
            snprintf(shown, sizeof shown, "\\u%04x", (unsigned)*text);
        }
        text_add(&copy, shown);
    }
    return copy.text;
}

char *visible_text(const char *text) {
    return visible_copy(text, false);
}

char *visible_line(const char *text) {
    return visible_copy(text, true);
}

char *visible_printed(const char *format, va_list arguments) {
    char *text = text_printed(format, arguments), *line = visible_line(text);
    memory_free(text);
    return line;
}
