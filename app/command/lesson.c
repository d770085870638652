/* Lessons: lists them, gives one in the window, tries their goals by their scripts, prints sheets. */

#include <dirent.h>
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/text.h"
#include "command/command.h"
#include "command/house_file.h"
#include "command/output.h"
#include "command/progress.h"
#include "command/report_files.h"
#include "document/pdf.h"
#include "laboratory/shipped.h"
#include "lesson/attempt.h"
#include "teaching/lesson_sheet.h"
#include "teaching/trial.h"

enum { LESSONS_MOST = 256 };

typedef struct Paths {
    const char *at[LESSONS_MOST]; /* (count) */
    size_t count;
    Arena arena;
} Paths;

static int is_lesson(const struct dirent *entry) {
    size_t length = strlen(entry->d_name);
    return *entry->d_name != '.' && length > 5 && strcmp(entry->d_name + length - 5, ".json") == 0;
}

/* Adds all shipped lessons, sorted by name. */
static void add_shipped(Paths *paths) {
    struct dirent **entries;
    int count = scandir(shipped_places()->lessons, &entries, is_lesson, alphasort);
    for (int i = 0; i < count; i++) {
        if (paths->count < LESSONS_MOST)
            paths->at[paths->count++] =
                text_in_arena(&paths->arena, "%s/%s", shipped_places()->lessons, entries[i]->d_name);
        free(entries[i]);
    }
    if (count >= 0)
        free(entries);
}

/* Adds a file, or a shipped lesson by its name. */
static void add_named(Paths *paths, const char *name) {
    if (paths->count == LESSONS_MOST)
        return;
    const char *shipped = text_in_arena(&paths->arena, "%s/%s.json", shipped_places()->lessons, name);
    paths->at[paths->count++] = strchr(name, '/') || access(shipped, R_OK) != 0 ? name : shipped;
}

static Making making_of(const Options *options) {
    return report_files_making(options, "");
}

static AttemptState state_of(const Options *options) {
    return (AttemptState){.profiles = shipped_places()->profiles, .jobs = options->jobs, .stop = &progress_stop};
}

/* Returns the file's name without folder and ending, in the arena. */
static const char *name_of(const char *path, Arena *arena) {
    const char *slash = strrchr(path, '/'), *name = slash ? slash + 1 : path;
    size_t length = strlen(name);
    bool ends = length > 5 && strcmp(name + length - 5, ".json") == 0;
    return text_in_arena(arena, "%.*s", (int)(ends ? length - 5 : length), name);
}

static int tell_interrupted(void) {
    fprintf(stderr, "clearance: interrupted\n");
    return EXIT_ANSWER_NO;
}

/* Verbs ------------------------------------------------------------------------------------------------------------ */

static int list(const Lesson *lesson, const Options *options, Arena *arena) {
    static const char *const laboratories[] = {"house", "beam", "crank"};
    (void)options;
    printf("%-22s %-6s %3d min  %-22s %s\n", name_of(lesson->path, arena), laboratories[lesson->laboratory],
           lesson->minutes, lesson->level, lesson->title);
    return EXIT_ANSWERED;
}

static int check(Lesson *lesson, const Options *options, Arena *arena) {
    Play play = {.lesson = *lesson};
    Fault fault = {0};
    AttemptState state = state_of(options);
    TrialOptions trial = {.profiles = state.profiles, .jobs = state.jobs, .stop = state.stop};
    TrialResult result = {.task_count = 0};
    play.numbered = attempt_numbers(&play.lesson, &state, &fault);
    if (play.numbered)
        trial_check_numbers(&play.lesson, &fault);
    if (play.numbered)
        result = trial_run(&play, &trial, &fault);
    if (!fault.total && (!play.numbered || result.interrupted))
        return tell_interrupted();
    if (fault.total) {
        house_file_report(&fault);
        return EXIT_ANSWER_NO;
    }
    printf("%s: %zu steps, %zu expectations of its script are met\n", name_of(lesson->path, arena), lesson->step_count,
           result.expected);
    for (size_t t = 0; t < result.task_count; t++)
        printf("    the goal of step %zu: not reached in %zu, reached in %zu\n", result.tasks[t].step + 1,
               result.tasks[t].no, result.tasks[t].yes);
    fflush(stdout); /* all lessons take minutes */
    return EXIT_ANSWERED;
}

