#include "check.h"

#include <string.h>

#include "imported.h"
#include "scratch.h"

static void read_bad(const char *path, Fault *fault) {
    Plan plan = {.name = "untouched"};
    ImportReport report = {0};
    CHECK(!import_read(&plan, path, &(ImportOptions){0}, &report, fault));
    CHECK(fault->total == 1);
    CHECK_TEXT(plan.name, "untouched");
    import_report_clear(&report);
}

TEST(a_bad_file_is_refused_in_one_line_that_says_where) {
    scratch_check_faults("tests/data/bad/imports", read_bad);
}

TEST(a_file_of_another_kind_is_refused_by_its_ending) {
    Imported import = imported_text(".txt", "POLYGON ((0 0, 4 0, 4 3, 0 0))", (ImportOptions){0});
    CHECK(import.fault.count && strstr(import.fault.lines[0], "must end in .sh3d, .dxf, .wkt or .scenario"));
    imported_end(&import, false);
    CHECK(import_is_file("a.DXF") && !import_is_file("dxf") && !import_is_file(".dxf"));
    CHECK(import_unit("inch") == 0.0254 && import_unit("parsec") == 0);
}
