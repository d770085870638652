/* The parameters of a running machine as sliders show them, and its presets. */
#pragma once

#include "laboratory/laboratory.h"

#include "laboratory/machine/machine.h"

enum { MACHINE_PRESET_NAME = 40 };

typedef struct MachineControls {
    const MachineKind *kind;
    Machine file; /* the machine as in its file, whose texts belong to the session */
    PanelParameter parameters[MACHINE_VALUES];
    size_t count;
    Preset presets[MACHINE_PRESETS_MOST];
    char names[MACHINE_PRESETS_MOST][MACHINE_PRESET_NAME];
    bool typed[MACHINE_PRESETS_MOST]; /* the name contains the type */
} MachineControls;

/* Makes the controls of a machine read from its file, which its texts must outlive. */
void machine_controls_open(MachineControls *controls, const MachineKind *kind, const Machine *file);

/* Sets the displayed values to the values of this machine. */
void machine_controls_show(MachineControls *controls, const Machine *machine);

/* Returns the parameter with this name; NULL: none. */
const PanelParameter *machine_controls_find(const MachineControls *controls, const char *name);

/* Sets a number of a machine and its provenance. False: a fault. */
bool machine_controls_set(const MachineControls *controls, Machine *machine, const char *name, double value,
                          Fault *fault);

/* Makes `machine` the machine of a preset: the file's with the preset's changes. */
void machine_controls_prefer(const MachineControls *controls, size_t preset, Machine *machine);

/* Adds the type of a machine to the names of presets with the same numbers. True: at least one name has changed. */
bool machine_controls_name_type(MachineControls *controls, const Machine *machine, const char *type);

/* Writes a value of a parameter as it is displayed: "300.0 Hz". */
void machine_controls_words(const PanelParameter *parameter, double value, char *text, size_t size);

/* Returns the range of an orbit diagram over the parameter: its useful range, extended to its value. */
void machine_controls_sweep(const MachineControls *controls, const PanelParameter *parameter, double *from, double *to);

/* Writes the words after "clearance" that reproduce the displayed machine, with texts in the arena, which is emptied
 * first; returns their number, at most 2 + 2 x count. */
size_t machine_controls_command(const MachineControls *controls, const char *path, const char **words, Arena *arena);
