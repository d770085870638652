#include "laboratory/beam/session.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/stopwatch.h"
#include "base/text.h"
#include "laboratory/beam/picture.h"
#include "laboratory/machine/item.h"
#include "laboratory/shipped.h"
#include "laboratory/save_file.h"
#include "visual/beam/beam_film.h"

#define BUSY_MOST 2e-3 /* s, longest time for which the motion is computed without a pause */

enum { STEPS = 60 /* steps per cycle from frame to frame */ };

/* Records one more cycle, or stores the reason why the record has ended. */
static void advance(BeamSession *session) {
    session->machine.news |= session->tape.next ? LABORATORY_TEXTS : 0;
    if (beam_tape_advance(&session->tape))
        return;
    arena_clear(&session->error_texts);
    session->error = beam_lately_error(&session->tape, &session->error_texts);
    session->machine.looked = SIZE_MAX;
    session->machine.news |= LABORATORY_ERROR | LABORATORY_TEXTS;
}

/* Changes ----------------------------------------------------------------------------------------------------------*/

static bool change_record(MachineSession *machine_session, const Machine *machine, Fault *fault) {
    BeamSession *session = (BeamSession *)machine_session;
    BeamTape *tape = &session->tape;
    double phase;
    size_t cycle = beam_tape_cycle_at(tape, session->machine.shown, &phase) + 1;
    return beam_tape_change(tape, &machine->beam, cycle < tape->front ? cycle : tape->front, fault);
}

static void restart(void *context) {
    BeamSession *session = context;
    Fault none = {0};
    if (beam_tape_restart(&session->tape, &session->machine.now.beam, &none)) {
        advance(session);
        beam_traces_forget(&session->traces, 0);
        session->machine.shown = 0;
        session->machine.looked = SIZE_MAX;
        session->machine.news |= LABORATORY_TEXTS;
    }
    fault_clear(&none);
}

static bool save_run(void *context, double time) {
    BeamSession *session = context;
    beam_traces_store(&session->traces, time);
    machine_diagram_store(&session->machine.diagram, true);
    return true;
}

static void clear_runs(void *context, double time) {
    BeamSession *session = context;
    double phase;
    beam_traces_store(&session->traces, -1);
    machine_diagram_store(&session->machine.diagram, false);
    beam_traces_forget(&session->traces, beam_tape_cycle_at(&session->tape, time, &phase));
    beam_traces_show(&session->traces, &session->tape, time);
}

static bool draw(MachineSession *machine_session, double time) {
    BeamSession *session = (BeamSession *)machine_session;
    bool restarted = beam_view_show(&session->view, &session->machine.picture, &session->tape, time);
    beam_traces_show(&session->traces, &session->tape, time);
    return restarted;
}

/* Opening -----------------------------------------------------------------------------------------------------------*/

static bool read_files(BeamSession *session, const char *path, const LaboratoryOptions *options, Fault *fault) {
    if (!beam_read(&session->opened, path, options->settings, options->setting_count, fault))
        return false;
    if (!beam_read(&session->file, path, NULL, 0, fault)) {
        beam_free(&session->opened);
        return false;
    }
    return true;
}

/* Updates the answer from the end of the record. */
static void look(MachineSession *machine_session) {
    BeamSession *session = (BeamSession *)machine_session;
    if (session->machine.looked == session->tape.front)
        return;
    session->machine.looked = session->tape.front;
    MachineLately lately = beam_lately_look(&session->tape);
    const Beam *beam = &session->machine.now.beam;
    snprintf(session->machine.where, sizeof session->machine.where, "%.1f Hz, gap %.3g mm", beam->frequency,
             1000 * beam->clearance);
    machine_session_write(&session->machine, session->tape.status, session->tape.next, &lately);
}

static size_t state_of(const MachineSession *machine_session, double *state) {
    const BeamSession *session = (const BeamSession *)machine_session;
    if (session->tape.next || session->tape.status != CYCLE_GOOD)
        return 0;
    motion_state(&session->tape.motion, state);
    return session->tape.motion.rig->free.states;
}

static void *open_live(const char *path, const LaboratoryOptions *options, Fault *fault) {
    BeamSession *session = memory_zeroed(1, sizeof *session);
    if (!read_files(session, path, options, fault)) {
        memory_free(session);
        return NULL;
    }
    if (!beam_tape_open(&session->tape, &session->opened, path, fault)) {
        beam_free(&session->file);
        beam_free(&session->opened);
        memory_free(session);
        return NULL;
    }
    session->tape.place = session->opened.name;
    session->machine.picture.parts = BEAM_SCENE_ALL & ~BEAM_SCENE_SOURCES;
    session->machine.picture.all = BEAM_SCENE_ALL;
    beam_traces_open(&session->traces);
    session->machine.change_record = change_record;
    session->machine.look = look;
    session->machine.draw = draw;
    session->machine.state = state_of;
    machine_session_open(&session->machine, &beam_machine, path, options->jobs, &(Machine){.beam = session->opened},
                         &(Machine){.beam = session->file});
    advance(session);
    machine_session_ask(&session->machine, true);
    look(&session->machine);
    return session;
}

static void close_live(void *context) {
    BeamSession *session = context;
    machine_session_close(&session->machine);
    beam_traces_close(&session->traces);
    beam_view_close(&session->view);
    beam_tape_close(&session->tape);
    beam_free(&session->file);
    beam_free(&session->opened);
    arena_clear(&session->error_texts);
    memory_free(session);
}

/* Time --------------------------------------------------------------------------------------------------------------*/

static RecordSpan span(const void *context) {
    const BeamSession *session = context;
    const BeamTape *tape = &session->tape;
    double frequency = session->machine.now.beam.frequency;
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

/* Answer ------------------------------------------------------------------------------------------------------------*/

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
    return shipped_title(((const BeamSession *)context)->opened.name);
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
    const char *const *words = machine_session_command(context, &count);
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
    .update = machine_session_update,
    .span = span,
    .reach = reach,
    .show = machine_picture_show,
    .still = machine_picture_still,
    .added = machine_picture_added,
    .moving = machine_picture_moving,
    .set_camera = machine_picture_set_camera,
    .set_layers = machine_picture_set_layers,
    .plot_count = beam_picture_plot_count,
    .plot = beam_picture_plot,
    .points_until = beam_picture_points_until,
    .answer = machine_session_answer,
    .clock = clock_words,
    .note = note,
    .title = title,
    .rows = machine_session_rows,
    .marks = marks,
    .error = error,
    .parameters = machine_session_parameters,
    .set = machine_session_set,
    .reset = machine_session_reset,
    .presets = machine_session_presets,
    .apply_preset = machine_session_apply_preset,
    .choices = machine_session_choices,
    .choose = machine_session_choose,
    .follow = machine_session_follow,
    .restart = restart,
    .save_run = save_run,
    .clear_runs = clear_runs,
    .pick = machine_item_pick,
    .next = machine_item_next,
    .select = machine_item_select,
    .selected = machine_item_selected,
    .item_name = machine_item_name,
    .outline = machine_item_outline,
    .command = machine_session_command,
    .save = save,
    .sound = beam_picture_sound,
};
