/* Small things about words. */
#pragma once

#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>

#include "base/memory.h"

/* The word of `words` (count) nearest to `word` by insertions, deletions and replacements (Levenshtein), or NULL when
 * none is near enough to be what was meant: at most a third of the word, and at least two characters, may differ. */
const char *text_nearest(const char *word, const char *const *words, size_t count);

/* Makes one line of UTF-8 of anything: a name may hold what it likes, and a longer one is cut anywhere. */
void text_make_plain(char *line);

/* The whole file, ended by 0, or NULL with errno set; memory_free it. `*size` counts its bytes without the 0. */
char *text_read_file(const char *path, size_t largest, size_t *size);

/* A copy; memory_free it. */
char *text_copy(const char *text);

/* Is it one of the words (count)? */
bool text_is_among(const char *text, const char *const *words, size_t count);

/* Text that grows. Zero is empty; memory_free(text->text) releases it. */
typedef struct Text {
    char *text; /* ended by 0; NULL when empty */
    size_t used, capacity;
} Text;

void text_add(Text *text, const char *more);

enum { TEXT_NUMBER = 40 /* bytes */ };

/* The fewest digits, at least so many, that are read as the same number again. */
void text_of_number(char text[TEXT_NUMBER], double value, int digits);

/* Adds what printf would print. */
void text_format(Text *text, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* What vprintf would print, as it is or as one line; memory_free it. */
char *text_printed(const char *format, va_list arguments) __attribute__((format(printf, 1, 0)));
char *text_printed_line(const char *format, va_list arguments) __attribute__((format(printf, 1, 0)));

/* What printf, or vprintf, would print, as long as the arena lives. */
const char *text_in_arena(Arena *arena, const char *format, ...) __attribute__((format(printf, 2, 3)));
const char *text_vin_arena(Arena *arena, const char *format, va_list arguments) __attribute__((format(printf, 2, 0)));

/* The name of a file beside `path`, of this process, to be renamed to it when it is whole; memory_free it. */
char *text_beside(const char *path);

/* Renames it to `path`, or removes it where an error (errno) has come up; takes the name. 0, or errno. */
int text_beside_end(char *beside, const char *path, int error);

/* Writes beside `path` and renames, so that a failed write leaves the old file. 0, or errno. */
int text_write_file(const char *path, const char *text, size_t size);

/* The same without waiting for the disk: for many files that can be made again. */
int text_write_quickly(const char *path, const char *text, size_t size);

/* Makes a folder and those above it, where they are not there. 0, or errno, also when it cannot be written to. */
int text_make_folder(const char *path);
