#include "laboratory/beam/picture.h"

#include <math.h>

/* The plots over time, and the orbit diagram. */

static const char *const plot_names[] = {"phase", "poincare", "force", "spectrum", "orbit"};
static const char *const plot_titles[] = {"Where the tip goes (phase plane)", "Once a cycle (Poincar\u00E9 map)",
                                          "Force over time", "Tones (spectrum)",
                                          "All rhythms at a glance (orbit diagram)"};

size_t beam_picture_plot_count(const void *context) {
    (void)context;
    return BEAM_TRACES + 1;
}

LaboratoryPlot beam_picture_plot(const void *context, size_t index) {
    const BeamSession *session = context;
    LaboratoryPlot shown = {.cursor = NAN, .now = ROLE_DANGER_MIDDLE};
    if (index == BEAM_TRACES) {
        shown = machine_diagram_shown(&session->machine.diagram, &session->machine.controls);
    } else {
        shown.plot = &session->traces.plots[index];
        shown.revision = session->traces.revisions[index];
        shown.still = index == BEAM_TRACE_SPECTRUM;
    }
    shown.name = plot_names[index];
    shown.title = plot_titles[index];
    return shown;
}

size_t beam_picture_points_until(const void *context, size_t index, size_t series, double time) {
    const BeamSession *session = context;
    return index == BEAM_TRACES ? session->machine.diagram.series[series].count
                                : beam_traces_until(&session->traces, index, series, time);
}

bool beam_picture_sound(void *context, double from, double to, float *samples, size_t count) {
    BeamSession *session = context;
    const BeamTape *tape = &session->tape;
    double loudest = session->traces.seen.speed;
    if (from < beam_tape_begin(tape, tape->first) || to > tape->front_time || !(to > from) || !(loudest > 0))
        return false;
    double *velocity = memory_zeroed(count, sizeof *velocity);
    beam_tape_velocities(&session->tape, from, to, velocity, count);
    for (size_t i = 0; i < count; i++)
        samples[i] = (float)fmax(-1, fmin(velocity[i] / loudest, 1));
    memory_free(velocity);
    return true;
}
