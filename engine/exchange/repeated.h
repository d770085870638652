/* Finds what a file holds more than once: some programs export a plan twice, or lay copies on top of each other.
 * Private to the importers. */
#pragma once

#include "exchange/house_builder.h"

/* Drops furniture and rooms that repeat an earlier one, with a note. */
void repeated_drop(HouseBuilder *builder);

/* Notes when the rooms overlap, or when walls cover much of them. Large plans are not compared: the time is bounded. */
void repeated_compare_rooms(const Plan *plan, ImportReport *report);
