#include "report/report_drivers.h"

#include <string.h>

#include "report/report_pictures.h"
#include "result/names.h"
#include "result/check.h"
#include "result/danger.h"
#include "result/drivers.h"
#include "result/page.h"
#include "visual/house/drivers_band.h"
#include "visual/house/drivers_plots.h"
#include "visual/house/drivers_scene.h"
#include "visual/house/grades_scene.h"
#include "visual/house/plan_picture.h"
#include "visual/house/plan_scene.h"

/* Design points. */
#define PLOT_WIDTH 498.0
#define PLOT_HEIGHT 280.0

enum { PLOTTED_MOST = 8 /* people with plots */ };

static void paint_plot(const void *context, struct _cairo *cairo, Vec2 size, Theme theme) {
    plot_paint(&((const DriversPlot *)context)->plot, cairo, size, theme);
}

static void release_plot(void *context) {
    drivers_plot_free(context);
    memory_free(context);
}

static void add_plot(Document *document, DriversPlotKind kind, const Reported *run, const Drivers *drivers,
                     size_t person) {
    static const char *const captions[DRIVERS_PLOTS] = {
        "%s: share of the drivers who are out by a time, a dot for each; with the nominal driver and, where the route "
        "was measured, the mean and deviation of those runs.",
        "%s: speed along the nominal driver's way; 5 to 95 % and 25 to 75 % of the drivers, and the nominal one.",
    };
    DriversPlot *plot = memory_zeroed(1, sizeof *plot);
    *plot = drivers_plot_make(kind, run->house, run->observation, drivers, person);
    Text caption = {0};
    const char *gap = strstr(captions[kind], "%s");
    text_format(&caption, "%s%s", names_person(run->house, person, &document->arena), gap + 2);
    const char *text = document_text(document, "%s", caption.text);
    memory_free(caption.text);
    document_add_picture(document, paint_plot, plot, vec2(PLOT_WIDTH, PLOT_HEIGHT), text, text)->release = release_plot;
}

static bool is_varied(const Drivers *drivers, size_t person) {
    for (size_t k = 0; k < drivers->count; k++)
        if (drivers->runs[k * drivers->person_count + person].varies)
            return true;
    return false;
}

static void add_plots(Document *document, const Reported *run, const Drivers *drivers) {
    int plotted = 0;
    for (size_t i = 0; i < drivers->person_count && plotted < PLOTTED_MOST; i++) {
        if (!is_varied(drivers, i))
            continue;
        plotted++;
        document_add_figures(document);
        for (DriversPlotKind kind = 0; kind < DRIVERS_PLOTS; kind++)
            add_plot(document, kind, run, drivers, i);
    }
}

void report_drivers_take_lines(Document *document, const House *house, Text *text) {
    for (char *at = text->text, *end; at && *at; at = end + 1) {
        end = strchr(at, '\n');
        const char *line = document_text(document, "%.*s.", (int)(end - at), at);
        document_add_paragraph(document, names_text(house, line, &document->arena));
    }
    memory_free(text->text);
    *text = (Text){0};
}

static void add_sentences(Document *document, const Reported *run, const Drivers *drivers) {
    Text text = {0};
    result_drivers_say(&text, run->house, run->observation, drivers);
    report_drivers_take_lines(document, run->house, &text);
}

static void add_plan(Document *document, const char *name, const Reported *run, const ReportedDrivers *of) {
    const Drivers *drivers = of->drivers;
    Scene scene = {0};
    plan_picture_bare(&scene, run->house);
    drivers_band_add(&scene, drivers, &run->observation->trace);
    drivers_scene_add(&scene, run->house, drivers);
    if (of->grades)
        grades_scene_add(&scene, run->house, of->grades);
    plan_scene_tags(&scene, run->house, NULL);
    plan_scene_names(&scene, run->house);
    const char *caption = document_text(
        document,
        "%s with the paths of %zu drivers: the dark band holds half of them, the dashed outline 9 of 10. Discs: places "
        "where drivers touch something, by area the share of them, by shade the fastest impact, by letter the part of "
        "the chair (F front, S side, T tail). Dashed rings (H): the same of hands at the rims that meet something.",
        name, drivers->count);
    report_pictures_add(document, &scene, caption, caption);
}

