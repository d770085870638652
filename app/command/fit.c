#include <errno.h>
#include <inttypes.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/digest.h"
#include "base/text.h"
#include "crank/crank.h"
#include "command/answer.h"
#include "command/command.h"
#include "command/fit_house.h"
#include "command/house_file.h"
#include "command/output.h"
#include "command/progress.h"
#include "command/report_files.h"
#include "platform/terminal.h"
#include "experiment/beam_experiment.h"
#include "experiment/beam_frequencies.h"
#include "experiment/house_experiment.h"
#include "laboratory/shipped.h"
#include "plot/plot_write.h"
#include "report/fit_report.h"
#include "result/fit.h"
#include "result/json.h"
#include "result/source_line.h"
#include "result/text.h"
#include "visual/study/fit_plots.h"

#define SPREAD 0.5           /* 1, of the logarithm of what is not given with --prior: assumed */
#define PEAK_DEVIATION 0.05  /* 1, of the logarithm of a peak: assumed */
#define TONE_DEVIATION 0.005 /* 1, of the logarithm of a natural frequency: assumed */

/* Beams -------------------------------------------------------------------------------------------------------------
 */

enum { MOTION, TONES, BEAM_EXPERIMENTS };

/* Lists what the columns of a file may be: numbers of the beam, and what its experiments observe. */
static size_t list_kinds(const FitJob *job, MeasuredKind kinds[MEASURED_KINDS]) {
    size_t count = 0;
    for (size_t r = 0; r < beam_table()->count && count < MEASURED_KINDS; r++) {
        const Parameter *row = &beam_table()->rows[r];
        if (row->kind == PARAMETER_NUMBER)
            kinds[count++] = (MeasuredKind){row->name, NULL, row->unit};
    }
    for (size_t e = 0; e < BEAM_EXPERIMENTS; e++)
        for (size_t o = 0; o < job->experiments[e].observable_count && count < MEASURED_KINDS; o++) {
            const Observable *observable = &job->experiments[e].observables[o];
            kinds[count++] = (MeasuredKind){observable->name, NULL, observable->unit};
        }
    return count;
}

/* The parameters that the file gives for each row. */
typedef struct Given {
    const char **names; /* (count) */
    const double **values;
    size_t count;
} Given;

static Given list_given(FitJob *job) {
    Given given = {.names = arena_allocate(&job->arena, job->measured.column_count * sizeof *given.names),
                   .values = arena_allocate(&job->arena, job->measured.column_count * sizeof *given.values)};
    for (size_t c = 0; c < job->measured.column_count; c++)
        if (parameters_find(beam_table(), job->measured.columns[c].name)) {
            given.names[given.count] = job->measured.columns[c].name;
            given.values[given.count++] = job->measured.columns[c].values;
        }
    return given;
}

static void add_observed(FitJob *job, const Given *given, size_t e, size_t observable, const double *values) {
    const Experiment *experiment = &job->experiments[e];
    for (size_t i = 0; i < job->measured.count; i++) {
        double *at = arena_allocate(&job->arena, (given->count + 1) * sizeof *at);
        if (!(values[i] > 0))
            continue;
        const char *label = text_in_arena(&job->arena, "row %zu", i + 1);
        for (size_t g = 0; g < given->count; g++) {
            bool known = !isnan(given->values[g][i]);
            at[g] = known ? given->values[g][i] : experiment->nominal(experiment->given, given->names[g]);
            label = g ? label : text_in_arena(&job->arena, "%s %g", given->names[g], at[g]);
        }
        fit_house_add_row(job, (FitRow){.experiment = experiment,
                                        .observable = observable,
                                        .way = SIZE_MAX,
                                        .names = given->names,
                                        .at = at,
                                        .name_count = given->count,
                                        .observed = values[i],
                                        .deviation = e == TONES ? TONE_DEVIATION : PEAK_DEVIATION,
                                        .relative = true,
                                        .group = e == TONES ? job->fit.row_count : i,
                                        .label = label});
        job->fit.robust |= e == MOTION;
        job->fit.jumps |= e == MOTION;
    }
}

