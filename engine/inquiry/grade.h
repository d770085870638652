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
 *     E  helper only       the body fits through, but cannot be driven, or the driver is too weak (strength.h)
 *     F  impossible        the body does not fit
 *
 * A limit is reached if a body that is smaller than it by GRADE_RESOLUTION finds a way.
 *
 * Places: for each better grade in turn the house is tried with the body of that grade's limit. What blocks it is a
 * place of the present grade; it is then eased as far as possible (a door as wide as its wall allows, a piece of
 * furniture taken away), and the same is tried again, until the body passes or blocks where nothing can be eased. So
 * all places that stand between the way and the next grade are listed, not only the tightest one, and easing one can
 * only remove places. The change of a place is the least that lets that body pass with the other places eased. */
#pragma once

#include "base/stop.h"
#include "house/house.h"
#include "house/observation.h"

#define GRADE_RESOLUTION 0.002 /* m */
#define GRADE_HANDS 0.05       /* m */
#define GRADE_ARMS_IN 0.015    /* m */
#define GRADE_DEEPEST 0.20     /* m: how much smaller bodies are looked at */

enum { GRADE_PLACES_MOST = 6 };

typedef enum GradeLetter { GRADE_A, GRADE_B, GRADE_C, GRADE_D, GRADE_E, GRADE_F, GRADES } GradeLetter;

/* A place of a way that is too tight for a better grade. */
typedef struct GradePlace {
    int letter; /* GradeLetter of this place */
    double
        to_next; /* m per side, to the next better grade here; NAN: not known, since something else stays in the way */
    Vec2 at;     /* m */
    char what[96];    /* "door d2" */
    bool changes;     /* True if a change buys the next grade here */
    double by;        /* m, size of that change: of a door's widening, of a piece's move; 0: it is taken away */
    char change[160]; /* "widen door d2 by 3 cm to 0.78 m", "move sofa (f4) 0.05 m to the left on the plan" */
} GradePlace;

typedef struct Grade {
    int letter;       /* GradeLetter */
    double tightness; /* m, c* of a driven way; < 0: the body must become smaller; NAN: by more than GRADE_DEEPEST */
    bool wider;       /* True if c* is more than that: the search ends at the limit of A */
    double to_next;   /* m per side, to the next better grade; 0 for A; NAN: not known */
    bool has_place;   /* True if something blocks the body that is a little larger */
    Vec2 at;          /* m, where that is */
    char what[96];    /* "door d2" */
    GradePlace places[GRADE_PLACES_MOST]; /* (place_count) tightest grade first */
    size_t place_count;
    bool weak;        /* True if it is strength that is missing, at that place, not room */
    bool interrupted; /* True: nothing else is known */
} Grade;

/* Grades the way of a person in a chair that is driven (profile `driver`). */
Grade grade_person(const House *house, size_t person, const Stop *stop);

/* Finds the grade alone, by three tries at most: the tightness, the distance to the next grade and what buys it are not
 * known (NAN, no places). The place is the one that stands in the way of the next better grade first. */
Grade grade_person_letter(const House *house, size_t person, const Stop *stop);

/* Grades all of them into `grades` (person_count). Returns false if interrupted. */
bool grade_all(Grade *grades, const House *house, int jobs, const Stop *stop);

/* Finds the letters of those drivers who are of `part` (person_count); the others are `interrupted`: nothing
 * is known of them. Returns false if interrupted. */
bool grade_all_letters(Grade *grades, const House *house, const bool *part, int jobs, const Stop *stop);

/* Finds the letters that an answer tells without being asked: all who took part are out, and they are at most `few`.
 * `grades` is (person_count), by memory_zeroed; NULL: none are told. Returns false, without grades, if interrupted. */
bool grade_answer(Grade **grades, const House *house, const Observation *observation, size_t few, int jobs,
                  const Stop *stop);

/* Finds the worst of these letters alone, of the same person as grade_worst: others are tried until they are known to
 * have no worse one. `interrupted`: none is told. Returns false if interrupted by `stop`. */
bool grade_answer_worst(Grade *worst, const House *house, const Observation *observation, size_t few, const Stop *stop);

/* Returns the driver with the worst known grade, the first one of those with the same; SIZE_MAX: no grade is known. */
size_t grade_worst(const House *house, const Grade *grades);

/* Returns all letters (GRADES), "A" first. */
const char *const *grade_letters(void);

/* Return "A", "B", ... and "easy", "with care", ... */
const char *grade_letter(int letter);
const char *grade_words(int letter);
