/* The part of a report about the differences of two plans: objects that only one of them has, and changed numbers. */
#pragma once

#include "document/document.h"
#include "plan/plan.h"

void report_plans_add(Document *document, const Plan *a, const Plan *b);