static bool open_beam(FitJob *job, Fault *fault) {
    const Options *options = job->options;
    MeasuredKind kinds[MEASURED_KINDS];
    const char *foreign = options->observed ? "--observed" : options->driving >= 0 ? "--driving" : NULL;
    if (foreign)
        fault_add(fault, "clearance: %s is for houses, %s is a beam", foreign, options->files[0]);
    else if (!options->measured)
        fault_add(fault, "clearance: a beam is fitted to --measured FILE");
    else if (!options->fit)
        fault_add(fault, "clearance: --fit must name what to fit, for instance shaker.position,shaker.moving_mass");
    if (fault->total || !beam_read(&job->beam, options->files[0], options->settings, options->setting_count, fault))
        return false;
    job->experiments = memory_zeroed(BEAM_EXPERIMENTS, sizeof *job->experiments);
    if (!beam_experiment_of(&job->experiments[MOTION], &job->beam, options->files[0], fault))
        return false;
    beam_frequencies_open(&job->experiments[TONES], &job->beam);
    job->experiment_count = BEAM_EXPERIMENTS;
    if (!measured_read(&job->measured, options->measured, kinds, list_kinds(job, kinds), fault))
        return false;
    Given given = list_given(job);
    for (size_t e = 0; e < BEAM_EXPERIMENTS; e++)
        for (size_t o = 0; o < job->experiments[e].observable_count; o++) {
            const double *values = measured_find(&job->measured, job->experiments[e].observables[o].name);
            if (values)
                add_observed(job, &given, e, o, values);
        }
    if (!job->fit.row_count)
        fault_add(fault, "%s:1:1: no column is a positive result of a beam, such as peak_max or frequency_1",
                  options->measured);
    return job->fit.row_count;
}

/* What is fitted ----------------------------------------------------------------------------------------------------
 */

static bool is_given(const FitJob *job, const char *name) {
    for (size_t i = 0; i < (job->fit.row_count ? job->fit.rows[0].name_count : 0); i++)
        if (strcmp(job->fit.rows[0].names[i], name) == 0)
            return true;
    return false;
}

static void add_unknown(FitJob *job, const char *given_name, Fault *fault) {
    const Experiment *experiment = &job->experiments[0];
    const Parameter *row = experiment->parameter(experiment->given, given_name);
    Fit *fit = &job->fit;
    if (!row) {
        experiment->unknown(experiment->given, given_name, "clearance: --fit: ", fault);
        return;
    }
    const char *name = arena_text(&job->arena, job->is_beam ? row->name : given_name);
    double prior = experiment->nominal(experiment->given, name);
    for (size_t i = 0; i < fit->unknown_count; i++)
        if (strcmp(job->unknowns[i].name, name) == 0) {
            fault_add(fault, "clearance: --fit names %s twice", name);
            return;
        }
    if (fit->unknown_count == FIT_UNKNOWNS_MOST)
        fault_add(fault, "clearance: --fit names too many parameters, must be at most %d", FIT_UNKNOWNS_MOST);
    else if (is_given(job, name))
        fault_add(fault, "clearance: %s is a column of the measured values, it cannot be fitted too", name);
    else
        job->unknowns[fit->unknown_count++] = (FitUnknown){.name = name, .prior = prior, .spread = SPREAD};
}

