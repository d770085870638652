#include "paint/png.h"

#include <errno.h>
#include <png.h>
#include <pthread.h>
#include <stdbool.h>
#include <stdio.h>

#include "base/file_write.h"
#include "base/memory.h"
#include "paint/bytes.h"

enum { SLOTS_PER_THREAD = 2, PATH_ROOM = 4096 };

typedef struct Slot {
    unsigned char *pixels;
    char path[PATH_ROOM];
    bool filled; /* waiting to be written */
    bool busy;   /* being written */
} Slot;

struct PngWriter {
    int width, height;
    Slot *slots; /* (slot_count) filled in turn */
    size_t slot_count, next;
    pthread_t *threads; /* (thread_count) */
    size_t thread_count;
    pthread_mutex_t lock;
    pthread_cond_t changed;
    bool closing;
    int error; /* errno of the first file that failed */
};

static void store_bytes(png_structp png, png_bytep data, png_size_t size) {
    bytes_add(png_get_io_ptr(png), data, size);
}

static void flush_nothing(png_structp png) {
    (void)png;
}

static void encode(png_structp png, png_infop info, Bytes *bytes, const unsigned char *pixels, int width, int height) {
    png_set_write_fn(png, bytes, store_bytes, flush_nothing);
    png_set_compression_level(png, 1);
    png_set_filter(png, PNG_FILTER_TYPE_BASE, PNG_FILTER_NONE);
    png_set_IHDR(png, info, (png_uint_32)width, (png_uint_32)height, 8, PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_write_info(png, info);
    png_set_bgr(png);
    png_set_filler(png, 0, PNG_FILLER_AFTER);
    for (int y = 0; y < height; y++)
        png_write_row(png, pixels + (size_t)y * (size_t)width * 4);
    png_write_end(png, info);
}

int png_write(const char *path, const unsigned char *pixels, int width, int height) {
    Bytes bytes = {0};
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, NULL, NULL, NULL);
    png_infop info = png ? png_create_info_struct(png) : NULL;
    int error = ENOMEM;
    if (info && setjmp(png_jmpbuf(png)) == 0) {
        encode(png, info, &bytes, pixels, width, height);
        error = 0;
    }
    png_destroy_write_struct(&png, &info);
    if (!error)
        error = file_write_quickly(path, bytes.at, bytes.size);
    memory_free(bytes.at);
    return error;
}

static Slot *find_filled(PngWriter *writer) {
    for (size_t i = 0; i < writer->slot_count; i++)
        if (writer->slots[i].filled && !writer->slots[i].busy)
            return &writer->slots[i];
    return NULL;
}

static void *write_slots(void *context) {
    PngWriter *writer = context;
    pthread_mutex_lock(&writer->lock);
    for (;;) {
        Slot *slot = find_filled(writer);
        if (!slot && writer->closing)
            break;
        if (!slot) {
            pthread_cond_wait(&writer->changed, &writer->lock);
            continue;
        }
        slot->busy = true;
        int error = writer->error;
        pthread_mutex_unlock(&writer->lock);
        if (!error)
            error = png_write(slot->path, slot->pixels, writer->width, writer->height);
        pthread_mutex_lock(&writer->lock);
        slot->filled = slot->busy = false;
        writer->error = writer->error ? writer->error : error;
        pthread_cond_broadcast(&writer->changed);
    }
    pthread_mutex_unlock(&writer->lock);
    return NULL;
}

PngWriter *png_writer_create(int width, int height, int threads) {
    PngWriter *writer = memory_zeroed(1, sizeof *writer);
    *writer = (PngWriter){.width = width, .height = height, .slot_count = (size_t)(SLOTS_PER_THREAD * threads + 1)};
    pthread_mutex_init(&writer->lock, NULL);
    pthread_cond_init(&writer->changed, NULL);
    writer->slots = memory_zeroed(writer->slot_count, sizeof *writer->slots);
    for (size_t i = 0; i < writer->slot_count; i++)
        writer->slots[i].pixels = memory_zeroed((size_t)width * (size_t)height, 4);
    writer->threads = memory_zeroed((size_t)threads, sizeof *writer->threads);
    for (int i = 0; i < threads; i++)
        if (pthread_create(&writer->threads[writer->thread_count], NULL, write_slots, writer) == 0)
            writer->thread_count++;
    return writer;
}

unsigned char *png_writer_room(PngWriter *writer) {
    pthread_mutex_lock(&writer->lock);
    while (writer->slots[writer->next].filled)
        pthread_cond_wait(&writer->changed, &writer->lock);
    pthread_mutex_unlock(&writer->lock);
    return writer->slots[writer->next].pixels;
}

void png_writer_put(PngWriter *writer, const char *path) {
    Slot *slot = &writer->slots[writer->next];
    snprintf(slot->path, sizeof slot->path, "%s", path);
    if (writer->thread_count == 0) { /* the system gives no more threads */
        writer->error = writer->error ? writer->error : png_write(path, slot->pixels, writer->width, writer->height);
        return;
    }
    pthread_mutex_lock(&writer->lock);
    slot->filled = true;
    pthread_cond_broadcast(&writer->changed);
    pthread_mutex_unlock(&writer->lock);
    writer->next = (writer->next + 1) % writer->slot_count;
}

int png_writer_error(PngWriter *writer) {
    pthread_mutex_lock(&writer->lock);
    int error = writer->error;
    pthread_mutex_unlock(&writer->lock);
    return error;
}

int png_writer_finish(PngWriter *writer) {
    pthread_mutex_lock(&writer->lock);
    writer->closing = true;
    pthread_cond_broadcast(&writer->changed);
    pthread_mutex_unlock(&writer->lock);
    for (size_t i = 0; i < writer->thread_count; i++)
        pthread_join(writer->threads[i], NULL);
    int error = writer->error;
    for (size_t i = 0; i < writer->slot_count; i++)
        memory_free(writer->slots[i].pixels);
    pthread_cond_destroy(&writer->changed);
    pthread_mutex_destroy(&writer->lock);
    memory_free(writer->slots);
    memory_free(writer->threads);
    memory_free(writer);
    return error;
}
