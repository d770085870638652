#include "report/comparison_report.h"

#include <string.h>

#include "base/text.h"
#include "result/drivers.h"
#include "result/grade.h"
#include "result/house.h"
#include "result/page.h"
#include "visual/house/house_scene.h"
#include "result/headline.h"
#include "result/names.h"
#include "report/report_basis.h"
#include "report/report_motion.h"
#include "report/report_people.h"
#include "report/report_pictures.h"
#include "report/report_places.h"
#include "report/report_plans.h"

static const char *const names[] = {"A", "B", "B - A"};

/* The answer ------------------------------------------------------------------------------------------------------- */

static const char *format_answer(Document *document, const Reported runs[2]) {
    const Observation *a = runs[0].observation, *b = runs[1].observation;
    if (a->completed != b->completed)
        return b->completed ? "B lets all people out, A does not" : "A lets all people out, B does not";
    if (!a->completed)
        return "Neither A nor B lets all people out";
    double gain = headline_difference(b->time, a->time);
    if (fabs(gain) < 0.05)
        return document_text(document, "All people are out in %s in both",
                             headline_duration(a->time, &document->arena));
    return document_text(document,
                         gain > 0 ? "All people are out %s earlier in B: in %s instead of %s"
                                  : "All people are out %s later in B: in %s instead of %s",
                         headline_duration(fabs(gain), &document->arena), headline_duration(b->time, &document->arena),
                         headline_duration(a->time, &document->arena));
}

/* Adds the totals of both runs with their differences. */
static void add_answers(Document *document, const Reported runs[2]) {
    ResultTable totals[2];
    for (int r = 0; r < 2; r++)
        totals[r] = result_house_totals(runs[r].house, runs[r].observation);
    result_page_pair(document, names, &totals[0], &totals[1],
                     runs[0].observation->completed && runs[1].observation->completed);
    for (int r = 0; r < 2; r++)
        result_clear(&totals[r]);
}

/* Adds the grade of the way out, where all leave. */
static void add_grades(Document *document, const Reported runs[2], const PairedDrivers *drivers) {
    for (int r = 0; r < 2; r++) {
        const char *grade =
            drivers->letters[r] ? result_grade_phrase(runs[r].house, drivers->letters[r], &document->arena) : "";
        if (*grade)
            document_add_paragraph(document, document_text(document, "%s: %s.", names[r],
                                                           names_text(runs[r].house, grade, &document->arena)));
    }
}

static void add_pictures(Document *document, const Reported runs[2]) {
    Scene scenes[2];
    const char *captions[2];
    for (int r = 0; r < 2; r++) {
        const char *headline = names_text(
            runs[r].house, headline_sentence(runs[r].house, runs[r].observation, &document->arena), &document->arena);
        captions[r] = document_text(document, "%s: %s. %s.", names[r], house_report_name(runs[r].house), headline);
        Before before = {.house = r ? runs[0].house : NULL, .observation = r ? runs[0].observation : NULL};
        house_scene_make_small(&scenes[r], runs[r].house, runs[r].observation, before);
    }
    report_pictures_add_beside(document, scenes, 2, report_pictures_box(scenes[0].box, scenes[1].box), captions);
}

static void add_notes(Document *document, const Reported runs[2]) {
    bool same = strcmp(runs[0].house->plan.note, runs[1].house->plan.note) == 0;
    for (int r = 0; r < (same ? 1 : 2); r++)
        if (*runs[r].house->plan.note)
            document_add_note(document,
                              document_text(document, "%s: %s", same ? "A and B" : names[r], runs[r].house->plan.note));
}

/* People ----------------------------------------------------------------------------------------------------------- */

/* Adds two tables of the same kind with the differences; both are released. */
static void add_pair(Document *document, const char *caption, const House *house, ResultTable a, ResultTable b,
                     const char *succeeded, const char *alike) {
    ResultPair pair = {&a, &b, {names[0], names[1], names[2]}, succeeded, alike};
    ResultTable table = {0};
    result_compare(&table, &pair);
    result_page_take_named(document, caption, house, table);
    result_clear(&a);
    result_clear(&b);
}

static void add_people(Document *document, const Reported runs[2]) {
    add_pair(document, "Differences of times and clearances are given for people who are out of both houses.",
             runs[1].house, result_house_people(runs[0].house, runs[0].observation),
             result_house_people(runs[1].house, runs[1].observation), "completed", NULL);
}

static void add_parties(Document *document, const Reported runs[2], const Census census[2]) {
    add_pair(document, NULL, runs[1].house, result_house_parties(runs[0].house, &census[0], false),
             result_house_parties(runs[1].house, &census[1], false), "out", "profile");
}

static bool any_simulated(const ResultTable *routes) {
    for (size_t r = 0; r < routes->record_count; r++)
        if (isfinite(result_find(routes, r, "simulation")->number))
            return true;
    return false;
}

