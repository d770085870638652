#include "command/paper.h"

#include <stdio.h>

#include "base/stopwatch.h"
#include "base/text.h"
#include "command/answer.h"
#include "command/house_file.h"
#include "command/output.h"
#include "command/progress.h"
#include "command/report_files.h"
#include "platform/terminal.h"
#include "plot/plot_write.h"
#include "report/crank_paper_report.h"
#include "report/paper_report.h"
#include "result/json.h"
#include "result/paper.h"
#include "result/source_line.h"
#include "result/text.h"

static const double LINES_APART = 10; /* s, at least, where progress is not shown in place */

/* Progress as lines, for standard error that is not a terminal. */
typedef struct Lines {
    double last; /* s, by the clock */
} Lines;

static void show_progress(void *context, const char *what) {
    (void)context;
    terminal_progress("%s", what);
}

/* Writes a line now and then. */
static void write_progress(void *context, const char *what) {
    Lines *lines = context;
    double now = stopwatch_now();
    if (now - lines->last < LINES_APART)
        return;
    lines->last = now;
    fprintf(stderr, "clearance: %s\n", what);
}

static json_t *make_runs(const Paper *paper) {
    json_t *runs = json_array();
    for (PaperRun i = 0; i < PAPER_RUNS; i++) {
        json_t *run = json_object();
        result_json_take_record(run, result_paper_run(paper, i));
        json_array_append_new(runs, run);
    }
    return runs;
}

static json_t *make_answer(const Paper *paper, const PaperClaim *claims) {
    return json_pack("{s:s, s:s, s:s, s:o, s:o, s:o}", "kind", "paper", "beam", paper->beam.name, "note",
                     paper->beam.note, "claims", result_json_take_list(result_paper_claims(claims, PAPER_CLAIMS)),
                     "runs", make_runs(paper), "types", result_json_take_list(result_paper_types(paper)));
}

static void print_claims(const char *path, const PaperClaim *claims, size_t count) {
    ResultTable table = result_paper_claims(claims, count);
    Text text = {0};
    text_format(&text, "%s: %s\n", path, result_paper_summary(claims, count, &table.arena));
    for (size_t i = 0; i < table.record_count; i++) {
        text_add(&text, "\n");
        result_text_record(&text, &table, i);
    }
    printf("%s", text.text);
    memory_free(text.text);
    result_clear(&table);
}

static void print_runs(const Paper *paper) {
    for (PaperRun i = 0; i < PAPER_RUNS; i++) {
        Text text = {0};
        result_paper_say_run(&text, paper, i);
        printf("\n%s", text.text);
        memory_free(text.text);
    }
}

/* Writes the document, and each figure as a picture. */
static bool write_pages(Paper *paper, const json_t *answer, const Options *options) {
    char path[PLOT_WRITE_PATH], *command = report_files_command(options);
    const Making making = report_files_making(options, command);
    PaperFigures *figures = paper_figures_make(paper);
    Document document = paper_report_make(paper, figures, &making);
    bool written = report_files_write(&document, "paper", options);
    int error = 0;
    Arena arena = {0};
    PlotSheet sheet = output_sheet(options, source_line_beam(&paper->beam, &arena));
    for (size_t i = 0; i < PAPER_FIGURES && !error; i++)
        if (figures->figures[i].plot)
            error = plot_write_files(figures->figures[i].plot, figures->figures[i].name, options->out, &sheet, path);
    if (!error) {
        snprintf(path, sizeof path, "%s/summary.json", options->out);
        error = answer_write(answer, path);
    }
    if (error)
        output_failed(path, error);
    arena_clear(&arena);
    document_clear(&document);
    paper_figures_free(figures);
    memory_free(command);
    return written && !error;
}

static int tell_interrupted(const Options *options) {
    fprintf(stderr, "clearance: interrupted; nothing is written\n");
    if (options->json)
        answer_print(json_pack("{s:s, s:b}", "kind", "paper", "interrupted", 1));
    return EXIT_ANSWER_NO;
}

/* Cranks ----------------------------------------------------------------------------------------------------------- */

