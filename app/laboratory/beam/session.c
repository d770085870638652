#include "laboratory/beam/session.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/stopwatch.h"
#include "base/text.h"
#include "laboratory/beam/picture.h"
#include "laboratory/machine/item.h"
#include "laboratory/save_file.h"
#include "visual/beam/beam_film.h"

#define BUSY_MOST 2e-3 /* s, longest time for which the motion is computed without a pause */

enum { STEPS = 60 /* steps per cycle from frame to frame */ };

/* Records one more cycle, or stores the reason why the record has ended. */
static void advance(BeamSession *session) {
    session->news |= session->tape.next ? LABORATORY_TEXTS : 0;
    if (beam_tape_advance(&session->tape))
        return;
    arena_clear(&session->error_texts);
    session->error = beam_lately_error(&session->tape, &session->error_texts);
    session->looked = SIZE_MAX;
    session->news |= LABORATORY_ERROR | LABORATORY_TEXTS;
}

/* Changes ----------------------------------------------------------------------------------------------------------*/

static const char *const sweeps[] = {"from rest", "upwards and downwards"};

enum { CHOICE_SWEEP, CHOICE_OVER, CHOICES };

static void show_choices(BeamSession *session) {
    session->choices[CHOICE_SWEEP] =
        (PanelChoice){.name = "Sweep",
                      .meaning = "the initial state of each value of the orbit diagram: at "
                                 "rest, or the final state of the neighbouring value",
                      .options = sweeps,
                      .count = sizeof sweeps / sizeof *sweeps,
                      .chosen = session->diagram.carried};
    session->choices[CHOICE_OVER] = (PanelChoice){.name = "Orbit over",
                                                  .meaning = "the parameter that varies along the orbit diagram",
                                                  .options = beam_machine.over_words,
                                                  .count = beam_machine.over_count,
                                                  .chosen = session->diagram.over};
}

static void ask_worker(BeamSession *session, bool verdict) {
    session->news |= LABORATORY_TEXTS | LABORATORY_PARAMETERS;
    session->looked = SIZE_MAX;
    session->has_verdict =
        session->has_verdict && machine_same(&beam_machine, &session->verdict.machine, &session->now);
    machine_controls_show(&session->controls, &session->now);
    machine_diagram_ask(&session->diagram, &session->controls, &session->now, session->worker);
    if (verdict)
        machine_worker_ask_verdict(session->worker, &session->now);
}

/* Changes the beam from the end of the displayed cycle on. */
static bool change(BeamSession *session, const Machine *machine, Fault *fault) {
    BeamTape *tape = &session->tape;
    double phase;
    if (machine_same(&beam_machine, machine, &session->now))
        return true;
    size_t cycle = beam_tape_cycle_at(tape, session->shown, &phase) + 1;
    if (!beam_tape_change(tape, &machine->beam, cycle < tape->front ? cycle : tape->front, fault))
        return false;
    session->now = *machine;
    ask_worker(session, true);
    return true;
}

static const PanelParameter *parameters(const void *context, size_t *count) {
    const BeamSession *session = context;
    *count = session->controls.count;
    return session->controls.parameters;
}

static bool set_number(void *context, const char *name, double value, Fault *fault) {
    BeamSession *session = context;
    Machine machine = session->now;
    return machine_controls_set(&session->controls, &machine, name, value, fault) && change(session, &machine, fault);
}

static void reset_numbers(void *context) {
    BeamSession *session = context;
    Fault none = {0};
    change(session, &session->controls.file, &none);
    fault_clear(&none);
}

static const Preset *presets(const void *context, size_t *count) {
    const BeamSession *session = context;
    *count = beam_machine.preset_count;
    return session->controls.presets;
}

static void apply_preset(void *context, size_t preset) {
    BeamSession *session = context;
    Machine machine;
    Fault none = {0};
    machine_controls_prefer(&session->controls, preset, &machine);
    change(session, &machine, &none);
    fault_clear(&none);
}

static const PanelChoice *choices(void *context, size_t *count) {
    *count = CHOICES;
    return ((const BeamSession *)context)->choices;
}

static void choose(void *context, size_t choice, size_t word) {
    BeamSession *session = context;
    if (choice == CHOICE_SWEEP)
        session->diagram.carried = word == 1;
    else
        session->diagram.over = word;
    show_choices(session);
    ask_worker(session, false);
}

static void restart(void *context) {
    BeamSession *session = context;
    Fault none = {0};
    if (beam_tape_restart(&session->tape, &session->now.beam, &none)) {
        advance(session);
        beam_traces_forget(&session->traces, 0);
        session->shown = 0;
        session->looked = SIZE_MAX;
        session->news |= LABORATORY_TEXTS;
    }
    fault_clear(&none);
}

