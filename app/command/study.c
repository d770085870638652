#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/stopwatch.h"
#include "base/digest.h"
#include "base/json.h"
#include "base/text.h"
#include "command/answer.h"
#include "command/command.h"
#include "command/follow_beam.h"
#include "command/house_file.h"
#include "command/output.h"
#include "command/paper.h"
#include "command/progress.h"
#include "command/report_files.h"
#include "command/shake_answer.h"
#include "command/study_answer.h"
#include "command/study_laboratory.h"
#include "command/study_shards.h"
#include "command/study_types.h"
#include "command/study_text.h"
#include "platform/terminal.h"
#include "report/study_report.h"
#include "study/study_csv.h"
#include "study/store.h"
#include "visual/study/study_plots.h"
#include "study/summary.h"

/* A study from the command line to its answer. */
typedef struct StudyJob {
    const Options *options;
    const StudyLaboratory *laboratory;
    Experiment experiment;
    uint64_t identity; /* the experiment's, as it is opened */
    StudyTypes types;  /* with --types: the experiment that classifies each run */
    Study study;
    uint64_t content;  /* digest of the file */
    Measured measured; /* points to draw over the plots */
    StoreFound found;
    char store[OUTPUT_NAME]; /* name of the file of results in --out */
    double begin;            /* s, by the clock */
    size_t done_before;
    bool shown;                    /* progress was printed */
    bool kept;                     /* study.sqlite is complete, or was not asked for */
    const ShakeFindings *findings; /* of a study of earthquakes, once they are made; or NULL */
} StudyJob;

/* The request ------------------------------------------------------------------------------------------------------ */

static uint64_t file_digest(const char *path) {
    size_t size = 0;
    char *text = text_read_file(path, JSON_LARGEST_FILE, &size);
    uint64_t digest = text ? digest_bytes(DIGEST_START, text, size) : 0;
    memory_free(text);
    return digest;
}

/* Returns a digest of everything that the results depend on besides the numbers of the study: the file, the settings,
 * and the program itself, since two builds of one version may differ. */
static uint64_t given_digest(const StudyJob *job) {
    uint64_t digest = digest_text(digest_chain(DIGEST_START, job->content), CLEARANCE_VERSION);
    digest = digest_chain(digest, file_digest("/proc/self/exe"));
    for (size_t i = 0; i < job->options->setting_count; i++)
        digest = digest_text(digest, job->options->settings[i]);
    return digest;
}

/* Fills the study. A single run is the nominal one (seed 0) unless a seed is given. */
static void make_study(StudyJob *job) {
    const StudyRequest *request = &job->options->study;
    size_t drivers = job->options->types ? 0 : study_laboratory_drivers(job->options, &job->experiment);
    Study *study = &job->study;
    *study = (Study){.experiment = &job->experiment,
                     .axis_count = request->axis_count,
                     .spread_count = request->spread_count,
                     .pass_count = request->pass_count ? request->pass_count : 1, /* reset */
                     .shard = request->shard,
                     .runs = request->shakes ? request->shakes
                             : drivers       ? drivers
                             : request->runs ? request->runs
                                             : 1};
    memcpy(study->axes, request->axes, sizeof study->axes);
    memcpy(study->spreads, request->spreads, sizeof study->spreads);
    memcpy(study->passes, request->passes, sizeof study->passes);
    bool chance = study->runs > 1 || request->shakes || options_given(job->options, "--seed");
    study->seed = chance ? job->options->seed : 0;
}

/* Reads the measured points, in the units of the study. */
static bool read_measured(StudyJob *job, Fault *fault) {
    const Options *options = job->options;
    if (!options->measured)
        return true;
    if (!options->out) {
        fault_add(fault, "clearance: --measured needs --out DIR, where the plots are written");
        return false;
    }
    Arena arena = {0};
    size_t count;
    const MeasuredKind *kinds = study_plots_kinds(&job->study, &count, &arena);
    bool good = measured_read(&job->measured, options->measured, kinds, count, fault);
    arena_clear(&arena);
    return good;
}

/* Opens the experiment of the file, or with --types the one that classifies each run. */
static bool open_experiment(StudyJob *job, Fault *fault) {
    const Options *options = job->options;
    job->content = file_digest(options->files[0]);
    if (!options->types) {
        job->laboratory = study_laboratory_open(&job->experiment, options, fault);
        job->identity = job->experiment.identity;
        return job->laboratory;
    }
    if (!study_types_open(&job->types, options, fault))
        return false;
    job->laboratory = job->types.laboratory;
    job->identity = job->types.quick.identity;
    bool good = study_types_of_runs(&job->types, &job->experiment, fault);
    if (!good)
        study_types_close(&job->types);
    return good;
}

