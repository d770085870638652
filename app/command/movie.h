/* A film made by ffmpeg, which reads the pictures from a pipe. */
#pragma once

#include <stdbool.h>

typedef struct Movie Movie;

/* Starts ffmpeg for `path`, whose ending says what kind of film it is. Returns NULL, after an error on standard error,
 * if ffmpeg is not installed or cannot be started. */
Movie *movie_begin(const char *path, int width, int height, double fps);

/* Adds a picture in the format of png_writer_room. Returns 0, or errno if ffmpeg has ended. */
int movie_add(Movie *movie, const unsigned char *pixels);

/* Waits for ffmpeg and renames the film to its path. False: an error was printed, and there is no film. */
bool movie_end(Movie *movie);
