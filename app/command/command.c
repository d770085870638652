#include "command/command.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/memory.h"
#include "base/parallel.h"
#include "base/text.h"
#include "house/profile.h"
#include "laboratory/beam_plots.h"
#include "laboratory/film.h"
#include "window/settings.h"

volatile sig_atomic_t command_interrupted;

bool command_shows_progress(const Options *options) {
    return !options->quiet && (isatty(STDERR_FILENO) || getenv("CLEARANCE_PROGRESS"));
}

/* Verbs ----------------------------------------------------------------------------------------------------------- */

enum {
    FOR_RUN = 1,
    FOR_CHECK = 2,
    FOR_COMPARE = 4,
    FOR_LOCI = 8,
    FOR_SCHEMA = 16,
    FOR_CASES = 32,
    FOR_STUDY = 64,
    FOR_OPEN = 128
};
enum { FOR_HOUSES = FOR_RUN | FOR_CHECK | FOR_COMPARE | FOR_LOCI | FOR_STUDY, FOR_FILMS = FOR_RUN | FOR_COMPARE };

typedef struct Verb {
    const char *name;
    int mark; /* FOR_... */
    size_t least_files, most_files;
    const char *usage;
    const char *meaning;
    const char *examples;
    int (*act)(const Options *options);
} Verb;

static const Verb verbs[] = {
    {"open", FOR_OPEN, 0, 1, "[HOUSE|BEAM]",
     "the window, in which it moves and all can be changed; `clearance` alone opens it, too",
     "  clearance\n"
     "  clearance open houses/ube-techno-house.json\n"
     "  clearance open assets/beams/ibs.json --set drive.frequency=290 --theme board\n",
     command_open},
    {"run", FOR_RUN, 1, 1, "HOUSE|BEAM",
     "simulate an evacuation to the end, or a beam in its clearance: the answer, and with --out data and pictures",
     "  clearance run houses/ube-techno-house.json --out out\n"
     "  clearance run houses/ube-techno-house.json --route C --driving miura --json\n"
     "  clearance run houses/ube-techno-house.json --report --out out\n"
     "  clearance run houses/corner-0.90-0.90.json --set profile.manual-chair.width=0.70\n"
     "  clearance run assets/beams/ibs.json --set drive.frequency=290 --out out\n",
     command_run},
    {"check", FOR_CHECK, 1, 1, "HOUSE",
     "find faults, then say for each person whether they can get out, and if not, why",
     "  clearance check houses/flat-0.910-module.json\n"
     "  clearance check houses/flat-0.910-module.json --set door.d1.width=0.90 --json\n",
     command_check},
    {"compare", FOR_COMPARE, 2, 2, "HOUSE_A HOUSE_B", "run both and show what differs",
     "  clearance compare houses/flat-0.910-module.json houses/flat-0.910-widened.json\n"
     "  clearance compare houses/flat-0.910-module.json houses/flat-0.910-widened.json --report --out out\n",
     command_compare},
    {"study", FOR_STUDY, 1, 1, "HOUSE|BEAM",
     "run it over a range of one or two of its numbers, or many times, and say where the answer changes",
     "  clearance study houses/flat-0.910-module.json --vary door.d3.width=0.7:1:31 --out out\n"
     "  clearance study houses/corner-0.90-0.90.json --vary profile.manual-chair.width=0.5:0.7:11 --vary "
     "profile.manual-chair.length=1:1.2:5\n"
     "  clearance study houses/ube-techno-house.json --runs 100 --spread profile.manual-chair.free_speed=0.1\n",
     command_study},
    {"loci", FOR_LOCI, 1, SIZE_MAX, "HOUSE ...",
     "drive each house both ways, miura and driver: times, and how far apart the loci are",
     "  clearance loci houses/corner-*.json\n", command_loci},
    {"cases", FOR_CASES, 1, SIZE_MAX, "DIR|FILE ...", "run public verification tests: what passed, and if not, why",
     "  clearance cases tests/cases --out out\n"
     "  clearance cases tests/cases/rimea-01.json\n",
     command_cases},
    {"schema", FOR_SCHEMA, 1, 1, "house|profile|beam", "print the JSON Schema of a kind of file, for editors",
     "  clearance schema house > house.schema.json\n", command_schema},
};
enum { VERBS = sizeof verbs / sizeof *verbs };

