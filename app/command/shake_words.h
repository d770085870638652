/* Prints the answer of a study of earthquakes as text. */
#pragma once

#include "result/shake_findings.h"

void shake_words_print(const ShakeFindings *findings, const char *file);
