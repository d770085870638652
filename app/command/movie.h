/* A film by ffmpeg, which is given one picture after another through a pipe. */
#pragma once

#include <stdbool.h>

typedef struct Movie Movie;

/* Starts ffmpeg for `path`, whose ending says what kind of film it is. NULL, with one line on standard error: ffmpeg is
 * not installed, or cannot be started. */
Movie *movie_begin(const char *path, int width, int height, double fps);

/* One more picture, as png_writer_room has it. 0, or errno: ffmpeg has given up. */
int movie_add(Movie *movie, const unsigned char *pixels);

/* Waits for ffmpeg and puts the film in its place. False, with one line on standard error: there is none. */
bool movie_end(Movie *movie);
