#include "base/file_memory.h"

#include <errno.h>
#include <fcntl.h>
#include <pthread.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/mman.h>
#include <unistd.h>

#include "base/memory.h"

enum {
    PART = 64 << 20, /* bytes of a part, unless a block is larger; whole pages */
    ALIGNED = 16,    /* bytes */
    PATH = 4200,
};

/* A mapped part of the file. */
typedef struct Part {
    char *at;
    size_t used, size; /* bytes */
} Part;

struct FileMemory {
    int file;
    Part *parts; /* (count) */
    size_t count, capacity;
    size_t end;           /* bytes of the file */
    unsigned touched;     /* how often, by all threads */
    pthread_mutex_t lock; /* protects `parts` */
};

/* Opens a file that vanishes with its descriptor. */
static int open_nameless(const char *folder) {
    int file = open(folder, O_TMPFILE | O_RDWR | O_CLOEXEC, 0600);
    if (file >= 0 || (errno != EOPNOTSUPP && errno != EISDIR && errno != EINVAL))
        return file;
    char path[PATH]; /* file systems of networks need a name for a moment */
    snprintf(path, sizeof path, "%s/clearance-XXXXXX", folder);
    file = mkostemp(path, O_CLOEXEC);
    if (file >= 0)
        unlink(path);
    return file;
}

FileMemory *file_memory_create(const char *folder) {
    int file = open_nameless(folder);
    if (file < 0)
        return NULL;
    FileMemory *memory = memory_zeroed(1, sizeof *memory);
    memory->file = file;
    pthread_mutex_init(&memory->lock, NULL);
    return memory;
}

void file_memory_destroy(FileMemory *memory) {
    if (!memory)
        return;
    for (size_t p = 0; p < memory->count; p++)
        munmap(memory->parts[p].at, memory->parts[p].size);
    close(memory->file);
    pthread_mutex_destroy(&memory->lock);
    memory_free(memory->parts);
    memory_free(memory);
}

/* Adds a part whose room on the disk is certain: a page that found none would end the program. */
static bool add_part(FileMemory *memory, size_t size) {
    size_t rounded = (size + PART - 1) / PART * PART;
    int error = posix_fallocate(memory->file, (off_t)memory->end, (off_t)rounded);
    if (error) {
        errno = error;
        return false;
    }
    void *at = mmap(NULL, rounded, PROT_READ | PROT_WRITE, MAP_SHARED, memory->file, (off_t)memory->end);
    if (at == MAP_FAILED)
        return false;
    memory->end += rounded;
    pthread_mutex_lock(&memory->lock);
    memory->parts = memory_reserve(memory->parts, &memory->capacity, memory->count + 1, sizeof *memory->parts);
    memory->parts[memory->count++] = (Part){at, 0, rounded};
    pthread_mutex_unlock(&memory->lock);
    return true;
}

void *file_memory_take(FileMemory *memory, size_t size) {
    size_t rounded = (size + ALIGNED - 1) / ALIGNED * ALIGNED;
    Part *last = memory->count ? &memory->parts[memory->count - 1] : NULL;
    if (!last || last->size - last->used < rounded) {
        if (!add_part(memory, rounded ? rounded : ALIGNED))
            return NULL;
        last = &memory->parts[memory->count - 1];
    }
    void *block = last->at + last->used;
    last->used += rounded;
    return block;
}

void file_memory_rest(FileMemory *memory) {
    /* of a shared mapping this forgets only where the pages are */
    pthread_mutex_lock(&memory->lock);
    for (size_t p = 0; p < memory->count; p++)
        madvise(memory->parts[p].at, memory->parts[p].size, MADV_DONTNEED);
    pthread_mutex_unlock(&memory->lock);
}

void file_memory_touch(FileMemory *memory) {
    if (__atomic_add_fetch(&memory->touched, 1, __ATOMIC_RELAXED) % FILE_MEMORY_TOUCHES == 0)
        file_memory_rest(memory);
}
