/* The table of verification cases: for a terminal, for Markdown, as JSON. */
#pragma once

#include <jansson.h>
#include <stddef.h>
#include <stdint.h>

#include "base/text.h"
#include "inquiry/verification.h"

/* Prints the table on standard output, and below it why checks are not passed. */
void cases_table_print(const Verification *cases, size_t count);

/* Adds the same as a Markdown table. */
void cases_table_markdown(Text *text, const Verification *cases, size_t count, uint64_t seed);

/* {"kind":"cases","seed":..,"cases":[{"id","suite","title","note","passed","checks":[..]}]}. New. */
json_t *cases_table_json(const Verification *cases, size_t count, uint64_t seed);
