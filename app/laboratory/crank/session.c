#include "laboratory/crank/session.h"

#include <math.h>
#include <stdio.h>

#include "base/stopwatch.h"
#include "laboratory/crank/picture.h"
#include "laboratory/machine/item.h"
#include "laboratory/shipped.h"
#include "laboratory/save_file.h"

#define BUSY_MOST 2e-3 /* s, longest time for which the motion is computed without a pause */
#define SLOW 60.0      /* 1, slow motion at speed 1 */
#define MILLI 1000.0   /* mm per m */

enum {
    STEPS = 180, /* frames per revolution from single step to single step */
    LEAST = 16,  /* revolutions before a motion may be called one without a period */
};

/* The answer so far -------------------------------------------------------------------------------------------------*/

static MachineLately look(const CrankTape *tape) {
    double along[MACHINE_ANSWER_LATELY], rate[MACHINE_ANSWER_LATELY], peak[2 * MACHINE_ANSWER_LATELY];
    const CrankPart *part = tape->parts[tape->part_count - 1];
    size_t first = crank_tape_first_return(tape);
    MachineLately lately = {.cycles = tape->front - part->first};
    size_t count = tape->front - first < MACHINE_ANSWER_LATELY ? tape->front - first : MACHINE_ANSWER_LATELY;
    for (size_t i = 0; i < count; i++) {
        const CrankReturn *next = crank_tape_return(tape, tape->front - count + i + 1);
        along[i] = next->along;
        rate[i] = next->along_rate;
        peak[2 * i] = crank_tape_return(tape, tape->front - count + i)->peak;
        peak[2 * i + 1] = 0;
    }
    size_t last = count / 2; /* assumed settled part of a motion that settles */
    lately.peaks = section_peaks(&(Section){.count = count - last, .peak = peak + 2 * last});
    lately.period = count < LEAST
                        ? SECTION_UNDECIDED
                        : section_period(along, rate, count, part->tree.omega, CRANK_REST * part->crank.clearance);
    return lately;
}

static void look_at_answer(MachineSession *machine_session) {
    CrankSession *session = (CrankSession *)machine_session;
    if (session->machine.looked == session->tape.front)
        return;
    session->machine.looked = session->tape.front;
    const Crank *crank = &session->machine.now.crank;
    MachineLately lately = look(&session->tape);
    snprintf(session->machine.where, sizeof session->machine.where, "%.4g rpm (%.4g Hz), gap %.3g mm",
             60 * crank->frequency, crank->frequency, MILLI * crank->clearance);
    machine_session_write(&session->machine, session->tape.status, session->tape.next, &lately);
}

static bool has_ended(const CrankSession *session) {
    return session->tape.status != CYCLE_GOOD && !session->tape.next;
}

/* Records one more revolution, or stores the reason why the record has ended. */
static void advance(CrankSession *session) {
    CrankTape *tape = &session->tape;
    session->machine.news |= tape->next ? LABORATORY_TEXTS : 0;
    if (crank_tape_advance(tape))
        return;
    if (tape->status == CYCLE_CHATTERS)
        snprintf(session->error, sizeof session->error,
                 "In revolution %zu the ball switches more than %d times, and the run ends: use more contact damping, "
                 "a softer contact or a larger clearance",
                 tape->front + 1, TURN_SWITCHES_MOST);
    else if (tape->status == CYCLE_STIFF)
        snprintf(session->error, sizeof session->error,
                 "Revolution %zu takes more than %.0f steps, and the run ends: use a softer or less damped joint, or a "
                 "higher speed",
                 tape->front + 1, tape->turn.steps_most);
    else
        snprintf(
            session->error, sizeof session->error,
            "In revolution %zu the coupler bends too far or the numbers grow without bound%s, and the run ends: use "
            "more damping or another speed",
            tape->front + 1, tape->turn.tree->turns ? ", or the motor stalls" : "");
    session->machine.looked = SIZE_MAX;
    session->machine.news |= LABORATORY_ERROR | LABORATORY_TEXTS;
}

