#include "report/report_places.h"

#include <stdio.h>
#include <string.h>

#include "base/text.h"
#include "result/census.h"
#include "visual/house/house_scene.h"
#include "result/house.h"
#include "result/jam.h"
#include "result/names.h"
#include "result/page.h"
#include "result/tight.h"

#define DETAIL_WIDTH 3.2 /* m, across a picture of a place */
#define DETAIL_HEIGHT 2.5

enum {
    PICTURES_MOST = 5,
    IN_A_ROW = 2,
};

static const Vec2 DETAIL_SIZE = {500, 390}; /* design points */

static void add_detail(Document *document, const House *house, const Observation *observation, size_t index, Vec2 at,
                       const char *caption, const char *alternative) {
    Vec2 half = vec2(DETAIL_WIDTH / 2, DETAIL_HEIGHT / 2);
    Scene scene;
    house_scene_make_detail(&scene, house, observation, (Box){vec2_sub(at, half), vec2_add(at, half)});
    if (index % IN_A_ROW == 0)
        document_add_figures(document);
    document_add_scene(document, &scene, DETAIL_SIZE, caption, alternative);
}

/* Stops ------------------------------------------------------------------------------------------------------------ */

static const char *format_hold(Document *document, const House *house, const Hold *hold) {
    const Blockage *blockage = &hold->blockage;
    char widths[ROUTE_WIDTHS], who[96];
    route_widths(blockage, widths, sizeof widths);
    snprintf(who, sizeof who, "%zu people", hold->people);
    if (hold->people == 1)
        snprintf(who, sizeof who, "%s", names_person(house, hold->first, &document->arena));
    const char *what = "a place on the route";
    const char *the = strncmp(blockage->what, "door ", strlen("door ")) == 0 ? "the " : "";
    if (*blockage->what)
        what = document_text(document, "%s%s", the, names_thing(house, blockage->what, blockage->at, &document->arena));
    if (hold->reason == REASON_BLOCKED)
        return document_text(document, "%s: on the route, but stuck at %s without further progress.", who, what);
    if (hold->reason == REASON_TOO_WEAK)
        return document_text(document,
                             "%s: too weak at any speed. The %s takes more than there is: %s. This follows from the "
                             "plan, before anything moves.",
                             who, blockage->what, widths);
    return document_text(
        document,
        *widths ? "%s cannot pass %s: %s. This follows from the plan, before anything moves: no route leads through."
                : "%s cannot pass %s. This follows from the plan, before anything moves: no route leads through.",
        who, what, widths);
}

void report_places_add_stops(Document *document, const House *house, const Observation *observation) {
    Census census = census_make(house, observation);
    size_t shown = 0;
    if (census.out < census.people)
        document_add_heading(document, 2,
                             observation->interrupted ? "Who is still inside at the interruption"
                                                      : "Who is not out, and why");
    for (size_t h = 0; h < census.hold_count; h++)
        if (!observation_reason_has_place(census.holds[h].reason)) {
            const Hold *hold = &census.holds[h];
            document_add_paragraph(document, document_text(document, "%zu of %zu: %s.", hold->people, census.people,
                                                           observation_reason(hold->reason)));
        }
    for (size_t h = 0; h < census.hold_count && shown < PICTURES_MOST; h++) {
        const Hold *hold = &census.holds[h];
        if (!observation_reason_has_place(hold->reason))
            continue;
        Vec2 at = hold->blockage.at;
        add_detail(document, house, observation, shown++, at, format_hold(document, house, hold),
                   document_text(document, "Detail of the plan round (%.2f, %.2f): %s", at.x, at.y,
                                 names_thing(house, hold->blockage.what, at, &document->arena)));
    }
    census_clear(&census);
}

/* Tight places ----------------------------------------------------------------------------------------------------- */

static void add_text(Text *text, const char *label) {
    text_add(text, text->used ? "; " : "");
    text_add(text, label);
}

/* Returns "clearance 0.04 m, below the 0.05 m from which on this report warns; 2.1 s lost, ..." */
static const char *format_hazard(Document *document, const House *house, const Hazard *hazard, size_t rank) {
    const RunSettings *run = &house->plan.run;
    char label[160];
    Text text = {0};
    if (hazard->clearance < run->clearance_warning) {
        snprintf(label, sizeof label,
                 hazard->clearance <= 0 ? "clearance %.3f m (contact), below the warning level of %g m"
                                        : "clearance %.3f m, below the warning level of %g m",
                 hazard->clearance, run->clearance_warning);
        add_text(&text, label);
    }
    if (hazard->peak_force > 0) {
        bool hard = hazard->peak_force > run->force_warning;
        snprintf(label, sizeof label,
                 hard ? "contact of up to %.0f N, above the warning level of %g N"
                      : "contact of up to %.0f N, within the warning level of %g N",
                 hazard->peak_force, run->force_warning);
        add_text(&text, label);
    }
    if (hazard->lost_time > run->loss_warning) {
        snprintf(label, sizeof label, "%.1f s lost here, above the warning level of %g s", hazard->lost_time,
                 run->loss_warning);
        add_text(&text, label);
    }
    const char *said = document_text(document, "%zu. %s: %s.", rank, jam_name(house, hazard, &document->arena),
                                     text.text ? text.text : "");
    memory_free(text.text);
    return said;
}

void report_places_add_table(Document *document, const House *house, const Observation *observation,
                             const char *caption) {
    ResultTable table = result_house_hindrances(house, observation);
    Tight places[HAZARDS_MOST];
    tight_all(house, observation, places);
    for (size_t i = 0; i < table.record_count; i++) {
        const Hazard *hazard = &observation->hazards[places[i].hazard];
        ((ResultRow *)result_find(&table, i, "what"))->text = jam_name(house, hazard, &table.arena);
    }
    result_page_take(document, caption, table);
}

void report_places_add_hazards(Document *document, const House *house, const Observation *observation) {
    const RunSettings *run = &house->plan.run;
    document_add_heading(document, 2, "Tight places");
    if (observation->time <= 0) {
        document_add_paragraph(document, "None is known: nobody could start.");
        return;
    }
    if (!observation->hazard_count) {
        document_add_paragraph(document,
                               document_text(document,
                                             "None: nobody came nearer than %g m to anything, touched anything harder "
                                             "than %g N or lost more than %g s at one place.",
                                             run->clearance_warning, run->force_warning, run->loss_warning));
        return;
    }
    report_places_add_table(
        document, house, observation,
        document_text(
            document,
            "Listed by the time lost by all people who pass. The clearance is that of the route that is driven: a body "
            "may pass close to an obstacle although there is room. A place is listed from a clearance below %g m, a "
            "contact above %g N or %g s of lost time on.",
            run->clearance_warning, run->force_warning, run->loss_warning));
    Tight places[HAZARDS_MOST];
    size_t count = tight_all(house, observation, places);
    for (size_t i = 0; i < count && i < PICTURES_MOST; i++) {
        Hazard hazard = observation->hazards[places[i].hazard];
        hazard.clearance = places[i].clearance;
        hazard.peak_force = places[i].peak_force;
        hazard.lost_time = places[i].lost_time;
        add_detail(document, house, observation, i, hazard.at, format_hazard(document, house, &hazard, i + 1),
                   document_text(document, "Detail of the plan round tight place %zu, %s", i + 1,
                                 jam_name(house, &hazard, &document->arena)));
    }
}
