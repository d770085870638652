#include "study/study_csv.h"

#include <errno.h>
#include <inttypes.h>
#include <math.h>
#include <stdio.h>

#include "base/file_write.h"
#include "base/memory.h"
#include "base/visible.h"
#include "study/montecarlo.h"
#include "study/summary.h"

/* Sheets --------------------------------------------------------------------------------------------------------- */

/* A table written cell by cell: the series of a map have millions of rows. */
typedef struct Sheet {
    FileWrite *work; /* NULL: the file cannot be created */
    FILE *file;      /* NULL, too */
    bool is_within;  /* a row */
    int error;
} Sheet;

static Sheet open_sheet(const char *path) {
    Sheet sheet = {.file = NULL};
    sheet.work = file_write_begin(path, &sheet.error);
    sheet.file = sheet.work ? file_write_stream(sheet.work) : NULL;
    if (sheet.work && !sheet.file)
        sheet.error = errno;
    return sheet;
}

static int close_sheet(Sheet *sheet) {
    return sheet->work ? file_write_end(sheet->work, sheet->error) : sheet->error;
}

static void begin_cell(Sheet *sheet) {
    if (sheet->is_within)
        putc(',', sheet->file);
    sheet->is_within = true;
}

static void end_row(Sheet *sheet) {
    fputs("\r\n", sheet->file);
    sheet->is_within = false;
}

static void add_number(Sheet *sheet, double value) {
    begin_cell(sheet);
    if (!isnan(value))
        fprintf(sheet->file, "%.9g", value);
}

static void add_count(Sheet *sheet, uint64_t count) {
    begin_cell(sheet);
    fprintf(sheet->file, "%" PRIu64, count);
}

static void add_word(Sheet *sheet, const char *word) {
    begin_cell(sheet);
    fputs(word, sheet->file);
}

/* Adds quoted text with inner quotes doubled; adds nothing for NULL. */
static void add_quoted(Sheet *sheet, const char *words) {
    begin_cell(sheet);
    if (!words)
        return;
    char *shown = visible_text(words);
    putc('"', sheet->file);
    for (const char *c = shown; *c; c++) {
        if (*c == '"')
            putc('"', sheet->file);
        putc(*c, sheet->file);
    }
    putc('"', sheet->file);
    memory_free(shown);
}

static void add_head(Sheet *sheet, const char *name, const char *kind, const char *unit) {
    begin_cell(sheet);
    fprintf(sheet->file, "%s%s%s [%s]", name, *kind ? "_" : "", kind, *unit ? unit : "1");
}

/* Tables --------------------------------------------------------------------------------------------------------- */

static void add_names_head(Sheet *sheet, const Study *study, size_t count) {
    const Experiment *experiment = study->experiment;
    for (size_t n = 0; n < count; n++)
        add_head(sheet, study->names[n], "", experiment->parameter(experiment->given, study->names[n])->unit);
    add_head(sheet, "pass", "", "");
}

/* Adds the cells that identify a trial. */
static void add_trial(Sheet *sheet, const Study *study, size_t index) {
    const Trial *trial = study_nth(study, index);
    for (size_t n = 0; n < study->name_count; n++)
        add_number(sheet, trial->at[n]);
    add_word(sheet, study_pass_name(study->passes[study_pass_of(study, index)]));
    add_count(sheet, trial->seed);
}

/* Adds a number, or the word of a class. */
static void add_observed(Sheet *sheet, const Experiment *experiment, const Trial *trial, size_t o) {
    bool verdict = experiment->verdict_count && o == experiment->verdict,
         rank = experiment->rank_count && o == experiment->rank;
    const char *word = verdict ? trial_verdict(trial, experiment) : rank ? trial_rank(trial, experiment) : NULL;
    if (verdict || rank)
        add_word(sheet, word ? word : "");
    else
        add_number(sheet, trial->observed[o]);
}

int study_csv_write_trials(const Study *study, const char *path) {
    const Experiment *experiment = study->experiment;
    Sheet sheet = open_sheet(path);
    if (!sheet.file)
        return close_sheet(&sheet);
    add_names_head(&sheet, study, study->name_count);
    add_head(&sheet, "seed", "", "");
    for (size_t o = 0; o < experiment->observable_count; o++)
        add_head(&sheet, experiment->observables[o].name, "", experiment->observables[o].unit);
    if (experiment->note)
        add_head(&sheet, experiment->note, "", "");
    add_head(&sheet, "fault", "", "");
    end_row(&sheet);
    for (size_t t = 0; t < study->trial_count; t++) {
        const Trial *trial = study_nth(study, t);
        if (!trial->done)
            continue;
        add_trial(&sheet, study, t);
        for (size_t o = 0; o < experiment->observable_count; o++)
            add_observed(&sheet, experiment, trial, o);
        if (experiment->note)
            add_quoted(&sheet, trial->note);
        add_quoted(&sheet, trial->fault);
        end_row(&sheet);
    }
    return close_sheet(&sheet);
}

