#include "check.h"

#include <dirent.h>
#include <ftw.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

static CheckTest *first;
static int failures, checks;

/* A test with very many failures is cut short in the output. */
enum { PRINTED_MOST = 10 };
static int printed;

static bool prints(bool good) {
    return !good && ++printed <= PRINTED_MOST;
}

void check_register(CheckTest *test) {
    CheckTest **end = &first;
    while (*end)
        end = &(*end)->next;
    *end = test;
}

static void count(bool good) {
    checks++;
    failures += !good;
}

void check_true(bool good, const char *what, const char *file, int line) {
    count(good);
    if (prints(good))
        printf("%s:%d: not true: %s\n", file, line, what);
}

void check_near(double got, double expected, double tolerance, const char *what, const char *file, int line) {
    bool good = fabs(got - expected) <= tolerance || got == expected;
    count(good);
    if (prints(good))
        printf("%s:%d: %s is %.12g, expected %.12g within %.3g\n", file, line, what, got, expected, tolerance);
}

void check_text(const char *got, const char *expected, const char *what, const char *file, int line) {
    bool good = got && strcmp(got, expected) == 0;
    count(good);
    if (prints(good))
        printf("%s:%d: %s is\n  \"%s\"\nexpected\n  \"%s\"\n", file, line, what, got ? got : "(none)", expected);
}

void check_say(Fault *fault) {
    for (size_t i = 0; i < fault->count; i++)
        printf("%s\n", fault->lines[i]);
    fault_clear(fault);
}

void check_skip(const char *why) {
    printf("skipped: %s\n", why);
    exit(77);
}

const char *check_source(void) {
    const char *source = getenv("CLEARANCE_SOURCE");
    return source ? source : ".";
}

enum { PARENT_MOST = 24 /* letters of TMPDIR: the paths of all tests have room */ };

static char temporary[CHECK_PATH - 24];
static pid_t owner; /* the process that removes the folder: its children leave it alone */

static int remove_entry(const char *path, const struct stat *status, int kind, struct FTW *walk) {
    (void)status, (void)kind, (void)walk;
    return remove(path);
}

static void remove_temporary(void) {
    if (owner == getpid())
        nftw(temporary, remove_entry, 16, FTW_DEPTH | FTW_PHYS);
}

static void make_temporary(void) {
    const char *parent = getenv("TMPDIR");
    owner = getpid();
    snprintf(temporary, sizeof temporary, "%s/test-XXXXXX", parent && strlen(parent) <= PARENT_MOST ? parent : "/tmp");
    if (!mkdtemp(temporary) || chmod(temporary, 01777) != 0 || /* tests act as other users, too */
        setenv("TMPDIR", temporary, 1) != 0) {
        perror(temporary);
        exit(1);
    }
    atexit(remove_temporary);
}

void check_temporary(char path[CHECK_PATH], const char *name) {
    snprintf(path, CHECK_PATH, "%s/%s", temporary, name);
}

/* Counts and prints the files that tests have left. */
static int left_behind(void) {
    DIR *folder = opendir(temporary);
    int left = 0;
    for (const struct dirent *entry; folder && (entry = readdir(folder));)
        if (strcmp(entry->d_name, ".") != 0 && strcmp(entry->d_name, "..") != 0) {
            printf("left behind: %s\n", entry->d_name);
            left++;
        }
    if (folder)
        closedir(folder);
    return left;
}

/* s of the processor's, if a test takes more than one. */
static void say_time(clock_t begun) {
    double seconds = (double)(clock() - begun) / CLOCKS_PER_SEC;
    if (seconds > 1)
        printf(" (%.1f s)", seconds);
}

/* Arguments: --long for the long tests instead of the others, and a part of a name. */
int main(int argc, char **argv) {
    int tests = 0, failed = 0;
    bool is_long = argc > 1 && strcmp(argv[1], "--long") == 0;
    const char *part = argc > 1 + is_long ? argv[1 + is_long] : NULL;
    setvbuf(stdout, NULL, _IOLBF, 0);
    make_temporary();
    for (CheckTest *test = first; test; test = test->next) {
        if (test->is_long != is_long || (part && !strstr(test->name, part)))
            continue;
        int before = failures;
        clock_t begun = clock();
        printed = 0;
        test->run();
        tests++;
        failed += failures != before;
        printf("%s %s", failures == before ? "ok  " : "FAIL", test->name);
        say_time(begun);
        printf("\n");
    }
    printf("%d tests, %d checks, %d tests failed\n", tests, checks, failed);
    if (!checks)
        printf("no check was made\n");
    return left_behind() || failed || !checks;
}
