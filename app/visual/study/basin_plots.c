#include "visual/study/basin_plots.h"

#include <stdio.h>
#include <string.h>

#include "base/text.h"

enum { NAME = 40 };

static const Role roles[BASIN_PLOTS_BANDS] = {ROLE_CLASS_FIRST, ROLE_CLASS_SECOND, ROLE_TYPE_SECOND, ROLE_CLASS_FOURTH,
                                              ROLE_CLASS_FIFTH, ROLE_CLASS_SIXTH,  ROLE_CLASS_THIRD, ROLE_TYPE_FIRST,
                                              ROLE_CLASS_NONE,  ROLE_TYPE_THIRD};

/* The bands from the foot up. */
typedef struct Bands {
    char names[BASIN_PLOTS_BANDS][NAME];
    bool regular[BASIN_PLOTS_BANDS];
    size_t count;
} Bands;

/* Writes the name of a basin's band: of several of one kind at a value the weaker ones are "period 1, 2nd". */
static void band_name(const Study *study, const Basins *basins, size_t i, char name[NAME]) {
    char own[NAME], other[NAME];
    size_t before = 0;
    basins_name(study, &basins->of[i], own, sizeof own);
    for (size_t k = 0; k < basins->count; k++) {
        basins_name(study, &basins->of[k], other, sizeof other);
        before += basins->of[k].share.good && strcmp(own, other) == 0 && basins->of[k].measure > basins->of[i].measure;
    }
    static const char *const places[] = {"", ", 2nd", ", 3rd"};
    snprintf(name, NAME, "%.30s%s", own, before < 3 ? places[before] : ", others");
}

/* Returns the band of a name, which is added while there is room; else the last. */
static size_t find_band(Bands *bands, const char *name, bool regular) {
    for (size_t b = 0; b < bands->count; b++)
        if (strcmp(bands->names[b], name) == 0)
            return b;
    if (bands->count == BASIN_PLOTS_BANDS) {
        snprintf(bands->names[BASIN_PLOTS_BANDS - 1], NAME, "others");
        return BASIN_PLOTS_BANDS - 1;
    }
    snprintf(bands->names[bands->count], NAME, "%s", name);
    bands->regular[bands->count] = regular;
    return bands->count++;
}

void basin_plots_add(Plot *plot, const Study *study, double factor, Arena *arena) {
    size_t steps = study->axes[0].steps;
    Bands bands = {.count = 0};
    double *x = arena_allocate(arena, (steps + 1) * sizeof *x),
           *share = arena_allocate(arena, BASIN_PLOTS_BANDS * steps * sizeof *share);
    for (size_t i = 0; i < steps; i++) {
        Basins basins = basins_at(study, i);
        x[i] = factor * study_value(&study->axes[0], i);
        for (size_t k = 0; k < basins.count; k++) {
            char name[NAME];
            band_name(study, &basins, k, name);
            if (basins.of[k].share.good)
                share[find_band(&bands, name, basins.of[k].regular) * steps + i] += basins.of[k].share.value;
        }
    }
    double *foot = arena_allocate(arena, steps * sizeof *foot);
    size_t regular = 0;
    for (int pass = 0; pass < 2; pass++) /* what is regular first */
        for (size_t b = 0; b < bands.count; b++) {
            if (bands.regular[b] != (pass == 0))
                continue;
            double *top = arena_allocate(arena, steps * sizeof *top);
            for (size_t i = 0; i < steps; i++)
                top[i] = foot[i] + share[b * steps + i];
            Role role = pass == 0 ? roles[regular++ % (BASIN_PLOTS_BANDS - 1)] : roles[BASIN_PLOTS_BANDS - 1];
            plot->areas[plot->area_count++] = (PlotArea){.name = arena_text(arena, bands.names[b]),
                                                         .x = x,
                                                         .low = foot,
                                                         .high = top,
                                                         .count = steps,
                                                         .role = role};
            foot = top;
        }
}
