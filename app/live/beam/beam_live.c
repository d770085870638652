#include "live/beam/beam_live.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/clock.h"
#include "base/text.h"
#include "visual/beam/beam_film.h"
#include "live/beam/beam_live_change.h"
#include "live/beam/beam_live_show.h"
#include "experiment/beam_numbers.h"
#include "live/live_save.h"

#define BUSY_MOST 2e-3 /* s, that the motion is followed at a time */

enum { STEPS = 60 /* a cycle, from picture to picture */ };

/* Opening -----------------------------------------------------------------------------------------------------------*/

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

/* The answer goes with the record. */
static void look_at_answer(BeamLive *live) {
    if (live->looked == live->tape.front)
        return;
    live->looked = live->tape.front;
    BeamLately lately = beam_answer_look(&live->tape);
    beam_answer_write(&live->answer, &live->tape, &live->beam, &lately, live->told ? &live->verdict : NULL);
    live->news |= LIVE_WORDS;
}

static void *open_live(const char *path, const LiveOptions *options, Fault *fault) {
    BeamLive *live = memory_zeroed(1, sizeof *live);
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
    beam_live_change_show_choices(live);
    live->news = LIVE_ALL & ~LIVE_TROUBLE;
    beam_live_advance(live);
    beam_live_change_ask(live, true);
    look_at_answer(live);
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

static LiveSpan span(const void *context) {
    const BeamLive *live = context;
    const BeamTape *tape = &live->tape;
    double frequency = live->beam.frequency;
    return (LiveSpan){.begin = beam_tape_begin(tape, tape->first),
                      .end = tape->front_time,
                      .complete = beam_live_has_ended(live),
                      .endless = !beam_live_has_ended(live),
                      .pace = 1 / beam_film_slow(frequency),
                      .step = 1 / frequency / STEPS,
                      .fastest = 1024};
}

void beam_live_advance(BeamLive *live) {
    live->news |= live->tape.next ? LIVE_WORDS : 0;
    if (beam_tape_advance(&live->tape))
        return;
    arena_clear(&live->troubles);
    live->trouble = beam_answer_trouble(&live->tape, &live->troubles);
    live->looked = SIZE_MAX;
    live->news |= LIVE_TROUBLE | LIVE_WORDS;
}

static double reach(void *context, double time) {
    BeamLive *live = context;
    BeamTape *tape = &live->tape;
    double until = clock_now() + BUSY_MOST;
    while (tape->front_time <= time && !beam_live_has_ended(live)) {
        beam_live_advance(live);
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
    BeamLive *live = context;
    BeamNews news;
    beam_worker_take(live->worker, &news);
    take_news(live, &news);
    look_at_answer(live);
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
    if (beam_live_has_ended(live))
        live->ticks[(*count)++] = (LiveTick){tape->front_time, LIVE_TICK_TROUBLE};
    return live->ticks;
}

static const char *trouble(const void *context, double *time) {
    const BeamLive *live = context;
    *time = live->tape.front_time;
    return beam_live_has_ended(live) ? live->trouble : NULL;
}

static const char *const layer_names[] = {"loupe", "forces", "names", "sources"};
static const char *const layer_meanings[] = {"the tip between its stops, enlarged",
                                             "the shaker's force, and those of the stops", "what the parts are called",
                                             "below each name its numbers, and where they come from"};

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

static bool save(const void *context, const char *path, Fault *fault) {
    size_t count;
    const char *const *words = beam_live_change_command(context, &count);
    return live_save_beam(words, count, path, fault);
}

const LiveKind beam_live = {
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
    .still = beam_live_show_still,
    .added = beam_live_show_added,
    .moving = beam_live_show_moving,
    .look = beam_live_show_look,
    .reveal = beam_live_show_reveal,
    .plot_count = beam_live_show_plot_count,
    .plot = beam_live_show_plot,
    .until = beam_live_show_until,
    .answer = answer,
    .clock = clock_words,
    .note = note,
    .title = title,
    .rows = rows,
    .ticks = ticks,
    .trouble = trouble,
    .parameters = beam_live_change_parameters,
    .set = beam_live_change_set,
    .reset = beam_live_change_reset,
    .presets = beam_live_change_presets,
    .prefer = beam_live_change_prefer,
    .choices = beam_live_change_choices,
    .choose = beam_live_change_choose,
    .again = beam_live_change_again,
    .keep = beam_live_change_keep,
    .clear = beam_live_change_clear,
    .pick = pick,
    .next = next,
    .select = select_thing,
    .selected = selected,
    .name_thing = name_thing,
    .outline = outline,
    .command = beam_live_change_command,
    .save = save,
    .sound = beam_live_show_sound,
};
