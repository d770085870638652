#include "laboratory/import_file.h"

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

bool import_file_read(ImportFile *import, const char *path, Fault *fault) {
    Plan plan = {0};
    ImportReport report = {0};
    bool read = import_read(&plan, path, &(ImportOptions){.unit = 0}, &report, fault);
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
