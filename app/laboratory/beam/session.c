#include "laboratory/beam/session.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/clock.h"
#include "base/parameters_number.h"
#include "base/text.h"
#include "experiment/beam_numbers.h"
#include "laboratory/beam/show.h"
#include "laboratory/save_file.h"
#include "visual/beam/beam_film.h"

#define BUSY_MOST 2e-3 /* s, that the motion is followed at a time */

enum { STEPS = 60 /* a cycle, from picture to picture */ };

/* Records one more cycle, or notes why the record has ended. */
static void advance(BeamSession *live) {
    live->news |= live->tape.next ? LABORATORY_WORDS : 0;
    if (beam_tape_advance(&live->tape))
        return;
    arena_clear(&live->troubles);
    live->trouble = beam_answer_trouble(&live->tape, &live->troubles);
    live->looked = SIZE_MAX;
    live->news |= LABORATORY_TROUBLE | LABORATORY_WORDS;
}

/* Changes ----------------------------------------------------------------------------------------------------------*/

static const char *const sweeps[] = {"from rest", "upwards and downwards"};

enum { CHOICE_SWEEP, CHOICE_OVER, CHOICES };

static void show_choices(BeamSession *live) {
    live->choices[CHOICE_SWEEP] = (PanelChoice){.name = "Sweep",
                                                .meaning = "how each value of the orbit diagram begins: at rest, or "
                                                           "from where the value beside it has ended",
                                                .words = sweeps,
                                                .count = sizeof sweeps / sizeof *sweeps,
                                                .chosen = live->diagram.carried};
    live->choices[CHOICE_OVER] = (PanelChoice){.name = "Orbit over",
                                               .meaning = "the number that the orbit diagram goes over",
                                               .words = beam_diagram_words,
                                               .count = BEAM_DIAGRAM_OVER,
                                               .chosen = live->diagram.over};
}

static void ask_worker(BeamSession *live, bool verdict) {
    live->news |= LABORATORY_WORDS | LABORATORY_PARAMETERS;
    live->looked = SIZE_MAX;
    live->told = live->told && beam_numbers_same(&live->verdict.beam, &live->beam);
    beam_controls_show(&live->controls, &live->beam);
    beam_diagram_ask(&live->diagram, &live->controls, &live->beam, live->worker);
    if (verdict)
        beam_worker_ask_verdict(live->worker, &live->beam);
}

/* From the end of the cycle that is shown on, the beam is this one. */
static bool change(BeamSession *live, const Beam *beam, Fault *fault) {
    BeamTape *tape = &live->tape;
    double phase;
    if (beam_numbers_same(beam, &live->beam))
        return true;
    size_t cycle = beam_tape_cycle_at(tape, live->shown, &phase) + 1;
    if (!beam_tape_change(tape, beam, cycle < tape->front ? cycle : tape->front, fault))
        return false;
    live->beam = *beam;
    ask_worker(live, true);
    return true;
}

static const PanelParameter *parameters(const void *context, size_t *count) {
    const BeamSession *live = context;
    *count = live->controls.count;
    return live->controls.parameters;
}

static bool set_number(void *context, const char *name, double value, Fault *fault) {
    BeamSession *live = context;
    Beam beam = live->beam;
    return beam_controls_set(&live->controls, &beam, name, value, fault) && change(live, &beam, fault);
}

static void reset_numbers(void *context) {
    BeamSession *live = context;
    Fault none = {0};
    change(live, &live->controls.file, &none);
    fault_clear(&none);
}

static const Preset *presets(const void *context, size_t *count) {
    const BeamSession *live = context;
    *count = BEAM_PRESETS;
    return live->controls.presets;
}

static void prefer(void *context, size_t preset) {
    BeamSession *live = context;
    Beam beam;
    Fault none = {0};
    beam_controls_prefer(&live->controls, preset, &beam);
    change(live, &beam, &none);
    fault_clear(&none);
}

static const PanelChoice *choices(void *context, size_t *count) {
    *count = CHOICES;
    return ((const BeamSession *)context)->choices;
}