static void set_prior(FitJob *job, const char *word, Fault *fault) {
    const char *equal = strchr(word, '=');
    char *end = NULL;
    double value = equal ? strtod(equal + 1, &end) : 0;
    double spread = end && *end == ':' ? strtod(end + 1, &end) : 0;
    if (!equal || *end || !(value > 0 && value < HUGE_VAL) || !(spread > 0 && spread <= 5)) {
        fault_add(fault,
                  "clearance: --prior takes NAME=VALUE:SPREAD, both more than 0 and SPREAD at most 5, not \"%s\"",
                  word);
        return;
    }
    for (size_t i = 0; i < job->fit.unknown_count; i++) {
        FitUnknown *unknown = &job->unknowns[i];
        size_t length = (size_t)(equal - word), whole = strlen(unknown->name);
        bool same = length <= whole && strncmp(unknown->name + whole - length, word, length) == 0 &&
                    (length == whole || unknown->name[whole - length - 1] == '.');
        if (!same)
            continue;
        unknown->prior = value;
        unknown->spread = spread;
        return;
    }
    fault_add(fault, "clearance: --prior: %.*s is not fitted", (int)(equal - word), word);
}

static void each_word(FitJob *job, const char *list, void (*take)(FitJob *job, const char *word, Fault *fault),
                      Fault *fault) {
    char *copy = list ? text_copy(list) : NULL, *rest = copy, *word;
    while (copy && (word = strsep(&rest, ",")))
        take(job, word, fault);
    memory_free(copy);
}

static bool choose(FitJob *job, Fault *fault) {
    const char *names = job->options->fit ? job->options->fit : fit_house_names(job);
    if (!names)
        fault_add(fault, "clearance: nobody in this house has a chair, so that --fit must name what to fit");
    each_word(job, names, add_unknown, fault);
    if (!fault->total)
        each_word(job, job->options->priors, set_prior, fault);
    for (size_t i = 0; i < job->fit.unknown_count && !fault->total; i++)
        if (!(job->unknowns[i].prior > 0))
            fault_add(fault,
                      "clearance: --fit: %s is %g, only what is more than 0 can be fitted; give --prior %s=VALUE:1",
                      job->unknowns[i].name, job->unknowns[i].prior, job->unknowns[i].name);
    job->fit.unknowns = job->unknowns;
    return !fault->total;
}

/* Answers -----------------------------------------------------------------------------------------------------------
 */

static json_t *correlations(const Fit *fit) {
    json_t *rows = json_array();
    for (size_t i = 0; i < fit->unknown_count; i++) {
        json_t *row = json_array();
        for (size_t j = 0; j < fit->unknown_count; j++)
            json_array_append_new(row, json_real(fit_correlation(fit, i, j)));
        json_array_append_new(rows, row);
    }
    return rows;
}

static json_t *answer_of(const FitJob *job) {
    Arena arena = {0};
    size_t count;
    if (job->fit.interrupted) { /* no number is known */
        json_t *nothing = json_pack("{s:s, s:s, s:s}", "kind", "fit", "of", job->options->files[0], "headline",
                                    result_fit_sentence(&job->fit, &arena));
        answer_mark_interrupted(nothing, true);
        arena_clear(&arena);
        return nothing;
    }
    const char **remarks = result_fit_remarks(&job->fit, &count, &arena);
    json_t *lines = json_array();
    for (size_t i = 0; i < count; i++)
        json_array_append_new(lines, json_string(remarks[i]));
    json_t *answer =
        json_pack("{s:s, s:s, s:s, s:o, s:o, s:o, s:o}", "kind", "fit", "of", job->options->files[0], "headline",
                  result_fit_sentence(&job->fit, &arena), "parameters",
                  result_json_take_list(result_fit_unknowns(&job->fit, &job->experiments[0])), "correlation",
                  correlations(&job->fit), "rows", result_json_take_list(result_fit_rows(&job->fit)), "remarks", lines);
    result_json_take_record(answer, result_fit_whole(&job->fit));
    arena_clear(&arena);
    return answer;
}

