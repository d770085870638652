#include "laboratory/laboratory.h"

#include <string.h>

static const Laboratory *const kinds[] = {&house_laboratory, &beam_laboratory};
enum { KINDS = sizeof kinds / sizeof *kinds };

/* Longer than any house or beam that is opened in a window. */
enum { LONGEST = 64 << 20 /* bytes */ };

/* Does the text hold "clearance-WORD" in quotation marks? */
static bool says(const char *text, const char *word) {
    Text format = {0};
    text_format(&format, "\"clearance-%s\"", word);
    bool found = strstr(text, format.text);
    memory_free(format.text);
    return found;
}

const Laboratory *laboratory_of(const char *path) {
    size_t size;
    char *text = text_read_file(path, LONGEST, &size);
    const Laboratory *kind = kinds[0];
    for (size_t i = 0; text && i < KINDS; i++)
        if (says(text, kinds[i]->word)) {
            kind = kinds[i];
            break;
        }
    memory_free(text);
    return kind;
}