static void choose(void *context, size_t choice, size_t word) {
    BeamSession *live = context;
    if (choice == CHOICE_SWEEP)
        live->diagram.carried = word == 1;
    else
        live->diagram.over = word;
    show_choices(live);
    ask_worker(live, false);
}

static void again(void *context) {
    BeamSession *live = context;
    Fault none = {0};
    if (beam_tape_restart(&live->tape, &live->beam, &none)) {
        advance(live);
        beam_traces_forget(&live->traces, 0);
        live->shown = 0;
        live->looked = SIZE_MAX;
        live->news |= LABORATORY_WORDS;
    }
    fault_clear(&none);
}

static bool keep(void *context, double time) {
    BeamSession *live = context;
    beam_traces_keep(&live->traces, time);
    beam_diagram_keep(&live->diagram, true);
    return true;
}

static void clear(void *context, double time) {
    BeamSession *live = context;
    double phase;
    beam_traces_keep(&live->traces, -1);
    beam_diagram_keep(&live->diagram, false);
    beam_traces_forget(&live->traces, beam_tape_cycle_at(&live->tape, time, &phase));
    beam_traces_show(&live->traces, &live->tape, time);
}

static const char *const *command(void *context, size_t *count) {
    BeamSession *live = context;
    size_t used = 0;
    arena_clear(&live->command_words);
    live->command[used++] = "run";
    live->command[used++] = live->path;
    for (size_t i = 0; i < live->controls.count; i++) {
        const PanelParameter *parameter = &live->controls.parameters[i];
        if (parameter->value == parameter->initial)
            continue;
        const char *value = parameters_number_text(parameter->row, parameter->value, &live->command_words);
        live->command[used++] = "--set";
        live->command[used++] = text_in_arena(&live->command_words, "%s=%s", parameter->name, value);
    }
    *count = used;
    return live->command;
}

/* Opening -----------------------------------------------------------------------------------------------------------*/

static bool read_files(BeamSession *live, const char *path, const LaboratoryOptions *options, Fault *fault) {
    Beam file = {0};
    if (!beam_read(&live->opened, path, options->settings, options->setting_count, fault))
        return false;
    if (!beam_read(&file, path, NULL, 0, fault)) {
        beam_free(&live->opened);
        return false;
    }
    live->beam = live->opened;
    beam_controls_open(&live->controls, &file);
    beam_controls_show(&live->controls, &live->beam);
    return true;
}

/* The answer goes with the record. */
static void look_at_answer(BeamSession *live) {
    if (live->looked == live->tape.front)
        return;
    live->looked = live->tape.front;
    BeamLately lately = beam_answer_look(&live->tape);
    beam_answer_write(&live->answer, &live->tape, &live->beam, &lately, live->told ? &live->verdict : NULL);
    live->news |= LABORATORY_WORDS;
}

static void *open_live(const char *path, const LaboratoryOptions *options, Fault *fault) {
    BeamSession *live = memory_zeroed(1, sizeof *live);
    if (!read_files(live, path, options, fault)) {
        memory_free(live);
        return NULL;
    }
    if (!beam_tape_open(&live->tape, &live->beam, path, fault)) {
        beam_controls_close(&live->controls);
        beam_free(&live->opened);
        memory_free(live);
        return NULL;
    }
    live->path = text_copy(path);
    live->tape.place = live->opened.name;
    live->view.parts = BEAM_SCENE_ALL & ~BEAM_SCENE_SOURCES;
    beam_traces_open(&live->traces);
    beam_diagram_open(&live->diagram);
    live->worker = beam_worker_start(options->jobs);
    show_choices(live);
    live->news = LABORATORY_ALL & ~LABORATORY_TROUBLE;
    advance(live);
    ask_worker(live, true);
    look_at_answer(live);
    return live;
}

