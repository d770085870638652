/* An earthquake: decides which pieces of furniture topple.
 *
 * Each piece that can topple, and does not lie already, falls to its face with its own probability. The draw depends on
 * the seed and the piece's id, so that adding or removing a piece, or another order in the file, changes nothing for
 * the others. Furniture falls before people move. A person under a fallen piece is caught and does not leave, "under
 * wardrobe (f3)". A chair stays there and obstructs others; a walker lies under the piece and does not. */
#pragma once

#include "house/house.h"
#include "route/route.h"

/* True if the piece can fall in a shake. */
static inline bool shake_can_topple(const Furniture *piece) {
    return piece->topples != TOPPLE_NO && !piece->toppled;
}

/* Fills in `topples` (furniture_count). Every seed is a shake, including 0. */
void shake_draw(const Plan *plan, uint64_t seed, bool *topples);

/* Writes the settings that topple the pieces in a house, "furniture.ID.toppled=true". The texts live in the arena;
 * `settings` has room for furniture_count. Returns their number. */
size_t shake_settings(const Plan *plan, const bool *topples, const char **settings, Arena *arena);

/* Returns the toppling piece under which a person's body is caught; NULL: none. Considers each piece as lying, even if
 * it stands in the plan. */
const Furniture *shake_catches(const Plan *plan, const bool *topples, const Inhabitant *person);

/* Returns the route of a caught person: no path, blocked "under wardrobe (f3)". */
Route shake_route(const Plan *plan, const Inhabitant *caught);
