/* The program's only allocator. Every block is zeroed and never NULL: when the machine is out of memory, the program
 * reports that in one line and ends with exit code 3. */
#pragma once

#include <stddef.h>

/* Reports that memory is exhausted and ends the program with exit code 3. */
__attribute__((noreturn)) void memory_end(void);

/* Has freed memory returned to the system early, for a program that works for hours: large blocks at once, and small
 * ones of all threads from few places. Call it before threads begin. */
void memory_return_freed(void);

/* Returns `count` zeroed elements of `size` bytes; memory_free releases them. */
void *memory_zeroed(size_t count, size_t size);

/* Grows `block` to at least `count` elements of `size` bytes and returns it, possibly at another address. The first
 * `*capacity` elements are preserved, and the new ones are zeroed. */
void *memory_reserve(void *block, size_t *capacity, size_t count, size_t size);

void memory_free(void *block);

/* Many small objects with one lifetime, such as the texts and points of a plan. A zeroed arena is empty. */
typedef struct Arena {
    struct ArenaBlock *blocks;
} Arena;

/* Returns `size` zeroed bytes that live until arena_clear, aligned for any type. */
void *arena_allocate(Arena *arena, size_t size);

/* Returns a copy of `text` that lives until arena_clear. */
const char *arena_text(Arena *arena, const char *text);

void arena_clear(Arena *arena);
