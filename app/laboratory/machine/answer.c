#include "laboratory/machine/answer.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/text.h"
#include "laboratory/machine/words.h"
#include "result/panel.h"

enum {
    SETTLED = 100,   /* cycles after a change before the motion is reported to differ from the motion from rest */
    FREQUENCIES = 6, /* natural frequencies in the answer */
};

static const double ALIKE = 0.02; /* 1, share of the largest force: motions whose peaks differ by less are the same */

/* Title and detail --------------------------------------------------------------------------------------------------*/

static const char *title_lately(const MachineKind *kind, const MachineNow *now, const MachineLately *lately,
                                Arena *arena) {
    if (now->status != CYCLE_GOOD)
        return now->status == CYCLE_CHATTERS ? "Chatter" : now->status == CYCLE_STIFF ? "Too stiff" : "Runs away";
    if (lately->period > 0)
        return machine_words_periodic(kind, (size_t)lately->period, lately->peaks.count > 0, arena);
    bool decided = lately->period == SECTION_NONE && lately->cycles >= MACHINE_ANSWER_LATELY;
    return decided ? "No rhythm so far" : "Settling ...";
}

/* True if the running motion has other hits or another rhythm than the motion from rest has in the end. */
static bool differs(const MachineLately *lately, const MachineVerdict *verdict) {
    if (verdict->facts.verdict == RESPONSE_CHAOTIC || verdict->facts.verdict == RESPONSE_QUASI_PERIODIC)
        return lately->period > 0;
    if (verdict->facts.verdict != RESPONSE_PERIODIC || (size_t)lately->period != verdict->facts.period)
        return verdict->facts.verdict == RESPONSE_PERIODIC;
    return fabs(lately->peaks.max - verdict->facts.peaks.max) >
           ALIKE * fmax(lately->peaks.max, verdict->facts.peaks.max);
}

/* True if the running motion differs from the motion from rest for good. */
static bool is_another(const MachineLately *lately, const MachineVerdict *verdict) {
    return lately->cycles >= SETTLED && lately->period != SECTION_UNDECIDED && differs(lately, verdict);
}

/* True if the picture still shows another motion than the answer tells of, which is that of the long run. */
static bool is_settling(const MachineLately *lately, const MachineVerdict *verdict) {
    return lately->cycles < SETTLED && response_is_told(verdict->facts.verdict) &&
           (verdict->facts.verdict != RESPONSE_PERIODIC || differs(lately, verdict));
}

/* Returns how the motion that is running now goes on; "": not known yet. */
static const char *rhythm_lately(const MachineKind *kind, const MachineLately *lately, Arena *arena) {
    if (lately->period > 0)
        return machine_words_repeat(kind, (size_t)lately->period, arena);
    return lately->period == SECTION_NONE ? "no rhythm (not periodic)" : "";
}

/* Adds a clause to a detail, unless it is empty. */
static void add_clause(Text *detail, const char *between, const char *clause) {
    if (*clause)
        text_format(detail, "%s%s", detail->used ? between : "", clause);
}

static const char *another_words(const MachineKind *kind, const MachineLately *lately, Arena *arena) {
    Text text = {0};
    text_add(&text, "running now: ");
    text_add(&text, rhythm_lately(kind, lately, arena));
    add_clause(&text, ", ", machine_words_hits(kind, &lately->peaks, arena));
    const char *words = arena_text(arena, text.text);
    memory_free(text.text);
    return words;
}

/* Writes the clauses of the detail, the most important ones first: the window leaves out the last ones. */
static void write_detail(MachineAnswer *answer, const MachineNow *now, const MachineLately *lately,
                         const MachineVerdict *verdict) {
    static const char between[] = " \u00b7 ";
    const MachineKind *kind = now->kind;
    Arena *arena = &answer->arena;
    Text text = {0};
    add_clause(&text, between, machine_words_hits(kind, verdict ? &verdict->facts.peaks : &lately->peaks, arena));
    add_clause(&text, ", ",
               verdict ? machine_words_rhythm(kind, &verdict->facts, arena) : rhythm_lately(kind, lately, arena));
    if (verdict && is_another(lately, verdict))
        add_clause(&text, between, another_words(kind, lately, arena));
    else if (verdict && is_settling(lately, verdict))
        add_clause(&text, between, "in the long run; it still settles");
    if (verdict && verdict->typed)
        add_clause(&text, between, machine_words_type(verdict->type));
    add_clause(&text, between, now->where);
    answer->result.detail = arena_text(arena, text.text);
    memory_free(text.text);
}

