#include "window/clauses.h"

#include <string.h>

const char *clauses_first_line(Window *window, const char *detail) {
    return detail ? text_in_arena(&window->arena, "%.*s", (int)strcspn(detail, "\n"), detail) : "";
}

const char *clauses_whole(Window *window, UiTextStyle size, const char *text, double width) {
    size_t length = strlen(text);
    while (length > 0 &&
           ui_extent(window->ui, size, text_in_arena(&window->arena, "%.*s", (int)length, text)).x > width) {
        size_t before = 0;
        for (size_t i = 1; i < length; i++) /* clauses end at "; ", ", " or " \u00b7 " */
            if (text[i] == ' ' && (text[i - 1] == ';' || text[i - 1] == ','))
                before = i - 1;
            else if (strncmp(text + i, " \u00b7 ", 4) == 0)
                before = i;
        length = before;
    }
    return text_in_arena(&window->arena, "%.*s", (int)length, text);
}

const char *clauses_some(Window *window, UiTextStyle size, const char *text, double width) {
    const char *whole = clauses_whole(window, size, text, width);
    return *whole ? whole : text;
}
