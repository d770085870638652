/* Runs the same houses with both driving models, which measures the open defect of the paper. */

#include <stdint.h>
#include <stdio.h>

#include "command/answer.h"
#include "command/command.h"
#include "command/house_file.h"
#include "house/locus.h"

/* The results of the first person of one house with both driving models. */
typedef struct Comparison {
    char name[128];
    PersonObservation miura, driver;
    LocusDistance apart; /* from the locus of `driver` to that of `miura` */
    double floor;        /* m/s, slowest speed of `miura` after the start */
    bool interrupted;
} Comparison;

static double slowest(const Observation *observation) {
    double floor = HUGE_VAL, before = 0;
    bool started = false;
    for (size_t r = 0; r < observation->trace.rows; r++) {
        const double *row = trace_row(&observation->trace, r);
        double speed = row[TRACE_SPEED];
        if (row[TRACE_PERSON] != 0)
            continue;
        started |= speed < before;
        floor = started ? fmin(floor, speed) : floor;
        before = speed;
    }
    return floor;
}

static bool compare_house(Comparison *comparison, const Options *options, size_t file, Fault *fault) {
    Observation observations[2] = {{.people = NULL}};
    Locus loci[2] = {{.count = 0}};
    bool good = true;
    for (int driving = 0; driving < 2 && good; driving++) {
        House house = {0};
        Options chosen = *options;
        chosen.driving = driving;
        good = house_file_read(&house, &chosen, file, fault);
        if (good && !house.person_count) {
            fault_add(fault, "%s:1:1: the house has no people; a locus needs at least one", options->files[file]);
            good = false;
        }
        if (good) {
            house_file_run(&observations[driving], &house, options, SIZE_MAX);
            comparison->interrupted |= observations[driving].interrupted;
            loci[driving] = locus_of(&house, &observations[driving], 0);
            snprintf(comparison->name, sizeof comparison->name, "%s", house.plan.name);
        }
        house_free(&house);
    }
    if (good) {
        comparison->driver = observations[DRIVING_DRIVER].people[0];
        comparison->miura = observations[DRIVING_MIURA].people[0];
        comparison->floor = slowest(&observations[DRIVING_MIURA]);
        if (comparison->driver.completed && comparison->miura.completed)
            comparison->apart = locus_distance(&loci[DRIVING_DRIVER], &loci[DRIVING_MIURA]);
    }
    for (int driving = 0; driving < 2; driving++) {
        observation_free(&observations[driving]);
        locus_free(&loci[driving]);
    }
    return good;
}

/* Prints the time, or the reason why there is none. */
static void print_time(const PersonObservation *person) {
    if (person->completed)
        printf(" %11.2f |", person->time);
    else
        printf(" %11s |", observation_reason(person->reason));
}

static void print_number(double value, bool there) {
    if (there)
        printf(" %9.3f |", value);
    else
        printf(" %9s |", "-");
}

static void print_comparison(const Comparison *comparison) {
    const PersonObservation *miura = &comparison->miura, *driver = &comparison->driver;
    bool both = miura->completed && driver->completed;
    printf("| %-40s |", comparison->name);
    print_time(miura);
    print_time(driver);
    print_number(miura->narrowest, miura->completed);
    print_number(driver->narrowest, driver->completed);
    print_number(comparison->floor, miura->completed && comparison->floor > 0 && comparison->floor < HUGE_VAL);
    print_number(comparison->apart.largest, both);
    print_number(comparison->apart.mean, both);
    printf("\n");
}

/* Prints the head of a Markdown table. */
static void print_head(void) {
    static const char *const columns[] = {"narrowest", "narrowest", "floor", "apart", "apart"};
    static const char *const units[] = {"miura, m", "driver, m", "m/s", "most, m", "mean, m"};
    enum { COLUMNS = sizeof columns / sizeof *columns };
    static const char dashes[] = "------------------------------------------";
    printf("| %-40s | %-11s | %-11s |", "", "miura", "driver");
    for (size_t c = 0; c < COLUMNS; c++)
        printf(" %-9s |", columns[c]);
    printf("\n|%.42s|%.13s|%.13s|", dashes, dashes, dashes);
    for (size_t c = 0; c < COLUMNS; c++)
        printf("%.11s|", dashes);
    printf("\n| %-40s | %-11s | %-11s |", "house", "time, s", "time, s");
    for (size_t c = 0; c < COLUMNS; c++)
        printf(" %-9s |", units[c]);
    printf("\n");
}

static json_t *answer_comparison(const Comparison *comparison) {
    bool both = comparison->miura.completed && comparison->driver.completed;
    json_t *answer = json_pack("{s:s}", "house", comparison->name);
    const PersonObservation *people[2] = {&comparison->miura, &comparison->driver};
    for (int p = 0; p < 2; p++)
        json_object_set_new(answer, p ? "driver" : "miura",
                            json_pack("{s:b, s:f, s:f, s:f}", "completed", people[p]->completed, "time",
                                      people[p]->time, "narrowest", people[p]->narrowest, "peak_force",
                                      people[p]->peak_force));
    json_object_set_new(answer, "locus_largest", both ? json_real(comparison->apart.largest) : json_null());
    json_object_set_new(answer, "locus_mean", both ? json_real(comparison->apart.mean) : json_null());
    return answer;
}

int command_loci(const Options *options) {
    Fault fault = {0};
    bool all = true, interrupted = false;
    json_t *rows = json_array();
    if (!options->json)
        print_head();
    for (size_t f = 0; f < options->file_count && !fault.count && !interrupted; f++) {
        Comparison comparison = {.floor = 0};
        if (!compare_house(&comparison, options, f, &fault))
            continue;
        interrupted = comparison.interrupted;
        if (interrupted)
            break;
        all &= comparison.miura.completed && comparison.driver.completed;
        json_array_append_new(rows, answer_comparison(&comparison));
        if (!options->json)
            print_comparison(&comparison);
    }
    json_t *answer = json_pack("{s:s, s:o}", "kind", "loci", "houses", rows);
    answer_mark_interrupted(answer, interrupted);
    if (interrupted)
        fprintf(stderr, "clearance: interrupted; the houses up to there are listed\n");
    if (options->json && !fault.count)
        answer_print(json_incref(answer));
    json_decref(answer);
    if (fault.count)
        return house_file_report(&fault);
    return all && !interrupted ? EXIT_ANSWERED : EXIT_ANSWER_NO;
}
