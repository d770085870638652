/* Helpers for text. */
#pragma once

#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>

#include "base/memory.h"

/* Returns the word of `words` (count) nearest to `word` by insertions, deletions and replacements (Levenshtein), or
 * NULL if none is near enough to be a misspelling: at most a third of the word, and at least two characters, may
 * differ. */
const char *text_nearest(const char *word, const char *const *words, size_t count);

/* Returns how many bytes of the text, at most `most`, are whole characters of UTF-8: a precision for %.*s. */
int text_fitting(const char *text, int most);

/* Turns any bytes into one line of valid UTF-8 without control characters, for the name of a thing; a message shows
 * them instead, see visible_line. */
void text_make_plain(char *line);

/* Returns the whole file, ended by 0, or NULL with errno set; memory_free it. `*size` counts its bytes without the 0. A
 * signal ends the wait for a pipe. */
char *text_read_file(const char *path, size_t largest, size_t *size);

/* True once a signal has ended the wait of text_read_file for a pipe: the file is not faulty, but unknown. Any thread
 * may call it. */
bool text_read_interrupted(void);

/* Makes text_read_file refuse all but regular files from here on, for a window, which must not wait for a pipe. */
void text_read_regular_only(void);

/* Returns 0 if text_read_file may open the file, or errno; for files that libraries read. */
int text_read_refusal(const char *path);

/* Returns the words for an error (errno) of a file that cannot be read, without a full stop. */
const char *text_read_reason(int error);

/* Returns a copy; memory_free it. */
char *text_copy(const char *text);

/* True if the text is one of the words (count). */
bool text_is_among(const char *text, const char *const *words, size_t count);

/* Growing text. A zeroed value is empty; memory_free(text->text) releases it. */
typedef struct Text {
    char *text; /* ended by 0; NULL when empty */
    size_t used, capacity;
} Text;

void text_add(Text *text, const char *more);

enum { TEXT_NUMBER = 40 /* bytes */ };

/* Writes the fewest digits, at least `digits`, that are read as the same number. */
void text_of_number(char text[TEXT_NUMBER], double value, int digits);

/* Appends text formatted as by printf. */
void text_format(Text *text, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* Returns text formatted as by vprintf; memory_free it. */
char *text_printed(const char *format, va_list arguments) __attribute__((format(printf, 1, 0)));

/* Returns text formatted as by printf or vprintf; it lives as long as the arena. */
const char *text_in_arena(Arena *arena, const char *format, ...) __attribute__((format(printf, 2, 3)));
const char *text_vin_arena(Arena *arena, const char *format, va_list arguments) __attribute__((format(printf, 2, 0)));

/* Creates a folder and its parents where they are missing. Returns 0 or errno, also if the folder is not writable. */
int text_make_folder(const char *path);
