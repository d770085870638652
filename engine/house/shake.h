/* An earthquake: which pieces of furniture topple.
 *
 * Each piece that can topple, and does not lie already, falls to its face with its own probability. The draw is bound
 * to the seed and the piece's id, so that one piece more or less, or another order in the file, changes nothing for the
 * others. It falls before anybody moves. Whoever stands where it comes to lie is caught: does not get out, "under
 * wardrobe (f3)". A chair stays there and is in the way of others; somebody on foot lies under the piece and is not. */
#pragma once

#include "house/house.h"
#include "route/route.h"

/* Can it fall in a shake at all? */
static inline bool shake_can_topple(const Furniture *piece) {
    return piece->topples != TOPPLE_NO && !piece->toppled;
}

/* Fills `topples` (furniture_count). Any seed is a shake, 0 too. */
void shake_draw(const Plan *plan, uint64_t seed, bool *topples);

/* "furniture.ID.toppled=true" for each of them: what makes a house so. The texts live in the arena; `settings` has room
 * for furniture_count. Returns how many. */
size_t shake_settings(const Plan *plan, const bool *topples, const char **settings, Arena *arena);

/* The piece, of those that topple, under which somebody's body is caught; NULL: none. Lies the pieces in the plan so,
 * whether they stand there or lie. */
const Furniture *shake_catches(const Plan *plan, const bool *topples, const Inhabitant *person);

/* That of somebody who is caught: none, blocked "under wardrobe (f3)". */
Route shake_route(const Plan *plan, const Inhabitant *caught);
