#include "laboratory/machine/diagram.h"

#include <math.h>
#include <string.h>

#include "base/parameters_number.h"

/* Diameter of a point in design points. */
#define LINE 1.6
#define LOCATED 9.0
#define DOT 2.2
#define SIGN 4.0

#define WIPED 0.55 /* of the distance of two values, that a new one stands for: a little more than half of it */

void machine_diagram_open(MachineDiagram *diagram, const MachineKind *kind) {
    static const PlotSeries looks[MACHINE_DIAGRAM_SERIES] = {
        {.role = ROLE_GHOST, .symbol = SYMBOL_TRIANGLE, .size = SIGN},
        {.role = ROLE_WALL, .symbol = SYMBOL_DISC, .size = DOT},
        {.role = ROLE_LOCUS, .symbol = SYMBOL_BOX, .size = SIGN, .open = true},
        {.role = ROLE_LOCUS_SECOND, .symbol = SYMBOL_DISC, .size = DOT}, /* drawn within the boxes where both occur */
        {.role = ROLE_LOCUS, .width = LINE},
        {.role = ROLE_LOCUS, .style = LINE_DASHED, .width = LINE},
        {.role = ROLE_IMPACT, .symbol = SYMBOL_DIAMOND, .size = LOCATED},
        {.role = ROLE_FURNITURE_LINE, .symbol = SYMBOL_DISC, .size = DOT}};
    *diagram = (MachineDiagram){.revision = 1};
    memcpy(diagram->series, looks, sizeof looks);
    diagram->plot = (Plot){.title = "All rhythms at a glance (orbit diagram)",
                           .y = {.title = kind->peak, .unit = "N"},
                           .series = diagram->series,
                           .series_count = MACHINE_DIAGRAM_SERIES,
                           .areas = diagram->areas};
}

void machine_diagram_close(MachineDiagram *diagram) {
    for (size_t s = 0; s <= MACHINE_SWEEP_PASSES; s++)
        machine_sweep_points_clear(&diagram->points[s]);
    machine_sweep_points_clear(&diagram->older);
    machine_lines_clear(&diagram->lines);
    arena_clear(&diagram->band_words);
}

static void show_points(PlotSeries *series, const MachineSweepPoints *points) {
    series->x = points->value;
    series->y = points->peak;
    series->count = points->count;
}

/* Points the series to the points' arrays, which may have moved. */
static void take_points(MachineDiagram *diagram) {
    PlotSeries *passes = diagram->series + MACHINE_DIAGRAM_PASSES, *lines = diagram->series + MACHINE_DIAGRAM_LINES;
    PlotSeries *older = &diagram->series[MACHINE_DIAGRAM_OLDER];
    for (size_t s = 0; s <= MACHINE_SWEEP_PASSES; s++)
        show_points(&diagram->series[s], &diagram->points[s]);
    for (size_t line = 0; line < MACHINE_LINES; line++) {
        static const char *const names[MACHINE_LINES] = {"stable", "unstable", "located"};
        lines[line].x = diagram->lines.points[line].value;
        lines[line].y = diagram->lines.points[line].peak;
        lines[line].count = diagram->lines.points[line].count;
        lines[line].name = lines[line].count ? names[line] : NULL;
    }
    show_points(older, &diagram->older);
    bool stored = diagram->points[0].count > 0;
    diagram->series[MACHINE_DIAGRAM_SAVED].name = stored ? "before" : NULL;
    passes[MACHINE_SWEEP_REST].name = stored && !diagram->carried ? "now" : NULL;
    passes[MACHINE_SWEEP_UP].name = diagram->carried ? "upwards" : NULL;
    passes[MACHINE_SWEEP_DOWN].name = diagram->carried ? "downwards" : NULL;
    older->name = older->count ? "updating" : NULL;
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

/* Begins without points; those of other numbers are shown pale until there are new ones. */
static void begin(MachineDiagram *diagram, bool keep_older) {
    const MachineSweepTask *task = &diagram->task;
    for (size_t s = 1; s <= MACHINE_SWEEP_PASSES; s++) {
        for (size_t i = 0; i < diagram->points[s].count && keep_older; i++)
            machine_sweep_points_add(&diagram->older, diagram->points[s].value[i], diagram->points[s].peak[i]);
        diagram->points[s].count = 0;
    }
    if (!keep_older)
        diagram->older.count = 0;
    diagram->done = 0;
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
    if (other) /* the displayed points belong to another parameter */
        diagram->points[0].count = 0;
    begin(diagram, !other);
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

/* Removes the older points at the values that are computed now. */
static void wipe_older(MachineDiagram *diagram, size_t done) {
    const MachineSweepTask *task = &diagram->task;
    const MachineKind *kind = task->kind;
    size_t steps = task->carried ? kind->carried_steps : (kind->steps - 1) / kind->coarse + 1, left = 0;
    double reach = WIPED * fabs(task->to - task->from) / (double)(steps - 1);
    MachineSweepPoints *older = &diagram->older;
    for (; diagram->done < done && older->count; diagram->done++, left = 0) {
        MachineSweepPass pass;
        double value = machine_sweep_value(task, diagram->done, &pass);
        for (size_t i = 0; i < older->count; i++)
            if (fabs(older->value[i] - diagram->factor * value) > diagram->factor * reach) {
                older->value[left] = older->value[i];
                older->peak[left++] = older->peak[i];
            }
        older->count = left;
    }
    diagram->done = done;
    if (done == machine_sweep_values(task))
        older->count = 0;
}

void machine_diagram_apply(MachineDiagram *diagram, MachineNews *news) {
    double most = news->followed ? take_lines(diagram, &news->lines) : 0;
    size_t older = diagram->older.count;
    if (news->sweep_begins)
        begin(diagram, true);
    for (size_t pass = 0; pass < MACHINE_SWEEP_PASSES; pass++) {
        const MachineSweepPoints *fresh = &news->points[pass];
        for (size_t i = 0; i < fresh->count; i++) {
            machine_sweep_points_add(&diagram->points[1 + pass], diagram->factor * fresh->value[i], fresh->peak[i]);
            most = fmax(most, fresh->peak[i]);
        }
        machine_sweep_points_clear(&news->points[pass]);
    }
    if (news->swept)
        wipe_older(diagram, news->sweep_done);
    diagram->revision += diagram->older.count != older;
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
