#include "study/type_map.h"

#include <math.h>
#include <string.h>

#include "base/digest.h"
#include "base/stop.h"

/* An experiment with other nominal values of some parameters. */
typedef struct Fixed {
    const Experiment *of;
    const char *const *names; /* (count) */
    const double *values;
    size_t count;
} Fixed;

/* Returns the index of a name, or the count. */
static size_t find_name(const char *const *names, size_t count, const char *name) {
    size_t i = 0;
    while (i < count && strcmp(names[i], name) != 0)
        i++;
    return i;
}

static const Parameter *fixed_parameter(const void *given, const char *name) {
    const Fixed *fixed = given;
    return fixed->of->parameter(fixed->of->given, name);
}

static double fixed_nominal(const void *given, const char *name) {
    const Fixed *fixed = given;
    size_t i = find_name(fixed->names, fixed->count, name);
    return i < fixed->count ? fixed->values[i] : fixed->of->nominal(fixed->of->given, name);
}

static void fixed_run(const void *given, const char *const *names, size_t name_count, Trial *trials, size_t count,
                      bool carry, const Stop *stop) {
    const Fixed *fixed = given;
    size_t width = fixed->count + name_count, used = 0;
    const char **all = memory_zeroed(width, sizeof *all);
    double *at = memory_zeroed(count * width, sizeof *at);
    const double **before = memory_zeroed(count, sizeof *before);
    for (size_t n = 0; n < width; n++) {
        bool own = n >= fixed->count;
        const char *name = own ? names[n - fixed->count] : fixed->names[n];
        if (!own && find_name(names, name_count, name) < name_count)
            continue;
        for (size_t t = 0; t < count; t++)
            at[t * width + used] = own ? trials[t].at[n - fixed->count] : fixed->values[n];
        all[used++] = name;
    }
    for (size_t t = 0; t < count; t++) {
        before[t] = trials[t].at;
        trials[t].at = at + t * width;
    }
    fixed->of->run(fixed->of->given, all, used, trials, count, carry, stop);
    for (size_t t = 0; t < count; t++)
        trials[t].at = before[t];
    memory_free(before);
    memory_free(at);
    memory_free(all);
}

static Experiment fix(Fixed *fixed) {
    Experiment experiment = *fixed->of;
    experiment.given = fixed;
    experiment.parameter = fixed_parameter;
    experiment.nominal = fixed_nominal;
    experiment.unknown = NULL;
    experiment.run = fixed_run;
    return experiment;
}

/* Returns 1, 2 or 3; NAN: unresolved or interrupted. */
static double type_at(const TypeMap *map, const char *const *names, size_t name_count, const double *at,
                      const Stop *stop) {
    Fixed quick = {map->of, names, at, name_count}, slow = {map->thorough, names, at, name_count};
    Experiment experiment = fix(&quick), thorough = {.kind = NULL};
    if (map->thorough)
        thorough = fix(&slow);
    Types types;
    Fault fault = {0};
    bool decided = types_classify(&types,
                                  &(TypesTask){.experiment = &experiment,
                                               .thorough = map->thorough ? &thorough : NULL,
                                               .names = map->names,
                                               .name_count = map->name_count,
                                               .window_only = true,
                                               .jobs = 1,
                                               .stop = stop},
                                  &fault);
    fault_clear(&fault);
    switch (types.kind) {
    case TYPES_I:
    case TYPES_II:
    case TYPES_III:
        return decided && !types.stopped ? (double)types.kind : (double)NAN;
    case TYPES_UNRESOLVED:
    case TYPES_KIND_INTERRUPTED:
        break;
    }
    return NAN;
}

static void typed_run(const void *given, const char *const *names, size_t name_count, Trial *trials, size_t count,
                      bool carry, const Stop *stop) {
    const TypeMap *map = given;
    map->of->run(map->of->given, names, name_count, trials, count, carry, stop);
    for (size_t t = 0; t < count; t++) {
        double *type = &trials[t].observed[map->of->observable_count];
        *type = NAN;
        if (trials[t].done && !trials[t].fault)
            *type = type_at(map, names, name_count, trials[t].at, stop);
        if (trials[t].done && stop_requested(stop))
            trials[t].done = false;
    }
}

static const Parameter *typed_parameter(const void *given, const char *name) {
    const TypeMap *map = given;
    return map->of->parameter(map->of->given, name);
}

static double typed_nominal(const void *given, const char *name) {
    const TypeMap *map = given;
    return map->of->nominal(map->of->given, name);
}

static void typed_unknown(const void *given, const char *name, const char *place, Fault *fault) {
    const TypeMap *map = given;
    map->of->unknown(map->of->given, name, place, fault);
}

bool type_map_open(TypeMap *map, Experiment *experiment, Fault *fault) {
    const Experiment *of = map->of;
    if (!types_check(of, map->names, map->name_count, fault))
        return false;
    map->observables = memory_zeroed(of->observable_count + 1, sizeof *map->observables);
    memcpy(map->observables, of->observables, of->observable_count * sizeof *map->observables);
    map->observables[of->observable_count] = (Observable){"type", "1", "type I, II or III of the place"};
    *experiment = *of;
    experiment->observables = map->observables;
    experiment->observable_count++;
    experiment->batch = 1;
    experiment->given = map;
    experiment->parameter = typed_parameter;
    experiment->nominal = typed_nominal;
    experiment->unknown = of->unknown ? typed_unknown : NULL;
    experiment->run = typed_run;
    for (size_t n = 0; n < map->name_count; n++)
        experiment->identity = digest_text(experiment->identity, map->names[n]);
    return true;
}

void type_map_close(TypeMap *map) {
    memory_free(map->observables);
    map->observables = NULL;
}
