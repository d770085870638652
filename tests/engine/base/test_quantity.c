#include "check.h"

#include <stdio.h>
#include <string.h>

#include "base/quantity.h"

#define NONSENSE (-77.7)

static double read_as(const char *words, const char *unit) {
    char reason[QUANTITY_REASON];
    double value = NONSENSE;
    bool good = quantity_read(words, unit, &value, reason);
    if (!good)
        printf("%s: %s\n", words, reason);
    CHECK(good);
    return value;
}

static void check_refused(const char *words, const char *unit) {
    char reason[QUANTITY_REASON] = "";
    double value = NONSENSE;
    bool good = quantity_read(words, unit, &value, reason);
    if (good)
        printf("%s is read as %g\n", words, value);
    CHECK(!good);
    CHECK(*reason);
    CHECK(value == NONSENSE);
}

TEST(a_number_is_read_with_and_without_its_unit) {
    CHECK_NEAR(read_as("0.9", "m"), 0.9, 0);
    CHECK_NEAR(read_as(" 0.90 m ", "m"), 0.9, 0);
    CHECK_NEAR(read_as("-1", "m"), -1, 0);
    CHECK_NEAR(read_as("\u2212"
                       "1",
                       "m"),
               -1, 0);
    CHECK_NEAR(read_as("+5", ""), 5, 0);
    CHECK_NEAR(read_as(".5", NULL), 0.5, 0);
    CHECK_NEAR(read_as("5.", NULL), 5, 0);
    CHECK_NEAR(read_as("1.5e3", "Hz"), 1500, 0);
    CHECK_NEAR(read_as("200 N s/m", "N s/m"), 200, 0);
    CHECK_NEAR(read_as("3 per cycle", "per cycle"), 3, 0);
}

TEST(a_comma_is_a_point) {
    CHECK_NEAR(read_as("2,5", "m"), 2.5, 0);
    CHECK_NEAR(read_as("0,127 mm", "mm"), 0.127, 0);
}

TEST(a_unit_of_the_same_kind_is_turned_into_ours) {
    CHECK_NEAR(read_as("250cm", "m"), 2.5, 1e-12);
    CHECK_NEAR(read_as("2500 mm", "m"), 2.5, 1e-12);
    CHECK_NEAR(read_as("0.000127 m", "mm"), 0.127, 1e-12);
    CHECK_NEAR(read_as("0.3 kHz", "Hz"), 300, 1e-9);
    CHECK_NEAR(read_as("0.2kN", "N"), 200, 1e-9);
    CHECK_NEAR(read_as("20 ms", "s"), 0.02, 1e-12);
    CHECK_NEAR(read_as("700 g", "kg"), 0.7, 1e-12);
    CHECK_NEAR(read_as("15°", "deg"), 15, 0);
    CHECK_NEAR(read_as("8 ft", "m"), 2.4384, 1e-12);
    CHECK_NEAR(read_as("3.6 km/h", "m/s"), 1, 1e-12);
}

TEST(numbers_are_added_and_feet_have_inches) {
    CHECK_NEAR(read_as("1.2+0.91", "m"), 2.11, 1e-12);
    CHECK_NEAR(read_as("1 m - 5cm + 2 mm", "m"), 0.952, 1e-12);
    CHECK_NEAR(read_as("2\u2212"
                       "0.5",
                       "m"),
               1.5, 0);
    CHECK_NEAR(read_as("8ft 2in", "m"), 2.4892, 1e-12);
    CHECK_NEAR(read_as("8'2\"", "m"), 2.4892, 1e-12);
    CHECK_NEAR(read_as("-1 ft 6 in", "m"), -0.4572, 1e-12);
}

TEST(what_is_no_number_is_refused_with_a_reason) {
    static const char *const words[] = {"abc",      "",     "   ",  "1e400",  "nan",  "inf",   "0x10", "1.2.3",
                                        "1,234.5",  "1 2",  "1\n2", "--1",    "1+",   "1 + ",  "5 kg", "5 parsec",
                                        "m",        "1mm2", "2*3",  "1e",     "\xFF", "1\xC2", "%s%n", "1ft 2",
                                        "1 m 2 in", ".",    ",",    "9e99e9", "1/2",  "'"};
    for (size_t i = 0; i < sizeof words / sizeof *words; i++)
        check_refused(words[i], "m");
    check_refused("5 m", "");
    check_refused("1e308+1e308", "m");
}

TEST(however_long_it_is) {
    char words[5000];
    memset(words, '1', sizeof words - 1);
    words[sizeof words - 1] = 0;
    check_refused(words, "m");
    memset(words, 'm', sizeof words - 1);
    check_refused(words, "m");
    memset(words + 1, ' ', sizeof words - 2);
    words[0] = '3';
    CHECK_NEAR(read_as(words, "m"), 3, 0);
}
