#include "laboratory/live.h"

#include <math.h>
#include <stdio.h>
#include <string.h>
#include <time.h>

#include "laboratory/beam_answer.h"
#include "laboratory/beam_diagram.h"
#include "laboratory/beam_film.h"
#include "laboratory/beam_numbers.h"
#include "laboratory/beam_traces.h"
#include "laboratory/beam_view.h"

/* The beam at work. The motion runs on the caller's thread, as far as it is reached for, into a record; pictures and
 * plots are made of the record; what takes longer is a worker's. */
typedef struct BeamLive {
    char *path;
    Beam opened; /* the file's, changed by the settings; holds texts */
    Beam beam;   /* as it is now */
    BeamControls controls;
    BeamTape tape;
    BeamView view;
    BeamTraces traces;
    BeamDiagram diagram;
    BeamWorker *worker;
    BeamAnswer answer;
    BeamVerdict verdict;
    bool told;     /* the verdict is there */
    size_t looked; /* at the front when the answer was written */
    double shown;  /* s */
    unsigned news; /* LIVE_..., of the next update */
    Scene added;   /* nothing */
    const char *trouble;
    LiveTick ticks[BEAM_TAPE_PARTS + 1];
    LiveChoice choices[2];
    Arena command_words;
    const char *command[3 + 2 * BEAM_VALUES];
    Arena troubles; /* texts */
    char clock[64];
} BeamLive;

#define BUSY_MOST 2e-3 /* s, that the motion is followed at a time */

enum { STEPS = 60 /* a cycle, from picture to picture */ };

