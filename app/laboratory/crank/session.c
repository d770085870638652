#include "laboratory/crank/session.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/stopwatch.h"
#include "base/text.h"
#include "laboratory/crank/picture.h"
#include "laboratory/machine/item.h"
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

static void look_at_answer(CrankSession *session) {
    if (session->looked == session->tape.front)
        return;
    session->looked = session->tape.front;
    const Crank *crank = &session->now.crank;
    MachineLately lately = look(&session->tape);
    snprintf(session->where, sizeof session->where, "%.4g rpm (%.4g Hz), clearance %.3g mm", 60 * crank->frequency,
             crank->frequency, MILLI * crank->clearance);
    MachineNow now = {session->tape.status, session->tape.next, session->where};
    machine_answer_write(&session->answer, &now, &lately, session->has_verdict ? &session->verdict : NULL);
    session->news |= LABORATORY_TEXTS;
}

static bool has_ended(const CrankSession *session) {
    return session->tape.status != CYCLE_GOOD && !session->tape.next;
}

/* Records one more revolution, or stores the reason why the record has ended. */
static void advance(CrankSession *session) {
    CrankTape *tape = &session->tape;
    session->news |= tape->next ? LABORATORY_TEXTS : 0;
    if (crank_tape_advance(tape))
        return;
    if (tape->status == CYCLE_CHATTERS)
        snprintf(session->error, sizeof session->error,
                 "In revolution %zu the ball switches more than %d times, and the run ends: use more contact damping, "
                 "a softer contact or a larger clearance",
                 tape->front + 1, TURN_SWITCHES_MOST);
    else
        snprintf(session->error, sizeof session->error,
                 "In revolution %zu the numbers grow without bound%s, and the run ends: use more damping or another "
                 "speed",
                 tape->front + 1, tape->turn.tree->turns ? ", or the motor stalls" : "");
    session->looked = SIZE_MAX;
    session->news |= LABORATORY_ERROR | LABORATORY_TEXTS;
}

/* Changes ----------------------------------------------------------------------------------------------------------*/

static const char *const sweeps[] = {"from the start", "upwards and downwards"};
static const char *const sights[CRANK_SIGHTS] = {"from the side", "along the coupler", "from above"};

enum { CHOICE_SWEEP, CHOICE_OVER, CHOICE_SIGHT };

static void show_choices(CrankSession *session) {
    session->choices[CHOICE_SWEEP] =
        (PanelChoice){.name = "Sweep",
                      .meaning = "the initial state of each value of the orbit diagram: the start of the file, or the "
                                 "final state of the neighbouring value",
                      .options = sweeps,
                      .count = sizeof sweeps / sizeof *sweeps,
                      .chosen = session->diagram.carried};
    session->choices[CHOICE_OVER] = (PanelChoice){.name = "Orbit over",
                                                  .meaning = "the parameter that varies along the orbit diagram",
                                                  .options = crank_machine.over_words,
                                                  .count = crank_machine.over_count,
                                                  .chosen = session->diagram.over};
    session->choices[CHOICE_SIGHT] = (PanelChoice){.name = "Loupe",
                                                   .meaning = "the direction in which the loupe shows the socket",
                                                   .options = sights,
                                                   .count = CRANK_SIGHTS,
                                                   .chosen = session->view.sight};
}

static void ask_worker(CrankSession *session, bool verdict) {
    session->news |= LABORATORY_TEXTS | LABORATORY_PARAMETERS;
    session->looked = SIZE_MAX;
    session->has_verdict =
        session->has_verdict && machine_same(&crank_machine, &session->verdict.machine, &session->now);
    machine_controls_show(&session->controls, &session->now);
    machine_diagram_ask(&session->diagram, &session->controls, &session->now, session->worker);
    if (verdict)
        machine_worker_ask_verdict(session->worker, &session->now);
}

/* Changes the crank from the end of the displayed revolution on. */
static bool change(CrankSession *session, const Machine *machine, Fault *fault) {
    CrankTape *tape = &session->tape;
    if (machine_same(&crank_machine, machine, &session->now))
        return true;
    if (!crank_check(&machine->crank, session->opened.name, fault))
        return false;
    size_t row, cycle = crank_tape_cycle_at(tape, session->shown, &row) + 1;
    crank_tape_change(tape, &machine->crank, cycle < tape->front ? cycle : tape->front);
    session->now = *machine;
    ask_worker(session, true);
    return true;
}

static const PanelParameter *parameters(const void *context, size_t *count) {
    const CrankSession *session = context;
    *count = session->controls.count;
    return session->controls.parameters;
}

static bool set_number(void *context, const char *name, double value, Fault *fault) {
    CrankSession *session = context;
    Machine machine = session->now;
    return machine_controls_set(&session->controls, &machine, name, value, fault) && change(session, &machine, fault);
}

static void reset_numbers(void *context) {
    CrankSession *session = context;
    Fault none = {0};
    change(session, &session->controls.file, &none);
    fault_clear(&none);
}

static const Preset *presets(const void *context, size_t *count) {
    const CrankSession *session = context;
    *count = crank_machine.preset_count;
    return session->controls.presets;
}

static void apply_preset(void *context, size_t preset) {
    CrankSession *session = context;
    Machine machine;
    Fault none = {0};
    machine_controls_prefer(&session->controls, preset, &machine);
    change(session, &machine, &none);
    fault_clear(&none);
}

static const PanelChoice *choices(void *context, size_t *count) {
    *count = CRANK_CHOICES;
    return ((const CrankSession *)context)->choices;
}

