#include "laboratory/beam/answer.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "result/panel.h"

enum {
    SETTLED = 100,   /* cycles after a change before the motion is reported to differ from the motion from rest */
    FREQUENCIES = 6, /* natural frequencies in the answer */
};

static const double ALIKE = 0.02; /* 1, share of the largest force: motions whose peaks differ by less are the same */

BeamLately beam_answer_look(const BeamTape *tape) {
    double deflection[BEAM_ANSWER_LATELY], velocity[BEAM_ANSWER_LATELY], peak[2 * BEAM_ANSWER_LATELY];
    const BeamPart *part = tape->parts[tape->part_count - 1];
    size_t first = part->first > tape->first ? part->first : tape->first;
    BeamLately lately = {.cycles = tape->front - part->first};
    size_t count = tape->front - first < BEAM_ANSWER_LATELY ? tape->front - first : BEAM_ANSWER_LATELY;
    for (size_t i = 0; i < count; i++) {
        const BeamCycle *cycle = beam_tape_cycle(tape, tape->front - count + i);
        const BeamCycle *next = beam_tape_cycle(tape, tape->front - count + i + 1);
        deflection[i] = next->deflection;
        velocity[i] = next->velocity;
        memcpy(peak + 2 * i, cycle->peak, sizeof cycle->peak);
    }
    size_t last = count / 2; /* assumed settled part of a motion that settles */
    lately.peaks = section_peaks(&(Section){.count = count - last, .peak = peak + 2 * last});
    lately.period = section_period(deflection, velocity, count, part->rig.omega, rig_rest_deflection(&part->rig));
    return lately;
}

/* Title and detail --------------------------------------------------------------------------------------------------*/

static void title_periodic(char *title, size_t size, size_t period, size_t contacts) {
    if (!contacts)
        snprintf(title, size, "No contact");
    else
        snprintf(title, size, "Periodic, period %zu", period);
}

static void title_lately(BeamAnswer *answer, const BeamTape *tape, const BeamLately *lately) {
    size_t size = sizeof answer->title;
    if (tape->status != CYCLE_GOOD)
        snprintf(answer->title, size, tape->status == CYCLE_CHATTERS ? "Chatter" : "Diverged");
    else if (lately->period > 0)
        title_periodic(answer->title, size, (size_t)lately->period, lately->peaks.count);
    else if (lately->period == SECTION_NONE && lately->cycles >= BEAM_ANSWER_LATELY)
        snprintf(answer->title, size, "Not periodic so far");
    else
        snprintf(answer->title, size, "Settling ...");
}

