#include "command/house_file.h"

#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/stopwatch.h"
#include "base/text.h"
#include "command/output.h"
#include "command/progress.h"
#include "platform/terminal.h"
#include "house/run.h"
#include "laboratory/shipped.h"

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

static int is_population(const struct dirent *entry) {
    const char *dot = strrchr(entry->d_name, '.');
    return dot && strcmp(dot, ".json") == 0;
}

/* Says that no population has this name, and which ones there are. */
static void report_unknown(const char *name, Fault *fault) {
    struct dirent **entries = NULL;
    Text known = {0};
    int count = scandir(shipped_places()->populations, &entries, is_population, alphasort);
    for (int i = 0; i < count; i++) {
        text_format(&known, "%s%.*s", i ? ", " : "", (int)(strlen(entries[i]->d_name) - strlen(".json")),
                    entries[i]->d_name);
        free(entries[i]); /* of scandir */
    }
    free(entries);
    fault_add(fault, "clearance: unknown population \"%s\"; known are %s, or name a file of your own", name,
              known.text ? known.text : "none");
    memory_free(known.text);
}

bool house_file_population(Population *population, const Options *options, Fault *fault) {
    const char *name = options->population ? options->population : "manual-jp";
    char path[OUTPUT_PATH];
    size_t length = strlen(name);
    bool file = strchr(name, '/') || (length > 5 && strcmp(name + length - 5, ".json") == 0);
    snprintf(path, sizeof path, file ? "%s%s" : "%s/%s.json", file ? "" : shipped_places()->populations, name);
    if (!file && access(path, R_OK) != 0) {
        report_unknown(name, fault);
        return false;
    }
    return population_read(population, path, fault);
}
