/* Tests that files are written without any loss. The functions of the system that write and sync are replaced here: the
 * tests count them, and let them fail. */
#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <signal.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <sys/xattr.h>
#include <unistd.h>

#include "base/file_write.h"
#include "base/memory.h"
#include "base/text.h"
#include "check.h"
#include "scratch.h"

enum { OTHER_USER = 12345, OTHER_GROUP = 23456, LONG_NAME = 255 };

static int synced_files, synced_folders, rename_error, steps;
static int write_error_after = -1; /* writes until the next ones fail */
static int write_error, kill_at = -1;
static size_t write_most = SIZE_MAX; /* bytes */
static int list_error;               /* of the attributes */

/* Ends the process at a chosen step, as kill -9 does. */
static void step(void) {
    if (steps++ == kill_at)
        kill(getpid(), SIGKILL);
}

int fsync(int file) {
    struct stat status;
    if (fstat(file, &status) == 0)
        *(S_ISDIR(status.st_mode) ? &synced_folders : &synced_files) += 1;
    step();
    return (int)syscall(SYS_fsync, file);
}

ssize_t write(int file, const void *bytes, size_t size) {
    static bool once;
    struct stat status;
    if (fstat(file, &status) == 0 && S_ISREG(status.st_mode) && file > STDERR_FILENO) {
        step();
        if (write_most != SIZE_MAX && (once = !once)) {
            errno = EINTR;
            return -1;
        }
        if (write_error_after >= 0 && write_error_after-- == 0) {
            errno = write_error;
            return -1;
        }
        size = size < write_most ? size : write_most;
    }
    return syscall(SYS_write, file, bytes, size);
}

int renameat(int from_folder, const char *from, int to_folder, const char *to) {
    step();
    if (rename_error) {
        errno = rename_error;
        return -1;
    }
    return (int)syscall(SYS_renameat2, from_folder, from, to_folder, to, 0);
}

int unlinkat(int folder, const char *name, int flags) {
    step();
    return (int)syscall(SYS_unlinkat, folder, name, flags);
}

ssize_t listxattr(const char *path, char *list, size_t size) {
    if (list_error) {
        errno = list_error;
        return -1;
    }
    return syscall(SYS_listxattr, path, list, size);
}

/* A folder for one test. */
typedef struct Place {
    char folder[CHECK_PATH], file[128], link[128];
} Place;

static Place make_place(void) {
    Place place = {"", "", ""};
    check_temporary(place.folder, "write-XXXXXX");
    CHECK(mkdtemp(place.folder) != NULL);
    snprintf(place.file, sizeof place.file, "%s/file", place.folder);
    snprintf(place.link, sizeof place.link, "%s/link", place.folder);
    synced_files = synced_folders = 0;
    return place;
}

static void remove_place(const Place *place) {
    char command[128];
    snprintf(command, sizeof command, "rm -rf %s", place->folder);
    CHECK(system(command) == 0);
}

/* Counts the entries of the folder. */
static int entries(const Place *place) {
    DIR *folder = opendir(place->folder);
    int count = 0;
    while (readdir(folder))
        count++;
    closedir(folder);
    return count - 2;
}

static int put(const char *path, const char *text) {
    return file_write_bytes(path, text, strlen(text));
}

static void make_file(const char *path, const char *text, mode_t mode) {
    FILE *file = fopen(path, "w");
    fputs(text, file);
    fclose(file);
    CHECK(chmod(path, mode) == 0);
}

static void check_file(const char *path, const char *expected) {
    char *text = scratch_read(path);
    CHECK_TEXT(text, expected);
    memory_free(text);
}

static struct stat status_of(const char *path) {
    struct stat status = {0};
    CHECK(lstat(path, &status) == 0);
    return status;
}

