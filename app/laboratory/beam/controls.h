/* The numbers of a running beam that can be changed, as sliders show them, and its presets. */
#pragma once

#include "laboratory/laboratory.h"

#include "beam/beam.h"

enum { BEAM_PRESETS = 6, BEAM_PRESET_NAME = 40 };

typedef struct BeamControls {
    Beam file; /* as in its file */
    PanelParameter parameters[BEAM_VALUES];
    size_t count;
    Preset presets[BEAM_PRESETS];
    char names[BEAM_PRESETS][BEAM_PRESET_NAME];
    bool typed[BEAM_PRESETS]; /* the name says of which type it is */
} BeamControls;

/* Makes the controls of a beam as in its file and takes that beam over; beam_controls_close frees it. */
void beam_controls_open(BeamControls *controls, Beam *file);
void beam_controls_close(BeamControls *controls);

/* The values are those of this beam. */
void beam_controls_show(BeamControls *controls, const Beam *beam);

/* NULL: there is none of that name. */
const PanelParameter *beam_controls_find(const BeamControls *controls, const char *name);

/* Sets a number of a beam, and where it comes from. False: a fault. */
bool beam_controls_set(const BeamControls *controls, Beam *beam, const char *name, double value, Fault *fault);

/* Makes `beam` the beam of a preset: as in the file, but for what the preset says. */
void beam_controls_prefer(const BeamControls *controls, size_t preset, Beam *beam);

/* Notes the type of a beam: a preset with the same numbers gets the type in its name. True: one has it now. */
bool beam_controls_name_type(BeamControls *controls, const Beam *beam, const char *type);

/* "300.0 Hz": a value of a parameter as it is shown. */
void beam_controls_words(const PanelParameter *parameter, double value, char *text, size_t size);

/* So far an orbit diagram over the parameter goes: its useful range, and farther where its value is. */
void beam_controls_sweep(const PanelParameter *parameter, double *from, double *to);
