#include "toy.h"

#include <stdio.h>
#include <string.h>

static const Parameter rows[] = {
    {.name = "x", .kind = PARAMETER_NUMBER, .unit = "m", .low = -10, .high = 100, .fallback = 1, .meaning = "place"},
    {.name = "y", .kind = PARAMETER_NUMBER, .unit = "1", .low = 0, .high = 100, .fallback = 2, .meaning = "share"},
    {.name = "n", .kind = PARAMETER_WHOLE, .unit = "1", .low = 0, .high = 100, .fallback = 3, .meaning = "number"},
    {.name = "nothing", .kind = PARAMETER_NUMBER, .unit = "N", .low = 0, .high = 1, .meaning = "nothing"},
};

static const Observable observables[TOY_OBSERVABLES] = {
    [TOY_REGULAR] = {"regular", "1", "x and memory are below 2"},
    [TOY_SUM] = {"sum", "m", "the sum"},
    [TOY_MEMORY] = {"memory", "m", "of the chain"},
};

static const Observable series = {"square", "m2", "squares"};

static const Parameter *find(const void *given, const char *name) {
    (void)given;
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
        if (strcmp(rows[i].name, name) == 0)
            return &rows[i];
    return NULL;
}

static double nominal(const void *given, const char *name) {
    return find(given, name)->fallback;
}

static double value_of(const Trial *trial, const char *const *names, size_t name_count, const char *name) {
    for (size_t n = 0; n < name_count; n++)
        if (strcmp(names[n], name) == 0)
            return trial->at[n];
    return nominal(NULL, name);
}

static void observe(Trial *trial, double x, double y, double memory) {
    trial->observed[TOY_REGULAR] = x + memory < 2;
    trial->observed[TOY_SUM] = x + 10 * y + (double)trial->seed / 1000;
    trial->observed[TOY_MEMORY] = memory;
    trial->series_count = x >= 0 ? (size_t)x + 1 : 0;
    trial->series = memory_zeroed(trial->series_count, sizeof *trial->series);
    for (size_t i = 0; i < trial->series_count; i++)
        trial->series[i] = (double)(i * i);
    trial->done = true;
}

static void run(const void *given, const char *const *names, size_t name_count, Trial *trials, size_t count, bool carry,
                const Stop *stop) {
    Toy *toy = (Toy *)given;
    double memory = 0;
    for (size_t i = 0; i < count; i++) {
        double x = value_of(&trials[i], names, name_count, "x"), y = value_of(&trials[i], names, name_count, "y");
        int run = __atomic_add_fetch(&toy->run, 1, __ATOMIC_SEQ_CST);
        if (toy->interrupted_after && run > toy->interrupted_after)
            stop_request(&toy->stop);
        if (stop_requested(stop))
            return;
        if (x > 50) {
            trials[i].fault = memory_zeroed(40, 1);
            snprintf(trials[i].fault, 40, "x is \"%g\", at most 50", x);
            continue;
        }
        observe(&trials[i], x, y, carry ? memory : 0);
        memory += x;
    }
}

Experiment toy_experiment(Toy *toy) {
    return (Experiment){.kind = "toy",
                        .observables = observables,
                        .observable_count = TOY_OBSERVABLES,
                        .series = &series,
                        .regular = TOY_REGULAR,
                        .outcome = TOY_MEMORY,
                        .measure = TOY_SUM,
                        .carries = true,
                        .batch = 3,
                        .given = toy,
                        .parameter = find,
                        .nominal = nominal,
                        .run = run};
}

Study toy_study(const Experiment *experiment) {
    return (Study){.experiment = experiment,
                   .axes = {{"x", 0, 3, 7}, {"y", 1, 2, 3}},
                   .axis_count = 2,
                   .spreads = {{"x", 0.05}},
                   .spread_count = 1,
                   .passes = {STUDY_RESET, STUDY_UP, STUDY_DOWN},
                   .pass_count = 3,
                   .runs = 3,
                   .seed = 1};
}
