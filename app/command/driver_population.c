#include "command/driver_population.h"

#include <stdio.h>
#include <string.h>

#include "command/output.h"
#include "laboratory/shipped.h"

bool driver_population_read(Population *population, const Options *options, Fault *fault) {
    const char *name = options->population ? options->population : "manual-jp";
    char path[OUTPUT_PATH];
    size_t length = strlen(name);
    bool file = strchr(name, '/') || (length > 5 && strcmp(name + length - 5, ".json") == 0);
    snprintf(path, sizeof path, file ? "%s%s" : "%s/%s.json", file ? "" : shipped_places()->populations, name);
    return population_read(population, path, fault);
}