/* Returns what the function returns for another user. */
static int as_other_user(int (*act)(const Place *place), const Place *place) {
    pid_t child = fork();
    int status;
    if (child == 0) {
        bool changed = geteuid() != 0 || (setgid(OTHER_GROUP) == 0 && setuid(OTHER_USER) == 0);
        _exit(changed ? act(place) : 255);
    }
    CHECK(waitpid(child, &status, 0) == child);
    return WIFEXITED(status) ? WEXITSTATUS(status) : 256;
}

static int put_file(const Place *place) {
    return put(place->file, "new");
}

TEST(file_and_folder_are_synced_and_nothing_else_is_left) {
    Place place = make_place();
    CHECK(put(place.file, "old") == 0 && synced_files == 1 && synced_folders == 1);
    CHECK(put(place.file, "new") == 0 && synced_files == 2 && synced_folders == 2);
    check_file(place.file, "new");
    CHECK(file_write_quickly(place.file, "quick", 5) == 0 && synced_files == 2 && synced_folders == 2);
    CHECK(link(place.file, place.link) == 0 && put(place.file, "in place") == 0);
    CHECK(synced_files == 4 && synced_folders == 4 && entries(&place) == 2);
    remove_place(&place);
}

TEST(links_are_followed) {
    Place place = make_place();
    char second[128], inner[128];
    snprintf(inner, sizeof inner, "%s/inner", place.folder);
    snprintf(second, sizeof second, "%s/inner/second", place.folder);
    CHECK(mkdir(inner, 0777) == 0 && symlink("../link", second) == 0 && symlink("file", place.link) == 0);
    CHECK(put(second, "dangling") == 0);
    check_file(place.file, "dangling");
    CHECK(put(second, "chain") == 0 && put(place.link, "one") == 0);
    check_file(place.file, "one");
    CHECK(S_ISLNK(status_of(second).st_mode) && S_ISLNK(status_of(place.link).st_mode));
    CHECK(S_ISREG(status_of(place.file).st_mode));
    CHECK(unlink(place.file) == 0 && symlink(second, place.file) == 0);
    CHECK(put(place.file, "circle") == ELOOP);
    CHECK_TEXT(file_write_reason(ELOOP), "its symbolic links lead in a circle");
    CHECK(unlink(second) == 0 && symlink("missing/file", second) == 0 && put(second, "x") == ENOENT);
    remove_place(&place);
}

TEST(mode_and_owner_are_kept) {
    Place place = make_place();
    mode_t mask = umask(0077);
    static const mode_t modes[] = {0600, 0644, 0664, 0755, 0200, 0622};
    for (size_t i = 0; i < sizeof modes / sizeof *modes; i++) {
        make_file(place.file, "old", modes[i]);
        CHECK(put(place.file, "new") == 0);
        CHECK((status_of(place.file).st_mode & 07777) == modes[i]);
        CHECK(chmod(place.file, 0600) == 0);
    }
    CHECK(unlink(place.file) == 0 && put(place.file, "new") == 0 && (status_of(place.file).st_mode & 07777) == 0600);
    umask(0022);
    CHECK(unlink(place.file) == 0 && put(place.file, "new") == 0 && (status_of(place.file).st_mode & 07777) == 0644);
    CHECK(setxattr(place.file, "user.note", "kept", 4, 0) == 0 || errno == ENOTSUP);
    bool has_note = getxattr(place.file, "user.note", NULL, 0) == 4;
    if (geteuid() == 0)
        CHECK(chown(place.file, OTHER_USER, OTHER_GROUP) == 0);
    struct stat before = status_of(place.file), after;
    CHECK(put(place.file, "newer") == 0);
    after = status_of(place.file);
    CHECK(after.st_uid == before.st_uid && after.st_gid == before.st_gid && after.st_mode == before.st_mode);
    CHECK(!has_note || getxattr(place.file, "user.note", NULL, 0) == 4);
    umask(mask);
    remove_place(&place);
}

