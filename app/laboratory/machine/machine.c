#include "laboratory/machine/machine.h"

#include <math.h>

#include "base/parameters_number.h"

const char *machine_name(const MachineKind *kind, const Machine *machine) {
    return *(const char *const *)((const char *)machine + kind->name);
}

const char **machine_provenance(const MachineKind *kind, Machine *machine, const Parameter *row) {
    return (const char **)((char *)machine + kind->provenances) + (row - kind->table()->rows);
}

bool machine_set(const Parameter *row, Machine *machine, double value, Fault *fault) {
    if (!isfinite(value)) {
        fault_add(fault, "%s must be a number", row->name);
        return false;
    }
    char place[] = "";
    Arena none = {0}; /* numbers need no memory */
    JsonFile file = {.path = place, .root = parameters_number_json(row, value)};
    JsonNode node = json_root(&file);
    bool good = parameters_read_value(row, machine, &node, &none, fault);
    json_decref(file.root);
    return good;
}

bool machine_same(const MachineKind *kind, const Machine *a, const Machine *b) {
    const ParameterTable *table = kind->table();
    for (size_t i = 0; i < table->count; i++)
        if (parameters_number_get(&table->rows[i], a) != parameters_number_get(&table->rows[i], b))
            return false;
    return true;
}
