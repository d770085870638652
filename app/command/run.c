#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include "beam/beam.h"
#include "command/answer.h"
#include "command/command.h"
#include "command/frames.h"
#include "command/house_file.h"
#include "command/output.h"
#include "command/progress.h"
#include "command/report_files.h"
#include "command/run_beam.h"
#include "command/run_crank.h"
#include "crank/crank.h"
#include "experiment/drivers.h"
#include "exchange/jupedsim.h"
#include "result/check.h"
#include "result/danger.h"
#include "result/drivers.h"
#include "result/grade.h"
#include "result/json.h"
#include "result/text.h"
#include "visual/house/drivers_band.h"
#include "visual/house/drivers_scene.h"
#include "visual/house/grades_scene.h"
#include "visual/house/house_scene.h"

static json_t *answer_of(const House *house, const Observation *observation, ReportedDrivers fleets) {
    json_t *answer = answer_house(house, observation);
    const Drivers *drivers = fleets.drivers;
    if (drivers->count)
        json_object_set_new(answer, "drivers",
                            json_pack("{s:s, s:I, s:o, s:o, s:o}", "population", fleets.population->id, "count",
                                      (json_int_t)drivers->count, "people",
                                      result_json_take_list(result_drivers_table(house, observation, drivers)),
                                      "routes", result_json_take_list(result_drivers_routes(house, drivers)),
                                      "measured", result_json_take_list(result_drivers_measured(house, drivers))));
    json_object_set_new(answer, "places", result_json_take_list(result_danger_places(house, observation, drivers)));
    const Grade *grades = fleets.grades ? fleets.grades : fleets.letters;
    if (grades)
        json_object_set_new(answer, "grades", result_json_take_list(result_check_grades(house, grades)));
    if (fleets.grades) {
        json_object_set_new(answer, "grade_places",
                            result_json_take_list(result_check_grade_places(house, fleets.grades)));
    }
    answer_mark_interrupted(answer, fleets.interrupted);
    return answer;
}

static int write_summary(const House *house, const Observation *observation, ReportedDrivers fleets, const char *path) {
    json_t *answer = answer_of(house, observation, fleets);
    int error = answer_write(answer, path);
    json_decref(answer);
    return error;
}

/* Writes the data files of a run, up to the first one that cannot be written. */
static bool write_data(const House *house, const Observation *observation, ReportedDrivers fleets,
                       const Options *options) {
    static const char *const names[] = {"summary.json", "trace.csv", "trajectory.sqlite"};
    int error = 0;
    char path[OUTPUT_PATH];
    for (size_t f = 0; f < sizeof names / sizeof *names && !error; f++) {
        snprintf(path, sizeof path, "%s/%s", options->out, names[f]);
        if (f == 0)
            error = write_summary(house, observation, fleets, path);
        else if (f == 1)
            error = trace_write_csv(&observation->trace, path);
        else
            error = jupedsim_write(house, observation, path);
    }
    if (error)
        output_failed(path, error);
    return !error;
}

/* Adds the band, the touches and the grades to a scene, and what they are to its answer. */
static void add_fleets(Scene *scene, const House *house, const Observation *observation, ReportedDrivers fleets) {
    if (fleets.letters && scene->title)
        result_grade_add(&scene->title, &scene->detail, house, fleets.letters, &scene->arena);
    const char *more = result_drivers_headline(house, fleets.drivers, fleets.grades, &scene->arena);
    if (*more && scene->title)
        scene->detail = observation->completed ? more : scene_text(scene, "%s \u00b7 %s", scene->detail, more);
    if (fleets.drivers->count)
        drivers_band_add(scene, fleets.drivers, &observation->trace);
    drivers_scene_add(scene, house, fleets.drivers);
    if (fleets.grades)
        grades_scene_add(scene, house, fleets.grades);
}

static bool write_frames(const House *house, const Observation *observation, ReportedDrivers fleets,
                         const Options *options) {
    Scene drivers = {0};
    add_fleets(&drivers, house, observation, fleets);
    const FramesFacts facts = {fleets.grades ? fleets.grades : fleets.letters, &drivers};
    bool written = frames_write(house, observation, (Before){.house = NULL}, &facts, options);
    scene_clear(&drivers);
    return written;
}

static bool write_results(const House *house, const Observation *observation, const ObservedLoci *observed,
                          ReportedDrivers fleets, const Options *options, size_t route) {
    if (options->out) {
        Scene scene = {0};
        house_scene_make(&scene, house, observation);
        add_fleets(&scene, house, observation, fleets);
        bool written = write_data(house, observation, fleets, options) && output_stills(&scene, options);
        scene_clear(&scene);
        if (!written || !report_files_write_run(house, observation, observed, &fleets, options, route))
            return false;
    }
    return !frames_wanted(options) || write_frames(house, observation, fleets, options);
}

static size_t find_route(const House *house, const Options *options) {
    return options->route ? plan_find_route(&house->plan, options->route) : SIZE_MAX;
}

/* Prints whose numbers diverged, when, and a remedy. */
static void report_divergence(const House *house, const Observation *observation) {
    for (size_t i = 0; i < observation->person_count; i++) {
        const PersonObservation *person = &observation->people[i];
        if (person->reason == REASON_DIVERGED)
            fprintf(stderr,
                    "clearance: the numbers of person %s diverged at %.3f s, the run ends with the last good state; "
                    "try a smaller run.dt or a softer contact of %s\n",
                    house->people[i].id, person->time, house->people[i].profile->name);
    }
}

