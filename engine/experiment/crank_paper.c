#include "experiment/crank_paper.h"

#include "base/stop.h"
#include "base/text.h"

/* Where the types are looked for. */
static const struct {
    double speed, clearance; /* rpm, m */
} places[CRANK_PAPER_CLAIMS] = {{500, 0.02e-3}, {600, 0.1e-3}, {700, 0.25e-3}};

static const TypesKind kinds[CRANK_PAPER_CLAIMS] = {TYPES_I, TYPES_II, TYPES_III};

static void tell(CrankPaper *paper, const PaperOptions *options, const char *what, size_t i) {
    if (options->progress)
        options->progress(options->context, text_in_arena(&paper->arena, "%s at %.0f rpm with a clearance of %g mm",
                                                          what, places[i].speed, 1000 * places[i].clearance));
}

/* Runs one place and tells its type. */
static bool make_place(CrankPaper *paper, size_t i, const PaperOptions *options, Fault *fault) {
    Crank *crank = &paper->cranks[i];
    *crank = paper->crank;
    crank->frequency = places[i].speed / 60;
    crank->clearance = places[i].clearance;
    paper->trees[i] = tree_of(crank);
    tell(paper, options, "the motion", i);
    response_run(&paper->responses[i], crank_cycle_of(&paper->trees[i]), crank->transient_cycles, crank->cycles, NULL,
                 options->stop);
    SurvivalTask watch = survival_task(&crank_cycle, SURVIVAL_USUAL, options->jobs, options->stop);
    response_confirm(&paper->responses[i], crank_cycle_of(&paper->trees[i]), &watch);
    crank_experiment_of(&paper->experiments[i], crank);
    if (stop_requested(options->stop))
        return true;
    tell(paper, options, "the type", i);
    Experiment thorough;
    crank_experiment_of(&thorough, crank);
    crank_experiment_be_thorough(&thorough, watch.lanes, watch.cycles);
    bool good = types_classify(&paper->types[i],
                               &(TypesTask){.experiment = &paper->experiments[i],
                                            .thorough = &thorough,
                                            .names = crank_experiment_window,
                                            .name_count = CRANK_EXPERIMENT_WINDOW,
                                            .window_only = true,
                                            .jobs = options->jobs,
                                            .stop = options->stop},
                               fault);
    crank_experiment_close(&thorough);
    return good;
}

PaperAnswer crank_paper_make(CrankPaper *paper, const PaperOptions *options, Fault *fault) {
    *paper = (CrankPaper){.path = options->path};
    if (!crank_read(&paper->crank, options->path, options->settings, options->setting_count, fault))
        return PAPER_FAULTY;
    bool good = true;
    for (size_t i = 0; i < CRANK_PAPER_CLAIMS && good && !stop_requested(options->stop); i++)
        good = make_place(paper, i, options, fault);
    bool whole = good && !stop_requested(options->stop);
    if (!whole)
        crank_paper_clear(paper);
    return whole ? PAPER_MADE : good ? PAPER_INTERRUPTED : PAPER_FAULTY;
}

void crank_paper_clear(CrankPaper *paper) {
    for (size_t i = 0; i < CRANK_PAPER_CLAIMS; i++) {
        response_clear(&paper->responses[i]);
        if (paper->experiments[i].given)
            crank_experiment_close(&paper->experiments[i]);
    }
    crank_free(&paper->crank);
    arena_clear(&paper->arena);
    *paper = (CrankPaper){.path = NULL};
}

static const char *say_type(CrankPaper *paper, size_t i) {
    const Response *response = &paper->responses[i];
    const Types *types = &paper->types[i];
    double steepest = 0;
    for (size_t p = 0; p < types->parameter_count; p++)
        if (fabs(types->parameters[p].sensitivity) > steepest)
            steepest = fabs(types->parameters[p].sensitivity);
    const char *place = text_in_arena(&paper->arena, "at %.0f rpm with a clearance of %g mm", places[i].speed,
                                      1000 * places[i].clearance);
    if (response->orbit.period && response->verdict == RESPONSE_PERIODIC)
        return text_in_arena(&paper->arena,
                             "type %s %s: period %zu, %.1f N; 1 %% of a number changes it by up to "
                             "%.1f %%",
                             types_kind_name(types->kind), place, response->orbit.period, response->orbit_peak,
                             steepest);
    return text_in_arena(&paper->arena, "type %s %s: %s, exponent %+.2f \u00b1 %.2f a revolution, %.0f to %.0f N",
                         types_kind_name(types->kind), place, response_name(response), response->exponent.value,
                         response->exponent.error, response->peaks.min, response->peaks.max);
}

void crank_paper_claims(CrankPaper *paper, PaperClaim claims[CRANK_PAPER_CLAIMS]) {
    static const char *const ids[] = {"type-1", "type-2", "type-3"};
    static const char *const sentences[] = {"the slider crank shows type I", "the slider crank shows type II",
                                            "the slider crank shows type III"};
    static const char *const rules[] = {
        "one periodic motion from 16 starts within 1 % of four numbers, and no change of 1 % changes its largest force "
        "by 5 %",
        "periodic from 16 starts within 1 % of four numbers, but a change of 1 % changes its largest force by 5 % or "
        "more, or there are several motions",
        "somewhere within 1 % of four numbers not periodic, which motions that are watched confirm"};
    for (size_t i = 0; i < CRANK_PAPER_CLAIMS; i++) {
        TypesKind kind = paper->types[i].kind;
        claims[i] = (PaperClaim){ids[i],
                                 "text, on the second system",
                                 sentences[i],
                                 "evident; no number is published",
                                 say_type(paper, i),
                                 kind == kinds[i]           ? PAPER_MET
                                 : kind == TYPES_UNRESOLVED ? PAPER_NOT_TOLD
                                                            : PAPER_NOT_MET,
                                 rules[i]};
    }
}
