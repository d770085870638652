/* Tests recovery of unsaved edits: a recovery file is found once its process has ended, and never before. */

#include "base/file_write.h"
#include "platform/recovery.h"

#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/memory.h"
#include "base/text.h"
#include "check.h"
#include "desk.h"

static const RecoveryAbout about = {"/somewhere/flat.json", "L corridor", 23, 1700000000};

/* Ends the process like a crash. */
static void leave_behind(const char *text, const RecoveryAbout *said) {
    pid_t child = fork();
    if (child == 0) {
        Recovery *recovery = recovery_create();
        _exit(!recovery || recovery_write(recovery, text, said) != 0);
    }
    int status;
    waitpid(child, &status, 0);
    CHECK(WIFEXITED(status) && WEXITSTATUS(status) == 0);
}

static void check_file(const char *path, const char *expected) {
    size_t size;
    char *text = text_read_file(path, 1 << 20, &size);
    CHECK(text);
    if (text)
        CHECK_TEXT(text, expected);
    memory_free(text);
}

TEST(what_a_process_that_is_gone_has_left_is_found) {
    desk_make();
    leave_behind("{\"a\": 1}", &about);
    Recovery *recovery = recovery_create();
    size_t count;
    RecoveryFound *found = recovery_find(recovery, &count);
    CHECK(count == 1);
    if (count == 1) {
        CHECK_TEXT(found->origin, "/somewhere/flat.json");
        CHECK_TEXT(found->name, "L corridor");
        CHECK(found->edits == 23 && found->when == 1700000000 && found->origin_when == 0);
        check_file(found->path, "{\"a\": 1}");
    }
    recovery_free_found(found, count);
    recovery_destroy(recovery);
    desk_remove();
}

TEST(what_is_still_edited_is_nobody_elses) {
    desk_make();
    Recovery *recovery = recovery_create();
    CHECK(recovery_write(recovery, "{}", &about) == 0);
    size_t count;
    RecoveryFound *found = recovery_find(recovery, &count);
    CHECK(count == 0);
    recovery_free_found(found, count);
    recovery_remove(recovery);
    CHECK(access(recovery_path(recovery), F_OK) != 0);
    recovery_destroy(recovery);
    desk_remove();
}

TEST(taken_over_it_is_not_found_again) {
    desk_make();
    leave_behind("one", &about);
    leave_behind("two", &(RecoveryAbout){.name = "new house", .edits = 1, .when = 1800000000});
    Recovery *recovery = recovery_create();
    size_t count, left;
    RecoveryFound *found = recovery_find(recovery, &count);
    CHECK(count == 2);
    if (count == 2) {
        CHECK(!found[0].origin && recovery_adopt(recovery, &found[0]));
        check_file(recovery_path(recovery), "two");
        recovery_forget(&found[1]);
    }
    RecoveryFound *rest = recovery_find(recovery, &left);
    CHECK(left == 0);
    recovery_free_found(rest, left);
    recovery_free_found(found, count);
    recovery_destroy(recovery);
    desk_remove();
}

TEST(without_what_is_about_it_the_house_speaks_for_itself) {
    desk_make();
    leave_behind("house", &about);
    Recovery *recovery = recovery_create();
    size_t count;
    RecoveryFound *found = recovery_find(recovery, &count);
    for (int broken = 0; count == 1 && broken < 2; broken++) {
        if (broken)
            CHECK(file_write_bytes(found->about_path, "{\"edits\": -3, \"na", 17) == 0);
        else
            unlink(found->about_path);
        RecoveryFound *now = recovery_find(recovery, &count);
        CHECK(count == 1 && !now->origin && now->edits == 0 && now->when > 0);
        recovery_free_found(now, count);
    }
    recovery_free_found(found, 1);
    recovery_destroy(recovery);
    desk_remove();
}

TEST(without_a_place_to_write_to_there_is_none) {
    desk_make();
    setenv("XDG_STATE_HOME", "/proc/nowhere", 1);
    CHECK(!recovery_create());
    desk_remove();
}
