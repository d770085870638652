#include "laboratory/import_file.h"

#include <stdio.h>
#include <string.h>

#include "base/text.h"
#include "exchange/import.h"

bool import_file_knows(const char *path) {
    return import_is_file(path);
}

static void add_notes(ImportFile *import, const ImportReport *report) {
    for (size_t i = 0; i < report->note_count; i++)
        fault_add(&import->notes, "%s", report->notes[i]);
    for (size_t i = 0; i < report->left_out_count; i++) {
        const ImportLeft *left = &report->left_out[i];
        fault_add(&import->notes, "left out: %zu %s", left->count, left->what);
        text_format(&import->left, "%s%zu %s", import->left.used ? ", " : "", left->count, left->what);
    }
}

static void add_choice(ImportFile *import, const ImportUnit *unit) {
    static const char *const plurals[][2] = {
        {"mm", "millimetres"}, {"cm", "centimetres"}, {"m", "metres"}, {"inch", "inches"}, {"ft", "feet"}};
    const char *plural = unit->name;
    for (size_t i = 0; i < sizeof plurals / sizeof *plurals; i++)
        plural = strcmp(unit->name, plurals[i][0]) == 0 ? plurals[i][1] : plural;
    Text text = {0};
    text_format(&text, "%.2f m by %.2f m, drawn in %s", unit->plan.x, unit->plan.y, plural);
    if (unit->leaf > 0)
        text_format(&text, ": doors %.2f m", unit->leaf);
    if (unit->wall > 0)
        text_format(&text, "%s walls %.2f m", unit->leaf > 0 ? "," : ":", unit->wall);
    ImportChoice *choice = &import->choices[import->choice_count++];
    choice->metres = unit->metres;
    snprintf(choice->text, sizeof choice->text, "%s", text.text);
    memory_free(text.text);
}

/* Adds the units that are possible; all if none is. */
static void add_choices(ImportFile *import, const ImportReport *report) {
    bool any = report->unit_count && report->units[0].possible;
    for (size_t i = 0; i < report->unit_count && i < IMPORT_CHOICES; i++)
        if (report->units[i].possible || !any)
            add_choice(import, &report->units[i]);
    import->width = report->unit_count ? report->units[0].plan.x / report->units[0].metres : 0;
}

bool import_file_read(ImportFile *import, const char *path, double unit, Fault *fault) {
    Plan plan = {0};
    ImportReport report = {0};
    bool read = import_read(&plan, path, &(ImportOptions){.unit = unit}, &report, fault);
    add_choices(import, &report);
    if (read) {
        import->text = plan_text(&plan);
        import->name = text_copy(plan.name);
        import->format = report.format ? report.format : "another program";
        add_notes(import, &report);
    }
    plan_free(&plan);
    import_report_clear(&report);
    return read;
}

void import_file_clear(ImportFile *import) {
    memory_free(import->text);
    memory_free(import->name);
    memory_free(import->left.text);
    fault_clear(&import->notes);
    *import = (ImportFile){.text = NULL};
}
