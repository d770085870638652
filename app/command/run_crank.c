#include "command/run_crank.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>

#include "base/text.h"
#include "command/answer.h"
#include "command/house_file.h"
#include "command/output.h"
#include "command/progress.h"
#include "command/report_files.h"
#include "command/studio.h"
#include "paint/paint_cairo.h"
#include "plot/plot_write.h"
#include "report/crank_report.h"
#include "result/crank.h"
#include "result/json.h"
#include "result/source_line.h"
#include "result/verdict.h"
#include "result/text.h"
#include "visual/crank/crank_film.h"
#include "visual/crank/crank_plots.h"
#include "visual/crank/crank_scene.h"

#define FILM_TAIL 0.25 /* revolutions before the present that are drawn thick */

/* A run of a crank. */
typedef struct CrankRun {
    Crank crank;
    Tree tree;
    Response response;
    double ideal; /* N, largest force of a joint without clearance; NAN: not known */
    ResultTable motion, forces;
    PlotChoice plots;
} CrankRun;

/* Words ------------------------------------------------------------------------------------------------------------ */

static void print_answer(const CrankRun *run, const Options *options) {
    Text text = {0};
    result_crank_name(&text, &run->crank, &run->response, run->ideal);
    result_verdict_say(&text, &run->response, "revolution");
    result_crank_say(&text, &run->crank, &run->tree, &run->response);
    printf("%sIts numbers are %s. For its type I, II or III: clearance study %s --types "
           "drive.frequency,joint.clearance,coupler.length,slider.mass\n",
           text.text, crank_is_assumed(&run->crank) ? "all assumed" : "not all measured", options->files[0]);
    memory_free(text.text);
    text = (Text){0};
    result_text_list(&text, (const ResultTable *const[]){&run->motion, &run->forces}, 2);
    printf("\n%s", text.text);
    memory_free(text.text);
    printf("\ndigest %016" PRIx64 "\n", run->response.digest);
}

/* JSON ------------------------------------------------------------------------------------------------------------- */

static json_t *provenance_json(const Crank *crank) {
    json_t *object = json_object();
    for (size_t i = 0; i < crank_table()->count; i++)
        json_object_set_new(object, crank_table()->rows[i].name, json_string(crank->provenance[i]));
    return object;
}

static json_t *make_answer(const CrankRun *run) {
    char digest[17];
    snprintf(digest, sizeof digest, "%016" PRIx64, run->response.digest);
    json_t *answer = json_pack("{s:s, s:s, s:s}", "kind", "crank", "crank", run->crank.name, "note", run->crank.note);
    result_json_add(answer, &run->motion, 0);
    result_json_add(answer, &run->forces, 0);
    json_object_set_new(answer, "provenance", provenance_json(&run->crank));
    json_object_set_new(answer, "digest", json_string(digest));
    return answer;
}

/* Files ------------------------------------------------------------------------------------------------------------ */

static bool write_plots(const CrankRun *run, const Options *options) {
    char path[PLOT_WRITE_PATH];
    int error = 0;
    Arena arena = {0};
    PlotSheet sheet = output_sheet(options, source_line_crank(&run->crank, &arena));
    CrankPlots plots = crank_plots_make(&run->response, &run->crank, &run->plots);
    for (size_t i = 0; i < plots.choice.count && !error; i++)
        error =
            plot_write_files(&plots.plots[i], crank_plots_name(plots.choice.indices[i]), options->out, &sheet, path);
    arena_clear(&arena);
    crank_plots_free(&plots);
    if (error)
        output_failed(path, error);
    return !error;
}

/* Writes the moment of the largest force. */
static bool write_still(const CrankRun *run, const Options *options) {
    char path[OUTPUT_PATH];
    int error = 0;
    if (run->response.trace.rows < CRANK_SAMPLES)
        return true;
    Scene scene = {0};
    crank_scene_make(&scene, &run->crank, &run->tree, &run->response);
    for (CairoFileKind kind = CAIRO_FILE_PNG; kind <= CAIRO_FILE_PDF && !error; kind++) {
        snprintf(path, sizeof path, "%s/crank.%s", options->out, cairo_file_endings[kind]);
        error = paint_cairo_file(kind, &scene, path, options->width, options->height, options->theme);
    }
    scene_clear(&scene);
    if (error)
        output_failed(path, error);
    return !error;
}

static bool write_report(const CrankRun *run, const Options *options) {
    char *command = report_files_command(options);
    const Making making = report_files_making(options, command);
    Document document = crank_report_make(
        &(CrankReport){&run->crank, &run->tree, &run->response, run->ideal, options->files[0]}, &making);
    bool written = report_files_write(&document, "report", options);
    document_clear(&document);
    memory_free(command);
    return written;
}

static bool write_files(const CrankRun *run, json_t *answer, const Options *options) {
    char path[OUTPUT_PATH];
    snprintf(path, sizeof path, "%s/summary.json", options->out);
    int error = answer_write(answer, path);
    if (!error) {
        snprintf(path, sizeof path, "%s/trace.csv", options->out);
        error = trace_write_csv(&run->response.trace, path);
    }
    if (error)
        output_failed(path, error);
    return !error && write_plots(run, options) && write_still(run, options) &&
           (!options->report || write_report(run, options));
}

/* Films -------------------------------------------------------------------------------------------------------------*/

