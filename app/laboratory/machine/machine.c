#include "laboratory/machine/machine.h"

#include "base/parameters_number.h"

const char **machine_provenance(const MachineKind *kind, Machine *machine, const Parameter *row) {
    return (const char **)((char *)machine + kind->provenances) + (row - kind->table()->rows);
}

bool machine_same(const MachineKind *kind, const Machine *a, const Machine *b) {
    return parameters_number_same(kind->table(), a, b);
}
