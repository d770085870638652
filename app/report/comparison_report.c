#include "report/comparison_report.h"

#include <string.h>

#include "plan/plan_tables.h"
#include "visual/house/census.h"
#include "visual/house/house_scene.h"
#include "visual/house/headline.h"
#include "report/report_basis.h"
#include "report/report_motion.h"
#include "report/report_people.h"
#include "report/report_pictures.h"
#include "report/report_places.h"
#include "report/report_plans.h"

static const char *const style[] = {"A", "B"};

/* The answer --------------------------------------------------------------------------------------------------------*/

static const char *format_answer(Document *document, const Reported runs[2]) {
    const Observation *a = runs[0].observation, *b = runs[1].observation;
    if (a->completed != b->completed)
        return document_text(document, "%s lets everybody out, %s does not", style[b->completed], style[a->completed]);
    if (!a->completed)
        return "Neither A nor B lets everybody out";
    double gain = a->time - b->time;
    if (fabs(gain) < 0.05)
        return document_text(document, "Everybody is out in %.1f s in both", a->time);
    return document_text(document, "Everybody is out %.1f s %s in B: in %.1f s instead of %.1f s", fabs(gain),
                         gain > 0 ? "earlier" : "later", b->time, a->time);
}

static const char *difference(Document *document, double a, double b, int digits) {
    if (!isfinite(a) || !isfinite(b))
        return NULL;
    bool same = fabs(b - a) < 0.5 * pow(10, -digits);
    return same ? "0" : document_text(document, "%+.*f", digits, b - a);
}

static void add_numbers(Document *document, const char *what, double a, double b, int digits, bool comparable) {
    const char *cells[] = {what, report_people_number(document, a, digits), report_people_number(document, b, digits),
                           comparable ? difference(document, a, b, digits) : NULL};
    document_add_row(document, cells);
}

static double narrowest(const Observation *observation) {
    double least = HUGE_VAL;
    for (size_t i = 0; i < observation->person_count; i++)
        if (observation->people[i].took_part && observation->people[i].time > 0)
            least = fmin(least, observation->people[i].narrowest);
    return least;
}

/* Adds the times and clearances with their differences: these need a person who gets out of both houses. Nothing is
 * known of people who never started. */
static void add_answers(Document *document, const Reported runs[2], const Census census[2]) {
    static const Column columns[] = {{"", ALIGN_LEFT}, {"A", ALIGN_RIGHT}, {"B", ALIGN_RIGHT}, {"B - A", ALIGN_RIGHT}};
    bool both = runs[0].observation->completed && runs[1].observation->completed;
    double last[2], contacts[2], hardest[2], dangers[2];
    for (int r = 0; r < 2; r++) {
        bool moved = runs[r].observation->time > 0;
        last[r] = census[r].out ? census[r].last : NAN;
        contacts[r] = moved ? census[r].contacts : NAN;
        hardest[r] = census[r].contacts ? census[r].peak_force : NAN;
        dangers[r] = moved ? (double)runs[r].observation->hazard_count : NAN;
    }
    document_add_table(document, NULL, columns, 4);
    add_numbers(document, "People", (double)census[0].people, (double)census[1].people, 0, true);
    add_numbers(document, "of them out", (double)census[0].out, (double)census[1].out, 0, true);
    add_numbers(document, "Last out, s", last[0], last[1], 2, both);
    add_numbers(document, "Narrowest, m", narrowest(runs[0].observation), narrowest(runs[1].observation), 3, both);
    add_numbers(document, "Contacts", contacts[0], contacts[1], 0, true);
    add_numbers(document, "Hardest contact, N", hardest[0], hardest[1], 0, true);
    add_numbers(document, "Dangerous points", dangers[0], dangers[1], 0, true);
}

static void add_pictures(Document *document, const Reported runs[2]) {
    Scene scenes[2];
    const char *captions[2];
    for (int r = 0; r < 2; r++) {
        char headline[HEADLINE_TEXT];
        headline_text(runs[r].house, runs[r].observation, headline, sizeof headline);
        captions[r] = document_text(document, "%s: %s. %s.", style[r], house_report_name(runs[r].house), headline);
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
                              document_text(document, "%s: %s", same ? "A and B" : style[r], runs[r].house->plan.note));
}

/* People ------------------------------------------------------------------------------------------------------------*/

static void add_person(Document *document, const char *id, const char *letter, const PersonObservation *person) {
    bool moved = person->time > 0;
    const char *cells[] = {id,
                           letter,
                           person->completed ? "out" : observation_reason(person->reason),
                           report_people_number(document, moved ? person->time : NAN, 2),
                           report_people_number(document, moved ? person->narrowest : NAN, 3),
                           moved ? document_text(document, "%d", person->contacts) : NULL,
                           report_people_number(document, person->contacts ? person->peak_force : NAN, 0),
                           report_people_number(document, moved ? person->lost_time : NAN, 1)};
    document_add_row(document, cells);
}

