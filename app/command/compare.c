#include <stdint.h>
#include <stdio.h>

#include "command/answer.h"
#include "command/command.h"
#include "command/frames.h"
#include "command/house_file.h"
#include "command/output.h"
#include "command/progress.h"
#include "command/report_files.h"
#include "experiment/drivers.h"
#include "result/check.h"
#include "result/drivers.h"
#include "result/grade.h"
#include "result/house.h"
#include "result/json.h"
#include "result/text.h"
#include "visual/house/house_scene.h"
#include "result/headline.h"

/* Prints two tables of the same kind with the differences; both are released. */
static void print_pair(ResultTable a, ResultTable b, const char *succeeded, const char *alike) {
    ResultPair pair = {&a, &b, {"a", "b", "b - a"}, succeeded, alike};
    ResultTable table = {0};
    Text text = {0};
    result_compare(&table, &pair);
    result_text_table(&text, &table);
    printf("\n%s", text.text ? text.text : "");
    for (size_t i = 0; i < a.record_count; i++)
        if (result_partner(&pair, i) == SIZE_MAX)
            printf("%s is not in b\n", result_at(&a, i, 0)->text);
    memory_free(text.text);
    result_clear(&table);
    result_clear(&a);
    result_clear(&b);
}

static bool is_interrupted(const Observation observations[2]) {
    return observations[0].interrupted || observations[1].interrupted;
}

static void print_comparison(const House houses[2], const Observation observations[2], const Grade *const letters[2]) {
    Arena arena = {0};
    for (int h = 0; h < 2; h++) {
        const char *grade = letters[h] ? result_grade_phrase(&houses[h], letters[h], &arena) : "";
        printf("%c: %s: %s%s%s\n", "ab"[h], houses[h].plan.name,
               headline_sentence(&houses[h], &observations[h], &arena), *grade ? "; " : "", grade);
    }
    arena_clear(&arena);
    if (is_interrupted(observations))
        return;
    Census census[2] = {census_make(&houses[0], &observations[0]), census_make(&houses[1], &observations[1])};
    if (census[0].people > CENSUS_ROWS)
        print_pair(result_house_parties(&houses[0], &census[0], false),
                   result_house_parties(&houses[1], &census[1], false), "out", "profile");
    else
        print_pair(result_house_people(&houses[0], &observations[0]), result_house_people(&houses[1], &observations[1]),
                   "completed", NULL);
    for (int h = 0; h < 2; h++)
        census_clear(&census[h]);
}

static json_t *differences(const House houses[2], const Observation observations[2]) {
    ResultTable a = result_house_people(&houses[0], &observations[0]),
                b = result_house_people(&houses[1], &observations[1]);
    ResultPair pair = {.a = &a, .b = &b, .succeeded = "completed"};
    json_t *rows = result_json_differences(&pair);
    result_clear(&a);
    result_clear(&b);
    return rows;
}

static json_t *answer_of(const House *house, const Observation *observation, const Grade *letters) {
    json_t *answer = answer_house(house, observation);
    if (letters)
        json_object_set_new(answer, "grades", result_json_take_list(result_check_grades(house, letters)));
    return answer;
}

/* The differences from an interrupted run are unknown, and left out. */
static json_t *make_answer(const House houses[2], const Observation observations[2], const Grade *const letters[2],
                           bool interrupted) {
    json_t *answer =
        json_pack("{s:s, s:o, s:o, s:o*}", "kind", "compare", "a", answer_of(&houses[0], &observations[0], letters[0]),
                  "b", answer_of(&houses[1], &observations[1], letters[1]), "differences",
                  is_interrupted(observations) ? NULL : differences(houses, observations));
    answer_mark_interrupted(answer, interrupted);
    return answer;
}

/* Writes the pictures of B, with the paths in A as "before". */
static bool write_pictures(const House houses[2], const Observation observations[2], Grade *const letters[2],
                           const Options *options) {
    const Before before = {.house = &houses[0], .observation = &observations[0], .letters = letters[0]};
    if (options->out) {
        Scene scene = {0};
        house_scene_make_compared(&scene, &houses[1], &observations[1], before);
        if (letters[1] && scene.title)
            result_grade_add(&scene.title, &scene.detail, &houses[1], letters[1], &scene.arena);
        bool written = output_stills(&scene, options);
        scene_clear(&scene);
        if (!written)
            return false;
    }
    return !frames_wanted(options) ||
           frames_write(&houses[1], &observations[1], before, &(FramesFacts){.letters = letters[1]}, options);
}

