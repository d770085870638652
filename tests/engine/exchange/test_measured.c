#include "check.h"

#include <math.h>
#include <unistd.h>

#include "scratch.h"
#include "exchange/measured.h"

static const MeasuredKind kinds[] = {{"drive.frequency", NULL, "Hz"},
                                     {"peak_max", NULL, "N"},
                                     {"deflection", "displacement", "m"},
                                     {"ratio", NULL, "1"}};
enum { KINDS = sizeof kinds / sizeof *kinds };

/* Reads points from a text; its \' stand for quotation marks. */
static bool read_text(Measured *measured, const char *text) {
    char path[SCRATCH_PATH];
    Fault fault = {0};
    scratch_write(path, text);
    bool good = measured_read(measured, path, kinds, KINDS, &fault);
    check_say(&fault);
    unlink(path);
    return good;
}

static double value_of(const Measured *measured, const char *name, size_t row) {
    const double *values = measured_find(measured, name);
    return values && row < measured->count ? values[row] : NAN;
}

TEST(columns_are_found_by_name_other_name_or_last_part_in_any_order) {
    Measured measured = {0};
    CHECK(read_text(&measured, "Peak_Max [N],who,frequency\n560,'a, b',190\n"));
    CHECK(measured.column_count == 2 && measured.count == 1);
    CHECK_NEAR(value_of(&measured, "peak_max", 0), 560, 0);
    CHECK_NEAR(value_of(&measured, "drive.frequency", 0), 190, 0);
    CHECK(!measured_find(&measured, "deflection") && !measured_find(NULL, "peak_max"));
    CHECK(read_text(&measured, "displacement;ratio\n0.5;2\n"));
    CHECK_NEAR(value_of(&measured, "deflection", 0), 0.5, 0);
    CHECK(!measured_find(&measured, "peak_max"));
    measured_free(&measured);
}

TEST(units_with_a_prefix_are_brought_to_the_quantity_s_own) {
    Measured measured = {0};
    CHECK(read_text(&measured, "drive.frequency [kHz],peak_max (kN),deflection [mm]\n0.3,1.5,0.127\n"));
    CHECK_NEAR(value_of(&measured, "drive.frequency", 0), 300, 1e-9);
    CHECK_NEAR(value_of(&measured, "peak_max", 0), 1500, 1e-9);
    CHECK_NEAR(value_of(&measured, "deflection", 0), 0.127e-3, 1e-15);
    CHECK(read_text(&measured, "deflection [\u00B5m],ratio [1]\n127,3\n"));
    CHECK_NEAR(value_of(&measured, "deflection", 0), 0.127e-3, 1e-15);
    measured_free(&measured);
}

TEST(an_empty_cell_was_not_measured) {
    Measured measured = {0};
    CHECK(read_text(&measured, "frequency,peak_max\n190,\n,570\n"));
    CHECK(measured.count == 2);
    CHECK(isnan(value_of(&measured, "peak_max", 0)) && isnan(value_of(&measured, "drive.frequency", 1)));
    CHECK_NEAR(value_of(&measured, "peak_max", 1), 570, 0);
    measured_free(&measured);
}

static void read_bad(const char *path, Fault *fault) {
    Measured measured = {.path = "untouched"};
    CHECK(!measured_read(&measured, path, kinds, KINDS, fault));
    CHECK_TEXT(measured.path, "untouched");
    CHECK(!measured.columns);
}

TEST(a_bad_file_gives_exactly_its_faults_and_leaves_its_target_as_it_was) {
    scratch_check_faults("tests/data/bad/measured", read_bad);
}
