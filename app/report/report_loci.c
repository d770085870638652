#include "report/report_loci.h"

#include <stdint.h>
#include <string.h>

#include "house/locus.h"
#include "visual/house/blockage_scene.h"
#include "result/names.h"
#include "result/census.h"
#include "visual/house/house_scene.h"
#include "visual/house/people_scene.h"
#include "visual/house/plan_scene.h"
#include "report/report_people.h"
#include "report/report_pictures.h"

#define TICK_WIDTH 2.0 /* design points, as those of simulated loci */
#define TICK_LENGTH 11.0
#define NAME_TEXT 17.0
#define KEEP_LOCUS 1.5 /* weight against being covered by labels */

static const char *const way_names[] = {[DRIVING_DRIVER] = "driver", [DRIVING_MIURA] = "miura"};

/* The observed people ---------------------------------------------------------------------------------------------- */

size_t report_loci_person(const House *house, const char *name) {
    if (!*name)
        return house->person_count == 1 ? 0 : SIZE_MAX;
    for (size_t i = 0; i < house->person_count; i++)
        if (strcmp(house->people[i].id, name) == 0)
            return i;
    for (size_t i = 0; i < house->person_count; i++)
        if (house->people[i].route && strcmp(house->people[i].route->id, name) == 0)
            return i;
    return SIZE_MAX;
}

bool report_loci_check(const House *house, const ObservedLoci *observed, Fault *fault) {
    size_t before = fault->total;
    for (size_t i = 0; i < observed->count; i++) {
        const ObservedLocus *locus = &observed->loci[i];
        if (report_loci_person(house, locus->person) < house->person_count)
            continue;
        if (*locus->person)
            fault_add(fault, "%s:%d:1: there is no person or route \"%s\" in the house", observed->path, locus->line,
                      locus->person);
        else
            fault_add(fault, "%s:1:1: there is no column \"person\", must say who of %zu people is meant",
                      observed->path, house->person_count);
    }
    return fault->total == before;
}

static size_t count_chairs(const House *house) {
    size_t chairs = 0;
    for (size_t i = 0; i < house->person_count; i++)
        chairs += !census_walks(house->people[i].profile);
    return chairs;
}

bool report_loci_make_sense(const House *house) {
    return house->person_count <= PEOPLE_SCENE_INDIVIDUALS && count_chairs(house) > 0;
}

/* Pictures --------------------------------------------------------------------------------------------------------- */

static Scene empty_scene(const House *house) {
    Scene scene = {.grid = HOUSE_SCENE_GRID, .box = box_expand(house->outline.box, HOUSE_SCENE_MARGIN)};
    plan_scene_solids(&scene, house);
    return scene;
}

static void add_ticks(Scene *scene, const Locus *locus, Role role) {
    double last = locus->times[0];
    for (size_t i = 1; i + 1 < locus->count; i++) {
        if (locus->times[i] < last + PEOPLE_SCENE_TICK)
            continue;
        last += PEOPLE_SCENE_TICK;
        scene_add_tick(scene, role, TICK_WIDTH, TICK_LENGTH, locus->points[i], locus->points[i + 1]);
    }
}

static void add_locus(Scene *scene, const House *house, size_t person, const Locus *locus) {
    LocusLook look = people_scene_look(house, person);
    if (locus->count < 2)
        return;
    Primitive *line = scene_add_line(scene, look.role, look.width, locus->points, locus->count);
    line->style = look.style;
    line->keep_clear = KEEP_LOCUS;
    add_ticks(scene, locus, look.role);
    for (size_t p = 0; p < locus->count; p++)
        scene->box = box_include(scene->box, locus->points[p]);
}

static void add_name(Scene *scene, const House *house, size_t person, Vec2 at) {
    Primitive *tag = scene_add_label(scene, ROLE_TEXT, NAME_TEXT, at, names_person(house, person, &scene->arena));
    tag->fill = people_scene_look(house, person).role;
    tag->shape = LABEL_TAG;
    tag->bold = tag->leader = true;
}

/* Makes a scene of loci only, with their starts and causes of their ends: names and bodies would cover the comparison.
 */
