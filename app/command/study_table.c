#include "command/study_table.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "command/study_words.h"
#include "study/montecarlo.h"
#include "study/summary.h"

enum {
    WORD = STUDY_WORDS_WORD,
    ROWS_MOST = 12,   /* of the table */
    CHANGES_MOST = 5, /* whose both sides are among them */
    MAP_COLUMNS = 72, /* of a map in letters */
    MAP_ROWS = 24,
};

/* The rows to show: both ends, both sides of each change while there is room, and others evenly between. */
static void choose_rows(const Study *study, bool *chosen) {
    size_t steps = study_steps(study, 0), most = ROWS_MOST / (study->pass_count + 1) * 2, count;
    size_t rows = steps < most ? steps : most;
    for (size_t r = 0; r < rows; r++)
        chosen[rows > 1 ? r * (steps - 1) / (rows - 1) : 0] = true;
    SummaryRange *ranges = summary_ranges(study, 0, 0, &count);
    for (size_t r = 1; r < count && count <= CHANGES_MOST + 1 && study->pass_count == 1; r++)
        chosen[ranges[r].first] = chosen[ranges[r].first - 1] = true;
    memory_free(ranges);
}

static void print_cell(const char *text, size_t width) {
    printf("  %*s", (int)width, text);
}

static size_t head_width(const char *name, const char *unit) {
    size_t width = strlen(name) + (*unit ? 1 + strlen(unit) : 0);
    return width < 8 ? 8 : width;
}

static void print_head(const char *name, const char *unit) {
    char head[2 * WORD];
    snprintf(head, sizeof head, "%.60s%s%.20s", name, *unit ? " " : "", unit);
    print_cell(head, head_width(name, unit));
}

/* What a table of single runs shows besides the answer: whatever any of them has. */
static bool is_shown(const Study *study, const StudyLaboratory *laboratory, size_t observable) {
    const Experiment *experiment = study->experiment;
    if (observable == experiment->regular || strcmp(experiment->observables[observable].name, laboratory->hidden) == 0)
        return false;
    bool any = false;
    for (size_t t = 0; t < study->trial_count && !any; t++)
        any = !isnan(study->trials[t].observed[observable]);
    return any;
}

static void print_runs_row(const Study *study, const StudyLaboratory *laboratory, size_t pass, size_t i) {
    const Experiment *experiment = study->experiment;
    const Trial *trial = study_trial(study, pass, 0, 0, i);
    for (size_t o = 0; o < experiment->observable_count; o++) {
        const Observable *observable = &experiment->observables[o];
        char word[WORD];
        study_words_number(trial->observed[o], word);
        if (is_shown(study, laboratory, o))
            print_cell(word, head_width(observable->name, study_words_unit(observable)));
    }
}

/* With many runs: how many are regular, and the measure as a distribution. */
static void print_point_row(const Study *study, size_t pass, size_t i) {
    MontecarloPoint point = montecarlo_point(study, pass, 0, i);
    const Distribution *d = &point.of[study->experiment->measure];
    const double numbers[] = {d->mean, d->deviation, d->low, d->median, d->high};
    char word[WORD] = "-";
    if (point.decided)
        snprintf(word, sizeof word, "%.0f %%", 100 * point.share);
    print_cell(word, 8);
    for (size_t k = 0; k < sizeof numbers / sizeof *numbers; k++) {
        study_words_number(numbers[k], word);
        print_cell(word, 9);
    }
    montecarlo_clear(&point);
}

static void print_table_head(const Study *study, const StudyLaboratory *laboratory) {
    const Experiment *experiment = study->experiment;
    printf("\n");
    if (study->pass_count > 1)
        printf("  pass ");
    print_head(study->axes[0].name, study_words_axis_unit(study, 0));
    if (study->runs > 1) {
        static const char *const heads[] = {"mean", "deviation", "5 %", "50 %", "95 %"};
        print_cell(laboratory->regular, 8);
        for (size_t k = 0; k < sizeof heads / sizeof *heads; k++)
            print_cell(heads[k], 9);
        const Observable *measure = &experiment->observables[experiment->measure];
        printf("  of %s %s\n", measure->name, study_words_unit(measure));
        return;
    }
    print_cell("answer", 14);
    for (size_t o = 0; o < experiment->observable_count; o++)
        if (is_shown(study, laboratory, o))
            print_head(experiment->observables[o].name, study_words_unit(&experiment->observables[o]));
    printf("\n");
}

