#include "options/help.h"

#include <stdio.h>
#include <string.h>

#include "options/option.h"

enum { VERB_COLUMN = 28, OPTION_COLUMN = 30 /* where meanings begin */ };

/* Characters of UTF-8 text; all that is printed here is one column wide. */
static size_t columns_of(const char *words, size_t bytes) {
    size_t columns = 0;
    for (size_t i = 0; i < bytes; i++)
        columns += ((unsigned char)words[i] & 0xc0) != 0x80;
    return columns;
}

void help_add_wrapped(Text *text, const char *words, size_t column) {
    size_t at = column;
    while (*words) {
        size_t bytes = strcspn(words, " "), wide = columns_of(words, bytes);
        if (at > column && at + 1 + wide > HELP_COLUMNS) {
            text_format(text, "\n%*s", (int)column, "");
            at = column;
        } else if (at > column) {
            text_add(text, " ");
            at++;
        }
        text_format(text, "%.*s", (int)bytes, words);
        at += wide;
        words += bytes + strspn(words + bytes, " ");
    }
    text_add(text, "\n");
}

/* Adds a term, and its meaning at `column`: on a line of its own if the term is too long. */
static void add_row(Text *text, const char *term, size_t column, const char *meaning) {
    text_format(text, "  %s", term);
    size_t used = 2 + columns_of(term, strlen(term));
    if (used + 2 > column)
        text_format(text, "\n%*s", (int)column, "");
    else
        text_format(text, "%*s", (int)(column - used), "");
    help_add_wrapped(text, meaning, column);
}

/* Adds lines, each indented. */
static void add_examples(Text *text, const char *lines) {
    for (const char *at = lines; *at;) {
        size_t length = strcspn(at, "\n");
        text_format(text, "  %.*s\n", (int)length, at);
        at += length + (at[length] == '\n');
    }
}

void help_add(Text *text) {
    text_add(text, "clearance " CLEARANCE_VERSION
                   ": does a wheelchair user reach an exit, how long does it take, where is the danger?\n"
                   "And a beam that rattles in its clearance: is its motion periodic or chaotic?\n\n"
                   "Verbs:\n");
    for (size_t v = 0; v < VERBS; v++) {
        char term[80];
        snprintf(term, sizeof term, "%s %s", verb_rows[v].name, verb_rows[v].usage);
        add_row(text, term, VERB_COLUMN, verb_rows[v].meaning);
    }
    text_add(text, "\nExamples:\n");
    for (size_t v = 0; v < VERBS; v++) {
        const char *examples = verb_rows[v].examples;
        text_format(text, "  %.*s\n", (int)strcspn(examples, "\n"), examples);
    }
    text_add(text, "\n`clearance VERB --help` lists the options of a verb, `clearance help options` all options.\n"
                   "`clearance help` lists the topics that are explained at length.\n"
                   "`clearance --version --licences` lists the libraries in the program and their licences.\n\n"
                   "Exit codes:\n");
    add_row(text, "0", 5, "the answer is yes: all people are out, or the motion of the beam is known");
    add_row(text, "1", 5,
            "the answer is no, or the work was interrupted; the answer of `--json` then holds \"interrupted\": true");
    add_row(text, "2", 5, "wrong use or bad input, with one line of explanation per error on standard error");
    add_row(text, "3", 5, "an error of the program itself");
}

/* "--seed N" */
static void term_of(const Option *option, char *term, size_t size) {
    snprintf(term, size, "%s%s%s", option->name, option->argument ? " " : "", option->argument ? option->argument : "");
}

/* Adds the options of a group that any of the verbs (FOR_...) takes, under its heading. */
static void add_group(Text *text, OptionGroup group, int verbs, bool with_verbs) {
    bool any = false;
    for (size_t o = 0; o < option_count; o++) {
        const Option *option = &option_rows[o];
        if (option->group != group || !(option->verbs & verbs))
            continue;
        if (!any)
            text_format(text, "\n%s:\n", option_group_name(group));
        any = true;
        char term[160];
        term_of(option, term, sizeof term);
        Text meaning = {0};
        text_add(&meaning, option->help);
        const char *before = " [";
        for (size_t v = 0; v < VERBS && with_verbs; v++)
            if (option->verbs >> v & 1) {
                text_format(&meaning, "%s%s", before, verb_rows[v].name);
                before = ", ";
            }
        text_add(&meaning, with_verbs ? "]" : "");
        add_row(text, term, OPTION_COLUMN, meaning.text);
        memory_free(meaning.text);
    }
}

void help_add_verb(Text *text, VerbId verb) {
    const Verb *row = &verb_rows[verb];
    const char *names[OPTIONS_MOST];
    bool any = option_names(verb, names) > 0;
    text_format(text, "Usage: clearance %s %s%s\n\n", row->name, row->usage, any ? " [options]" : "");
    help_add_wrapped(text, row->meaning, 0);
    text_add(text, "\nExamples:\n");
    add_examples(text, row->examples);
    for (OptionGroup group = 0; group < OPTION_GROUPS; group++)
        add_group(text, group, 1 << verb, false);
}

void help_add_options(Text *text) {
    text_add(text, "Options: all options of all verbs.\n\n");
    help_add_wrapped(
        text,
        "Options stand after the files of a verb, in any order, as --name VALUE or --name=VALUE. The verbs "
        "that take an option are listed in brackets.",
        0);
    for (OptionGroup group = 0; group < OPTION_GROUPS; group++)
        add_group(text, group, ~0, true);
}
