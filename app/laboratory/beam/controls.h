/* The parameters of a running beam as sliders show them, and its presets. */
#pragma once

#include "laboratory/laboratory.h"

#include "beam/beam.h"

enum { BEAM_PRESETS = 6, BEAM_PRESET_NAME = 40 };

typedef struct BeamControls {
    Beam file; /* the beam as in its file */
    PanelParameter parameters[BEAM_VALUES];
    size_t count;
    Preset presets[BEAM_PRESETS];
    char names[BEAM_PRESETS][BEAM_PRESET_NAME];
    bool typed[BEAM_PRESETS]; /* the name contains the type */
} BeamControls;

/* Makes the controls of a beam read from its file and takes ownership of that beam; beam_controls_close frees it. */
void beam_controls_open(BeamControls *controls, Beam *file);
void beam_controls_close(BeamControls *controls);

/* Sets the displayed values to the values of this beam. */
void beam_controls_show(BeamControls *controls, const Beam *beam);

/* Returns the parameter with this name; NULL: none. */
const PanelParameter *beam_controls_find(const BeamControls *controls, const char *name);

/* Sets a number of a beam and its provenance. False: a fault. */
bool beam_controls_set(const BeamControls *controls, Beam *beam, const char *name, double value, Fault *fault);

/* Makes `beam` the beam of a preset: the beam of the file with the preset's changes. */
void beam_controls_prefer(const BeamControls *controls, size_t preset, Beam *beam);

/* Adds the type of a beam to the names of presets with the same numbers. True: at least one name has changed. */
bool beam_controls_name_type(BeamControls *controls, const Beam *beam, const char *type);

/* Writes a value of a parameter as it is displayed: "300.0 Hz". */
void beam_controls_words(const PanelParameter *parameter, double value, char *text, size_t size);

/* Returns the range of an orbit diagram over the parameter: its useful range, extended to its value. */
void beam_controls_sweep(const PanelParameter *parameter, double *from, double *to);
