#include "exchange/import_report.h"

#include <stdarg.h>
#include <string.h>

#include "base/visible.h"

static const char other_kinds[] = "things of other kinds";

static void add_count(ImportReport *report, const char *what, size_t count) {
    for (size_t i = 0; i < report->left_out_count; i++) {
        if (strcmp(report->left_out[i].what, what) == 0) {
            report->left_out[i].count += count;
            return;
        }
    }
    if (report->left_out_count == IMPORT_REPORT_KINDS) {
        add_count(report, report->left_out[IMPORT_REPORT_KINDS - 1].what, count);
        return;
    }
    if (report->left_out_count == IMPORT_REPORT_KINDS - 1)
        what = other_kinds;
    report->left_out = memory_reserve(report->left_out, &report->left_out_capacity, report->left_out_count + 1,
                                      sizeof *report->left_out);
    report->left_out[report->left_out_count++] = (ImportLeft){arena_text(&report->arena, what), count};
}

void import_report_leave(ImportReport *report, size_t count, const char *format, ...) {
    if (!count)
        return;
    va_list arguments;
    va_start(arguments, format);
    char *what = visible_printed(format, arguments);
    va_end(arguments);
    add_count(report, what, count);
    memory_free(what);
}

void import_report_note(ImportReport *report, const char *format, ...) {
    if (report->note_count == IMPORT_REPORT_NOTES)
        return;
    va_list arguments;
    va_start(arguments, format);
    char *note = visible_printed(format, arguments);
    va_end(arguments);
    report->notes =
        memory_reserve(report->notes, &report->note_capacity, report->note_count + 1, sizeof *report->notes);
    report->notes[report->note_count++] = arena_text(&report->arena, note);
    memory_free(note);
}

void import_report_clear(ImportReport *report) {
    memory_free(report->left_out);
    memory_free(report->notes);
    arena_clear(&report->arena);
    *report = (ImportReport){0};
}
