/* How tight each chair's way out is, on the plan: the letter of the grade at the tightest place, with the centimetres
 * to the next better grade, on each side. */
#pragma once

#include "draw/scene.h"
#include "inquiry/grade.h"

/* Adds them and a list of the grades; grades: (person_count), of chairs that are driven. */
void grades_scene_add(Scene *scene, const House *house, const Grade *grades);
