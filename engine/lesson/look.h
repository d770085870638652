/* The "view" of a lesson or of a step: layers by the numbers of their keys, plots by their names, speed of playback.
 *
 *     "view": {"layers": [1, 3, 5], "plots": "speed,clearance", "speed": 2}
 *
 * A step without one of them has that of the lesson. */
#pragma once

#include "lesson/lesson.h"

/* Reads "view" of a lesson or step; without it, or after an error, `look` is empty. */
void look_read(LessonLook *look, Lesson *lesson, const JsonNode *object, Fault *fault);

/* Returns the look of a step with what it takes from the lesson. */
LessonLook look_of_step(const Lesson *lesson, const LessonStep *step);

/* Returns the number of layers of a laboratory that have keys, and the names of its plots in `count`. */
size_t look_layers(LessonLaboratory laboratory);
const char *const *look_plots(LessonLaboratory laboratory, size_t *count);

/* Returns the schema of "view"; new, json_decref it. */
json_t *look_schema(void);