static void close_experiment(StudyJob *job) {
    if (job->options->types)
        study_types_close(&job->types);
    else
        job->laboratory->close(&job->experiment);
}

static bool open_study(StudyJob *job, Fault *fault) {
    if (!open_experiment(job, fault))
        return false;
    bool listed = job->experiment.series;
    if (job->options->study.no_series)
        job->experiment.series = NULL;
    make_study(job);
    if (job->options->study.no_series && !listed)
        fault_add(fault,
                  "clearance: --no-series has no effect, since the runs of this file list nothing; leave it out");
    else if (!job->study.axis_count && job->study.runs < 2 && !job->options->study.shakes)
        fault_add(
            fault,
            "clearance: there is nothing to study; use --vary NAME=FROM:TO:STEPS, --runs N, --shake N or --drivers N");
    else if (study_check(&job->study, fault) && read_measured(job, fault))
        return true;
    close_experiment(job);
    return false;
}

/* Running ---------------------------------------------------------------------------------------------------------- */

/* Prints progress once the work has taken more than a second. */
static void show_progress(void *context, size_t done, size_t all) {
    StudyJob *job = context;
    double seconds = stopwatch_now() - job->begin;
    if (seconds < 1 || done <= job->done_before)
        return;
    double left = seconds * (double)(all - done) / (double)(done - job->done_before);
    terminal_progress("%zu of %zu runs, %.0f s left ", done, all, left);
    job->shown = true;
}

/* Prints how many runs the file of results holds already. */
static void tell_found(const StudyJob *job) {
    size_t done = job->found.done, all = study_room(&job->study);
    const Options *options = job->options;
    if (options->quiet)
        return;
    if (*options->study.shard_named)
        fprintf(stderr, "clearance: shard %zu of %zu, from %s\n", job->study.shard.number, job->study.shard.count,
                options->study.shard_named);
    if (done == all && all)
        fprintf(stderr, "clearance: all %zu runs are read back from %s/%s\n", all, options->out, job->store);
    else if (done)
        fprintf(stderr, "clearance: continues in %s/%s, where %zu of %zu runs are done\n", options->out, job->store,
                done, all);
    else if (job->found.others)
        fprintf(
            stderr,
            "clearance: %s/%s holds another study, since the file, settings, range or program have changed; this one "
            "starts from the beginning, and the old one is kept\n",
            options->out, job->store);
}

static size_t done_of(const StudyJob *job) {
    return study_done(&job->study);
}

/* True if all runs of the study, or of its shard, are done. */
static bool is_whole(const StudyJob *job) {
    return done_of(job) == study_room(&job->study);
}

static void run_study(StudyJob *job, Store *store) {
    const Options *options = job->options;
    bool show = progress_is_shown(options);
    job->begin = stopwatch_now();
    job->done_before = done_of(job);
    study_run(&job->study, &(StudyOptions){.jobs = options->jobs,
                                           .stop = &progress_stop,
                                           .progress = show ? show_progress : NULL,
                                           .context = job,
                                           .keep = store ? store_write : NULL,
                                           .keeper = store});
    if (job->shown)
        terminal_clear_progress();
    if (!is_whole(job))
        fprintf(stderr,
                store ? "clearance: interrupted after %zu of %zu runs; the same command continues from there\n"
                      : "clearance: interrupted after %zu of %zu runs\n",
                done_of(job), study_room(&job->study));
}

/* Creates the trials. Those of a large study lie in a file, in the directory that TMPDIR names, or beside the results.
 */
static bool begin_study(StudyJob *job, Fault *fault) {
    const char *folder = getenv("TMPDIR");
    if (study_room(&job->study) <= STUDY_IN_MEMORY) {
        study_begin(&job->study);
        return true;
    }
    if (!job->options->out) {
        fault_add(fault, "clearance: a study of more than %d runs needs --out DIR, where they are kept",
                  STUDY_IN_MEMORY);
        return false;
    }
    return study_begin_in(&job->study, folder && *folder ? folder : job->options->out, fault);
}

/* True if the files have not changed since the study began: each run of a house reads them. */
static bool is_unchanged(const StudyJob *job) {
    Experiment again;
    Fault fault = {0};
    bool same =
        file_digest(job->options->files[0]) == job->content && job->laboratory->open(&again, job->options, &fault);
    if (same) {
        same = again.identity == job->identity;
        job->laboratory->close(&again);
    }
    fault_clear(&fault);
    return same;
}

/* Opens the file of results. False: `fault` says why it is unusable. */
static bool open_store(StudyJob *job, Store **store, Fault *fault) {
    const Options *options = job->options;
    if (!options->out)
        return true;
    char path[OUTPUT_PATH];
    study_shards_name(options, job->store);
    snprintf(path, sizeof path, "%s/%s", options->out, job->store);
    *store = store_open(path, job->study.shard.count ? STORE_WITH_READERS : STORE_ALONE, &job->study,
                        study_digest(&job->study, given_digest(job)), &job->found, fault);
    if (*store)
        tell_found(job);
    return *store;
}

