#include "report/rules_report.h"

#include "report/house_report.h"
#include "report/report_pictures.h"
#include "result/page.h"
#include "result/names.h"
#include "result/rules.h"
#include "visual/house/rules_scene.h"

static void add_group(Document *document, const House *house, const Inspection *inspection, FindingGroup group) {
    ResultTable table = result_rules_findings(inspection, group);
    if (table.record_count) {
        document_add_heading(document, 2,
                             document_text(document, "%s: %zu", result_rules_group(group), table.record_count));
        result_page_take_named(document, NULL, house, table);
    } else {
        result_clear(&table);
    }
}

static void add_sets(Document *document, const RuleSets *sets, const Inspection *inspection) {
    document_add_heading(document, 2, "The rules");
    document_add_note(document,
                      "Only a source that was itself read is called read. Read second-hand is a page about the text, "
                      "known is from memory, assumed is ours: look the number up before you rely on it. This is no "
                      "legal advice.");
    result_page_take(document, NULL, result_rules_sets(inspection, sets));
    for (size_t s = 0; s < sets->count; s++)
        document_add_paragraph(document, document_text(document, "%s: %s", sets->sets[s].id, sets->sets[s].note));
}

Document rules_report_make(const House *house, const RuleSets *sets, const Inspection *inspection,
                           const Making *making) {
    Document document = document_begin(making->program);
    Scene scene = {0};
    const char *sentence = names_text(house, result_rules_sentence(inspection, &document.arena), &document.arena);
    document_add_title(&document, document_text(&document, "Rules report: %s", house_report_name(house)), sentence);
    document_add_paragraph(&document,
                           document_text(&document, "%s.", result_rules_counts(inspection, &document.arena)));
    if (*house->plan.note)
        document_add_note(&document, house->plan.note);
    report_basis_add_changes(&document, making);
    document_add_contents(&document);
    rules_scene_make(&scene, house, inspection, "", "");
    report_pictures_add(&document, &scene,
                        document_text(&document,
                                      "%s, seen from above, with what was measured. A tick: all rules pass; a cross: "
                                      "some fail. The chair that is stopped stands at its start.",
                                      house_report_name(house)),
                        document_text(&document, "Plan of %s. %s.", house_report_name(house), sentence));
    if (inspection->population)
        document_add_paragraph(
            &document,
            document_text(&document,
                          "Tried with %zu drivers of the population %s. Drivers through: whose chair can be driven "
                          "through the place, by its body alone. Out: who get out of the house, with errors of "
                          "steering. Touch there: whose fastest impact is there. A place stops chairs if one of the "
                          "plan's own is stopped there, or at least %.0f %% of the drivers (assumed). Grade: of the "
                          "tightest way there, and what is missing on each side to the next better one.",
                          inspection->driver_count, inspection->population, 100 * INSPECTION_REFUSED));
    document_add_heading(&document, 2, "Where chairs are stopped");
    ResultTable stops = result_rules_stops(inspection);
    if (!stops.record_count)
        document_add_paragraph(&document, "Nowhere: every chair in this house has a way out.");
    result_page_take_named(&document, NULL, house, stops);
    for (FindingGroup group = GROUP_LEGAL_IMPASSABLE; group <= GROUP_OPEN; group++)
        add_group(&document, house, inspection, group);
    add_sets(&document, sets, inspection);
    report_basis_add_making(&document, making, NULL, 0);
    report_basis_add_names(&document, house);
    return document;
}
