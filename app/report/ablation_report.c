#include "report/ablation_report.h"

#include <string.h>

#include "report/house_report.h"
#include "report/report_pictures.h"
#include "result/ablation.h"
#include "result/page.h"
#include "visual/house/drivers_band.h"
#include "visual/house/drivers_scene.h"
#include "visual/house/plan_picture.h"

static void add_sentences(Document *document, const Ablation *ablation, size_t person) {
    Text text = {0};
    result_ablation_say(&text, ablation, person);
    for (char *at = text.text, *end; at && *at; at = end + 1) {
        end = strchr(at, '\n');
        document_add_paragraph(document, document_text(document, "%.*s.", (int)(end - at), at));
    }
    memory_free(text.text);
}

/* Adds the plan once for each variant, with the paths and the touches of the same drivers, all at one scale. */
static void add_pictures(Document *document, const Ablation *ablation) {
    Scene scenes[ABLATIONS] = {{.count = 0}};
    const char *captions[ABLATIONS];
    for (int v = 0; v < ABLATIONS; v++) {
        plan_picture_bare(&scenes[v], &ablation->house);
        drivers_band_add(&scenes[v], &ablation->drivers[v], &ablation->nominal.trace);
        drivers_scene_add(&scenes[v], &ablation->house, &ablation->drivers[v]);
        captions[v] = document_text(document, "%s: %s.", ablation_rows[v].name, ablation_rows[v].meaning);
    }
    document_add_heading(document, 2, "Paths and touches");
    document_add_paragraph(document,
                           "The dark band holds half of the drivers, the dashed outline 9 of 10, about the way "
                           "of the nominal driver by the whole law. Discs: where drivers touch something, by "
                           "area the share of them, by shade the fastest impact.");
    report_pictures_add_beside(document, scenes, ABLATIONS, scenes[ABLATION_WHOLE].box, captions);
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
    add_pictures(&document, ablation);
    document_add_heading(&document, 2, "The variants");
    result_page_take(&document, NULL, result_ablation_variants(population));
    report_basis_add_making(&document, making, NULL, 0);
    return document;
}