/* Runs the missing runs and stores them if there is --out, after taking those of the shards that are merged. Returns 0,
 * or if there is no answer, the exit code; `fault` says why. A file that could not be written completely adds an error,
 * but there is an answer. */
static int run_kept(StudyJob *job, Fault *fault) {
    const Options *options = job->options;
    Store *store = NULL;
    if (!open_store(job, &store, fault))
        return EXIT_WRONG_INPUT;
    int code = options->study.merge ? study_shards_merge(options, &job->study, store, fault) : 0;
    if (code) {
        store_abandon(store);
        return code;
    }
    if (!options->study.no_run)
        run_study(job, store);
    if (job->study.full)
        store_add_full(&job->study, fault);
    bool same = is_unchanged(job);
    if (!same)
        fault_add(fault, "%s or a profile changed during the study; the runs mix both versions and are not kept",
                  options->files[0]);
    if (store && !same)
        store_forget(store);
    job->kept = !store || store_close(store, fault);
    return same && !job->study.full ? 0 : EXIT_WRONG_INPUT;
}

/* Answering -------------------------------------------------------------------------------------------------------- */

static bool write_tables(const StudyJob *job, const json_t *answer) {
    static const struct {
        const char *name;
        int (*write)(const Study *study, const char *path);
    } tables[] = {{"study.csv", study_csv_write_trials},
                  {"study-series.csv", study_csv_write_series},
                  {"study-points.csv", study_csv_write_points}};
    const bool wanted[] = {true, job->experiment.series, job->study.runs > 1};
    char path[OUTPUT_PATH];
    snprintf(path, sizeof path, "%s/summary.json", job->options->out);
    int error = answer_write(answer, path);
    for (size_t t = 0; t < sizeof tables / sizeof *tables && !error; t++) {
        snprintf(path, sizeof path, "%s/%s", job->options->out, tables[t].name);
        error = wanted[t] ? tables[t].write(&job->study, path) : 0;
    }
    if (error)
        output_failed(path, error);
    return !error;
}

static bool write_plots(const StudyJob *job) {
    const Options *options = job->options;
    if (job->findings)
        return shake_answer_write(job->findings, options);
    char path[PLOT_WRITE_PATH];
    Arena arena = {0};
    PlotSheet sheet = output_sheet(options, job->laboratory->source(options, &job->experiment, &arena));
    int error = study_plots_write(&job->study, options->measured ? &job->measured : NULL, options->out, &sheet, path);
    arena_clear(&arena);
    if (error)
        output_failed(path, error);
    return !error;
}

static bool write_report(const StudyJob *job) {
    const Options *options = job->options;
    char *command = report_files_command(options);
    const Making making = report_files_making(options, command);
    Text words = {0};
    study_text_add(&words, &job->study, options->files[0]);
    Document document = study_report_make(&(StudyReport){.study = &job->study,
                                                         .measured = options->measured ? &job->measured : NULL,
                                                         .words = words.text,
                                                         .file = options->files[0],
                                                         .add_numbers = job->laboratory->add_numbers,
                                                         .context = options},
                                          &making);
    bool written = report_files_write(&document, "report", options);
    document_clear(&document);
    memory_free(words.text);
    memory_free(command);
    return written;
}

static json_t *make_answer(const StudyJob *job) {
    const char *file = job->options->files[0];
    return job->findings ? shake_answer_make(job->findings, file) : study_answer_make(&job->study, file);
}

static void print_words(const StudyJob *job) {
    const char *file = job->options->files[0];
    if (job->findings) {
        shake_answer_print(job->findings, file);
        return;
    }
    Text text = {0};
    study_text_add(&text, &job->study, file);
    printf("%s", text.text);
    memory_free(text.text);
}

static bool is_interrupted(const StudyJob *job) {
    return !is_whole(job) || (job->findings && job->findings->calm == SHAKE_CALM_INTERRUPTED);
}

/* Prints and writes the answer. Returns the exit code. */
static int answer_study(const StudyJob *job) {
    const Options *options = job->options;
    bool interrupted = is_interrupted(job);
    json_t *answer = make_answer(job);
    answer_mark_interrupted(answer, interrupted);
    bool written = job->kept && (!options->out || (write_tables(job, answer) && write_plots(job) &&
                                                   (!options->report || job->findings || write_report(job))));
    if (options->json)
        answer_print(json_incref(answer));
    else
        print_words(job);
    if (options->out && written && !options->json)
        printf("\nplots and data are in %s\n", options->out);
    json_decref(answer);
    SummaryCount count = summary_count(&job->study);
    bool yes = (job->findings ? count.regular == count.done : count.regular > 0) && !interrupted;
    return !written ? EXIT_WRONG_INPUT : yes ? EXIT_ANSWERED : EXIT_ANSWER_NO;
}

