/* What a person does to the running beam: as in Laboratory, with a BeamSession as `live`. */
#pragma once

#include "laboratory/beam/session.h"

/* Makes live->choices what is chosen. */
void beam_change_show_choices(BeamSession *live);

/* The beam is another one now, or what is asked about it: asks for its orbit diagram, and for its verdict. */
void beam_change_ask(BeamSession *live, bool verdict);

const PanelParameter *beam_change_parameters(const void *context, size_t *count);
bool beam_change_set(void *context, const char *name, double value, Fault *fault);
void beam_change_reset(void *context);
const Preset *beam_change_presets(const void *context, size_t *count);
void beam_change_prefer(void *context, size_t preset);
const PanelChoice *beam_change_choices(void *context, size_t *count);
void beam_change_choose(void *context, size_t choice, size_t word);
void beam_change_again(void *context);
bool beam_change_keep(void *context, double time);
void beam_change_clear(void *context, double time);
const char *const *beam_change_command(void *context, size_t *count);
