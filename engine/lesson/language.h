/* Languages in the texts of a lesson: wherever a text stands for people to read, {"en": "Watch.", "ja": "..."} may
 * stand in its place. A plain text is English, and English is shown where the wanted language is missing. */
#pragma once

#include "base/json.h"

/* Returns the language that LC_ALL, LC_MESSAGES or LANG names, the first that is set: "ja" of ja_JP.UTF-8, "en" of C.
 */
const char *language_wanted(void);

/* Returns a copy of a lesson with each text in one language; new, json_decref it. A text without English, and a key
 * that names no language, is a fault. */
json_t *language_choose(const JsonNode *root, const char *language, Fault *fault);

/* Lets the schema of a lesson take languages in its texts. */
void language_extend_schema(json_t *schema);
