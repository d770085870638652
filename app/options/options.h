/* What the command line asks for, and the exit codes. */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "base/memory.h"
#include "draw/palette.h"
#include "draw/view.h"
#include "options/study_request.h"
#include "visual/house/house_plots.h"

/* Exit codes, part of the contract. */
typedef enum ExitCode {
    EXIT_ANSWERED = 0, /* everybody is out */
    EXIT_ANSWER_NO = 1,
    EXIT_WRONG_INPUT = 2,
    EXIT_OUR_FAULT = 3,
} ExitCode;

/* What the command line said. Texts belong to argv. */
typedef struct Options {
    const char **files; /* (file_count) */
    size_t file_count;
    const char **settings; /* (setting_count) NAME=VALUE */
    size_t setting_count;
    const char *out;   /* directory, or NULL */
    const char *route; /* id, or NULL */
    uint64_t seed;
    bool seed_said;
    int driving; /* Driving, or -1 */
    int jobs;
    bool json, quiet;
    int width, height; /* pixels */
    bool size_said, theme_said;
    Theme theme;
    double frames;     /* pictures a s of the film; 0: none */
    double slow;       /* simulated time is shown so many times slower; 0: not said */
    const char *movie; /* file, or NULL */
    double from, to;   /* s; negative: not said */
    Camera camera;
    int show;               /* FILM_..., added up */
    const char *plot_words; /* --plots, or NULL */
    PlotChoice plots;       /* of a house, as they say; none when they are those of a beam */
    const char *measured;   /* file of measured points, or NULL */
    bool report;            /* write one */
    const char *observed;   /* file of measured loci, or NULL */
    bool suggest;           /* the smallest changes that let everybody out */
    StudyRequest study;
    bool paper;         /* study the paper's claims */
    bool thorough;      /* tell each run of a beam as `run` does */
    const char *types;  /* names of parameters, parted by commas, or NULL */
    int text;           /* size of the window's text, 1 to 3; 0: not said */
    const char *script; /* file for the window to follow, or NULL */
    double benchmark;   /* s, of the window; 0: none */
    double benchmark_edit;
    bool reduced_motion; /* in the window */
    double unit;         /* m, of the file to import; 0: not said */
    const char *layers;  /* of a drawing, as said, or NULL */
    const char *level;   /* of a home, or NULL */
    const char *format;  /* to export to, or NULL */
    char **arguments;    /* (argument_count) the command line, as given */
    int argument_count;
    Arena arena; /* holds what was made of the words */
} Options;
