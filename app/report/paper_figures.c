#include "report/paper_figures.h"

#include <assert.h>
#include <math.h>
#include <string.h>

#include "base/text.h"
#include "visual/beam/follow_plots.h"
#include "visual/study/study_axes.h"
#include "visual/study/type_bands.h"

#define SIGN 8.0    /* design points, of a type's mark on the map */
#define GROUND 13.0 /* design points, of what it stands on */

#define LOW_PEAKS "peaks-to-1000"
#define LOW_REACH 1000.0 /* N */

/* The source of a figure's plot: a run, or a study. */
typedef struct Source {
    const char *name, *title, *caption;
    bool is_run;
    int of;           /* PaperRun or PaperStudy */
    const char *plot; /* beam_plots.h, study_plots.h */
} Source;

/* The paper's text does not say which of the figures 3 to 6 shows which response, nor the axes of 7 and 9; these
 * follow the quantities that the text discusses. */
static const Source sources[PAPER_FIGURES] = {
    {"figure-2-phase", "Figure 2", "The tip at 190 Hz, in its phase plane; grey: the stops beyond the clearance.", true,
     PAPER_PERIODIC, "phase"},
    {"figure-2-force", "Figure 2", "The force of the joint on the tip at 190 Hz.", true, PAPER_PERIODIC, "force"},
    {"figure-3-phase", "Figures 3 to 6", "The tip at 300 Hz, in its phase plane.", true, PAPER_CHAOTIC, "phase"},
    {"figure-4-poincare", "Figures 3 to 6", "The Poincar\u00e9 map at 300 Hz: the tip once a cycle of the drive.", true,
     PAPER_CHAOTIC, "poincare"},
    {"figure-5-force", "Figures 3 to 6", "The force of the joint on the tip at 300 Hz.", true, PAPER_CHAOTIC, "force"},
    {"figure-6-spectrum", "Figures 3 to 6", "The spectrum of the tip's displacement at 300 Hz.", true, PAPER_CHAOTIC,
     "spectrum"},
    {"figure-8-peaks", "Figures 7 and 8",
     "Largest force of each of 100 cycles against the drive's frequency: each from rest, and swept upwards and "
     "downwards; where these differ, motions coexist. Along the foot: the types I, II and III there.",
     false, PAPER_FREQUENCIES, "peaks"},
    {"figure-8-peaks-to-1000", "Figures 7 and 8",
     "The same up to 1,000 N, the range of the paper's figures; what is larger is cut off.", false, PAPER_FREQUENCIES,
     LOW_PEAKS},
    {"figure-9-map", "Figure 9",
     "Responses over frequency and clearance, from rest; on the right the clearance over the static deflection of the "
     "tip under the drive's amplitude, without the joint. Marks: the type within 1 % of each place by quick runs, from "
     "16 starts.",
     false, PAPER_MAP, "map-period"},
    {"figure-10-length", "Figure 10",
     "Largest force of each of 100 cycles at 290 Hz against the length of the beam; along the foot its types. Dotted: "
     "both lengths of the paper.",
     false, PAPER_LENGTHS, "peaks"},
};

static const Plot *find_beam_plot(const BeamPlots *plots, const char *name) {
    for (size_t i = 0; i < plots->choice.count; i++)
        if (strcmp(beam_plots_name(plots->choice.indices[i]), name) == 0)
            return &plots->plots[i];
    return NULL;
}

static const Plot *find_study_plot(const StudyPlots *plots, const char *name) {
    for (size_t i = 0; i < plots->count; i++)
        if (strcmp(plots->plots[i].name, name) == 0)
            return &plots->plots[i].plot;
    return NULL;
}

/* Adds types, at so many values times `factor`, along the foot of the plot of peaks. */
static void add_types(StudyPlots *plots, const double *values, const Types *types, size_t count, double factor) {
    Arena *arena = &plots->arena;
    double *at = arena_allocate(arena, count * sizeof *at), *kinds = arena_allocate(arena, count * sizeof *kinds);
    for (size_t i = 0; i < count; i++) {
        at[i] = factor * values[i];
        kinds[i] = types[i].kind >= TYPES_I && types[i].kind <= TYPES_III ? (double)types[i].kind : (double)NAN;
    }
    for (size_t i = 0; i < plots->count; i++)
        if (strcmp(plots->plots[i].name, "peaks") == 0)
            type_bands_add(&plots->plots[i].plot, at, kinds, count, at[1] - at[0],
                           type_bands_height(&plots->plots[i].plot), arena);
}