static bool show_film(void *film, double time) {
    return crank_film_show(film, time);
}

static size_t film_until(const void *owner, size_t plot, size_t series, double time) {
    return crank_film_until(owner, plot, series, time);
}

/* Returns some revolutions from --from on, or the time up to --to. */
static StudioTimes film_times(const CrankRun *run, const Options *options) {
    const Trace *trace = &run->response.trace;
    double fps = options->frames > 0 ? options->frames : STUDIO_FPS,
           end = trace_row(trace, trace->rows - 1)[CRANK_TIME];
    double first = fmin(fmax(options->from, 0), end), slow = options->slow > 0 ? options->slow : CRANK_FILM_SLOW;
    double last = options->to >= 0 ? options->to : first + CRANK_FILM_TURNS / run->crank.frequency;
    return studio_times(first, fmin(last, end), fps * slow, fps);
}

static bool write_film(const CrankRun *run, const Options *options) {
    if (options->frames <= 0 && !options->movie)
        return true;
    if (run->response.trace.rows < CRANK_SAMPLES) {
        fprintf(stderr, "clearance: not one whole revolution was recorded: there is nothing to draw\n");
        return true;
    }
    StudioTimes times = film_times(run, options);
    if (!studio_can_take(&times))
        return false;
    CrankFilm *film = crank_film_create(&run->crank, &run->tree, &run->response, times.first, times.last);
    StudioFilm filmed = {.film = film,
                         .show = show_film,
                         .still = crank_film_still(film),
                         .added = crank_film_added(film),
                         .moving = crank_film_moving(film),
                         .plots = {crank_film_plots(film), CRANK_FILM_PLOTS, FILM_TAIL / run->crank.frequency,
                                   ROLE_DANGER_MIDDLE, film, film_until}};
    Studio studio;
    bool good = studio_open(&studio, &filmed, options);
    if (good) {
        good = studio_write(&studio, &times);
        studio_close(&studio);
    }
    crank_film_destroy(film);
    return good;
}

/* Refuses options that are for others only. */
static bool check_options(CrankRun *run, const Options *options) {
    char message[PLOT_CHOICE_FAULT];
    const char *foreign = options->route                        ? "--route"
                          : options->driving >= 0               ? "--driving"
                          : options->observed                   ? "--observed"
                          : options_given(options, "--until")   ? "--until"
                          : options->measured                   ? "--measured"
                          : options->camera.kind == VIEW_RAISED ? "--view raised"
                          : options->show                       ? "--show"
                                                                : NULL;
    if (foreign) {
        fprintf(stderr, "clearance: %s is not for cranks, %s is a crank\n", foreign, options->files[0]);
        return false;
    }
    if (options->plot_words && !options->out) {
        fprintf(stderr, "clearance: --plots needs --out DIR, where the plots are written\n");
        return false;
    }
    if (!report_files_possible(options) || studio_check(options))
        return false;
    const char *words = options->plot_words ? options->plot_words : CRANK_PLOTS_USUAL;
    if (!crank_plots_choose(&run->plots, words, message)) {
        fprintf(stderr, "clearance: --plots %s: %s\n", words, message);
        return false;
    }
    return true;
}

int run_crank_file(const Options *options) {
    CrankRun run = {0};
    Fault fault = {0};
    if (!check_options(&run, options))
        return EXIT_WRONG_INPUT;
    if (!crank_read(&run.crank, options->files[0], options->settings, options->setting_count, &fault) ||
        !output_directory(options->out)) {
        crank_free(&run.crank);
        return house_file_report(&fault);
    }
    run.tree = tree_of(&run.crank);
    run.ideal = crank_cycle_ideal_force(&run.crank, &progress_stop);
    response_run(&run.response, crank_cycle_of(&run.tree), run.crank.transient_cycles, run.crank.cycles, NULL,
                 &progress_stop);
    SurvivalTask watch = survival_task(&crank_cycle, options->lanes, options->jobs, &progress_stop);
    response_confirm(&run.response, crank_cycle_of(&run.tree), &watch);
    bool interrupted = run.response.verdict == RESPONSE_INTERRUPTED || stop_requested(&progress_stop);
    if (interrupted)
        fprintf(stderr, "clearance: interrupted after %zu recorded revolutions; the results up to there are kept\n",
                run.response.section.count);
    run.motion = result_crank_motion(&run.crank, &run.response);
    run.forces = result_crank_forces(&run.tree, &run.response, run.ideal);
    json_t *answer = make_answer(&run);
    answer_mark_interrupted(answer, interrupted);
    bool written = (!options->out || write_files(&run, answer, options)) && write_film(&run, options);
    interrupted = output_tell_interrupted(interrupted);
    answer_mark_interrupted(answer, interrupted);
    if (options->json)
        answer_print(json_incref(answer));
    else
        print_answer(&run, options);
    if (options->out && written && !options->json)
        printf("\nplots and data are in %s\n", options->out);
    bool resolved = response_is_told(run.response.verdict);
    json_decref(answer);
    result_clear(&run.motion);
    result_clear(&run.forces);
    response_clear(&run.response);
    crank_free(&run.crank);
    return !written ? EXIT_WRONG_INPUT : resolved && !interrupted ? EXIT_ANSWERED : EXIT_ANSWER_NO;
}
