/* The moving layer of a film: the people, doors and falling furniture at the time that is shown. */
#pragma once

#include "visual/house/film.h"

/* Fills film->moving, which must be empty. */
void film_moving_make(Film *film);
