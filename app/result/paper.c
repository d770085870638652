#include "result/paper.h"

#include <string.h>

#include "result/advice.h"
#include "result/verdict.h"

static void add_text(ResultTable *table, const char *key, const char *label, const char *text) {
    result_add(table, (ResultRow){.key = key, .label = label, .text = text});
}

ResultTable result_paper_claims(const PaperClaim *claims, size_t count) {
    ResultTable table = {.numbers = RESULT_SHORTEST};
    for (size_t i = 0; i < count; i++) {
        const PaperClaim *claim = &claims[i];
        const char *met = paper_met_name(claim->met);
        add_text(&table, "id", NULL, claim->id);
        add_text(&table, "place", "in the paper", claim->place);
        add_text(&table, "claim", "claim", claim->claim);
        add_text(&table, "paper", "paper", claim->paper);
        add_text(&table, "ours", "ours", claim->ours);
        add_text(&table, "met", NULL, met);
        result_add(&table, (ResultRow){.label = "result",
                                       .text = claim->met == PAPER_NOT_TOLD ? "undecided" : met,
                                       .role = claim->met == PAPER_NOT_MET ? ROLE_ERROR : ROLE_TEXT});
        add_text(&table, "rule", "met when", claim->rule);
        result_end(&table);
    }
    return table;
}

ResultTable result_paper_run(const Paper *paper, PaperRun which) {
    ResultTable table = {.numbers = RESULT_SHORTEST};
    result_add(&table, (ResultRow){.key = "frequency",
                                   .label = "frequency",
                                   .kind = RESULT_NUMBER,
                                   .number = paper->beams[which].frequency,
                                   .unit = "Hz"});
    result_add(&table, (ResultRow){.key = "length",
                                   .label = "length",
                                   .kind = RESULT_NUMBER,
                                   .number = paper->beams[which].length,
                                   .unit = "m"});
    result_verdict_add(&table, &paper->responses[which], "cycle");
    result_end(&table);
    return table;
}

void result_paper_say_run(Text *text, const Paper *paper, PaperRun which) {
    const Response *response = &paper->responses[which];
    text_format(text, "%.0f Hz, %.1f mm long: ", paper->beams[which].frequency, 1000 * paper->beams[which].length);
    result_verdict_name(text, response, "cycle");
    text_add(text, "\n");
    result_verdict_say(text, response, "cycle");
}

/* Returns the first line of the advice. */
static const char *advice_of(Arena *arena, const Paper *paper, size_t i) {
    Text text = {0};
    advice_write(&text, &paper->types[i], &paper->experiments[PAPER_FREQUENCIES], 0);
    const char *line = text_in_arena(arena, "%.*s", (int)strcspn(text.text, "\n"), text.text);
    memory_free(text.text);
    return line;
}

ResultTable result_paper_types(const Paper *paper) {
    ResultTable table = {.numbers = RESULT_SHORTEST};
    for (size_t i = 0; i < PAPER_TYPES; i++) {
        TypesKind kind = paper->types[i].kind;
        result_add(&table, (ResultRow){.key = "frequency",
                                       .label = "frequency",
                                       .kind = RESULT_NUMBER,
                                       .number = paper->frequency[i],
                                       .unit = "Hz"});
        add_text(&table, "type", NULL, types_kind_name(kind));
        add_text(&table, NULL, "type", kind == TYPES_UNRESOLVED ? "undecided" : types_kind_name(kind));
        add_text(&table, NULL, "advice", advice_of(&table.arena, paper, i));
        result_end(&table);
    }
    return table;
}

const char *result_paper_summary(const PaperClaim *claims, size_t count, Arena *arena) {
    size_t met = 0;
    for (size_t i = 0; i < count; i++)
        met += claims[i].met == PAPER_MET;
    return text_in_arena(arena, "%zu of %zu claims of the paper are met", met, count);
}