/* Options --------------------------------------------------------------------------------------------------------- */

typedef struct Option {
    const char *name;
    const char *argument; /* NULL: none */
    int marks;            /* the verbs that take it */
    const char *meaning;
    bool (*take)(Options *options, const char *value); /* false: `argument` does not describe the value */
} Option;

static bool take_setting(Options *options, const char *value) {
    options->settings[options->setting_count++] = value;
    return true;
}

static bool take_whole(const char *value, long long low, long long high, long long *number) {
    char *end;
    errno = 0;
    *number = strtoll(value, &end, 10);
    return *value && !*end && !errno && *number >= low && *number <= high;
}

static bool take_seed(Options *options, const char *value) {
    long long number;
    if (!take_whole(value, 0, INT64_MAX, &number))
        return false;
    options->seed = (uint64_t)number;
    return options->seed_said = true;
}

static bool take_jobs(Options *options, const char *value) {
    long long number;
    if (!take_whole(value, 1, 1024, &number))
        return false;
    options->jobs = (int)number;
    return true;
}

static bool take_out(Options *options, const char *value) {
    options->out = value;
    return *value;
}

static bool take_json(Options *options, const char *value) {
    (void)value;
    return options->json = true;
}

static bool take_quiet(Options *options, const char *value) {
    (void)value;
    return options->quiet = true;
}

static bool take_report(Options *options, const char *value) {
    (void)value;
    return options->report = true;
}

static bool take_observed(Options *options, const char *value) {
    options->observed = value;
    return *value;
}

static bool take_route(Options *options, const char *value) {
    options->route = value;
    return *value;
}

static bool take_driving(Options *options, const char *value) {
    options->driving = strcmp(value, "driver") == 0 ? DRIVING_DRIVER : strcmp(value, "miura") == 0 ? DRIVING_MIURA : -1;
    return options->driving >= 0;
}

/* --until is a parameter like any other. */
static bool take_until(Options *options, const char *value) {
    char *end;
    double seconds = strtod(value, &end);
    if (!*value || *end || !(seconds >= 0))
        return false;
    size_t size = strlen("run.until=") + strlen(value) + 1;
    char *setting = arena_allocate(&options->arena, size);
    snprintf(setting, size, "run.until=%s", value);
    return take_setting(options, setting);
}

static bool take_size(Options *options, const char *value) {
    int used = 0;
    bool good = sscanf(value, "%dx%d%n", &options->width, &options->height, &used) == 2 && !value[used];
    return good && options->width >= 320 && options->height >= 200 && options->width <= 16384 &&
           options->height <= 16384 && (options->size_said = true);
}

/* A number of a range, alone. */
static bool take_number(const char *value, double low, double high, double *number) {
    char *end;
    *number = strtod(value, &end);
    return *value && !*end && *number >= low && *number <= high;
}

static bool take_frames(Options *options, const char *value) {
    return take_number(value, 0.001, 1000, &options->frames);
}

static bool take_slow(Options *options, const char *value) {
    return take_number(value, 0.001, 1e9, &options->slow);
}

static bool take_from(Options *options, const char *value) {
    return take_number(value, 0, 1e9, &options->from);
}

static bool take_to(Options *options, const char *value) {
    return take_number(value, 0, 1e9, &options->to);
}

static bool take_movie(Options *options, const char *value) {
    options->movie = value;
    return *value;
}

static bool take_view(Options *options, const char *value) {
    options->camera.kind = strcmp(value, "raised") == 0 ? VIEW_RAISED : VIEW_PLAN;
    return strcmp(value, "raised") == 0 || strcmp(value, "plan") == 0;
}