static bool write_crank_page(CrankPaper *paper, const json_t *answer, const Options *options) {
    char path[OUTPUT_PATH], *command = report_files_command(options);
    const Making making = report_files_making(options, command);
    Document document = crank_paper_report_make(paper, &making);
    bool written = report_files_write(&document, "paper", options);
    snprintf(path, sizeof path, "%s/summary.json", options->out);
    int error = written ? answer_write(answer, path) : 0;
    if (error)
        output_failed(path, error);
    document_clear(&document);
    memory_free(command);
    return written && !error;
}

static int answer_crank(const Options *options, const PaperOptions *asked) {
    Fault fault = {0};
    CrankPaper paper;
    PaperAnswer made = crank_paper_make(&paper, asked, &fault);
    if (progress_is_shown(options))
        terminal_clear_progress();
    if (made == PAPER_FAULTY)
        return house_file_report(&fault);
    if (made == PAPER_INTERRUPTED)
        return tell_interrupted(options);
    PaperClaim claims[CRANK_PAPER_CLAIMS];
    crank_paper_claims(&paper, claims);
    json_t *answer =
        json_pack("{s:s, s:s, s:s, s:o}", "kind", "paper", "crank", paper.crank.name, "note", paper.crank.note,
                  "claims", result_json_take_list(result_paper_claims(claims, CRANK_PAPER_CLAIMS)));
    bool written = !options->out || write_crank_page(&paper, answer, options);
    if (options->json)
        answer_print(json_incref(answer));
    else
        print_claims(paper.path, claims, CRANK_PAPER_CLAIMS);
    if (options->out && written && !options->json)
        printf("\nthe page is %s/paper.html and .pdf\n", options->out);
    json_decref(answer);
    crank_paper_clear(&paper);
    return written ? EXIT_ANSWERED : EXIT_WRONG_INPUT;
}

/* Both ------------------------------------------------------------------------------------------------------------- */

/* Reads the file and forgets it: a fault is told before the folder of --out is made. */
static bool can_be_read(const Options *options, bool crank, Fault *fault) {
    Crank read_crank = {0};
    Beam read_beam = {0};
    bool good = crank ? crank_read(&read_crank, options->files[0], options->settings, options->setting_count, fault)
                      : beam_read(&read_beam, options->files[0], options->settings, options->setting_count, fault);
    crank_free(&read_crank);
    beam_free(&read_beam);
    return good;
}

int paper_answer(const Options *options) {
    Fault fault = {0};
    Paper paper;
    bool show = progress_is_shown(options), crank = crank_is_file(options->files[0]);
    Lines lines = {stopwatch_now()};
    const PaperOptions asked = {.path = options->files[0],
                                .settings = options->settings,
                                .setting_count = options->setting_count,
                                .jobs = options->jobs,
                                .stop = &progress_stop,
                                .progress = show             ? show_progress
                                            : options->quiet ? NULL
                                                             : write_progress,
                                .context = &lines};
    if (!crank && !beam_is_file(options->files[0]) && !text_read_interrupted()) {
        fault_add(&fault, "clearance: --paper needs a beam or crank file; %s is not one", options->files[0]);
        return house_file_report(&fault);
    }
    if (!can_be_read(options, crank, &fault) || !output_directory(options->out))
        return house_file_report(&fault);
    if (crank)
        return answer_crank(options, &asked);
    PaperAnswer made = paper_make(&paper, &asked, &fault);
    if (show)
        terminal_clear_progress();
    if (made == PAPER_FAULTY)
        return house_file_report(&fault);
    if (made == PAPER_INTERRUPTED)
        return tell_interrupted(options);
    PaperClaim claims[PAPER_CLAIMS];
    paper_claims(&paper, claims);
    json_t *answer = make_answer(&paper, claims);
    bool written = !options->out || write_pages(&paper, answer, options);
    if (options->json)
        answer_print(json_incref(answer));
    else {
        print_claims(paper.path, claims, PAPER_CLAIMS);
        print_runs(&paper);
    }
    if (options->out && written && !options->json)
        printf("\nthe page is %s/paper.html and .pdf\n", options->out);
    json_decref(answer);
    paper_clear(&paper);
    return written ? EXIT_ANSWERED : EXIT_WRONG_INPUT;
}