static void print_drivers(const House *house, const Observation *observation, const Drivers *drivers,
                          const Population *population) {
    Text text = {0};
    text_format(&text, "\ndrivers of the population %s: %s\n", population->id, population->title);
    result_drivers_say(&text, house, observation, drivers);
    result_text_take(&text, "", result_drivers_table(house, observation, drivers));
    result_text_take(&text, "", result_drivers_routes(house, drivers));
    result_text_take(&text, "what they touch, worst first (`clearance help danger`)\n",
                     result_danger_places(house, observation, drivers));
    result_text_take(&text, "single measured runs\n", result_drivers_measured(house, drivers));
    output_text(&text);
    memory_free(text.text);
}

static void print_answer(const House *house, const Observation *observation, ReportedDrivers fleets) {
    Arena arena = {0};
    const Grade *grades = fleets.grades ? fleets.grades : fleets.letters;
    answer_text_print(house, observation, result_drivers_headline(house, fleets.drivers, grades, &arena));
    arena_clear(&arena);
}

static void print_grades(const House *house, const Drivers *drivers, const Grade *grades) {
    Text text = {0};
    result_text_take(&text, "how tight the ways are\n", result_check_grades(house, grades));
    result_text_take(&text, "", result_check_grade_places(house, grades));
    Text contradictions = {0};
    result_drivers_say_grades(&contradictions, house, drivers, grades);
    if (contradictions.used)
        text_format(&text, "\n%s", contradictions.text);
    memory_free(contradictions.text);
    if (text.text)
        output_text(&text);
    memory_free(text.text);
}

static void print_json(const House *house, const Observation *observation, ReportedDrivers fleets, bool interrupted) {
    json_t *answer = answer_of(house, observation, fleets);
    answer_mark_interrupted(answer, interrupted);
    answer_print(answer);
}

int command_run(const Options *options) {
    static const struct {
        bool (*is_file)(const char *path);
        int (*run)(const Options *options);
    } machines[] = {{beam_is_file, run_beam_file}, {crank_is_file, run_crank_file}};
    for (size_t i = 0; i < sizeof machines / sizeof *machines; i++)
        if (machines[i].is_file(options->files[0]))
            return machines[i].run(options);
    House house = {0};
    Fault fault = {0};
    if (frames_check(options) || !report_files_possible(options))
        return EXIT_WRONG_INPUT;
    if (!house_file_read(&house, options, 0, &fault))
        return house_file_report(&fault);
    size_t route = find_route(&house, options);
    if (options->route && route == SIZE_MAX) {
        fprintf(stderr, "clearance: %s has no route \"%s\"", options->files[0], options->route);
        for (size_t r = 0; r < house.plan.route_count; r++)
            fprintf(stderr, "%s%s", r ? ", " : ", its routes are ", house.plan.routes[r].id);
        fprintf(stderr, "\n");
        house_free(&house);
        return EXIT_WRONG_INPUT;
    }
    ObservedLoci observed = {0};
    Population population = {0};
    size_t count = house_file_drivers(options, &house.plan);
    if (!report_files_read_observed(&observed, &house, options, &fault) ||
        (count && !house_file_population(&population, options, &house.plan, &fault)) ||
        !output_directory(options->out)) {
        population_free(&population);
        observed_free(&observed);
        house_free(&house);
        return house_file_report(&fault);
    }
    Observation observation;
    Drivers drivers = {0};
    ReportedDrivers fleets = {.drivers = &drivers, .population = &population};
    house_file_run(&observation, &house, options, route);
    if (count && !observation.interrupted)
        drivers_run(&drivers, &house, &population, count, route, options->jobs, &progress_stop);
    report_divergence(&house, &observation);
    bool told = observation.interrupted || drivers.interrupted;
    Grade *grades = NULL;
    if (!told) {
        grades = options->grades ? memory_zeroed(house.person_count, sizeof *grades) : NULL;
        told = !(grades ? grade_all(grades, &house, options->jobs, &progress_stop)
                        : house_file_letters(&grades, &house, &observation, options));
        const Grade *known = told ? NULL : grades;
        fleets.grades = options->grades ? known : NULL;
        fleets.letters = options->grades ? NULL : known;
        if (told)
            fprintf(stderr, "clearance: interrupted before all ways were graded; no grades are told\n");
    }
    if (drivers.interrupted) {
        fprintf(stderr, "clearance: interrupted before all drivers had run; the answer is that of the nominal one\n");
        drivers_free(&drivers);
    } else if (observation.interrupted)
        fprintf(stderr, "clearance: interrupted at %.2f s of simulated time; the results up to there are kept\n",
                observation.time);
    fleets.interrupted = told;
    bool written = write_results(&house, &observation, &observed, fleets, options, route);
    bool interrupted = output_tell_interrupted(told);
    if (options->json)
        print_json(&house, &observation, fleets, interrupted);
    else
        print_answer(&house, &observation, fleets);
    if (drivers.count && !options->json)
        print_drivers(&house, &observation, &drivers, &population);
    if (fleets.grades && !options->json)
        print_grades(&house, &drivers, fleets.grades);
    if (options->out && written && !options->json)
        printf(options->report ? "\nreport.html, report.pdf, pictures and data are in %s\n"
                               : "\npictures and data are in %s\n",
               options->out);
    bool whole = observation.completed && !interrupted;
    int code = !written ? EXIT_WRONG_INPUT : whole ? EXIT_ANSWERED : EXIT_ANSWER_NO;
    drivers_free(&drivers);
    memory_free(grades);
    population_free(&population);
    observation_free(&observation);
    observed_free(&observed);
    house_free(&house);
    return code;
}