/* Rows --------------------------------------------------------------------------------------------------------------*/

static void add_row(MachineAnswer *answer, RowKind kind, const char *first, const char *second) {
    answer->rows = memory_reserve(answer->rows, &answer->row_capacity, answer->row_count + 1, sizeof *answer->rows);
    PanelRow *row = &answer->rows[answer->row_count++];
    *row = (PanelRow){.row = {.kind = kind, .role = ROLE_TEXT, .cells = {first, second}}, .time = NAN};
}

/* Adds a row for each line of a text, or of NULL none. */
static void add_advice(MachineAnswer *answer, const char *advice) {
    for (const char *line = advice; line && *line; line += strcspn(line, "\n"), line += *line == '\n')
        add_row(answer, ROW_PLAIN, text_in_arena(&answer->arena, "%.*s", (int)strcspn(line, "\n"), line), NULL);
}

static void add_type(MachineAnswer *answer, const MachineVerdict *verdict) {
    if (!verdict->typed)
        return;
    add_row(answer, ROW_HEADING, machine_words_type_heading(verdict->type), NULL);
    add_advice(answer, verdict->advice);
}

static void add_fact(MachineAnswer *answer, const MachineKind *kind, const ResultRow *row) {
    Arena *arena = &answer->arena;
    SceneRow line;
    if (!result_panel_row(&line, row, arena))
        return;
    const char *value = arena_text(arena, line.cells[1]); /* the verdict may be released before the rows */
    add_row(answer, line.kind, machine_words_label(kind, row, arena), machine_words_value(value, arena));
}

static void add_peaks(MachineAnswer *answer, const MachineKind *kind, const SectionPeaks *peaks) {
    Arena *arena = &answer->arena;
    const ResultRow rows[] = {{.key = "peaks.min", .label = "", .number = peaks->min},
                              {.key = "peaks.mean", .label = "", .number = peaks->mean},
                              {.key = "peaks.max", .label = "", .number = peaks->max}};
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
        add_row(answer, ROW_PLAIN, machine_words_label(kind, &rows[i], arena),
                text_in_arena(arena, "%.0f N", rows[i].number));
}

/* Adds the facts that are single values. */
static void add_facts(MachineAnswer *answer, const MachineKind *kind, const ResultTable *facts) {
    for (size_t r = 0; r < facts->row_count; r++)
        if (result_at(facts, 0, r)->kind != RESULT_LIST)
            add_fact(answer, kind, result_at(facts, 0, r));
}

static void add_natural(MachineAnswer *answer, const MachineVerdict *verdict) {
    const ResultRow *list = result_find(&verdict->facts.forces, 0, "natural_frequencies");
    if (!list)
        return;
    add_row(answer, ROW_HEADING, "Its own tones", NULL);
    for (size_t i = 0; i < list->count && i < FREQUENCIES; i++) {
        ResultRow row = result_element(list, i, text_in_arena(&answer->arena, "natural frequency %zu", i + 1));
        add_fact(answer, verdict->kind, &row);
    }
}

/* Adds what was located on a followed orbit. */
static void add_lines(MachineAnswer *answer, const MachineLines *lines) {
    if (!lines || (!lines->period && !lines->why))
        return;
    Arena *arena = &answer->arena;
    add_row(answer, ROW_HEADING,
            lines->period ? text_in_arena(arena, "Followed (period %zu)", lines->period) : "Followed rhythm", NULL);
    if (!lines->period)
        add_row(answer, ROW_PLAIN, text_in_arena(arena, "%s.", lines->why), NULL);
    else if (!lines->located_count)
        add_row(answer, ROW_PLAIN, "It neither folds nor changes its stability.", NULL);
    for (size_t i = 0; i < lines->located_count; i++)
        add_row(answer, ROW_PLAIN, lines->located[i].kind,
                text_in_arena(arena, "%.6g, %.0f N", lines->located[i].value, lines->located[i].peak));
}

