/* Changes that a person makes to a house at work, besides editing it; and what the editor has changed. */
#pragma once

#include "laboratory/house/session_parts.h"

/* Returns the session of a laboratory's context, after it has taken over what was edited since the last call: every
 * function of the laboratory that depends on the draft or on the selection begins with this. */
HouseSession *house_control_sync(void *context);
void house_control_select(HouseSession *session, Item item);

/* Functions of Laboratory, with a HouseSession as context. */
const PanelParameter *house_control_parameters(const void *context, size_t *count);
bool house_control_set(void *context, const char *name, double value, Fault *fault);
void house_control_reset(void *context);
const Preset *house_control_presets(const void *context, size_t *count);
void house_control_prefer(void *context, size_t preset);
const PanelChoice *house_control_choices(void *context, size_t *count);
void house_control_choose(void *context, size_t choice, size_t word);
void house_control_again(void *context);
bool house_control_keep(void *context, double time);
void house_control_clear(void *context, double time);

/* Numbers are dragged: as in Laboratory. */
void house_control_hold(void *context, const char *name);
void house_control_settle(void *context);

/* The function `command` of Laboratory. */
const char *const *house_control_command(void *context, size_t *count);
