/* Houses for tests: shipped ones, and ones made of a few numbers. */
#pragma once

#include <jansson.h>

#include "house/house.h"
#include "house/observation.h"

/* Reads houses/NAME.json with the shipped profiles; `driving` as in HouseOptions; settings end with NULL. A fault fails
 * the test. house_free releases it. */
void case_house(House *house, const char *name, int driving, const char *const *settings);

/* The same of a house made in memory; the JSON is released. */
void case_made(House *house, json_t *plan, int driving, const char *const *settings);

/* The JSON of a shipped house; json_decref it. */
json_t *case_plan(const char *name);

/* Runs everybody with `jobs` threads. observation_free releases it. */
Observation case_run(const House *house, int jobs);

/* A straight corridor along x, `width` m clear and 20 m long, its faces at y = -width / 2 and width / 2, walls 0.2 m
 * thick, an exit across x = 18; nobody in it. New. */
json_t *case_corridor(double width);

/* Adds a person p<n> at (x, y). */
void case_add_person(json_t *plan, const char *profile, double x, double y, double heading);
