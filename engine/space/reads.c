#include "space/reads.h"

#include "base/memory.h"

Reads reads_begin(int nx, int ny, size_t list_count) {
    Reads reads = {.tile_nx = (nx + READS_TILE - 1) / READS_TILE,
                   .tile_ny = (ny + READS_TILE - 1) / READS_TILE,
                   .list_count = list_count};
    reads.tiles = memory_zeroed((size_t)reads.tile_nx * (size_t)reads.tile_ny, sizeof *reads.tiles);
    reads.boxes = memory_zeroed(list_count, sizeof *reads.boxes);
    for (size_t i = 0; i < list_count; i++)
        reads.boxes[i] = box_empty();
    return reads;
}

void reads_free(Reads *reads) {
    memory_free(reads->tiles);
    memory_free(reads->boxes);
    *reads = (Reads){0};
}