/* Changes ----------------------------------------------------------------------------------------------------------*/

static bool change_record(MachineSession *machine_session, const Machine *machine, Fault *fault) {
    CrankSession *session = (CrankSession *)machine_session;
    CrankTape *tape = &session->tape;
    if (!crank_check(&machine->crank, session->opened.name, fault))
        return false;
    size_t row, cycle = crank_tape_cycle_at(tape, session->machine.shown, &row) + 1;
    crank_tape_change(tape, &machine->crank, cycle < tape->front ? cycle : tape->front);
    return true;
}

enum { CHOICE_SIGHT = MACHINE_CHOICES };

static void show_sight(CrankSession *session) {
    session->machine.choices[CHOICE_SIGHT] =
        (PanelChoice){.name = "Loupe",
                      .meaning = "the direction in which the loupe shows the socket",
                      .options = crank_scene_sights,
                      .count = CRANK_SIGHTS,
                      .chosen = session->view.sight};
}

static void choose(void *context, size_t choice, size_t word) {
    CrankSession *session = context;
    if (choice != CHOICE_SIGHT) {
        machine_session_choose(context, choice, word);
        return;
    }
    session->view.sight = (CrankSight)word;
    show_sight(session);
    crank_view_show(&session->view, &session->machine.picture, &session->tape, session->machine.shown);
    session->machine.news |= LABORATORY_VIEW | LABORATORY_PARAMETERS;
}

static void restart(void *context) {
    CrankSession *session = context;
    crank_tape_restart(&session->tape, &session->machine.now.crank);
    advance(session);
    crank_traces_forget(&session->traces, 0);
    session->machine.shown = 0;
    session->machine.looked = SIZE_MAX;
    session->machine.news |= LABORATORY_TEXTS;
}

static bool save_run(void *context, double time) {
    CrankSession *session = context;
    crank_traces_store(&session->traces, time);
    machine_diagram_store(&session->machine.diagram, true);
    return true;
}

static void clear_runs(void *context, double time) {
    CrankSession *session = context;
    size_t row;
    crank_traces_store(&session->traces, -1);
    machine_diagram_store(&session->machine.diagram, false);
    crank_traces_forget(&session->traces, crank_tape_cycle_at(&session->tape, time, &row));
    crank_traces_show(&session->traces, &session->tape, time);
}

static bool draw(MachineSession *machine_session, double time) {
    CrankSession *session = (CrankSession *)machine_session;
    bool restarted = crank_view_show(&session->view, &session->machine.picture, &session->tape, time);
    crank_traces_show(&session->traces, &session->tape, time);
    return restarted;
}

/* Opening -----------------------------------------------------------------------------------------------------------*/

static bool read_files(CrankSession *session, const char *path, const LaboratoryOptions *options, Fault *fault) {
    if (!crank_read(&session->opened, path, options->settings, options->setting_count, fault))
        return false;
    if (!crank_read(&session->file, path, NULL, 0, fault)) {
        crank_free(&session->opened);
        return false;
    }
    return true;
}

static void *open_live(const char *path, const LaboratoryOptions *options, Fault *fault) {
    CrankSession *session = memory_zeroed(1, sizeof *session);
    if (!read_files(session, path, options, fault)) {
        memory_free(session);
        return NULL;
    }
    crank_tape_open(&session->tape, &session->opened);
    session->machine.picture.parts = session->machine.picture.all = CRANK_SCENE_ALL;
    crank_traces_open(&session->traces);
    session->machine.change_record = change_record;
    session->machine.look = look_at_answer;
    session->machine.draw = draw;
    machine_session_open(&session->machine, &crank_machine, path, options->jobs, &(Machine){.crank = session->opened},
                         &(Machine){.crank = session->file});
    session->machine.choice_count = CHOICE_SIGHT + 1;
    show_sight(session);
    advance(session);
    machine_session_ask(&session->machine, true);
    look_at_answer(&session->machine);
    return session;
}

