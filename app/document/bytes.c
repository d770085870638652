#include "document/bytes.h"

#include <string.h>

#include "base/memory.h"

cairo_status_t bytes_keep(void *context, const unsigned char *data, unsigned length) {
    Bytes *bytes = context;
    bytes->at = memory_reserve(bytes->at, &bytes->capacity, bytes->size + length + 1, 1);
    memcpy(bytes->at + bytes->size, data, length);
    bytes->size += length;
    return CAIRO_STATUS_SUCCESS;
}
