#include "laboratory/machine/diagram.h"

#include <math.h>
#include <string.h>

#include "base/parameters_number.h"

/* Diameter of a point in design points. */
#define LINE 1.6
#define LOCATED 9.0
#define DOT 2.2
#define SIGN 4.0

void machine_diagram_open(MachineDiagram *diagram, const MachineKind *kind) {
    static const PlotSeries looks[MACHINE_SWEEP_PASSES + 1 + MACHINE_LINES] = {
        {.role = ROLE_GHOST, .symbol = SYMBOL_TRIANGLE, .size = SIGN},
        {.role = ROLE_WALL, .symbol = SYMBOL_DISC, .size = DOT},
        {.role = ROLE_LOCUS, .symbol = SYMBOL_BOX, .size = SIGN, .open = true},
        {.role = ROLE_LOCUS_SECOND, .symbol = SYMBOL_DISC, .size = DOT}, /* drawn within the boxes where both occur */
        {.role = ROLE_LOCUS, .width = LINE},
        {.role = ROLE_LOCUS, .style = LINE_DASHED, .width = LINE},
        {.role = ROLE_IMPACT, .symbol = SYMBOL_DIAMOND, .size = LOCATED}};
    *diagram = (MachineDiagram){.revision = 1};
    memcpy(diagram->series, looks, sizeof looks);
    diagram->plot = (Plot){.title = "All rhythms at a glance (orbit diagram)",
                           .y = {.title = kind->peak, .unit = "N"},
                           .series = diagram->series,
                           .series_count = MACHINE_SWEEP_PASSES + 1 + MACHINE_LINES,
                           .areas = diagram->areas};
}

void machine_diagram_close(MachineDiagram *diagram) {
    for (size_t s = 0; s <= MACHINE_SWEEP_PASSES; s++)
        machine_sweep_points_clear(&diagram->points[s]);
    machine_lines_clear(&diagram->lines);
    arena_clear(&diagram->band_words);
}

/* Points the series to the points' arrays, which may have moved. */
static void take_points(MachineDiagram *diagram) {
    for (size_t s = 0; s <= MACHINE_SWEEP_PASSES; s++) {
        diagram->series[s].x = diagram->points[s].value;
        diagram->series[s].y = diagram->points[s].peak;
        diagram->series[s].count = diagram->points[s].count;
    }
    for (size_t line = 0; line < MACHINE_LINES; line++) {
        PlotSeries *series = &diagram->series[MACHINE_SWEEP_PASSES + 1 + line];
        static const char *const names[MACHINE_LINES] = {"stable", "unstable", "located"};
        series->x = diagram->lines.points[line].value;
        series->y = diagram->lines.points[line].peak;
        series->count = diagram->lines.points[line].count;
        series->name = series->count ? names[line] : NULL;
    }
    bool stored = diagram->points[0].count > 0;
    diagram->series[0].name = stored ? "before" : NULL;
    diagram->series[1 + MACHINE_SWEEP_REST].name = stored && !diagram->carried ? "now" : NULL;
    diagram->series[1 + MACHINE_SWEEP_UP].name = diagram->carried ? "upwards" : NULL;
    diagram->series[1 + MACHINE_SWEEP_DOWN].name = diagram->carried ? "downwards" : NULL;
}

static bool same_task(const MachineSweepTask *a, const MachineSweepTask *b) {
    if (!a->name || strcmp(a->name, b->name) != 0 || a->carried != b->carried || a->from != b->from || a->to != b->to)
        return false;
    const Parameter *row = parameters_find(b->kind->table(), b->name);
    Machine like = b->machine;
    Fault none = {0};
    parameters_set_number(row, &like, parameters_number_get(row, &a->machine), &none);
    fault_clear(&none);
    return machine_same(b->kind, &a->machine, &like);
}

static void begin_anew(MachineDiagram *diagram) {
    const MachineSweepTask *task = &diagram->task;
    for (size_t s = 1; s <= MACHINE_SWEEP_PASSES; s++)
        diagram->points[s].count = 0;
    diagram->plot.area_count = 0;
    diagram->plot.x.title = task->kind->over_titles[diagram->over];
    diagram->plot.x.low = diagram->factor * task->from;
    diagram->plot.x.high = diagram->factor * task->to;
    diagram->revision++;
}

/* Removes a followed orbit: it belongs to other numbers, or is not wanted any longer. */
static void forget_lines(MachineDiagram *diagram, MachineWorker *worker) {
    machine_worker_drop_follow(worker);
    machine_lines_clear(&diagram->lines);
    diagram->follows = false;
    diagram->revision++;
    take_points(diagram);
}

