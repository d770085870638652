/* Makes the texts about a displayed house: the answer, the rows of the panel, the marks of the timeline. */
#pragma once

#include "laboratory/house/session_state.h"

/* Rebuilds the texts that are out of date; `time` is the displayed time. */
void house_text_make(HouseSession *session, double time);
void house_text_clear(HouseSession *session);

/* True if the texts of the moment are out of date. */
bool house_text_moved(const HouseSession *session, double time);

Result house_text_answer(HouseSession *session);

/* True if the text about the work in progress has changed since the last call. */
bool house_text_progress_changed(HouseSession *session);