static bool take_camera(Options *options, const char *value) {
    Camera *camera = &options->camera;
    int used = 0,
        numbers = sscanf(value, "%lf,%lf%n,%lf%n", &camera->azimuth, &camera->elevation, &used, &camera->zoom, &used);
    bool good = numbers >= 2 && !value[used] && fabs(camera->azimuth) <= 360;
    camera->kind = VIEW_RAISED;
    return good && camera->elevation >= 5 && camera->elevation <= 90 && camera->zoom >= 0.1 && camera->zoom <= 100;
}

static bool take_show(Options *options, const char *value) {
    const char *unknown;
    options->show = film_shown(value, &unknown);
    return options->show >= 0;
}

static bool take_plots(Options *options, const char *value) {
    char fault[PLOT_CHOICE_FAULT];
    PlotChoice beam;
    options->plot_words = value;
    options->plots.count = 0;
    return house_plots_choose(&options->plots, value, fault) || beam_plots_choose(&beam, value, fault);
}

static bool take_measured(Options *options, const char *value) {
    options->measured = value;
    return *value;
}

static bool take_theme(Options *options, const char *value) {
    options->theme = strcmp(value, "board") == 0 ? THEME_BOARD : THEME_PAPER;
    options->theme_said = true;
    return strcmp(value, "board") == 0 || strcmp(value, "paper") == 0;
}

static bool take_vary(Options *options, const char *value) {
    return study_request_vary(&options->study, value, &options->arena);
}

static bool take_spread(Options *options, const char *value) {
    return study_request_spread(&options->study, value, &options->arena);
}

static bool take_sweep(Options *options, const char *value) {
    return study_request_sweep(&options->study, value);
}

static bool take_types(Options *options, const char *value) {
    options->types = value;
    return *value;
}

static bool take_thorough(Options *options, const char *value) {
    (void)value;
    return options->thorough = true;
}

static bool take_paper(Options *options, const char *value) {
    (void)value;
    return options->paper = true;
}

static bool take_runs(Options *options, const char *value) {
    long long number;
    bool good = take_whole(value, 1, STUDY_RUNS_MOST, &number);
    options->study.runs = good ? (size_t)number : 0;
    return good;
}

static bool take_text(Options *options, const char *value) {
    long long number;
    bool good = take_whole(value, 1, SETTINGS_TEXT_MOST, &number);
    options->text = good ? (int)number : 0;
    return good;
}

static bool take_script(Options *options, const char *value) {
    options->script = value;
    return *value;
}

static bool take_benchmark(Options *options, const char *value) {
    return take_number(value, 0.1, 1e6, &options->benchmark);
}

static bool take_reduced_motion(Options *options, const char *value) {
    (void)value;
    return options->reduced_motion = true;
}

