/* Measures distances, and says whether a wheelchair fits through. */
#pragma once

#include "laboratory/edit/editor_state.h"

/* Returns the width of the narrowest wheelchair in the house, m; infinite: there is none. */
double edit_measure_chair(const Editor *edit);

/* Writes a length, m, and compares it with the width of the chair, m: "0.78 m: 0.08 m to spare". */
void edit_measure_format(double length, double chair, char *text, size_t size);

/* Stores a measured distance between two places, m; the oldest of EDIT_MEASURES is removed. */
void edit_measure_store(Editor *edit, Vec2 from, Vec2 to);

/* Measures the side of an item at the pointer; false: there is none. */
bool edit_measure_side(Editor *edit);
