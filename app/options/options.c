#include "options/options.h"

#include <ctype.h>
#include <inttypes.h>
#include <stdio.h>
#include <string.h>

#include "base/parallel.h"
#include "base/text.h"
#include "cycle/survival.h"
#include "options/option.h"

void options_begin(Options *options, int argc, char **argv) {
    *options = (Options){.seed = 1,
                         .driving = -1,
                         .jobs = parallel_processors(),
                         .lanes = SURVIVAL_USUAL,
                         .width = 1280,
                         .height = 720,
                         .from = -1,
                         .to = -1,
                         .camera = {.azimuth = VIEW_AZIMUTH, .elevation = VIEW_ELEVATION, .zoom = 1},
                         .arguments = argv,
                         .argument_count = argc};
    options->settings = memory_zeroed((size_t)argc, sizeof *options->settings);
    options->files = memory_zeroed((size_t)argc, sizeof *options->files);
}

void options_end(Options *options) {
    memory_free(options->settings);
    memory_free(options->files);
    arena_clear(&options->arena);
}

bool options_given(const Options *options, const char *name) {
    for (size_t o = 0; o < option_count; o++)
        if (options->given[o] && strcmp(option_rows[o].name, name) == 0)
            return true;
    return false;
}

int options_complain(const char *what, const char *word, const char *const *known, size_t count) {
    const char *nearest = count ? text_nearest(word, known, count) : NULL;
    if (nearest)
        fprintf(stderr, "clearance: %s \"%s\", did you mean %s?\n", what, word, nearest);
    else
        fprintf(stderr, "clearance: %s \"%s\", see clearance --help\n", what, word);
    return EXIT_WRONG_INPUT;
}

/* Returns the values that an option takes: "N from 1 to 1024", "driver|miura". */
static const char *expected(const Option *option, Arena *arena) {
    if (option->high <= option->low || option->words)
        return option->argument;
    if (option->high >= (double)INT64_MAX) /* which a double rounds up */
        return text_in_arena(arena, "%s from %g to %" PRId64, option->argument, option->low, INT64_MAX);
    return text_in_arena(arena, "%s from %g to %.10g", option->argument, option->low, option->high);
}

/* Says why the value, which may be NULL, is not one of the option. */
static int complain_of_value(const Option *option, Options *options, const char *value) {
    const char *words[OPTION_WORDS];
    size_t count =
        value && option->words && option->kind != OPTION_FILE ? option_words(option, words, &options->arena) : 0;
    const char *nearest = count ? text_nearest(value, words, count) : NULL;
    if (!option->argument)
        fprintf(stderr, "clearance: %s takes no value, not \"%s\": %s\n", option->name, value, option->help);
    else if (!value)
        fprintf(stderr, "clearance: %s takes %s: %s\n", option->name, expected(option, &options->arena), option->help);
    else if (nearest)
        fprintf(stderr, "clearance: %s takes %s, not \"%s\", did you mean %s?\n", option->name,
                expected(option, &options->arena), value, nearest);
    else
        fprintf(stderr, "clearance: %s takes %s, not \"%s\": %s\n", option->name, expected(option, &options->arena),
                value, option->help);
    return EXIT_WRONG_INPUT;
}

/* Reads the option at arguments[*at], as --name value or --name=value. */
static int read_option(Options *options, VerbId verb, int *at) {
    const char *word = options->arguments[*at], *equals = strchr(word, '=');
    size_t length = equals ? (size_t)(equals - word) : strlen(word);
    const Option *option = option_find(verb, word, length);
    if (!option) {
        const char *known[OPTIONS_MOST], *name = text_in_arena(&options->arena, "%.*s", (int)length, word);
        return options_complain("unknown option", name, known, option_names(verb, known));
    }
    const char *value = equals ? equals + 1 : NULL;
    const char *next = *at + 1 < options->argument_count ? options->arguments[*at + 1] : NULL;
    bool follows = next && (option->kind != OPTION_MAYBE || isdigit((unsigned char)*next));
    if (option->argument && !value && follows)
        value = options->arguments[++*at];
    return option_take(option, options, value) ? 0 : complain_of_value(option, options, value);
}

int options_read(Options *options, VerbId verb, int first) {
    const Verb *row = &verb_rows[verb];
    int code = 0;
    for (int i = first; i < options->argument_count && !code && !options->help; i++) {
        const char *word = options->arguments[i];
        if (strcmp(word, "--help") == 0 || strcmp(word, "-h") == 0)
            options->help = true;
        else if (word[0] == '-' && word[1])
            code = read_option(options, verb, &i);
        else if (options->file_count < row->most_files)
            options->files[options->file_count++] = word;
        else
            code = options_complain("one argument too many:", word, NULL, 0);
    }
    if (!code && !options->help && options->file_count < row->least_files) {
        fprintf(stderr, "clearance: usage: clearance %s %s [options]\n", row->name, row->usage);
        code = EXIT_WRONG_INPUT;
    }
    return code;
}
