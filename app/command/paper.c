#include "command/paper.h"

#include <stdio.h>

#include "command/answer.h"
#include "command/house_file.h"
#include "command/output.h"
#include "command/progress.h"
#include "command/report_files.h"
#include "plot/plot_write.h"
#include "report/paper_report.h"

static void show_progress(void *context, const char *what) {
    (void)context;
    fprintf(stderr, "\r%-60s", what);
}

static json_t *make_answer(const Paper *paper, const PaperClaim *claims) {
    json_t *list = json_array(), *types = json_array();
    for (size_t i = 0; i < PAPER_CLAIMS; i++)
        json_array_append_new(list,
                              json_pack("{s:s, s:s, s:s, s:s, s:s, s:s, s:s}", "id", claims[i].id, "place",
                                        claims[i].place, "claim", claims[i].claim, "paper", claims[i].paper, "ours",
                                        claims[i].ours, "met", paper_met_name(claims[i].met), "rule", claims[i].rule));
    for (size_t i = 0; i < PAPER_TYPES; i++)
        json_array_append_new(types, json_pack("{s:o, s:s}", "frequency", json_number(paper->frequency[i]), "type",
                                               types_kind_name(paper->types[i].kind)));
    return json_pack("{s:s, s:s, s:s, s:o, s:o}", "kind", "paper", "beam", paper->beam.name, "note", paper->beam.note,
                     "claims", list, "types", types);
}

static void print_claims(const Paper *paper, const PaperClaim *claims) {
    size_t met = 0;
    for (size_t i = 0; i < PAPER_CLAIMS; i++)
        met += claims[i].met == PAPER_MET;
    printf("%zu of %d claims of Gu and Dubowsky (1995) are met by %s\n", met, PAPER_CLAIMS, paper->path);
    for (size_t i = 0; i < PAPER_CLAIMS; i++)
        printf("\n%s: %s: %s\n  paper  %s\n  ours   %s\n", paper_met_name(claims[i].met), claims[i].place,
               claims[i].claim, claims[i].paper, claims[i].ours);
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
    bool made = paper_make(&paper,
                           &(PaperOptions){.path = options->files[0],
                                           .settings = options->settings,
                                           .setting_count = options->setting_count,
                                           .jobs = options->jobs,
                                           .stop = &progress_interrupted,
                                           .progress = show ? show_progress : NULL},
                           &fault);
    if (show)
        fprintf(stderr, "\r%60s\r", "");
    if (!made) {
        if (progress_interrupted)
            fprintf(stderr, "clearance: interrupted; nothing is written\n");
        int code = house_file_report(&fault);
        return progress_interrupted ? EXIT_ANSWER_NO : code;
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
