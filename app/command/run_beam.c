#include "command/run_beam.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "beam/beam_cycle.h"
#include "command/answer.h"
#include "command/beam_frames.h"
#include "command/house_file.h"
#include "command/output.h"
#include "command/progress.h"
#include "command/types_answer.h"
#include "experiment/beam_follow.h"
#include "experiment/beam_experiment.h"
#include "experiment/beam_family.h"
#include "mechanics/trace.h"
#include "plot/plot_write.h"
#include "result/beam.h"
#include "result/verdict.h"
#include "result/json.h"
#include "result/text.h"
#include "study/study.h"
#include "visual/beam/follow_plots.h"
#include "visual/study/study_axes.h"

/* Type ------------------------------------------------------------------------------------------------------------- */

/* The type and the runs that it rests on; type_close releases it. */
typedef struct TypeAnswer {
    Types types;
    Experiment quick, thorough;
    int cycles; /* length of a run */
} TypeAnswer;

static void type_close(TypeAnswer *answer) {
    beam_experiment_close(&answer->quick);
    beam_experiment_close(&answer->thorough);
}

static bool type_tell(TypeAnswer *answer, const Beam *beam, const Options *options, Fault *fault) {
    const char *place = options->files[0];
    answer->cycles = beam->transient_cycles + beam->cycles;
    if (!beam_experiment_of(&answer->quick, beam, place, fault))
        return false;
    if (!beam_experiment_of(&answer->thorough, beam, place, fault)) {
        beam_experiment_close(&answer->quick);
        return false;
    }
    beam_experiment_be_thorough(&answer->thorough, BEAM_EXPERIMENT_LANES, BEAM_EXPERIMENT_CYCLES);
    if (types_answer_classify(&answer->types, &answer->quick, &answer->thorough, beam_experiment_window,
                              BEAM_EXPERIMENT_WINDOW, options, fault))
        return true;
    type_close(answer);
    return false;
}

/* Words ------------------------------------------------------------------------------------------------------------ */

static void print_peaks(const Response *response, const Beam *beam, const Rig *rig) {
    const SectionPeaks *peaks = &response->peaks;
    if (!peaks->count)
        printf("at %g Hz the tip moves +-%.3f mm and does not touch the joint, whose clearance is +-%.3f mm",
               beam->frequency, 1000 * rig_free_amplitude(rig), 1000 * beam->clearance);
    else if (peaks->max - peaks->min < 0.005)
        printf("at %g Hz the tip hits the joint with %.2f N on either side", beam->frequency, peaks->max);
    else
        printf("at %g Hz the tip hits the joint with %.0f to %.0f N, %.0f N in the mean (one draw of %zu peaks in %zu "
               "cycles)",
               beam->frequency, peaks->min, peaks->max, peaks->mean, peaks->count, response->section.count);
    printf("\n");
}

static void print_orbit(const Response *response) {
    static const char *const leavings[] = {[ORBIT_FOLD] = "positive: beyond 1 the orbit folds or loses its symmetry",
                                           [ORBIT_FLIP] = "negative: beyond -1 its period doubles",
                                           [ORBIT_NEIMARK] = "one of a pair: beyond 1 the orbit becomes a torus"};
    printf("The orbit's largest multiplier is %s\n", leavings[response->orbit.leaving]);
    if (!response->settled)
        printf("The recorded cycles still hold the transient: use more run.transient_cycles to leave it out\n");
}

static void print_verdict(const Response *response, const Beam *beam, const Rig *rig) {
    Text text = {0};
    result_verdict_name(&text, response, "cycle");
    printf("%s: ", text.text);
    print_peaks(response, beam, rig);
    memory_free(text.text);
    text = (Text){0};
    if (response->verdict == RESPONSE_PERIODIC)
        print_orbit(response);
    result_verdict_say(&text, response, "cycle");
    if (text.text)
        printf("%s", text.text);
    memory_free(text.text);
}

/* The numbers of a response as rows. */
typedef struct Facts {
    ResultTable motion, forces;
} Facts;

static void print_answer(const Response *response, const Facts *facts, const TypeAnswer *type, const Beam *beam,
                         const Rig *rig) {
    Text text = {0};
    print_verdict(response, beam, rig);
    printf("\n");
    types_answer_print(&type->types, &type->quick, type->cycles);
    if (type->types.kind != TYPES_KIND_INTERRUPTED)
        printf("A motion that none of %d starts has reached has a basin of less than %.0f %% of them (95 %%); to see "
               "one of "
               "1 %% takes %.0f starts\n",
               TYPES_STARTS, 100 * half_life_unseen(TYPES_STARTS), half_life_starts(0.01));
    result_text_list(&text, (const ResultTable *const[]){&facts->motion, &facts->forces}, 2);
    printf("\n%s", text.text);
    memory_free(text.text);
    if (response->grazes)
        printf(
            "\nThe tip came nearer to the joint than %.0e of the clearance without touching, or only as deep into it\n",
            MOTION_GRAZE);
    if (rig->modes.residual * rig->stiffness > MODES_RESIDUAL_MOST)
        printf("\nThe modes that are left out have too much compliance: use more beam.modes\n");
    printf("\ndigest %016" PRIx64 "\n", response->digest);
}

/* JSON ------------------------------------------------------------------------------------------------------------- */

