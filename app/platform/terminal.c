#include "platform/terminal.h"

#include <errno.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "base/memory.h"
#include "base/text.h"
#include "base/visible.h"

typedef struct Pen {
    int file;
    char rest[4]; /* bytes of a character whose end is not printed yet */
    size_t rest_size;
    int error; /* the first one, as errno; 0: none */
} Pen;

static Pen pens[] = {{.file = STDOUT_FILENO}, {.file = STDERR_FILENO}};

static bool write_all(int file, const Text *text) {
    for (size_t done = 0; done < text->used;) {
        ssize_t now = write(file, text->text + done, text->used - done);
        if (now <= 0)
            return false;
        done += (size_t)now;
    }
    return true;
}

/* Prints bytes; as a function of a stream it returns their number, 0 after an error. */
static ssize_t print(void *cookie, const char *bytes, size_t size) {
    Pen *pen = cookie;
    size_t all = pen->rest_size + size;
    char *joined = memory_zeroed(all + 1, 1);
    memcpy(joined, pen->rest, pen->rest_size);
    memcpy(joined + pen->rest_size, bytes, size);
    Text shown = {0};
    char letter[VISIBLE_LETTER];
    size_t at = 0;
    for (size_t taken; at < all && (taken = visible_letter(joined + at, all - at, letter)) > 0; at += taken)
        text_add(&shown, letter);
    pen->rest_size = all - at;
    memcpy(pen->rest, joined + at, pen->rest_size);
    bool good = write_all(pen->file, &shown);
    int error = good ? 0 : errno;
    if (!pen->error)
        pen->error = error;
    memory_free(joined);
    memory_free(shown.text);
    errno = error;
    return good ? (ssize_t)size : 0;
}

static FILE *open_pen(Pen *pen, FILE *usual, int buffering) {
    FILE *stream = fopencookie(pen, "w", (cookie_io_functions_t){.write = print});
    if (!stream)
        return usual;
    setvbuf(stream, NULL, buffering, BUFSIZ);
    return stream;
}

void terminal_show_all_characters(void) {
    stdout = open_pen(&pens[0], stdout, isatty(STDOUT_FILENO) ? _IOLBF : _IOFBF);
    stderr = open_pen(&pens[1], stderr, _IONBF);
}

static int progress_width; /* bytes of the longest line of progress since the last clearing */

void terminal_progress(const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    char *words = text_printed(format, arguments), *shown = visible_text(words);
    va_end(arguments);
    int width = (int)strlen(shown);
    Text line = {0};
    text_format(&line, "\r%-*s", progress_width, shown);
    progress_width = width > progress_width ? width : progress_width;
    write_all(STDERR_FILENO, &line);
    memory_free(words);
    memory_free(shown);
    memory_free(line.text);
}

void terminal_clear_progress(void) {
    Text line = {0};
    text_format(&line, "\r%*s\r", progress_width, "");
    progress_width = 0;
    write_all(STDERR_FILENO, &line);
    memory_free(line.text);
}

int terminal_error(void) {
    return pens[0].error;
}
