/* The plots next to a house, for the selected person or for all people. While a run is in progress the axes end at
 * round numbers and only grow; for a complete run they fit the data. */
#include <string.h>

#include "laboratory/house/runs.h"

#define FIRST_SECONDS 10.0 /* s, least length of the time axis while a run is in progress */
#define THICK_TAIL 2.0     /* s, end of the line that is drawn thick in a plot whose x axis is not time */

static const char *const titles[HOUSE_PLOTS_KNOWN] = {"Speed", "Clearance", "Contact force", "Personal space pressed",
                                                      "Sideways phase plane"};

/* Rounds away from zero to 1, 2 or 5 times a power of ten. */
static double round_out(double value) {
    if (!(fabs(value) > 0))
        return 0;
    double power = pow(10, floor(log10(fabs(value)))), part = fabs(value) / power;
    double out = part <= 1 ? 1 : part <= 2 ? 2 : part <= 5 ? 5 : 10;
    return copysign(out * power, value);
}

static Box extent_of(const Plot *plot) {
    Box box = {{0, 0}, {0, 0}};
    for (size_t s = 0; s < plot->series_count; s++)
        for (size_t i = 0; i < plot->series[s].count; i++) {
            Vec2 value = plot_value(&plot->series[s], i);
            if (isfinite(value.x) && isfinite(value.y))
                box = box_include(box, value);
        }
    for (size_t g = 0; g < plot->guide_count; g++)
        box = box_include(box, plot->guides[g].upright ? vec2(plot->guides[g].at, 0) : vec2(0, plot->guides[g].at));
    return box;
}

/* Extends the axes until they contain the plot's data; true: the axes have changed. */
static bool grow_axes(Plot *plot, Box *grown, bool timed) {
    Box box = extent_of(plot), before = *grown;
    if (timed)
        box.high.x = fmax(box.high.x, FIRST_SECONDS);
    grown->low = vec2(fmin(before.low.x, round_out(box.low.x)), fmin(before.low.y, round_out(box.low.y)));
    grown->high = vec2(fmax(before.high.x, round_out(box.high.x)), fmax(before.high.y, round_out(box.high.y)));
    plot->x.low = grown->low.x;
    plot->x.high = grown->high.x;
    plot->y.low = grown->low.y;
    plot->y.high = grown->high.y;
    return memcmp(&before, grown, sizeof before) != 0;
}

void house_session_plots_make(HouseSession *session, bool anew) {
    static const PlotChoice all = {.indices = {0, 1, 2, 3, 4}, .count = HOUSE_PLOTS_KNOWN};
    ShownPlots *plots = &session->plots;
    size_t person = session->selected.kind == HOUSE_PERSON ? session->selected.index : SIZE_MAX;
    if (plots->made)
        house_plots_free(&plots->plots);
    plots->made = true;
    plots->plots = house_plots_make_of(&session->runs[RUN_SHOWN]->house, session->observation, session->trails.trails,
                                       house_runs_compared(session), person, &all);
    for (size_t i = 0; i < HOUSE_PLOTS_KNOWN; i++) {
        Plot *plot = &plots->plots.plots[i];
        if (anew)
            plots->grown[i] = (Box){{0, 0}, {0, 0}};
        bool timed = strcmp(house_plots_name(i), "phase") != 0;
        bool other = !session->whole && grow_axes(plot, &plots->grown[i], timed);
        plots->revision[i] += anew || other;
    }
}

void house_session_plots_clear(HouseSession *session) {
    if (session->plots.made)
        house_plots_free(&session->plots.plots);
    session->plots.made = false;
}

LaboratoryPlot house_session_plots_at(const HouseSession *session, size_t index) {
    const char *name = house_plots_name(index);
    return (LaboratoryPlot){.name = name,
                            .title = titles[index],
                            .plot = &session->plots.plots.plots[index],
                            .revision = session->plots.revision[index],
                            .cursor = NAN,
                            .now = ROLE_PAPER,
                            .tail = strcmp(name, "phase") == 0 ? THICK_TAIL : 0};
}
