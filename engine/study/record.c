#include "study/record.h"

#include <inttypes.h>
#include <math.h>
#include <string.h>

#include "base/memory.h"
#include "base/text.h"
#include "study/montecarlo.h"

static void add_number(Text *text, double value) {
    if (isnan(value))
        text_add(text, ",");
    else
        text_format(text, "%.9g,", value);
}

/* In quotes, those inside doubled. */
static void add_quoted(Text *text, const char *words) {
    text_add(text, "\"");
    for (const char *c = words; *c; c++)
        text_add(text, *c == '"' ? "\"\"" : (const char[]){*c, 0});
    text_add(text, "\"");
}

static void add_head(Text *text, const char *name, const char *unit) {
    text_format(text, "%s [%s],", name, *unit ? unit : "1");
}

static void add_names_head(Text *text, const Study *study, size_t count) {
    const Experiment *experiment = study->experiment;
    for (size_t n = 0; n < count; n++)
        add_head(text, study->names[n], experiment->parameter(experiment->given, study->names[n])->unit);
}

/* The last cell of a row is followed by no comma. */
static void end_row(Text *text) {
    if (text->used && text->text[text->used - 1] == ',')
        text->text[--text->used] = 0;
    text_add(text, "\r\n");
}

static int write_text(Text *text, const char *path) {
    int error = text_write_file(path, text->text, text->used);
    memory_free(text->text);
    return error;
}

/* What tells one trial from another. */
static void add_trial(Text *text, const Study *study, size_t index) {
    const Trial *trial = &study->trials[index];
    for (size_t n = 0; n < study->name_count; n++)
        add_number(text, trial->at[n]);
    text_format(text, "%s,%" PRIu64 ",", study_pass_name(study->passes[study_pass_of(study, index)]), trial->seed);
}

int record_write_trials(const Study *study, const char *path) {
    const Experiment *experiment = study->experiment;
    Text text = {0};
    add_names_head(&text, study, study->name_count);
    text_add(&text, "pass [1],seed [1],");
    for (size_t o = 0; o < experiment->observable_count; o++)
        add_head(&text, experiment->observables[o].name, experiment->observables[o].unit);
    text_add(&text, "fault [1]\r\n");
    for (size_t t = 0; t < study->trial_count; t++) {
        const Trial *trial = &study->trials[t];
        if (!trial->done)
            continue;
        add_trial(&text, study, t);
        for (size_t o = 0; o < experiment->observable_count; o++)
            add_number(&text, trial->observed[o]);
        if (trial->fault)
            add_quoted(&text, trial->fault);
        text_add(&text, "\r\n");
    }
    return write_text(&text, path);
}

int record_write_series(const Study *study, const char *path) {
    Text text = {0};
    add_names_head(&text, study, study->name_count);
    text_add(&text, "pass [1],seed [1],place [1],");
    add_head(&text, study->experiment->series->name, study->experiment->series->unit);
    end_row(&text);
    for (size_t t = 0; t < study->trial_count; t++) {
        const Trial *trial = &study->trials[t];
        for (size_t i = 0; i < trial->series_count && trial->done; i++) {
            add_trial(&text, study, t);
            text_format(&text, "%zu,", i + 1);
            add_number(&text, trial->series[i]);
            end_row(&text);
        }
    }
    return write_text(&text, path);
}

static void add_distribution(Text *text, const Distribution *d) {
    const double numbers[] = {d->mean, d->deviation, d->error, d->low, d->median, d->high};
    for (size_t i = 0; i < sizeof numbers / sizeof *numbers; i++)
        add_number(text, numbers[i]);
}

static void add_points_head(Text *text, const Study *study) {
    static const char *const kinds[] = {"mean", "deviation", "standard_error", "q05", "q50", "q95"};
    add_names_head(text, study, study->axis_count);
    text_add(text, "pass [1],runs [1],faults [1],regular [1],share_regular [1],share_q025 [1],share_q975 [1],");
    for (size_t o = 0; o < study->experiment->observable_count; o++)
        for (size_t k = 0; k < sizeof kinds / sizeof *kinds; k++) {
            const Observable *observable = &study->experiment->observables[o];
            text_format(text, "%s_%s [%s],", observable->name, kinds[k], *observable->unit ? observable->unit : "1");
        }
    end_row(text);
}

int record_write_points(const Study *study, const char *path) {
    Text text = {0};
    add_points_head(&text, study);
    for (size_t pass = 0; pass < study->pass_count; pass++)
        for (size_t i1 = 0; i1 < study_steps(study, 1); i1++)
            for (size_t i0 = 0; i0 < study_steps(study, 0); i0++) {
                const size_t steps[STUDY_AXES_MOST] = {i0, i1};
                MontecarloPoint point = montecarlo_point(study, pass, i1, i0);
                for (size_t a = 0; a < study->axis_count; a++)
                    add_number(&text, study_value(&study->axes[a], steps[a]));
                text_format(&text, "%s,%zu,%zu,%zu,", study_pass_name(study->passes[pass]), point.done, point.faults,
                            point.regular);
                add_number(&text, point.share);
                add_number(&text, point.share_low);
                add_number(&text, point.share_high);
                for (size_t o = 0; o < point.observables; o++)
                    add_distribution(&text, &point.of[o]);
                end_row(&text);
                montecarlo_clear(&point);
            }
    return write_text(&text, path);
}