static bool save_run(void *context, double time) {
    BeamSession *session = context;
    beam_traces_store(&session->traces, time);
    machine_diagram_store(&session->diagram, true);
    return true;
}

static void clear_runs(void *context, double time) {
    BeamSession *session = context;
    double phase;
    beam_traces_store(&session->traces, -1);
    machine_diagram_store(&session->diagram, false);
    beam_traces_forget(&session->traces, beam_tape_cycle_at(&session->tape, time, &phase));
    beam_traces_show(&session->traces, &session->tape, time);
}

static const char *const *command(void *context, size_t *count) {
    BeamSession *session = context;
    *count = machine_controls_command(&session->controls, session->path, session->command, &session->command_words);
    return session->command;
}

/* Opening -----------------------------------------------------------------------------------------------------------*/

static bool read_files(BeamSession *session, const char *path, const LaboratoryOptions *options, Fault *fault) {
    if (!beam_read(&session->opened, path, options->settings, options->setting_count, fault))
        return false;
    if (!beam_read(&session->file, path, NULL, 0, fault)) {
        beam_free(&session->opened);
        return false;
    }
    session->now.beam = session->opened;
    machine_controls_open(&session->controls, &beam_machine, &(Machine){.beam = session->file});
    machine_controls_show(&session->controls, &session->now);
    return true;
}

/* Updates the answer from the end of the record. */
static void look_at_answer(BeamSession *session) {
    if (session->looked == session->tape.front)
        return;
    session->looked = session->tape.front;
    MachineLately lately = beam_lately_look(&session->tape);
    const Beam *beam = &session->now.beam;
    snprintf(session->where, sizeof session->where, "%.1f Hz, gap %.3g mm", beam->frequency, 1000 * beam->clearance);
    MachineNow now = {session->tape.status, session->tape.next, session->where};
    machine_answer_write(&session->answer, &now, &lately, session->has_verdict ? &session->verdict : NULL);
    session->news |= LABORATORY_TEXTS;
}

static void *open_live(const char *path, const LaboratoryOptions *options, Fault *fault) {
    BeamSession *session = memory_zeroed(1, sizeof *session);
    if (!read_files(session, path, options, fault)) {
        memory_free(session);
        return NULL;
    }
    if (!beam_tape_open(&session->tape, &session->now.beam, path, fault)) {
        beam_free(&session->file);
        beam_free(&session->opened);
        memory_free(session);
        return NULL;
    }
    session->path = text_copy(path);
    session->tape.place = session->opened.name;
    session->view.parts = BEAM_SCENE_ALL & ~BEAM_SCENE_SOURCES;
    beam_traces_open(&session->traces);
    machine_diagram_open(&session->diagram);
    session->worker = machine_worker_start(&beam_machine, options->jobs);
    show_choices(session);
    session->news = LABORATORY_ALL & ~LABORATORY_ERROR;
    advance(session);
    ask_worker(session, true);
    look_at_answer(session);
    return session;
}

static void close_live(void *context) {
    BeamSession *session = context;
    machine_worker_stop(session->worker);
    beam_traces_close(&session->traces);
    machine_diagram_close(&session->diagram);
    beam_view_close(&session->view);
    beam_tape_close(&session->tape);
    machine_answer_clear(&session->answer);
    machine_verdict_clear(&session->verdict);
    beam_free(&session->file);
    beam_free(&session->opened);
    arena_clear(&session->command_words);
    arena_clear(&session->error_texts);
    memory_free(session->path);
    memory_free(session);
}

/* Time --------------------------------------------------------------------------------------------------------------*/

static RecordSpan span(const void *context) {
    const BeamSession *session = context;
    const BeamTape *tape = &session->tape;
    double frequency = session->now.beam.frequency;
    return (RecordSpan){.begin = beam_tape_begin(tape, tape->first),
                        .end = tape->front_time,
                        .complete = beam_session_has_ended(session),
                        .endless = !beam_session_has_ended(session),
                        .pace = 1 / beam_film_slow(frequency),
                        .step = 1 / frequency / STEPS,
                        .fastest = 1024};
}

static double reach(void *context, double time) {
    BeamSession *session = context;
    BeamTape *tape = &session->tape;
    double deadline = stopwatch_now() + BUSY_MOST;
    while (tape->front_time <= time && !beam_session_has_ended(session)) {
        advance(session);
        if (stopwatch_now() > deadline)
            break;
    }
    return tape->front_time;
}

static bool show(void *context, double time) {
    BeamSession *session = context;
    session->shown = time;
    bool restarted = beam_view_show(&session->view, &session->tape, time);
    beam_traces_show(&session->traces, &session->tape, time);
    if (restarted)
        session->news |= LABORATORY_VIEW;
    return !restarted;
}

