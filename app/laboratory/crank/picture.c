#include "laboratory/crank/picture.h"

#include <math.h>

/* The plots over time, the orbit diagram, and the map of types. */
enum { ORBIT = CRANK_TRACES, MAP, PLOTS };

static const char *const plot_names[] = {"phase",  "poincare", "section", "force",
                                         "slider", "spectrum", "orbit",   MACHINE_MAP_NAME};
static const char *const plot_titles[] = {"Where the ball goes (phase plane)",
                                          "Once a revolution (Poincar\u00E9 map)",
                                          "Once a revolution, across (Poincar\u00E9 map)",
                                          "Force over time",
                                          "Slider's error",
                                          "Tones (spectrum)",
                                          "All rhythms at a glance (orbit diagram)",
                                          "Where it is safe (map of types)"};

size_t crank_picture_plot_count(const void *context) {
    (void)context;
    return PLOTS;
}

LaboratoryPlot crank_picture_plot(const void *context, size_t index) {
    const CrankSession *session = context;
    LaboratoryPlot shown = {.cursor = NAN, .now = ROLE_DANGER_MIDDLE};
    if (index == ORBIT) {
        shown = machine_diagram_shown(&session->machine.diagram, &session->machine.controls);
    } else if (index == MAP) {
        shown = machine_map_shown(&session->machine.map, &session->machine.controls);
    } else {
        shown.plot = &session->traces.plots[index];
        shown.revision = session->traces.revisions[index];
    }
    shown.name = plot_names[index];
    shown.title = plot_titles[index];
    return shown;
}

size_t crank_picture_points_until(const void *context, size_t index, size_t series, double time) {
    const CrankSession *session = context;
    if (index == MAP)
        return 0;
    return index == ORBIT ? session->machine.diagram.series[series].count
                          : crank_traces_until(&session->traces, index, series, time);
}

/* The sound is the slider's velocity. */
bool crank_picture_sound(void *context, double from, double to, float *samples, size_t count) {
    CrankSession *session = context;
    const CrankTape *tape = &session->tape;
    if (from < crank_tape_return(tape, tape->first)->begin || to > tape->front_time || !(to > from))
        return false;
    for (size_t i = 0; i < count; i++) {
        size_t row, cycle = crank_tape_cycle_at(tape, from + (to - from) * (double)i / (double)count, &row);
        const CrankTapeCycle *at = crank_tape_cycle(tape, cycle);
        const Tree *tree = &crank_tape_part(tape, cycle)->tree;
        double rate = row < at->row_count ? crank_tape_row(at, row)[CRANK_TAPE_SLIDER_RATE] : 0;
        samples[i] = (float)fmax(-1, fmin(rate / (tree->omega * tree->radius * 1.5), 1));
    }
    return true;
}