int study_csv_write_series(const Study *study, const char *path) {
    const Observable *series = study->experiment->series;
    Sheet sheet = open_sheet(path);
    if (!sheet.file)
        return close_sheet(&sheet);
    add_names_head(&sheet, study, study->name_count);
    add_head(&sheet, "seed", "", "");
    add_head(&sheet, "place", "", "");
    add_head(&sheet, series->name, "", series->unit);
    end_row(&sheet);
    for (size_t t = 0; t < study->trial_count; t++) {
        const Trial *trial = study_nth(study, t);
        for (size_t i = 0; i < trial->series_count && trial->done; i++) {
            add_trial(&sheet, study, t);
            add_count(&sheet, i + 1);
            add_number(&sheet, trial->series[i]);
            end_row(&sheet);
        }
    }
    return close_sheet(&sheet);
}

static void add_points_head(Sheet *sheet, const Study *study) {
    static const char *const counts[] = {"runs", "faults", "regular", "share_regular", "share_q025", "share_q975"};
    static const char *const kinds[] = {"mean", "deviation", "standard_error", "q05", "q50", "q95"};
    add_names_head(sheet, study, study->axis_count);
    for (size_t c = 0; c < sizeof counts / sizeof *counts; c++)
        add_head(sheet, counts[c], "", "");
    for (size_t v = 0; v < study->experiment->verdict_count; v++)
        add_head(sheet, study->experiment->verdicts[v], "", "");
    for (size_t o = 0; o < study->experiment->observable_count; o++)
        for (size_t k = 0; k < sizeof kinds / sizeof *kinds && !summary_is_class(study->experiment, o); k++)
            add_head(sheet, study->experiment->observables[o].name, kinds[k], study->experiment->observables[o].unit);
    if (study->experiment->rank_count)
        add_head(sheet, study->experiment->observables[study->experiment->rank].name, "", "");
    if (study->experiment->note)
        add_head(sheet, study->experiment->note, "", "");
    end_row(sheet);
}

/* Adds the worst rank at a point, and the note of that run. */
static void add_worst_rank(Sheet *sheet, const Study *study, size_t pass, size_t i1, size_t i0) {
    const Trial *worst = summary_worst_rank(study, pass, i1, i0);
    if (study->experiment->rank_count)
        add_word(sheet, worst ? trial_rank(worst, study->experiment) : "");
    if (study->experiment->note)
        add_quoted(sheet, worst ? worst->note : NULL);
}

/* Returns how many runs at a point have a verdict. */
static size_t point_verdicts(const Study *study, size_t pass, size_t i1, size_t i0, size_t verdict) {
    size_t count = 0;
    for (size_t run = 0; run < study->runs; run++) {
        const Trial *trial = study_trial(study, pass, run, i1, i0);
        count += trial->done && !trial->fault && trial->observed[study->experiment->verdict] == (double)verdict;
    }
    return count;
}

static void add_point(Sheet *sheet, const Study *study, size_t pass, size_t i1, size_t i0) {
    const size_t steps[STUDY_AXES_MOST] = {i0, i1};
    MontecarloPoint point = montecarlo_point(study, pass, i1, i0);
    for (size_t a = 0; a < study->axis_count; a++)
        add_number(sheet, study_value(&study->axes[a], steps[a]));
    add_word(sheet, study_pass_name(study->passes[pass]));
    const size_t counts[] = {point.done, point.faults, point.regular};
    for (size_t c = 0; c < sizeof counts / sizeof *counts; c++)
        add_count(sheet, counts[c]);
    const double shares[] = {point.share, point.share_low, point.share_high};
    for (size_t s = 0; s < sizeof shares / sizeof *shares; s++)
        add_number(sheet, shares[s]);
    for (size_t v = 0; v < study->experiment->verdict_count; v++)
        add_count(sheet, point_verdicts(study, pass, i1, i0, v));
    for (size_t o = 0; o < point.observables; o++) {
        if (summary_is_class(study->experiment, o))
            continue;
        const Distribution *d = &point.of[o];
        const double numbers[] = {d->mean, d->deviation, d->error, d->low, d->median, d->high};
        for (size_t i = 0; i < sizeof numbers / sizeof *numbers; i++)
            add_number(sheet, numbers[i]);
    }
    add_worst_rank(sheet, study, pass, i1, i0);
    end_row(sheet);
    montecarlo_clear(&point);
}

int study_csv_write_points(const Study *study, const char *path) {
    Sheet sheet = open_sheet(path);
    if (!sheet.file)
        return close_sheet(&sheet);
    add_points_head(&sheet, study);
    for (size_t pass = 0; pass < study->pass_count; pass++)
        for (size_t i1 = 0; i1 < study_steps(study, 1); i1++)
            for (size_t i0 = 0; i0 < study_steps(study, 0); i0++)
                add_point(&sheet, study, pass, i1, i0);
    return close_sheet(&sheet);
}
