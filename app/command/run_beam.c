#include "command/run_beam.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>

#include "beam/beam_cycle.h"
#include "command/answer.h"
#include "command/beam_frames.h"
#include "command/house_file.h"
#include "command/output.h"
#include "command/progress.h"
#include "command/types_answer.h"
#include "experiment/beam_experiment.h"
#include "mechanics/trace.h"
#include "result/beam.h"
#include "result/verdict.h"
#include "result/json.h"
#include "result/text.h"

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
    if (!response->section.count)
        printf("at %g Hz with a clearance of +-%.3f mm", beam->frequency, 1000 * beam->clearance);
    else if (!peaks->count)
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
    if (!check_options(options) || beam_frames_check(options) || !beam_frames_plots_begin(&files, options))
        return EXIT_WRONG_INPUT;
    if (!beam_read(&beam, options->files[0], options->settings, options->setting_count, &fault) ||
        !rig_build(&rig, &beam, options->files[0], &fault)) {
        beam_free(&beam);
        beam_frames_plots_end(&files);
        return house_file_report(&fault);
    }
    if (!output_directory(options->out)) {
        rig_clear(&rig);
        beam_free(&beam);
        beam_frames_plots_end(&files);
        return EXIT_WRONG_INPUT;
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
