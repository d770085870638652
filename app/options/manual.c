#include "options/manual.h"

#include <string.h>

#include "options/option.h"

/* When the manual last changed beyond the tables. */
#define MANUAL_DATE "2026-11-24"

static const char before[] = ".SH DESCRIPTION\n"
                             "Does a wheelchair user reach an exit of a house, how long does it take, where is the "
                             "danger, and what would change "
                             "it?\n"
                             ".B clearance\n"
                             "simulates houses with people in and without wheelchairs, up to thousands in an "
                             "underground street, and, as a second "
                             "laboratory, a beam that rattles in its clearance.\n"
                             "Without a verb it opens its window, with the file if one is given.\n"
                             ".PP\n"
                             "Options stand after the files of a verb, in any order, as\n"
                             ".BI \\-\\-name \" VALUE\"\n"
                             "or\n"
                             ".BI \\-\\-name= VALUE\\fR.\n"
                             ".B clearance help\n"
                             "explains topics at length: the house file, editing, studies, films, reports, models.\n";

static const char after[] =
    ".SH FILES\n"
    "Houses, beams, profiles, furniture and help are looked for in the first of these directories that has a "
    "subdirectory\n"
    ".I profiles\n"
    "(and\n"
    ".IR CLEARANCE_ASSETS ,\n"
    "if set, alone):\n"
    ".TP\n"
    ".I ../share/clearance\n"
    "beside the directory of the program, so that an installed tree can be moved\n"
    ".TP\n"
    ".I $XDG_DATA_HOME/clearance\n"
    "by default\n"
    ".I ~/.local/share/clearance\n"
    ".TP\n"
    ".I clearance\n"
    "in each of\n"
    ".IR $XDG_DATA_DIRS .\n"
    ".PP\n"
    "A profile beside the house file comes before all others.\n"
    ".PP\n"
    "Profiles of a person or a site lie in\n"
    ".I clearance/profiles\n"
    "of\n"
    ".I $XDG_DATA_HOME\n"
    "and of each of\n"
    ".IR $XDG_DATA_DIRS ,\n"
    "houses and beams likewise in\n"
    ".I houses\n"
    "and\n"
    ".IR beams .\n"
    "They stand beside the shipped ones, which win where names are equal.\n"
    ".SH ENVIRONMENT\n"
    ".TP\n"
    ".B CLEARANCE_ASSETS\n"
    "the directory of houses, beams, profiles, furniture and help\n"
    ".TP\n"
    ".BR XDG_DATA_HOME \", \" XDG_DATA_DIRS\n"
    "where these are looked for, see above\n"
    ".TP\n"
    ".BR XDG_CONFIG_HOME \", \" XDG_STATE_HOME\n"
    "where the window keeps its settings and unsaved edits\n"
    ".TP\n"
    ".B CLEARANCE_PROGRESS\n"
    "print progress, also where standard error is no terminal\n"
    ".SH EXIT STATUS\n"
    ".TP\n"
    ".B 0\n"
    "The answer is yes: all people are out, or the motion of the beam is known; of a shard: all its runs are done.\n"
    ".TP\n"
    ".B 1\n"
    "The answer is no, or the work was interrupted: then the answer of\n"
    ".B \\-\\-json\n"
    "holds \\(dqinterrupted\\(dq: true.\n"
    ".TP\n"
    ".B 2\n"
    "Wrong use or bad input, with one line of explanation per error on standard error.\n"
    ".TP\n"
    ".B 3\n"
    "An error of the program itself.\n";

static const char last[] = ".SH SEE ALSO\n"
                           ".BR ffmpeg (1),\n"
                           "which makes films, and\n"
                           ".BR sbatch (1)\n"
                           "and\n"
                           ".BR parallel (1),\n"
                           "which run the shards of a study.\n";

/* Adds text so that it is printed as it is: a hyphen is a minus, and nothing is a request. */
static void add_plain(Text *text, const char *words) {
    if (*words == '.' || *words == '\'')
        text_add(text, "\\&");
    for (const char *at = words; *at; at++)
        if (*at == '-')
            text_add(text, "\\-");
        else if (*at == '\\')
            text_add(text, "\\e");
        else
            text_format(text, "%c", *at);
}

static void add_option(Text *text, const Option *option) {
    text_add(text, ".TP\n\\fB");
    add_plain(text, option->name);
    text_add(text, "\\fR");
    if (option->argument) {
        text_add(text, option->kind == OPTION_MAYBE ? " [\\fI" : " \\fI");
        add_plain(text, option->argument);
        text_add(text, option->kind == OPTION_MAYBE ? "\\fR]" : "\\fR");
    }
    text_add(text, "\n");
    add_plain(text, option->help);
    text_add(text, "\n");
}

static void add_verb(Text *text, VerbId verb) {
    const Verb *row = &verb_rows[verb];
    text_format(text, ".SS clearance %s ", row->name);
    add_plain(text, row->usage);
    text_add(text, "\n");
    add_plain(text, row->meaning);
    text_add(text, "\n");
    for (OptionGroup group = 0; group < OPTION_GROUPS; group++)
        for (size_t o = 0; o < option_count; o++)
            if (option_rows[o].group == group && option_rows[o].verbs >> verb & 1)
                add_option(text, &option_rows[o]);
}

/* Adds the lines, each as it is. */
static void add_lines(Text *text, const char *lines) {
    for (const char *at = lines; *at;) {
        size_t length = strcspn(at, "\n");
        Text line = {0};
        text_format(&line, "%.*s", (int)length, at);
        add_plain(text, line.text);
        text_add(text, "\n");
        memory_free(line.text);
        at += length + (at[length] == '\n');
    }
}

void manual_add(Text *text) {
    text_add(text, ".TH CLEARANCE 1 " MANUAL_DATE " \"clearance " CLEARANCE_VERSION "\" \"User Commands\"\n"
                   ".SH NAME\n"
                   "clearance \\- evacuation of wheelchair users, and beams that rattle\n"
                   ".SH SYNOPSIS\n");
    for (VerbId verb = 0; verb < VERBS; verb++) {
        const char *names[OPTIONS_MOST];
        text_format(text, "%s.B clearance %s\n\\fI", verb ? ".br\n" : "", verb_rows[verb].name);
        add_plain(text, verb_rows[verb].usage);
        text_add(text, option_names(verb, names) ? "\\fR [options]\n" : "\\fR\n");
    }
    text_add(text, before);
    text_add(text, ".SH VERBS\n");
    for (VerbId verb = 0; verb < VERBS; verb++)
        add_verb(text, verb);
    text_add(text, after);
    text_add(text, ".SH EXAMPLES\n");
    for (VerbId verb = 0; verb < VERBS; verb++) {
        text_format(text, "%s.EX\n", verb ? ".PP\n" : "");
        add_lines(text, verb_rows[verb].examples);
        text_add(text, ".EE\n");
    }
    text_add(text, last);
}
