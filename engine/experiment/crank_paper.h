/* Compares what Gu and Dubowsky's paper (1995) says of its second machine with a crank file. It says one thing: in an
 * instrumented spatial slider crank "many of the characteristic behaviors found for the IBS were evident, including
 * types I, II and III". None of the machine's dimensions is published, so that a claim is met when the file's machine
 * has such a type somewhere; each is looked for at one speed and clearance, which were found beforehand. */
#pragma once

#include "crank/crank_cycle.h"
#include "cycle/response.h"
#include "experiment/crank_experiment.h"
#include "experiment/paper.h"

enum { CRANK_PAPER_CLAIMS = 3 /* types I, II and III */ };

typedef struct CrankPaper {
    const char *path;
    Crank crank;                      /* as in the file */
    Crank cranks[CRANK_PAPER_CLAIMS]; /* where a type is looked for; their texts belong to the file's crank */
    Tree trees[CRANK_PAPER_CLAIMS];
    Response responses[CRANK_PAPER_CLAIMS];     /* from the start, confirmed by motions that are watched */
    Experiment experiments[CRANK_PAPER_CLAIMS]; /* of these cranks */
    Types types[CRANK_PAPER_CLAIMS];            /* told in windows alone, without what is beyond */
    Arena arena;
} CrankPaper;

/* Runs all simulations: minutes. */
PaperAnswer crank_paper_make(CrankPaper *paper, const PaperOptions *options, Fault *fault);
void crank_paper_clear(CrankPaper *paper);

/* Fills the claims, whose texts live as long as the paper. */
void crank_paper_claims(CrankPaper *paper, PaperClaim claims[CRANK_PAPER_CLAIMS]);
