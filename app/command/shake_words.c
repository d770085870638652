#include "command/shake_words.h"

#include <inttypes.h>
#include <stdio.h>

#include "result/shake.h"
#include "result/text.h"

enum { ROWS_MOST = 20 };

/* Adds a table below an empty line, shortened to the first rows; the table is released. */
static void add_table(Text *text, ResultTable table) {
    size_t all = table.record_count, listed = all < ROWS_MOST ? all : ROWS_MOST;
    table.record_count = listed;
    result_text_take(text, "", table);
    if (listed < all)
        text_format(text, "and %zu more\n", all - listed);
}

static void add_answer(Text *text, const ShakeFindings *findings) {
    ResultTable answer = result_shake_answer(findings), stops = result_shake_stops(findings);
    text_add(text, "\n");
    result_text_list(text, (const ResultTable *const[]){&answer, &stops}, 2);
    result_clear(&answer);
    result_clear(&stops);
}

static void print_faults(const ShakeFindings *findings) {
    const Study *study = findings->study;
    size_t faults = 0;
    const char *first = NULL;
    for (size_t t = 0; t < study->trial_count; t++) {
        faults += study->trials[t].fault != NULL;
        first = first ? first : study->trials[t].fault;
    }
    if (faults)
        printf(faults == 1 ? "\n%zu shake could not be simulated: %s\n"
                           : "\n%zu shakes could not be simulated; the first: %s\n",
               faults, first);
}

void shake_words_print(const ShakeFindings *findings, const char *file) {
    Arena arena = {0};
    Text text = {0};
    text_format(&text, "%s\n%s: %s\n", shake_findings_headline(findings, &arena), file,
                result_shake_simulated(findings, &arena));
    if (!findings->toppling)
        text_add(&text, "Nothing in this house can fall: all shakes are alike\n");
    add_answer(&text, findings);
    add_table(&text, result_shake_people(findings));
    if (findings->shakes)
        add_table(&text, result_shake_furniture(findings));
    fputs(text.text, stdout);
    if (findings->worst)
        printf(*findings->made_by ? "\nFewest people are out in the shake with seed %" PRIu64
                                    ": clearance run HOUSE %s\n"
                                  : "\nFewest people are out in the shake with seed %" PRIu64 "%s\n",
               findings->worst->seed, findings->made_by);
    print_faults(findings);
    memory_free(text.text);
    arena_clear(&arena);
}