/* Answers the study; earthquakes without --vary have findings of their own. */
static int answer_all(StudyJob *job) {
    const Options *options = job->options;
    if (job->study.shard.count)
        return job->kept ? study_shards_answer(options, &job->study) : EXIT_WRONG_INPUT;
    if (!options->study.shakes || job->study.axis_count || options->types)
        return answer_study(job);
    ShakeFindings findings = shake_findings_make(&job->study);
    size_t route = options->route ? plan_find_route(&findings.house->plan, options->route) : SIZE_MAX;
    shake_findings_run_calm(&findings, route, options->jobs, &progress_stop);
    if (is_whole(job) && findings.calm == SHAKE_CALM_INTERRUPTED)
        fprintf(stderr, "clearance: interrupted in the run without a shake\n");
    job->findings = &findings;
    int code = answer_study(job);
    job->findings = NULL;
    shake_findings_free(&findings);
    return code;
}

/* Refuses options that have no effect with --shake, and --report where there is none. */
static bool is_one_chance(const Options *options, Fault *fault) {
    const StudyRequest *asked = &options->study;
    if (asked->shakes && asked->runs)
        fault_add(fault, "clearance: --runs has no effect with --shake N, which sets the number of runs; leave it out");
    else if (options->drivers && (asked->shakes || asked->runs))
        fault_add(fault, "clearance: %s has no effect with --drivers N, which sets the runs; leave it out",
                  asked->shakes ? "--shake" : "--runs");
    else if (asked->shakes && options->types)
        fault_add(fault, "clearance: --types has no effect with --shake; leave it out");
    else if (asked->shakes && options->measured && !asked->axis_count)
        fault_add(fault, "clearance: --measured has no effect with --shake without --vary; leave it out");
    else if (options->report && (options->paper || options->follow))
        fault_add(fault, "clearance: --report has no effect with %s; leave it out",
                  options->paper ? "--paper, whose page is written to --out" : "--follow");
    else if (options->report && options->types && !asked->axis_count && asked->runs < 2)
        fault_add(fault, "clearance: --report of types needs --vary; leave it out");
    else if (options->report && !options->out)
        fault_add(fault, "clearance: --report needs --out DIR, the directory to write it to");
    else
        return true;
    return false;
}

/* Refuses options that have no effect: the page of the paper has its own ranges, runs and types, and types without
 * --vary are told at one point. */
static bool is_one_question(const Options *options, Fault *fault) {
    static const char *const idle[] = {"--vary",     "--runs",      "--shake",    "--spread", "--sweep",
                                       "--measured", "--no-series", "--thorough", "--lanes",  "--types",
                                       "--route",    "--driving",   "--seed"};
    enum { IDLE = sizeof idle / sizeof *idle, IDLE_WITH_TYPES = 8 };
    bool ranges = options->study.axis_count || options->study.runs > 1;
    const char *own = options->follow             ? "--follow"
                      : options->paper            ? "--paper"
                      : options->types && !ranges ? "--types without --vary"
                                                  : NULL;
    bool curves = options->follow && options->study.axis_count == 1; /* of what is located, over a second number */
    for (size_t i = 0; own && i < (options->paper || options->follow ? IDLE : IDLE_WITH_TYPES); i++)
        if (!(i == 0 && curves) && options_given(options, idle[i])) {
            fault_add(fault, "clearance: %s has no effect with %s; leave it out", idle[i], own);
            return false;
        }
    return true;
}

int command_study(const Options *options) {
    StudyJob job = {.options = options};
    Fault fault = {0};
    if (!study_shards_check(options, &fault) || !is_one_question(options, &fault) || !is_one_chance(options, &fault))
        return house_file_report(&fault);
    bool types = options->types && !options->study.axis_count && options->study.runs < 2;
    if (types || options->follow || options->paper)
        return types             ? study_types_answer(options)
               : options->follow ? follow_beam_file(options)
                                 : paper_answer(options);
    if (!open_study(&job, &fault))
        return house_file_report(&fault);
    int code = EXIT_WRONG_INPUT;
    if (options->study.print_shards) {
        code = study_shards_print(options, &job.study);
    } else if (!output_directory(options->out) || !begin_study(&job, &fault)) {
        house_file_report(&fault);
    } else {
        code = run_kept(&job, &fault);
        house_file_report(&fault);
        if (!code)
            code = answer_all(&job);
    }
    study_clear(&job.study);
    measured_free(&job.measured);
    close_experiment(&job);
    return code;
}
