#include "report/ablation_report.h"

#include <string.h>

#include "report/house_report.h"
#include "result/ablation.h"
#include "result/page.h"

static void add_sentences(Document *document, const Ablation *ablation, size_t person) {
    Text text = {0};
    result_ablation_say(&text, ablation, person);
    for (char *at = text.text, *end; at && *at; at = end + 1) {
        end = strchr(at, '\n');
        document_add_paragraph(document, document_text(document, "%.*s.", (int)(end - at), at));
    }
    memory_free(text.text);
}

Document ablation_report_make(const Ablation *ablation, const Population *population, const Making *making) {
    Document document = document_begin(making->program);
    const House *house = &ablation->house;
    document_add_title(&document, document_text(&document, "Ablation report: %s", house_report_name(house)),
                       document_text(&document, "What each part of the driving law is worth to %zu drivers",
                                     ablation->drivers[ABLATION_WHOLE].count));
    document_add_paragraph(&document, document_text(&document, "Drivers of the population %s: %s. %s", population->id,
                                                    population->title, population->note));
    document_add_note(&document, "The same drivers, with the same bodies, starts and errors of steering, in every row: "
                                 "differences are paired. The lateral control of miura is ours, not the paper's.");
    report_basis_add_changes(&document, making);
    document_add_contents(&document);
    for (size_t i = 0; i < house->person_count; i++) {
        ResultTable table = result_ablation_table(ablation, i);
        if (!table.record_count) {
            result_clear(&table);
            continue;
        }
        document_add_heading(&document, 2, house->people[i].id);
        result_page_take(&document, NULL, table);
        add_sentences(&document, ablation, i);
    }
    document_add_heading(&document, 2, "The variants");
    result_page_take(&document, NULL, result_ablation_variants(population));
    report_basis_add_making(&document, making, NULL, 0);
    return document;
}
