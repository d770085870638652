/* Prints rows for the window's panel. */
#pragma once

#include "result/result.h"

/* The label, and the value with its unit; false: there is nothing to show. Texts made for it live in the arena. */
bool result_panel_row(SceneRow *line, const ResultRow *row, Arena *arena);

/* The label, and the values of two runs with their units. */
bool result_panel_pair(SceneRow *line, const ResultRow *before, const ResultRow *now, Arena *arena);
