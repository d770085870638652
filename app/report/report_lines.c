#include "report/report_lines.h"

#include <string.h>

#include "base/memory.h"

void report_lines_add(Document *document, const char *text) {
    for (const char *line = text; line && *line && *line != '\n'; line += strcspn(line, "\n"), line += *line == '\n')
        document_add_paragraph(document, document_text(document, "%.*s%s", (int)strcspn(line, "\n"), line,
                                                       line[strcspn(line, "\n") - 1] == '.' ? "" : "."));
}

void report_lines_add_numbers(Document *document, const ParameterTable *table, const void *owner,
                              const char *const *provenance) {
    static const Column columns[] = {
        {"number", ALIGN_LEFT}, {"value", ALIGN_RIGHT}, {"unit", ALIGN_LEFT}, {"source", ALIGN_LEFT}};
    document_add_heading(document, 2, "All numbers and their sources");
    document_add_table(document, NULL, columns, sizeof columns / sizeof *columns);
    for (size_t i = 0; i < table->count; i++) {
        char *value = parameters_words(&table->rows[i], owner);
        const char *cells[] = {table->rows[i].name, document_text(document, "%s", value),
                               parameters_unit(&table->rows[i]), provenance[i]};
        document_add_row(document, cells);
        memory_free(value);
    }
}
