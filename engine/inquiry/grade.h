/* How tight a person's way out is, by geometry alone.
 *
 * The tightness c* of a way is the largest growth of the body, all round, with which there still is a way; c*_n is the
 * same with at most n changes of direction. Both are found by bisection with the route search, to GRADE_RESOLUTION, and
 * do not depend on the quickest way: more room can make neither smaller. Grades (limits assumed, driver.md's table;
 * v the free speed, b the steering time):
 *
 *     A  easy              c*_0 >= b v / 2: the clearance that costs no speed, no change of direction
 *     B  with care         c*_0 >= 0.05 m: room for the hands at the rims
 *     C  arms in           c*_2 >= 0.015 m: a tenth of the passages of a door touch with less
 *     D  touching likely   there is a way
 *     E  helper only       the body fits through, but cannot be driven
 *     F  impossible        the body does not fit */
#pragma once

#include "base/stop.h"
#include "house/house.h"

#define GRADE_RESOLUTION 0.002 /* m */
#define GRADE_HANDS 0.05       /* m */
#define GRADE_ARMS_IN 0.015    /* m */
#define GRADE_DEEPEST 0.20     /* m: how much smaller bodies are looked at */

typedef enum GradeLetter { GRADE_A, GRADE_B, GRADE_C, GRADE_D, GRADE_E, GRADE_F } GradeLetter;

typedef struct Grade {
    int letter;       /* GradeLetter */
    double tightness; /* m, c* of a driven way; < 0: the body must become smaller; NAN: by more than GRADE_DEEPEST */
    bool wider;       /* True if c* is more than that: the search ends at the limit of A */
    double to_next;   /* m per side, to the next better grade; 0 for A; NAN: not known */
    bool has_place;   /* True if something blocks the body that is a little larger */
    Vec2 at;          /* m, where that is */
    char what[96];    /* "door d2" */
    bool interrupted; /* True: nothing else is known */
} Grade;

/* Grades the way of a person in a chair that is driven (profile `driver`). */
Grade grade_person(const House *house, size_t person, const Stop *stop);

/* Grades all of them into `grades` (person_count). Returns false if interrupted. */
bool grade_all(Grade *grades, const House *house, int jobs, const Stop *stop);

/* Return "A", "B", ... and "easy", "with care", ... */
const char *grade_letter(int letter);
const char *grade_words(int letter);
