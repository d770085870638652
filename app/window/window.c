#include "window/window.h"

#include <stdio.h>

int window_run(const WindowOptions *options) {
    fprintf(stderr, "clearance: %s cannot be opened: this build has no window\n",
            options->file ? options->file : "the window");
    return 3;
}
