#include <stdint.h>
#include <stdio.h>

#include "command/answer.h"
#include "command/command.h"
#include "command/frames.h"
#include "command/house_file.h"
#include "command/output.h"
#include "command/progress.h"
#include "command/report_files.h"
#include "visual/house/census.h"
#include "visual/house/house_scene.h"
#include "visual/house/headline.h"

static void print_row(const char *name, const char *id, const PersonObservation *person) {
    printf("%-12s %-8s %9.2f %11.3f %9d %8.0f %8.1f  %s\n", id, name, person->time, person->narrowest, person->contacts,
           person->peak_force, person->lost_time, person->completed ? "out" : observation_reason(person->reason));
}

static void print_party(const char *name, const char *id, const Party *party) {
    char mean[16] = "-", last[16] = "-";
    if (party->out) {
        snprintf(mean, sizeof mean, "%.2f", party->mean);
        snprintf(last, sizeof last, "%.2f", party->last);
    }
    printf("%-20s %-8s %8zu %8zu %9s %9s %9d %8.0f %8.1f\n", id, name, party->people, party->out, mean, last,
           party->contacts, party->peak_force, party->lost);
}

/* A row a crowd; where nobody is out there are no times to compare. */
static void print_parties(const House houses[2], const Census census[2]) {
    printf("\n%-20s %-8s %8s %8s %9s %9s %9s %8s %8s\n", "people", "", "number", "out", "mean s", "last s", "contacts",
           "peak N", "lost s");
    for (size_t p = 0; p < census[0].party_count; p++) {
        const Party *a = &census[0].parties[p];
        const char *id = census_party_name(&houses[0], a);
        const Party *b = census_find_party(&houses[1], &census[1], id, a->profile->name);
        if (!b) {
            printf("%-20s is not in b\n", id);
            continue;
        }
        print_party("a", id, a);
        print_party("b", "", b);
        if (a->out && b->out)
            printf("%-20s %-8s %+8ld %+8ld %+9.2f %+9.2f %+9d %+8.0f %+8.1f\n", "", "b - a",
                   (long)b->people - (long)a->people, (long)b->out - (long)a->out, b->mean - a->mean, b->last - a->last,
                   b->contacts - a->contacts, b->peak_force - a->peak_force, b->lost - a->lost);
    }
}

static void print_people(const House houses[2], const Observation observations[2]) {
    printf("\n%-12s %-8s %9s %11s %9s %8s %8s\n", "person", "", "time s", "narrowest m", "contacts", "peak N",
           "lost s");
    for (size_t i = 0; i < houses[0].person_count; i++) {
        const char *id = houses[0].people[i].id;
        const PersonObservation *a = &observations[0].people[i],
                                *b = observation_of_person(&houses[1], &observations[1], id);
        if (!b) {
            printf("%-12s is not in b\n", id);
            continue;
        }
        print_row("a", id, a);
        print_row("b", "", b);
        if (!a->completed || !b->completed) /* times and clearances of different ways have no difference */
            continue;
        printf("%-12s %-8s %+9.2f %+11.3f %+9d %+8.0f %+8.1f\n", "", "b - a", b->time - a->time,
               b->narrowest - a->narrowest, b->contacts - a->contacts, b->peak_force - a->peak_force,
               b->lost_time - a->lost_time);
    }
}

static void print_comparison(const House houses[2], const Observation observations[2]) {
    char headline[HEADLINE_TEXT];
    for (int h = 0; h < 2; h++) {
        headline_text(&houses[h], &observations[h], headline, sizeof headline);
        printf("%c: %s: %s\n", "ab"[h], houses[h].plan.name, headline);
    }
    Census census[2] = {census_make(&houses[0], &observations[0]), census_make(&houses[1], &observations[1])};
    if (census[0].people > CENSUS_ROWS)
        print_parties(houses, census);
    else
        print_people(houses, observations);
    for (int h = 0; h < 2; h++)
        census_clear(&census[h]);
}

static json_t *differences(const House houses[2], const Observation observations[2]) {
    json_t *rows = json_array();
    for (size_t i = 0; i < houses[0].person_count; i++) {
        const char *id = houses[0].people[i].id;
        const PersonObservation *b = observation_of_person(&houses[1], &observations[1], id);
        if (b)
            json_array_append_new(rows, answer_difference(id, &observations[0].people[i], b));
    }
    return rows;
}

/* B's pictures, with what was in A as "before", and the report on both. */
static bool write_results(const House houses[2], const Observation observations[2], const Options *options) {
    if (options->out) {
        Scene scene = {0};
        house_scene_make_compared(&scene, &houses[1], &observations[1],
                                  (Before){.house = &houses[0], .observation = &observations[0]});
        bool written = output_stills(&scene, options);
        scene_clear(&scene);
        if (!written)
            return false;
    }
    return report_files_write_comparison(houses, observations, options) &&
           (!frames_wanted(options) ||
            frames_write(&houses[1], &observations[1], (Before){.house = &houses[0], .observation = &observations[0]},
                         options));
}

int command_compare(const Options *options) {
    House houses[2] = {{.seed = 0}};
    Observation observations[2];
    Fault fault = {0};
    if (frames_check(options) || !report_files_possible(options) || (options->out && !output_directory(options->out)))
        return EXIT_WRONG_INPUT;
    bool first = house_file_read(&houses[0], options, 0, &fault);
    bool second = house_file_read(&houses[1], options, 1, &fault);
    if (!first || !second) {
        house_free(&houses[0]);
        house_free(&houses[1]);
        return house_file_report(&fault);
    }
    for (int h = 0; h < 2; h++)
        house_file_run(&observations[h], &houses[h], options, SIZE_MAX);
    bool written = write_results(houses, observations, options);
    output_tell_interrupted(false);
    if (options->json)
        answer_print(
            json_pack("{s:s, s:o, s:o, s:o}", "kind", "compare", "a", answer_house(&houses[0], &observations[0]), "b",
                      answer_house(&houses[1], &observations[1]), "differences", differences(houses, observations)));
    else
        print_comparison(houses, observations);
    if (options->out && written && !options->json)
        printf("\npictures are in %s\n", options->out);
    bool all = observations[0].completed && observations[1].completed && !progress_interrupted;
    for (int h = 0; h < 2; h++) {
        observation_free(&observations[h]);
        house_free(&houses[h]);
    }
    return !written ? EXIT_WRONG_INPUT : all ? EXIT_ANSWERED : EXIT_ANSWER_NO;
}
