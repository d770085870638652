/* Lists the places of a way that stand between it and better grades: see grade.h. */
#pragma once

#include "inquiry/grade.h"

/* The body with which a person must pass for a grade. */
typedef struct GradeLevel {
    int letter;    /* GradeLetter */
    double growth; /* m */
    int reversals; /* changes of direction that are allowed */
    double has;    /* m, the largest growth with which there is a way with so many; NAN: none */
} GradeLevel;

/* Fills in the places of a person's grade. `levels` (count): the grades better than the present one, the next one
 * first. */
void grade_places_find(Grade *grade, const House *house, size_t person, const GradeLevel *levels, size_t count,
                       const Stop *stop);
