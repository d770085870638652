#include "check.h"

#include <math.h>
#include <string.h>

#include "visual/study/study_maps.h"
#include "visual/study/study_plots.h"

/* Studies with hand-written results. */
enum { REGULAR, OUTCOME, MEASURE, MEASURE_ERROR, RATIO, OBSERVABLES };

static const Observable observables[] = {[REGULAR] = {"regular", "1", "periodic"},
                                         [OUTCOME] = {"period", "1", "period"},
                                         [MEASURE] = {"peak_max", "N", "largest peak force"},
                                         [MEASURE_ERROR] = {"peak_max_error", "N", "standard error"},
                                         [RATIO] = {"clearance_ratio", "1", "g/a"}};
static const Observable listed = {"peak", "N", "peak force"};
static const Parameter frequency = {.name = "drive.frequency", .unit = "Hz"},
                       clearance = {.name = "joint.clearance", .unit = "m"};

static const Parameter *find_parameter(const void *given, const char *name) {
    (void)given;
    return strcmp(name, frequency.name) == 0 ? &frequency : &clearance;
}

static const Experiment beam = {.kind = "beam",
                                .observables = observables,
                                .observable_count = OBSERVABLES,
                                .series = &listed,
                                .regular = REGULAR,
                                .outcome = OUTCOME,
                                .measure = MEASURE,
                                .parameter = find_parameter};

/* Returns a study with memory for its trials; `free_study` releases it. */
static Study make_study(const Experiment *experiment, size_t steps0, size_t steps1, size_t runs, size_t passes) {
    Study study = {.experiment = experiment,
                   .axes = {{"drive.frequency", 100, 300, steps0}, {"joint.clearance", 1e-4, 2e-4, steps1}},
                   .axis_count = (steps0 > 1) + (steps1 > 1),
                   .passes = {STUDY_RESET, STUDY_UP, STUDY_DOWN},
                   .pass_count = passes,
                   .runs = runs};
    study.trial_count = passes * runs * steps0 * steps1;
    study.trials = memory_zeroed(study.trial_count, sizeof *study.trials);
    study.values = memory_zeroed(study.trial_count * (2 + OBSERVABLES), sizeof *study.values);
    for (size_t t = 0; t < study.trial_count; t++) {
        double *at = study.values + t * (2 + OBSERVABLES);
        at[0] = 100 + 200.0 * (double)(t % steps0) / (double)(steps0 > 1 ? steps0 - 1 : 1);
        at[1] = 1e-4 + 1e-4 * (double)(t / steps0 % steps1) / (double)(steps1 > 1 ? steps1 - 1 : 1);
        study.trials[t] = (Trial){.at = at, .observed = at + 2, .done = true};
        at[2 + REGULAR] = at[2 + OUTCOME] = 1;
        at[2 + MEASURE] = 500 + (double)t;
        at[2 + RATIO] = 1e4 * at[1];
    }
    return study;
}

static void free_study(Study *study) {
    for (size_t t = 0; t < study->trial_count; t++)
        trial_clear(&study->trials[t]);
    memory_free(study->trials);
    memory_free(study->values);
}

static const Plot *find_plot(const StudyPlots *plots, const char *name) {
    for (size_t i = 0; i < plots->count; i++)
        if (strcmp(plots->plots[i].name, name) == 0)
            return &plots->plots[i].plot;
    return NULL;
}

TEST(an_orbit_diagram_has_every_listed_number_of_every_pass_and_tells_passes_apart) {
    Study study = make_study(&beam, 5, 1, 1, 3);
    size_t all = 0, shown = 0;
    for (size_t t = 0; t < study.trial_count; t++) {
        Trial *trial = &study.trials[t];
        trial->series_count = t % 4;
        trial->series = memory_zeroed(4, sizeof *trial->series);
        for (size_t s = 0; s < t % 4; s++)
            trial->series[s] = 100.0 * (double)t + (double)s;
        all += t % 4;
    }
    StudyPlots plots = study_plots_make(&study, NULL);
    const Plot *plot = find_plot(&plots, "peaks");
    CHECK(plot && plot->series_count == 3);
    for (size_t a = 0; plot && a < plot->series_count; a++) {
        shown += plot->series[a].count;
        for (size_t b = 0; b < a; b++)
            CHECK(plot->series[a].role != plot->series[b].role && plot->series[a].symbol != plot->series[b].symbol);
    }
    CHECK(shown == all);
    CHECK(plot && plot_value(&plot->series[0], 0).x == 150 && plot_value(&plot->series[0], 0).y == 100);
    study_plots_free(&plots);
    free_study(&study);
}

