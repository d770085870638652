#include "platform/export.h"

#include <fcntl.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/memory.h"
#include "check.h"
#include "desk.h"
#include "scratch.h"

static void check_command(const char *const *words, size_t count, const char *expected) {
    char *command = export_command(words, count);
    CHECK_TEXT(command, expected);
    memory_free(command);
}

TEST(a_command_is_quoted_for_a_shell) {
    check_command((const char *[]){"run", "my house.json", "--set", "door.d1.width=0.8"}, 4,
                  "clearance run 'my house.json' --set door.d1.width=0.8");
    check_command((const char *[]){"it's", "", "$HOME", "a;b", "c*", "\xc3\xa4", "~"}, 7,
                  "clearance 'it'\\''s' '' '$HOME' 'a;b' 'c*' '\xc3\xa4' '~'");
    check_command(NULL, 0, "clearance");
}

TEST(a_quoted_command_gives_its_words_again) {
    static const char *const words[] = {"a b",       "it's", "\"x\"", "$(rm)", "back\\slash",
                                        "new\nline", "",     "*",     "-x",    "#"};
    char *command = export_command(words, sizeof words / sizeof *words);
    char line[500], printed[500] = "";
    snprintf(line, sizeof line, "clearance() { printf '<%%s>' \"$@\"; }; %s", command);
    FILE *shell = popen(line, "r");
    CHECK(shell && fread(printed, 1, sizeof printed - 1, shell));
    pclose(shell);
    CHECK_TEXT(printed, "<a b><it's><\"x\"><$(rm)><back\\slash><new\nline><><*><-x><#>");
    memory_free(command);
}

static void check_name(const char *name, const char *expected) {
    char *path = export_free_name("folder", name, (const char *[]){"png", NULL});
    CHECK_TEXT(path, expected);
    memory_free(path);
}

TEST(a_name_is_plain_and_over_nothing) {
    desk_make();
    check_name("plan", "folder/plan");
    check_name("L corridor 0.90-0.90 (before)", "folder/L-corridor-0.90-0.90-before");
    check_name("../../etc/passwd", "folder/etc-passwd");
    check_name("", "folder/picture");
    check_name("...", "folder/picture");
    check_name("\xc3\xbc\xe6\x88\xb8", "folder/\xc3\xbc\xe6\x88\xb8");
    char longest[400] = "";
    for (int i = 0; i < 90; i++)
        strcat(longest, "\xe6\x88\xb8");
    char *path = export_free_name("folder", longest, (const char *[]){"png", NULL});
    CHECK(strlen(path) == strlen("folder/") + 102);
    memory_free(path);
    desk_write("folder/plan.png", "");
    desk_write("folder/plan-2.png", "");
    desk_write("folder/plan-4.png", "");
    check_name("plan", "folder/plan-3");
    desk_write("folder/run/x", "");
    path = export_free_name("folder", "run", (const char *[]){"", "mp4", NULL});
    CHECK_TEXT(path, "folder/run-2");
    memory_free(path);
    desk_remove();
}

static void check_folder(const char *expected) {
    Fault fault = {0};
    char *folder = export_folder(&fault);
    CHECK_TEXT(folder, expected);
    CHECK(access(folder, W_OK) == 0 && fault.count == 0);
    memory_free(folder);
}

TEST(what_is_handed_on_goes_to_out_or_home) {
    desk_make();
    char home[100];
    snprintf(home, sizeof home, "%s", desk_path("clearance"));
    check_folder(home);
    CHECK(mkdir("out", 0777) == 0);
    check_folder("out/clearance");
    CHECK(rmdir("out/clearance") == 0 && rmdir("out") == 0);
    unsetenv("HOME");
    check_folder("clearance");
    setenv("HOME", "/proc", 1);
    check_folder("clearance");
    desk_remove();
}

/* Children --------------------------------------------------------------------------------------------------------- */

static const char *program(void) {
    const char *path = getenv("CLEARANCE_PROGRAM");
    if (!path)
        check_skip("CLEARANCE_PROGRAM does not say where the program is");
    return path;
}

/* Runs the export to its end; counts its progress reports, and returns the largest fraction. */
typedef struct Watched {
    const ExportStatus *status;
    int pictures;
    double part;
} Watched;

static Watched watch(Export *export) {
    Watched watched = {.part = 0};
    for (int i = 0; i < 12000; i++) {
        watched.status = export_update(export);
        if (watched.status->stage != EXPORT_RUNNING)
            break;
        watched.pictures += strncmp(watched.status->doing, "picture ", 8) == 0;
        if (watched.status->part > watched.part)
            watched.part = watched.status->part;
        usleep(5000);
    }
    return watched;
}