void study_table_print(const Study *study, const StudyLaboratory *laboratory) {
    bool *chosen = memory_zeroed(study_steps(study, 0), sizeof *chosen);
    choose_rows(study, chosen);
    print_table_head(study, laboratory);
    for (size_t i = 0; i < study_steps(study, 0); i++)
        for (size_t pass = 0; pass < study->pass_count && chosen[i]; pass++) {
            char value[WORD];
            study_words_step(study, 0, i, false, value);
            if (study->pass_count > 1)
                printf("  %-5s", study_pass_name(study->passes[pass]));
            print_cell(value, head_width(study->axes[0].name, study_words_axis_unit(study, 0)));
            if (study->runs > 1) {
                print_point_row(study, pass, i);
            } else {
                print_cell(study_words_state(laboratory, summary_point(study, pass, 0, i)), 14);
                print_runs_row(study, laboratory, pass, i);
            }
            printf("\n");
        }
    memory_free(chosen);
}

void study_table_map(const Study *study, const StudyLaboratory *laboratory, size_t pass) {
    static const char letters[] = {[SUMMARY_NOTHING] = ' ',
                                   [SUMMARY_REGULAR] = '#',
                                   [SUMMARY_IRREGULAR] = '.',
                                   [SUMMARY_MIXED] = '+',
                                   [SUMMARY_UNDECIDED] = '?'};
    size_t steps0 = study_steps(study, 0), steps1 = study_steps(study, 1);
    size_t columns = steps0 < MAP_COLUMNS ? steps0 : MAP_COLUMNS, rows = steps1 < MAP_ROWS ? steps1 : MAP_ROWS;
    SummaryCount count = summary_count(study);
    printf("\n# %s, . %s%s%s%s; to the right %s, upwards %s\n", laboratory->regular, laboratory->irregular,
           study->runs > 1 ? ", + sometimes" : "", count.undecided ? ", ? cannot be told" : "",
           count.faults || count.done < count.trials ? ", blank not run" : "", study->axes[0].name,
           study->axes[1].name);
    for (size_t r = rows; r-- > 0;) {
        size_t i1 = rows > 1 ? r * (steps1 - 1) / (rows - 1) : 0;
        char value[WORD];
        study_words_step(study, 1, i1, false, value);
        printf("%10s ", value);
        for (size_t c = 0; c < columns; c++)
            putchar(letters[summary_point(study, pass, i1, columns > 1 ? c * (steps0 - 1) / (columns - 1) : 0)]);
        printf("\n");
    }
    char from[WORD], to[WORD];
    study_words_step(study, 0, 0, false, from);
    study_words_step(study, 0, steps0 - 1, true, to);
    printf("%10s %s to %s\n", "", from, to);
}

void study_table_distributions(const Study *study, const StudyLaboratory *laboratory) {
    static const char *const heads[] = {"mean", "deviation", "std error", "5 %", "50 %", "95 %"};
    const Experiment *experiment = study->experiment;
    MontecarloPoint point = montecarlo_point(study, 0, 0, 0);
    printf("\n%-20s", "");
    for (size_t k = 0; k < sizeof heads / sizeof *heads; k++)
        print_cell(heads[k], 10);
    printf("\n");
    for (size_t o = 0; o < point.observables; o++) {
        if (!is_shown(study, laboratory, o))
            continue;
        const Distribution *d = &point.of[o];
        const double numbers[] = {d->mean, d->deviation, d->error, d->low, d->median, d->high};
        char word[WORD];
        snprintf(word, sizeof word, "%.30s %.10s", experiment->observables[o].name,
                 study_words_unit(&experiment->observables[o]));
        printf("%-20s", word);
        for (size_t k = 0; k < sizeof numbers / sizeof *numbers; k++) {
            study_words_number(numbers[k], word);
            print_cell(word, 10);
        }
        printf("\n");
    }
    montecarlo_clear(&point);
}
