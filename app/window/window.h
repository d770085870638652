/* The interactive window. */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef struct WindowOptions {
    const char *file;            /* NULL: the default house */
    const char *const *settings; /* (setting_count) NAME=VALUE */
    size_t setting_count;
    const char *route; /* id, or NULL */
    int driving;       /* Driving, or -1 */
    uint64_t seed;
    int width, height;   /* pixels; 0: from the settings */
    int theme;           /* Theme; -1: from the settings */
    int text;            /* 1 to 3; 0: from the settings */
    bool reduced_motion; /* false: from the settings */
    const char *script;  /* file, or NULL */
    double benchmark;    /* s; 0: none */
    double benchmark_edit;
    int jobs; /* threads */
} WindowOptions;

/* Runs the window until it is closed, and returns the program's exit code. */
int window_run(const WindowOptions *options);
