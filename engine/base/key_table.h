/* A hash table of plain entries, each of which begins with `uint64_t key`, which is not 0; open addressing, never more
 * than half full.
 *
 *     KEY_TABLE_DEFINE(cell, Cell)
 *
 * defines cell_first, where the search for a key begins in a table of that capacity, cell_enter, which returns the
 * entry of a key in a block of memory that grows (zero but for its key if the entry is new, which `*fresh` tells), and
 * cell_find, which returns the entry of a key, or an empty entry of key 0; the table must not be empty. An entry stays
 * valid until the next one is entered; memory_free releases the block.
 */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "base/memory.h"

enum { KEY_TABLE_LEAST = 1 << 14 /* entries; a power of two, as every capacity */ };

#define KEY_TABLE_DEFINE(name_, Entry_)                                                                                \
    static size_t name_##_first(size_t capacity, uint64_t key) {                                                       \
        return (size_t)((key * UINT64_C(0x9e3779b97f4a7c15)) >> 24) & (capacity - 1);                                  \
    }                                                                                                                  \
                                                                                                                       \
    static Entry_ *name_##_find(Entry_ *entries, size_t capacity, uint64_t key) {                                      \
        size_t i = name_##_first(capacity, key);                                                                       \
        while (entries[i].key != key && entries[i].key != 0)                                                           \
            i = (i + 1) & (capacity - 1);                                                                              \
        return &entries[i];                                                                                            \
    }                                                                                                                  \
                                                                                                                       \
    static Entry_ *name_##_enter(Entry_ **entries, size_t *count, size_t *capacity, uint64_t key, bool *fresh) {       \
        if (2 * *count >= *capacity) {                                                                                 \
            size_t larger = *capacity ? 2 * *capacity : KEY_TABLE_LEAST;                                               \
            Entry_ *grown = memory_zeroed(larger, sizeof *grown);                                                      \
            for (size_t i = 0; i < *capacity; i++)                                                                     \
                if ((*entries)[i].key)                                                                                 \
                    *name_##_find(grown, larger, (*entries)[i].key) = (*entries)[i];                                   \
            memory_free(*entries);                                                                                     \
            *entries = grown;                                                                                          \
            *capacity = larger;                                                                                        \
        }                                                                                                              \
        Entry_ *entry = name_##_find(*entries, *capacity, key);                                                        \
        *fresh = entry->key == 0;                                                                                      \
        entry->key = key;                                                                                              \
        *count += *fresh;                                                                                              \
        return entry;                                                                                                  \
    }
