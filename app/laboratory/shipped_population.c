#include "laboratory/shipped_population.h"

#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/text.h"
#include "laboratory/shipped.h"

static const char *const USUAL = "manual-jp";

static int is_population(const struct dirent *entry) {
    const char *dot = strrchr(entry->d_name, '.');
    return dot && strcmp(dot, ".json") == 0;
}

/* Says that no population has this name, and which ones there are. */
static void report_unknown(const PlanDrivers *drivers, Fault *fault) {
    struct dirent **entries = NULL;
    Text known = {0};
    int count = scandir(shipped_places()->populations, &entries, is_population, alphasort);
    for (int i = 0; i < count; i++) {
        text_format(&known, "%s%.*s", i ? ", " : "", (int)(strlen(entries[i]->d_name) - strlen(".json")),
                    entries[i]->d_name);
        free(entries[i]); /* of scandir */
    }
    free(entries);
    fault_add(fault, "%sunknown population \"%.60s\"; known are %s, or name a file of your own", drivers->place,
              drivers->population, known.text ? known.text : "none");
    memory_free(known.text);
}

bool shipped_population_read(Population *population, const PlanDrivers *drivers, const char *beside, Fault *fault) {
    const char *name = drivers->population && *drivers->population ? drivers->population : USUAL;
    size_t length = strlen(name);
    bool file = strchr(name, '/') || (length > 5 && strcmp(name + length - 5, ".json") == 0);
    const char *slash = file && beside && *name != '/' ? strrchr(beside, '/') : NULL;
    Arena arena = {0};
    const char *path = !file   ? text_in_arena(&arena, "%s/%s.json", shipped_places()->populations, name)
                       : slash ? text_in_arena(&arena, "%.*s%s", (int)(slash - beside + 1), beside, name)
                               : name;
    bool good = file || access(path, R_OK) == 0;
    if (good)
        good = population_read(population, path, fault);
    else
        report_unknown(drivers, fault);
    arena_clear(&arena);
    return good;
}