static void close_live(void *context) {
    BeamSession *live = context;
    beam_worker_stop(live->worker);
    beam_traces_close(&live->traces);
    beam_diagram_close(&live->diagram);
    beam_view_close(&live->view);
    beam_tape_close(&live->tape);
    beam_answer_clear(&live->answer);
    beam_verdict_clear(&live->verdict);
    beam_controls_close(&live->controls);
    beam_free(&live->opened);
    arena_clear(&live->command_words);
    arena_clear(&live->troubles);
    memory_free(live->path);
    memory_free(live);
}

/* Time --------------------------------------------------------------------------------------------------------------*/

static RecordSpan span(const void *context) {
    const BeamSession *live = context;
    const BeamTape *tape = &live->tape;
    double frequency = live->beam.frequency;
    return (RecordSpan){.begin = beam_tape_begin(tape, tape->first),
                        .end = tape->front_time,
                        .complete = beam_session_has_ended(live),
                        .endless = !beam_session_has_ended(live),
                        .pace = 1 / beam_film_slow(frequency),
                        .step = 1 / frequency / STEPS,
                        .fastest = 1024};
}

static double reach(void *context, double time) {
    BeamSession *live = context;
    BeamTape *tape = &live->tape;
    double until = clock_now() + BUSY_MOST;
    while (tape->front_time <= time && !beam_session_has_ended(live)) {
        advance(live);
        if (clock_now() > until)
            break;
    }
    return tape->front_time;
}

static bool show(void *context, double time) {
    BeamSession *live = context;
    live->shown = time;
    bool anew = beam_view_show(&live->view, &live->tape, time);
    beam_traces_show(&live->traces, &live->tape, time);
    if (anew)
        live->news |= LABORATORY_VIEW;
    return !anew;
}

/* Answer ------------------------------------------------------------------------------------------------------------*/

static void take_news(BeamSession *live, BeamNews *news) {
    if (news->verdict && beam_numbers_same(&news->told.beam, &live->beam)) {
        beam_verdict_clear(&live->verdict);
        live->verdict = news->told;
        live->told = true;
        live->looked = SIZE_MAX;
        bool typed = live->verdict.typed && live->verdict.type != TYPES_UNRESOLVED;
        if (typed && beam_controls_name_type(&live->controls, &live->verdict.beam, types_kind_name(live->verdict.type)))
            live->news |= LABORATORY_PARAMETERS;
    } else if (news->verdict) {
        beam_verdict_clear(&news->told);
    }
    if (news->swept)
        beam_diagram_take(&live->diagram, news);
}

/* What is being worked out, if anything. */
static void note_doing(BeamSession *live, const BeamNews *news) {
    BeamAnswer *answer = &live->answer;
    size_t size = sizeof answer->doing, done = news->sweep_done, all = news->sweep_all;
    answer->live.doing = answer->doing;
    answer->live.part = NAN;
    if (news->telling) {
        snprintf(answer->doing, size, "verdict: running it from rest");
    } else if (news->types_all) {
        snprintf(answer->doing, size, "type: %zu of at most %zu runs", news->types_done, news->types_all);
        answer->live.part = (double)news->types_done / (double)news->types_all;
    } else if (done < all) {
        snprintf(answer->doing, size, "orbit diagram: %zu of %zu values", done, all);
        answer->live.part = (double)done / (double)all;
    } else {
        *answer->doing = 0;
        answer->live.doing = NULL;
    }
}

static unsigned update(void *context, double time) {
    (void)time;
    BeamSession *live = context;
    BeamNews news;
    beam_worker_take(live->worker, &news);
    take_news(live, &news);
    look_at_answer(live);
    char before[sizeof live->answer.doing];
    memcpy(before, live->answer.doing, sizeof before);
    note_doing(live, &news);
    if (strcmp(before, live->answer.doing) != 0)
        live->news |= LABORATORY_WORDS;
    unsigned changed = live->news;
    live->news = 0;
    return changed;
}

static Result answer(void *context) {
    return ((const BeamSession *)context)->answer.live;
}

static const PanelRow *rows(const void *context, size_t *count) {
    const BeamSession *live = context;
    *count = live->answer.row_count;
    return live->answer.rows;
}

