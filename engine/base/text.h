/* Small things about words. */
#pragma once

#include <stddef.h>

/* The word of `words` (count) nearest to `word` by insertions, deletions and replacements (Levenshtein), or NULL when
 * none is near enough to be what was meant: at most a third of the word, and at least two characters, may differ. */
const char *text_nearest(const char *word, const char *const *words, size_t count);

/* The whole file, ended by 0, or NULL with errno set; memory_free it. `*size` counts its bytes without the 0. */
char *text_read_file(const char *path, size_t largest, size_t *size);

/* Writes beside `path` and renames, so that a failed write leaves the old file. 0, or errno. */
int text_write_file(const char *path, const char *text, size_t size);
