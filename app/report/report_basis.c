#include "report/report_basis.h"

#include <inttypes.h>
#include <string.h>

#include "base/text.h"
#include "plan/plan_tables.h"
#include "result/census.h"
#include "result/names.h"

/* How ---------------------------------------------------------------------------------------------------------------*/

static bool has_driving(const House *house, int driving) {
    for (size_t i = 0; i < house->profile_count; i++)
        if (house->profiles[i].driving == driving)
            return true;
    return false;
}

/* Prints "Doors that are shut at first take time to open, which counts as lost time there "
"(opening_time in the house's file; assumed if the file does not give it): %s." */
static void add_doors(Document *document, const Plan *plan) {
    const char *doors = "";
    for (size_t d = 0; d < plan->door_count; d++)
        if (outline_door_moves(&plan->doors[d]))
            doors = document_text(document, "%s%s%s %g s", doors, *doors ? ", " : "",
                                  names_door(plan, d, &document->arena), plan->doors[d].opening_time);
    if (*doors)
        document_add_paragraph(document,
                               document_text(document,
                                             "Doors that are shut at first take time to be opened, which is "
                                             "lost there and counts as such (opening_time of the house's file; "
                                             "assumed where that does not say it): %s.",
                                             doors));
}

void report_basis_add_method(Document *document, const House *house, bool both_ways) {
    document_add_heading(document, 3, "How it is computed");
    document_add_paragraph(document,
                           "Times include movement only: from the start of the run until a person's drive axle "
                           "(on foot: the middle of the body) has crossed the exit's line. They do not include "
                           "alarm, waking and the transfer into the chair. Single people have the mean free "
                           "speed of their profile, or one of their own; speeds vary only within crowds.");
    document_add_paragraph(document,
                           "Each person is a distinct element: a rigid body with a mass. Where a body meets a "
                           "wall, a piece of furniture or another body, a spring and a dashpot push them apart, "
                           "and along the surface within the limit of Coulomb friction (the method of Cundall "
                           "and Strack, as Miura, Takimoto and Kubodera use it for wheelchairs). A second, "
                           "softer law of the same form acts in the personal space around the body.");
    if (both_ways || has_driving(house, DRIVING_DRIVER))
        document_add_paragraph(document,
                               "driver: a chair is its true rounded rectangle, rolls and turns about its drive axle "
                               "and does not slip sideways. It follows the quickest route that was found: searches "
                               "with smaller bodies propose ways, which are moved until the true body keeps 5 mm and "
                               "no small change makes them quicker. That no quicker one exists is not proved; that a "
                               "body does not fit is, to 3 mm. The push is limited.");
    if (both_ways || has_driving(house, DRIVING_MIURA))
        document_add_paragraph(document,
                               "miura: a chair is a disc on straight legs and corners, after the paper. It has no "
                               "length, and therefore passes where a chair may not.");
    if (has_driving(house, DRIVING_WALKER))
        document_add_paragraph(document,
                               "On foot: a disc that moves where the time to the exit falls fastest, keeps its "
                               "distance to the person ahead, and steps aside where that is quicker.");
    add_doors(document, &house->plan);
    document_add_paragraph(
        document, document_text(document,
                                "\"Cannot pass\" is found before anything moves: the geometry of the plan leaves no "
                                "drivable route. \"Blocked\" happens during the run: there is a route, but the person"
                                " on it has made no progress for %g s.",
                                house->plan.run.patience));
    document_add_paragraph(document,
                           "The model does not include fatigue, fear, helpers, smoke, darkness, slopes, stairs, "
                           "lifts, thresholds and wet floors. A run with one seed says nothing about the scatter"
                           " of times. It does not replace a trial with the people who live there.");
}

/* Numbers -----------------------------------------------------------------------------------------------------------*/

static const char *stored_values(Document *document, const Parameter *row, const void *object) {
    char *text = parameters_words(row, object);
    const char *kept = document_text(document, "%s", text);
    memory_free(text);
    return kept;
}

/* Returns "N s/m" with spaces that keep it on one line. */
static const char *unit_text(Document *document, const Parameter *row) {
    const char *unit = parameters_unit(row), *space = strchr(unit, ' ');
    return space ? document_text(document, "%.*s\u00a0%s", (int)(space - unit), unit, space + 1) : unit;
}

void report_basis_add_settings(Document *document, const House *house) {
    static const Column columns[] = {{"Setting", ALIGN_LEFT},
                                     {"Value", ALIGN_RIGHT},
                                     {"Unit", ALIGN_LEFT},
                                     {"Meaning", ALIGN_LEFT},
                                     {"Source", ALIGN_LEFT}};
    RunSettings usual;
    parameters_reset(&plan_tables_run, &usual);
    document_add_heading(document, 3, "Settings of the run");
    document_add_table(document, NULL, columns, sizeof columns / sizeof *columns);
    for (size_t r = 0; r < plan_tables_run.count; r++) {
        const Parameter *row = &plan_tables_run.rows[r];
        const char *value = stored_values(document, row, &house->plan.run);
        bool changed = strcmp(value, stored_values(document, row, &usual)) != 0;
        const char *cells[] = {document_text(document, "run.%s", row->name), value, unit_text(document, row),
                               row->meaning,
                               changed           ? "set for this house or this run"
                               : row->provenance ? row->provenance
                                                 : "default"};
        document_add_row(document, cells);
    }
}