TEST(attributes_that_cannot_be_listed_are_kept_by_writing_in_place) {
    Place place = make_place();
    make_file(place.file, "old", 0644);
    ino_t number = status_of(place.file).st_ino;
    list_error = EIO;
    CHECK(put(place.file, "new") == 0 && status_of(place.file).st_ino == number);
    list_error = ENOTSUP;
    CHECK(put(place.file, "newer") == 0 && status_of(place.file).st_ino != number);
    list_error = 0;
    check_file(place.file, "newer");
    remove_place(&place);
}

TEST(a_stream_keeps_the_first_error) {
    Place place = make_place();
    int error;
    FileWrite *work = file_write_begin(place.file, &error);
    FILE *stream = file_write_stream(work);
    setvbuf(stream, NULL, _IONBF, 0);
    write_error = ENOSPC;
    write_error_after = 0;
    CHECK(fputs("text", stream) == EOF);
    write_error_after = -1;
    errno = ENOTTY; /* a later call fails for another reason */
    CHECK(file_write_end(work, 0) == ENOSPC && entries(&place) == 0);
    remove_place(&place);
}

TEST(too_many_copies_are_named) {
    Place place = make_place();
    make_file(place.file, "old", 0644);
    CHECK(link(place.file, place.link) == 0);
    for (int i = 1; i <= 99; i++) {
        char copy[160], number[16] = "";
        if (i > 1)
            snprintf(number, sizeof number, "-%d", i);
        snprintf(copy, sizeof copy, "%s.before-saving%s", place.file, number);
        make_file(copy, "older", 0644);
    }
    CHECK(put(place.file, "new") == EEXIST);
    CHECK_TEXT(file_write_reason(EEXIST),
               "too many copies named .before-saving are left next to it; remove those that are not needed");
    CHECK_TEXT(file_write_reason(EINTR), "interrupted");
    check_file(place.file, "old");
    remove_place(&place);
}

TEST(new_files_take_the_group_of_the_folder) {
    Place place = make_place();
    if (geteuid() == 0)
        CHECK(chown(place.folder, 0, OTHER_GROUP) == 0);
    CHECK(chmod(place.folder, 02775) == 0 && put(place.file, "new") == 0);
    CHECK(status_of(place.file).st_gid == status_of(place.folder).st_gid);
    remove_place(&place);
}

/* Also where rename is refused, as it is for a mount point, and where the folder is not writable. */
TEST(hard_links_and_mount_points_and_others_files_are_written_in_place) {
    Place place = make_place();
    make_file(place.file, "a long old text", 0666);
    CHECK(link(place.file, place.link) == 0);
    ino_t number = status_of(place.file).st_ino;
    CHECK(put(place.file, "new") == 0 && status_of(place.file).st_ino == number);
    check_file(place.link, "new");
    CHECK(unlink(place.link) == 0);
    rename_error = EBUSY;
    CHECK(put(place.file, "mounted") == 0 && status_of(place.file).st_ino == number && entries(&place) == 1);
    rename_error = 0;
    check_file(place.file, "mounted");
    CHECK(chmod(place.folder, 0777) == 0 && as_other_user(put_file, &place) == 0);
    CHECK(status_of(place.file).st_uid == geteuid() && (status_of(place.file).st_mode & 07777) == 0666);
    check_file(place.file, "new");
    make_file(place.file, "old", 0666);
    CHECK(chmod(place.folder, 0555) == 0 && as_other_user(put_file, &place) == 0);
    check_file(place.file, "new");
    CHECK(chmod(place.folder, 0777) == 0 && entries(&place) == 1);
    remove_place(&place);
}

TEST(write_protected_files_are_refused) {
    Place place = make_place();
    make_file(place.file, "old", 0444);
    CHECK(put(place.file, "new") == EPERM);
    CHECK_TEXT(file_write_reason(EPERM), "the file is write-protected");
    CHECK(chmod(place.folder, 0777) == 0 && chmod(place.file, 0644) == 0);
    if (geteuid() == 0)
        CHECK(as_other_user(put_file, &place) == EPERM);
    check_file(place.file, "old");
    CHECK(entries(&place) == 1 && put(place.folder, "new") == EISDIR && put("", "new") == ENOENT);
    CHECK(unlink(place.file) == 0 && chmod(place.folder, 0555) == 0);
    CHECK(as_other_user(put_file, &place) == EACCES);
    CHECK(chmod(place.folder, 0777) == 0);
    remove_place(&place);
}

