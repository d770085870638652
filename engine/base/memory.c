#include "base/memory.h"

#include <malloc.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { ARENA_BLOCK = 16 * 1024 /* bytes: a plan of some hundred walls */ };

typedef struct ArenaBlock {
    struct ArenaBlock *next;
    size_t used, size; /* bytes of `bytes` */
    max_align_t bytes[];
} ArenaBlock;

void memory_end(void) {
    static const char message[] = "clearance: out of memory\n";
    (void)!write(STDERR_FILENO, message, sizeof message - 1);
    _exit(3);
}

/* LAPACKE's numbers for a lack of memory; the layers keep lapacke.h out of here. */
enum { LAPACKE_WORK_MEMORY = -1010, LAPACKE_TRANSPOSE_MEMORY = -1011 };

/* Takes the place of LAPACKE's own, which prints to standard output that it lacks memory, and goes on. */
void LAPACKE_xerbla(const char *name, int info);

void LAPACKE_xerbla(const char *name, int info) {
    (void)name;
    if (info == LAPACKE_WORK_MEMORY || info == LAPACKE_TRANSPOSE_MEMORY)
        memory_end();
}

void memory_return_freed(void) {
    mallopt(M_MMAP_THRESHOLD, 1 << 20); /* bytes; otherwise it grows with the blocks that are freed */
    mallopt(M_ARENA_MAX, 2);            /* instead of eight per processor */
}

void *memory_zeroed(size_t count, size_t size) {
    void *block = calloc(count ? count : 1, size ? size : 1);
    if (!block)
        memory_end();
    return block;
}

void *memory_reserve(void *block, size_t *capacity, size_t count, size_t size) {
    if (count <= *capacity)
        return block;
    size_t grown = *capacity + *capacity / 2;
    if (grown < count)
        grown = count < 8 ? 8 : count;
    if (grown > SIZE_MAX / size)
        memory_end();
    char *moved = realloc(block, grown * size);
    if (!moved)
        memory_end();
    memset(moved + *capacity * size, 0, (grown - *capacity) * size);
    *capacity = grown;
    return moved;
}

void memory_free(void *block) {
    free(block);
}

void *arena_allocate(Arena *arena, size_t size) {
    size_t rounded = (size + sizeof(max_align_t) - 1) / sizeof(max_align_t) * sizeof(max_align_t);
    ArenaBlock *block = arena->blocks;
    if (!block || block->size - block->used < rounded) {
        size_t room = rounded > ARENA_BLOCK ? rounded : ARENA_BLOCK;
        block = memory_zeroed(1, sizeof *block + room);
        block->size = room;
        block->next = arena->blocks;
        arena->blocks = block;
    }
    void *place = (char *)block->bytes + block->used;
    block->used += rounded;
    return place;
}

const char *arena_text(Arena *arena, const char *text) {
    size_t size = strlen(text) + 1;
    return memcpy(arena_allocate(arena, size), text, size);
}

void arena_clear(Arena *arena) {
    while (arena->blocks) {
        ArenaBlock *next = arena->blocks->next;
        memory_free(arena->blocks);
        arena->blocks = next;
    }
}