/* Runs the same drivers through both houses. Returns false if interrupted. */
static bool run_drivers(Drivers drivers[2], const House houses[2], const Population *population, size_t count,
                        const Options *options) {
    for (int h = 0; h < 2; h++)
        drivers_run(&drivers[h], &houses[h], population, count, SIZE_MAX, options->jobs, &progress_stop);
    if (!drivers[0].interrupted && !drivers[1].interrupted)
        return true;
    for (int h = 0; h < 2; h++)
        drivers_free(&drivers[h]);
    return false;
}

/* Adds the differences of the drivers to the answer, or prints them. */
static void tell_drivers(const House houses[2], const PairedDrivers *drivers, json_t *answer) {
    const char *population = drivers->population->id;
    if (answer) {
        json_object_set_new(answer, "drivers",
                            json_pack("{s:s, s:o}", "population", population, "people",
                                      result_json_take_list(result_drivers_paired(houses, drivers->of))));
        return;
    }
    Text text = {0};
    text_format(&text, "\nthe same %zu drivers of the population %s in both:\n", drivers->of[0].count, population);
    result_drivers_paired_say(&text, houses, drivers->of);
    result_text_take(&text, "", result_drivers_paired(houses, drivers->of));
    output_text(&text);
    memory_free(text.text);
}

int command_compare(const Options *options) {
    House houses[2] = {{.seed = 0}};
    Observation observations[2];
    Fault fault = {0};
    if (frames_check(options) || !report_files_possible(options))
        return EXIT_WRONG_INPUT;
    bool first = house_file_read(&houses[0], options, 0, &fault);
    bool second = house_file_read(&houses[1], options, 1, &fault);
    Population population = {0};
    const Plan *asks = &houses[houses[0].plan.drivers.count ? 0 : 1].plan; /* the first house that asks for drivers */
    size_t count = house_file_drivers(options, asks);
    if (!first || !second || (count && !house_file_population(&population, options, asks, &fault)) ||
        !output_directory(options->out)) {
        population_free(&population);
        house_free(&houses[0]);
        house_free(&houses[1]);
        return house_file_report(&fault);
    }
    for (int h = 0; h < 2; h++)
        house_file_run(&observations[h], &houses[h], options, SIZE_MAX);
    bool told = is_interrupted(observations);
    if (told)
        fprintf(stderr, "clearance: interrupted; nothing is compared or written\n");
    Grade *letters[2] = {NULL, NULL};
    for (int h = 0; h < 2 && !told; h++)
        if (!house_file_letters(&letters[h], &houses[h], &observations[h], options)) {
            fprintf(stderr,
                    "clearance: interrupted before all ways were graded; no grades are told, nothing is written\n");
            told = true;
        }
    for (int h = 0; h < 2 && told; h++) {
        memory_free(letters[h]);
        letters[h] = NULL;
    }
    bool nothing = told, written = nothing || write_pictures(houses, observations, letters, options);
    told = output_tell_interrupted(told);
    Drivers of[2] = {{.count = 0}};
    const PairedDrivers drivers = {of, &population, {letters[0], letters[1]}};
    if (count && !told && !run_drivers(of, houses, &population, count, options)) {
        fprintf(stderr, "clearance: interrupted before all drivers had run; they are not compared\n");
        told = true;
    }
    written = written && (nothing || report_files_write_comparison(houses, observations, &drivers, options));
    bool interrupted = output_tell_interrupted(told);
    json_t *answer = options->json ? make_answer(houses, observations, drivers.letters, interrupted) : NULL;
    if (!answer)
        print_comparison(houses, observations, drivers.letters);
    if (of[0].count)
        tell_drivers(houses, &drivers, answer);
    if (answer)
        answer_print(answer);
    population_free(&population);
    if (options->out && written && !told && !options->json)
        printf("\npictures are in %s\n", options->out);
    bool all = observations[0].completed && observations[1].completed && !interrupted;
    for (int h = 0; h < 2; h++) {
        drivers_free(&of[h]);
        memory_free(letters[h]);
        observation_free(&observations[h]);
        house_free(&houses[h]);
    }
    return !written ? EXIT_WRONG_INPUT : all ? EXIT_ANSWERED : EXIT_ANSWER_NO;
}
