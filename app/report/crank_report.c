#include "report/crank_report.h"

#include <inttypes.h>
#include <string.h>

#include "base/memory.h"
#include "base/text.h"
#include "report/crank_figures.h"
#include "report/report_lines.h"
#include "result/crank.h"
#include "result/page.h"
#include "result/verdict.h"

static void add_answer(Document *document, const CrankReport *report, const Making *making) {
    Text text = {0};
    result_verdict_say(&text, report->response, "revolution");
    result_crank_say(&text, report->crank, report->tree, report->response);
    report_lines_add(document, text.text);
    memory_free(text.text);
    document_add_note(document, crank_is_assumed(report->crank)
                                    ? "Every number of this mechanism is assumed; see the table of its numbers."
                                    : "Not all numbers of this mechanism are measured; see the table of its numbers.");
    if (*report->crank->note)
        document_add_note(document, report->crank->note);
    report_basis_add_changes(document, making);
    document_add_contents(document);
}

static void add_picture(Document *document, const CrankReport *report) {
    crank_figures_add_moment(document, report->crank, report->tree, report->response,
                             "The moment of the largest force in the recorded revolutions; bending and the support's "
                             "motion are magnified. In the loupe the path of the ball in its socket, below it the "
                             "force over the crank angle.");
}

static void add_plots(Document *document, const CrankReport *report) {
    static const struct {
        const char *name, *caption;
    } shown[] = {
        {"force", "Force in the joint against time."},
        {"angle", "Force in the joint over the crank angle, the last revolutions one over the other."},
        {"phase", "Phase plane: place and velocity of the ball in its socket, along the coupler."},
        {"poincare", "Poincar\u00e9 section: the same once a revolution, at angle 0."},
        {"across", "Path of the ball in its socket, seen along the coupler."},
        {"slider", "Error of the slider: its place beside that of the ideal mechanism."},
        {"spectrum", "Spectrum of the force, with the frequencies of bending and supports."},
    };
    document_add_heading(document, 2, "Plots");
    for (size_t p = 0; p < sizeof shown / sizeof *shown; p++) {
        if (p % 2 == 0)
            document_add_figures(document);
        crank_figures_add_plot(document, report->crank, report->response, shown[p].name, shown[p].caption);
    }
}

static void add_facts(Document *document, const CrankReport *report) {
    ResultTable motion = result_crank_motion(report->crank, report->response),
                forces = result_crank_forces(report->tree, report->response, report->ideal);
    document_add_heading(document, 2, "Results");
    result_page_list(document, NULL, (const ResultTable *const[]){&motion, &forces}, 2);
    result_clear(&motion);
    result_clear(&forces);
}

static void add_method(Document *document) {
    document_add_heading(document, 2, "Method");
    document_add_paragraph(
        document,
        "Slider, universal joint and elastic coupler are an open tree, closed by the force of the joint at the "
        "clearance: ordinary differential equations without multipliers. The coupler bends in its natural modes and "
        "stretches; bending shortens it. In contact the force is a spring and a damper, and the joint never pulls. "
        "Steps are Dormand and Prince's of order 8, from switch to switch; each switch is located until the force is "
        "known to 1e-9 N.");
    document_add_paragraph(
        document,
        document_text(
            document,
            "Periodic: Newton's iteration has found a stable orbit, whose largest multiplier is below 1. "
            "Chaotic: the largest Lyapunov exponent is above 0 by three standard errors, K of the 0-1 test "
            "is above %.1f, and of the motions that were started on it and watched none settled. Transient: "
            "one that was chaotic for %d revolutions or more before it settled on a stable orbit, or on which "
            "motions were started that settled.",
            RESPONSE_ZERO_ONE_LEAST, RESPONSE_TRANSIENT_LEAST));
}

Document crank_report_make(const CrankReport *report, const Making *making) {
    Document document = document_begin(making->program);
    const Crank *crank = report->crank;
    Text title = {0};
    result_crank_name(&title, crank, report->response, report->ideal);
    document_add_title(&document,
                       document_text(&document, "Slider crank: %s", *crank->name ? crank->name : report->path),
                       document_text(&document, "%.*s", (int)strcspn(title.text, "\n"), title.text));
    memory_free(title.text);
    add_answer(&document, report, making);
    add_picture(&document, report);
    add_plots(&document, report);
    add_facts(&document, report);
    add_method(&document);
    report_lines_add_numbers(&document, crank_table(), crank, crank->provenance);
    report_basis_add_making(&document, making, NULL, 0);
    document_add_paragraph(
        &document, document_text(&document, "Digest of the recorded states: %016" PRIx64, report->response->digest));
    return document;
}
