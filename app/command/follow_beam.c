#include "command/follow_beam.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "beam/beam_cycle.h"
#include "command/answer.h"
#include "command/house_file.h"
#include "command/output.h"
#include "command/progress.h"
#include "experiment/beam_experiment.h"
#include "experiment/beam_family.h"
#include "experiment/beam_follow.h"
#include "mechanics/trace.h"
#include "plot/plot_write.h"
#include "result/source_line.h"
#include "study/study.h"
#include "visual/beam/follow_plots.h"
#include "visual/study/study_axes.h"

enum { DOTS = 241 /* values of the runs from rest below the curve */ };

typedef struct Follower {
    const Options *options;
    Beam beam;
    BeamFamily family;
    char name[100];
    double from, to;
    BeamFollow follow;
} Follower;

/* Reads NAME=FROM:TO. */
static bool read_range(Follower *follower, Fault *fault) {
    const char *words = follower->options->follow, *range = strchr(words, '=');
    char *end = NULL;
    size_t length = range ? (size_t)(range - words) : 0;
    if (range && length < sizeof follower->name) {
        memcpy(follower->name, words, length);
        follower->from = strtod(range + 1, &end);
        follower->to = *end == ':' ? strtod(end + 1, &end) : (double)NAN;
    }
    bool good = end && !*end && *follower->name && isfinite(follower->from) && follower->to > follower->from &&
                isfinite(follower->to);
    if (!good)
        fault_add(fault,
                  "clearance: --follow takes NAME=FROM:TO with FROM < TO, where NAME is a number of the beam such as "
                  "drive.frequency or joint.clearance, not \"%s\"",
                  words);
    return good;
}

static const char *unit_of(const Follower *follower) {
    return follower->family.row->unit;
}

/* Words and files ---------------------------------------------------------------------------------------------------
 */

static const char *end_words(FollowEnd end) {
    static const char *const words[] = {[FOLLOW_RANGE] = "the end of the range",
                                        [FOLLOW_LOST] = "where no step leads on",
                                        [FOLLOW_LONG] = "where it grew too long",
                                        [FOLLOW_IMAGE] = "the pitchfork at which it meets its mirror image",
                                        [FOLLOW_STOPPED] = "where it was interrupted"};
    return words[end];
}

static bool is_shown(const FollowBranch *branch, size_t i) {
    return branch->points[i].kind != FOLLOW_STEP || i == 0 || i == branch->start || i + 1 == branch->count;
}

static const char *row_name(const FollowBranch *branch, size_t i) {
    FollowKind kind = branch->points[i].kind;
    return kind != FOLLOW_STEP ? follow_kind_name(kind) : i == branch->start ? "start" : "end";
}

static void print_branch(const Follower *follower, const FollowBranch *branch) {
    bool begun = branch != follower->follow.branches;
    bool both = !begun || branch->start > 0;
    printf("%sThe orbit of period %zu%s, followed in %s from %g to %g %s: %zu points; %s ends at %s", begun ? "\n" : "",
           branch->period,
           !begun ? ""
           : both ? " that is its own mirror image"
                  : " that begins there",
           follower->name, follower->from, follower->to, unit_of(follower), branch->count, both ? "above it" : "it",
           end_words(branch->above));
    if (both)
        printf(", below at %s", end_words(branch->below));
    printf("\n\n");
    printf("%-16s %14s %12s %24s  %s\n", "point", unit_of(follower), "peak, N", "multiplier", "beside it");
    for (size_t i = 0; i < branch->count; i++) {
        const FollowPoint *point = &branch->points[i];
        if (!is_shown(branch, i))
            continue;
        char multiplier[60];
        if (point->im != 0)
            snprintf(multiplier, sizeof multiplier, "%.6f +- %.6f i", point->re, fabs(point->im));
        else
            snprintf(multiplier, sizeof multiplier, "%.6f", point->re);
        printf("%-16s %14.8g %12.2f %24s  %s\n", row_name(branch, i), point->value, point->peak, multiplier,
               point->kind != FOLLOW_STEP ? ""
               : point->stable            ? "stable"
                                          : "unstable");
    }
}

