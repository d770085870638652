/* Many pictures as PNG files, compressed and written by threads while the next ones are drawn: quick rather than small
 * (zlib's lowest level, no filters). Every file is written to a temporary file, then renamed. */
#pragma once

#include <stddef.h>

typedef struct PngWriter PngWriter;

/* Makes a writer for pictures of width x height pixels with that many threads. */
PngWriter *png_writer_create(int width, int height, int threads);

/* Returns room for the next picture: rows from the top, four bytes per pixel, blue, green, red and one that is
 * ignored. Waits while all room is taken. */
unsigned char *png_writer_room(PngWriter *writer);

/* Queues the picture to be written as `path`, which is copied. */
void png_writer_put(PngWriter *writer, const char *path);

/* Returns the errno of the first file that failed so far, or 0: after a failure, drawing on is useless. */
int png_writer_error(PngWriter *writer);

/* Waits until all pictures are written and releases the writer. Returns 0, or the errno of the first file that failed;
 * nothing is written after that one. */
int png_writer_finish(PngWriter *writer);

/* Writes a single picture; returns 0 or errno. */
int png_write(const char *path, const unsigned char *pixels, int width, int height);
