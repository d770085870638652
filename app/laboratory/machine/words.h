/* Plain words for the motion of a machine, as the window shows them, with the term of the trade in brackets. The texts
 * live as long as the arena. */
#pragma once

#include "laboratory/machine/machine.h"
#include "study/types.h"

/* Returns "Two hits in turn", "Every cycle alike" or "Never touches": the title of a motion with a period. */
const char *machine_words_periodic(const MachineKind *kind, size_t period, bool touches, Arena *arena);

/* Returns the title of a verdict: "Chaotic", or "Probably chaotic" while it is not confirmed; "Still settling" if the
 * recorded cycles are not periodic yet. */
const char *machine_words_title(const MachineKind *kind, const MachineFacts *facts, Arena *arena);

/* Returns "hardest hits 518 to 953 N", or "" if nothing touches. */
const char *machine_words_hits(const MachineKind *kind, const SectionPeaks *peaks, Arena *arena);

/* Returns "the same every two cycles (period 2)". */
const char *machine_words_repeat(const MachineKind *kind, size_t period, Arena *arena);

/* Returns how the motion of a verdict goes on: "never the same twice"; "": there is nothing to say. */
const char *machine_words_rhythm(const MachineKind *kind, const MachineFacts *facts, Arena *arena);

/* Returns "two almost equal starts drift 2.6 times apart each cycle (Lyapunov +0.95)" for a largest exponent. */
const char *machine_words_drift(const MachineKind *kind, double exponent, Arena *arena);

/* Returns "do not run it here (type III)". */
const char *machine_words_type(TypesKind type);

/* Returns the type as a heading that fits the panel: "Do not run it (type III)". */
const char *machine_words_type_heading(TypesKind type);

/* Returns the plain label of a row of a result, or the row's own one. */
const char *machine_words_label(const MachineKind *kind, const ResultRow *row, Arena *arena);

/* Returns a value with a minus sign instead of a hyphen before a negative number. */
const char *machine_words_value(const char *value, Arena *arena);
