/* What many drivers of a house do, as rows: one record for each person of the population. */
#pragma once

#include "base/text.h"
#include "experiment/drivers.h"
#include "inquiry/grade.h"
#include "result/result.h"
#include "study/montecarlo.h"

/* `nominal` is the observation of the nominal driver. */
ResultTable result_drivers_table(const House *house, const Observation *nominal, const Drivers *drivers);

/* The table of the paper for routes with drivers of the population: measured (a), (b), n and simulated (c), (d), N, and
 * whether the two means agree within 10 % (welch.h). The time of a route is that of its last person; a driver counts if
 * all of the route get out. */
ResultTable result_drivers_routes(const House *house, const Drivers *drivers);

/* Returns, for each route with single measured runs or counted touches, how far one person's times scatter and how far
 * people differ, how many runs lie inside the simulated 90 % band, or the rank of a single one among the simulated
 * times, and how often something was touched. */
ResultTable result_drivers_measured(const House *house, const Drivers *drivers);

/* Two houses with the same drivers, person by person: how many get out and touch something in each, and of those who
 * get out of both the mean difference of their times, b - a, with its 95 % interval, and how many are quicker in b. */
ResultTable result_drivers_paired(const House houses[2], const Drivers drivers[2]);

/* Adds a sentence for each person: "p1  46 of 100 get out of both, in 19.0 s and 17.8 s in the mean: only these are
 * compared; 8 get out of b alone, in 18.3 s, and change the mean of all who get out". Slow and wide drivers who get out
 * of the roomier house alone can raise that mean although nobody takes longer. */
void result_drivers_paired_say(Text *text, const House houses[2], const Drivers drivers[2]);

/* Returns the drivers of a person in one line, "90 % of drivers take 11.9 to 15.2 s; 97 of 100 out; 12 % touch, most at
 * bedroom door", in the arena; NULL: the person is not of the population. */
const char *result_drivers_brief(const House *house, const Drivers *drivers, size_t person, Arena *arena);

/* Returns what the drivers add to the nominal answer, "65 of 100 drivers get out, 32 % touch something, 28.9 s in the
 * mean, grade D, touching likely, at door d3", in the arena; "": no drivers, and `grades` (person_count) is NULL. A
 * grade that the drivers contradict ends with ", by room alone". */
const char *result_drivers_headline(const House *house, const Drivers *drivers, const Grade *grades, Arena *arena);

/* Adds a sentence for each person whose grade is C or better though at least 10 % of the drivers touch something;
 * `grades` is (person_count). */
void result_drivers_say_grades(Text *text, const House *house, const Drivers *drivers, const Grade *grades);

/* Adds a sentence for each person: "p-a  13.0 s; 90 % of drivers take 11.9 to 15.2 s; 97 of 100 out; 12 % touch (7 to
 * 20)".
 */
void result_drivers_say(Text *text, const House *house, const Observation *nominal, const Drivers *drivers);
