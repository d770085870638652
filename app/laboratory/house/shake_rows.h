/* The panel's rows about earthquakes: what fell in the one whose outcome is displayed, who leaves how often in a
 * hundred of them, and which pieces of furniture to fix to the wall. */
#pragma once

#include "laboratory/house/session_state.h"

/* Adds the rows; none, if the displayed house is not the outcome of an earthquake. */
void house_shake_rows_add(HouseSession *session);