static const Option option_rows[] = {
    {"--set", "NAME=VALUE", FOR_HOUSES | FOR_OPEN, "change a parameter, for instance door.d1.width=0.8 (repeatable)",
     take_setting},
    {"--out", "DIR", FOR_RUN,
     "write summary.json, trace.csv, of a house trajectory.sqlite, and plan.png or beam.png, .svg and .pdf there",
     take_out},
    {"--out", "DIR", FOR_COMPARE,
     "write plan.png, .svg and .pdf, B with the ways in A as \"before\", and what other options ask for", take_out},
    {"--out", "DIR", FOR_CASES, "write cases.html, cases.md and cases.json there", take_out},
    {"--out", "DIR", FOR_STUDY,
     "write summary.json, study.csv and plots there, and study.sqlite, from which a study that was stopped goes on",
     take_out},
    {"--vary", "NAME=FROM:TO:STEPS", FOR_STUDY,
     "from FROM to TO in STEPS values, both ends among them, for instance door.d1.width=0.7:1:31 (at most twice)",
     take_vary},
    {"--runs", "N", FOR_STUDY, "runs of each point, with seeds of their own, 1 to 100000 (default 1)", take_runs},
    {"--spread", "NAME=SHARE", FOR_STUDY,
     "in each run the number is off by a normal deviate of this share of it, such as 0.02 (repeatable)", take_spread},
    {"--sweep", "reset,up,down", FOR_STUDY,
     "each run from its start, or from where its neighbour below or above ended; a list (default reset)", take_sweep},
    {"--types", "NAME[,NAME ...]", FOR_STUDY,
     "tell type I, II or III in a window of 1 % in each of these numbers, from 16 starts, and what is beyond; with "
     "--vary, of each point",
     take_types},
    {"--thorough", NULL, FOR_STUDY, "of a beam: tell each run as `run` does, with exponents and the 0-1 test; slower",
     take_thorough},
    {"--paper", NULL, FOR_STUDY,
     "of a beam: each claim and figure of Gu and Dubowsky's paper beside ours; --out has them as a page", take_paper},
    {"--report", NULL, FOR_RUN | FOR_COMPARE, "write report.html and report.pdf to --out, to be handed on",
     take_report},
    {"--observed", "FILE", FOR_RUN, "measured loci for the report: CSV with columns time, x, y and person",
     take_observed},
    {"--json", NULL, FOR_HOUSES | FOR_CASES, "the answer as one JSON object and nothing else", take_json},
    {"--route", "ID", FOR_RUN | FOR_STUDY | FOR_OPEN, "only this route's people", take_route},
    {"--driving", "miura|driver", (FOR_HOUSES & ~FOR_LOCI) | FOR_OPEN, "drive everybody this way", take_driving},
    {"--until", "SECONDS", FOR_RUN | FOR_COMPARE | FOR_STUDY, "give up at this simulated time", take_until},
    {"--seed", "N", FOR_HOUSES | FOR_CASES | FOR_OPEN, "seed of all chance, from 0 (default 1)", take_seed},
    {"--jobs", "N", FOR_HOUSES | FOR_CASES | FOR_OPEN,
     "threads, from 1 (default: one a processor); the answer is the same", take_jobs},
    {"--frames", "FPS", FOR_FILMS,
     "write so many pictures of each second (of a beam: of film) to DIR/frames/frame-00001.png and so on", take_frames},
    {"--movie", "FILE", FOR_FILMS, "make a film of them (30 a second where --frames does not say), by ffmpeg",
     take_movie},
    {"--slow", "TIMES", FOR_RUN, "of a beam: so many times slower (default: so that a cycle takes some 1.5 s)",
     take_slow},
    {"--from", "SECONDS", FOR_FILMS, "begin them at this time (default 0)", take_from},
    {"--to", "SECONDS", FOR_FILMS, "end them at this time (default: when the last is out, or 8 cycles of a beam)",
     take_to},
    {"--view", VIEW_WORDS, FOR_FILMS, "seen from above, or raised: then also DIR/raised.png, at the end", take_view},
    {"--camera", "AZ,EL[,ZOOM]", FOR_FILMS,
     "raised from this azimuth (0: up the plan) and elevation, 5 to 90 degrees, so many times larger (default 10,60,1)",
     take_camera},
    {"--show", FILM_WORDS, FOR_FILMS, "show also discs that cover the chairs, planned ways, widths at corners; a list",
     take_show},
    {"--plots", HOUSE_PLOTS_WORDS, FOR_FILMS,
     "curves beside the house, in place of the list, and as DIR/plot-NAME.png, .svg, .pdf and .csv; a list; of a "
     "beam: " BEAM_PLOTS_WORDS " (default " BEAM_PLOTS_USUAL ")",
     take_plots},
    {"--measured", "FILE", FOR_RUN | FOR_STUDY,
     "measured points laid over the plots of a beam or a study: CSV with columns like time [s] and force [N], or "
     "drive.frequency [Hz] and peak_max [N]",
     take_measured},
    {"--size", "WxH", FOR_FILMS | FOR_STUDY,
     "size of the pictures in pixels, 320x200 to 16384x16384 (default 1280x720)", take_size},
    {"--size", "WxH", FOR_OPEN, "size of the window in pixels, 320x200 to 16384x16384 (default: as last time)",
     take_size},
    {"--theme", THEME_WORDS, FOR_FILMS | FOR_STUDY, "light or dark pictures", take_theme},
    {"--theme", THEME_WORDS, FOR_OPEN, "light or dark (default: as last time)", take_theme},
    {"--text", "1|2|3", FOR_OPEN, "size of the text (default: as last time)", take_text},
    {"--reduced-motion", NULL, FOR_OPEN, "nothing moves but what is simulated", take_reduced_motion},
    {"--script", "FILE", FOR_OPEN, "do what this file says, as a person would; for tests and lessons", take_script},
    {"--benchmark-window", "SECONDS", FOR_OPEN, "play for so long, say how many pictures a second there were, and end",
     take_benchmark},
    {"--quiet", NULL, FOR_HOUSES | FOR_CASES, "no progress", take_quiet},
};
enum {
    OPTIONS = sizeof option_rows / sizeof *option_rows,
    NAME_WIDTH = 10,
    ARGUMENT_WIDTH = 22, /* characters: what is longer has a line of its own */
};

