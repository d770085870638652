#include "report/report_people.h"

#include "visual/house/census.h"

const char *report_people_number(Document *document, double value, int digits) {
    if (!isfinite(value))
        return NULL;
    bool nought = fabs(value) < 0.5 * pow(10, -digits); /* without the sign that rounding leaves */
    return document_text(document, "%.*f", digits, nought ? 0 : value);
}

static const char *exit_name(const House *house, size_t exit) {
    return exit < house->plan.exit_count ? house->plan.exits[exit].id : NULL;
}

static void add_person(Document *document, const House *house, size_t i, const PersonObservation *person) {
    const Inhabitant *inhabitant = &house->people[i];
    bool moved = person->time > 0;
    double contacts = person->contacts;
    const char *cells[] = {inhabitant->id,
                           inhabitant->profile->name,
                           inhabitant->route ? inhabitant->route->id : NULL,
                           exit_name(house, person->exit),
                           person->completed ? "out" : observation_reason(person->reason),
                           report_people_number(document, moved ? person->time : NAN, 2),
                           report_people_number(document, moved ? person->narrowest : NAN, 3),
                           report_people_number(document, moved ? contacts : NAN, 0),
                           report_people_number(document, person->contacts ? person->peak_force : NAN, 0),
                           report_people_number(document, moved ? person->lost_time : NAN, 1)};
    document_add_row(document, cells);
}

static void add_people(Document *document, const House *house, const Observation *observation) {
    static const Column columns[] = {
        {"Person", ALIGN_LEFT},      {"Profile", ALIGN_LEFT},  {"Route", ALIGN_LEFT},         {"Exit", ALIGN_LEFT},
        {"Answer", ALIGN_LEFT},      {"Time, s", ALIGN_RIGHT}, {"Narrowest, m", ALIGN_RIGHT}, {"Contacts", ALIGN_RIGHT},
        {"Hardest, N", ALIGN_RIGHT}, {"Lost, s", ALIGN_RIGHT}};
    document_add_table(
        document,
        "Narrowest: how near the body came to anything, 0.30 m or the personal space at most; negative: it "
        "was pressed against it. Contacts: times that the body began to touch something. Lost: time "
        "against the free speed.",
        columns, sizeof columns / sizeof *columns);
    for (size_t i = 0; i < house->person_count; i++)
        if (observation->people[i].took_part)
            add_person(document, house, i, &observation->people[i]);
}

static void add_party(Document *document, const House *house, const Party *party) {
    const char *cells[] = {census_party_name(house, party),
                           party->profile->name,
                           party->route ? party->route->id : NULL,
                           document_text(document, "%zu", party->people),
                           document_text(document, "%zu", party->out),
                           report_people_number(document, party->mean, 1),
                           report_people_number(document, party->last, 1),
                           report_people_number(document, party->lost, 1),
                           document_text(document, "%d", party->contacts),
                           report_people_number(document, party->contacts ? party->peak_force : NAN, 0)};
    document_add_row(document, cells);
}

static void add_parties(Document *document, const House *house, const Census *census) {
    static const Column columns[] = {{"People", ALIGN_LEFT},     {"Profile", ALIGN_LEFT},  {"Route", ALIGN_LEFT},
                                     {"Number", ALIGN_RIGHT},    {"Out", ALIGN_RIGHT},     {"Mean, s", ALIGN_RIGHT},
                                     {"Last, s", ALIGN_RIGHT},   {"Lost, s", ALIGN_RIGHT}, {"Contacts", ALIGN_RIGHT},
                                     {"Hardest, N", ALIGN_RIGHT}};
    document_add_table(
        document,
        "Mean and last: times of those who are out. Lost: mean of all, against the free speed. Contacts: "
        "times that bodies began to touch something or each other.",
        columns, sizeof columns / sizeof *columns);
    for (size_t p = 0; p < census->party_count; p++)
        add_party(document, house, &census->parties[p]);
}

static void add_exits(Document *document, const House *house, const Census *census) {
    static const Column columns[] = {{"Exit", ALIGN_LEFT}, {"People who left by it", ALIGN_RIGHT}};
    document_add_table(document, NULL, columns, 2);
    for (size_t e = 0; e < house->plan.exit_count; e++) {
        const char *cells[] = {house->plan.exits[e].id, document_text(document, "%zu", census->left[e])};
        document_add_row(document, cells);
    }
}

void report_people_add(Document *document, const House *house, const Observation *observation) {
    Census census = census_make(house, observation);
    document_add_heading(document, 2, "Who gets out");
    if (!census.people) {
        document_add_paragraph(document, "Nobody takes part.");
    } else if (census.people > CENSUS_ROWS) {
        add_parties(document, house, &census);
        add_exits(document, house, &census);
    } else {
        add_people(document, house, observation);
    }
    census_clear(&census);
}

static void add_route(Document *document, const House *house, const Observation *observation, const PlanRoute *route) {
    double time = census_route_time(house, observation, route), mean = route->observed.mean;
    bool measured = mean > 0, simulated = time >= 0;
    const char *cells[] = {route->id,
                           measured ? document_text(document, "%d", route->observed.runs) : NULL,
                           measured ? report_people_number(document, mean, 2) : NULL,
                           measured ? report_people_number(document, route->observed.deviation, 2) : NULL,
                           simulated ? report_people_number(document, time, 2) : NULL,
                           measured && simulated ? document_text(document, "%+.1f %%", 100 * (time - mean) / mean)
                                                 : NULL};
    document_add_row(document, cells);
}

void report_people_add_routes(Document *document, const House *house, const Observation *observation) {
    static const Column columns[] = {{"Route", ALIGN_LEFT},
                                     {"Measured runs", ALIGN_RIGHT},
                                     {"Mean (a), s", ALIGN_RIGHT},
                                     {"Deviation (b), s", ALIGN_RIGHT},
                                     {"Simulation (c), s", ALIGN_RIGHT},
                                     {"Error ((c) - (a)) / (a)", ALIGN_RIGHT}};
    size_t measured = 0;
    for (size_t r = 0; r < house->plan.route_count; r++)
        measured += house->plan.routes[r].observed.mean > 0;
    if (!house->plan.route_count)
        return;
    document_add_heading(document, 2, "Routes, measured and simulated");
    if (!measured)
        document_add_paragraph(document,
                               "The house's file has no measured times of these routes: there is nothing to hold "
                               "the simulated ones against. Whoever measures adds \"observed\" to a route.");
    document_add_table(document, "Simulation: mean of the route's people, when all of them get out.", columns,
                       sizeof columns / sizeof *columns);
    for (size_t r = 0; r < house->plan.route_count; r++)
        add_route(document, house, observation, &house->plan.routes[r]);
}
