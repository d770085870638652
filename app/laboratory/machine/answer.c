#include "laboratory/machine/answer.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "result/panel.h"

enum {
    SETTLED = 100,   /* cycles after a change before the motion is reported to differ from the motion from rest */
    FREQUENCIES = 6, /* natural frequencies in the answer */
};

static const double ALIKE = 0.02; /* 1, share of the largest force: motions whose peaks differ by less are the same */

/* Title and detail --------------------------------------------------------------------------------------------------*/

static void title_periodic(char *title, size_t size, size_t period, size_t contacts) {
    if (!contacts)
        snprintf(title, size, "No contact");
    else
        snprintf(title, size, "Periodic, period %zu", period);
}

static void title_lately(MachineAnswer *answer, const MachineNow *now, const MachineLately *lately) {
    size_t size = sizeof answer->title;
    if (now->status != CYCLE_GOOD)
        snprintf(answer->title, size, "%s",
                 now->status == CYCLE_CHATTERS ? "Chatter"
                 : now->status == CYCLE_STIFF  ? "Too stiff"
                                               : "Diverged");
    else if (lately->period > 0)
        title_periodic(answer->title, size, (size_t)lately->period, lately->peaks.count);
    else if (lately->period == SECTION_NONE && lately->cycles >= MACHINE_ANSWER_LATELY)
        snprintf(answer->title, size, "Not periodic so far");
    else
        snprintf(answer->title, size, "Settling ...");
}

static void title_verdict(MachineAnswer *answer, const MachineVerdict *verdict) {
    static const char *const titles[] = {[RESPONSE_PERIODIC] = "",
                                         [RESPONSE_QUASI_PERIODIC] = "Quasi-periodic",
                                         [RESPONSE_CHAOTIC] = "Chaotic",
                                         [RESPONSE_TRANSIENT] = "Transient",
                                         [RESPONSE_UNDETERMINED] = "Undetermined",
                                         [RESPONSE_CHATTERS] = "Chatter",
                                         [RESPONSE_DIVERGED] = "Diverged",
                                         [RESPONSE_STIFF] = "Too stiff",
                                         [RESPONSE_INTERRUPTED] = "Interrupted"};
    if (verdict->facts.verdict == RESPONSE_PERIODIC)
        title_periodic(answer->title, sizeof answer->title, verdict->facts.period, verdict->facts.peaks.count);
    else
        snprintf(answer->title, sizeof answer->title, verdict->facts.quick ? "%s (quick)" : "%s",
                 titles[verdict->facts.verdict]);
}

static void peaks_words(const SectionPeaks *peaks, char *text, size_t size) {
    if (!peaks->count)
        snprintf(text, size, "no contact");
    else if (peaks->max - peaks->min < 0.5)
        snprintf(text, size, "peaks %.0f N", peaks->max);
    else
        snprintf(text, size, "peaks %.0f-%.0f N", peaks->min, peaks->max);
}

/* True if the running motion differs from the motion from rest. */
static bool is_another(const MachineLately *lately, const MachineVerdict *verdict) {
    if (lately->cycles < SETTLED || lately->period == SECTION_UNDECIDED)
        return false;
    if (verdict->facts.verdict == RESPONSE_CHAOTIC || verdict->facts.verdict == RESPONSE_QUASI_PERIODIC)
        return lately->period > 0;
    if (verdict->facts.verdict != RESPONSE_PERIODIC || (size_t)lately->period != verdict->facts.period)
        return verdict->facts.verdict == RESPONSE_PERIODIC;
    return fabs(lately->peaks.max - verdict->facts.peaks.max) >
           ALIKE * fmax(lately->peaks.max, verdict->facts.peaks.max);
}

static void format_another(const MachineLately *lately, char *text, size_t size) {
    char peaks[60];
    peaks_words(&lately->peaks, peaks, sizeof peaks);
    if (lately->period > 0)
        snprintf(text, size, "running now: period %d, %s", lately->period, peaks);
    else
        snprintf(text, size, "running now: not periodic, %s", peaks);
}

static void write_detail(MachineAnswer *answer, const MachineNow *now, const MachineLately *lately,
                         const MachineVerdict *verdict) {
    char type[40] = "", peaks[60], exponent[60] = "", another[100] = "";
    peaks_words(verdict ? &verdict->facts.peaks : &lately->peaks, peaks, sizeof peaks);
    if (verdict && verdict->typed)
        snprintf(type, sizeof type, verdict->type == TYPES_UNRESOLVED ? "type undecided   " : "type %s   ",
                 types_kind_name(verdict->type));
    if (verdict && verdict->facts.verdict == RESPONSE_CHAOTIC)
        snprintf(exponent, sizeof exponent, "   Lyapunov %+.2f per %s", verdict->facts.exponent.value,
                 verdict->kind->cycle);
    if (verdict && is_another(lately, verdict)) {
        strcpy(another, "   ");
        format_another(lately, another + 3, sizeof another - 3);
    }
    answer->result.detail = text_in_arena(&answer->arena, "%s%s%s   %s%s", type, peaks, exponent, now->where, another);
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
    const char *heading = verdict->type == TYPES_UNRESOLVED
                              ? "Type undecided"
                              : text_in_arena(&answer->arena, "Type %s", types_kind_name(verdict->type));
    add_row(answer, ROW_HEADING, heading, NULL);
    add_advice(answer, verdict->advice);
}