static void print_answer(const FitJob *job) {
    Arena arena = {0};
    Text text = {0};
    size_t count;
    const char **remarks = result_fit_remarks(&job->fit, &count, &arena);
    text_format(&text, "%s\n", result_fit_sentence(&job->fit, &arena));
    if (!job->fit.interrupted) {
        result_text_take(&text, "", result_fit_unknowns(&job->fit, &job->experiments[0]));
        result_text_take(&text, "", result_fit_rows(&job->fit));
        ResultTable whole = result_fit_whole(&job->fit);
        text_add(&text, "\n");
        result_text_list(&text, (const ResultTable *const[]){&whole}, 1);
        result_clear(&whole);
        for (size_t i = 0; i < count; i++)
            text_format(&text, "%s%s\n", i ? "" : "\n", remarks[i]);
    }
    output_text(&text);
    memory_free(text.text);
    arena_clear(&arena);
}

/* Returns the files of what was measured, each with a digest of its bytes, "times.csv (0123456789abcdef)"; a pipe has
 * been read and has none. */
static const char *sources_of(const FitJob *job, Arena *arena) {
    const char *files = job->is_beam ? job->options->measured : job->options->observed;
    char *list = text_copy(files ? files : ""), *rest = list, *file;
    Text text = {0};
    while (files && (file = strsep(&rest, ","))) {
        size_t size = 0;
        struct stat status;
        bool regular = stat(file, &status) == 0 && S_ISREG(status.st_mode);
        char *bytes = regular ? text_read_file(file, SIZE_MAX, &size) : NULL;
        text_format(&text, "%s%s", text.used ? ", " : "", file);
        if (bytes)
            text_format(&text, " (%016" PRIx64 ")", digest_bytes(DIGEST_START, bytes, size));
        memory_free(bytes);
    }
    const char *sources = text.used ? arena_text(arena, text.text) : "its observed times";
    memory_free(text.text);
    memory_free(list);
    return sources;
}

/* Sets one value of a profile's or a beam's file, with where it comes from; false: it is not of this file. */
static bool set_value(const FitJob *job, json_t *root, const char *profile, const FitUnknown *unknown) {
    const Experiment *experiment = &job->experiments[0];
    const Parameter *row = experiment->parameter(experiment->given, unknown->name);
    const char *dot = strchr(row->name, '.');
    size_t length = profile ? strlen(profile) : 0;
    bool mine = job->is_beam || (strncmp(unknown->name, "profile.", 8) == 0 &&
                                 strncmp(unknown->name + 8, profile, length) == 0 && unknown->name[8 + length] == '.');
    if (!unknown->told || !mine || !dot)
        return false;
    Arena arena = {0};
    const char *group_name = text_in_arena(&arena, "%.*s", (int)(dot - row->name), row->name);
    json_t *group = json_object_get(root, group_name);
    if (!group)
        json_object_set_new(root, group_name, group = json_object());
    const char *provenance =
        text_in_arena(&arena, "%s: %s, %s, %zu values, 90 %% %.4g to %.4g", job->is_beam ? "identified" : "fitted",
                      job->options->files[0], sources_of(job, &arena), job->fit.row_count, unknown->low, unknown->high);
    json_object_set_new(group, dot + 1, json_pack("{s:f, s:s}", "value", unknown->value, "provenance", provenance));
    arena_clear(&arena);
    return true;
}

/* Writes a copy of a file with the told values as OUT/NAME-fitted.json, unless none of them is in it. */
static bool write_copy(const FitJob *job, const char *from, const char *name, bool profile) {
    json_t *root = json_load_file(from, 0, NULL);
    char path[OUTPUT_PATH];
    bool changed = false;
    for (size_t i = 0; i < job->fit.unknown_count && root; i++)
        changed |= set_value(job, root, profile ? name : NULL, &job->unknowns[i]);
    int error = 0;
    if (changed) {
        snprintf(path, sizeof path, "%s/%.200s-fitted.json", job->options->out, name);
        char fitted[240];
        snprintf(fitted, sizeof fitted, "%.200s-fitted", name);
        json_object_set_new(root, "name", json_string(fitted));
        error = answer_write(root, path);
        if (error)
            output_failed(path, error);
    }
    json_decref(root);
    return !error;
}

