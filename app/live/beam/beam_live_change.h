/* What a person does to the running beam: as in LiveKind, with a BeamLive as `live`. */
#pragma once

#include "live/beam/beam_live.h"

/* Makes live->choices what is chosen. */
void beam_live_change_show_choices(BeamLive *live);

/* The beam is another one now, or what is asked about it: asks for its orbit diagram, and for its verdict. */
void beam_live_change_ask(BeamLive *live, bool verdict);

const LiveParameter *beam_live_change_parameters(const void *context, size_t *count);
bool beam_live_change_set(void *context, const char *name, double value, Fault *fault);
void beam_live_change_reset(void *context);
const LivePreset *beam_live_change_presets(const void *context, size_t *count);
void beam_live_change_prefer(void *context, size_t preset);
const LiveChoice *beam_live_change_choices(const void *context, size_t *count);
void beam_live_change_choose(void *context, size_t choice, size_t word);
void beam_live_change_again(void *context);
bool beam_live_change_keep(void *context, double time);
void beam_live_change_clear(void *context, double time);
const char *const *beam_live_change_command(const void *context, size_t *count);
