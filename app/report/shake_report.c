#include "report/shake_report.h"

#include <ctype.h>
#include <inttypes.h>
#include <math.h>

#include "visual/house/shake_plots.h"
#include "visual/house/shake_scene.h"
#include "report/house_report.h"
#include "report/report_people.h"
#include "report/report_pictures.h"

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

static const char *per_cent(Document *document, double share) {
    return isfinite(share) ? document_text(document, "%.1f %%", 100 * share) : NULL;
}

static const char *between(Document *document, const Share *share) {
    return isfinite(share->low) ? document_text(document, "%.0f to %.0f %%", 100 * share->low, 100 * share->high)
                                : NULL;
}

/* Adds the answer again above the picture, with its confidence interval. */
static void add_answer(Document *document, const ShakeFindings *findings, const Making *making) {
    const char *times = shake_findings_times(findings, &document->arena);
    const Share *share = &findings->everybody;
    const char *answer = "No shake was simulated to its end.";
    if (findings->shakes)
        answer = document_text(document,
                               "%zu shakes were simulated, with seeds from %" PRIu64 " on. Everybody gets out in "
                               "%.1f %% of them, with 95 %% confidence in %.0f to %.0f %%.",
                               findings->shakes, findings->study->seed, 100 * share->value, 100 * share->low,
                               100 * share->high);
    document_add_paragraph(document, answer);
    if (*times)
        document_add_paragraph(document, document_text(document,
                                                       "%c%s. Times include movement only, not the shake, alarm "
                                                       "and the transfer into the chair.",
                                                       toupper((unsigned char)*times), times + 1));
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
    static const Column columns[] = {
        {"Person", ALIGN_LEFT},     {"Profile", ALIGN_LEFT},          {"People", ALIGN_RIGHT},
        {"Out in", ALIGN_RIGHT},    {"95 % confidence", ALIGN_RIGHT}, {"25 % within, s", ALIGN_RIGHT},
        {"Median, s", ALIGN_RIGHT}, {"75 % within, s", ALIGN_RIGHT},  {"95 % within, s", ALIGN_RIGHT}};
    document_add_heading(document, 2, "Who is out");
    document_add_table(document,
                       "Out in: shakes in which the person gets out, of a crowd all of it. Times: of those shakes. "
                       "95 % confidence: the interval of the share, from the number of shakes.",
                       columns, sizeof columns / sizeof *columns);
    for (size_t p = 0; p < findings->party_count; p++) {
        const ShakeParty *party = &findings->parties[p];
        const char *cells[] = {party->id,
                               party->profile,
                               document_text(document, "%zu", party->people),
                               per_cent(document, party->out.value),
                               between(document, &party->out),
                               report_people_number(document, party->time.quarters[0], 1),
                               report_people_number(document, party->time.median, 1),
                               report_people_number(document, party->time.quarters[1], 1),
                               report_people_number(document, party->time.high, 1)};
        document_add_row(document, cells);
    }
    if (findings->caught.good)
        document_add_paragraph(document,
                               document_text(document,
                                             "Shakes in which furniture falls on somebody: %zu. People caught "
                                             "under furniture count as not out.",
                                             findings->caught.good));
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
                         "others do not get out.",
                         "A curve that rises with time.")
        ->release = release_curve;
}

static void add_pieces(Document *document, const ShakeFindings *findings) {
    static const Column columns[] = {{"Furniture", ALIGN_LEFT},        {"Probability", ALIGN_RIGHT},
                                     {"Falls in", ALIGN_RIGHT},        {"Stops somebody in", ALIGN_RIGHT},
                                     {"95 % confidence", ALIGN_RIGHT}, {"Fell and not all out", ALIGN_RIGHT}};
    document_add_heading(document, 2, "What stops people");
    if (!findings->piece_count) {
        document_add_paragraph(document, "Nothing in this house can fall.");
        return;
    }
    document_add_table(document,
                       "Probability: of falling, as the house's file has it. Stops somebody: it has fallen next to the "
                       "place where they stick, or on them. Fell and not all out: shakes, whether it was in the way or "
                       "not.",
                       columns, sizeof columns / sizeof *columns);
    for (size_t p = 0; p < findings->piece_count; p++) {
        const ShakePiece *piece = &findings->pieces[p];
        const Furniture *furniture = &findings->house->plan.furniture[piece->index];
        char name[96];
        outline_name(&findings->house->plan, OWNER_FURNITURE, (int)piece->index, name, sizeof name);
        const char *cells[] = {document_text(document, "%s", name),
                               document_text(document, "%g", furniture->probability),
                               per_cent(document, (double)piece->toppled / (double)findings->shakes),
                               per_cent(document, piece->stops.value),
                               between(document, &piece->stops),
                               document_text(document, "%zu", piece->with_loss)};
        document_add_row(document, cells);
    }
    if (findings->elsewhere.good)
        document_add_paragraph(
            document, document_text(document, "Shakes in which a wall, a door or other people stop somebody: %zu.",
                                    findings->elsewhere.good));
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
