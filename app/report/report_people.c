#include "report/report_people.h"

#include "plan/observed_times.h"
#include "result/house.h"
#include "result/page.h"

const char *report_people_number(Document *document, double value, int digits) {
    if (!isfinite(value))
        return NULL;
    bool nought = fabs(value) < 0.5 * real_power_of_ten(-digits); /* without the sign that rounding leaves */
    return document_text(document, "%.*f", digits, nought ? 0 : value);
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
    document_add_heading(document, 2, "Who is out");
    if (!census.people) {
        document_add_paragraph(document, "No person takes part.");
    } else if (census.people > CENSUS_ROWS) {
        result_page_take_named(
            document,
            "Mean and last: times of those who are out. Lost: mean of all, against the free speed. Contacts: "
            "times that bodies began to touch something or each other.",
            house, result_house_parties(house, &census, false));
        add_exits(document, house, &census);
    } else {
        result_page_take_named(
            document,
            "Narrowest: how near the body came to anything, up to the personal space; negative: the body was "
            "pressed against it. Contacts: times that the body began to touch something. Space entered: how long "
            "something was in the personal space. Lost: time against the free speed.",
            house, result_house_people(house, observation));
    }
    census_clear(&census);
}

void report_people_add_routes(Document *document, const House *house, const Observation *observation) {
    size_t measured = 0;
    for (size_t r = 0; r < house->plan.route_count; r++)
        measured += observed_times_of(&house->plan.routes[r].observed).runs > 0;
    if (!house->plan.route_count)
        return;
    document_add_heading(document, 2, "Routes, measured and simulated");
    if (!measured)
        document_add_paragraph(document,
                               "The house's file has no measured times of these routes: there is nothing to hold "
                               "the simulated ones against. Whoever measures adds \"observed\" to a route.");
    result_page_take(document, "Simulation: mean of the route's people, if all of them are out.",
                     result_house_routes(house, observation));
}
