#include "options/option.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "exchange/import.h"
#include "experiment/drivers.h"
#include "visual/beam/beam_plots.h"
#include "visual/crank/crank_plots.h"
#include "visual/house/film.h"

/* Values that one number, word or text does not hold ----------------------------------------------------------------*/

static bool read_setting(Options *options, const char *value) {
    options->settings[options->setting_count++] = value;
    return true;
}

#define UNTIL_MOST 1e5 /* s, as for the parameter run.until */

/* Stores --until as the setting of run.until. */
static bool read_until(Options *options, const char *value) {
    char *end;
    double seconds = strtod(value, &end);
    return *value && !*end && seconds >= 0 && seconds <= UNTIL_MOST &&
           read_setting(options, text_in_arena(&options->arena, "run.until=%s", value));
}

static bool read_size(Options *options, const char *value) {
    int used = 0;
    bool good = sscanf(value, "%dx%d%n", &options->width, &options->height, &used) == 2 && !value[used];
    return good && options->width >= 320 && options->height >= 200 && options->width <= 16384 &&
           options->height <= 16384;
}

static bool read_camera(Options *options, const char *value) {
    Camera *camera = &options->camera;
    int used = 0,
        numbers = sscanf(value, "%lf,%lf%n,%lf%n", &camera->azimuth, &camera->elevation, &used, &camera->zoom, &used);
    bool good = numbers >= 2 && !value[used] && fabs(camera->azimuth) <= 360;
    camera->kind = VIEW_RAISED;
    return good && camera->elevation >= 5 && camera->elevation <= 90 && camera->zoom >= 0.1 && camera->zoom <= 100;
}

static bool read_show(Options *options, const char *value) {
    const char *unknown;
    options->show = film_shown(value, &unknown);
    return options->show >= 0;
}

static bool read_plots(Options *options, const char *value) {
    char fault[PLOT_CHOICE_FAULT];
    PlotChoice beam, crank;
    options->plot_words = value;
    options->plots.count = 0;
    return house_plots_choose(&options->plots, value, fault) || beam_plots_choose(&beam, value, fault) ||
           crank_plots_choose(&crank, value, fault);
}

static bool read_house_plots(Options *options, const char *value) {
    char fault[PLOT_CHOICE_FAULT];
    options->plot_words = value;
    options->plots.count = 0;
    return house_plots_choose(&options->plots, value, fault);
}

static bool read_vary(Options *options, const char *value) {
    return study_request_vary(&options->study, value, &options->arena);
}

static bool read_spread(Options *options, const char *value) {
    return study_request_spread(&options->study, value, &options->arena);
}

static bool read_sweep(Options *options, const char *value) {
    return study_request_sweep(&options->study, value);
}

static bool read_shard(Options *options, const char *value) {
    return study_request_shard(&options->study, value);
}

static bool read_follow(Options *options, const char *value) {
    options->follow = value;
    return strchr(value, '=') && strchr(value, ':');
}

static bool read_unit(Options *options, const char *value) {
    options->unit = import_unit(value);
    return options->unit > 0;
}

/* The table ---------------------------------------------------------------------------------------------------------*/

#define FIELD(member) offsetof(Options, member), sizeof((Options *)NULL)->member
#define NO_FIELD 0, 0
#define NO_RANGE 0, 0

