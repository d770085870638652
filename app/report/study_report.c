#include "report/study_report.h"

#include <string.h>

#include "base/memory.h"
#include "base/text.h"
#include "report/report_lines.h"
#include "result/page.h"
#include "result/study.h"
#include "result/study_grades.h"
#include "visual/study/study_plots.h"

/* Design points. */
#define PLOT_WIDTH 1027.0
#define PLOT_HEIGHT 500.0

/* The plots of a document, released with the last picture. */
typedef struct Shown {
    StudyPlots plots;
    size_t left;
} Shown;

typedef struct ShownPlot {
    Shown *shown;
    size_t index;
} ShownPlot;

static void paint_plot(const void *context, struct _cairo *cairo, Vec2 size, Theme theme) {
    const ShownPlot *one = context;
    plot_paint(&one->shown->plots.plots[one->index].plot, cairo, size, theme);
}

static void release_plot(void *context) {
    ShownPlot *one = context;
    if (--one->shown->left == 0) {
        study_plots_free(&one->shown->plots);
        memory_free(one->shown);
    }
    memory_free(one);
}

static void add_plots(Document *document, const StudyReport *report) {
    Shown *shown = memory_zeroed(1, sizeof *shown);
    shown->plots = study_plots_make(report->study, report->measured);
    shown->left = shown->plots.count;
    document_add_heading(document, 2, "Plots");
    for (size_t i = 0; i < shown->plots.count; i++) {
        const StudyPlot *one = &shown->plots.plots[i];
        ShownPlot *context = memory_zeroed(1, sizeof *context);
        *context = (ShownPlot){shown, i};
        const char *what = one->plot.title ? one->plot.title : one->plot.y.title ? one->plot.y.title : one->name;
        const char *caption = document_text(document, "%s%s%s.", what, one->plot.x.title ? " over " : "",
                                            one->plot.x.title ? one->plot.x.title : "");
        document_add_figures(document);
        document_add_picture(document, paint_plot, context, vec2(PLOT_WIDTH, PLOT_HEIGHT), caption, caption)->release =
            release_plot;
    }
    if (!shown->plots.count) {
        study_plots_free(&shown->plots);
        memory_free(shown);
        document_add_paragraph(document, "There is nothing to draw: no run was completed.");
    }
}

static void add_tables(Document *document, const Study *study) {
    ResultTable counts = result_study_counts(study);
    document_add_heading(document, 2, "Runs");
    result_page_list(document, NULL, (const ResultTable *const[]){&counts}, 1);
    result_clear(&counts);
    if (study->axis_count)
        result_page_take(document, "Ranges of equal answers along each parameter.", result_study_ranges(study));
    else if (study->runs > 1)
        result_page_take(document, "Distribution of each quantity over the runs.", result_study_distributions(study));
    result_page_take(document, "Worst grade of the ways out, over the values where all people are out.",
                     study_grades_ranges(study));
}

Document study_report_make(const StudyReport *report, const Making *making) {
    Document document = document_begin(making->program);
    size_t size = strlen(report->words) + 1;
    char *words = arena_allocate(&document.arena, size);
    memcpy(words, report->words, size);
    char *end = strstr(words, "\n\n");
    if (end)
        *end = '\0';
    char *more = words + strcspn(words, "\n");
    bool several = *more;
    *more = '\0';
    document_add_title(&document, document_text(&document, "Study of a %s", report->study->experiment->kind), words);
    report_lines_add(&document, several ? more + 1 : more);
    report_basis_add_changes(&document, making);
    document_add_contents(&document);
    add_plots(&document, report);
    add_tables(&document, report->study);
    if (report->add_numbers)
        report->add_numbers(&document, report->context);
    report_basis_add_making(&document, making, NULL, 0);
    return document;
}
