/* Finds the unit of a drawing by its dimensions: a written length beside a measured one. Private to the DXF importer.
 */
#pragma once

#include "exchange/dxf_file.h"
#include "exchange/length_text.h"
#include "exchange/plan_size.h"

typedef struct DxfEvidence {
    const PlanUnit *unit;         /* NULL: the dimensions do not say the unit */
    char text[LENGTH_TEXT_BYTES]; /* the first dimension that says it ... */
    double measured;              /* ... and its length in the drawing's unit */
} DxfEvidence;

/* Asks dimensions, and written lengths beside parallel lines (dimensions that were exploded); most of them must agree.
 * `header` is the unit (of plan_size_units) that a plausible header says, or NULL: a dimension that shows the length
 * that it measures agrees with it, and a single number without a unit does not outweigh it. */
DxfEvidence dxf_dimensions_ask(const DxfFile *file, const PlanUnit *header);
