/* A test is a sentence: TEST(a_closed_gap_never_pulls) { ... }. Checks print both values, and a test continues after
 * a failed check. tests/support/check.c runs all tests of the program it is linked into. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "base/fault.h"

typedef struct CheckTest {
    const char *name;
    void (*run)(void);
    bool is_long;
    struct CheckTest *next;
} CheckTest;

void check_register(CheckTest *test);
void check_true(bool good, const char *what, const char *file, int line);
void check_near(double got, double expected, double tolerance, const char *what, const char *file, int line);
void check_text(const char *got, const char *expected, const char *what, const char *file, int line);

/* Prints faults, and clears them. */
void check_say(Fault *fault);

/* Skips the tests: prints what this machine lacks and exits with 77, which meson counts as skipped. */
void check_skip(const char *why) __attribute__((noreturn));

/* Writes the path of a temporary file of this name, which may end in XXXXXX. It lies in a folder of the test program's
 * own, which is TMPDIR for all that the program does and is removed at its end; what tests leave in it is an error. */
enum { CHECK_PATH = 64 };
void check_temporary(char path[CHECK_PATH], const char *name);

/* Returns the project's source directory, for houses/, assets/ and tests/data/. */
const char *check_source(void);

#define TEST(name_) CHECK_REGISTERED(name_, false)

/* A test of many seconds: it runs with the long suite only. */
#define LONG_TEST(name_) CHECK_REGISTERED(name_, true)

#define CHECK_REGISTERED(name_, is_long_)                                                                              \
    static void name_(void);                                                                                           \
    static CheckTest name_##_test = {#name_, name_, is_long_, NULL};                                                   \
    __attribute__((constructor)) static void name_##_register(void) {                                                  \
        check_register(&name_##_test);                                                                                 \
    }                                                                                                                  \
    static void name_(void)

#define CHECK(condition_) check_true((condition_), #condition_, __FILE__, __LINE__)
#define CHECK_NEAR(got_, expected_, tolerance_) check_near((got_), (expected_), (tolerance_), #got_, __FILE__, __LINE__)
#define CHECK_TEXT(got_, expected_) check_text((got_), (expected_), #got_, __FILE__, __LINE__)
