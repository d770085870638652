#include <stdint.h>
#include <stdio.h>

#include "base/text.h"
#include "command/answer.h"
#include "command/command.h"
#include "command/house_file.h"
#include "command/output.h"
#include "command/progress.h"
#include "command/report_files.h"
#include "laboratory/shipped.h"
#include "report/rules_report.h"
#include "result/json.h"
#include "result/rules.h"
#include "result/rules_drivers.h"
#include "result/text.h"
#include "visual/house/rules_scene.h"

static void print_answer(const House *house, const RuleSets *sets, const Inspection *inspection) {
    Arena arena = {0};
    Text text = {0};
    text_format(&text, "%s\n%s", result_rules_sentence(inspection, &arena), house->plan.name);
    if (!inspection->interrupted)
        text_format(&text, ": %s", result_rules_counts(inspection, &arena));
    text_add(&text, "\n");
    result_text_take(&text, "where chairs are stopped\n", result_rules_stops(inspection));
    for (FindingGroup group = GROUP_LEGAL_IMPASSABLE; group <= GROUP_OPEN; group++)
        result_text_take(&text, text_in_arena(&arena, "%s\n", result_rules_group(group)),
                         result_rules_findings(inspection, group));
    for (size_t s = 0; s < sets->count; s++)
        text_format(&text, "%s%s: %s\n", s ? "" : "\n", sets->sets[s].id, sets->sets[s].note);
    output_text(&text);
    memory_free(text.text);
    arena_clear(&arena);
}

/* Returns a count, or NULL, which leaves the key out, if it is unknown. */
static json_t *count_of(const Inspection *inspection, int verdict) {
    return inspection->interrupted ? NULL : json_integer((json_int_t)inspection->counts[verdict]);
}

/* An interrupted inspection has no numbers: its answer has only the keys that are known. */
static json_t *answer_of(const House *house, const RuleSets *sets, const Inspection *inspection) {
    Arena arena = {0};
    bool known = !inspection->interrupted;
    json_t *answer = json_pack(
        "{s:s, s:s, s:s, s:s, s:o*, s:o*, s:o*, s:o*, s:o*, s:o*, s:o}", "kind", "rules", "house", house->plan.name,
        "note", house->plan.note, "headline", result_rules_sentence(inspection, &arena), "legal_impassable",
        known ? json_boolean(inspection_legal_impassable(inspection) != NULL) : NULL, "pass",
        count_of(inspection, RULE_PASSES), "fail", count_of(inspection, RULE_FAILS), "unknown",
        count_of(inspection, RULE_OPEN), "findings", known ? result_json_take_list(result_rules_all(inspection)) : NULL,
        "stops", known ? result_json_take_list(result_rules_stops(inspection)) : NULL, "sets",
        result_json_take_list(result_rules_sets(inspection, sets)));
    answer_mark_interrupted(answer, inspection->interrupted);
    arena_clear(&arena);
    return answer;
}

/* Writes rules.json, the plan and the report. */
static bool write_files(const House *house, const RuleSets *sets, const Inspection *inspection, const json_t *answer,
                        const Options *options) {
    Scene scene = {0};
    Arena arena = {0};
    char path[OUTPUT_PATH];
    snprintf(path, sizeof path, "%s/rules.json", options->out);
    int error = answer_write(answer, path);
    if (error)
        output_failed(path, error);
    rules_scene_make(&scene, house, inspection, result_rules_title(inspection, &arena),
                     result_rules_detail(inspection, &arena));
    bool good = !error && output_stills(&scene, options);
    scene_clear(&scene);
    arena_clear(&arena);
    char *command = report_files_command(options);
    const Making making = report_files_making(options, command);
    Document document = rules_report_make(house, sets, inspection, &making);
    good = good && report_files_write(&document, "rules", options);
    document_clear(&document);
    memory_free(command);
    return good;
}

/* Drives the drivers of a population, tries their bodies and grades the ways. */
static void try_drivers(Inspection *inspection, const House *house, const Population *population,
                        const Options *options) {
    size_t count = (size_t)options->drivers;
    Drivers drivers;
    Shares *shares = memory_zeroed(house->person_count + 1, sizeof *shares);
    Grade *grades = memory_zeroed(house->person_count + 1, sizeof *grades);
    drivers_run(&drivers, house, population, count, SIZE_MAX, options->jobs, &progress_stop);
    shares_find(shares, house, population, count, SIZE_MAX, options->jobs, &progress_stop);
    bool whole = grade_all(grades, house, options->jobs, &progress_stop) && !drivers.interrupted;
    for (size_t i = 0; i < house->person_count; i++)
        whole &= !shares[i].interrupted;
    if (whole)
        result_rules_drivers_take(inspection, house, population->id, &drivers, shares, grades);
    else
        fprintf(stderr, "clearance: interrupted before all drivers had run; nothing is told of them\n");
    drivers_free(&drivers);
    memory_free(shares);
    memory_free(grades);
}

int command_rules(const Options *options) {
    House house = {0};
    RuleSets sets = {0};
    Fault fault = {0};
    Population population = {0};
    bool good = rule_set_read_all(&sets, shipped_places()->rules, options->rules, &fault) &&
                house_file_read(&house, options, 0, &fault) &&
                (!options->drivers || house_file_population(&population, options, &house.plan, &fault)) &&
                output_directory(options->out);
    if (!good) {
        population_free(&population);
        house_free(&house);
        rule_set_free_all(&sets);
        return house_file_report(&fault);
    }
    Inspection inspection = inspection_make(&house, &sets, options->jobs, &progress_stop);
    if (options->drivers && !inspection.interrupted)
        try_drivers(&inspection, &house, &population, options);
    json_t *answer = answer_of(&house, &sets, &inspection);
    int code = inspection.counts[RULE_FAILS] || inspection.interrupted ? EXIT_ANSWER_NO : EXIT_ANSWERED;
    if (options->json)
        answer_print(json_incref(answer));
    else
        print_answer(&house, &sets, &inspection);
    if (options->out && !inspection.interrupted && !write_files(&house, &sets, &inspection, answer, options))
        code = EXIT_WRONG_INPUT;
    json_decref(answer);
    inspection_free(&inspection);
    population_free(&population);
    house_free(&house);
    rule_set_free_all(&sets);
    return code;
}
