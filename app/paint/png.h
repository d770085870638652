/* Many pictures as PNG files, compressed and written by threads of their own while the next ones are drawn: quickly
 * rather than small (zlib's lowest level, no filters). Every file is written beside and renamed. */
#pragma once

#include <stddef.h>

typedef struct PngWriter PngWriter;

/* For pictures of width x height pixels, by so many threads. */
PngWriter *png_writer_create(int width, int height, int threads);

/* Room for the next picture: rows from the top, four bytes a pixel, blue, green, red and one that does not matter.
 * Waits while all room is taken. */
unsigned char *png_writer_room(PngWriter *writer);

/* Hands the room over to be written as `path`, which is copied. */
void png_writer_put(PngWriter *writer, const char *path);

/* The errno of the first file that could not be written so far, or 0: then drawing on is in vain. */
int png_writer_error(PngWriter *writer);

/* Waits until all is written and releases the writer. 0, or the errno of the first file that could not be written;
 * nothing is written after that one. */
int png_writer_finish(PngWriter *writer);

/* One picture at once; 0 or errno. */
int png_write(const char *path, const unsigned char *pixels, int width, int height);
