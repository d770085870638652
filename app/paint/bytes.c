#include "paint/bytes.h"

#include <string.h>

#include "base/memory.h"

void bytes_add(Bytes *bytes, const void *more, size_t size) {
    bytes->at = memory_reserve(bytes->at, &bytes->capacity, bytes->size + size + 1, 1);
    memcpy(bytes->at + bytes->size, more, size);
    bytes->size += size;
    bytes->at[bytes->size] = 0;
}