const Option option_rows[] = {
    {"--set", OPTION_NAME, NO_FIELD, NO_RANGE, "NAME=VALUE",
     "change a parameter, for instance door.d1.width=0.8 (repeatable)", GROUP_INPUT, FOR_HOUSES | FOR_OPEN | FOR_EXPORT,
     NULL, read_setting},
    {"--route", OPTION_TEXT, FIELD(route), NO_RANGE, "ID", "only the people of this route", GROUP_INPUT,
     FOR_RUN | FOR_STUDY | FOR_OPEN, NULL, NULL},
    {"--observed", OPTION_FILE, FIELD(observed), NO_RANGE, "FILE",
     "measured loci for the report: CSV with the columns time, x, y and person", GROUP_INPUT, FOR_RUN, ".csv", NULL},
    {"--measured", OPTION_FILE, FIELD(measured), NO_RANGE, "FILE",
     "measured points to draw over the plots of a beam or a study: CSV with columns such as time [s] and force [N], or "
     "drive.frequency [Hz] and peak_max [N]",
     GROUP_INPUT, FOR_RUN | FOR_STUDY, ".csv", NULL},
    {"--observed", OPTION_FILE, FIELD(observed), NO_RANGE, "FILE[,FILE ...]",
     "houses only: measured times, CSV with the columns route and time [s], and deviation [s] if known (default: those "
     "in the house file); or measured loci, with the columns time, x, y and person",
     GROUP_INPUT, FOR_FIT, ".csv", NULL},
    {"--measured", OPTION_FILE, FIELD(measured), NO_RANGE, "FILE",
     "beams only: CSV with columns such as drive.frequency [Hz] and peak_max [N], or frequency_1 [Hz]", GROUP_INPUT,
     FOR_FIT, ".csv", NULL},
    {"--fit", OPTION_TEXT, FIELD(fit), NO_RANGE, "NAME[,NAME ...]",
     "parameters to fit, at most 8 (default of a house: free speed and steering time of its chairs)", GROUP_INPUT,
     FOR_FIT, NULL, NULL},
    {"--prior", OPTION_TEXT, FIELD(priors), NO_RANGE, "NAME=VALUE:SPREAD[,...]",
     "what is known before: a value and the standard deviation of its logarithm (default: the file's value, 0.5)",
     GROUP_INPUT, FOR_FIT, NULL, NULL},
    {"--leave-out", OPTION_FLAG, FIELD(leave_out), NO_RANGE, NULL,
     "also predict each route, or each measured point, from the others alone", GROUP_INPUT, FOR_FIT, NULL, NULL},
    {"--rules", OPTION_TEXT, FIELD(rules), NO_RANGE, "ID|FILE[,...]",
     "only these rules, by the names of the shipped ones or as files (default: all that are shipped)", GROUP_INPUT,
     FOR_RULES, NULL, NULL},
    {"--rules", OPTION_TEXT, FIELD(rules), NO_RANGE, "ID|FILE[,...]",
     "with --suggest: also say which changes these rules pay for, such as jp-care-insurance", GROUP_INPUT, FOR_CHECK,
     NULL, NULL},
    {"--answers", OPTION_FLAG, FIELD(answers), NO_RANGE, NULL,
     "the teacher's sheet: model answers, numbers, common mistakes and pictures of the results", GROUP_OUTPUT,
     FOR_LESSON, NULL, NULL},
    {"--unit", OPTION_READ, NO_FIELD, NO_RANGE, IMPORT_UNITS,
     "unit of the numbers in the file (default: the one that the file names, or the usual one)", GROUP_INPUT,
     FOR_IMPORT, IMPORT_UNITS, read_unit},
    {"--layers", OPTION_TEXT, FIELD(layers), NO_RANGE, "ROLE=NAME[,NAME ...]",
     "layers of a drawing that are walls, doors, furniture and exits, for instance walls=A-WALL,A-GLAZ,doors=A-DOOR "
     "(default: guess from their names)",
     GROUP_INPUT, FOR_IMPORT, NULL, NULL},
    {"--level", OPTION_TEXT, FIELD(level), NO_RANGE, "NAME", "storey of a home (default: the lowest)", GROUP_INPUT,
     FOR_IMPORT, NULL, NULL},

    {"--driving", OPTION_CHOICE, FIELD(driving), NO_RANGE, "driver|miura",
     "driving model of all chairs: driver is a rectangle that steers along a planned path, miura the disc of the paper",
     GROUP_SIMULATION, (FOR_HOUSES & ~FOR_LOCI & ~FOR_ABLATE) | FOR_OPEN, "driver|miura", NULL},
    {"--until", OPTION_READ, NO_FIELD, 0, UNTIL_MOST, "SECONDS", "stop at this simulated time", GROUP_SIMULATION,
     FOR_RUN | FOR_COMPARE | FOR_STUDY, NULL, read_until},
    {"--lanes", OPTION_WHOLE, FIELD(lanes), 0, 1024, "N",
     "beams and cranks: motions that are watched, to tell whether one that is not periodic lasts (default: of a beam "
     "64 "
     "for 20,000 cycles each, of a crank 16 for 400 revolutions each; 0: none, and the verdict is marked quick); of a "
     "study, with --thorough",
     GROUP_SIMULATION, FOR_RUN | FOR_STUDY, NULL, NULL},
    {"--seed", OPTION_WHOLE, FIELD(seed), 0, (double)INT64_MAX, "N", "seed of all random numbers (default 1)",
     GROUP_SIMULATION, FOR_HOUSES | FOR_CASES | FOR_OPEN, NULL, NULL},

    {"--drivers", OPTION_WHOLE, FIELD(drivers), 1, DRIVERS_MOST, "N",
     "run the house with N drivers of a population, too: their times, how many get out, and how many touch something "
     "(default: as many as the house asks for)",
     GROUP_SIMULATION, FOR_RUN | FOR_COMPARE, NULL, NULL},
    {"--drivers", OPTION_WHOLE, FIELD(drivers), 1, DRIVERS_MOST, "N",
     "of N drivers of a population, how many fit, how many can drive out, how many only with a skid; slow where it is "
     "tight",
     GROUP_SIMULATION, FOR_CHECK, NULL, NULL},
    {"--drivers", OPTION_WHOLE, FIELD(drivers), 1, DRIVERS_MOST, "N",
     "number of drivers of the population (default: as many as the house asks for, or 100)", GROUP_SIMULATION,
     FOR_ABLATE, NULL, NULL},
    {"--drivers", OPTION_WHOLE, FIELD(drivers), 1, DRIVERS_MOST, "N",
     "also try N drivers of a population where the rules are kept: how many get through, get out and touch something, "
     "and the grade of each place; slow where it is tight",
     GROUP_SIMULATION, FOR_RULES, NULL, NULL},
    {"--drivers", OPTION_WHOLE, FIELD(drivers), 1, DRIVERS_MOST, "N",
     "houses only: drive each point with the same N drivers of a population, instead of --runs", GROUP_SIMULATION,
     FOR_STUDY, NULL, NULL},
    {"--population", OPTION_TEXT, FIELD(population), NO_RANGE, "ID|FILE",
     "population of the drivers: one of assets/populations, or a file (default: that of the house, or manual-jp)",
     GROUP_SIMULATION, FOR_RUN | FOR_COMPARE | FOR_CHECK | FOR_ABLATE | FOR_STUDY | FOR_RULES, NULL, NULL},

    {"--vary", OPTION_NAME, NO_FIELD, NO_RANGE, "NAME=FROM:TO:STEPS",
     "vary a parameter from FROM to TO in STEPS values, both ends included, for instance door.d1.width=0.7:1:31 (at "
     "most "
     "twice)",
     GROUP_STUDY, FOR_STUDY, NULL, read_vary},
    {"--runs", OPTION_WHOLE, FIELD(study.runs), 1, STUDY_RUNS_MOST, "N",
     "runs of each point, each with a seed of its own (default 1)", GROUP_STUDY, FOR_STUDY, NULL, NULL},
    {"--shake", OPTION_WHOLE, FIELD(study.shakes), 1, STUDY_RUNS_MOST, "N",
     "houses only: simulate N earthquakes with the seeds from --seed on; in each, furniture topples by its "
     "probability, "
     "then routes are re-planned; says how often and how fast each person leaves, and what stops the others",
     GROUP_STUDY, FOR_STUDY, NULL, NULL},
    {"--spread", OPTION_NAME, NO_FIELD, NO_RANGE, "NAME=SHARE",
     "draw the parameter of each run from a normal distribution with this relative standard deviation, such as 0.02 "
     "(repeatable)",
     GROUP_STUDY, FOR_STUDY, NULL, read_spread},
    {"--sweep", OPTION_READ, NO_FIELD, NO_RANGE, "reset,up,down",
     "start each run afresh (reset, the default), or from the end state of its lower (up) or upper (down) neighbour; a "
     "list",
     GROUP_STUDY, FOR_STUDY, "reset,up,down", read_sweep},
    {"--types", OPTION_TEXT, FIELD(types), NO_RANGE, "NAME[,NAME ...]",
     "classify as type I, II or III within +-1 % of these parameters, from 16 initial states, and name the nearest "
     "trouble; with --vary, at each point",
     GROUP_STUDY, FOR_STUDY, NULL, NULL},
    {"--follow", OPTION_NAME, NO_FIELD, NO_RANGE, "NAME=FROM:TO",
     "beams only: follow the orbit of the file, stable or not, as one of its numbers changes, locate where it folds, "
     "flips, loses its symmetry, becomes a torus or begins to touch, and follow the orbits that begin there; with "
     "--vary of another number, follow these points over both",
     GROUP_STUDY, FOR_STUDY, NULL, read_follow},
    {"--thorough", OPTION_FLAG, FIELD(thorough), NO_RANGE, NULL,
     "beams and cranks: full analysis of every run (Lyapunov exponents, 0-1 test, and whether it lasts, by --lanes); "
     "slower",
     GROUP_STUDY, FOR_STUDY, NULL, NULL},
    {"--paper", OPTION_FLAG, FIELD(paper), NO_RANGE, NULL,
     "beams and cranks: compare each claim of Gu and Dubowsky's paper with our results, of a beam its figures, too; "
     "--out "
     "holds the page",
     GROUP_STUDY, FOR_STUDY, NULL, NULL},

    {"--no-series", OPTION_FLAG, FIELD(study.no_series), NO_RANGE, NULL,
     "beams and cranks: do not keep the peaks of each run, which take most of the room of a large study", GROUP_STUDY,
     FOR_STUDY, NULL, NULL},

    {"--shard", OPTION_MAYBE, NO_FIELD, NO_RANGE, "I/N",
     "run only the I-th of N parts of the study and keep it in --out as study-I-of-N.sqlite; without I/N, the part of "
     "a "
     "task in a job array (SLURM_ARRAY_TASK_ID, SGE_TASK_ID or OMPI_COMM_WORLD_RANK, with its count)",
     GROUP_STUDY, FOR_STUDY, NULL, read_shard},
    {"--merge", OPTION_FLAG, FIELD(study.merge), NO_RANGE, NULL,
     "join the files of all shards in --out, run what they lack, and answer", GROUP_STUDY, FOR_STUDY, NULL, NULL},
    {"--no-run", OPTION_FLAG, FIELD(study.no_run), NO_RANGE, NULL,
     "with --merge: run nothing, answer from what there is", GROUP_STUDY, FOR_STUDY, NULL, NULL},
    {"--print-shards", OPTION_WHOLE, FIELD(study.print_shards), 1, STUDY_SHARDS_MOST, "N",
     "print how to run this study in N shards with Slurm or GNU parallel, and run nothing", GROUP_STUDY, FOR_STUDY,
     NULL, NULL},

    {"--json", OPTION_FLAG, FIELD(json), NO_RANGE, NULL, "print the answer as one JSON object and nothing else",
     GROUP_OUTPUT, FOR_HOUSES | FOR_CASES | FOR_IMPORT, NULL, NULL},
    {"--grades", OPTION_FLAG, FIELD(grades), NO_RANGE, NULL,
     "grade how tight the way of each chair is, from A (easy) to F (impossible), and what is missing to the next grade",
     GROUP_OUTPUT, FOR_CHECK | FOR_RUN, NULL, NULL},
    {"--suggest", OPTION_FLAG, FIELD(suggest), NO_RANGE, NULL,
     "if not all people can leave, list the smallest changes that let all of them out: doors widened, furniture moved, "
     "turned or stood up, each tried by simulation",
     GROUP_OUTPUT, FOR_CHECK, NULL, NULL},
    {"--to", OPTION_CHOICE, FIELD(format), NO_RANGE, EXPORT_WORDS,
     "wkt: the walkable area; svg, pdf, png: a picture of the plan (default: as the name of --out ends, or wkt)",
     GROUP_OUTPUT, FOR_EXPORT, EXPORT_WORDS, NULL},
    {"--out", OPTION_FILE, FIELD(out), NO_RANGE, "FILE|DIR",
     "file or directory to write (default: WKT to standard output, a picture next to the house)", GROUP_OUTPUT,
     FOR_EXPORT, ".wkt,.svg,.pdf,.png", NULL},
    {"--out", OPTION_FOLDER, FIELD(out), NO_RANGE, "DIR",
     "write summary.json, trace.csv, plan.png, beam.png or crank.png (also .svg and .pdf), and trajectory.sqlite "
     "(houses only) to "
     "DIR",
     GROUP_OUTPUT, FOR_RUN, NULL, NULL},
    {"--out", OPTION_FOLDER, FIELD(out), NO_RANGE, "DIR",
     "write plan.png, .svg and .pdf to DIR: the second house, with the routes in the first as \"before\"; and what "
     "other "
     "options ask for",
     GROUP_OUTPUT, FOR_COMPARE, NULL, NULL},
    {"--out", OPTION_FOLDER, FIELD(out), NO_RANGE, "DIR",
     "write fit.json, plot-residuals.png, .svg, .pdf and .csv, and the profile or beam with the fitted values to DIR",
     GROUP_OUTPUT, FOR_FIT, NULL, NULL},
    {"--out", OPTION_FOLDER, FIELD(out), NO_RANGE, "DIR",
     "write rules.json, rules.html, rules.pdf and plan.png, .svg and .pdf with what was measured to DIR", GROUP_OUTPUT,
     FOR_RULES, NULL, NULL},
    {"--out", OPTION_FOLDER, FIELD(out), NO_RANGE, "DIR", "write ablate.json, ablate.html and ablate.pdf to DIR",
     GROUP_OUTPUT, FOR_ABLATE, NULL, NULL},
    {"--out", OPTION_FOLDER, FIELD(out), NO_RANGE, "DIR", "write the sheet, NAME.pdf or NAME-answers.pdf, to DIR",
     GROUP_OUTPUT, FOR_LESSON, NULL, NULL},
    {"--out", OPTION_FOLDER, FIELD(out), NO_RANGE, "DIR", "write cases.html, cases.md and cases.json to DIR",
     GROUP_OUTPUT, FOR_CASES, NULL, NULL},
    {"--out", OPTION_FOLDER, FIELD(out), NO_RANGE, "DIR",
     "write summary.json, study.csv, plots and study.sqlite to DIR; the same command continues an interrupted study",
     GROUP_OUTPUT, FOR_STUDY, NULL, NULL},
    {"--report", OPTION_FLAG, FIELD(report), NO_RANGE, NULL,
     "houses and cranks: write report.html and report.pdf to --out", GROUP_OUTPUT, FOR_RUN, NULL, NULL},
    {"--report", OPTION_FLAG, FIELD(report), NO_RANGE, NULL, "write report.html and report.pdf to --out", GROUP_OUTPUT,
     FOR_COMPARE, NULL, NULL},
    {"--report", OPTION_FLAG, FIELD(report), NO_RANGE, NULL, "write report.html and report.pdf to --out", GROUP_OUTPUT,
     FOR_STUDY, NULL, NULL},

    {"--plots", OPTION_READ, NO_FIELD, NO_RANGE, HOUSE_PLOTS_NAMES,
     "curves next to the house instead of the list of people, and as DIR/plot-NAME.png, .svg, .pdf and .csv; a list; "
     "for a beam: " BEAM_PLOTS_NAMES " (default " BEAM_PLOTS_USUAL "); "
     "for a crank: " CRANK_PLOTS_NAMES " (default " CRANK_PLOTS_USUAL ")",
     GROUP_PICTURES, FOR_RUN, HOUSE_PLOTS_NAMES "," BEAM_PLOTS_NAMES "," CRANK_PLOTS_NAMES, read_plots},
    {"--plots", OPTION_READ, NO_FIELD, NO_RANGE, HOUSE_PLOTS_NAMES,
     "curves of both houses next to the second one instead of the list of people, and as DIR/plot-NAME.png, .svg, .pdf "
     "and .csv; a list",
     GROUP_PICTURES, FOR_COMPARE, HOUSE_PLOTS_NAMES, read_house_plots},
    {"--size", OPTION_READ, NO_FIELD, NO_RANGE, "WxH",
     "size of the pictures in pixels, 320x200 to 16384x16384 (default 1280x720)", GROUP_PICTURES,
     FOR_FILMS | FOR_STUDY | FOR_EXPORT | FOR_RULES | FOR_FIT, NULL, read_size},
    {"--theme", OPTION_CHOICE, FIELD(theme), NO_RANGE, THEME_NAMES, "light (paper, default) or dark (board) pictures",
     GROUP_PICTURES, FOR_FILMS | FOR_STUDY | FOR_EXPORT | FOR_RULES | FOR_FIT | FOR_ABLATE, THEME_NAMES, NULL},

    {"--frames", OPTION_NUMBER, FIELD(frames), 0.001, 1000, "FPS",
     "write FPS pictures per simulated second (beams, cranks: per second of film) to DIR/frames/frame-00001.png and so "
     "on",
     GROUP_FILM, FOR_RUN, NULL, NULL},
    {"--frames", OPTION_NUMBER, FIELD(frames), 0.001, 1000, "FPS",
     "write FPS pictures per simulated second to DIR/frames/frame-00001.png and so on", GROUP_FILM, FOR_COMPARE, NULL,
     NULL},
    {"--movie", OPTION_FILE, FIELD(movie), NO_RANGE, "FILE",
     "make a film with ffmpeg: .mp4, .mkv, .mov or .webm (30 pictures per second unless --frames is given)", GROUP_FILM,
     FOR_FILMS, ".mp4,.mkv,.mov,.webm", NULL},
    {"--slow", OPTION_NUMBER, FIELD(slow), 0.001, 1e9, "TIMES",
     "beams and cranks: slow-motion factor (default: a beam's drive cycle lasts 1.5 s, a crank is 60 times slower)",
     GROUP_FILM, FOR_RUN, NULL, NULL},
    {"--from", OPTION_NUMBER, FIELD(from), 0, 1e9, "SECONDS", "time of the first picture (default 0)", GROUP_FILM,
     FOR_FILMS, NULL, NULL},
    {"--to", OPTION_NUMBER, FIELD(to), 0, 1e9, "SECONDS",
     "time of the last picture (default: when the last person is out; beams: after 8 cycles, cranks: after 3 "
     "revolutions)",
     GROUP_FILM, FOR_RUN, NULL, NULL},
    {"--to", OPTION_NUMBER, FIELD(to), 0, 1e9, "SECONDS",
     "time of the last picture (default: when the last person is out of the second house)", GROUP_FILM, FOR_COMPARE,
     NULL, NULL},
    {"--view", OPTION_CHOICE, FIELD(camera.kind), NO_RANGE, VIEW_NAMES,
     "view from above (plan, default) or from the side (raised); raised writes the last picture as DIR/raised.png, too",
     GROUP_FILM, FOR_FILMS, VIEW_NAMES, NULL},
    {"--camera", OPTION_READ, NO_FIELD, NO_RANGE, "AZ,EL[,ZOOM]",
     "raised view from this azimuth (0: up the plan) and elevation (5 to 90 degrees), enlarged ZOOM times (default "
     "10,60,1)",
     GROUP_FILM, FOR_FILMS, NULL, read_camera},
    {"--show", OPTION_READ, NO_FIELD, NO_RANGE, FILM_SHOWN_NAMES,
     "draw also discs that cover the chairs, planned routes, and widths at corners; a list", GROUP_FILM, FOR_FILMS,
     FILM_SHOWN_NAMES, read_show},

    {"--size", OPTION_READ, NO_FIELD, NO_RANGE, "WxH",
     "size of the window in pixels, 320x200 to 16384x16384 (default: as last time)", GROUP_WINDOW,
     FOR_OPEN | FOR_LESSON, NULL, read_size},
    {"--theme", OPTION_CHOICE, FIELD(theme), NO_RANGE, THEME_NAMES,
     "light (paper) or dark (board) (default: as last time)", GROUP_WINDOW, FOR_OPEN | FOR_LESSON, THEME_NAMES, NULL},
    {"--text", OPTION_WHOLE, FIELD(text), 1, 3, "1|2|3", "size of the text (default: as last time)", GROUP_WINDOW,
     FOR_OPEN | FOR_LESSON, "1|2|3", NULL},
    {"--reduced-motion", OPTION_FLAG, FIELD(reduced_motion), NO_RANGE, NULL,
     "animate nothing but the simulation itself", GROUP_WINDOW, FOR_OPEN | FOR_LESSON, NULL, NULL},
    {"--script", OPTION_FILE, FIELD(script), NO_RANGE, "FILE",
     "do what this file says, as a person would; for tests and lessons", GROUP_WINDOW, FOR_OPEN | FOR_LESSON, ".script",
     NULL},
    {"--benchmark-window", OPTION_NUMBER, FIELD(benchmark), 0.1, 1e6, "SECONDS",
     "play for this time, then move the view for as long, print the pictures per second and how busy the machine is, "
     "and end",
     GROUP_WINDOW, FOR_OPEN, NULL, NULL},
    {"--benchmark-edit", OPTION_NUMBER, FIELD(benchmark_edit), 0.1, 1e6, "SECONDS",
     "drag a wardrobe for this time, print how long the answer takes after each move and how busy the machine is, and "
     "end",
     GROUP_WINDOW, FOR_OPEN, NULL, NULL},

    {"--jobs", OPTION_WHOLE, FIELD(jobs), 1, 1024, "N",
     "number of threads (default: one per processor); the answer does not depend on it", GROUP_PROGRAM,
     FOR_HOUSES | FOR_CASES | FOR_LESSON | FOR_OPEN, NULL, NULL},
    {"--quiet", OPTION_FLAG, FIELD(quiet), NO_RANGE, NULL, "print no progress", GROUP_PROGRAM, FOR_HOUSES | FOR_CASES,
     NULL, NULL},
};
const size_t option_count = sizeof option_rows / sizeof *option_rows;
_Static_assert(sizeof option_rows / sizeof *option_rows <= OPTIONS_MOST, "Options.given has room for all rows");