/* Returns the change of a number of a profile by this house or for this run, or NULL. */
static const Override *find_override(const House *house, const Profile *profile, const Parameter *row) {
    const Override *last = NULL;
    size_t length = strlen(profile->name);
    for (size_t i = 0; i < house->plan.override_count; i++) {
        const char *name = house->plan.overrides[i].name + strlen("profile.");
        if (strncmp(name, profile->name, length) == 0 && name[length] == '.' &&
            parameters_find(profile_table(), name + length + 1) == row)
            last = &house->plan.overrides[i];
    }
    return last;
}

static void add_number(Document *document, const House *house, const Profile *profile, size_t index) {
    const Parameter *row = &profile_table()->rows[index];
    const Override *override = find_override(house, profile, row);
    const char *provenance = profile->provenance[index];
    if (override)
        provenance = strncmp(override->place, "--set", strlen("--set")) == 0 ? "changed here, for this run"
                                                                             : "changed here, in the house's file";
    const char *cells[] = {row->name, stored_values(document, row, profile), unit_text(document, row), row->meaning,
                           provenance};
    document_add_row(document, cells);
}

/* Returns "Of 38 numbers 9 are reconstructed, 3 from the literature and 26 assumed." */
static const char *format_kinds(Document *document, const House *house, const Profile *profile) {
    static const char *const kinds[] = {"paper", "reconstructed", "literature", "assumed"};
    enum { KINDS = sizeof kinds / sizeof *kinds };
    size_t counts[KINDS] = {0}, changed = 0, all = 0;
    for (size_t i = 0; i < profile_table()->count; i++) {
        if (!profile_row_matters(i, profile->driving))
            continue;
        all++;
        bool here = find_override(house, profile, &profile_table()->rows[i]);
        changed += here;
        for (size_t k = 0; k < KINDS && !here; k++)
            counts[k] += strncmp(profile->provenance[i], kinds[k], strlen(kinds[k])) == 0;
    }
    return document_text(
        document,
        "%s Of its %zu numbers, %zu are the paper's, %zu reconstructed from it, %zu from the literature, "
        "%zu assumed and %zu changed here.",
        profile->note, all, counts[0], counts[1], counts[2], counts[3], changed);
}

void report_basis_add_profile(Document *document, const House *house, const Profile *profile) {
    static const Column columns[] = {{"Number", ALIGN_LEFT},
                                     {"Value", ALIGN_RIGHT},
                                     {"Unit", ALIGN_LEFT},
                                     {"Meaning", ALIGN_LEFT},
                                     {"Source", ALIGN_LEFT}};
    document_add_heading(
        document, 3, document_text(document, "Profile %s (%s)", profile->name, profile_driving_name(profile->driving)));
    document_add_table(document, format_kinds(document, house, profile), columns, sizeof columns / sizeof *columns);
    for (size_t i = 0; i < profile_table()->count; i++)
        if (profile_row_matters(i, profile->driving))
            add_number(document, house, profile, i);
}

/* Making ------------------------------------------------------------------------------------------------------------*/

void report_basis_add_changes(Document *document, const Making *making) {
    Text text = {0};
    for (size_t s = 0; s < making->setting_count; s++) {
        text_add(&text, s ? ", " : "");
        text_add(&text, making->settings[s]);
    }
    if (text.used)
        document_add_note(document, document_text(document, "Changed for this run: %s.", text.text));
    memory_free(text.text);
}

void report_basis_add_making(Document *document, const Making *making, const Reported *runs, size_t count) {
    static const Column columns[] = {{"House", ALIGN_LEFT},
                                     {"Seed", ALIGN_RIGHT},
                                     {"Step, s", ALIGN_RIGHT},
                                     {"Steps", ALIGN_RIGHT},
                                     {"Digest of all states", ALIGN_LEFT}};
    document_add_heading(document, 2, "How this report was made");
    document_add_paragraph(document, document_text(document, "By %s, with this command:", making->program));
    document_add_command(document, making->command);
    document_add_paragraph(document, count ? "The same files, command and version give the same numbers to the last "
                                             "bit; the digest shows whether they did."
                                           : "The same files, command and version give the same numbers to the last "
                                             "bit.");
    if (!count)
        return;
    document_add_table(document, NULL, columns, sizeof columns / sizeof *columns);
    for (size_t r = 0; r < count; r++) {
        const Observation *observation = runs[r].observation;
        const char *cells[] = {runs[r].house->plan.path, document_text(document, "%" PRIu64, runs[r].house->seed),
                               document_text(document, "%g", observation->dt),
                               document_text(document, "%" PRIu64, observation->steps),
                               document_text(document, "%016" PRIx64, observation->digest)};
        document_add_row(document, cells);
    }
}

/* Adds a pair of a name and an id, unless they are the same. */
static void add_pair(Text *text, const char *name, const char *kind, const char *id) {
    bool same = strncmp(name, kind, strlen(kind)) == 0 && strcmp(name + strlen(kind), id) == 0;
    if (!same)
        text_format(text, "%s%s is %s%s", text->used ? "; " : "", name, kind, id);
}

void report_basis_add_names(Document *document, const House *house) {
    Text text = {0};
    for (size_t d = 0; d < house->plan.door_count; d++)
        add_pair(&text, names_door(&house->plan, d, &document->arena), "door ", house->plan.doors[d].id);
    for (size_t i = 0; i < house->person_count && house->person_count <= CENSUS_FEW; i++)
        add_pair(&text, names_person(house, i, &document->arena), "", house->people[i].id);
    if (text.used)
        document_add_paragraph(
            document, document_text(document, "Names here and ids in the house's file and the data: %s.", text.text));
    memory_free(text.text);
}
