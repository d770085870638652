#include "command/command.h"

#include <errno.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "base/file_write.h"
#include "base/json.h"
#include "base/text.h"
#include "command/answer.h"
#include "command/licences.h"
#include "command/progress.h"
#include "platform/terminal.h"
#include "mechanics/broadphase.h"
#include "options/help.h"

static int (*const acts[VERBS])(const Options *options) = {
    [VERB_OPEN] = command_open,       [VERB_RUN] = command_run,       [VERB_CHECK] = command_check,
    [VERB_COMPARE] = command_compare, [VERB_STUDY] = command_study,   [VERB_LOCI] = command_loci,
    [VERB_ABLATE] = command_ablate,   [VERB_FIT] = command_fit,       [VERB_RULES] = command_rules,
    [VERB_CASES] = command_cases,     [VERB_IMPORT] = command_import, [VERB_EXPORT] = command_export,
    [VERB_SCHEMA] = command_schema,   [VERB_HELP] = command_help,     [VERB_LESSON] = command_lesson,
};

static void print(Text *text) {
    fputs(text->text, stdout);
    memory_free(text->text);
}

/* Says that a file could not be read before the interruption, which is not an error of the input. */
static int tell_unread(VerbId verb, const Options *options) {
    static const char *const kinds[VERBS] = {
        /* NULL: the kind of the answer depends on the file */
        [VERB_CHECK] = "check", [VERB_COMPARE] = "compare", [VERB_LOCI] = "loci",   [VERB_ABLATE] = "ablate",
        [VERB_FIT] = "fit",     [VERB_RULES] = "rules",     [VERB_CASES] = "cases", [VERB_IMPORT] = "import"};
    if (options->json) {
        json_t *answer = json_object();
        if (kinds[verb])
            json_object_set_new(answer, "kind", json_string(kinds[verb]));
        answer_mark_interrupted(answer, true);
        answer_print(answer);
    }
    return EXIT_ANSWER_NO;
}

/* Runs a verb whose own words begin at argv[first]. */
static int run_verb(VerbId verb, int argc, char **argv, int first) {
    Options options;
    options_begin(&options, argc, argv);
    int code = options_read(&options, verb, first);
    if (options.help) {
        Text text = {0};
        help_add_verb(&text, verb);
        print(&text);
    } else if (!code) {
        code = acts[verb](&options);
        if (code == EXIT_WRONG_INPUT && text_read_interrupted())
            code = tell_unread(verb, &options);
    }
    options_end(&options);
    return code;
}

/* True if a word that is not a verb looks like a file. */
static bool is_file(const char *word) {
    size_t length = strlen(word);
    return strchr(word, '/') || (length > 5 && strcmp(word + length - 5, ".json") == 0) || access(word, F_OK) == 0;
}

static int dispatch(int argc, char **argv) {
    progress_catch_signals();
    signal(SIGXFSZ, SIG_IGN); /* a file that grows too large is reported like any other that cannot be written */
    const char *word = argc < 2 ? "open" : argv[1];
    if (strcmp(word, "--help") == 0 || strcmp(word, "-h") == 0) {
        Text text = {0};
        help_add(&text);
        print(&text);
        return EXIT_ANSWERED;
    }
    if (strcmp(word, "--version") == 0)
        return licences_answer(argc, argv, 2);
    const Verb *verb = verb_find(word);
    if (verb)
        return run_verb((VerbId)(verb - verb_rows), argc, argv, 2);
    if (*word == '-' || is_file(word))
        return run_verb(VERB_OPEN, argc, argv, 1);
    const char *names[VERBS];
    for (size_t v = 0; v < VERBS; v++)
        names[v] = verb_rows[v].name;
    return options_complain("unknown verb", word, names, VERBS);
}

int command_main(int argc, char **argv) {
    json_use_memory();
    broadphase_use_memory();
    terminal_show_all_characters();
    int code = dispatch(argc, argv);
    if (fflush(stdout) || ferror(stdout)) {
        fprintf(stderr, "clearance: the answer cannot be written: %s\n",
                file_write_reason(terminal_error() ? terminal_error() : EIO));
        return EXIT_OUR_FAULT;
    }
    return code;
}
