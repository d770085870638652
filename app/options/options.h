/* The values of the options of one command line, and the exit codes. */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "base/memory.h"
#include "draw/palette.h"
#include "draw/view.h"
#include "options/study_request.h"
#include "options/verb.h"
#include "visual/house/house_plots.h"

/* The exit codes are part of the contract with scripts. */
typedef enum ExitCode {
    EXIT_ANSWERED = 0,  /* the answer is yes: all people are out, or the motion of the beam is known */
    EXIT_ANSWER_NO = 1, /* the answer is no, or the work was interrupted: then the JSON answer says "interrupted" */
    EXIT_WRONG_INPUT = 2,
    EXIT_OUR_FAULT = 3,
} ExitCode;

typedef enum ExportFormat { EXPORT_WKT, EXPORT_SVG, EXPORT_PDF, EXPORT_PNG, EXPORT_FORMATS } ExportFormat;

#define EXPORT_WORDS "wkt|svg|pdf|png"

enum { OPTIONS_MOST = 128 /* rows of the table in option.c */ };

/* The values of the options. Texts belong to argv or to the arena. */
typedef struct Options {
    const char **files; /* (file_count) */
    size_t file_count;
    const char **settings; /* (setting_count) NAME=VALUE */
    size_t setting_count;
    const char *out;   /* directory or file, or NULL */
    const char *route; /* id, or NULL */
    uint64_t seed;
    int driving;            /* Driving, or -1 */
    int drivers;            /* number of drivers; 0: the nominal one alone */
    const char *population; /* id or file, or NULL */
    int jobs;
    bool json, quiet;
    int width, height; /* pixels */
    int theme;         /* Theme */
    double frames;     /* 1/s, pictures per second of the film; 0: none */
    double slow;       /* 1, how many times slower a beam is shown; 0: not given */
    const char *movie; /* file, or NULL */
    double from, to;   /* s; negative: not given */
    Camera camera;
    int show;               /* FILM_..., added up */
    const char *plot_words; /* --plots, or NULL */
    PlotChoice plots;       /* those words as plots of a house; none if they name plots of a beam */
    const char *measured;   /* file of measured points, or NULL */
    bool report;
    const char *observed; /* file of measured loci, or NULL */
    bool suggest, grades;
    const char *fit;    /* names of parameters, separated by commas, or NULL */
    const char *priors; /* NAME=VALUE:SPREAD, separated by commas, or NULL */
    bool leave_out;
    bool answers;
    const char *rules; /* ids and files, separated by commas, or NULL: all that are shipped */
    StudyRequest study;
    bool paper;
    bool thorough;
    int lanes;          /* motions that are watched to tell whether chaos lasts; 0: none; or SURVIVAL_USUAL */
    const char *follow; /* NAME=FROM:TO, or NULL */
    const char *types;  /* names of parameters, separated by commas, or NULL */
    int text;           /* size of the window's text, 1 to 3; 0: not given */
    const char *script; /* file for the window to follow, or NULL */
    double benchmark;   /* s, of the window; 0: none */
    double benchmark_edit;
    bool reduced_motion;
    double unit;              /* m, of the file to import; 0: not given */
    const char *layers;       /* of a drawing, as given, or NULL */
    const char *level;        /* of a home, or NULL */
    int format;               /* ExportFormat */
    bool help;                /* print the help of the verb and end */
    bool given[OPTIONS_MOST]; /* by row of the table in option.c */
    char **arguments;         /* (argument_count) the command line, as given */
    int argument_count;
    Arena arena; /* keeps texts that were made while the values were read */
} Options;

/* Sets the defaults. options_end releases what the reading takes. */
void options_begin(Options *options, int argc, char **argv);
void options_end(Options *options);

/* Reads argv from `first` on as files and options of a verb. Returns 0, or EXIT_WRONG_INPUT after one line on standard
 * error. */
int options_read(Options *options, VerbId verb, int first);

/* True if the command line holds the option of that name, "--seed". */
bool options_given(const Options *options, const char *name);

/* Prints "clearance: WHAT "WORD"" on standard error, with the nearest of the known words (count) if there is one near
 * enough. Returns EXIT_WRONG_INPUT. */
int options_complain(const char *what, const char *word, const char *const *known, size_t count);