static void title_verdict(BeamAnswer *answer, const BeamVerdict *verdict) {
    static const char *const titles[] = {[RESPONSE_PERIODIC] = "",
                                         [RESPONSE_QUASI_PERIODIC] = "Quasi-periodic",
                                         [RESPONSE_CHAOTIC] = "Chaotic",
                                         [RESPONSE_TRANSIENT] = "Transient",
                                         [RESPONSE_UNDETERMINED] = "Undetermined",
                                         [RESPONSE_CHATTERS] = "Chatter",
                                         [RESPONSE_DIVERGED] = "Diverged",
                                         [RESPONSE_INTERRUPTED] = "Interrupted"};
    if (verdict->verdict == RESPONSE_PERIODIC)
        title_periodic(answer->title, sizeof answer->title, verdict->period, verdict->peaks.count);
    else
        snprintf(answer->title, sizeof answer->title, "%s", titles[verdict->verdict]);
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
static bool is_another(const BeamLately *lately, const BeamVerdict *verdict) {
    if (lately->cycles < SETTLED || lately->period == SECTION_UNDECIDED)
        return false;
    if (verdict->verdict == RESPONSE_CHAOTIC || verdict->verdict == RESPONSE_QUASI_PERIODIC)
        return lately->period > 0;
    if (verdict->verdict != RESPONSE_PERIODIC || (size_t)lately->period != verdict->period)
        return verdict->verdict == RESPONSE_PERIODIC;
    return fabs(lately->peaks.max - verdict->peaks.max) > ALIKE * fmax(lately->peaks.max, verdict->peaks.max);
}

static void format_another(const BeamLately *lately, char *text, size_t size) {
    char peaks[60];
    peaks_words(&lately->peaks, peaks, sizeof peaks);
    if (lately->period > 0)
        snprintf(text, size, "running now: period %d, %s", lately->period, peaks);
    else
        snprintf(text, size, "running now: not periodic, %s", peaks);
}

static void write_detail(BeamAnswer *answer, const Beam *beam, const BeamLately *lately, const BeamVerdict *verdict) {
    char type[40] = "", peaks[60], exponent[60] = "", another[100] = "";
    peaks_words(verdict ? &verdict->peaks : &lately->peaks, peaks, sizeof peaks);
    if (verdict && verdict->typed)
        snprintf(type, sizeof type, verdict->type == TYPES_UNRESOLVED ? "type undecided   " : "type %s   ",
                 types_kind_name(verdict->type));
    if (verdict && verdict->verdict == RESPONSE_CHAOTIC)
        snprintf(exponent, sizeof exponent, "   lyapunov %+.2f per cycle", verdict->exponent.value);
    if (verdict && is_another(lately, verdict)) {
        strcpy(another, "   ");
        format_another(lately, another + 3, sizeof another - 3);
    }
    answer->result.detail = text_in_arena(&answer->arena, "%s%s%s   %.1f Hz, gap %.3g mm%s", type, peaks, exponent,
                                          beam->frequency, 1000 * beam->clearance, another);
}

/* Rows --------------------------------------------------------------------------------------------------------------*/

static void add_row(BeamAnswer *answer, RowKind kind, const char *first, const char *second) {
    answer->rows = memory_reserve(answer->rows, &answer->row_capacity, answer->row_count + 1, sizeof *answer->rows);
    PanelRow *row = &answer->rows[answer->row_count++];
    *row = (PanelRow){.row = {.kind = kind, .role = ROLE_TEXT, .cells = {first, second}}, .time = NAN};
}

/* Adds a row for each line of the advice. */
static void add_advice(BeamAnswer *answer, const char *advice) {
    for (const char *line = advice; line && *line; line += strcspn(line, "\n"), line += *line == '\n')
        add_row(answer, ROW_PLAIN, text_in_arena(&answer->arena, "%.*s", (int)strcspn(line, "\n"), line), NULL);
}

static void add_type(BeamAnswer *answer, const BeamVerdict *verdict) {
    if (!verdict->typed)
        return;
    const char *heading = verdict->type == TYPES_UNRESOLVED
                              ? "Type undecided"
                              : text_in_arena(&answer->arena, "Type %s", types_kind_name(verdict->type));
    add_row(answer, ROW_HEADING, heading, NULL);
    add_advice(answer, verdict->advice);
}

static void add_peaks(BeamAnswer *answer, const SectionPeaks *peaks) {
    Arena *arena = &answer->arena;
    add_row(answer, ROW_PLAIN, "smallest peak", text_in_arena(arena, "%.0f N", peaks->min));
    add_row(answer, ROW_PLAIN, "mean peak", text_in_arena(arena, "%.0f N", peaks->mean));
    add_row(answer, ROW_PLAIN, "largest peak", text_in_arena(arena, "%.0f N", peaks->max));
}

static void add_fact(BeamAnswer *answer, const ResultRow *row) {
    SceneRow line;
    if (!result_panel_row(&line, row, &answer->arena))
        return;
    line.cells[1] = arena_text(&answer->arena, line.cells[1]); /* the verdict may be released before the rows */
    add_row(answer, line.kind, line.cells[0], line.cells[1]);
}

/* Adds the facts that are single values. */
static void add_facts(BeamAnswer *answer, const ResultTable *facts) {
    for (size_t r = 0; r < facts->row_count; r++)
        if (result_at(facts, 0, r)->kind != RESULT_LIST)
            add_fact(answer, result_at(facts, 0, r));
}

static void add_natural(BeamAnswer *answer, const BeamVerdict *verdict) {
    const ResultRow *list = result_find(&verdict->forces, 0, "natural_frequencies");
    add_row(answer, ROW_HEADING, "Natural frequencies", NULL);
    for (size_t i = 0; i < list->count && i < FREQUENCIES; i++) {
        ResultRow row = result_element(list, i, text_in_arena(&answer->arena, "mode %zu", i + 1));
        add_fact(answer, &row);
    }
}

static void write_rows(BeamAnswer *answer, const BeamLately *lately, const BeamVerdict *verdict) {
    answer->row_count = 0;
    if (!verdict) {
        add_row(answer, ROW_HEADING, "Running now", NULL);
        add_peaks(answer, &lately->peaks);
        return;
    }
    add_type(answer, verdict);
    add_row(answer, ROW_HEADING, "From rest", NULL);
    add_facts(answer, &verdict->motion);
    add_facts(answer, &verdict->forces);
    if (is_another(lately, verdict)) {
        char text[100];
        format_another(lately, text, sizeof text);
        add_row(answer, ROW_HEADING, "Another motion is running", NULL);
        add_row(answer, ROW_PLAIN, arena_text(&answer->arena, text), NULL);
        add_row(answer, ROW_PLAIN, "The motion can depend on the initial state; \"Run again\" starts from rest.", NULL);
    }
    add_natural(answer, verdict);
}

/* -------------------------------------------------------------------------------------------------------------------*/

void beam_answer_write(BeamAnswer *answer, const BeamTape *tape, const Beam *beam, const BeamLately *lately,
                       const BeamVerdict *verdict) {
    bool failed = tape->status != CYCLE_GOOD && !tape->next;
    if (failed || !verdict)
        title_lately(answer, tape, lately);
    else
        title_verdict(answer, verdict);
    arena_clear(&answer->arena);
    write_detail(answer, beam, lately, verdict);
    write_rows(answer, lately, verdict);
    bool resolved = !verdict || response_is_told(verdict->verdict);
    answer->result.title = answer->title;
    answer->result.role = failed || !resolved ? ROLE_ERROR : ROLE_TEXT;
    answer->result.stale = !verdict && !failed;
}

void beam_answer_clear(BeamAnswer *answer) {
    memory_free(answer->rows);
    arena_clear(&answer->arena);
}

const char *beam_answer_error(const BeamTape *tape, Arena *arena) {
    if (tape->status == CYCLE_CHATTERS)
        return text_in_arena(arena,
                             "In cycle %zu the tip switches more than %d times, and the run ends: use more contact "
                             "damping, a softer contact or a larger gap",
                             tape->front + 1, MOTION_SWITCHES_MOST);
    return text_in_arena(arena,
                         "In cycle %zu the motion grows without bound, and the run ends: use more damping of the "
                         "modes, less force or another excitation",
                         tape->front + 1);
}
