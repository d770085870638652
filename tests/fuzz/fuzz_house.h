/* Houses of the fuzz targets that plan and move. */
#pragma once

#include "fuzz.h"
#include "house/house.h"
#include "house/journey.h"

/* Reads the input as a house that is small enough to be planned in a moment. Returns false if it is not one. */
bool fuzz_house_read(House *house, const uint8_t *data, size_t size);

/* Plans all journeys, or requests the end of the planning after half a second of work. */
Journeys fuzz_house_plan(const House *house, Stop *stop);

/* True if the vector's numbers are finite. */
bool fuzz_house_is_finite(Vec2 at);