TEST(an_observable_has_its_standard_error_as_an_area_and_no_plot_of_the_error_alone) {
    Study study = make_study(&beam, 4, 1, 1, 1);
    for (size_t t = 0; t < 4; t++)
        study.trials[t].observed[MEASURE_ERROR] = 7 + (double)t;
    study.trials[2].done = false;
    StudyPlots plots = study_plots_make(&study, NULL);
    const Plot *plot = find_plot(&plots, "peak_max");
    CHECK(plot && plot->area_count == 1 && plot->series_count == 1);
    CHECK(!find_plot(&plots, "peak_max_error") && !find_plot(&plots, "regular")); /* equal everywhere */
    CHECK_NEAR(plot->areas[0].low[1], 501 - 8, 1e-9);
    CHECK_NEAR(plot->areas[0].high[1], 501 + 8, 1e-9);
    CHECK(isnan(plot_value(&plot->series[0], 2).y));
    study_plots_free(&plots);
    free_study(&study);
}

TEST(many_runs_have_a_mean_and_what_lies_between_five_and_ninety_five_percent) {
    Study study = make_study(&beam, 2, 1, 101, 1);
    for (size_t run = 0; run < 101; run++)
        for (size_t i = 0; i < 2; i++)
            study.trials[run * 2 + i].observed[MEASURE] = (double)((run * 37) % 101) + 1000.0 * (double)i;
    StudyPlots plots = study_plots_make(&study, NULL);
    const Plot *plot = find_plot(&plots, "peak_max");
    CHECK(plot && plot->area_count == 1);
    for (size_t i = 0; i < 2; i++) {
        CHECK_NEAR(plot->areas[0].low[i], 5 + 1000.0 * (double)i, 1e-9);
        CHECK_NEAR(plot->areas[0].high[i], 95 + 1000.0 * (double)i, 1e-9);
        CHECK_NEAR(plot_value(&plot->series[0], i).y, 50 + 1000.0 * (double)i, 1e-9);
    }
    study_plots_free(&plots);
    free_study(&study);
}

TEST(a_histogram_counts_every_run_once) {
    Study study = make_study(&beam, 1, 1, 200, 1);
    study.trials[3].observed[MEASURE] = NAN;
    StudyPlots plots = study_plots_make(&study, NULL);
    const Plot *plot = find_plot(&plots, "peak_max");
    double sum = 0;
    CHECK(plot && plot->series_count == 1);
    for (size_t i = 0; plot && i < plot->series[0].count; i += 2)
        sum += plot_value(&plot->series[0], i).y;
    CHECK_NEAR(sum, 199, 0);
    study_plots_free(&plots);
    free_study(&study);
}

TEST(a_house_shows_where_not_everybody_gets_out) {
    Experiment house = beam;
    house.kind = "house";
    Study study = make_study(&house, 5, 1, 1, 1);
    for (size_t t = 1; t < 3; t++) {
        study.trials[t].observed[REGULAR] = 0;
        study.trials[t].observed[MEASURE] = NAN;
    }
    StudyPlots plots = study_plots_make(&study, NULL);
    const Plot *plot = find_plot(&plots, "peak_max");
    CHECK(plot && plot->guide_count == 1 && plot->guides[0].band);
    CHECK_NEAR(plot->guides[0].at, 125, 1e-9);
    CHECK_NEAR(plot->guides[0].to, 225, 1e-9);
    study_plots_free(&plots);
    free_study(&study);
}

