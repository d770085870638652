/* The cells of a map of types over two parameters of a machine, from coarse to fine.
 *
 * A cell's type is that of study/types.h, from one start, in a window of +-1 % in the map's two parameters alone: five
 * quick runs instead of the hundreds of the whole definition, so that a map takes minutes. A cell of type III is one
 * whose motion, or one within 1 % of it, is not periodic; of type II one whose largest force changes steeply, or whose
 * period doubles, within 1 %. */
#pragma once

#include "base/stop.h"
#include "laboratory/machine/machine.h"
#include "study/types.h"

/* Returns the number of cells; 0: the kind has no map. */
size_t machine_map_cells_count(const MachineKind *kind);

/* Returns the index of the nth cell to compute: first every fourth column and row, then every second, then all. The
 * index counts along the first axis, from the lowest values on. */
size_t machine_map_cells_nth(const MachineKind *kind, size_t nth);

/* Returns the value of a cell along an axis, in the parameter's unit. */
double machine_map_cells_value(const MachineKind *kind, size_t axis, size_t cell);

/* Returns the type of a cell; TYPES_KIND_INTERRUPTED: it was stopped. */
TypesKind machine_map_cells_type(const MachineKind *kind, const Machine *machine, size_t cell, int jobs,
                                 const Stop *stop);