/* Help ------------------------------------------------------------------------------------------------------------ */

static void print_help(void) {
    printf("clearance " CLEARANCE_VERSION
           ": does a wheelchair user get out, how long does it take, where is the danger?\n"
           "And a beam that rattles in its clearance: is it periodic or chaotic, and what does that mean?\n\n");
    for (size_t v = 0; v < VERBS; v++)
        printf("%s", verbs[v].examples);
    printf("\n");
    for (size_t v = 0; v < VERBS; v++)
        printf("  clearance %-8s %-16s %s\n", verbs[v].name, verbs[v].usage, verbs[v].meaning);
    printf("\n`clearance VERB --help` tells a verb's options. Exit codes: 0 everybody gets out, or the beam's\n"
           "motion can be told; 1 the answer is no; 2 wrong use or bad input, 3 a fault of the program.\n");
}

static void print_verb_help(const Verb *verb) {
    printf("%s\nclearance %s %s [options]: %s\n\n", verb->examples, verb->name, verb->usage, verb->meaning);
    for (size_t o = 0; o < OPTIONS; o++) {
        const Option *option = &option_rows[o];
        const char *argument = option->argument ? option->argument : "";
        if (!(option->marks & verb->mark))
            continue;
        size_t wide = strlen(option->name) > NAME_WIDTH ? strlen(option->name) - NAME_WIDTH : 0;
        printf("  %-*s %-*s", NAME_WIDTH, option->name, ARGUMENT_WIDTH - (int)wide, argument);
        if (strlen(argument) + wide > ARGUMENT_WIDTH)
            printf("\n%*s", NAME_WIDTH + ARGUMENT_WIDTH + 3, "");
        printf(" %s\n", option->meaning);
    }
}

static int wrong_use(const char *what, const char *word, const char *const *known, size_t count) {
    const char *nearest = known ? text_nearest(word, known, count) : NULL;
    fprintf(stderr, "clearance: %s \"%s\"%s%s%s\n", what, word, nearest ? ", did you mean " : ", see clearance --help",
            nearest ? nearest : "", nearest ? "?" : "");
    return EXIT_WRONG_INPUT;
}

/* Reading argv ------------------------------------------------------------------------------------------------------*/

static const Option *find_option(const Verb *verb, const char *name, size_t length) {
    for (size_t o = 0; o < OPTIONS; o++)
        if ((option_rows[o].marks & verb->mark) && strlen(option_rows[o].name) == length &&
            memcmp(option_rows[o].name, name, length) == 0)
            return &option_rows[o];
    return NULL;
}