static void choose(void *context, size_t choice, size_t word) {
    CrankSession *session = context;
    if (choice == CHOICE_SWEEP)
        session->diagram.carried = word == 1;
    else if (choice == CHOICE_OVER)
        session->diagram.over = word;
    else
        session->view.sight = (CrankSight)word;
    show_choices(session);
    if (choice == CHOICE_SIGHT) {
        crank_view_show(&session->view, &session->tape, session->shown);
        session->news |= LABORATORY_VIEW | LABORATORY_PARAMETERS;
    } else {
        ask_worker(session, false);
    }
}

static void restart(void *context) {
    CrankSession *session = context;
    crank_tape_restart(&session->tape, &session->now.crank);
    advance(session);
    crank_traces_forget(&session->traces, 0);
    session->shown = 0;
    session->looked = SIZE_MAX;
    session->news |= LABORATORY_TEXTS;
}

static bool save_run(void *context, double time) {
    CrankSession *session = context;
    crank_traces_store(&session->traces, time);
    machine_diagram_store(&session->diagram, true);
    return true;
}

static void clear_runs(void *context, double time) {
    CrankSession *session = context;
    size_t row;
    crank_traces_store(&session->traces, -1);
    machine_diagram_store(&session->diagram, false);
    crank_traces_forget(&session->traces, crank_tape_cycle_at(&session->tape, time, &row));
    crank_traces_show(&session->traces, &session->tape, time);
}

static const char *const *command(void *context, size_t *count) {
    CrankSession *session = context;
    *count = machine_controls_command(&session->controls, session->path, session->command, &session->command_words);
    return session->command;
}

/* Opening -----------------------------------------------------------------------------------------------------------*/

static bool read_files(CrankSession *session, const char *path, const LaboratoryOptions *options, Fault *fault) {
    if (!crank_read(&session->opened, path, options->settings, options->setting_count, fault))
        return false;
    if (!crank_read(&session->file, path, NULL, 0, fault)) {
        crank_free(&session->opened);
        return false;
    }
    session->now.crank = session->opened;
    machine_controls_open(&session->controls, &crank_machine, &(Machine){.crank = session->file});
    machine_controls_show(&session->controls, &session->now);
    return true;
}

static void *open_live(const char *path, const LaboratoryOptions *options, Fault *fault) {
    CrankSession *session = memory_zeroed(1, sizeof *session);
    if (!read_files(session, path, options, fault)) {
        memory_free(session);
        return NULL;
    }
    crank_tape_open(&session->tape, &session->now.crank);
    session->path = text_copy(path);
    session->view.parts = CRANK_SCENE_ALL;
    crank_traces_open(&session->traces);
    machine_diagram_open(&session->diagram);
    session->worker = machine_worker_start(&crank_machine, options->jobs);
    show_choices(session);
    session->news = LABORATORY_ALL & ~LABORATORY_ERROR;
    advance(session);
    ask_worker(session, true);
    look_at_answer(session);
    return session;
}

static void close_live(void *context) {
    CrankSession *session = context;
    machine_worker_stop(session->worker);
    crank_traces_close(&session->traces);
    machine_diagram_close(&session->diagram);
    crank_view_close(&session->view);
    crank_tape_close(&session->tape);
    machine_answer_clear(&session->answer);
    machine_verdict_clear(&session->verdict);
    crank_free(&session->file);
    crank_free(&session->opened);
    arena_clear(&session->command_words);
    memory_free(session->path);
    memory_free(session);
}

/* Time --------------------------------------------------------------------------------------------------------------*/

static RecordSpan span(const void *context) {
    const CrankSession *session = context;
    const CrankTape *tape = &session->tape;
    double frequency = session->now.crank.frequency;
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

static bool show(void *context, double time) {
    CrankSession *session = context;
    session->shown = time;
    bool restarted = crank_view_show(&session->view, &session->tape, time);
    crank_traces_show(&session->traces, &session->tape, time);
    if (restarted)
        session->news |= LABORATORY_VIEW;
    return !restarted;
}

/* Answer ------------------------------------------------------------------------------------------------------------*/

static void apply_news(CrankSession *session, MachineNews *news) {
    if (news->verdict && machine_same(&crank_machine, &news->result.machine, &session->now)) {
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
    CrankSession *session = context;
    MachineNews news;
    machine_worker_take(session->worker, &news);
    apply_news(session, &news);
    look_at_answer(session);
    char before[sizeof session->answer.doing];
    memcpy(before, session->answer.doing, sizeof before);
    machine_answer_note_doing(&session->answer, &crank_machine, &news);
    if (strcmp(before, session->answer.doing) != 0)
        session->news |= LABORATORY_TEXTS;
    unsigned changed = session->news;
    session->news = 0;
    return changed;
}

static Result answer(void *context) {
    return ((const CrankSession *)context)->answer.result;
}

static const PanelRow *rows(const void *context, size_t *count) {
    const CrankSession *session = context;
    *count = session->answer.row_count;
    return session->answer.rows;
}

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
    return ((const CrankSession *)context)->opened.name;
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
    const char *const *words = command(context, &count);
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
    .update = update,
    .span = span,
    .reach = reach,
    .show = show,
    .still = crank_picture_still,
    .added = crank_picture_added,
    .moving = crank_picture_moving,
    .set_camera = crank_picture_set_camera,
    .set_layers = crank_picture_set_layers,
    .plot_count = crank_picture_plot_count,
    .plot = crank_picture_plot,
    .points_until = crank_picture_points_until,
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
    .sound = crank_picture_sound,
};