static json_t *make_branch(const FollowBranch *branch) {
    json_t *points = json_array();
    for (size_t i = 0; i < branch->count; i++) {
        const FollowPoint *point = &branch->points[i];
        if (is_shown(branch, i))
            json_array_append_new(points, json_pack("{s:s, s:f, s:f, s:f, s:f, s:b}", "point", row_name(branch, i),
                                                    "value", point->value, "peak", point->peak, "multiplier_re",
                                                    point->re, "multiplier_im", point->im, "stable", point->stable));
    }
    return json_pack("{s:i, s:i, s:s, s:s, s:o}", "period", (int)branch->period, "steps", (int)branch->count, "below",
                     end_words(branch->below), "above", end_words(branch->above), "points", points);
}

static void print_curves(const Follower *follower) {
    const char *second = follower->options->study.axes[0].name;
    for (size_t i = 0; i < follower->follow.curve_count; i++) {
        const FollowCurve *curve = &follower->follow.curves[i];
        size_t first = 0, last = curve->count - 1;
        while (first < last && isnan(curve->other[first]))
            first++;
        while (last > first && isnan(curve->other[last]))
            last--;
        printf("%sCurve %zu, %s of period %zu: from %s = %.6g at %s = %.6g to %.6g at %.6g, %zu points\n",
               i ? "" : "\n", i + 1,
               curve->kind == FOLLOW_TOUCH ? "end of the motion without contact" : follow_kind_name(curve->kind),
               curve->period, follower->name, curve->value[first], second, curve->other[first], curve->value[last],
               curve->other[last], curve->count);
    }
    if (follower->follow.left_out)
        printf("%zu more points were located, whose curves are not followed; a shorter range of --follow has fewer\n",
               follower->follow.left_out);
}

static json_t *make_curves(const BeamFollow *follow) {
    json_t *curves = json_array();
    for (size_t i = 0; i < follow->curve_count; i++) {
        const FollowCurve *curve = &follow->curves[i];
        json_t *points = json_array();
        for (size_t k = 0; k < curve->count; k++)
            if (!isnan(curve->other[k]))
                json_array_append_new(points, json_pack("[f,f]", curve->value[k], curve->other[k]));
        json_array_append_new(curves, json_pack("{s:s, s:i, s:o}", "point", follow_kind_name(curve->kind), "period",
                                                (int)curve->period, "points", points));
    }
    return curves;
}

static json_t *make_follow(const Follower *follower) {
    json_t *answer = json_pack("{s:s, s:s, s:s, s:f, s:f}", "kind", "follow", "beam", follower->beam.name, "parameter",
                               follower->name, "from", follower->from, "to", follower->to);
    json_t *first = make_branch(follower->follow.branches), *begun = json_array();
    json_object_update(answer, first);
    json_decref(first);
    for (size_t b = 1; b < follower->follow.count; b++)
        json_array_append_new(begun, make_branch(&follower->follow.branches[b]));
    json_object_set_new(answer, "begun", begun);
    if (follower->options->study.axis_count) {
        json_object_set_new(answer, "over", json_string(follower->options->study.axes[0].name));
        json_object_set_new(answer, "curves", make_curves(&follower->follow));
        json_object_set_new(answer, "left_out", json_integer((json_int_t)follower->follow.left_out));
    }
    return answer;
}

static int write_table(const Follower *follower, const char *path) {
    const TraceColumn columns[] = {{"period", "1"},        {follower->name, unit_of(follower)},
                                   {"peak", "N"},          {"stable", "1"},
                                   {"multiplier_re", "1"}, {"multiplier_im", "1"},
                                   {"kind", "1"}};
    Trace trace;
    trace_init(&trace, columns, sizeof columns / sizeof *columns);
    for (size_t b = 0; b < follower->follow.count; b++)
        for (size_t i = 0; i < follower->follow.branches[b].count; i++) {
            const FollowPoint *point = &follower->follow.branches[b].points[i];
            trace_add(&trace, (double[]){(double)follower->follow.branches[b].period, point->value, point->peak,
                                         point->stable, point->re, point->im, point->kind});
        }
    int error = trace_write_csv(&trace, path);
    trace_clear(&trace);
    return error;
}