/* Takes the option at argv[*at], as --name value or --name=value. */
static int take_option(const Verb *verb, Options *options, int argc, char **argv, int *at) {
    const char *word = argv[*at], *equals = strchr(word, '=');
    size_t length = equals ? (size_t)(equals - word) : strlen(word);
    const Option *option = find_option(verb, word, length);
    if (!option) {
        const char *known[OPTIONS];
        size_t count = 0;
        for (size_t o = 0; o < OPTIONS; o++)
            if (option_rows[o].marks & verb->mark)
                known[count++] = option_rows[o].name;
        return wrong_use("unknown option", word, known, count);
    }
    const char *value = equals ? equals + 1 : NULL;
    if (option->argument && !value && *at + 1 < argc)
        value = argv[++*at];
    if ((option->argument && !value) || (!option->argument && value) || !option->take(options, value)) {
        fprintf(stderr, "clearance: %s takes %s%s%s%s: %s\n", option->name,
                option->argument ? option->argument : "no value", value ? ", not \"" : "", value ? value : "",
                value ? "\"" : "", option->meaning);
        return EXIT_WRONG_INPUT;
    }
    return 0;
}

static void free_options(Options *options) {
    memory_free(options->settings);
    memory_free(options->files);
    arena_clear(&options->arena);
}

/* The verb's own words begin at argv[first]. */
static int run_verb(const Verb *verb, int argc, char **argv, int first) {
    Options options = {.seed = 1,
                       .driving = -1,
                       .jobs = parallel_processors(),
                       .width = 1280,
                       .height = 720,
                       .from = -1,
                       .to = -1,
                       .camera = {.azimuth = VIEW_AZIMUTH, .elevation = VIEW_ELEVATION, .zoom = 1}};
    options.arguments = argv;
    options.argument_count = argc;
    options.settings = memory_allocate((size_t)argc, sizeof *options.settings);
    options.files = memory_allocate((size_t)argc, sizeof *options.files);
    int code = 0;
    for (int i = first; i < argc && !code; i++) {
        if (strcmp(argv[i], "--help") == 0 || strcmp(argv[i], "-h") == 0) {
            print_verb_help(verb);
            free_options(&options);
            return 0;
        }
        if (argv[i][0] == '-' && argv[i][1])
            code = take_option(verb, &options, argc, argv, &i);
        else if (options.file_count < verb->most_files)
            options.files[options.file_count++] = argv[i];
        else
            code = wrong_use("one argument too many:", argv[i], NULL, 0);
    }
    if (!code && options.file_count < verb->least_files) {
        fprintf(stderr, "clearance: usage: clearance %s %s [options]\n", verb->name, verb->usage);
        code = EXIT_WRONG_INPUT;
    }
    if (!code)
        code = verb->act(&options);
    free_options(&options);
    return code;
}

static void interrupt(int signal_number) {
    if (command_interrupted)
        _exit(128 + signal_number);
    command_interrupted = 1;
}

/* A word that is no verb and looks like a file. */
static bool is_file(const char *word) {
    size_t length = strlen(word);
    return strchr(word, '/') || (length > 5 && strcmp(word + length - 5, ".json") == 0) || access(word, F_OK) == 0;
}

static int dispatch(int argc, char **argv) {
    signal(SIGINT, interrupt);
    signal(SIGTERM, interrupt);
    signal(SIGXFSZ, SIG_IGN); /* a file that would be too large is told of as any other that cannot be written */
    const char *word = argc < 2 ? "open" : argv[1];
    if (strcmp(word, "--help") == 0 || strcmp(word, "-h") == 0 || strcmp(word, "help") == 0) {
        print_help();
        return 0;
    }
    if (strcmp(word, "--version") == 0) {
        printf("clearance " CLEARANCE_VERSION "\n");
        return 0;
    }
    const char *names[VERBS];
    for (size_t v = 0; v < VERBS; v++) {
        names[v] = verbs[v].name;
        if (strcmp(word, verbs[v].name) == 0)
            return run_verb(&verbs[v], argc, argv, 2);
    }
    if (*word == '-' || is_file(word))
        return run_verb(&verbs[0], argc, argv, 1);
    return wrong_use("unknown verb", word, names, VERBS);
}

int command_main(int argc, char **argv) {
    int code = dispatch(argc, argv);
    if (fflush(stdout) || ferror(stdout)) {
        fprintf(stderr, "clearance: the answer cannot be written: %s\n", strerror(errno));
        return EXIT_OUR_FAULT;
    }
    return code;
}