static void write_rows(MachineAnswer *answer, const MachineKind *kind, const MachineLately *lately,
                       const MachineVerdict *verdict) {
    Arena *arena = &answer->arena;
    answer->row_count = 0;
    if (!verdict) {
        add_row(answer, ROW_HEADING, "Running now", NULL);
        add_peaks(answer, kind, &lately->peaks);
        add_lines(answer, answer->lines);
        return;
    }
    add_type(answer, verdict);
    add_row(answer, ROW_HEADING, kind->from, NULL);
    if (verdict->facts.verdict == RESPONSE_CHAOTIC)
        add_row(answer, ROW_PLAIN, machine_words_drift(kind, verdict->facts.exponent.value, arena), NULL);
    add_advice(answer, verdict->facts.words);
    add_facts(answer, kind, &verdict->facts.motion);
    add_facts(answer, kind, &verdict->facts.forces);
    if (is_another(lately, verdict)) {
        add_row(answer, ROW_HEADING, "Another motion is running", NULL);
        add_row(answer, ROW_PLAIN, another_words(kind, lately, arena), NULL);
        add_row(answer, ROW_PLAIN, "The motion can depend on the initial state; \"Run again\" restarts it.", NULL);
    }
    add_lines(answer, answer->lines);
    add_natural(answer, verdict);
}

/* -------------------------------------------------------------------------------------------------------------------*/

void machine_answer_write(MachineAnswer *answer, const MachineNow *now, const MachineLately *lately,
                          const MachineVerdict *verdict) {
    bool failed = now->status != CYCLE_GOOD && !now->changed;
    arena_clear(&answer->arena);
    const char *title = failed || !verdict ? title_lately(now->kind, now, lately, &answer->arena)
                                           : machine_words_title(now->kind, &verdict->facts, &answer->arena);
    snprintf(answer->title, sizeof answer->title, "%s", title);
    write_detail(answer, now, lately, verdict);
    write_rows(answer, now->kind, lately, verdict);
    bool resolved = !verdict || response_is_told(verdict->facts.verdict);
    answer->result.title = answer->title;
    answer->result.role = failed || !resolved ? ROLE_ERROR : ROLE_TEXT;
    answer->result.stale = answer->result.due = !verdict && !failed;
}

void machine_answer_note_doing(MachineAnswer *answer, const MachineKind *kind, const MachineNews *news) {
    size_t size = sizeof answer->doing, done = news->sweep_done, all = news->sweep_all;
    answer->result.doing = answer->doing;
    answer->result.part = NAN;
    if (news->following) {
        snprintf(answer->doing, size, "following the rhythm");
    } else if (news->deciding) {
        snprintf(answer->doing, size, "finding out how it moves");
    } else if (news->map.all && (done >= all || done >= kind->before_type)) {
        snprintf(answer->doing, size, "map of types: %zu of %zu cells", news->map.done, news->map.all);
        answer->result.part = (double)news->map.done / (double)news->map.all;
    } else if (news->types_all) {
        snprintf(answer->doing, size, "safe or not: %zu of at most %zu runs", news->types_done, news->types_all);
        answer->result.part = (double)news->types_done / (double)news->types_all;
    } else if (done < all) {
        snprintf(answer->doing, size, "all rhythms: %zu of %zu values", done, all);
        answer->result.part = (double)done / (double)all;
    } else if (news->confirming) {
        snprintf(answer->doing, size, "making sure: %zu motions are watched", kind->lanes);
    } else if (news->bands_all) {
        snprintf(answer->doing, size, "safe or not, along the diagram: %zu of %zu", news->bands.count, news->bands_all);
        answer->result.part = (double)news->bands.count / (double)news->bands_all;
    } else {
        *answer->doing = 0;
        answer->result.doing = NULL;
    }
}

void machine_answer_clear(MachineAnswer *answer) {
    memory_free(answer->rows);
    arena_clear(&answer->arena);
}
