#include "command/command.h"

#include <errno.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/memory.h"
#include "base/parallel.h"
#include "base/text.h"
#include "command/option.h"
#include "command/progress.h"

/* Verbs ----------------------------------------------------------------------------------------------------------- */

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
     "  clearance check houses/flat-0.910-module.json --set door.d1.width=0.90 --json\n"
     "  clearance check houses/flat-0.910-module.json --suggest\n",
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
     "  clearance study houses/ube-techno-house.json --runs 100 --spread profile.manual-chair.free_speed=0.1\n"
     "  clearance study houses/ube-techno-house.json --shake 100 --report --out out\n",
     command_study},
    {"loci", FOR_LOCI, 1, SIZE_MAX, "HOUSE ...",
     "drive each house both ways, miura and driver: times, and how far apart the loci are",
     "  clearance loci houses/corner-*.json\n", command_loci},
    {"cases", FOR_CASES, 1, SIZE_MAX, "DIR|FILE ...", "run public verification tests: what passed, and if not, why",
     "  clearance cases tests/cases --out out\n"
     "  clearance cases tests/cases/rimea-01.json\n",
     command_cases},
    {"import", FOR_IMPORT, 2, 2, "FILE HOUSE",
     "make a house of another program's file: Sweet Home 3D (.sh3d), a drawing (.dxf), a walkable area (.wkt), a "
     "Vadere "
     ".scenario",
     "  clearance import flat.sh3d flat.json\n"
     "  clearance import flat.dxf flat.json --layers walls=A-WALL,doors=A-DOOR --unit mm\n",
     command_import},
    {"export", FOR_EXPORT, 1, 1, "HOUSE", "give a house to other programs: its walkable area, or a picture of its plan",
     "  clearance export houses/ube-techno-house.json --to wkt --out ube.wkt\n", command_export},
    {"schema", FOR_SCHEMA, 1, 1, "house|profile|beam", "print the JSON Schema of a kind of file, for editors",
     "  clearance schema house > house.schema.json\n", command_schema},
};
enum { VERBS = sizeof verbs / sizeof *verbs };

enum { NAME_WIDTH = 10, ARGUMENT_WIDTH = 22 /* characters: what is longer has a line of its own */ };

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
    for (size_t o = 0; o < option_count; o++) {
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
    for (size_t o = 0; o < option_count; o++)
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
        const char *known[OPTIONS_MOST];
        size_t count = 0;
        for (size_t o = 0; o < option_count; o++)
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
    options.settings = memory_zeroed((size_t)argc, sizeof *options.settings);
    options.files = memory_zeroed((size_t)argc, sizeof *options.files);
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

/* A word that is no verb and looks like a file. */
static bool is_file(const char *word) {
    size_t length = strlen(word);
    return strchr(word, '/') || (length > 5 && strcmp(word + length - 5, ".json") == 0) || access(word, F_OK) == 0;
}

static int dispatch(int argc, char **argv) {
    progress_catch_signals();
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
