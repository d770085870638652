#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include "command/answer.h"
#include "command/command.h"
#include "command/house_file.h"
#include "command/report.h"

/* The person with this id, or NULL. */
static const PersonObservation *find_person(const House *house, const Observation *observation, const char *id) {
    for (size_t i = 0; i < house->person_count; i++)
        if (strcmp(house->people[i].id, id) == 0)
            return &observation->people[i];
    return NULL;
}

static void print_row(const char *name, const char *id, const PersonObservation *person) {
    printf("%-12s %-8s %9.2f %11.3f %9d %8.0f %8.1f  %s\n", id, name, person->time, person->narrowest, person->contacts,
           person->peak_force, person->lost_time, person->completed ? "out" : observation_reason(person->reason));
}

static void print_comparison(const House houses[2], const Observation observations[2]) {
    char headline[REPORT_HEADLINE];
    for (int h = 0; h < 2; h++) {
        report_headline(&houses[h], &observations[h], headline, sizeof headline);
        printf("%c: %s: %s\n", "ab"[h], houses[h].plan.name, headline);
    }
    printf("\n%-12s %-8s %9s %11s %9s %8s %8s\n", "person", "", "time s", "narrowest m", "contacts", "peak N",
           "lost s");
    for (size_t i = 0; i < houses[0].person_count; i++) {
        const char *id = houses[0].people[i].id;
        const PersonObservation *a = &observations[0].people[i], *b = find_person(&houses[1], &observations[1], id);
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

static json_t *differences(const House houses[2], const Observation observations[2]) {
    json_t *rows = json_array();
    for (size_t i = 0; i < houses[0].person_count; i++) {
        const char *id = houses[0].people[i].id;
        const PersonObservation *b = find_person(&houses[1], &observations[1], id);
        if (b)
            json_array_append_new(rows, answer_difference(id, &observations[0].people[i], b));
    }
    return rows;
}

int command_compare(const Options *options) {
    House houses[2] = {{.seed = 0}};
    Observation observations[2];
    Fault fault = {0};
    bool first = house_file_read(&houses[0], options, 0, &fault);
    bool second = house_file_read(&houses[1], options, 1, &fault);
    if (!first || !second) {
        house_free(&houses[0]);
        house_free(&houses[1]);
        return house_file_report(&fault);
    }
    for (int h = 0; h < 2; h++)
        house_file_run(&observations[h], &houses[h], options, SIZE_MAX);
    if (options->json)
        answer_print(
            json_pack("{s:s, s:o, s:o, s:o}", "kind", "compare", "a", answer_house(&houses[0], &observations[0]), "b",
                      answer_house(&houses[1], &observations[1]), "differences", differences(houses, observations)));
    else
        print_comparison(houses, observations);
    bool all = observations[0].completed && observations[1].completed;
    for (int h = 0; h < 2; h++) {
        observation_free(&observations[h]);
        house_free(&houses[h]);
    }
    return all ? EXIT_ANSWERED : EXIT_ANSWER_NO;
}
