/* Changes that a person makes to a displayed house apart from editing it, and the transfer of the editor's changes. */
#pragma once

#include "laboratory/house/session_state.h"

/* Returns the session of a laboratory's context, after taking over the edits since the last call: every function of
 * the laboratory that depends on the draft or on the selection calls it first. */
HouseSession *house_control_sync(void *context);
void house_control_select(HouseSession *session, Item item);

/* Functions of Laboratory with a HouseSession as context. */
const PanelParameter *house_control_parameters(const void *context, size_t *count);
bool house_control_set(void *context, const char *name, double value, Fault *fault);
void house_control_reset(void *context);
const Preset *house_control_presets(const void *context, size_t *count);
void house_control_apply_preset(void *context, size_t preset);
const PanelChoice *house_control_choices(void *context, size_t *count);
void house_control_choose(void *context, size_t choice, size_t word);
void house_control_restart(void *context);
bool house_control_save_run(void *context, double time);
void house_control_clear(void *context, double time);

/* Start and end the dragging of a number, as in Laboratory. */
void house_control_begin_number(void *context, const char *name);
void house_control_end_number(void *context);

/* Implements the function `command` of Laboratory. */
const char *const *house_control_command(void *context, size_t *count);
