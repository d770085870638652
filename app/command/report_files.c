#include "command/report_files.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "base/text.h"
#include "command/frames.h"
#include "command/house_file.h"
#include "command/output.h"
#include "command/progress.h"
#include "document/html.h"
#include "document/pdf.h"
#include "report/comparison_report.h"
#include "report/house_report.h"
#include "report/report_loci.h"

enum { LINE_MOST = 88 /* characters of a line of a command, as many as a page has */ };

bool report_files_possible(const Options *options) {
    const char *missing = options->report && !options->out        ? "--report needs --out DIR: where to write it"
                          : options->observed && !options->report ? "--observed needs --report: only that shows it"
                                                                  : NULL;
    if (missing)
        fprintf(stderr, "clearance: %s\n", missing);
    return !missing;
}

bool report_files_read_observed(ObservedLoci *observed, const House *house, const Options *options, Fault *fault) {
    if (!options->observed)
        return true;
    if (!report_loci_make_sense(house)) {
        fault_add(fault, "%s:1:1: observed loci are shown of a few people in chairs, not of the %zu in this house",
                  options->observed, house->person_count);
        return false;
    }
    bool good = observed_read(observed, options->observed, fault) && report_loci_check(house, observed, fault);
    if (!good)
        observed_free(observed);
    return good;
}

/* The command ------------------------------------------------------------------------------------------------------ */

/* Adds a word, quoted as a shell reads it back. */
static void add_quoted(Text *text, const char *word) {
    static const char plain[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_./=:,@%+-";
    if (*word && !word[strspn(word, plain)]) {
        text_add(text, word);
        return;
    }
    text_add(text, "'");
    for (const char *at = word; *at; at++) {
        const char one[] = {*at, 0};
        text_add(text, *at == '\'' ? "'\\''" : one);
    }
    text_add(text, "'");
}

/* Returns the command on several lines, each but the last ended by a backslash. */
char *report_files_command(const Options *options) {
    Text text = {0};
    size_t begin = 0;
    for (int a = 0; a < options->argument_count; a++) {
        Text word = {0};
        add_quoted(&word, options->arguments[a]);
        if (a && text.used - begin + word.used + 3 > LINE_MOST) {
            text_add(&text, " \\\n   ");
            begin = text.used - 3;
        }
        text_add(&text, a ? " " : "");
        text_add(&text, word.text);
        memory_free(word.text);
    }
    return text.text;
}

Making report_files_making(const Options *options, const char *command) {
    return (Making){.command = command,
                    .program = "clearance " CLEARANCE_VERSION,
                    .settings = options->settings,
                    .setting_count = options->setting_count};
}

/* The files -------------------------------------------------------------------------------------------------------- */

/* Returns the time now, or that of $SOURCE_DATE_EPOCH, s since 1970. */
static time_t created(void) {
    const char *given = getenv("SOURCE_DATE_EPOCH");
    char *end = NULL;
    long long seconds = given ? strtoll(given, &end, 10) : 0;
    bool good = given && *given && !*end && seconds >= 0 && seconds < 253402300800; /* the year 10000 */
    return good ? (time_t)seconds : time(NULL);
}

bool report_files_write(const Document *document, const char *name, const Options *options) {
    char path[OUTPUT_PATH];
    snprintf(path, sizeof path, "%s/%s.html", options->out, name);
    int error = html_write(document, path, options->theme);
    if (!error) {
        snprintf(path, sizeof path, "%s/%s.pdf", options->out, name);
        error = pdf_write(document, path, created());
    }
    if (error)
        output_failed(path, error);
    return !error;
}

static bool drives_only(const House *house, int driving) {
    for (size_t i = 0; i < house->profile_count; i++)
        if (house->profiles[i].driving != DRIVING_WALKER && house->profiles[i].driving != driving)
            return false;
    return true;
}

/* Runs the house with the other driving model; does nothing if it has none. */
typedef struct Another {
    House house;
    Observation observation;
    bool run;
} Another;

static void run_another(Another *another, const Options *options, int driving, size_t route) {
    Fault fault = {0};
    Options chosen = *options;
    chosen.driving = driving;
    another->run = house_file_read(&another->house, &chosen, 0, &fault);
    fault_clear(&fault);
    if (another->run)
        house_file_run(&another->observation, &another->house, options, route);
}

static void clear_another(Another *another) {
    if (another->run)
        observation_free(&another->observation);
    house_free(&another->house);
}

bool report_files_write_run(const House *house, const Observation *observation, const ObservedLoci *observed,
                            const ReportedDrivers *drivers, const Options *options, size_t route) {
    if (!options->report)
        return true;
    Another others[2] = {{.run = false}};
    char *command = report_files_command(options);
    const Making making = report_files_making(options, command);
    HouseReport report = {.run = {house, observation},
                          .observed = options->observed ? observed : NULL,
                          .drivers = *drivers,
                          .making = &making};
    for (int driving = 0; driving < 2 && report_loci_make_sense(house); driving++) {
        Another *another = &others[driving];
        if (drives_only(house, driving)) {
            report.by_driving[driving] = report.run;
            continue;
        }
        run_another(another, options, driving, route);
        if (another->run && !another->observation.interrupted)
            report.by_driving[driving] = (Reported){&another->house, &another->observation};
    }
    RaisedPicture raised = {.pixels = NULL};
    if (observation->time > 0 && frames_draw_raised(house, observation, options, &raised))
        report.raised = &raised;
    Document document = house_report_make(&report);
    bool written = report_files_write(&document, "report", options);
    document_clear(&document);
    memory_free(raised.pixels);
    for (int driving = 0; driving < 2; driving++)
        clear_another(&others[driving]);
    memory_free(command);
    return written;
}

bool report_files_write_comparison(const House houses[2], const Observation observations[2],
                                   const PairedDrivers *drivers, const Options *options) {
    if (!options->report)
        return true;
    char *command = report_files_command(options);
    const Making making = report_files_making(options, command);
    const Reported runs[2] = {{&houses[0], &observations[0]}, {&houses[1], &observations[1]}};
    Document document = comparison_report_make(runs, drivers, &making);
    bool written = report_files_write(&document, "report", options);
    document_clear(&document);
    memory_free(command);
    return written;
}