/* Runs the beam from rest at values of the range. */
static void run_dots(const Follower *follower, Study *study, Experiment *experiment) {
    *study = (Study){.experiment = experiment,
                     .axes = {{follower->name, follower->from, follower->to, DOTS}},
                     .axis_count = 1,
                     .pass_count = 1,
                     .runs = 1};
    study_begin(study);
    study_run(study, &(StudyOptions){.jobs = follower->options->jobs, .stop = &progress_stop});
}

static int write_plot(const Follower *follower, char path[PLOT_WRITE_PATH]) {
    const Options *options = follower->options;
    Experiment experiment;
    Study study;
    Fault fault = {0};
    Arena arena = {0};
    if (!beam_experiment_of(&experiment, &follower->beam, options->files[0], &fault)) {
        fault_clear(&fault);
        return 0;
    }
    PlotSheet sheet = output_sheet(options, source_line_beam(&follower->beam, &arena));
    run_dots(follower, &study, &experiment);
    size_t count = 0;
    bool whole = !stop_requested(&progress_stop);
    for (size_t t = 0; t < study.trial_count; t++)
        count += study.trials[t].series_count;
    double *value = arena_allocate(&arena, (count + 1) * sizeof *value),
           *peak = arena_allocate(&arena, (count + 1) * sizeof *peak);
    FollowDots dots = {value, peak, 0};
    for (size_t t = 0; t < study.trial_count && whole; t++)
        for (size_t s = 0; s < study.trials[t].series_count; s++) {
            value[dots.count] = study.trials[t].at[0];
            peak[dots.count++] = study.trials[t].series[s];
        }
    StudyScale scale = study_axes_parameter(&study, 0, &arena);
    scale.axis.low = scale.factor * follower->from;
    scale.axis.high = scale.factor * follower->to;
    FollowPlot plot =
        follow_plots_make(follower->follow.branches, follower->follow.count, scale.axis, scale.factor, &dots);
    int error = plot_write_files(&plot.plot, "follow", options->out, &sheet, path);
    follow_plots_free(&plot);
    study_clear(&study);
    beam_experiment_close(&experiment);
    arena_clear(&arena);
    return error;
}

/* Writes the curves over both numbers as a plot, whose table is their file. */
static int write_curves(const Follower *follower, char path[PLOT_WRITE_PATH]) {
    const Options *options = follower->options;
    const StudyAxis *second = &options->study.axes[0];
    Experiment experiment;
    Fault fault = {0};
    Arena arena = {0};
    if (!follower->follow.curve_count || !beam_experiment_of(&experiment, &follower->beam, options->files[0], &fault)) {
        fault_clear(&fault);
        return 0;
    }
    const Study study = {.experiment = &experiment,
                         .axes = {{follower->name, follower->from, follower->to, 2}, *second},
                         .axis_count = 2};
    StudyScale x = study_axes_parameter(&study, 0, &arena), y = study_axes_parameter(&study, 1, &arena);
    x.axis.low = x.factor * follower->from;
    x.axis.high = x.factor * follower->to;
    y.axis.low = y.factor * second->from;
    y.axis.high = y.factor * second->to;
    PlotSheet sheet = output_sheet(options, source_line_beam(&follower->beam, &arena));
    FollowPlot plot = follow_plots_make_curves(follower->follow.curves, follower->follow.curve_count, x.axis, x.factor,
                                               y.axis, y.factor);
    int error = plot_write_files(&plot.plot, "curves", options->out, &sheet, path);
    follow_plots_free(&plot);
    beam_experiment_close(&experiment);
    arena_clear(&arena);
    return error;
}

/* Writes the plots first, whose dots may be interrupted, which the answer says. */
static bool write_files(const Follower *follower, json_t *answer) {
    char path[PLOT_WRITE_PATH];
    int error = write_plot(follower, path);
    if (!error)
        error = write_curves(follower, path);
    if (!error) {
        snprintf(path, sizeof path, "%s/follow.csv", follower->options->out);
        error = write_table(follower, path);
    }
    if (!error) {
        answer_mark_interrupted(answer, stop_requested(&progress_stop));
        snprintf(path, sizeof path, "%s/summary.json", follower->options->out);
        error = answer_write(answer, path);
    }
    if (error)
        output_failed(path, error);
    return !error;
}

