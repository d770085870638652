#include "exchange/import.h"

#include <stdio.h>
#include <unistd.h>

#include "command/answer.h"
#include "command/command.h"
#include "command/house_file.h"
#include "command/output.h"
#include "house/house.h"
#include "laboratory/shipped.h"
#include "result/json.h"
#include "result/text.h"

/* One record of what was taken over. */
static ResultTable list_taken(const Plan *plan) {
    ResultTable table = {0};
    size_t people = plan->person_count;
    for (size_t c = 0; c < plan->crowd_count; c++)
        people += (size_t)plan->crowds[c].count;
    const struct {
        const char *what;
        size_t count;
    } all[] = {{"walls", plan->wall_count},  {"doors", plan->door_count}, {"furniture", plan->furniture_count},
               {"rooms", plan->room_count},  {"exits", plan->exit_count}, {"people", people},
               {"routes", plan->route_count}};
    for (size_t i = 0; i < sizeof all / sizeof *all; i++)
        result_add(&table, (ResultRow){.key = all[i].what,
                                       .label = all[i].what,
                                       .kind = RESULT_COUNT,
                                       .number = (double)all[i].count,
                                       .unknown = i > 0 && !all[i].count});
    result_end(&table);
    return table;
}

/* A record for each kind of thing that was left out. */
static ResultTable list_left_out(const ImportReport *report) {
    ResultTable table = {0};
    for (size_t i = 0; i < report->left_out_count; i++) {
        result_add(&table, (ResultRow){.key = "what", .label = "not taken over", .text = report->left_out[i].what});
        result_add(&table, (ResultRow){.key = "count",
                                       .label = "number",
                                       .kind = RESULT_COUNT,
                                       .number = (double)report->left_out[i].count});
        result_end(&table);
    }
    return table;
}

static void print_json(const Plan *plan, const ImportReport *report, const Options *options) {
    ResultTable taken = list_taken(plan), left_out = list_left_out(report);
    json_t *notes = json_array();
    for (size_t i = 0; i < report->note_count; i++)
        json_array_append_new(notes, json_string(report->notes[i]));
    answer_print(json_pack("{s:s, s:s, s:s, s:s, s:o, s:o, s:o}", "kind", "import", "file", options->files[0], "out",
                           options->files[1], "format", report->format, "taken", result_json_record(&taken, 0),
                           "left_out", result_json_list(&left_out), "notes", notes));
    result_clear(&taken);
    result_clear(&left_out);
}

static void print_text(const Plan *plan, const ImportReport *report, const Options *options) {
    ResultTable taken = list_taken(plan), left_out = list_left_out(report);
    Text text = {0};
    text_format(&text, "%s (%s)\n", options->files[0], report->format);
    result_text_record(&text, &taken, 0);
    if (left_out.record_count)
        text_add(&text, "\n");
    result_text_table(&text, &left_out);
    if (report->note_count)
        text_add(&text, "\n");
    for (size_t i = 0; i < report->note_count; i++)
        text_format(&text, "note: %s\n", report->notes[i]);
    text_format(&text, "\nwritten to %s\n", options->files[1]);
    printf("%s", text.text);
    memory_free(text.text);
    result_clear(&taken);
    result_clear(&left_out);
}

/* Notes errors of the written house, such as people without space: these show only when people are placed. */
static void check_people(const Plan *plan, ImportReport *report, const char *path) {
    if (!plan->person_count && !plan->crowd_count)
        return;
    House house = {.seed = 0};
    HouseOptions options = {.profiles = shipped_places()->profiles, .seed = 1, .driving = -1};
    Fault fault = {0};
    house_read(&house, path, &options, &fault);
    for (size_t i = 0; i < fault.count; i++)
        import_report_note(report, "to be put right: %s", fault.lines[i]);
    fault_clear(&fault);
    house_free(&house);
}

int command_import(const Options *options) {
    const char *out = options->files[1];
    if (access(out, F_OK) == 0) {
        fprintf(stderr, "clearance: %s exists and is not overwritten; choose another name\n", out);
        return EXIT_WRONG_INPUT;
    }
    ImportOptions wanted = {.unit = options->unit, .layers = options->layers, .level = options->level};
    Plan plan = {0};
    ImportReport report = {0};
    Fault fault = {0};
    int code = EXIT_ANSWERED;
    if (!import_read(&plan, options->files[0], &wanted, &report, &fault)) {
        code = house_file_report(&fault);
    } else {
        int error = plan_write(&plan, out);
        if (error) {
            output_failed(out, error);
            code = EXIT_WRONG_INPUT;
        } else {
            check_people(&plan, &report, out);
            (options->json ? print_json : print_text)(&plan, &report, options);
        }
    }
    import_report_clear(&report);
    plan_free(&plan);
    return code;
}
