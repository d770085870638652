#include "command/output.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

bool output_directory(const char *path) {
    char part[4096];
    snprintf(part, sizeof part, "%s", path);
    int error = 0;
    for (char *slash = part + 1; !error && *slash; slash++) {
        if (*slash != '/')
            continue;
        *slash = 0;
        error = mkdir(part, 0777) && errno != EEXIST ? errno : 0;
        *slash = '/';
    }
    if (!error)
        error = mkdir(part, 0777) && errno != EEXIST ? errno : 0;
    if (!error && access(part, W_OK | X_OK))
        error = errno;
    if (error)
        fprintf(stderr, "clearance: %s cannot be written: %s\n", path, strerror(error));
    return !error;
}