/* Adds the types that were told over the plane as marks, and the curves of folds and flips, to the map. */
static void add_plane(StudyPlots *plots, const Paper *paper, double x_factor, double y_factor) {
    static const struct {
        const char *name;
        Symbol symbol;
    } looks[] = {[TYPES_I] = {"type I", SYMBOL_DISC},
                 [TYPES_II] = {"type II", SYMBOL_DIAMOND},
                 [TYPES_III] = {"type III", SYMBOL_BOX}};
    enum { PLACES = PAPER_PLANE_CLEARANCES * PAPER_PLANE_FREQUENCIES };
    Arena *arena = &plots->arena;
    for (size_t p = 0; p < plots->count; p++) {
        Plot *plot = &plots->plots[p].plot;
        if (strcmp(plots->plots[p].name, "map-period") != 0)
            continue;
        PlotSeries *series =
            arena_allocate(arena, (plot->series_count + 1 + TYPES_III + FOLLOW_PLOTS_CURVES) * sizeof *series);
        if (plot->series_count)
            memcpy(series, plot->series, plot->series_count * sizeof *series);
        plot->series = series;
        follow_plots_add_curves(plot, paper->follow.curves, paper->follow.curve_count, x_factor, y_factor, arena);
        double *all_x = arena_allocate(arena, PLACES * sizeof *all_x),
               *all_y = arena_allocate(arena, PLACES * sizeof *all_y);
        size_t all = 0;
        for (size_t i = 0; i < PLACES; i++) {
            size_t c = i / PAPER_PLANE_FREQUENCIES, f = i % PAPER_PLANE_FREQUENCIES;
            if (paper->plane[c][f] < TYPES_I || paper->plane[c][f] > TYPES_III)
                continue;
            all_x[all] = x_factor * paper->plane_frequency[f];
            all_y[all++] = y_factor * paper->plane_clearance[c];
        }
        series[plot->series_count++] = (PlotSeries){.x = all_x, /* the ground of the marks */
                                                    .y = all_y,
                                                    .count = all,
                                                    .role = ROLE_PAPER,
                                                    .symbol = SYMBOL_DISC,
                                                    .size = GROUND};
        for (TypesKind kind = TYPES_I; kind <= TYPES_III; kind++) {
            double *x = arena_allocate(arena, PLACES * sizeof *x), *y = arena_allocate(arena, PLACES * sizeof *y);
            size_t count = 0;
            for (size_t c = 0; c < PAPER_PLANE_CLEARANCES; c++)
                for (size_t i = 0; i < PAPER_PLANE_FREQUENCIES; i++)
                    if (paper->plane[c][i] == kind) {
                        x[count] = x_factor * paper->plane_frequency[i];
                        y[count++] = y_factor * paper->plane_clearance[c];
                    }
            if (count)
                series[plot->series_count++] = (PlotSeries){.name = looks[kind].name,
                                                            .x = x,
                                                            .y = y,
                                                            .count = count,
                                                            .role = ROLE_TEXT,
                                                            .symbol = looks[kind].symbol,
                                                            .size = SIGN,
                                                            .open = kind != TYPES_III};
        }
    }
}

/* Makes the plot of the peaks up to LOW_REACH, with bands of types as high as in the whole one. */
static Plot cut_peaks(const Plot *whole, Arena *arena) {
    Plot cut = *whole;
    double most = 0;
    for (size_t s = 0; s < whole->series_count; s++)
        for (size_t i = 0; i < whole->series[s].count; i++)
            most = fmax(most, plot_value(&whole->series[s], i).y);
    cut.y.low = 0;
    cut.y.high = LOW_REACH;
    cut.areas = arena_allocate(arena, (whole->area_count + 1) * sizeof *cut.areas);
    for (size_t a = 0; a < whole->area_count; a++) {
        double *high = arena_allocate(arena, whole->areas[a].count * sizeof *high);
        for (size_t i = 0; i < whole->areas[a].count; i++)
            high[i] = whole->areas[a].high[i] * (most > LOW_REACH ? LOW_REACH / most : 1);
        cut.areas[a] = whole->areas[a];
        cut.areas[a].high = high;
    }
    return cut;
}

