/* A home for tests of what a window remembers and writes: a temporary folder that HOME and the XDG variables name. */
#pragma once

/* Makes it, empty, and forgets the one before; the working directory is within. */
const char *desk_make(void);

/* A path in it; overwritten by the call after the next. */
const char *desk_path(const char *name);

/* Writes a file there, with the folders above it. */
void desk_write(const char *name, const char *text);
void desk_remove(void);
