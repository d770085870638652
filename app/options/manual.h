/* The manual page, made from the tables of verbs and options. */
#pragma once

#include "base/text.h"

/* Adds the page in the language of man(7). */
void manual_add(Text *text);