TEST(a_map_of_periods_has_the_classes_that_there_are_and_the_second_axis_the_ratio) {
    Study study = make_study(&beam, 4, 3, 1, 1);
    static const double periods[] = {1, 2, 0, 1, 1, 16, 0, 0, 2, 1, 1, 1};
    for (size_t t = 0; t < 12; t++)
        study.trials[t].observed[OUTCOME] = periods[t];
    study.trials[11].done = false;
    StudyPlots plots = study_plots_make(&study, NULL);
    const Plot *plot = find_plot(&plots, "map-period");
    CHECK(plot && plot->raster && plot->raster->class_count == 4);
    for (size_t t = 0; plot && t < 12; t++) {
        double value = plot->raster->values[t];
        const char *expected = periods[t] == 0   ? "not periodic"
                               : periods[t] == 1 ? "period 1"
                               : periods[t] == 2 ? "period 2"
                                                 : "9 and more";
        if (t == 11)
            CHECK(isnan(value));
        else
            CHECK_TEXT(plot->raster->classes[(size_t)value].name, expected);
    }
    CHECK_NEAR(plot->right_factor, 1e4 / 1000, 1e-9); /* of mm */
    CHECK_TEXT(plot->y.unit, "mm");
    CHECK_NEAR(plot->raster->box.low.y, 0.075, 1e-12);
    CHECK_NEAR(plot->raster->box.high.y, 0.225, 1e-12);
    study_plots_free(&plots);
    free_study(&study);
}

TEST(a_map_of_periods_counts_in_the_experiments_own_cycles) {
    Experiment crank = beam;
    crank.cycle = "revolution";
    const Experiment *const experiments[] = {&beam, &crank};
    static const char *const titles[] = {"Periodic or not, and the period in cycles",
                                         "Periodic or not, and the period in revolutions"};
    for (size_t e = 0; e < 2; e++) {
        Study study = make_study(experiments[e], 2, 2, 1, 1);
        StudyPlots plots = study_plots_make(&study, NULL);
        const Plot *plot = find_plot(&plots, "map-period");
        CHECK(plot);
        if (plot)
            CHECK_TEXT(plot->title, titles[e]);
        study_plots_free(&plots);
        free_study(&study);
    }
}

TEST(a_map_tells_what_cannot_be_told_from_what_is_not_run) {
    Study study = make_study(&beam, 3, 2, 1, 1);
    study.trials[1].observed[OUTCOME] = study.trials[1].observed[REGULAR] = NAN;
    study.trials[2].observed[OUTCOME] = study.trials[2].observed[REGULAR] = NAN;
    study.trials[2].done = false;
    StudyPlots plots = study_plots_make(&study, NULL);
    static const char *const names[] = {"map-period", "map-regular"};
    for (size_t n = 0; n < 2; n++) {
        const Plot *plot = find_plot(&plots, names[n]);
        CHECK(plot && plot->raster->class_count == 2 && isnan(plot->raster->values[2]));
        CHECK_TEXT(plot->raster->classes[(size_t)plot->raster->values[1]].name, "undecided");
    }
    study_plots_free(&plots);
    free_study(&study);
}

TEST(attractors_are_told_by_outcome_and_measure_the_most_visited_first) {
    Study study = make_study(&beam, 3, 3, 1, 1);
    static const double measures[] = {759, 500, 759.1, 500.1, 759, 759, 759, 0, 0};
    static const double expected[] = {0, 1, 0, 1, 0, 0, 2, 3, 4}; /* A to C, irregular, unknown */
    for (size_t t = 0; t < 9; t++)
        study.trials[t].observed[MEASURE] = measures[t];
    study.trials[6].observed[OUTCOME] = 5;
    study.trials[7].observed[REGULAR] = 0;
    study.trials[8].observed[REGULAR] = NAN;
    study.axes[0].name = "start.deflection";
    study.axes[1].name = "start.velocity";
    StudyPlots plots = study_plots_make(&study, NULL);
    const Plot *basins = find_plot(&plots, "basins");
    CHECK(basins && basins->raster->class_count == 5);
    for (size_t t = 0; t < 9; t++)
        CHECK(basins->raster->values[t] == expected[t]);
    CHECK_TEXT(basins->raster->classes[4].name, "undecided");
    CHECK_TEXT(basins->raster->classes[0].name, "A: period 1, 759 N");
    study_plots_free(&plots);
    free_study(&study);
}

