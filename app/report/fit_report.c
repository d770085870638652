#include "report/fit_report.h"

#include "plot/plot.h"
#include "result/fit.h"
#include "result/page.h"
#include "visual/study/fit_plots.h"

/* Design points. */
#define PLOT_WIDTH 498.0
#define PLOT_HEIGHT 280.0

/* A plot and what it points to. */
typedef struct Residuals {
    Plot plot;
    Arena arena;
} Residuals;

static void paint_residuals(const void *context, struct _cairo *cairo, Vec2 size, Theme theme) {
    plot_paint(&((const Residuals *)context)->plot, cairo, size, theme);
}

static void release_residuals(void *context) {
    Residuals *residuals = context;
    arena_clear(&residuals->arena);
    memory_free(residuals);
}

static void add_residuals(Document *document, const Fit *fit) {
    Residuals *residuals = memory_zeroed(1, sizeof *residuals);
    fit_plots_residuals(&residuals->plot, fit, &residuals->arena);
    residuals->plot.title = NULL; /* the heading says it */
    const char *caption = "Each measured value, in the order of the file or along the way: simulated minus observed, "
                          "before the fit and fitted, with lines at 2 standard deviations.";
    document_add_heading(document, 2, "Residuals");
    document_add_figures(document);
    document_add_picture(document, paint_residuals, residuals, vec2(PLOT_WIDTH, PLOT_HEIGHT), caption, caption)
        ->release = release_residuals;
}

Document fit_report_make(const Fit *fit, const Experiment *experiment, const char *file, const Making *making) {
    Document document = document_begin(making->program);
    size_t count;
    document_add_title(&document, document_text(&document, "Fit report: %s", file),
                       result_fit_sentence(fit, &document.arena));
    const char **remarks = result_fit_remarks(fit, &count, &document.arena);
    for (size_t i = 0; i < count; i++)
        document_add_paragraph(&document, document_text(&document, "%s.", remarks[i]));
    report_basis_add_changes(&document, making);
    document_add_heading(&document, 2, "What the data tell");
    document_add_paragraph(&document,
                           "Learned: 1 minus the square of the spread after the data by the one before. Below 0.3 the "
                           "data do not tell a parameter, and the value to be used is the one before. Spread: the "
                           "standard deviation of the logarithm.");
    result_page_take(&document, NULL, result_fit_unknowns(fit, experiment));
    ResultTable whole = result_fit_whole(fit);
    result_page_list(&document, NULL, (const ResultTable *const[]){&whole}, 1);
    result_clear(&whole);
    add_residuals(&document, fit);
    document_add_heading(&document, 2, "Measured values");
    result_page_take(&document, NULL, result_fit_rows(fit));
    report_basis_add_making(&document, making, NULL, 0);
    return document;
}