/* Returns the file of a profile: in the folder of the house first. */
static const char *profile_file(FitJob *job, const char *name) {
    const char *house = job->options->files[0], *slash = strrchr(house, '/');
    const char *near = text_in_arena(&job->arena, "%.*s%s.json", slash ? (int)(slash - house + 1) : 0, house, name);
    return access(near, R_OK) == 0 ? near : profile_find(shipped_places()->profiles, name, &job->arena);
}

static bool write_files(FitJob *job, const json_t *answer) {
    const Options *options = job->options;
    char path[PLOT_WRITE_PATH];
    Arena arena = {0};
    Plot plot;
    PlotSheet sheet = output_sheet(
        options, job->is_beam ? source_line_beam(&job->beam, &arena)
                              : source_line_house(&house_experiment_house(&job->experiments[0])->plan, &arena));
    snprintf(path, sizeof path, "%s/fit.json", options->out);
    int error = answer_write(answer, path);
    fit_plots_residuals(&plot, &job->fit, &arena);
    if (!error)
        error = plot_write_files(&plot, "residuals", options->out, &sheet, path);
    arena_clear(&arena);
    if (error) {
        output_failed(path, error);
        return false;
    }
    char *command = report_files_command(options);
    const Making making = report_files_making(options, command);
    Document document = fit_report_make(&job->fit, &job->experiments[0], options->files[0], &making);
    bool told = report_files_write(&document, "fit", options);
    document_clear(&document);
    memory_free(command);
    if (!told)
        return false;
    if (job->is_beam)
        return write_copy(job, options->files[0], *job->beam.name ? job->beam.name : "beam", false);
    const House *house = house_experiment_house(&job->experiments[0]);
    bool good = true;
    for (size_t p = 0; p < house->profile_count; p++)
        good &= write_copy(job, profile_file(job, house->profiles[p].name), house->profiles[p].name, true);
    return good;
}

static void show_progress(void *context, size_t runs) {
    (void)context;
    terminal_progress("%zu simulations ", runs);
}

static void close_job(FitJob *job) {
    if (!job->is_beam)
        fit_house_close(job);
    else if (job->experiment_count)
        beam_experiment_close(&job->experiments[MOTION]);
    beam_free(&job->beam);
    memory_free(job->experiments);
    memory_free(job->fit.rows);
    measured_free(&job->measured);
    arena_clear(&job->arena);
}

static bool learned(const Fit *fit) {
    bool any = false;
    for (size_t i = 0; i < fit->unknown_count; i++)
        any |= fit->unknowns[i].told;
    return any && !fit->interrupted && (!fit->leave_out || fit->error <= fit->error_before);
}

int command_fit(const Options *options) {
    FitJob job = {.options = options, .is_beam = beam_is_file(options->files[0])};
    Fault fault = {0};
    if (crank_is_file(options->files[0])) {
        fprintf(stderr, "clearance: fit is for houses and beams, %s is a crank\n", options->files[0]);
        return EXIT_WRONG_INPUT;
    }
    bool shown = progress_is_shown(options);
    job.fit = (Fit){.leave_out = options->leave_out,
                    .jobs = options->jobs,
                    .stop = &progress_stop,
                    .progress = shown ? show_progress : NULL};
    bool good = (job.is_beam ? open_beam(&job, &fault) : fit_house_open(&job, &fault)) && choose(&job, &fault) &&
                output_directory(options->out) && fit_run(&job.fit, &fault);
    if (shown)
        terminal_clear_progress();
    if (!good) {
        close_job(&job);
        return house_file_report(&fault);
    }
    json_t *answer = answer_of(&job);
    int code = learned(&job.fit) ? EXIT_ANSWERED : EXIT_ANSWER_NO;
    if (options->json)
        answer_print(json_incref(answer));
    else
        print_answer(&job);
    if (options->out && !job.fit.interrupted && !write_files(&job, answer))
        code = EXIT_WRONG_INPUT;
    json_decref(answer);
    close_job(&job);
    return code;
}