/* Adds a line at each of the paper's two lengths. */
static void add_lengths(StudyPlots *plots, const Paper *paper, double factor) {
    static const PaperRun runs[] = {PAPER_NOMINAL, PAPER_LONGER};
    enum { LENGTHS = sizeof runs / sizeof *runs };
    Arena *arena = &plots->arena;
    for (size_t p = 0; p < plots->count; p++) {
        Plot *plot = &plots->plots[p].plot;
        if (strcmp(plots->plots[p].name, "peaks") != 0)
            continue;
        PlotGuide *guides = arena_allocate(arena, (plot->guide_count + LENGTHS) * sizeof *guides);
        for (size_t i = 0; i < plot->guide_count; i++)
            guides[i] = plot->guides[i];
        plot->guides = guides;
        for (size_t i = 0; i < LENGTHS; i++) {
            double at = factor * paper->beams[runs[i]].length;
            guides[plot->guide_count++] = (PlotGuide){.upright = true,
                                                      .at = at,
                                                      .name = text_in_arena(arena, "%.1f mm", at),
                                                      .role = ROLE_DIM_TEXT,
                                                      .style = LINE_DOTTED};
        }
    }
}

/* Returns the caption of a figure; that of the map names the orbit whose curves it shows. */
static const char *caption_of(const Source *source, const Paper *paper, Arena *arena) {
    if (strcmp(source->plot, "map-period") != 0 || !paper->follow.curve_count)
        return source->caption;
    return text_in_arena(arena,
                         "%s Lines: where the orbit of %.0f Hz folds, flips, loses its symmetry or becomes a torus.",
                         source->caption, paper->beams[paper->followed].frequency);
}

PaperFigures *paper_figures_make(const Paper *paper) {
    PaperFigures *figures = memory_zeroed(1, sizeof *figures);
    char fault[PLOT_CHOICE_FAULT];
    PlotChoice choice;
    bool known = beam_plots_choose(&choice, BEAM_PLOTS_NAMES, fault);
    assert(known);
    (void)known;
    for (size_t i = 0; i < PAPER_RUNS; i++)
        figures->responses[i] = beam_plots_make(&paper->responses[i], &paper->beams[i], NULL, &choice);
    for (size_t i = 0; i < PAPER_STUDIES; i++)
        figures->studies[i] = study_plots_make(&paper->studies[i], NULL);
    add_types(
        &figures->studies[PAPER_FREQUENCIES], paper->frequency, paper->types, PAPER_TYPES,
        study_axes_parameter(&paper->studies[PAPER_FREQUENCIES], 0, &figures->studies[PAPER_FREQUENCIES].arena).factor);
    add_types(&figures->studies[PAPER_LENGTHS], paper->length, paper->length_types, PAPER_LENGTH_TYPES,
              study_axes_parameter(&paper->studies[PAPER_LENGTHS], 0, &figures->studies[PAPER_LENGTHS].arena).factor);
    add_lengths(&figures->studies[PAPER_LENGTHS], paper,
                study_axes_parameter(&paper->studies[PAPER_LENGTHS], 0, &figures->studies[PAPER_LENGTHS].arena).factor);
    const Study *map = &paper->studies[PAPER_MAP];
    StudyPlots *maps = &figures->studies[PAPER_MAP];
    add_plane(maps, paper, study_axes_parameter(map, 0, &maps->arena).factor,
              study_axes_parameter(map, 1, &maps->arena).factor);
    const Plot *whole = find_study_plot(&figures->studies[PAPER_FREQUENCIES], "peaks");
    if (whole)
        figures->low_peaks = cut_peaks(whole, &figures->studies[PAPER_FREQUENCIES].arena);
    for (size_t i = 0; i < PAPER_FIGURES; i++) {
        const Source *source = &sources[i];
        figures->figures[i] = (PaperFigure){
            source->name, source->title, caption_of(source, paper, &maps->arena),
            source->is_run                         ? find_beam_plot(&figures->responses[source->of], source->plot)
            : strcmp(source->plot, LOW_PEAKS) == 0 ? (whole ? &figures->low_peaks : NULL)
                                                   : find_study_plot(&figures->studies[source->of], source->plot)};
    }
    return figures;
}

void paper_figures_free(PaperFigures *figures) {
    for (size_t i = 0; i < PAPER_RUNS; i++)
        beam_plots_free(&figures->responses[i]);
    for (size_t i = 0; i < PAPER_STUDIES; i++)
        study_plots_free(&figures->studies[i]);
    memory_free(figures);
}