static Export *begin(const char *const *words, size_t word_count, const char *const *options, size_t option_count,
                     const char *out) {
    Fault fault = {0};
    Export *export = export_begin(&(ExportOrder){.program = program(),
                                                 .arguments = words,
                                                 .argument_count = word_count,
                                                 .options = options,
                                                 .option_count = option_count,
                                                 .out = out},
                                  &fault);
    CHECK(export && fault.count == 0);
    return export;
}

static bool has_file(const ExportStatus *status, const char *name) {
    for (size_t i = 0; i < status->file_count; i++)
        if (strcmp(status->files[i], name) == 0)
            return true;
    return false;
}

TEST(a_run_is_exported_to_the_end_and_its_files_are_told) {
    desk_make();
    const char *words[] = {"run", scratch_source("houses/straight-corridor.json"), "--seed", "2"};
    const char *options[] = {"--frames", "10", "--size", "320x200"};
    Export *export = begin(words, 4, options, 4, "here/run");
    Watched watched = watch(export);
    CHECK(watched.status->stage == EXPORT_DONE && !watched.status->no);
    CHECK_TEXT(watched.status->reason, "");
    CHECK_NEAR(watched.status->part, 1, 0);
    CHECK(watched.pictures > 0 && watched.part > 0 && watched.part <= 1);
    CHECK_TEXT(watched.status->folder, "here/run");
    CHECK(has_file(watched.status, "summary.json") && has_file(watched.status, "frames/frame-00001.png"));
    CHECK(!has_file(watched.status, "frames") && watched.status->file_count > 20); /* each picture is a file */
    CHECK(access("here/run/frames/frame-00001.png", F_OK) == 0);
    export_end(export);
    desk_remove();
}

TEST(an_answer_that_is_no_is_done_all_the_same) {
    desk_make();
    const char *words[] = {"run", scratch_source("houses/flat-0.910-module.json")};
    Export *export = begin(words, 2, NULL, 0, "run");
    Watched watched = watch(export);
    CHECK(watched.status->stage == EXPORT_DONE && watched.status->no);
    export_end(export);
    desk_remove();
}

TEST(what_fails_says_why_in_its_own_words) {
    desk_make();
    const char *words[] = {"run", "nowhere.json"};
    Export *export = begin(words, 2, NULL, 0, NULL);
    Watched watched = watch(export);
    CHECK(watched.status->stage == EXPORT_FAILED);
    CHECK_TEXT(watched.status->reason, "nowhere.json:1:1: cannot be read: No such file or directory");
    CHECK(isnan(watched.status->part) && watched.status->file_count == 0);
    export_end(export);
    desk_remove();
}

TEST(a_cancelled_export_ends_soon_and_keeps_what_is_whole) {
    desk_make();
    const char *words[] = {"run", scratch_source("houses/ube-techno-house.json")};
    const char *options[] = {"--frames", "1000", "--size", "640x400"};
    Export *export = begin(words, 2, options, 4, "run");
    while (export_update(export)->stage == EXPORT_RUNNING && !strstr(export_update(export)->doing, "picture "))
        usleep(5000);
    CHECK(export_update(export)->stage == EXPORT_RUNNING);
    export_cancel(export);
    export_cancel(export);
    Watched watched = watch(export);
    CHECK(watched.status->stage == EXPORT_CANCELLED);
    CHECK_TEXT(watched.status->reason, "cancelled");
    CHECK(has_file(watched.status, "summary.json"));
    export_end(export);
    export = begin(words, 2, options, 4, "run");
    export_end(export); /* while it runs */
    desk_remove();
}

TEST(a_program_that_is_not_there_is_a_fault) {
    Fault fault = {0};
    const char *words[] = {"run"};
    CHECK(!export_begin(&(ExportOrder){.program = "/nowhere/clearance", .arguments = words, .argument_count = 1},
                        &fault));
    CHECK_TEXT(fault.count ? fault.lines[0] : "", "the program cannot start itself: No such file or directory");
    fault_clear(&fault);
}

TEST(this_program_is_started_where_none_is_named) {
    Fault fault = {0};
    const char *words[] = {"no test is called so"}; /* of this one: it ends with 1 */
    Export *export = export_begin(&(ExportOrder){.arguments = words, .argument_count = 1}, &fault);
    CHECK(export);
    Watched watched = watch(export);
    CHECK(watched.status->stage == EXPORT_DONE && watched.status->no);
    export_end(export);
}
