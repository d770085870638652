/* Memory that lies in a file without a name, for more data than the machine's memory holds. The system keeps of it what
 * is in use; pages that were touched leave this program's memory from time to time, and come back by themselves. */
#pragma once

#include <stddef.h>
#include <stdint.h>

typedef struct FileMemory FileMemory;

/* Creates it in a directory, which needs room for all blocks. Returns NULL, with errno, where no file can be created.
 * file_memory_destroy releases all blocks, and accepts NULL. */
FileMemory *file_memory_create(const char *folder);
void file_memory_destroy(FileMemory *memory);

/* Returns `size` zeroed bytes, for one thread at a time, that stay at their address until file_memory_destroy, aligned
 * for numbers and pointers; NULL, with errno, if the file system has no room. */
void *file_memory_take(FileMemory *memory, size_t size);

/* Lets all pages leave the memory of this program; their content stays. Any thread may be at work on them. */
void file_memory_rest(FileMemory *memory);

/* To be called before each use of a row, by any thread: after FILE_MEMORY_TOUCHES of them, pages rest. */
void file_memory_touch(FileMemory *memory);

enum {
    FILE_MEMORY_TOUCHES = 2048, /* each brings two pages in, and each of these up to 15 neighbours: at most 256 MB */
};