/* Following ---------------------------------------------------------------------------------------------------------
 */

static int tell_branches(const Follower *follower) {
    json_t *answer = make_follow(follower);
    bool written = !follower->options->out || write_files(follower, answer);
    bool interrupted = stop_requested(&progress_stop);
    if (interrupted)
        fprintf(stderr, "clearance: interrupted; the answer ends where it had come to\n");
    answer_mark_interrupted(answer, interrupted);
    if (follower->options->json)
        answer_print(json_incref(answer));
    for (size_t b = 0; b < follower->follow.count && !follower->options->json; b++)
        print_branch(follower, &follower->follow.branches[b]);
    if (!follower->options->json)
        print_curves(follower);
    json_decref(answer);
    return !written ? EXIT_WRONG_INPUT : interrupted ? EXIT_ANSWER_NO : EXIT_ANSWERED;
}

/* Says that the search was interrupted before there was an orbit to follow. */
static void tell_nothing(const Options *options) {
    fprintf(stderr, "clearance: interrupted; nothing is written\n");
    if (options->json)
        answer_print(json_pack("{s:s, s:b}", "kind", "follow", "interrupted", 1));
}

/* Finds the orbit of the file as `run` does, and follows it. */
static int follow_orbit(Follower *follower) {
    Response response;
    double value = beam_family_value(&follower->family);
    if (value < follower->from || value > follower->to) {
        fprintf(stderr, "clearance: %s is %g in the file, outside the range of --follow; set it with --set\n",
                follower->name, value);
        return EXIT_WRONG_INPUT;
    }
    if (!output_directory(follower->options->out))
        return EXIT_WRONG_INPUT;
    beam_cycle_respond(&response, &follower->family.rig, &follower->beam, NULL, &progress_stop);
    int code = EXIT_ANSWER_NO;
    bool told = response.verdict != RESPONSE_INTERRUPTED;
    if (told && !response.orbit.period)
        fprintf(stderr, "clearance: the motion is %s, with no stable orbit to follow; set %s to where there is one\n",
                response_name(&response), follower->name);
    else if (!told || !beam_follow_run(&follower->follow, &follower->family, response.orbit.point,
                                       response.orbit.period, &progress_stop))
        if (stop_requested(&progress_stop))
            tell_nothing(follower->options);
        else
            fprintf(stderr, "clearance: the orbit cannot be followed\n");
    else {
        const StudyAxis *axis = &follower->options->study.axes[0];
        if (follower->options->study.axis_count)
            beam_follow_curves(&follower->follow, &follower->family,
                               &(BeamPlane){axis->name, axis->from, axis->to, axis->steps}, follower->options->jobs,
                               &progress_stop);
        code = tell_branches(follower);
    }
    beam_follow_clear(&follower->follow);
    response_clear(&response);
    return code;
}

int follow_beam_file(const Options *options) {
    Follower follower = {.options = options};
    Fault fault = {0};
    const char *file = options->files[0];
    if (!read_range(&follower, &fault))
        return house_file_report(&fault);
    if (!beam_is_file(file) && !text_read_interrupted()) {
        fault_add(&fault, "clearance: --follow is for beams, %s is none", file);
        return house_file_report(&fault);
    }
    if (!beam_read(&follower.beam, file, options->settings, options->setting_count, &fault))
        return house_file_report(&fault);
    const StudyAxis *axis = &options->study.axes[0];
    const BeamPlane plane = {axis->name, axis->from, axis->to, axis->steps};
    int code = EXIT_WRONG_INPUT;
    if (beam_family_open(&follower.family, &follower.beam, follower.name, follower.from, follower.to, "--follow",
                         &fault)) {
        bool good = !options->study.axis_count || beam_follow_check(&follower.family, &plane, "clearance", &fault);
        code = good ? follow_orbit(&follower) : house_file_report(&fault);
        beam_family_close(&follower.family);
    } else {
        code = house_file_report(&fault);
    }
    beam_free(&follower.beam);
    return code;
}
