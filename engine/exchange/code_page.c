#include "exchange/code_page.h"

#include <iconv.h>
#include <stdio.h>

#include "base/memory.h"

enum { LONGEST = 4 /* UTF-8 bytes per input byte, at most */ };

bool code_page_is_utf8(const char *text, size_t size) {
    for (size_t i = 0; i < size;) {
        unsigned char lead = (unsigned char)text[i++];
        size_t more = lead < 0x80 ? 0 : lead >= 0xf0 ? 3 : lead >= 0xe0 ? 2 : 1;
        if (lead >= 0x80 && (lead < 0xc2 || lead > 0xf4))
            return false;
        for (; more > 0; more--, i++)
            if (i >= size || ((unsigned char)text[i] & 0xc0) != 0x80)
                return false;
    }
    return true;
}

static iconv_t open_page(const char *page) {
    char name[32];
    snprintf(name, sizeof name, "CP%.16s", page);
    iconv_t converter = iconv_open("UTF-8", name);
    if (converter == (iconv_t)-1)
        converter = iconv_open("UTF-8", "CP1252");
    return converter;
}

char *code_page_convert(char *text, size_t *size, const char *page) {
    iconv_t converter = open_page(page);
    char *copy = memory_zeroed(*size * LONGEST + 1, 1), *out = copy, *in = text;
    size_t left = *size, room = *size * LONGEST;
    while (left > 0) {
        if (converter != (iconv_t)-1 && iconv(converter, &in, &left, &out, &room) != (size_t)-1)
            continue;
        if (left > 0) { /* the code page has no such byte */
            *out++ = (unsigned char)*in < 0x80 ? *in : '?';
            in++;
            left--;
            room--;
        }
    }
    if (converter != (iconv_t)-1)
        iconv_close(converter);
    *size = (size_t)(out - copy);
    return copy;
}