TEST(a_full_disk_leaves_the_old_file_and_is_named) {
    Place place = make_place();
    static const int errors[] = {ENOSPC, EDQUOT, EIO};
    CHECK_TEXT(file_write_reason(ENOSPC), "the disk is full");
    CHECK_TEXT(file_write_reason(EDQUOT), "the disk quota is used up");
    make_file(place.file, "old", 0644);
    write_error = ENOSPC;
    for (size_t i = 0; i < sizeof errors / sizeof *errors; i++) {
        write_error = errors[i];
        write_error_after = 0;
        CHECK(put(place.file, "new") == errors[i]);
        check_file(place.file, "old");
        CHECK(entries(&place) == 1);
    }
    CHECK(link(place.file, place.link) == 0);
    for (int after = 0; after < 3; after++) { /* the new contents, the copy, the file */
        write_error_after = after;
        CHECK(put(place.file, "new") == EIO);
        check_file(place.link, "old");
        CHECK(entries(&place) == 2);
    }
    write_error_after = -1;
    CHECK(put("/dev/full", "new") == ENOSPC);
    struct rlimit before, small = {100, 100};
    CHECK(getrlimit(RLIMIT_FSIZE, &before) == 0);
    signal(SIGXFSZ, SIG_IGN);
    small.rlim_max = before.rlim_max;
    CHECK(setrlimit(RLIMIT_FSIZE, &small) == 0);
    char big[1000] = "";
    CHECK(file_write_bytes(place.file, big, sizeof big) == EFBIG);
    CHECK(setrlimit(RLIMIT_FSIZE, &before) == 0);
    check_file(place.file, "old");
    CHECK(entries(&place) == 2);
    remove_place(&place);
}

TEST(short_writes_and_signals_are_survived) {
    Place place = make_place();
    write_most = 3;
    CHECK(put(place.file, "0123456789") == 0);
    check_file(place.file, "0123456789");
    CHECK(link(place.file, place.link) == 0 && put(place.file, "abcdefgh") == 0);
    write_most = SIZE_MAX;
    check_file(place.link, "abcdefgh");
    remove_place(&place);
}

TEST(pipes_and_devices_are_written_directly) {
    Place place = make_place();
    char text[8] = "";
    CHECK(mkfifo(place.file, 0600) == 0);
    int reader = open(place.file, O_RDONLY | O_NONBLOCK);
    CHECK(put(place.file, "pipe") == 0 && read(reader, text, sizeof text) == 4);
    CHECK_TEXT(text, "pipe");
    close(reader);
    CHECK(file_write_is_direct(place.file) && file_write_is_direct("/dev/null") && !file_write_is_direct(""));
    CHECK(!file_write_is_direct(place.folder) && !file_write_is_direct(place.link));
    CHECK(S_ISFIFO(status_of(place.file).st_mode) && put("/dev/null", "x") == 0 && unlink(place.file) == 0);
    int file = open(place.file, O_RDWR | O_CREAT | O_APPEND, 0600);
    char own[64];
    snprintf(own, sizeof own, "/dev/fd/%d", file);
    CHECK(file_write_is_direct(own) && !file_write_is_direct(place.file));
    CHECK(put(own, "first,") == 0 && put(own, "second") == 0);
    check_file(place.file, "first,second");
    close(file);
    remove_place(&place);
}

TEST(names_may_be_as_long_as_the_system_allows) {
    Place place = make_place();
    for (size_t size = 1; size <= 3; size++) {
        static const char *const letters[] = {"", "x", "\xc3\xa9", "\xe2\x82\xac"};
        Text path = {0};
        text_format(&path, "%s/", place.folder);
        for (size_t i = 0; i < LONG_NAME / size; i++)
            text_add(&path, letters[size]);
        CHECK(put(path.text, "long") == 0);
        check_file(path.text, "long");
        CHECK(unlink(place.link) == 0 || errno == ENOENT);
        CHECK(link(path.text, place.link) == 0 && put(path.text, "in place") == 0);
        check_file(place.link, "in place");
        memory_free(path.text);
    }
    CHECK(entries(&place) == 4);
    remove_place(&place);
}