static void close_live(void *context) {
    CrankSession *session = context;
    machine_session_close(&session->machine);
    crank_traces_close(&session->traces);
    crank_view_close(&session->view);
    crank_tape_close(&session->tape);
    crank_free(&session->file);
    crank_free(&session->opened);
    memory_free(session);
}

/* Time --------------------------------------------------------------------------------------------------------------*/

static RecordSpan span(const void *context) {
    const CrankSession *session = context;
    const CrankTape *tape = &session->tape;
    double frequency = session->machine.now.crank.frequency;
    return (RecordSpan){.begin = crank_tape_return(tape, tape->first)->begin,
                        .end = tape->front_time,
                        .complete = has_ended(session),
                        .endless = !has_ended(session),
                        .pace = 1 / SLOW,
                        .step = 1 / frequency / STEPS,
                        .fastest = 64};
}

static double reach(void *context, double time) {
    CrankSession *session = context;
    CrankTape *tape = &session->tape;
    double deadline = stopwatch_now() + BUSY_MOST;
    while (tape->front_time <= time && !has_ended(session)) {
        advance(session);
        if (stopwatch_now() > deadline)
            break;
    }
    return tape->front_time;
}

/* Answer ------------------------------------------------------------------------------------------------------------*/

static const char *clock_words(void *context, double time) {
    CrankSession *session = context;
    size_t row, cycle = crank_tape_cycle_at(&session->tape, time, &row);
    const CrankTapeCycle *at = crank_tape_cycle(&session->tape, cycle);
    double angle = row < at->row_count ? crank_tape_row(at, row)[CRANK_TAPE_ANGLE] * 180 / M_PI : 0;
    snprintf(session->clock, sizeof session->clock, "revolution %zu, %.0f\u00b0, %.3f s", cycle + 1, angle, time);
    return session->clock;
}

static const char *note(void *context) {
    return crank_is_assumed(&((const CrankSession *)context)->opened) ? "all numbers assumed" : "";
}

static const char *title(const void *context) {
    return shipped_title(((const CrankSession *)context)->opened.name);
}

static const TimelineMark *marks(void *context, size_t *count) {
    CrankSession *session = context;
    const CrankTape *tape = &session->tape;
    *count = 0;
    for (size_t p = 1; p < tape->part_count; p++)
        session->marks[(*count)++] = (TimelineMark){tape->parts[p]->begin, TIMELINE_CHANGE};
    if (has_ended(session))
        session->marks[(*count)++] = (TimelineMark){tape->front_time, TIMELINE_ERROR};
    return session->marks;
}

static const char *error(const void *context, double *time) {
    const CrankSession *session = context;
    *time = session->tape.front_time;
    return has_ended(session) ? session->error : NULL;
}

static const char *const layer_names[] = {"loupe", "polar", "forces", "names"};
static const char *const layer_meanings[] = {"the ball in its socket, enlarged", "the force over the crank angle",
                                             "the force on the ball", "the names of the parts"};

static bool save(void *context, const char *path, Fault *fault) {
    size_t count;
    const char *const *words = machine_session_command(context, &count);
    return save_file_crank(words, count, path, fault);
}

const Laboratory crank_laboratory = {
    .name = "Crank",
    .word = "crank",
    .plots_at_first = "phase,orbit",
    .numbers_first = true,
    .layers = layer_names,
    .meanings = layer_meanings,
    .layer_count = sizeof layer_names / sizeof *layer_names,
    .layers_at_first = CRANK_SCENE_ALL,
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
    .note_plots = machine_session_note_plots,
    .plot_count = crank_picture_plot_count,
    .plot = crank_picture_plot,
    .points_until = crank_picture_points_until,
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
    .command = machine_session_command,
    .save = save,
    .sound = crank_picture_sound,
};
