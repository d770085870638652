/* The table of verification cases for a terminal, as Markdown and as JSON. */
#pragma once

#include <jansson.h>
#include <stddef.h>
#include <stdint.h>

#include "base/text.h"
#include "inquiry/verification.h"

/* Prints the table on standard output, and below it the reasons of failed checks. */
void cases_text_print(const Verification *cases, size_t count);

/* Adds the same as a Markdown table. */
void cases_text_markdown(Text *text, const Verification *cases, size_t count, uint64_t seed);

/* Returns a new {"kind":"cases","seed":..,"cases":[{"id","suite","title","note","passed","checks":[..]}]}. */
json_t *cases_text_json(const Verification *cases, size_t count, uint64_t seed);