static double clock_now(void) {
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

/* Opening -----------------------------------------------------------------------------------------------------------*/

static const char *const sweeps[] = {"from rest", "upwards and downwards"};

enum { CHOICE_SWEEP, CHOICE_OVER, CHOICES };

static void show_choices(BeamLive *live) {
    live->choices[CHOICE_SWEEP] = (LiveChoice){.name = "Sweep",
                                               .meaning = "how each value of the orbit diagram begins: at rest, or "
                                                          "from where the value beside it has ended",
                                               .words = sweeps,
                                               .count = sizeof sweeps / sizeof *sweeps,
                                               .chosen = live->diagram.carried};
    live->choices[CHOICE_OVER] = (LiveChoice){.name = "Orbit over",
                                              .meaning = "the number that the orbit diagram goes over",
                                              .words = beam_diagram_words,
                                              .count = BEAM_DIAGRAM_OVER,
                                              .chosen = live->diagram.over};
}

static bool read_files(BeamLive *live, const char *path, const LiveOptions *options, Fault *fault) {
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

/* The beam is another one now, or what is asked about it. */
static void ask(BeamLive *live, bool verdict) {
    live->news |= LIVE_WORDS | LIVE_PARAMETERS;
    live->looked = SIZE_MAX;
    live->told = live->told && beam_numbers_same(&live->verdict.beam, &live->beam);
    beam_controls_show(&live->controls, &live->beam);
    beam_diagram_ask(&live->diagram, &live->controls, &live->beam, live->worker);
    if (verdict)
        beam_worker_ask_verdict(live->worker, &live->beam);
}

static void *open_live(const char *path, const LiveOptions *options, Fault *fault) {
    BeamLive *live = memory_allocate(1, sizeof *live);
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
    live->path = strcpy(memory_allocate(strlen(path) + 1, 1), path);
    live->tape.place = live->opened.name;
    live->view.parts = BEAM_SCENE_ALL;
    beam_traces_open(&live->traces);
    beam_diagram_open(&live->diagram);
    live->worker = beam_worker_start(options->jobs);
    show_choices(live);
    beam_tape_advance(&live->tape);
    ask(live, true);
    live->news = LIVE_ALL & ~LIVE_TROUBLE;
    return live;
}

static void close_live(void *context) {
    BeamLive *live = context;
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

static bool has_ended(const BeamLive *live) {
    return live->tape.status != MOTION_GOOD && !live->tape.next;
}

static LiveSpan span(const void *context) {
    const BeamLive *live = context;
    const BeamTape *tape = &live->tape;
    double frequency = live->beam.frequency;
    return (LiveSpan){.begin = beam_tape_begin(tape, tape->first),
                      .end = tape->front_time,
                      .complete = has_ended(live),
                      .endless = !has_ended(live),
                      .pace = 1 / beam_film_slow(frequency),
                      .step = 1 / frequency / STEPS,
                      .fastest = 1024};
}

static void note_trouble(BeamLive *live) {
    arena_clear(&live->troubles);
    live->trouble = beam_answer_trouble(&live->tape, &live->troubles);
    live->news |= LIVE_TROUBLE | LIVE_WORDS;
}

static double reach(void *context, double time) {
    BeamLive *live = context;
    BeamTape *tape = &live->tape;
    double until = clock_now() + BUSY_MOST;
    while (tape->front_time <= time && !has_ended(live)) {
        size_t parts = tape->part_serial;
        bool changes = tape->next != NULL;
        if (!beam_tape_advance(tape))
            note_trouble(live);
        if (changes || parts != tape->part_serial)
            live->news |= LIVE_WORDS;
        if (clock_now() > until)
            break;
    }
    return tape->front_time;
}

static bool show(void *context, double time) {
    BeamLive *live = context;
    live->shown = time;
    bool anew = beam_view_show(&live->view, &live->tape, time);
    beam_traces_show(&live->traces, &live->tape, time);
    if (anew)
        live->news |= LIVE_VIEW;
    return !anew;
}

/* Answer ------------------------------------------------------------------------------------------------------------*/

static void take_news(BeamLive *live, BeamNews *news) {
    if (news->verdict && beam_numbers_same(&news->told.beam, &live->beam)) {
        beam_verdict_clear(&live->verdict);
        live->verdict = news->told;
        live->told = true;
        live->looked = SIZE_MAX;
        bool typed = live->verdict.typed && live->verdict.type != TYPES_UNRESOLVED;
        if (typed && beam_controls_name_type(&live->controls, &live->verdict.beam, types_kind_name(live->verdict.type)))
            live->news |= LIVE_PARAMETERS;
    } else if (news->verdict) {
        beam_verdict_clear(&news->told);
    }
    if (news->swept)
        beam_diagram_take(&live->diagram, news);
}

/* What is being worked out, if anything. */
static void note_doing(BeamLive *live, const BeamNews *news) {
    BeamAnswer *answer = &live->answer;
    size_t size = sizeof answer->doing, done = news->sweep_done, all = news->sweep_all;
    bool sweeps_now = all && done < all && !news->telling;
    answer->live.doing = answer->doing;
    answer->live.part = NAN;
    if (news->telling) {
        snprintf(answer->doing, size, "verdict: running it from rest");
    } else if (sweeps_now) {
        snprintf(answer->doing, size, "orbit diagram: %zu of %zu values", done, all);
        answer->live.part = (double)done / (double)all;
    } else if (news->types_all) {
        snprintf(answer->doing, size, "type: %zu of at most %zu runs", news->types_done, news->types_all);
        answer->live.part = (double)news->types_done / (double)news->types_all;
    } else {
        answer->live.doing = NULL;
    }
}

static unsigned update(void *context, double time) {
    (void)time;
    BeamLive *live = context;
    BeamNews news;
    beam_worker_take(live->worker, &news);
    take_news(live, &news);
    if (live->looked != live->tape.front) {
        live->looked = live->tape.front;
        BeamLately lately = beam_answer_look(&live->tape);
        beam_answer_write(&live->answer, &live->tape, &live->beam, &lately, live->told ? &live->verdict : NULL);
        live->news |= LIVE_WORDS;
    }
    char before[sizeof live->answer.doing];
    memcpy(before, live->answer.doing, sizeof before);
    note_doing(live, &news);
    if (strcmp(before, live->answer.doing) != 0)
        live->news |= LIVE_WORDS;
    unsigned changed = live->news;
    live->news = 0;
    return changed;
}

static LiveAnswer answer(const void *context) {
    return ((const BeamLive *)context)->answer.live;
}

static const LiveRow *rows(const void *context, size_t *count) {
    const BeamLive *live = context;
    *count = live->answer.row_count;
    return live->answer.rows;
}

static const char *clock_words(const void *context, double time) {
    BeamLive *live = (BeamLive *)context;
    double phase;
    size_t cycle = beam_tape_cycle_at(&live->tape, time, &phase);
    snprintf(live->clock, sizeof live->clock, "cycle %zu, %.3f s", cycle + 1, time);
    return live->clock;
}

static const char *note(const void *context) {
    const BeamLive *live = context;
    for (int i = 0; i < BEAM_VALUES; i++)
        if (live->opened.provenance[i] && strstr(live->opened.provenance[i], "not published"))
            return "identified, not published";
    return "";
}

static const char *title(const void *context) {
    return ((const BeamLive *)context)->opened.name;
}

static const LiveTick *ticks(const void *context, size_t *count) {
    BeamLive *live = (BeamLive *)context;
    const BeamTape *tape = &live->tape;
    *count = 0;
    for (size_t p = 1; p < tape->part_count; p++)
        live->ticks[(*count)++] = (LiveTick){tape->parts[p]->begin, LIVE_TICK_CHANGE};
    if (has_ended(live))
        live->ticks[(*count)++] = (LiveTick){tape->front_time, LIVE_TICK_TROUBLE};
    return live->ticks;
}

static const char *trouble(const void *context, double *time) {
    const BeamLive *live = context;
    *time = live->tape.front_time;
    return has_ended(live) ? live->trouble : NULL;
}

/* Changes -----------------------------------------------------------------------------------------------------------*/

/* From the end of the cycle that is shown on, the beam is this one. */
static bool change(BeamLive *live, const Beam *beam, Fault *fault) {
    BeamTape *tape = &live->tape;
    double phase;
    if (beam_numbers_same(beam, &live->beam))
        return true;
    size_t cycle = beam_tape_cycle_at(tape, live->shown, &phase) + 1;
    if (!beam_tape_change(tape, beam, cycle < tape->front ? cycle : tape->front, fault))
        return false;
    live->beam = *beam;
    ask(live, true);
    return true;
}

static const LiveParameter *parameters(const void *context, size_t *count) {
    const BeamLive *live = context;
    *count = live->controls.count;
    return live->controls.parameters;
}

static bool set(void *context, const char *name, double value, Fault *fault) {
    BeamLive *live = context;
    Beam beam = live->beam;
    return beam_controls_set(&live->controls, &beam, name, value, fault) && change(live, &beam, fault);
}

static void reset(void *context) {
    BeamLive *live = context;
    Fault none = {0};
    change(live, &live->controls.file, &none);
    fault_clear(&none);
}

static const LivePreset *presets(const void *context, size_t *count) {
    const BeamLive *live = context;
    *count = BEAM_PRESETS;
    return live->controls.presets;
}

static void prefer(void *context, size_t preset) {
    BeamLive *live = context;
    Beam beam;
    Fault none = {0};
    beam_controls_prefer(&live->controls, preset, &beam);
    change(live, &beam, &none);
    fault_clear(&none);
}

static const LiveChoice *choices(const void *context, size_t *count) {
    *count = CHOICES;
    return ((const BeamLive *)context)->choices;
}

static void choose(void *context, size_t choice, size_t word) {
    BeamLive *live = context;
    if (choice == CHOICE_SWEEP)
        live->diagram.carried = word == 1;
    else
        live->diagram.over = word;
    show_choices(live);
    ask(live, false);
}

static void again(void *context) {
    BeamLive *live = context;
    Fault none = {0};
    if (beam_tape_restart(&live->tape, &live->beam, &none)) {
        beam_tape_advance(&live->tape);
        beam_traces_forget(&live->traces, 0);
        live->shown = 0;
        live->looked = SIZE_MAX;
        live->news |= LIVE_WORDS;
    }
    fault_clear(&none);
}

static void keep(void *context, double time) {
    BeamLive *live = context;
    beam_traces_keep(&live->traces, time);
    beam_diagram_keep(&live->diagram, true);
}

static void clear(void *context, double time) {
    BeamLive *live = context;
    double phase;
    beam_traces_keep(&live->traces, -1);
    beam_diagram_keep(&live->diagram, false);
    beam_traces_forget(&live->traces, beam_tape_cycle_at(&live->tape, time, &phase));
    beam_traces_show(&live->traces, &live->tape, time);
}

/* Looking -----------------------------------------------------------------------------------------------------------*/

static const char *const layer_names[] = {"loupe", "forces", "names"};
static const char *const layer_meanings[] = {"the tip between its stops, enlarged",
                                             "the shaker's force, and those of the stops",
                                             "what the parts are called, and their numbers"};

static void look(void *context, Camera camera) {
    BeamLive *live = context;
    live->view.camera = camera;
    beam_view_renew(&live->view);
    beam_view_show(&live->view, &live->tape, live->shown);
    live->news |= LIVE_VIEW;
}

static void reveal(void *context, unsigned layers) {
    BeamLive *live = context;
    live->view.parts = layers & BEAM_SCENE_ALL;
    beam_view_show(&live->view, &live->tape, live->shown);
    live->news |= LIVE_VIEW;
}

static const Scene *still(const void *context) {
    return &((const BeamLive *)context)->view.still;
}

static const Scene *added(const void *context) {
    return &((const BeamLive *)context)->added;
}

static const Scene *moving(const void *context) {
    return &((const BeamLive *)context)->view.moving;
}

/* Plots: those of the time, and the orbit diagram. */

static const char *const plot_names[] = {"phase", "poincare", "force", "spectrum", "orbit"};
static const char *const plot_titles[] = {"Phase plane", "Poincar\u00E9 map", "Force", "Spectrum", "Orbit diagram"};

static size_t plot_count(const void *context) {
    (void)context;
    return BEAM_TRACES + 1;
}

static LivePlot diagram_plot(const BeamLive *live) {
    const BeamDiagram *diagram = &live->diagram;
    const char *over = beam_diagram_over[diagram->over];
    return (LivePlot){.plot = &diagram->plot,
                      .revision = diagram->revision,
                      .still = true,
                      .cursor = diagram->factor * beam_controls_find(&live->controls, over)->value,
                      .cursor_words = diagram->cursor,
                      .cursor_parameter = over,
                      .cursor_factor = diagram->factor,
                      .now = ROLE_PAPER};
}

static LivePlot plot(const void *context, size_t index) {
    const BeamLive *live = context;
    LivePlot shown = {.cursor = NAN, .now = ROLE_DANGER_MIDDLE};
    if (index == BEAM_TRACES) {
        shown = diagram_plot(live);
    } else {
        shown.plot = &live->traces.plots[index];
        shown.revision = live->traces.revisions[index];
    }
    shown.name = plot_names[index];
    shown.title = plot_titles[index];
    return shown;
}

static size_t until(const void *context, size_t index, size_t series, double time) {
    const BeamLive *live = context;
    return index == BEAM_TRACES ? live->diagram.series[series].count
                                : beam_traces_until(&live->traces, index, series, time);
}

/* Nothing in the picture can be selected. */

static LiveThing pick(const void *context, Vec2 at, double time, LiveThing below) {
    (void)context, (void)at, (void)time, (void)below;
    return (LiveThing){0};
}

static LiveThing next(const void *context, LiveThing thing, int step) {
    (void)context, (void)thing, (void)step;
    return (LiveThing){0};
}

static void select_thing(void *context, LiveThing thing) {
    (void)context, (void)thing;
}

static LiveThing selected(const void *context) {
    (void)context;
    return (LiveThing){0};
}

static const char *name_thing(const void *context, LiveThing thing) {
    (void)context, (void)thing;
    return "";
}

static size_t outline(const void *context, LiveThing thing, double time, Vec2 *points) {
    (void)context, (void)thing, (void)time, (void)points;
    return 0;
}

/* -------------------------------------------------------------------------------------------------------------------*/

static const char *const *command(const void *context, size_t *count) {
    BeamLive *live = (BeamLive *)context;
    size_t used = 0;
    arena_clear(&live->command_words);
    live->command[used++] = "run";
    live->command[used++] = live->path;
    for (size_t i = 0; i < live->controls.count; i++) {
        const LiveParameter *parameter = &live->controls.parameters[i];
        if (parameter->value == parameter->initial)
            continue;
        const char *value = beam_numbers_text(parameter->row, parameter->value, &live->command_words);
        live->command[used++] = "--set";
        live->command[used++] = text_in_arena(&live->command_words, "%s=%s", parameter->name, value);
    }
    *count = used;
    return live->command;
}

static bool sound(const void *context, double from, double to, float *samples, size_t count) {
    BeamLive *live = (BeamLive *)context;
    const BeamTape *tape = &live->tape;
    double loudest = live->traces.seen.speed;
    if (from < beam_tape_begin(tape, tape->first) || to > tape->front_time || !(to > from) || !(loudest > 0))
        return false;
    double *velocity = memory_allocate(count, sizeof *velocity);
    beam_tape_velocities(&live->tape, from, to, velocity, count);
    for (size_t i = 0; i < count; i++)
        samples[i] = (float)fmax(-1, fmin(velocity[i] / loudest, 1));
    memory_free(velocity);
    return true;
}

const LiveKind beam_live = {
    .name = "Beam",
    .word = "beam",
    .plots_at_first = "phase,orbit,force,poincare,spectrum",
    .layers = layer_names,
    .meanings = layer_meanings,
    .layer_count = sizeof layer_names / sizeof *layer_names,
    .layers_at_first = BEAM_SCENE_ALL,
    .open = open_live,
    .close = close_live,
    .update = update,
    .span = span,
    .reach = reach,
    .show = show,
    .still = still,
    .added = added,
    .moving = moving,
    .look = look,
    .reveal = reveal,
    .plot_count = plot_count,
    .plot = plot,
    .until = until,
    .answer = answer,
    .clock = clock_words,
    .note = note,
    .title = title,
    .rows = rows,
    .ticks = ticks,
    .trouble = trouble,
    .parameters = parameters,
    .set = set,
    .reset = reset,
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
    .sound = sound,
};