/* Adds where and how hard the run, or its drivers, touch something, beside limits with their sources. */
static void add_danger(Document *document, const Reported *run, const Drivers *drivers) {
    const House *house = run->house;
    ResultTable places = result_danger_places(house, run->observation, drivers);
    if (!places.record_count) {
        result_clear(&places);
        return;
    }
    size_t first = house_find_person(house, result_find(&places, 0, "id")->text);
    double mass = house->people[first].profile->mass;
    document_add_heading(document, 2, "How hard the touches are");
    document_add_paragraph(
        document,
        document_text(
            document,
            "Worst first: by the energy that a run is expected to have there, then by the share of drivers, "
            "then by the speed that 95 %% of them stay below. Below %.1f m/s a touch, from there a knock, from "
            "%.1f m/s a blow (assumed). The energy is that of the effective mass: what a chair that cannot "
            "slip sideways opposes at that point. Squeeze is the greatest mean force over %.1f s. Hands stand "
            "last: something comes between a rim and what it passes, at the speed of the chair. Where the "
            "plan leaves less room than the hands take, the law has the arms tucked in, and who does that is "
            "not caught.",
            DANGER_KNOCK, DANGER_BLOW, OBSERVATION_SQUEEZE));
    result_page_take_named(document, NULL, house, places);
    document_add_heading(document, 3, "What a clamped part of the body bears");
    result_page_take(document, NULL, result_danger_limits(mass));
    document_add_paragraph(document,
                           document_text(document,
                                         "The speeds are those at which a chair of %.0f kg reaches the limits, F / "
                                         "sqrt(m k). %s",
                                         mass, danger_caveat));
}

void report_drivers_add(Document *document, const char *name, const Reported *run, const ReportedDrivers *of) {
    const House *house = run->house;
    if (of->drivers && of->drivers->count) {
        document_add_heading(document, 2, document_text(document, "%zu drivers", of->drivers->count));
        document_add_paragraph(document, document_text(document, "Of the population %s: %s. %s", of->population->id,
                                                       of->population->title, of->population->note));
        add_sentences(document, run, of->drivers);
        result_page_take_named(document, NULL, house, result_drivers_table(house, run->observation, of->drivers));
        ResultTable routes = result_drivers_routes(house, of->drivers);
        if (routes.record_count)
            document_add_heading(document, 3, "Measured and simulated times");
        result_page_take(document, NULL, routes);
        ResultTable measured = result_drivers_measured(house, of->drivers);
        if (measured.record_count)
            document_add_heading(document, 3, "Single measured runs");
        result_page_take(
            document,
            "Deviation of one person and between people: of the measured times, by one-way random effects; "
            "the simulated drivers are each another person.",
            measured);
        add_plan(document, name, run, of);
        add_plots(document, run, of->drivers);
    }
    add_danger(document, run, of->drivers);
    if (!of->grades)
        return;
    ResultTable grades = result_check_grades(house, of->grades);
    if (grades.record_count) {
        document_add_heading(document, 2, "How tight the ways are");
        document_add_paragraph(document, "The body is grown all round until no way is left: that growth is the room to "
                                         "spare. It does not depend on the quickest way, and the limits of the grades, "
                                         "A (easy) to F (impossible), are assumed.");
    }
    result_page_take_named(document, NULL, house, grades);
    Text contradictions = {0};
    result_drivers_say_grades(&contradictions, house, of->drivers, of->grades);
    report_drivers_take_lines(document, house, &contradictions);
    ResultTable places = result_check_grade_places(house, of->grades);
    if (places.record_count)
        document_add_paragraph(document,
                               "Places that stand between a way and a better grade, each with the least change "
                               "that buys that grade here while the other places are eased. Walls are not "
                               "moved: where none helps, nothing beyond is listed.");
    result_page_take_named(document, NULL, house, places);
}
