#include "report/house_report.h"

#include <ctype.h>

#include "visual/house/house_scene.h"
#include "visual/house/people_scene.h"
#include "result/drivers.h"
#include "result/grade.h"
#include "result/headline.h"
#include "result/names.h"
#include "report/report_basis.h"
#include "report/report_density.h"
#include "report/report_loci.h"
#include "report/report_motion.h"
#include "report/report_people.h"
#include "report/report_pictures.h"
#include "report/report_places.h"

const char *house_report_name(const House *house) {
    return *house->plan.name ? house->plan.name : house->plan.path;
}

/* Explains the picture and those of its signs that occur. */
static const char *caption_of(Document *document, const Reported *run) {
    const Observation *observation = run->observation;
    bool moved = observation->time > 0, crowd = run->house->person_count > PEOPLE_SCENE_INDIVIDUALS;
    bool rings = moved && run->house->person_count <= PEOPLE_SCENE_SEVERAL;
    return document_text(document,
                         moved ? "%s, seen from above, with the routes that people took.%s%s%s%s"
                               : "%s, seen from above.%s%s%s%s",
                         house_report_name(run->house), observation->hazard_count ? " Numbers: tight places." : "",
                         rings ? " Dashed outlines: personal space, thick where it is compressed." : "",
                         crowd ? " Grey discs: starts of people on foot; coloured lines: chairs, by profile." : "",
                         !crowd || observation->completed ? ""
                         : observation->interrupted       ? " Diamonds: people who are still inside at the end."
                                                          : " Diamonds: people who are not out at the end.");
}

/* Tells of exits that are not always open. */
static void add_exit_times(Document *document, const Plan *plan) {
    for (size_t e = 0; e < plan->exit_count; e++) {
        const Exit *exit = &plan->exits[e];
        bool opens = exit->opens > 0, closes = exit->closes < HUGE_VAL;
        if (opens || closes)
            document_add_paragraph(
                document, document_text(document, "Exit %s%s%s%s.", exit->id,
                                        opens ? document_text(document, " opens at %.4g s", exit->opens) : "",
                                        opens && closes ? " and" : "",
                                        closes ? document_text(document, " closes at %.4g s", exit->closes) : ""));
    }
}

/* Removes the answer from the picture, as it stands above the picture in the document. */
static void add_house(Document *document, const HouseReport *report, const char *headline) {
    const Reported *run = &report->run;
    Scene scene;
    house_scene_make(&scene, run->house, run->observation);
    const char *detail = scene.detail ? scene.detail : "";
    const ReportedDrivers *of = &report->drivers;
    const char *grade =
        of->letters
            ? names_text(run->house, result_grade_phrase(run->house, of->letters, &document->arena), &document->arena)
            : "";
    if (*grade)
        document_add_paragraph(document, document_text(document, "%c%s.", toupper((unsigned char)*grade), grade + 1));
    if (of->drivers && (of->drivers->count || of->grades))
        document_add_paragraph(
            document, document_text(document, "That is what the nominal driver does; %s.",
                                    result_drivers_headline(run->house, of->drivers, of->grades, &document->arena)));
    if (*detail && run->observation->completed) /* otherwise the headline already says so */
        document_add_paragraph(document, document_text(document, "%c%s.", toupper((unsigned char)*detail), detail + 1));
    add_exit_times(document, &run->house->plan);
    if (run->observation->time > 0)
        document_add_paragraph(document,
                               "Times include movement only, not alarm, waking and the transfer into the chair.");
    if (*run->house->plan.note)
        document_add_note(document, run->house->plan.note);
    report_basis_add_changes(document, report->making);
    document_add_contents(document);
    report_pictures_add(document, &scene, caption_of(document, run),
                        document_text(document, "Plan of %s. %s.", house_report_name(run->house), headline));
}

static void add_motion(Document *document, const HouseReport *report) {
    document_add_heading(document, 2, "Motion");
    if (report->raised)
        report_motion_add_raised(document, report->raised, house_report_name(report->run.house));
    report_density_add(document, &report->run);
    report_motion_add_curves(document, &report->run, &(Reported){.house = NULL});
}

Document house_report_make(const HouseReport *report) {
    const House *house = report->run.house;
    const Observation *observation = report->run.observation;
    Document document = document_begin(report->making->program);
    const char *headline = names_text(house, headline_sentence(house, observation, &document.arena), &document.arena);
    document_add_title(&document, document_text(&document, "Evacuation report: %s", house_report_name(house)),
                       headline);
    add_house(&document, report, headline);
    report_people_add(&document, house, observation);
    report_places_add_stops(&document, house, observation);
    report_people_add_routes(&document, house, observation);
    report_places_add_hazards(&document, house, observation);
    report_drivers_add(&document, house_report_name(house), &report->run, &report->drivers);
    if (observation->time > 0)
        add_motion(&document, report);
    report_loci_add(&document, report);
    document_add_heading(&document, 2, "What the model assumes");
    if (*house->plan.note)
        document_add_note(&document, house->plan.note);
    report_basis_add_method(&document, house, report_loci_make_sense(house));
    report_basis_add_settings(&document, house);
    for (size_t p = 0; p < house->profile_count; p++)
        report_basis_add_profile(&document, house, &house->profiles[p]);
    report_basis_add_making(&document, report->making, &report->run, 1);
    report_basis_add_names(&document, house);
    return document;
}