static void add_people(Document *document, const Reported runs[2]) {
    static const Column columns[] = {{"Person", ALIGN_LEFT},        {"In", ALIGN_LEFT},
                                     {"Answer", ALIGN_LEFT},        {"Time, s", ALIGN_RIGHT},
                                     {"Narrowest, m", ALIGN_RIGHT}, {"Contacts", ALIGN_RIGHT},
                                     {"Hardest, N", ALIGN_RIGHT},   {"Lost, s", ALIGN_RIGHT}};
    document_add_table(document, "Times and clearances have a difference where somebody gets out of both.", columns,
                       sizeof columns / sizeof *columns);
    for (size_t i = 0; i < runs[0].house->person_count; i++) {
        const char *id = runs[0].house->people[i].id;
        const PersonObservation *a = &runs[0].observation->people[i];
        const PersonObservation *b = observation_of_person(runs[1].house, runs[1].observation, id);
        add_person(document, id, "A", a);
        if (!b)
            continue;
        add_person(document, id, "B", b);
        if (!a->completed || !b->completed)
            continue;
        const char *cells[] = {id,
                               "B - A",
                               "",
                               difference(document, a->time, b->time, 2),
                               difference(document, a->narrowest, b->narrowest, 3),
                               difference(document, a->contacts, b->contacts, 0),
                               difference(document, a->peak_force, b->peak_force, 0),
                               difference(document, a->lost_time, b->lost_time, 1)};
        document_add_row(document, cells);
    }
}

static void add_party(Document *document, const char *name, const char *letter, const Party *party) {
    const char *cells[] = {name,
                           letter,
                           document_text(document, "%zu", party->people),
                           document_text(document, "%zu", party->out),
                           report_people_number(document, party->mean, 1),
                           report_people_number(document, party->last, 1),
                           document_text(document, "%d", party->contacts),
                           report_people_number(document, party->contacts ? party->peak_force : NAN, 0),
                           report_people_number(document, party->lost, 1)};
    document_add_row(document, cells);
}

static void add_parties(Document *document, const Reported runs[2], const Census census[2]) {
    static const Column columns[] = {{"People", ALIGN_LEFT},    {"In", ALIGN_LEFT},          {"Number", ALIGN_RIGHT},
                                     {"Out", ALIGN_RIGHT},      {"Mean, s", ALIGN_RIGHT},    {"Last, s", ALIGN_RIGHT},
                                     {"Contacts", ALIGN_RIGHT}, {"Hardest, N", ALIGN_RIGHT}, {"Lost, s", ALIGN_RIGHT}};
    document_add_table(document, NULL, columns, sizeof columns / sizeof *columns);
    for (size_t p = 0; p < census[0].party_count; p++) {
        const Party *a = &census[0].parties[p];
        const char *name = census_party_name(runs[0].house, a);
        const Party *b = census_find_party(runs[1].house, &census[1], name, a->profile->name);
        add_party(document, name, "A", a);
        if (!b)
            continue;
        add_party(document, name, "B", b);
        const char *cells[] = {name,
                               "B - A",
                               difference(document, (double)a->people, (double)b->people, 0),
                               difference(document, (double)a->out, (double)b->out, 0),
                               difference(document, a->mean, b->mean, 1),
                               difference(document, a->last, b->last, 1),
                               difference(document, a->contacts, b->contacts, 0),
                               difference(document, a->peak_force, b->peak_force, 0),
                               difference(document, a->lost, b->lost, 1)};
        document_add_row(document, cells);
    }
}

static void add_routes(Document *document, const Reported runs[2]) {
    static const Column columns[] = {
        {"Route", ALIGN_LEFT}, {"A, s", ALIGN_RIGHT}, {"B, s", ALIGN_RIGHT}, {"B - A, s", ALIGN_RIGHT}};
    const Plan *a = &runs[0].house->plan, *b = &runs[1].house->plan;
    if (!a->route_count)
        return;
    document_add_table(document, "Routes: mean time of those who take them, when all of them get out.", columns, 4);
    for (size_t r = 0; r < a->route_count; r++) {
        size_t other = plan_find_route(b, a->routes[r].id);
        double first = census_route_time(runs[0].house, runs[0].observation, &a->routes[r]);
        double second =
            other < b->route_count ? census_route_time(runs[1].house, runs[1].observation, &b->routes[other]) : -1;
        add_numbers(document, a->routes[r].id, first < 0 ? NAN : first, second < 0 ? NAN : second, 2, true);
    }
}

/* The rest ----------------------------------------------------------------------------------------------------------*/

static void add_hazards(Document *document, const Reported runs[2]) {
    document_add_heading(document, 2, "Dangerous points");
    for (int r = 0; r < 2; r++)
        if (runs[r].observation->hazard_count)
            report_places_add_table(
                document, runs[r].observation,
                document_text(document, "%s: %s, worst first", style[r], house_report_name(runs[r].house)));
        else
            document_add_paragraph(
                document,
                document_text(document, "%s: %s.", style[r],
                              runs[r].observation->time > 0 ? "none" : "none is known, since nobody could set off"));
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

Document comparison_report_make(const Reported runs[2], const Making *making) {
    Census census[2];
    Document document = document_begin(making->program);
    for (int r = 0; r < 2; r++)
        census[r] = census_make(runs[r].house, runs[r].observation);
    document_add_title(&document,
                       document_text(&document, "Comparison of A, %s, and B, %s", house_report_name(runs[0].house),
                                     house_report_name(runs[1].house)),
                       format_answer(&document, runs));
    add_pictures(&document, runs);
    add_answers(&document, runs, census);
    add_notes(&document, runs);
    report_basis_add_changes(&document, making);
    document_add_contents(&document);
    report_plans_add(&document, &runs[0].house->plan, &runs[1].house->plan);
    document_add_heading(&document, 2, "Who gets out");
    if (census[0].people > CENSUS_ROWS)
        add_parties(&document, runs, census);
    else
        add_people(&document, runs);
    add_routes(&document, runs);
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