static json_t *make_answer(const Response *response, const Facts *facts, const TypeAnswer *type, const Beam *beam) {
    char digest[17];
    snprintf(digest, sizeof digest, "%016" PRIx64, response->digest);
    json_t *answer = json_pack("{s:s, s:s, s:s}", "kind", "beam", "beam", beam->name, "note", beam->note);
    result_json_add(answer, &facts->motion, 0);
    json_object_set_new(answer, "type", json_string(types_kind_name(type->types.kind)));
    json_object_set_new(answer, "types", types_answer_json(&type->types, &type->quick, type->cycles));
    json_object_set_new(answer, "unseen_below", json_real(half_life_unseen(TYPES_STARTS)));
    result_json_add(answer, &facts->forces, 0);
    json_object_set_new(answer, "digest", json_string(digest));
    return answer;
}

static bool write_data(const Response *response, json_t *answer, const char *out) {
    char path[OUTPUT_PATH];
    snprintf(path, sizeof path, "%s/summary.json", out);
    int error = answer_write(answer, path);
    if (!error) {
        snprintf(path, sizeof path, "%s/trace.csv", out);
        error = trace_write_csv(&response->trace, path);
    }
    if (error)
        output_failed(path, error);
    return !error;
}

/* Refuses options that are for houses only. */
static bool check_options(const Options *options) {
    const char *foreign = options->route                      ? "--route"
                          : options->driving >= 0             ? "--driving"
                          : options->report                   ? "--report"
                          : options->observed                 ? "--observed"
                          : options_given(options, "--until") ? "--until"
                                                              : NULL;
    if (foreign)
        fprintf(stderr, "clearance: %s is for houses, %s is a beam\n", foreign, options->files[0]);
    return !foreign;
}

int run_beam_file(const Options *options) {
    Beam beam = {0};
    Rig rig;
    Fault fault = {0};
    BeamFrames files;
    if (!check_options(options) || beam_frames_check(options) || (options->out && !output_directory(options->out)) ||
        !beam_frames_plots_begin(&files, options))
        return EXIT_WRONG_INPUT;
    if (!beam_read(&beam, options->files[0], options->settings, options->setting_count, &fault) ||
        !rig_build(&rig, &beam, options->files[0], &fault)) {
        beam_free(&beam);
        beam_frames_plots_end(&files);
        return house_file_report(&fault);
    }
    Response response;
    TypeAnswer type;
    beam_cycle_respond(&response, &rig, &beam, NULL, &progress_stop);
    SurvivalTask watch = survival_task(&beam_cycle, options->lanes, options->jobs, &progress_stop);
    response_confirm(&response, beam_cycle_of(&rig), &watch);
    if (!type_tell(&type, &beam, options, &fault)) {
        beam_frames_plots_end(&files);
        response_clear(&response);
        rig_clear(&rig);
        beam_free(&beam);
        return house_file_report(&fault);
    }
    bool interrupted = response.verdict == RESPONSE_INTERRUPTED || type.types.stopped || stop_requested(&progress_stop);
    if (interrupted)
        fprintf(stderr, "clearance: interrupted after %zu recorded cycles; the results up to there are kept\n",
                response.section.count);
    Facts facts = {result_beam_motion(&beam, &response), result_beam_forces(&rig, &response)};
    json_t *answer = make_answer(&response, &facts, &type, &beam);
    answer_mark_interrupted(answer, interrupted);
    bool written = (!options->out || (write_data(&response, answer, options->out) &&
                                      beam_frames_plots_write(&files, &response, &beam, options))) &&
                   beam_frames_write(&beam, &rig, &response, options);
    interrupted = output_tell_interrupted(interrupted);
    answer_mark_interrupted(answer, interrupted);
    beam_frames_plots_end(&files);
    if (options->json)
        answer_print(json_incref(answer));
    else
        print_answer(&response, &facts, &type, &beam, &rig);
    if (options->out && written && !options->json)
        printf("\nplots and data are in %s\n", options->out);
    bool resolved = response_is_told(response.verdict);
    json_decref(answer);
    result_clear(&facts.motion);
    result_clear(&facts.forces);
    type_close(&type);
    response_clear(&response);
    rig_clear(&rig);
    beam_free(&beam);
    return !written ? EXIT_WRONG_INPUT : resolved && !interrupted ? EXIT_ANSWERED : EXIT_ANSWER_NO;
}

/* Following an orbit ------------------------------------------------------------------------------------------------
 */

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
    printf(begun ? "\nThe orbit of period %zu that begins there, followed in %s from %g to %g %s: %zu points; it "
                   "ends at %s\n\n"
                 : "The orbit of period %zu, followed in %s from %g to %g %s: %zu points; above it ends at %s",
           branch->period, follower->name, follower->from, follower->to, unit_of(follower), branch->count,
           end_words(branch->above));
    if (!begun)
        printf(", below at %s\n\n", end_words(branch->below));
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
    int error =
        plot_write_files(&plot.plot, "follow", options->out, options->width, options->height, options->theme, path);
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
    FollowPlot plot = follow_plots_make_curves(follower->follow.curves, follower->follow.curve_count, x.axis, x.factor,
                                               y.axis, y.factor);
    int error =
        plot_write_files(&plot.plot, "curves", options->out, options->width, options->height, options->theme, path);
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

int run_beam_follow(const Options *options) {
    Follower follower = {.options = options};
    Fault fault = {0};
    const char *file = options->files[0];
    if (!read_range(&follower, &fault))
        return house_file_report(&fault);
    if (!beam_is_file(file)) {
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
