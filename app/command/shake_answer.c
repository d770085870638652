#include "command/shake_answer.h"

#include <inttypes.h>
#include <stdio.h>

#include "command/output.h"
#include "command/report_files.h"
#include "plot/plot_write.h"
#include "result/source_line.h"
#include "visual/house/shake_plots.h"
#include "visual/house/shake_scene.h"
#include "report/shake_report.h"
#include "result/json.h"
#include "result/shake.h"
#include "result/text.h"
#include "study/summary.h"

/* JSON ------------------------------------------------------------------------------------------------------------- */

static json_t *whole(size_t value) {
    return json_integer((json_int_t)value);
}

static json_t *worst_of(const ShakeFindings *findings) {
    if (!findings->worst)
        return json_null();
    return json_pack("{s:I, s:s}", "seed", (json_int_t)findings->worst->seed, "settings", findings->made_by);
}

json_t *shake_answer_make(const ShakeFindings *findings, const char *file) {
    const Study *study = findings->study;
    SummaryCount count = summary_count(study);
    char digest[17];
    snprintf(digest, sizeof digest, "%016" PRIx64, summary_digest(study));
    json_t *answer = json_pack("{s:s, s:s, s:s, s:I, s:o, s:o, s:o}", "kind", "shake", "house",
                               findings->house->plan.name, "file", file, "seed", (json_int_t)study->seed, "shakes",
                               whole(count.trials), "done", whole(count.done), "faults", whole(count.faults));
    result_json_take_record(answer, result_shake_answer(findings));
    json_object_set_new(answer, "people", result_json_take_list(result_shake_people(findings)));
    json_object_set_new(answer, "furniture", result_json_take_list(result_shake_furniture(findings)));
    result_json_take_record(answer, result_shake_stops(findings));
    json_object_set_new(answer, "worst", worst_of(findings));
    json_object_set_new(answer, "digest", json_string(digest));
    return answer;
}

/* Files ------------------------------------------------------------------------------------------------------------ */

static bool write_plan(const ShakeFindings *findings, const Options *options) {
    Scene scene;
    shake_scene_make(&scene, findings);
    bool written = output_stills(&scene, options);
    scene_clear(&scene);
    return written;
}

static bool write_times(const ShakeFindings *findings, const Options *options) {
    Arena arena = {0};
    Plot plot;
    char path[PLOT_WRITE_PATH];
    int error = 0;
    PlotSheet sheet = output_sheet(options, source_line_house(&findings->house->plan, &arena));
    if (shake_plots_times(&plot, findings, &arena))
        error = plot_write_files(&plot, "times", options->out, &sheet, path);
    if (error)
        output_failed(path, error);
    arena_clear(&arena);
    return !error;
}

static bool write_report(const ShakeFindings *findings, const Options *options) {
    if (!options->report)
        return true;
    char *command = report_files_command(options);
    const Making making = report_files_making(options, command);
    Document document = shake_report_make(findings, &making);
    bool written = report_files_write(&document, "report", options);
    document_clear(&document);
    memory_free(command);
    return written;
}

bool shake_answer_write(const ShakeFindings *findings, const Options *options) {
    return write_plan(findings, options) && write_times(findings, options) && write_report(findings, options);
}

/* Text --------------------------------------------------------------------------------------------------------------
 */

enum { ROWS_MOST = 20 };

/* Adds a table below an empty line, shortened to the first rows; the table is released. */
static void add_table(Text *text, ResultTable table) {
    size_t all = table.record_count, listed = all < ROWS_MOST ? all : ROWS_MOST;
    table.record_count = listed;
    result_text_take(text, "", table);
    if (listed < all)
        text_format(text, "and %zu more\n", all - listed);
}

static void add_answer(Text *text, const ShakeFindings *findings) {
    ResultTable answer = result_shake_answer(findings), stops = result_shake_stops(findings);
    text_add(text, "\n");
    result_text_list(text, (const ResultTable *const[]){&answer, &stops}, 2);
    result_clear(&answer);
    result_clear(&stops);
}

static void print_faults(const ShakeFindings *findings) {
    const Study *study = findings->study;
    size_t faults = 0;
    const char *first = NULL;
    for (size_t t = 0; t < study->trial_count; t++) {
        faults += study_nth(study, t)->fault != NULL;
        first = first ? first : study_nth(study, t)->fault;
    }
    if (faults)
        printf(faults == 1 ? "\n%zu shake could not be simulated: %s\n"
                           : "\n%zu shakes could not be simulated; the first: %s\n",
               faults, first);
}

void shake_answer_print(const ShakeFindings *findings, const char *file) {
    Arena arena = {0};
    Text text = {0};
    text_format(&text, "%s\n%s: %s\n", shake_findings_headline(findings, &arena), file,
                result_shake_simulated(findings, &arena));
    if (!findings->toppling)
        text_add(&text, "Nothing in this house can fall: all shakes are alike\n");
    add_answer(&text, findings);
    add_table(&text, result_shake_people(findings));
    if (findings->shakes)
        add_table(&text, result_shake_furniture(findings));
    output_text(&text);
    if (findings->worst)
        printf(*findings->made_by ? "\nFewest people are out in the shake with seed %" PRIu64
                                    ": clearance run HOUSE %s\n"
                                  : "\nFewest people are out in the shake with seed %" PRIu64 "%s\n",
               findings->worst->seed, findings->made_by);
    print_faults(findings);
    memory_free(text.text);
    arena_clear(&arena);
}
