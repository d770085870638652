/* Houses for measurements; `source` is the project's directory. house_free releases them. */
#pragma once

#include "house/house.h"

/* The default house: four routes. */
void houses_read_ube(House *house, const char *source);

/* Returns the default house with a piece of furniture at another place, m. */
void houses_read_ube_moved(House *house, const char *source, const char *piece, Vec2 centre);

/* Returns a square hall with a 2 m exit in the middle of each side: `side` m, `density` people per m2, all of one
 * profile. */
void houses_read_hall(House *house, const char *source, const char *profile, double side, double density);

/* Returns a flat of eight rooms, a door `door` m wide each, on both sides of a corridor `corridor` m wide: in each room
 * sixteen pieces of furniture along its walls, 128 in all. One manual chair starts in the room farthest from the exit.
 */
void houses_read_flat(House *house, const char *source, double corridor, double door);

/* Returns the flat with one piece of the room opposite of the last moved by `away` m. */
void houses_read_flat_moved(House *house, const char *source, double corridor, double door, Vec2 away);