static void add_routes(Document *document, const Reported runs[2]) {
    ResultTable a = result_house_routes(runs[0].house, runs[0].observation),
                b = result_house_routes(runs[1].house, runs[1].observation);
    ResultPair pair = {&a, &b, {names[0], names[1], names[2]}, "simulation", NULL};
    if (any_simulated(&a) || any_simulated(&b))
        result_page_fact(document,
                         "Simulated times of the routes: mean of the people who take a route, if all of them "
                         "are out.",
                         &pair, "simulation");
    result_clear(&a);
    result_clear(&b);
}

/* Adds how the same drivers do in both houses. */
static void add_drivers(Document *document, const Reported runs[2], const PairedDrivers *drivers) {
    if (!drivers->of[0].count)
        return;
    const House houses[2] = {*runs[0].house, *runs[1].house};
    document_add_heading(document, 2, "The same drivers in both");
    document_add_paragraph(
        document,
        document_text(document,
                      "%zu drivers of the population %s (%s) take the same starts in A and B. The answer above is that "
                      "of the nominal driver alone. Differences of times are of the drivers who get out of both.",
                      drivers->of[0].count, drivers->population->id, drivers->population->title));
    Text said = {0};
    result_drivers_paired_say(&said, houses, drivers->of);
    report_drivers_take_lines(document, runs[1].house, &said);
    result_page_take_named(document, NULL, runs[1].house, result_drivers_paired(houses, drivers->of));
}

/* The rest --------------------------------------------------------------------------------------------------------- */

static void add_hazards(Document *document, const Reported runs[2]) {
    document_add_heading(document, 2, "Tight places");
    for (int r = 0; r < 2; r++)
        if (runs[r].observation->hazard_count)
            report_places_add_table(
                document, runs[r].house, runs[r].observation,
                document_text(document, "%s: %s, by the time lost", names[r], house_report_name(runs[r].house)));
        else
            document_add_paragraph(
                document,
                document_text(document, "%s: %s.", names[r],
                              runs[r].observation->time > 0 ? "none" : "none is known, since nobody could start"));
}

static bool same_numbers(const Profile *a, const Profile *b) {
    bool same = a->driving == b->driving;
    for (size_t i = 0; i < profile_table()->count && same; i++) {
        const Parameter *row = &profile_table()->rows[i];
        same = *(const double *)((const char *)a + row->offset) == *(const double *)((const char *)b + row->offset);
    }
    return same;
}

static bool is_in(const House *house, const Profile *profile) {
    for (size_t p = 0; p < house->profile_count; p++)
        if (strcmp(house->profiles[p].name, profile->name) == 0 && same_numbers(&house->profiles[p], profile))
            return true;
    return false;
}

/* Lists the common inputs once. */
static void add_basis(Document *document, const Reported runs[2]) {
    document_add_heading(document, 2, "What the model assumes");
    report_basis_add_method(document, runs[0].house, false);
    report_basis_add_settings(document, runs[0].house);
    for (size_t p = 0; p < runs[0].house->profile_count; p++)
        report_basis_add_profile(document, runs[0].house, &runs[0].house->profiles[p]);
    for (size_t p = 0; p < runs[1].house->profile_count; p++)
        if (!is_in(runs[0].house, &runs[1].house->profiles[p]))
            report_basis_add_profile(document, runs[1].house, &runs[1].house->profiles[p]);
}

Document comparison_report_make(const Reported runs[2], const PairedDrivers *drivers, const Making *making) {
    Census census[2];
    Document document = document_begin(making->program);
    for (int r = 0; r < 2; r++)
        census[r] = census_make(runs[r].house, runs[r].observation);
    document_add_title(&document,
                       document_text(&document, "Comparison of A, %s, and B, %s", house_report_name(runs[0].house),
                                     house_report_name(runs[1].house)),
                       format_answer(&document, runs));
    add_pictures(&document, runs);
    add_grades(&document, runs, drivers);
    add_answers(&document, runs);
    add_notes(&document, runs);
    report_basis_add_changes(&document, making);
    document_add_contents(&document);
    report_plans_add(&document, &runs[0].house->plan, &runs[1].house->plan);
    document_add_heading(&document, 2, "Who is out");
    if (census[0].people > CENSUS_ROWS)
        add_parties(&document, runs, census);
    else
        add_people(&document, runs);
    add_routes(&document, runs);
    add_drivers(&document, runs, drivers);
    add_hazards(&document, runs);
    if (runs[1].observation->time > 0) {
        document_add_heading(&document, 2, "Motion in B, and in A before");
        report_motion_add_curves(&document, &runs[1], &runs[0]);
    }
    add_basis(&document, runs);
    report_basis_add_making(&document, making, runs, 2);
    for (int r = 0; r < 2; r++)
        census_clear(&census[r]);
    return document;
}
