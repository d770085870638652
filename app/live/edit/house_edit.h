/* Editing a house while it runs: see live_edit.h. Its state is the member `edit` of a house at work. */
#pragma once

#include "live/live_edit.h"

extern const LiveEditor house_edit;
