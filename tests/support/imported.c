#include "base/file_write.h"
#include "imported.h"

#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "check.h"
#include "scratch.h"

const char *imported_path(char path[IMPORTED_PATH], const char *ending) {
    char base[SCRATCH_PATH];
    scratch_write(base, "");
    unlink(base);
    snprintf(path, IMPORTED_PATH, "%s%s", base, ending);
    return path;
}

Imported imported_file(const char *path, ImportOptions options) {
    Imported import = {.good = false};
    import.good = import_read(&import.plan, path, &options, &import.report, &import.fault);
    CHECK(import.good == (import.fault.total == 0));
    unlink(path);
    return import;
}

Imported imported_text(const char *ending, const char *text, ImportOptions options) {
    char path[IMPORTED_PATH];
    imported_path(path, ending);
    CHECK(file_write_quickly(path, text, strlen(text)) == 0);
    return imported_file(path, options);
}

void imported_end(Imported *import, bool wanted) {
    CHECK(import->good == wanted);
    for (size_t i = 0; i < import->fault.count && wanted; i++)
        printf("%s\n", import->fault.lines[i]);
    fault_clear(&import->fault);
    import_report_clear(&import->report);
    plan_free(&import->plan);
}

void imported_check_lists(const Plan *plan, const char *expected) {
    char *text = plan_text(plan), *walls = strstr(text, "  \"walls\"");
    for (char *c = text; *c; c++)
        *c = *c == '"' ? '\'' : *c;
    CHECK(walls);
    if (walls)
        CHECK_TEXT(walls, expected);
    memory_free(text);
}

bool imported_left_out(const Imported *import, const char *what, size_t count) {
    for (size_t i = 0; i < import->report.left_out_count; i++)
        if (strcmp(import->report.left_out[i].what, what) == 0)
            return import->report.left_out[i].count == count;
    return false;
}

bool imported_noted(const Imported *import, const char *part) {
    for (size_t i = 0; i < import->report.note_count; i++)
        if (strstr(import->report.notes[i], part))
            return true;
    return false;
}
