#include "command/house_file.h"

#include <stdio.h>
#include <string.h>

#include "base/stopwatch.h"
#include "command/output.h"
#include "command/progress.h"
#include "platform/terminal.h"
#include "house/run.h"
#include "laboratory/shipped.h"
#include "laboratory/shipped_population.h"
#include "result/census.h"

bool house_file_read(House *house, const Options *options, size_t index, Fault *fault) {
    HouseOptions house_options = {.profiles = shipped_places()->profiles,
                                  .settings = options->settings,
                                  .setting_count = options->setting_count,
                                  .seed = options->seed,
                                  .driving = options->driving};
    return house_read(house, options->files[index], &house_options, fault);
}

int house_file_report(Fault *fault) {
    for (size_t i = 0; i < fault->count; i++)
        fprintf(stderr, "%s\n", fault->lines[i]);
    if (fault->total > fault->count)
        fprintf(stderr, "and %zu more\n", fault->total - fault->count);
    if (shipped_places()->missing)
        fprintf(stderr, "clearance: %s\n", shipped_places()->missing);
    fault_clear(fault);
    return EXIT_WRONG_INPUT;
}

/* Prints progress once the work has taken more than a second. */
typedef struct Progress {
    double begin; /* s, by the clock */
    bool shown;
} Progress;

static void show_progress(void *context, double time) {
    Progress *progress = context;
    if (stopwatch_now() - progress->begin < 1)
        return;
    terminal_progress("simulated %.0f s ", time);
    progress->shown = true;
}

void house_file_run(Observation *observation, const House *house, const Options *options, size_t route) {
    Progress progress = {.begin = stopwatch_now()};
    bool show = progress_is_shown(options);
    RunOptions run = {.route = route,
                      .jobs = options->jobs,
                      .stop = &progress_stop,
                      .progress = show ? show_progress : NULL,
                      .context = &progress};
    run_house(observation, house, &run);
    if (progress.shown)
        terminal_clear_progress();
}

bool house_file_letters(Grade **letters, const House *house, const Observation *observation, const Options *options) {
    return grade_answer(letters, house, observation, CENSUS_FEW, options->jobs, &progress_stop);
}

size_t house_file_drivers(const Options *options, const Plan *plan) {
    return (size_t)(options->drivers ? options->drivers : plan->drivers.count);
}

/* True if the house has people of a profile. */
static bool has_people_of(const Plan *plan, const char *profile) {
    bool any = false;
    for (size_t p = 0; p < plan->person_count; p++)
        any |= strcmp(plan->people[p].profile, profile) == 0;
    for (size_t c = 0; c < plan->crowd_count; c++)
        any |= strcmp(plan->crowds[c].profile, profile) == 0;
    return any;
}

bool house_file_population(Population *population, const Options *options, const Plan *plan, Fault *fault) {
    PlanDrivers drivers = plan->drivers;
    if (options->population)
        drivers = (PlanDrivers){.population = options->population, .place = "clearance: "};
    if (!shipped_population_read(population, &drivers, options->population ? NULL : plan->path, fault))
        return false;
    if (has_people_of(plan, population->profile))
        return true;
    fault_add(fault, "%sthe population %s varies the profile \"%s\", which nobody in this house has",
              drivers.place ? drivers.place : "clearance: ", population->id, population->profile);
    return false;
}
