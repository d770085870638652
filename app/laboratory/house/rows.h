/* The rows of the panel, to which several files add. */
#pragma once

#include "laboratory/house/session_state.h"

/* Adds a row with its first cell; good until the next one is added. */
PanelRow *house_rows_add(HouseSession *session, RowKind kind, const char *first);
