#include <stdio.h>

#include "base/text.h"
#include "command/answer.h"
#include "command/command.h"
#include "command/house_file.h"
#include "command/output.h"
#include "command/progress.h"
#include "command/report_files.h"
#include "laboratory/shipped.h"
#include "report/ablation_report.h"
#include "result/ablation.h"
#include "result/json.h"
#include "result/text.h"

/* Without --drivers. */
enum { DRIVERS_USUAL = 100 };

static bool is_of_population(const Ablation *ablation, size_t person) {
    const Drivers *drivers = &ablation->drivers[ABLATION_WHOLE];
    for (size_t k = 0; k < drivers->count; k++)
        if (drivers->runs[k * drivers->person_count + person].varies)
            return true;
    return false;
}

static json_t *answer_of(const Ablation *ablation, const Population *population) {
    const House *house = &ablation->house;
    json_t *people = json_array();
    for (size_t i = 0; i < house->person_count; i++)
        if (is_of_population(ablation, i))
            json_array_append_new(people, json_pack("{s:s, s:o}", "id", house->people[i].id, "variants",
                                                    result_json_take_list(result_ablation_table(ablation, i))));
    return json_pack("{s:s, s:s, s:s, s:I, s:o, s:o}", "kind", "ablate", "house", house->plan.name, "population",
                     population->id, "count", (json_int_t)ablation->drivers[ABLATION_WHOLE].count, "variants",
                     result_json_take_list(result_ablation_variants(population)), "people", people);
}

static void print_answer(const Ablation *ablation, const Population *population) {
    const House *house = &ablation->house;
    Text text = {0};
    text_format(&text, "%s: the same %zu drivers of the population %s in every row\n", house->plan.name,
                ablation->drivers[ABLATION_WHOLE].count, population->id);
    bool any = false;
    for (size_t i = 0; i < house->person_count; i++) {
        if (!is_of_population(ablation, i))
            continue;
        any = true;
        text_format(&text, "\n%s", house->people[i].id);
        result_text_take(&text, "", result_ablation_table(ablation, i));
        text_add(&text, "\n");
        result_ablation_say(&text, ablation, i);
    }
    if (!any)
        text_format(&text, "nobody in this house has its profile, %s\n", population->profile);
    result_text_take(&text, "", result_ablation_variants(population));
    output_text(&text);
    memory_free(text.text);
}

/* Writes ablate.json and the report. */
static bool write_files(const Ablation *ablation, const Population *population, const json_t *answer,
                        const Options *options) {
    char path[OUTPUT_PATH];
    snprintf(path, sizeof path, "%s/ablate.json", options->out);
    int error = answer_write(answer, path);
    if (error)
        output_failed(path, error);
    char *command = report_files_command(options);
    const Making making = report_files_making(options, command);
    Document document = ablation_report_make(ablation, population, &making);
    bool good = !error && report_files_write(&document, "ablate", options);
    document_clear(&document);
    memory_free(command);
    return good;
}

/* Prints and writes what all variants have led to. Returns the exit code. */
static int answer(const Ablation *ablation, const Population *population, const Options *options) {
    json_t *object = answer_of(ablation, population);
    bool written = !options->out || write_files(ablation, population, object, options);
    if (options->json)
        answer_print(json_incref(object));
    else
        print_answer(ablation, population);
    if (options->out && written && !options->json)
        printf("\nablate.json, ablate.html and ablate.pdf are in %s\n", options->out);
    json_decref(object);
    return written ? EXIT_ANSWERED : EXIT_WRONG_INPUT;
}

int command_ablate(const Options *options) {
    Population population = {0};
    Fault fault = {0};
    Ablation ablation = {0};
    const HouseOptions house_options = {.profiles = shipped_places()->profiles,
                                        .settings = options->settings,
                                        .setting_count = options->setting_count,
                                        .seed = options->seed,
                                        .driving = -1};
    House house = {0};
    bool good = house_read(&house, options->files[0], &house_options, &fault) &&
                house_file_population(&population, options, &house.plan, &fault) && output_directory(options->out);
    size_t asked = house_file_drivers(options, &house.plan), count = asked ? asked : DRIVERS_USUAL;
    house_free(&house); /* each variant is read by itself */
    if (!good || !ablation_run(&ablation, options->files[0], &house_options, &population, count, options->jobs,
                               &progress_stop, &fault)) {
        population_free(&population);
        return house_file_report(&fault);
    }
    int code = EXIT_ANSWER_NO;
    if (!ablation.interrupted) {
        code = answer(&ablation, &population, options);
    } else {
        fprintf(stderr, "clearance: interrupted before all drivers had run; nothing is compared or written\n");
        if (options->json) {
            json_t *object = json_pack("{s:s}", "kind", "ablate");
            answer_mark_interrupted(object, true);
            answer_print(object);
        }
    }
    ablation_free(&ablation);
    population_free(&population);
    return code;
}
