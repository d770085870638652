#include "laboratory/machine/controls.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/parameters_number.h"
#include "base/text.h"

static const char set_here[] = "assumed: set in the window";

static const char *group_of(const MachineKind *kind, const char *name) {
    for (size_t g = 0; g < kind->group_count; g++)
        if (strncmp(kind->groups[g] + 1, name + 1, strcspn(name, ".") - 1) == 0)
            return kind->groups[g];
    return "";
}

static const MachineLooks *looks_of(const MachineKind *kind, const char *name) {
    for (size_t i = 0; i < kind->look_count; i++)
        if (strcmp(kind->looks[i].name, name) == 0)
            return &kind->looks[i];
    return NULL;
}

/* Sets the useful part of the range: around the value in the file if that is positive. */
static void set_range(PanelParameter *parameter, const MachineLooks *looks) {
    double value = parameter->initial;
    bool about = looks->high > 0 && value > 0;
    parameter->low = fmax(about ? looks->low * value : looks->least, parameter->row->low);
    parameter->high = fmax(about ? looks->high * value : 0, looks->most);
    if (parameter->row->kind != PARAMETER_CHOICE)
        parameter->high = fmin(parameter->high, parameter->row->high);
    if (!about) {
        parameter->low = fmin(parameter->low, value);
        parameter->high = fmax(parameter->high, value);
    }
}

static PanelParameter make_parameter(MachineControls *controls, const MachineLooks *looks) {
    const MachineKind *kind = controls->kind;
    const Parameter *row = parameters_find(kind->table(), looks->name);
    PanelParameter parameter = {.name = looks->name,
                                .group = group_of(kind, looks->name),
                                .label = looks->label,
                                .row = row,
                                .meaning = row->meaning,
                                .provenance = *machine_provenance(kind, &controls->file, row),
                                .unit = looks->unit,
                                .factor = looks->factor,
                                .initial = parameters_number_get(row, &controls->file),
                                .logarithmic = looks->logarithmic,
                                .first = looks->first};
    set_range(&parameter, looks);
    return parameter;
}

/* Presets -----------------------------------------------------------------------------------------------------------*/

void machine_controls_prefer(const MachineControls *controls, size_t preset, Machine *machine) {
    const MachinePreset *preferred = &controls->kind->presets[preset];
    *machine = controls->file;
    Fault none = {0};
    for (size_t i = 0; i < MACHINE_CHANGES && preferred->changes[i].name; i++) {
        const PanelParameter *parameter = machine_controls_find(controls, preferred->changes[i].name);
        double value = preferred->changes[i].value;
        if (preferred->changes[i].times)
            value *= parameter->initial;
        machine_controls_set(controls, machine, parameter->name, value, &none);
    }
    fault_clear(&none);
}

bool machine_controls_name_type(MachineControls *controls, const Machine *machine, const char *type) {
    bool named = false;
    for (size_t p = 0; p < controls->kind->preset_count; p++) {
        Machine preferred;
        machine_controls_prefer(controls, p, &preferred);
        if (controls->typed[p] || !machine_same(controls->kind, &preferred, machine))
            continue;
        snprintf(controls->names[p], MACHINE_PRESET_NAME, "%s  %s", type, controls->kind->presets[p].name);
        named = controls->typed[p] = true;
    }
    return named;
}

/* -------------------------------------------------------------------------------------------------------------------*/

void machine_controls_open(MachineControls *controls, const MachineKind *kind, const Machine *file) {
    *controls = (MachineControls){.kind = kind, .file = *file, .count = kind->look_count};
    for (size_t i = 0; i < controls->count; i++)
        controls->parameters[i] = make_parameter(controls, &kind->looks[i]);
    for (size_t p = 0; p < kind->preset_count; p++) {
        snprintf(controls->names[p], MACHINE_PRESET_NAME, "%s", kind->presets[p].name);
        controls->presets[p] = (Preset){controls->names[p], kind->presets[p].meaning};
    }
}

void machine_controls_show(MachineControls *controls, const Machine *machine) {
    Machine shown = *machine;
    for (size_t i = 0; i < controls->count; i++) {
        PanelParameter *parameter = &controls->parameters[i];
        parameter->value = parameters_number_get(parameter->row, machine);
        parameter->provenance = *machine_provenance(controls->kind, &shown, parameter->row);
    }
}

const PanelParameter *machine_controls_find(const MachineControls *controls, const char *name) {
    for (size_t i = 0; i < controls->count; i++)
        if (strcmp(controls->parameters[i].name, name) == 0)
            return &controls->parameters[i];
    return NULL;
}

bool machine_controls_set(const MachineControls *controls, Machine *machine, const char *name, double value,
                          Fault *fault) {
    const PanelParameter *parameter = machine_controls_find(controls, name);
    if (!parameter) {
        fault_add(fault, "a %s has no parameter \"%.60s\"", controls->kind->word, name);
        return false;
    }
    if (!parameters_set_number(parameter->row, machine, value, fault))
        return false;
    Machine file = controls->file;
    *machine_provenance(controls->kind, machine, parameter->row) =
        value == parameter->initial ? *machine_provenance(controls->kind, &file, parameter->row) : set_here;
    return true;
}

void machine_controls_words(const PanelParameter *parameter, double value, char *text, size_t size) {
    double factor = parameter->factor, most = fmax(fabs(factor * parameter->high), fabs(factor * value));
    int digits = most > 0 ? (int)fmax(1, 2 - floor(log10(most))) : 1;
    if (parameter->row->kind != PARAMETER_NUMBER)
        digits = 0;
    const char *unit = parameter->unit ? parameter->unit : parameter->row->unit;
    bool bare = !*unit || strcmp(unit, "1") == 0;
    snprintf(text, size, "%.*f%s%s", digits, factor * value, bare ? "" : " ", bare ? "" : unit);
}

void machine_controls_sweep(const MachineControls *controls, const PanelParameter *parameter, double *from,
                            double *to) {
    const MachineLooks *looks = looks_of(controls->kind, parameter->name);
    bool about = looks->to > 0 && parameter->initial > 0;
    *from = fmax(about ? looks->from * parameter->initial : parameter->low, parameter->row->low);
    *to = fmin(about ? looks->to * parameter->initial : parameter->high, parameter->row->high);
    double spare = (*to - *from) / 10;
    if (parameter->value < *from)
        *from = fmax(parameter->value - spare, parameter->row->low);
    if (parameter->value > *to)
        *to = fmin(parameter->value + spare, parameter->row->high);
}

size_t machine_controls_command(const MachineControls *controls, const char *path, const char **words, Arena *arena) {
    size_t used = 0;
    arena_clear(arena);
    words[used++] = "run";
    words[used++] = path;
    for (size_t i = 0; i < controls->count; i++) {
        const PanelParameter *parameter = &controls->parameters[i];
        if (parameter->value == parameter->initial)
            continue;
        words[used++] = "--set";
        words[used++] = text_in_arena(arena, "%s=%s", parameter->name,
                                      parameters_number_text(parameter->row, parameter->value, arena));
    }
    return used;
}
