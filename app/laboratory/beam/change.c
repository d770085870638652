#include "laboratory/beam/change.h"

#include "base/parameters_number.h"
#include "base/text.h"
#include "experiment/beam_numbers.h"

static const char *const sweeps[] = {"from rest", "upwards and downwards"};

enum { CHOICE_SWEEP, CHOICE_OVER, CHOICES };

void beam_change_show_choices(BeamSession *live) {
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

void beam_change_ask(BeamSession *live, bool verdict) {
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
    beam_change_ask(live, true);
    return true;
}

const PanelParameter *beam_change_parameters(const void *context, size_t *count) {
    const BeamSession *live = context;
    *count = live->controls.count;
    return live->controls.parameters;
}

bool beam_change_set(void *context, const char *name, double value, Fault *fault) {
    BeamSession *live = context;
    Beam beam = live->beam;
    return beam_controls_set(&live->controls, &beam, name, value, fault) && change(live, &beam, fault);
}

void beam_change_reset(void *context) {
    BeamSession *live = context;
    Fault none = {0};
    change(live, &live->controls.file, &none);
    fault_clear(&none);
}

const Preset *beam_change_presets(const void *context, size_t *count) {
    const BeamSession *live = context;
    *count = BEAM_PRESETS;
    return live->controls.presets;
}

void beam_change_prefer(void *context, size_t preset) {
    BeamSession *live = context;
    Beam beam;
    Fault none = {0};
    beam_controls_prefer(&live->controls, preset, &beam);
    change(live, &beam, &none);
    fault_clear(&none);
}

const PanelChoice *beam_change_choices(void *context, size_t *count) {
    *count = CHOICES;
    return ((const BeamSession *)context)->choices;
}

void beam_change_choose(void *context, size_t choice, size_t word) {
    BeamSession *live = context;
    if (choice == CHOICE_SWEEP)
        live->diagram.carried = word == 1;
    else
        live->diagram.over = word;
    beam_change_show_choices(live);
    beam_change_ask(live, false);
}

void beam_change_again(void *context) {
    BeamSession *live = context;
    Fault none = {0};
    if (beam_tape_restart(&live->tape, &live->beam, &none)) {
        beam_session_advance(live);
        beam_traces_forget(&live->traces, 0);
        live->shown = 0;
        live->looked = SIZE_MAX;
        live->news |= LABORATORY_WORDS;
    }
    fault_clear(&none);
}

bool beam_change_keep(void *context, double time) {
    BeamSession *live = context;
    beam_traces_keep(&live->traces, time);
    beam_diagram_keep(&live->diagram, true);
    return true;
}

void beam_change_clear(void *context, double time) {
    BeamSession *live = context;
    double phase;
    beam_traces_keep(&live->traces, -1);
    beam_diagram_keep(&live->diagram, false);
    beam_traces_forget(&live->traces, beam_tape_cycle_at(&live->tape, time, &phase));
    beam_traces_show(&live->traces, &live->tape, time);
}

const char *const *beam_change_command(void *context, size_t *count) {
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
