/* Houses for tests: shipped ones, and synthetic ones made from a few numbers. */
#pragma once

#include <jansson.h>

#include "house/house.h"
#include "house/observation.h"

/* Reads houses/NAME.json with the shipped profiles; `driving` as in HouseOptions; settings end with NULL. An error
 * fails the test. house_free releases the house. */
void case_house(House *house, const char *name, int driving, const char *const *settings);

/* The settings with which the chair of corner-1.20-0.80 touches a wall: a driver who is slow to turn, and a personal
 * space that pushes. They end with NULL. */
extern const char *const case_touching[];

/* Reads a house made in memory in the same way; releases the JSON. */
void case_made(House *house, json_t *plan, int driving, const char *const *settings);

/* Returns the JSON of a shipped house; json_decref it. */
json_t *case_plan(const char *name);

/* Runs all people with `jobs` threads. observation_free releases the result. */
Observation case_run(const House *house, int jobs);

/* Returns a straight corridor along x, `width` m clear and 20 m long, with faces at y = -width / 2 and width / 2,
 * walls 0.2 m thick, an exit across x = 18, and no people. */
json_t *case_corridor(double width);

/* Returns the corner of houses/corner-*.json, legs w1 and w2 m wide, with its chair p1, turned by an angle, rad, about
 * the origin. */
json_t *case_corner(double w1, double w2, double angle);

/* Returns a corridor of 6 m, `wide` m clear, with a doorway of `door` m in the middle of its long side and a room of 3
 * m behind, turned by an angle, rad, about the origin. A chair p1 goes from the corridor into the room, or out of it.
 */
json_t *case_side_door(double wide, double door, bool from_room, double angle);

/* Adds a person p<n> at (x, y). */
void case_add_person(json_t *plan, const char *profile, double x, double y, double heading);
