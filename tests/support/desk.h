/* A temporary home folder for tests of stored settings and files, named by HOME and the XDG variables. */
#pragma once

/* Creates it empty, discarding the previous one; it becomes the working directory. */
const char *desk_make(void);

/* Returns a path in it; overwritten by the call after the next. */
const char *desk_path(const char *name);

/* Writes a file there and creates the folders above it. */
void desk_write(const char *name, const char *text);
void desk_remove(void);
