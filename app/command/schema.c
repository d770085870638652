#include <stdio.h>
#include <string.h>

#include "beam/beam.h"
#include "command/answer.h"
#include "command/command.h"
#include "command/house_file.h"
#include "crank/crank.h"
#include "lesson/lesson.h"
#include "options/completion.h"
#include "options/manual.h"
#include "plan/plan.h"
#include "plan/plan_names.h"
#include "plan/profile.h"
#include "rules/rule_set.h"

static int print(Text *text) {
    fputs(text->text, stdout);
    memory_free(text->text);
    return EXIT_ANSWERED;
}

static int print_manual(void) {
    Text text = {0};
    manual_add(&text);
    return print(&text);
}

static int print_completion(const char *shell) {
    Text text = {0};
    if (completion_add(&text, shell))
        return print(&text);
    fprintf(stderr, "clearance: there is completion for the shells bash, zsh and fish, not for \"%s\"\n", shell);
    return EXIT_WRONG_INPUT;
}

/* Prints the names of a file's parameters. The profiles of a house are not read. */
static int print_names(const char *path) {
    Text text = {0};
    Fault fault = {0};
    if (beam_is_file(path) || crank_is_file(path)) {
        const ParameterTable *table = beam_is_file(path) ? beam_table() : crank_table();
        for (size_t r = 0; r < table->count; r++)
            text_format(&text, "%s\t%s\n", table->rows[r].name, table->rows[r].meaning);
        return print(&text);
    }
    Plan plan = {0};
    if (!plan_read(&plan, path, NULL, 0, &fault))
        return house_file_report(&fault);
    plan_names_add(&text, &plan);
    plan_free(&plan);
    return print(&text);
}

static int print_schema(const char *kind) {
    if (strcmp(kind, "house") == 0) {
        answer_print(plan_schema());
    } else if (strcmp(kind, "profile") == 0) {
        answer_print(profile_schema());
    } else if (strcmp(kind, "beam") == 0) {
        answer_print(beam_schema());
    } else if (strcmp(kind, "crank") == 0) {
        answer_print(crank_schema());
    } else if (strcmp(kind, "rules") == 0) {
        answer_print(rule_set_schema());
    } else if (strcmp(kind, "lesson") == 0) {
        answer_print(lesson_schema());
    } else {
        fprintf(stderr,
                "clearance: schema prints house, profile, beam, crank, rules, lesson, man, completion SHELL and names "
                "FILE, not "
                "\"%s\"\n",
                kind);
        return EXIT_WRONG_INPUT;
    }
    return EXIT_ANSWERED;
}

int command_schema(const Options *options) {
    const char *kind = options->files[0], *of = options->file_count > 1 ? options->files[1] : NULL;
    bool needs = strcmp(kind, "completion") == 0 || strcmp(kind, "names") == 0;
    if (needs != (of != NULL)) {
        fprintf(stderr, needs ? "clearance: schema %s needs %s\n" : "clearance: schema %s takes no other word\n", kind,
                strcmp(kind, "names") == 0 ? "the FILE of a house, beam or crank" : "a shell: " COMPLETION_SHELLS);
        return EXIT_WRONG_INPUT;
    }
    if (!needs)
        return strcmp(kind, "man") == 0 ? print_manual() : print_schema(kind);
    return strcmp(kind, "names") == 0 ? print_names(of) : print_completion(of);
}
