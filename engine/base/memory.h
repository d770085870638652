/* Memory in one place. Every block is zeroed and never NULL: when the machine has none left, the program says so
 * in one line and ends with exit code 3, here and nowhere else. */
#pragma once

#include <stddef.h>

/* `count` zeroed elements of `size` bytes; memory_free releases them. */
void *memory_zeroed(size_t count, size_t size);

/* Makes room in `block` for at least `count` elements of `size` bytes and returns it, perhaps elsewhere; what
 * `*capacity` counts is kept, the new part is zeroed. */
void *memory_reserve(void *block, size_t *capacity, size_t count, size_t size);

void memory_free(void *block);

/* Many small things that live and die together: the texts and points of a plan. Zero is an empty arena. */
typedef struct Arena {
    struct ArenaBlock *blocks;
} Arena;

/* `size` zeroed bytes that live until arena_clear, aligned for any type. */
void *arena_allocate(Arena *arena, size_t size);

/* A copy of `text` that lives until arena_clear. */
const char *arena_text(Arena *arena, const char *text);

void arena_clear(Arena *arena);
