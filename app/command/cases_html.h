/* The table of verification cases as one page without further files, large enough to read from the back of a room,
 * light or dark as the reader's system is set. Each value is on a ruler with its limits. Words and shapes say which
 * case passed; colour only repeats it. */
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "base/text.h"
#include "inquiry/verification.h"

void cases_html_add(Text *text, const Verification *cases, size_t count, uint64_t seed);