const char *option_group_name(OptionGroup group) {
    static const char *const names[OPTION_GROUPS] = {
        [GROUP_INPUT] = "Input",   [GROUP_SIMULATION] = "Simulation", [GROUP_STUDY] = "Study",
        [GROUP_OUTPUT] = "Output", [GROUP_PICTURES] = "Pictures",     [GROUP_FILM] = "Films",
        [GROUP_WINDOW] = "Window", [GROUP_PROGRAM] = "Program"};
    return names[group];
}

/* Looking up --------------------------------------------------------------------------------------------------------*/

static bool is_taken(const Option *option, VerbId verb) {
    return option->verbs >> verb & 1;
}

const Option *option_find(VerbId verb, const char *name, size_t length) {
    for (size_t o = 0; o < option_count; o++)
        if (is_taken(&option_rows[o], verb) && strlen(option_rows[o].name) == length &&
            memcmp(option_rows[o].name, name, length) == 0)
            return &option_rows[o];
    return NULL;
}

size_t option_names(VerbId verb, const char **names) {
    size_t count = 0;
    for (size_t o = 0; o < option_count; o++)
        if (is_taken(&option_rows[o], verb))
            names[count++] = option_rows[o].name;
    return count;
}

size_t option_words(const Option *option, const char **words, Arena *arena) {
    size_t count = 0;
    for (const char *at = option->words; at && *at && count < OPTION_WORDS;) {
        size_t length = strcspn(at, "|,");
        words[count++] = text_in_arena(arena, "%.*s", (int)length, at);
        at += length + (at[length] != '\0');
    }
    return count;
}

