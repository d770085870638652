/* The answer about a house in words and tables, for people to read. */
#pragma once

#include "house/house.h"
#include "house/observation.h"

enum { REPORT_HEADLINE = 1024 /* room for a headline */ };

/* "Out in 18.4 s" or what stands against it. */
void report_headline(const House *house, const Observation *observation, char *text, size_t size);

/* Prints answer, people (of many the sums, and some of those who are not out), routes and dangerous points. */
void report_print(const House *house, const Observation *observation);
