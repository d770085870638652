#include "laboratory/machine/map_cells.h"

enum { COARSEST = 4 };

size_t machine_map_cells_count(const MachineKind *kind) {
    return kind->map[0].name ? kind->map[0].steps * kind->map[1].steps : 0;
}

/* True if a cell belongs to the columns and rows that are `stride` apart. */
static bool is_on(const MachineKind *kind, size_t cell, size_t stride) {
    size_t columns = kind->map[0].steps;
    return cell % columns % stride == 0 && cell / columns % stride == 0;
}

size_t machine_map_cells_nth(const MachineKind *kind, size_t nth) {
    size_t cells = machine_map_cells_count(kind);
    for (size_t stride = COARSEST; stride; stride /= 2)
        for (size_t cell = 0; cell < cells; cell++) {
            bool is_new = is_on(kind, cell, stride) && (stride == COARSEST || !is_on(kind, cell, 2 * stride));
            if (is_new && nth-- == 0)
                return cell;
        }
    return cells - 1;
}

double machine_map_cells_value(const MachineKind *kind, size_t axis, size_t cell) {
    const MachineMapAxis *along = &kind->map[axis];
    size_t columns = kind->map[0].steps, step = axis ? cell / columns : cell % columns;
    return along->from + (along->to - along->from) * (double)step / (double)(along->steps - 1);
}

TypesKind machine_map_cells_type(const MachineKind *kind, const Machine *machine, size_t cell, int jobs,
                                 const Stop *stop) {
    const char *names[MACHINE_MAP_AXES];
    Machine own = *machine;
    Experiment quick;
    Types types = {.kind = TYPES_UNRESOLVED};
    Fault fault = {0};
    bool good = true;
    for (size_t a = 0; a < MACHINE_MAP_AXES; a++) {
        names[a] = kind->map[a].name;
        good = good && parameters_set_number(parameters_find(kind->table(), names[a]), &own,
                                             machine_map_cells_value(kind, a, cell), &fault);
    }
    if (good && kind->open_experiment(&quick, &own, &fault)) {
        TypesTask task = {.experiment = &quick,
                          .names = names,
                          .name_count = MACHINE_MAP_AXES,
                          .starts = 1,
                          .window_only = true,
                          .jobs = jobs,
                          .stop = stop};
        if (!types_classify(&types, &task, &fault))
            types.kind = TYPES_UNRESOLVED;
        kind->close_experiment(&quick);
    }
    fault_clear(&fault);
    return types.kind;
}