static Scene paths_scene(const Reported *run) {
    const House *house = run->house;
    const PersonObservation *people = run->observation->people;
    Scene scene = empty_scene(house);
    Trail *trails = trail_list(run->observation);
    for (size_t i = 0; i < house->person_count; i++) {
        if (!people[i].took_part)
            continue;
        Locus locus = locus_of(house, run->observation, i);
        add_locus(&scene, house, i, &locus);
        people_scene_start(&scene, &house->people[i], ROLE_CHAIR);
        locus_free(&locus);
        if (blockage_scene_has(&people[i]))
            blockage_scene_add(&scene, house, run->observation, i, &trails[i]);
    }
    plan_scene_tags(&scene, house, NULL);
    for (size_t i = 0; i < house->person_count; i++)
        if (people[i].took_part)
            add_name(&scene, house, i, house->people[i].at);
    blockage_scene_labels(&scene, house, run->observation);
    trail_free_list(trails);
    return scene;
}

static Scene observed_scene(const House *house, const ObservedLoci *observed) {
    Scene scene = empty_scene(house);
    for (size_t i = 0; i < observed->count; i++)
        add_locus(&scene, house, report_loci_person(house, observed->loci[i].person), &observed->loci[i].locus);
    plan_scene_tags(&scene, house, NULL);
    for (size_t i = 0; i < observed->count; i++)
        add_name(&scene, house, report_loci_person(house, observed->loci[i].person), observed->loci[i].locus.points[0]);
    return scene;
}

static void add_pictures(Document *document, const HouseReport *report) {
    static const char *const captions[] = {
        "miura: the driving model of the paper, a disc on straight legs and corners.",
        "driver: our driving model, the true rectangle of the chair on a planned path.",
        "observed: the measured loci."};
    Scene scenes[3] = {paths_scene(&report->by_driving[DRIVING_MIURA]),
                       paths_scene(&report->by_driving[DRIVING_DRIVER])};
    Box box = report_pictures_box(scenes[0].box, scenes[1].box);
    if (report->observed) {
        scenes[2] = observed_scene(report->run.house, report->observed);
        box = report_pictures_box(box, scenes[2].box);
    }
    report_pictures_add_beside(document, scenes, report->observed ? 3 : 2, box, captions);
}

/* Tables ----------------------------------------------------------------------------------------------------------- */

static void add_way(Document *document, const HouseReport *report, size_t person, int driving,
                    const LocusDistance *apart) {
    const Reported *run = &report->by_driving[driving];
    const PersonObservation *observed = &run->observation->people[person];
    bool moved = observed->time > 0;
    const char *cells[] = {names_person(run->house, person, &document->arena),
                           way_names[driving],
                           observed->completed ? report_people_number(document, observed->time, 2)
                                               : observation_reason(observed->reason),
                           report_people_number(document, moved ? observed->narrowest : NAN, 3),
                           moved ? document_text(document, "%d", observed->contacts) : NULL,
                           report_people_number(document, moved ? observed->lost_time : NAN, 1),
                           report_people_number(document, apart && apart->counted ? apart->mean : NAN, 3),
                           report_people_number(document, apart && apart->counted ? apart->largest : NAN, 3)};
    document_add_row(document, cells);
}

static LocusDistance ways_apart(const HouseReport *report, size_t person) {
    const Reported *runs = report->by_driving;
    LocusDistance apart = {.counted = 0};
    if (!runs[0].observation->people[person].completed || !runs[1].observation->people[person].completed)
        return apart;
    Locus driver = locus_of(runs[DRIVING_DRIVER].house, runs[DRIVING_DRIVER].observation, person);
    Locus miura = locus_of(runs[DRIVING_MIURA].house, runs[DRIVING_MIURA].observation, person);
    apart = locus_distance(&driver, &miura);
    locus_free(&driver);
    locus_free(&miura);
    return apart;
}