static const char *clock_words(void *context, double time) {
    BeamSession *live = context;
    double phase;
    size_t cycle = beam_tape_cycle_at(&live->tape, time, &phase);
    snprintf(live->clock, sizeof live->clock, "cycle %zu, %.3f s", cycle + 1, time);
    return live->clock;
}

static const char *note(void *context) {
    const BeamSession *live = context;
    for (int i = 0; i < BEAM_VALUES; i++)
        if (live->opened.provenance[i] && strstr(live->opened.provenance[i], "not published"))
            return "identified, not published";
    return "";
}

static const char *title(const void *context) {
    return ((const BeamSession *)context)->opened.name;
}

static const TimelineMark *ticks(void *context, size_t *count) {
    BeamSession *live = context;
    const BeamTape *tape = &live->tape;
    *count = 0;
    for (size_t p = 1; p < tape->part_count; p++)
        live->ticks[(*count)++] = (TimelineMark){tape->parts[p]->begin, TIMELINE_CHANGE};
    if (beam_session_has_ended(live))
        live->ticks[(*count)++] = (TimelineMark){tape->front_time, TIMELINE_TROUBLE};
    return live->ticks;
}

static const char *trouble(const void *context, double *time) {
    const BeamSession *live = context;
    *time = live->tape.front_time;
    return beam_session_has_ended(live) ? live->trouble : NULL;
}

static const char *const layer_names[] = {"loupe", "forces", "names", "sources"};
static const char *const layer_meanings[] = {"the tip between its stops, enlarged",
                                             "the shaker's force, and those of the stops", "what the parts are called",
                                             "below each name its numbers, and where they come from"};

/* Nothing in the picture can be selected. */

static Item pick(const void *context, Vec2 at, double time, Item below) {
    (void)context, (void)at, (void)time, (void)below;
    return (Item){0};
}

static Item next(const void *context, Item thing, int step) {
    (void)context, (void)thing, (void)step;
    return (Item){0};
}

static void select_thing(void *context, Item thing) {
    (void)context, (void)thing;
}

static Item selected(void *context) {
    (void)context;
    return (Item){0};
}

static const char *name_thing(void *context, Item thing) {
    (void)context, (void)thing;
    return "";
}

static size_t outline(const void *context, Item thing, double time, Vec2 *points) {
    (void)context, (void)thing, (void)time, (void)points;
    return 0;
}

static bool save(void *context, const char *path, Fault *fault) {
    size_t count;
    const char *const *words = command(context, &count);
    return save_file_beam(words, count, path, fault);
}

const Laboratory beam_laboratory = {
    .name = "Beam",
    .word = "beam",
    .plots_at_first = "phase,orbit,force,poincare,spectrum",
    .numbers_first = true,
    .layers = layer_names,
    .meanings = layer_meanings,
    .layer_count = sizeof layer_names / sizeof *layer_names,
    .layers_at_first = BEAM_SCENE_ALL & ~BEAM_SCENE_SOURCES,
    .open = open_live,
    .close = close_live,
    .update = update,
    .span = span,
    .reach = reach,
    .show = show,
    .still = beam_show_still,
    .added = beam_show_added,
    .moving = beam_show_moving,
    .look = beam_show_look,
    .reveal = beam_show_reveal,
    .plot_count = beam_show_plot_count,
    .plot = beam_show_plot,
    .until = beam_show_until,
    .answer = answer,
    .clock = clock_words,
    .note = note,
    .title = title,
    .rows = rows,
    .ticks = ticks,
    .trouble = trouble,
    .parameters = parameters,
    .set = set_number,
    .reset = reset_numbers,
    .presets = presets,
    .prefer = prefer,
    .choices = choices,
    .choose = choose,
    .again = again,
    .keep = keep,
    .clear = clear,
    .pick = pick,
    .next = next,
    .select = select_thing,
    .selected = selected,
    .name_thing = name_thing,
    .outline = outline,
    .command = command,
    .save = save,
    .sound = beam_show_sound,
};
