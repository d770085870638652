#include "report/crank_paper_report.h"

#include <string.h>

#include "base/memory.h"
#include "base/text.h"
#include "report/crank_figures.h"
#include "report/report_lines.h"
#include "result/advice.h"
#include "result/crank.h"
#include "result/page.h"
#include "result/paper.h"
#include "result/verdict.h"

/* Adds a type with its words, picture and plots. */
static void add_type(Document *document, const CrankPaper *paper, size_t i) {
    const Crank *crank = &paper->cranks[i];
    const Response *response = &paper->responses[i];
    Text text = {0};
    document_add_heading(document, 2,
                         document_text(document, "Type %s: %.0f rpm, clearance %g mm",
                                       types_kind_name(paper->types[i].kind), 60 * crank->frequency,
                                       1000 * crank->clearance));
    advice_write(&text, &paper->types[i], &paper->experiments[i], 0); /* its first line is of the window itself */
    report_lines_add(document, document_text(document, "%.*s", (int)strcspn(text.text, "\n"), text.text));
    memory_free(text.text);
    text = (Text){0};
    result_crank_name(&text, crank, response, crank_cycle_ideal_force(crank, NULL));
    result_verdict_say(&text, response, "revolution");
    result_crank_say(&text, crank, &paper->trees[i], response);
    report_lines_add(document, text.text);
    memory_free(text.text);
    if (!crank_figures_add_moment(document, crank, &paper->trees[i], response,
                                  "The moment of the largest force; bending and the support's motion are magnified."))
        return;
    document_add_figures(document);
    crank_figures_add_plot(document, crank, response, "angle", "Force in the joint over the crank angle.");
    crank_figures_add_plot(document, crank, response, "phase",
                           "Phase plane of the ball in its socket, along the coupler.");
}

Document crank_paper_report_make(CrankPaper *paper, const Making *making) {
    PaperClaim claims[CRANK_PAPER_CLAIMS];
    crank_paper_claims(paper, claims);
    Document document = document_begin(making->program);
    document_add_title(
        &document,
        document_text(&document, "The paper and the crank: %s", *paper->crank.name ? paper->crank.name : paper->path),
        result_paper_summary(claims, CRANK_PAPER_CLAIMS, &document.arena));
    document_add_paragraph(
        &document,
        "Gu and Dubowsky, \u201cChaotic Vibration and Design Criteria for Machine Systems with Clearance "
        "Connections\u201d, Ninth World Congress on the Theory of Machines and Mechanisms, Milan 1995. Of its second "
        "machine, a spatial slider crank, it says that it shows types I, II and III. None of its dimensions is "
        "published: the machine here is another one, and shows that the claim holds for a slider crank with such a "
        "joint, not that it is that machine.");
    if (*paper->crank.note)
        document_add_note(&document, paper->crank.note);
    report_basis_add_changes(&document, making);
    document_add_contents(&document);
    document_add_heading(&document, 2, "Claims");
    result_page_take(&document, NULL, result_paper_claims(claims, CRANK_PAPER_CLAIMS));
    for (size_t i = 0; i < CRANK_PAPER_CLAIMS; i++)
        add_type(&document, paper, i);
    report_lines_add_numbers(&document, crank_table(), &paper->crank, paper->crank.provenance);
    report_basis_add_making(&document, making, NULL, 0);
    return document;
}
