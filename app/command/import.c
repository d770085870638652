#include "exchange/import.h"

#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "command/answer.h"
#include "command/command.h"
#include "command/house_file.h"
#include "command/output.h"
#include "house/house.h"
#include "laboratory/shipped.h"

typedef struct Taken {
    const char *what;
    size_t count;
} Taken;

enum { TAKEN = 7 };

static void list_taken(const Plan *plan, Taken taken[TAKEN]) {
    size_t people = plan->person_count;
    for (size_t c = 0; c < plan->crowd_count; c++)
        people += (size_t)plan->crowds[c].count;
    const Taken all[TAKEN] = {{"walls", plan->wall_count},          {"doors", plan->door_count},
                              {"furniture", plan->furniture_count}, {"rooms", plan->room_count},
                              {"exits", plan->exit_count},          {"people", people},
                              {"routes", plan->route_count}};
    memcpy(taken, all, sizeof all);
}

static void print_json(const Plan *plan, const ImportReport *report, const Options *options) {
    Taken taken[TAKEN];
    list_taken(plan, taken);
    json_t *counts = json_object(), *left = json_array(), *notes = json_array();
    for (size_t t = 0; t < TAKEN; t++)
        json_object_set_new(counts, taken[t].what, json_integer((json_int_t)taken[t].count));
    for (size_t i = 0; i < report->left_out_count; i++)
        json_array_append_new(left, json_pack("{s:s, s:I}", "what", report->left_out[i].what, "count",
                                              (json_int_t)report->left_out[i].count));
    for (size_t i = 0; i < report->note_count; i++)
        json_array_append_new(notes, json_string(report->notes[i]));
    answer_print(json_pack("{s:s, s:s, s:s, s:s, s:o, s:o, s:o}", "kind", "import", "file", options->files[0], "out",
                           options->files[1], "format", report->format, "taken", counts, "left_out", left, "notes",
                           notes));
}

static void print_text(const Plan *plan, const ImportReport *report, const Options *options) {
    Taken taken[TAKEN];
    list_taken(plan, taken);
    printf("%s (%s)", options->files[0], report->format);
    const char *before = ": ";
    for (size_t t = 0; t < TAKEN; t++) {
        if (taken[t].count || t == 0)
            printf("%s%s %zu", before, taken[t].what, taken[t].count);
        before = ", ";
    }
    printf("\n");
    for (size_t i = 0; i < report->left_out_count; i++)
        printf("not taken over: %s (%zu)\n", report->left_out[i].what, report->left_out[i].count);
    for (size_t i = 0; i < report->note_count; i++)
        printf("note: %s\n", report->notes[i]);
    printf("written to %s\n", options->files[1]);
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
