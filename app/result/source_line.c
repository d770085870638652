#include "result/source_line.h"

#include <string.h>

#include "base/text.h"

static bool holds_word(const char *text, const char *word) {
    size_t length = strlen(word);
    for (; *text; text++)
        if (strncasecmp(text, word, length) == 0)
            return true;
    return false;
}

bool source_line_is_assumed(const Plan *plan) {
    return holds_word(plan->note, "assumed");
}

const char *source_line_house(const Plan *plan, Arena *arena) {
    const char *name = *plan->name ? plan->name : "house";
    if (!source_line_is_assumed(plan))
        return text_in_arena(arena, "%s", name);
    return text_in_arena(arena, "%s: %snot measured", name, holds_word(name, "assumed") ? "" : "assumed plan, ");
}

/* Beginnings of a number's provenance, and their words; the first match counts. */
static const struct {
    const char *begin, *words;
} kinds[] = {{"paper", "from the paper"},  {"reconstructed", "reconstructed"},
             {"identified", "identified"}, {"literature", "from the literature"},
             {"measured", "measured"},     {"assumed: set for this run", "set for this run"},
             {"assumed", "assumed"}};

enum { KINDS = sizeof kinds / sizeof *kinds };

/* Returns the index of a number's kind; KINDS: none. */
static size_t kind_of(const char *provenance) {
    size_t k = 0;
    while (k < KINDS && strncmp(provenance, kinds[k].begin, strlen(kinds[k].begin)) != 0)
        k++;
    return k;
}

/* Counts the numbers of a machine by kind; those of the run belong to the command. */
static const char *count_kinds(const char *name, const ParameterTable *table, const char *const *provenance,
                               Arena *arena) {
    static const char of_run[] = "run.";
    size_t of_kind[KINDS + 1] = {0}, count = 0;
    for (size_t i = 0; i < table->count; i++) {
        if (strncmp(table->rows[i].name, of_run, sizeof of_run - 1) == 0)
            continue;
        of_kind[kind_of(provenance[i])]++;
        count++;
    }
    const char *line = text_in_arena(arena, "%s: of %zu numbers", name, count), *comma = "";
    for (size_t k = 0; k < KINDS; k++) {
        if (of_kind[k] == count)
            return text_in_arena(arena, "%s: all %zu numbers %s", name, count, kinds[k].words);
        if (!of_kind[k])
            continue;
        line = text_in_arena(arena, "%s%s %zu %s", line, comma, of_kind[k], kinds[k].words);
        comma = ",";
    }
    return of_kind[KINDS] ? text_in_arena(arena, "%s%s %zu of other origin", line, comma, of_kind[KINDS]) : line;
}

const char *source_line_beam(const Beam *beam, Arena *arena) {
    return count_kinds(*beam->name ? beam->name : "beam", beam_table(), beam->provenance, arena);
}

const char *source_line_crank(const Crank *crank, Arena *arena) {
    return count_kinds(*crank->name ? crank->name : "crank", crank_table(), crank->provenance, arena);
}