TEST(the_points_of_each_rank_are_marked_over_the_measure_and_a_map_has_a_class_for_each) {
    static const char *const ranks[] = {"A", "B", "C"};
    Experiment ranked = beam;
    ranked.series = NULL;
    ranked.rank = RATIO;
    ranked.ranks = ranks;
    ranked.rank_count = 3;
    Study study = make_study(&ranked, 4, 1, 1, 1);
    static const double known[] = {NAN, 2, 2, 0};
    for (size_t t = 0; t < 4; t++)
        study.trials[t].observed[RATIO] = known[t];
    StudyPlots plots = study_plots_make(&study, NULL);
    const Plot *plot = find_plot(&plots, "peak_max");
    CHECK(plot && plot->series_count == 3 && !find_plot(&plots, "clearance_ratio"));
    CHECK_TEXT(plot ? plot->series[1].name : "", "clearance_ratio A");
    CHECK_TEXT(plot ? plot->series[2].name : "", "clearance_ratio C");
    for (size_t t = 0; plot && t < 4; t++) {
        CHECK(isnan(plot->series[2].y[t]) == (known[t] != 2) && isnan(plot->series[1].y[t]) == (known[t] != 0));
        CHECK(known[t] != 2 || plot->series[2].y[t] == plot->series[0].y[t]);
    }
    study_plots_free(&plots);
    free_study(&study);
    study = make_study(&ranked, 2, 2, 1, 1);
    for (size_t t = 0; t < 4; t++)
        study.trials[t].observed[RATIO] = known[t];
    plots = study_plots_make(&study, NULL);
    const Plot *map = find_plot(&plots, "map-clearance_ratio");
    CHECK(map && map->raster->class_count == 3 && map->raster->values[0] == 2); /* which was run, and has no rank */
    CHECK_TEXT(map ? map->raster->classes[2].name : "", "none");
    CHECK_TEXT(map ? map->raster->classes[1].mark : "", "C");
    study_plots_free(&plots);
    free_study(&study);
}

TEST(measured_columns_are_the_study_s_parameters_and_observables) {
    Study study = make_study(&beam, 4, 1, 1, 1);
    Arena arena = {0};
    size_t count;
    const MeasuredKind *kinds = study_plots_kinds(&study, &count, &arena);
    CHECK(count == 1 + 1 + OBSERVABLES);
    CHECK_TEXT(kinds[0].name, "drive.frequency");
    CHECK_TEXT(kinds[0].unit, "Hz");
    double values[2][1] = {{200}, {510}};
    MeasuredColumn columns[] = {{"drive.frequency", values[0], 1}, {"peak_max", values[1], 1}};
    Measured measured = {.columns = columns, .column_count = 2, .count = 1};
    StudyPlots plots = study_plots_make(&study, &measured);
    static const char *const names[] = {"peaks", "peak_max"};
    for (int i = 0; i < 2; i++) {
        const Plot *plot = find_plot(&plots, names[i]);
        const PlotSeries *last = &plot->series[plot->series_count - 1];
        CHECK(last->open && last->count == 1 && plot_value(last, 0).x == 200 && plot_value(last, 0).y == 510);
    }
    study_plots_free(&plots);
    arena_clear(&arena);
    free_study(&study);
}

TEST(a_map_of_more_cells_than_pixels_shows_evenly_spaced_ones_and_says_so) {
    Study study = make_study(&beam, 2501, 3, 1, 1);
    StudyPlots plots = study_plots_make(&study, NULL);
    const Plot *plot = find_plot(&plots, "map-peak_max");
    CHECK(plot && plot->raster->columns == 834 && plot->raster->rows == 3);
    double step = 200.0 / 2500;
    for (size_t i = 0; plot && i < 834; i++)
        CHECK(plot->raster->values[834 + i] == 500 + 2501 + 3.0 * (double)i);
    CHECK_NEAR(plot ? plot->raster->box.low.x : 0, 100 - 1.5 * step, 1e-9);
    CHECK_NEAR(plot ? plot->raster->box.high.x : 0, 100 + 3 * 833 * step + 1.5 * step, 1e-9);
    CHECK(plot && plot->note && strstr(plot->note, "one cell of 3 x 1"));
    study_plots_free(&plots);
    free_study(&study);
}
