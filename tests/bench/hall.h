/* A square hall full of people, a 2 m exit in the middle of each side. */
#pragma once

#include "house/house.h"

/* `side` m, `density` people per m2, all of one profile; `source`: the project's directory. house_free releases it. */
void hall_read(House *house, const char *source, const char *profile, double side, double density);
