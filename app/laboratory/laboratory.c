#include "laboratory/laboratory.h"

#include <string.h>

#include "laboratory/laboratories.h"
#include "laboratory/shipped.h"

/* Longer than any house or beam file that the window opens. */
enum { LONGEST = 64 << 20 /* bytes */ };

/* True if the text contains "clearance-WORD" in quotation marks. */
static bool says(const char *text, const char *word) {
    Text format = {0};
    text_format(&format, "\"clearance-%s\"", word);
    bool found = strstr(text, format.text);
    memory_free(format.text);
    return found;
}

size_t laboratory_of(const char *path) {
    size_t size, index = 0;
    char *text = text_read_file(path, LONGEST, &size);
    while (text && index < laboratories_count && !says(text, laboratories[index].laboratory->word))
        index++;
    memory_free(text);
    return index < laboratories_count ? index : 0;
}

size_t laboratory_find(const char *word) {
    size_t index = 0;
    while (index < laboratories_count && strcmp(laboratories[index].laboratory->word, word) != 0)
        index++;
    return index;
}

const char *laboratory_folder(size_t index) {
    const char *path;
    memcpy(&path, (const char *)shipped_places() + laboratories[index].folder, sizeof path);
    return path;
}

const char *laboratory_file(size_t index, Arena *arena) {
    return text_in_arena(arena, "%s/%s", laboratory_folder(index), laboratories[index].file);
}
