#include "report/paper_report.h"

#include "base/memory.h"
#include "base/text.h"
#include "report/report_lines.h"
#include "result/page.h"
#include "result/paper.h"

/* Design points of a figure. */
#define FIGURE_WIDTH 1027.0
#define FIGURE_HEIGHT 560.0

static const char *name_of(const Paper *paper) {
    return *paper->beam.name ? paper->beam.name : paper->path;
}

static void add_basis(Document *document, const Paper *paper, const Making *making) {
    document_add_paragraph(
        document,
        "Gu and Dubowsky, \u201cChaotic Vibration and Design Criteria for Machine Systems with Clearance "
        "Connections\u201d, Ninth World Congress on the Theory of Machines and Mechanisms, Milan 1995. Of what "
        "survives "
        "of it, every digit 0, every capital T and all figures are lost: the paper's numbers here are as they can be "
        "read or were reconstructed, and which of figures 3 to 6 showed what is not known.");
    document_add_paragraph(
        document,
        document_text(
            document,
            "A motion is called chaotic by what it did in %d cycles or more after a transient of %d. The single "
            "runs are confirmed by %d motions that were started on them and watched for %d cycles each; "
            "orbit diagrams, map and types are not, and what is chaotic there may still settle later.",
            BEAM_CYCLES_LEAST, paper->beam.transient_cycles, SURVIVAL_LANES, SURVIVAL_CYCLES));
    if (*paper->beam.note)
        document_add_note(document, paper->beam.note);
    report_basis_add_changes(document, making);
    document_add_contents(document);
}

static void add_claims(Document *document, const PaperClaim *claims) {
    document_add_heading(document, 2, "Claims");
    result_page_take(document, NULL, result_paper_claims(claims, PAPER_CLAIMS));
}

/* How long each motion lasts, and how many cycles its largest peak takes. */
static void add_runs(Document *document, const Paper *paper) {
    document_add_heading(document, 2, "How many cycles");
    document_add_paragraph(
        document, "The paper found no measure of how long such a motion must be watched. Of each single run whose "
                  "motion is not periodic, this is how long it lasts, and how large its peaks become:");
    for (PaperRun i = 0; i < PAPER_RUNS; i++) {
        Text text = {0};
        result_paper_say_run(&text, paper, i);
        report_lines_add(document, text.text);
        memory_free(text.text);
    }
}

static void paint_figure(const void *context, struct _cairo *cairo, Vec2 size, Theme theme) {
    plot_paint(context, cairo, size, theme);
}

static void add_figures(Document *document, const PaperFigures *figures) {
    document_add_heading(document, 2, "Figures");
    for (size_t i = 0; i < PAPER_FIGURES; i++) {
        const PaperFigure *figure = &figures->figures[i];
        if (!figure->plot)
            continue;
        const char *caption = document_text(document, "%s. %s", figure->title, figure->caption);
        document_add_figures(document);
        document_add_picture(document, paint_figure, (void *)figure->plot, vec2(FIGURE_WIDTH, FIGURE_HEIGHT), caption,
                             caption);
    }
}

static void add_types(Document *document, const Paper *paper) {
    document_add_heading(document, 2, "Types over the frequency");
    document_add_paragraph(document,
                           "I: one periodic motion from all starts, whose peak force does not change steeply; II: "
                           "periodic, but steep, or one of several motions; III: somewhere within 1 % not periodic.");
    result_page_take(document, NULL, result_paper_types(paper));
}

Document paper_report_make(Paper *paper, PaperFigures *figures, const Making *making) {
    PaperClaim claims[PAPER_CLAIMS];
    paper_claims(paper, claims);
    Document document = document_begin(making->program);
    document_add_title(&document, document_text(&document, "The paper and the beam: %s", name_of(paper)),
                       result_paper_summary(claims, PAPER_CLAIMS, &document.arena));
    add_basis(&document, paper, making);
    add_claims(&document, claims);
    add_runs(&document, paper);
    add_figures(&document, figures);
    add_types(&document, paper);
    report_lines_add_numbers(&document, beam_table(), &paper->beam, paper->beam.provenance);
    report_basis_add_making(&document, making, NULL, 0);
    return document;
}
