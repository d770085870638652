#include "report/shake_report.h"

#include "visual/house/shake_plots.h"
#include "visual/house/shake_scene.h"
#include "report/house_report.h"
#include "report/report_pictures.h"
#include "result/page.h"
#include "result/shake.h"

/* Design points. */
#define CURVE_WIDTH 1027.0
#define CURVE_HEIGHT 420.0

/* A plot with what it shows. */
typedef struct Curve {
    Plot plot;
    Arena arena;
} Curve;

static void paint_curve(const void *context, struct _cairo *cairo, Vec2 size, Theme theme) {
    plot_paint(&((const Curve *)context)->plot, cairo, size, theme);
}

static void release_curve(void *context) {
    arena_clear(&((Curve *)context)->arena);
    memory_free(context);
}

/* Adds the answer above the picture. */
static void add_answer(Document *document, const ShakeFindings *findings, const Making *making) {
    ResultTable answer = result_shake_answer(findings), stops = result_shake_stops(findings);
    if (!findings->shakes)
        document_add_paragraph(document, "No shake was simulated to its end.");
    else
        result_page_list(document,
                         document_text(document,
                                       "%s. 95 %% confidence: the interval of the share above it, from the number of "
                                       "shakes. Times include movement only, not the shake, alarm and the transfer "
                                       "into the chair. People caught under furniture count as not out.",
                                       result_shake_simulated(findings, &document->arena)),
                         (const ResultTable *const[]){&answer, &stops}, 2);
    result_clear(&answer);
    result_clear(&stops);
    if (*findings->house->plan.note)
        document_add_note(document, findings->house->plan.note);
    report_basis_add_changes(document, making);
    document_add_contents(document);
    Scene scene;
    shake_scene_make(&scene, findings);
    report_pictures_add(
        document, &scene,
        document_text(document,
                      "%s, seen from above, before a shake. Dashed: where furniture would "
                      "fall. In colour: furniture that stops people, with the share of shakes in which it does.",
                      house_report_name(findings->house)),
        document_text(document, "Plan of %s with the furniture that stops people after a shake.",
                      house_report_name(findings->house)));
}

static void add_people(Document *document, const ShakeFindings *findings) {
    document_add_heading(document, 2, "Who is out");
    result_page_take_named(
        document,
        "Out in: shakes in which the person is out, of a crowd all of it. Times: of those shakes. 95 % confidence: "
        "the interval of the share, from the number of shakes.",
        findings->house, result_shake_people(findings));
}

static void add_times(Document *document, const ShakeFindings *findings) {
    Curve *curve = memory_zeroed(1, sizeof *curve);
    if (!shake_plots_times(&curve->plot, findings, &curve->arena)) {
        release_curve(curve);
        return;
    }
    document_add_heading(document, 2, "How long it takes");
    document_add_figures(document);
    document_add_picture(document, paint_curve, curve, vec2(CURVE_WIDTH, CURVE_HEIGHT),
                         "Share of shakes in which they are out within a time. Where a curve ends below 100 %, the "
                         "others are not out.",
                         "A curve that rises with time.")
        ->release = release_curve;
}

static void add_pieces(Document *document, const ShakeFindings *findings) {
    document_add_heading(document, 2, "What stops people");
    if (!findings->piece_count) {
        document_add_paragraph(document, "Nothing in this house can fall.");
        return;
    }
    result_page_take(
        document,
        "Probability: of falling, as the house's file has it. Stops people: it has fallen next to the place where "
        "they stick, or on them. Falls, not all out: shakes, whether it was in the way or not.",
        result_shake_furniture(findings));
}

static void add_assumptions(Document *document, const ShakeFindings *findings, const Making *making) {
    const House *house = findings->house;
    document_add_heading(document, 2, "What the model assumes");
    if (*house->plan.note)
        document_add_note(document, house->plan.note);
    document_add_paragraph(document,
                           "In each shake every piece of furniture that can fall does so with its own "
                           "probability, independently of the others, before anybody moves. It then lies on its "
                           "face and covers as much floor in front of it as it was high; it does not slide, "
                           "bounce or break. Walls, doors and exits stay unchanged. People know the positions of"
                           " the fallen furniture and re-plan their routes.");
    report_basis_add_method(document, house, false);
    report_basis_add_settings(document, house);
    for (size_t p = 0; p < house->profile_count; p++)
        report_basis_add_profile(document, house, &house->profiles[p]);
    report_basis_add_making(document, making, NULL, 0);
}

Document shake_report_make(const ShakeFindings *findings, const Making *making) {
    Document document = document_begin(making->program);
    const char *headline = shake_findings_headline(findings, &document.arena);
    document_add_title(&document, document_text(&document, "Earthquake report: %s", house_report_name(findings->house)),
                       headline);
    add_answer(&document, findings, making);
    add_people(&document, findings);
    add_times(&document, findings);
    add_pieces(&document, findings);
    add_assumptions(&document, findings, making);
    return document;
}