static int sheet(Lesson *lesson, const Options *options, Arena *arena) {
    Fault fault = {0};
    AttemptState state = state_of(options);
    if (!output_directory(options->out))
        return EXIT_WRONG_INPUT;
    const char *path = text_in_arena(arena, "%s/%s%s.pdf", options->out, name_of(lesson->path, arena),
                                     options->answers ? "-answers" : "");
    struct stat status;
    if (stat(path, &status) == 0 && S_ISDIR(status.st_mode)) { /* said before minutes of work */
        output_failed(path, EISDIR);
        return EXIT_WRONG_INPUT;
    }
    if (!attempt_numbers(lesson, &state, &fault) && !fault.total)
        return tell_interrupted();
    Making making = making_of(options);
    SheetOptions made = {
        .answers = options->answers, .program = making.program, .profiles = state.profiles, .jobs = options->jobs};
    Document printed = lesson_sheet_make(lesson, &made, &fault);
    int error = fault.total ? 0 : pdf_write(&printed, path, 0);
    document_clear(&printed);
    if (fault.total)
        return house_file_report(&fault);
    if (error)
        output_failed(path, error);
    else
        printf("%s\n", path);
    return error ? EXIT_WRONG_INPUT : EXIT_ANSWERED;
}

/* Opens the window with a lesson. */
static int play(const Options *options) {
    Paths paths = {.count = 0};
    if (options->file_count != 2) {
        fprintf(stderr, "clearance: lesson play needs the NAME or FILE of one lesson\n");
        return EXIT_WRONG_INPUT;
    }
    add_named(&paths, options->files[1]);
    Options opened = *options;
    opened.files = paths.at;
    opened.file_count = 1;
    int code = command_open(&opened);
    arena_clear(&paths.arena);
    return code;
}

int command_lesson(const Options *options) {
    static const struct {
        const char *word;
        int (*act)(Lesson *lesson, const Options *options, Arena *arena);
    } acts[] = {{"check", check}, {"sheet", sheet}};
    const char *word = options->files[0];
    Paths paths = {.count = 0};
    bool lists = strcmp(word, "list") == 0, sheets = strcmp(word, "sheet") == 0;
    if (strcmp(word, "play") == 0)
        return play(options);
    if (!lists && !sheets && strcmp(word, "check") != 0) {
        static const char *const words[] = {"list", "play", "check", "sheet"};
        return options_complain("lesson must be followed by list, play, check or sheet, not", word, words, 4);
    }
    if (sheets && (!options->out || options->file_count < 2)) {
        fprintf(stderr, "clearance: lesson sheet needs the NAME or FILE of a lesson and --out DIR\n");
        return EXIT_WRONG_INPUT;
    }
    for (size_t f = 1; f < options->file_count; f++)
        add_named(&paths, options->files[f]);
    if (options->file_count < 2)
        add_shipped(&paths);
    int code = EXIT_ANSWERED;
    for (size_t i = 0; i < paths.count && !progress_interrupted(); i++) {
        Lesson lesson = {.path = NULL};
        Fault fault = {0};
        int one = lesson_read(&lesson, paths.at[i], &fault) ? (lists ? list(&lesson, options, &paths.arena)
                                                                     : acts[sheets].act(&lesson, options, &paths.arena))
                                                            : house_file_report(&fault);
        code = one > code ? one : code;
        lesson_free(&lesson);
    }
    arena_clear(&paths.arena);
    return code;
}