void machine_diagram_ask(MachineDiagram *diagram, const MachineControls *controls, const Machine *machine,
                         MachineWorker *worker) {
    const MachineKind *kind = controls->kind;
    const PanelParameter *parameter = machine_controls_find(controls, kind->over[diagram->over]);
    MachineSweepTask task = {.kind = kind, .machine = *machine, .name = parameter->name, .carried = diagram->carried};
    machine_controls_sweep(controls, parameter, &task.from, &task.to);
    diagram->factor = parameter->factor;
    machine_controls_words(parameter, parameter->value, diagram->cursor, sizeof diagram->cursor);
    if (same_task(&diagram->task, &task))
        return;
    bool other = !diagram->task.name || strcmp(diagram->task.name, task.name) != 0;
    diagram->task = task;
    diagram->plot.x.unit = parameter->unit ? parameter->unit : parameter->row->unit;
    if (other) { /* the displayed points belong to another parameter */
        diagram->points[0].count = 0;
        begin_anew(diagram);
        take_points(diagram);
    }
    forget_lines(diagram, worker);
    machine_worker_ask_sweep(worker, &task);
}

bool machine_diagram_follow(MachineDiagram *diagram, MachineWorker *worker, const Machine *machine, const double *state,
                            size_t count) {
    bool wanted = !diagram->follows && diagram->task.name;
    forget_lines(diagram, worker);
    if (!wanted)
        return false;
    MachineSweepTask task = diagram->task;
    task.machine = *machine;
    diagram->follows = true;
    machine_worker_ask_follow(worker, &task, state, count);
    return true;
}

/* Rounds up to 1, 1.5, 2, 3, 4, 5, 6 or 8 times a power of ten. */
static double round_up(double value) {
    static const double steps[] = {1, 1.5, 2, 3, 4, 5, 6, 8, 10};
    double power = pow(10, floor(log10(value)));
    size_t i = 0;
    while (i + 1 < sizeof steps / sizeof *steps && steps[i] * power < value)
        i++;
    return steps[i] * power;
}

/* Takes over a followed orbit in the displayed unit. Returns its largest force. */
static double take_lines(MachineDiagram *diagram, const MachineLines *lines) {
    double most = 0;
    machine_lines_clear(&diagram->lines);
    diagram->lines = *lines;
    for (size_t line = 0; line < MACHINE_LINES; line++)
        for (size_t i = 0; i < lines->points[line].count; i++) {
            diagram->lines.points[line].value[i] *= diagram->factor;
            most = fmax(most, isnan(lines->points[line].peak[i]) ? 0 : lines->points[line].peak[i]);
        }
    for (size_t i = 0; i < diagram->lines.located_count; i++)
        diagram->lines.located[i].value *= diagram->factor;
    diagram->revision++;
    return most;
}

static void take_bands(MachineDiagram *diagram, const MachineBands *bands) {
    double at[MACHINE_BANDS_MOST];
    for (size_t i = 0; i < bands->count; i++)
        at[i] = diagram->factor * bands->value[i];
    arena_clear(&diagram->band_words);
    diagram->plot.area_count = 0;
    type_bands_add(&diagram->plot, at, bands->type, bands->count, diagram->factor * bands->step,
                   type_bands_height(&diagram->plot), &diagram->band_words);
    diagram->revision++;
}

void machine_diagram_apply(MachineDiagram *diagram, MachineNews *news) {
    double most = news->followed ? take_lines(diagram, &news->lines) : 0;
    if (news->sweep_begins)
        begin_anew(diagram);
    for (size_t pass = 0; pass < MACHINE_SWEEP_PASSES; pass++) {
        const MachineSweepPoints *fresh = &news->points[pass];
        for (size_t i = 0; i < fresh->count; i++) {
            machine_sweep_points_add(&diagram->points[1 + pass], diagram->factor * fresh->value[i], fresh->peak[i]);
            most = fmax(most, fresh->peak[i]);
        }
        machine_sweep_points_clear(&news->points[pass]);
    }
    if (most > diagram->plot.y.high) {
        diagram->plot.y.high = round_up(most);
        diagram->revision++;
    }
    take_points(diagram);
    if (news->banded)
        take_bands(diagram, &news->bands);
}

void machine_diagram_store(MachineDiagram *diagram, bool keep) {
    diagram->points[0].count = 0;
    for (size_t s = 1; s <= MACHINE_SWEEP_PASSES && keep; s++)
        for (size_t i = 0; i < diagram->points[s].count; i++)
            machine_sweep_points_add(&diagram->points[0], diagram->points[s].value[i], diagram->points[s].peak[i]);
    diagram->revision++;
    take_points(diagram);
}

LaboratoryPlot machine_diagram_shown(const MachineDiagram *diagram, const MachineControls *controls) {
    const char *over = controls->kind->over[diagram->over];
    return (LaboratoryPlot){.plot = &diagram->plot,
                            .revision = diagram->revision,
                            .still = true,
                            .cursor = diagram->factor * machine_controls_find(controls, over)->value,
                            .cursor_text = diagram->cursor,
                            .cursor_parameter = over,
                            .cursor_factor = diagram->factor,
                            .now = ROLE_PAPER};
}
