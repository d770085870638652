/* The answer of a study of earthquakes: as JSON (the contract), and as files beside the tables of every study. */
#pragma once

#include <jansson.h>

#include "options/options.h"
#include "result/shake_findings.h"

/* {"kind":"shake", ...}. New; json_decref it. */
json_t *shake_answer_make(const ShakeFindings *findings, const char *file);

/* plan.png, .svg, .pdf, plot-times.png and so on in --out, with --report report.html and .pdf too; says on standard
 * error what cannot be written. */
bool shake_answer_write(const ShakeFindings *findings, const Options *options);

/* Prints it as text. */
void shake_answer_print(const ShakeFindings *findings, const char *file);