/* Answer ------------------------------------------------------------------------------------------------------------*/

static void apply_news(BeamSession *session, MachineNews *news) {
    if (news->verdict && machine_same(&beam_machine, &news->result.machine, &session->now)) {
        machine_verdict_clear(&session->verdict);
        session->verdict = news->result;
        session->has_verdict = true;
        session->looked = SIZE_MAX;
        bool typed = session->verdict.typed && session->verdict.type != TYPES_UNRESOLVED;
        if (typed && machine_controls_name_type(&session->controls, &session->verdict.machine,
                                                types_kind_name(session->verdict.type)))
            session->news |= LABORATORY_PARAMETERS;
    } else if (news->verdict) {
        machine_verdict_clear(&news->result);
    }
    if (news->swept)
        machine_diagram_apply(&session->diagram, news);
}

static unsigned update(void *context, double time) {
    (void)time;
    BeamSession *session = context;
    MachineNews news;
    machine_worker_take(session->worker, &news);
    apply_news(session, &news);
    look_at_answer(session);
    char before[sizeof session->answer.doing];
    memcpy(before, session->answer.doing, sizeof before);
    machine_answer_note_doing(&session->answer, &beam_machine, &news);
    if (strcmp(before, session->answer.doing) != 0)
        session->news |= LABORATORY_TEXTS;
    unsigned changed = session->news;
    session->news = 0;
    return changed;
}

static Result answer(void *context) {
    return ((const BeamSession *)context)->answer.result;
}

static const PanelRow *rows(const void *context, size_t *count) {
    const BeamSession *session = context;
    *count = session->answer.row_count;
    return session->answer.rows;
}

static const char *clock_words(void *context, double time) {
    BeamSession *session = context;
    double phase;
    size_t cycle = beam_tape_cycle_at(&session->tape, time, &phase);
    snprintf(session->clock, sizeof session->clock, "cycle %zu, %.3f s", cycle + 1, time);
    return session->clock;
}

static const char *note(void *context) {
    const BeamSession *session = context;
    for (int i = 0; i < BEAM_VALUES; i++)
        if (session->opened.provenance[i] && strstr(session->opened.provenance[i], "not published"))
            return "identified, not published";
    return "";
}

static const char *title(const void *context) {
    return ((const BeamSession *)context)->opened.name;
}

static const TimelineMark *marks(void *context, size_t *count) {
    BeamSession *session = context;
    const BeamTape *tape = &session->tape;
    *count = 0;
    for (size_t p = 1; p < tape->part_count; p++)
        session->marks[(*count)++] = (TimelineMark){tape->parts[p]->begin, TIMELINE_CHANGE};
    if (beam_session_has_ended(session))
        session->marks[(*count)++] = (TimelineMark){tape->front_time, TIMELINE_ERROR};
    return session->marks;
}

static const char *error(const void *context, double *time) {
    const BeamSession *session = context;
    *time = session->tape.front_time;
    return beam_session_has_ended(session) ? session->error : NULL;
}

static const char *const layer_names[] = {"loupe", "forces", "names", "sources"};
static const char *const layer_meanings[] = {"the tip between its stops, enlarged",
                                             "the forces of the shaker and of the stops", "the names of the parts",
                                             "the parameters below each name, and their sources"};

static bool save(void *context, const char *path, Fault *fault) {
    size_t count;
    const char *const *words = command(context, &count);
    return save_file_beam(words, count, path, fault);
}

const Laboratory beam_laboratory = {
    .name = "Beam",
    .word = "beam",
    .plots_at_first = "phase,orbit",
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
    .still = beam_picture_still,
    .added = beam_picture_added,
    .moving = beam_picture_moving,
    .set_camera = beam_picture_set_camera,
    .set_layers = beam_picture_set_layers,
    .plot_count = beam_picture_plot_count,
    .plot = beam_picture_plot,
    .points_until = beam_picture_points_until,
    .answer = answer,
    .clock = clock_words,
    .note = note,
    .title = title,
    .rows = rows,
    .marks = marks,
    .error = error,
    .parameters = parameters,
    .set = set_number,
    .reset = reset_numbers,
    .presets = presets,
    .apply_preset = apply_preset,
    .choices = choices,
    .choose = choose,
    .restart = restart,
    .save_run = save_run,
    .clear_runs = clear_runs,
    .pick = machine_item_pick,
    .next = machine_item_next,
    .select = machine_item_select,
    .selected = machine_item_selected,
    .item_name = machine_item_name,
    .outline = machine_item_outline,
    .command = command,
    .save = save,
    .sound = beam_picture_sound,
};
