/* The names of doors, people and wheelchairs as people say them: "bedroom door" instead of "door d3", "A" instead of
 * "p-a". Pictures, reports and the window use them; files, the terminal and JSON have the ids. */
#pragma once

#include "base/memory.h"
#include "house/house.h"

/* Returns the name of a door by its rooms: "bedroom door", or "bedroom door to closet", "bedroom door, left" if the
 * room has two; "door d8" if no room is named. */
const char *names_door(const Plan *plan, size_t door, Arena *arena);

/* Returns the name of the room that holds a place; NULL: none does. */
const char *names_room(const Plan *plan, Vec2 at);

/* Returns the name of a wall at a place, m, by the rooms there: "wall between bedroom and corridor", "left wall of
 * bedroom", "wall" if no room is named; or the name that all pieces of a wall share, else "wall". */
const char *names_wall_at(const Plan *plan, size_t wall, Vec2 at, Arena *arena);
const char *names_wall(const Plan *plan, size_t wall, Arena *arena);

/* Returns the letter of a person: that of the route, otherwise by order. */
const char *names_person(const House *house, size_t person, Arena *arena);

/* Returns the word for a profile, "wheelchair" for "manual-chair", or its own name if there is none. */
const char *names_profile(const char *profile);

/* Returns the window's word for the label of a number, "touches" for "contacts", or the label if there is none. */
const char *names_number(const char *label);

/* Returns the name of a thing at a place, m, in a few words: "bedroom door", "left wall of shop 3". */
const char *names_thing(const House *house, const char *thing, Vec2 at, Arena *arena);

/* Returns a text with the names in place of the ids of doors, walls, furniture, people and profiles. */
const char *names_text(const House *house, const char *text, Arena *arena);

/* Returns such a text for a plan whose people are those of a house; NULL: they have no names yet. */
const char *names_plan_text(const Plan *plan, const House *house, const char *text, Arena *arena);
