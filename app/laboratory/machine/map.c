#include "laboratory/machine/map.h"

#include <math.h>
#include <string.h>

#include "base/parameters_number.h"

/* The last one is named where it occurs. */
static const PlotClass classes[MACHINE_MAP_CLASSES] = {
    {"type I", "I", ROLE_TYPE_FIRST, PLOT_PATTERN_PLAIN},
    {"type II", "II", ROLE_TYPE_SECOND, PLOT_PATTERN_RISING},
    {"type III", "III", ROLE_TYPE_THIRD, PLOT_PATTERN_PLAIN},
    {"unresolved", "?", ROLE_CLASS_NONE, PLOT_PATTERN_RISING},
};

enum { UNRESOLVED = MACHINE_MAP_CLASSES - 1 };

/* Empties all cells. */
static void begin_anew(MachineMap *map) {
    for (size_t i = 0; i < MACHINE_MAP_CELLS; i++)
        map->values[i] = NAN;
    map->revision++;
}

static PlotAxis axis_of(const MachineControls *controls, size_t axis, double *low, double *high) {
    const MachineMapAxis *along = &controls->kind->map[axis];
    const PanelParameter *parameter = machine_controls_find(controls, along->name);
    double half = (along->to - along->from) / (double)(along->steps - 1) / 2;
    *low = parameter->factor * (along->from - half);
    *high = parameter->factor * (along->to + half);
    return (PlotAxis){.title = along->word,
                      .unit = parameter->unit ? parameter->unit : parameter->row->unit,
                      .low = *low,
                      .high = *high};
}

void machine_map_open(MachineMap *map, const MachineControls *controls) {
    const MachineKind *kind = controls->kind;
    *map = (MachineMap){.revision = 1};
    if (!machine_map_cells_count(kind))
        return;
    memcpy(map->classes, classes, sizeof classes);
    map->raster = (PlotRaster){.columns = kind->map[0].steps,
                               .rows = kind->map[1].steps,
                               .values = map->values,
                               .classes = map->classes,
                               .class_count = UNRESOLVED};
    map->plot = (Plot){.title = "Types over speed and clearance",
                       .x = axis_of(controls, 0, &map->raster.box.low.x, &map->raster.box.high.x),
                       .y = axis_of(controls, 1, &map->raster.box.low.y, &map->raster.box.high.y),
                       .raster = &map->raster};
    begin_anew(map);
}

/* True if the machines differ in the map's own parameters at most. */
static bool same_but_place(const MachineKind *kind, const Machine *a, const Machine *b) {
    Machine like = *b;
    Fault none = {0};
    for (size_t i = 0; i < MACHINE_MAP_AXES; i++) {
        const Parameter *row = parameters_find(kind->table(), kind->map[i].name);
        parameters_set_number(row, &like, parameters_number_get(row, a), &none);
    }
    fault_clear(&none);
    return machine_same(kind, a, &like);
}

void machine_map_ask(MachineMap *map, const MachineKind *kind, const Machine *machine, MachineWorker *worker) {
    if (!machine_map_cells_count(kind) || !map->shown)
        return;
    if (map->asked && same_but_place(kind, &map->machine, machine))
        return;
    map->asked = true;
    map->machine = *machine;
    begin_anew(map);
    machine_worker_ask_map(worker, machine);
}

void machine_map_show(MachineMap *map, bool shown, const MachineKind *kind, const Machine *machine,
                      MachineWorker *worker) {
    if (!machine_map_cells_count(kind))
        return;
    map->shown = shown;
    machine_worker_pause_map(worker, !shown);
    machine_map_ask(map, kind, machine, worker);
}

void machine_map_apply(MachineMap *map, const MachineNews *news) {
    bool unresolved = false;
    for (size_t i = 0; i < MACHINE_MAP_CELLS; i++) {
        double type = news->map.type[i];
        map->values[i] = isnan(type) ? NAN : type >= TYPES_I && type <= TYPES_III ? type - TYPES_I : UNRESOLVED;
        unresolved |= map->values[i] == UNRESOLVED;
    }
    map->raster.class_count = UNRESOLVED + unresolved;
    map->revision++;
}

LaboratoryPlot machine_map_shown(const MachineMap *map, const MachineControls *controls) {
    const MachineMapAxis *axes = controls->kind->map;
    const PanelParameter *x = machine_controls_find(controls, axes[0].name),
                         *y = machine_controls_find(controls, axes[1].name);
    return (LaboratoryPlot){.plot = &map->plot,
                            .revision = map->revision,
                            .still = true,
                            .cursor = x->factor * x->value,
                            .cursor_parameter = axes[0].name,
                            .cursor_factor = x->factor,
                            .cursor_y = y->factor * y->value,
                            .cursor_y_parameter = axes[1].name,
                            .cursor_y_factor = y->factor,
                            .now = ROLE_PAPER};
}
