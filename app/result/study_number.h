/* Numbers of a study as text. */
#pragma once

#include "study/study.h"

enum { STUDY_NUMBER = 48 /* characters of a number with its unit */ };

/* Formats an observed number; "-" for none. */
void study_number_observed(double number, char word[STUDY_NUMBER]);

/* Formats a value of an axis with as many digits as tell it from its neighbours: "0.84 m". Small lengths and times are
 * in mm and ms, the speed of a shaft in rpm. */
void study_number_value(const Study *study, size_t axis, double value, bool with_unit, char word[STUDY_NUMBER]);

/* Formats the i-th value of an axis likewise. */
void study_number_step(const Study *study, size_t axis, size_t i, bool with_unit, char word[STUDY_NUMBER]);

/* The unit of an axis, and that of an observable; "" for pure numbers. */
const char *study_number_axis_unit(const Study *study, size_t axis);
const char *study_number_unit(const Observable *observable);
