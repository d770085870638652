#include "command/paper.h"

#include <stdio.h>

#include "command/answer.h"
#include "command/house_file.h"
#include "command/output.h"
#include "command/progress.h"
#include "command/report_files.h"
#include "command/terminal.h"
#include "plot/plot_write.h"
#include "report/paper_report.h"
#include "result/json.h"
#include "result/paper.h"
#include "result/text.h"

static void show_progress(void *context, const char *what) {
    (void)context;
    terminal_progress("%s", what);
}

static json_t *make_answer(const Paper *paper, const PaperClaim *claims) {
    return json_pack("{s:s, s:s, s:s, s:o, s:o}", "kind", "paper", "beam", paper->beam.name, "note", paper->beam.note,
                     "claims", result_json_take_list(result_paper_claims(claims)), "types",
                     result_json_take_list(result_paper_types(paper)));
}

static void print_claims(const Paper *paper, const PaperClaim *claims) {
    ResultTable table = result_paper_claims(claims);
    Text text = {0};
    text_format(&text, "%s: %s\n", paper->path, result_paper_summary(claims, &table.arena));
    for (size_t i = 0; i < table.record_count; i++) {
        text_add(&text, "\n");
        result_text_record(&text, &table, i);
    }
    printf("%s", text.text);
    memory_free(text.text);
    result_clear(&table);
}

/* Writes the document, and each figure as a picture. */
static bool write_pages(Paper *paper, const json_t *answer, const Options *options) {
    char path[PLOT_WRITE_PATH], *command = report_files_command(options);
    const Making making = report_files_making(options, command);
    PaperFigures *figures = paper_figures_make(paper);
    Document document = paper_report_make(paper, figures, &making);
    bool written = report_files_write(&document, "paper", options);
    int error = 0;
    for (size_t i = 0; i < PAPER_FIGURES && !error; i++)
        if (figures->figures[i].plot)
            error = plot_write_files(figures->figures[i].plot, figures->figures[i].name, options->out, options->width,
                                     options->height, options->theme, path);
    if (!error) {
        snprintf(path, sizeof path, "%s/summary.json", options->out);
        error = answer_write(answer, path);
    }
    if (error)
        output_failed(path, error);
    document_clear(&document);
    paper_figures_free(figures);
    memory_free(command);
    return written && !error;
}

int paper_answer(const Options *options) {
    Fault fault = {0};
    Paper paper;
    if (!beam_is_file(options->files[0])) {
        fault_add(&fault, "clearance: --paper needs a beam file; %s is not one", options->files[0]);
        return house_file_report(&fault);
    }
    bool show = progress_is_shown(options);
    PaperAnswer made = paper_make(&paper,
                                  &(PaperOptions){.path = options->files[0],
                                                  .settings = options->settings,
                                                  .setting_count = options->setting_count,
                                                  .jobs = options->jobs,
                                                  .stop = &progress_stop,
                                                  .progress = show ? show_progress : NULL},
                                  &fault);
    if (show)
        terminal_clear_progress();
    if (made == PAPER_FAULTY)
        return house_file_report(&fault);
    if (made == PAPER_INTERRUPTED) {
        fprintf(stderr, "clearance: interrupted; nothing is written\n");
        if (options->json)
            answer_print(json_pack("{s:s, s:b}", "kind", "paper", "interrupted", 1));
        return EXIT_ANSWER_NO;
    }
    PaperClaim claims[PAPER_CLAIMS];
    paper_claims(&paper, claims);
    json_t *answer = make_answer(&paper, claims);
    bool written = !options->out || write_pages(&paper, answer, options);
    if (options->json)
        answer_print(json_incref(answer));
    else
        print_claims(&paper, claims);
    if (options->out && written && !options->json)
        printf("\nthe page is %s/paper.html and .pdf\n", options->out);
    json_decref(answer);
    paper_clear(&paper);
    return written ? EXIT_ANSWERED : EXIT_WRONG_INPUT;
}
