/* Runs public verification suites from files, one case each, and makes one table of all results. */

#include <dirent.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>

#include "base/file_write.h"
#include "base/memory.h"
#include "base/text.h"
#include "command/answer.h"
#include "command/cases_html.h"
#include "result/cases_text.h"
#include "command/command.h"
#include "command/house_file.h"
#include "command/output.h"
#include "command/progress.h"
#include "platform/terminal.h"
#include "inquiry/case_run.h"
#include "laboratory/shipped.h"

/* Case files --------------------------------------------------------------------------------------------------------*/

typedef struct Paths {
    char **at; /* (count) */
    size_t count, capacity;
} Paths;

static void add_path(Paths *paths, const char *directory, const char *name) {
    size_t size = strlen(directory) + strlen(name) + 2;
    char *path = memory_zeroed(size, 1);
    snprintf(path, size, "%s%s%s", directory, *directory ? "/" : "", name);
    paths->at = memory_reserve(paths->at, &paths->capacity, paths->count + 1, sizeof *paths->at);
    paths->at[paths->count++] = path;
}

static int is_case_file(const struct dirent *entry) {
    size_t length = strlen(entry->d_name);
    return *entry->d_name != '.' && length > 5 && strcmp(entry->d_name + length - 5, ".json") == 0;
}

/* Adds a file, or the .json files of a directory sorted by name. */
static void find_files(Paths *paths, const char *file, Fault *fault) {
    struct stat status;
    if (stat(file, &status) != 0 || !S_ISDIR(status.st_mode)) {
        add_path(paths, "", file);
        return;
    }
    struct dirent **entries;
    int count = scandir(file, &entries, is_case_file, alphasort);
    if (count <= 0)
        fault_add(fault, "%s:1:1: %s", file, count < 0 ? "cannot be read" : "the directory holds no .json files");
    for (int i = 0; i < count; i++) {
        add_path(paths, file, entries[i]->d_name);
        free(entries[i]);
    }
    if (count >= 0)
        free(entries);
}

static Verification *read_cases(const Paths *paths, Fault *fault) {
    Verification *cases = memory_zeroed(paths->count, sizeof *cases);
    for (size_t i = 0; i < paths->count; i++) {
        size_t before = fault->total;
        verification_read(&cases[i], paths->at[i], fault);
        for (size_t k = 0; k < i && fault->total == before; k++)
            if (cases[k].id && strcmp(cases[k].id, cases[i].id) == 0)
                fault_add(fault, "%s:1:1: the id \"%s\" is already used by %s; ids must be unique", paths->at[i],
                          cases[i].id, paths->at[k]);
    }
    return cases;
}

/* Running -----------------------------------------------------------------------------------------------------------*/

typedef struct Progress {
    time_t begin;
    bool shown;
} Progress;

/* Prints progress once the work has taken more than a second. */
static void show_progress(void *context, size_t done, size_t all) {
    Progress *progress = context;
    if (time(NULL) - progress->begin < 2)
        return;
    terminal_progress("%zu of %zu runs ", done, all);
    progress->shown = true;
}

static void run_cases(Verification *cases, size_t count, const Options *options, Fault *fault) {
    Progress progress = {.begin = time(NULL)};
    bool show = progress_is_shown(options);
    CaseRunOptions trial = {.profiles = shipped_places()->profiles,
                            .seed = options->seed,
                            .jobs = options->jobs,
                            .stop = &progress_stop,
                            .progress = show ? show_progress : NULL,
                            .context = &progress};
    case_run_all(cases, count, &trial, fault);
    if (progress.shown)
        terminal_clear_progress();
}

/* Writing -----------------------------------------------------------------------------------------------------------*/

static json_t *make_answer(const Verification *cases, size_t count, uint64_t seed, bool interrupted) {
    json_t *answer = cases_text_json(cases, count, seed);
    answer_mark_interrupted(answer, interrupted);
    return answer;
}

static void add_json(Text *text, const json_t *answer) {
    char *dump = json_dumps(answer, JSON_INDENT(2) | JSON_REAL_PRECISION(12));
    text_add(text, dump);
    text_add(text, "\n");
    free(dump);
}

static bool write_tables(const Verification *cases, size_t count, const json_t *answer, const Options *options) {
    static const char *const names[] = {"cases.html", "cases.md", "cases.json"};
    char path[OUTPUT_PATH];
    int error = 0;
    for (size_t f = 0; f < sizeof names / sizeof *names && !error; f++) {
        Text text = {0};
        if (f == 0)
            cases_html_add(&text, cases, count, options->seed);
        else if (f == 1)
            cases_text_markdown(&text, cases, count, options->seed);
        else
            add_json(&text, answer);
        snprintf(path, sizeof path, "%s/%s", options->out, names[f]);
        error = file_write_bytes(path, text.text, text.used);
        memory_free(text.text);
    }
    if (error)
        output_failed(path, error);
    return !error;
}

static bool all_passed(const Verification *cases, size_t count) {
    bool all = true;
    for (size_t i = 0; i < count; i++) {
        Verdict verdict = case_run_verdict(&cases[i]);
        all &= verdict == VERDICT_PASSED || verdict == VERDICT_DOES_NOT_APPLY;
    }
    return all;
}

/* True if a check was not run although its house can be read, or could not be read before the interruption. */
static bool is_interrupted(const Verification *cases, size_t count, const Fault *fault) {
    bool missing = false;
    for (size_t i = 0; i < count; i++)
        missing |= case_run_verdict(&cases[i]) == VERDICT_NOT_RUN;
    return missing && (!fault->total || text_read_interrupted());
}

static int give_answer(const Verification *cases, size_t count, const Options *options, Fault *fault) {
    bool interrupted = is_interrupted(cases, count, fault);
    if (interrupted)
        fprintf(stderr, "clearance: interrupted; the results of finished tests are kept\n");
    json_t *answer = make_answer(cases, count, options->seed, interrupted);
    bool written = !options->out || write_tables(cases, count, answer, options);
    if (options->json)
        answer_print(json_incref(answer));
    else
        cases_text_print(cases, count);
    json_decref(answer);
    if (fault->total) {
        int code = house_file_report(fault);
        return interrupted ? EXIT_ANSWER_NO : code;
    }
    if (options->out && written && !options->json)
        printf("\nthe tables are in %s\n", options->out);
    return !written ? EXIT_WRONG_INPUT : all_passed(cases, count) ? EXIT_ANSWERED : EXIT_ANSWER_NO;
}

int command_cases(const Options *options) {
    Fault fault = {0};
    Paths paths = {0};
    for (size_t f = 0; f < options->file_count; f++)
        find_files(&paths, options->files[f], &fault);
    Verification *cases = read_cases(&paths, &fault);
    int code = EXIT_WRONG_INPUT;
    if (fault.total) {
        code = house_file_report(&fault);
    } else if (output_directory(options->out)) {
        run_cases(cases, paths.count, options, &fault);
        code = give_answer(cases, paths.count, options, &fault);
    }
    for (size_t i = 0; i < paths.count; i++) {
        verification_free(&cases[i]);
        memory_free(paths.at[i]);
    }
    memory_free(paths.at);
    memory_free(cases);
    return code;
}