static void add_peaks(MachineAnswer *answer, const SectionPeaks *peaks) {
    Arena *arena = &answer->arena;
    add_row(answer, ROW_PLAIN, "smallest peak", text_in_arena(arena, "%.0f N", peaks->min));
    add_row(answer, ROW_PLAIN, "mean peak", text_in_arena(arena, "%.0f N", peaks->mean));
    add_row(answer, ROW_PLAIN, "largest peak", text_in_arena(arena, "%.0f N", peaks->max));
}

static void add_fact(MachineAnswer *answer, const ResultRow *row) {
    SceneRow line;
    if (!result_panel_row(&line, row, &answer->arena))
        return;
    line.cells[1] = arena_text(&answer->arena, line.cells[1]); /* the verdict may be released before the rows */
    add_row(answer, line.kind, line.cells[0], line.cells[1]);
}

/* Adds the facts that are single values. */
static void add_facts(MachineAnswer *answer, const ResultTable *facts) {
    for (size_t r = 0; r < facts->row_count; r++)
        if (result_at(facts, 0, r)->kind != RESULT_LIST)
            add_fact(answer, result_at(facts, 0, r));
}

static void add_natural(MachineAnswer *answer, const MachineVerdict *verdict) {
    const ResultRow *list = result_find(&verdict->facts.forces, 0, "natural_frequencies");
    if (!list)
        return;
    add_row(answer, ROW_HEADING, "Natural frequencies", NULL);
    for (size_t i = 0; i < list->count && i < FREQUENCIES; i++) {
        ResultRow row = result_element(list, i, text_in_arena(&answer->arena, "mode %zu", i + 1));
        add_fact(answer, &row);
    }
}

/* Adds what was located on a followed orbit. */
static void add_lines(MachineAnswer *answer, const MachineLines *lines) {
    if (!lines || (!lines->period && !lines->why))
        return;
    Arena *arena = &answer->arena;
    add_row(answer, ROW_HEADING,
            lines->period ? text_in_arena(arena, "Followed orbit, period %zu", lines->period) : "Followed orbit", NULL);
    if (!lines->period)
        add_row(answer, ROW_PLAIN, text_in_arena(arena, "%s.", lines->why), NULL);
    else if (!lines->located_count)
        add_row(answer, ROW_PLAIN, "It neither folds nor changes its stability.", NULL);
    for (size_t i = 0; i < lines->located_count; i++)
        add_row(answer, ROW_PLAIN, lines->located[i].kind,
                text_in_arena(arena, "%.6g, %.0f N", lines->located[i].value, lines->located[i].peak));
}

static void write_rows(MachineAnswer *answer, const MachineLately *lately, const MachineVerdict *verdict) {
    answer->row_count = 0;
    if (!verdict) {
        add_row(answer, ROW_HEADING, "Running now", NULL);
        add_peaks(answer, &lately->peaks);
        add_lines(answer, answer->lines);
        return;
    }
    add_type(answer, verdict);
    add_row(answer, ROW_HEADING, verdict->kind->from, NULL);
    add_advice(answer, verdict->facts.words);
    add_facts(answer, &verdict->facts.motion);
    add_facts(answer, &verdict->facts.forces);
    if (is_another(lately, verdict)) {
        char text[100];
        format_another(lately, text, sizeof text);
        add_row(answer, ROW_HEADING, "Another motion is running", NULL);
        add_row(answer, ROW_PLAIN, arena_text(&answer->arena, text), NULL);
        add_row(answer, ROW_PLAIN, "The motion can depend on the initial state; \"Run again\" restarts it.", NULL);
    }
    add_lines(answer, answer->lines);
    add_natural(answer, verdict);
}

/* -------------------------------------------------------------------------------------------------------------------*/

void machine_answer_write(MachineAnswer *answer, const MachineNow *now, const MachineLately *lately,
                          const MachineVerdict *verdict) {
    bool failed = now->status != CYCLE_GOOD && !now->changed;
    if (failed || !verdict)
        title_lately(answer, now, lately);
    else
        title_verdict(answer, verdict);
    arena_clear(&answer->arena);
    write_detail(answer, now, lately, verdict);
    write_rows(answer, lately, verdict);
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
        snprintf(answer->doing, size, "following the orbit");
    } else if (news->deciding) {
        snprintf(answer->doing, size, "finding the verdict");
    } else if (news->map.all && (done >= all || done >= kind->before_type)) {
        snprintf(answer->doing, size, "map of types: %zu of %zu cells", news->map.done, news->map.all);
        answer->result.part = (double)news->map.done / (double)news->map.all;
    } else if (news->types_all) {
        snprintf(answer->doing, size, "type: %zu of at most %zu runs", news->types_done, news->types_all);
        answer->result.part = (double)news->types_done / (double)news->types_all;
    } else if (done < all) {
        snprintf(answer->doing, size, "orbit diagram: %zu of %zu values", done, all);
        answer->result.part = (double)done / (double)all;
    } else if (news->confirming) {
        snprintf(answer->doing, size, "verdict: %zu motions are watched", kind->lanes);
    } else if (news->bands_all) {
        snprintf(answer->doing, size, "types along the diagram: %zu of %zu", news->bands.count, news->bands_all);
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