/* Kills a process at each of its steps, and runs the next one. Returns how often the file held parts of both texts. */
static int kill_at_each_step(bool is_linked, const char *old, const char *new) {
    Place place = make_place();
    char copy[160];
    snprintf(copy, sizeof copy, "%s.before-saving", place.file);
    int torn = 0;
    for (bool ended = false; !ended; kill_at++) {
        pid_t child;
        int status;
        make_file(place.file, old, 0644);
        if (is_linked && access(place.link, F_OK))
            CHECK(link(place.file, place.link) == 0);
        steps = 0;
        kill_at = kill_at < 0 ? 0 : kill_at;
        if ((child = fork()) == 0)
            _exit(put(place.file, new));
        CHECK(waitpid(child, &status, 0) == child);
        ended = WIFEXITED(status);
        char *text = scratch_read(place.file);
        bool is_whole = strcmp(text, old) == 0 || strcmp(text, new) == 0;
        CHECK(is_whole || is_linked);
        CHECK(!ended || strcmp(text, new) == 0);
        if (!is_whole)
            check_file(copy, old);
        torn += !is_whole;
        unlink(copy);
        memory_free(text);
        if ((child = fork()) == 0)
            execl("/proc/self/exe", "test", "--put", place.file, NULL);
        CHECK(waitpid(child, &status, 0) == child && status == 0);
        check_file(place.file, "another");
        char command[160];
        snprintf(command, sizeof command, "! ls -A %s | grep -q part", place.folder);
        CHECK(system(command) == 0);
    }
    CHECK(kill_at > 4);
    kill_at = -1;
    remove_place(&place);
    return torn;
}

TEST(a_killed_process_leaves_the_old_or_the_new_file) {
    CHECK(kill_at_each_step(false, "old", "new") == 0);
    write_most = 1;
    CHECK(kill_at_each_step(false, "a long old text", "new") == 0);
    write_most = SIZE_MAX;
}

TEST(a_killed_process_leaves_a_copy_of_the_old_contents_if_it_wrote_in_place) {
    kill_at_each_step(true, "old", "new");
    write_most = 1;
    CHECK(kill_at_each_step(true, "a long old text", "new") > 0);
    CHECK(kill_at_each_step(true, "old", "a long new text") > 0);
    write_most = SIZE_MAX;
}

TEST(parts_of_running_processes_stay) {
    Place place = make_place();
    int error;
    FileWrite *work = file_write_begin_named(place.file, ".mp4", &error);
    CHECK(work && strstr(file_write_part(work), ".part.mp4"));
    char stale[160];
    snprintf(stale, sizeof stale, "%s/.clearance-1-1.part", place.folder);
    make_file(stale, "stale", 0600);
    if (fork() == 0) /* forks share the locks */
        execl("/proc/self/exe", "test", "--put", place.link, NULL);
    int status;
    wait(&status);
    CHECK(access(stale, F_OK) != 0 && access(file_write_part(work), F_OK) == 0);
    fputs("a film", file_write_stream(work));
    CHECK(file_write_end(work, 0) == 0);
    check_file(place.file, "a film");
    work = file_write_begin(place.file, &error);
    fputs("nothing", file_write_stream(work));
    CHECK(file_write_end(work, EIO) == EIO);
    check_file(place.file, "a film");
    remove_place(&place);
}

/* Called as `test --put FILE`, writes the file and ends. */
static void __attribute__((constructor)) put_and_end(int argc, char **argv) {
    if (argc == 3 && strcmp(argv[1], "--put") == 0)
        _exit(put(argv[2], "another"));
}