static void add_ways(Document *document, const HouseReport *report) {
    static const Column columns[] = {{"Person", ALIGN_LEFT},
                                     {"Driving model", ALIGN_LEFT},
                                     {"Time, s", ALIGN_RIGHT},
                                     {"Narrowest, m", ALIGN_RIGHT},
                                     {"Contacts", ALIGN_RIGHT},
                                     {"Lost, s", ALIGN_RIGHT},
                                     {"Mean distance, m", ALIGN_RIGHT},
                                     {"Largest distance, m", ALIGN_RIGHT}};
    const House *house = report->run.house;
    document_add_table(
        document, "Distance: from the driver's locus to the paper's, both of the body's middle, where both are out.",
        columns, sizeof columns / sizeof *columns);
    for (size_t i = 0; i < house->person_count; i++) {
        if (!report->run.observation->people[i].took_part || census_walks(house->people[i].profile))
            continue;
        LocusDistance apart = ways_apart(report, i);
        add_way(document, report, i, DRIVING_MIURA, &apart);
        add_way(document, report, i, DRIVING_DRIVER, NULL);
    }
}

/* Adds an observed locus and the simulated one of the same name. */
static void add_agreement(Document *document, const Reported *run, int driving, const ObservedLocus *observed) {
    size_t person = report_loci_person(run->house, observed->person);
    const PersonObservation *simulated = &run->observation->people[person];
    Locus locus = locus_of(run->house, run->observation, person);
    LocusDistance apart = locus_distance(&observed->locus, &locus);
    double taken = observed->locus.times[observed->locus.count - 1] - observed->locus.times[0];
    bool both = simulated->completed && taken > 0;
    const char *cells[] = {names_person(run->house, person, &document->arena),
                           way_names[driving],
                           report_people_number(document, taken, 2),
                           simulated->completed ? report_people_number(document, simulated->time, 2)
                                                : observation_reason(simulated->reason),
                           both ? document_text(document, "%+.1f %%", 100 * (simulated->time - taken) / taken) : NULL,
                           report_people_number(document, apart.counted ? apart.mean : NAN, 3),
                           report_people_number(document, apart.counted ? apart.largest : NAN, 3)};
    document_add_row(document, cells);
    locus_free(&locus);
}

static void add_agreements(Document *document, const HouseReport *report) {
    static const Column columns[] = {{"Person", ALIGN_LEFT},
                                     {"Driving model", ALIGN_LEFT},
                                     {"Observed, s", ALIGN_RIGHT},
                                     {"Simulated, s", ALIGN_RIGHT},
                                     {"Error", ALIGN_RIGHT},
                                     {"Mean distance, m", ALIGN_RIGHT},
                                     {"Largest distance, m", ALIGN_RIGHT}};
    document_add_table(
        document,
        document_text(document,
                      "Observed (%s) against simulated. Distance: from the observed places to the simulated "
                      "locus of the body's middle.",
                      report->observed->path),
        columns, sizeof columns / sizeof *columns);
    for (size_t i = 0; i < report->observed->count; i++) {
        add_agreement(document, &report->by_driving[DRIVING_MIURA], DRIVING_MIURA, &report->observed->loci[i]);
        add_agreement(document, &report->by_driving[DRIVING_DRIVER], DRIVING_DRIVER, &report->observed->loci[i]);
    }
}

void report_loci_add(Document *document, const HouseReport *report) {
    document_add_heading(document, 2, "Loci side by side");
    if (!report_loci_make_sense(report->run.house)) {
        document_add_paragraph(
            document,
            count_chairs(report->run.house)
                ? document_text(document,
                                "Left out: the loci of more than %d people cover each other, and in a crowd they "
                                "depend on the other people more than on the driving model.",
                                PEOPLE_SCENE_INDIVIDUALS)
                : "Left out: nobody is in a chair, and people on foot have one model only.");
        return;
    }
    if (!report->by_driving[0].house || !report->by_driving[1].house) {
        document_add_paragraph(document, "Left out: the run was interrupted.");
        return;
    }
    document_add_paragraph(document,
                           "The same people in the same house with both driving models: the loci of the middles "
                           "of their bodies, with a tick each second. Where the two differ, the answer depends "
                           "on the driving model.");
    add_pictures(document, report);
    add_ways(document, report);
    if (report->observed)
        add_agreements(document, report);
}