/* Taking a value ----------------------------------------------------------------------------------------------------*/

static bool take_whole(const Option *option, void *field, const char *value) {
    char *end;
    errno = 0;
    long long number = strtoll(value, &end, 10); /* beyond INT64_MAX: ERANGE */
    if (!*value || *end || errno || (double)number < option->low || (double)number > option->high)
        return false;
    if (option->size == sizeof(int))
        *(int *)field = (int)number;
    else
        *(uint64_t *)field = (uint64_t)number;
    return true;
}

static bool take_number(const Option *option, void *field, const char *value) {
    char *end;
    double number = strtod(value, &end);
    bool good = *value && !*end && number >= option->low && number <= option->high;
    if (good)
        *(double *)field = number;
    return good;
}

static bool take_choice(const Option *option, Options *options, void *field, const char *value) {
    const char *words[OPTION_WORDS];
    size_t count = option_words(option, words, &options->arena);
    for (size_t w = 0; w < count; w++)
        if (strcmp(words[w], value) == 0) {
            *(int *)field = (int)w;
            return true;
        }
    return false;
}

bool option_take(const Option *option, Options *options, const char *value) {
    void *field = (char *)options + option->offset;
    bool good = false;
    switch (option->kind) {
    case OPTION_FLAG:
        good = !value;
        *(bool *)field = good;
        break;
    case OPTION_WHOLE:
        good = value && take_whole(option, field, value);
        break;
    case OPTION_NUMBER:
        good = value && take_number(option, field, value);
        break;
    case OPTION_CHOICE:
        good = value && take_choice(option, options, field, value);
        break;
    case OPTION_TEXT:
    case OPTION_FILE:
    case OPTION_FOLDER:
        good = value && *value;
        *(const char **)field = value;
        break;
    case OPTION_NAME:
    case OPTION_READ:
        good = value && option->read(options, value);
        break;
    case OPTION_MAYBE:
        good = option->read(options, value);
        break;
    }
    options->given[option - option_rows] |= good;
    return good;
}
