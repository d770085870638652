/* The facts of the comparison with the paper as rows, for `study --paper`, its JSON and its page. */
#pragma once

#include "base/text.h"
#include "experiment/paper.h"
#include "result/result.h"

/* A record for each of `count` claims: its place, the claim, the paper's figure and ours, and whether they agree. */
ResultTable result_paper_claims(const PaperClaim *claims, size_t count);

/* A record of a single run: its beam, its verdict, and of a motion that is not periodic how long it lasts and how large
 * its peaks become (verdict.h), so that runs have different rows. */
ResultTable result_paper_run(const Paper *paper, PaperRun which);

/* Adds a single run in words: a line with its verdict, then what supports it. */
void result_paper_say_run(Text *text, const Paper *paper, PaperRun which);

/* A record for each classified frequency. */
ResultTable result_paper_types(const Paper *paper);

/* "3 of 10 claims of the paper are met"; it lives as long as the arena. */
const char *result_paper_summary(const PaperClaim *claims, size_t count, Arena *arena);
