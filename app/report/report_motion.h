/* The motion in a report: the end of the run in the raised view, and curves over time. */
#pragma once

#include "document/document.h"
#include "report/report_basis.h"

/* A picture drawn by the caller. */
typedef struct RaisedPicture {
    unsigned char *pixels; /* (height x width x 4) rows from the top: blue, green, red and an ignored byte */
    int width, height;
} RaisedPicture;

/* Copies the picture of the house of that name. */
void report_motion_add_raised(Document *document, const RaisedPicture *picture, const char *name);

/* Adds speed, clearance, contact force and lateral motion; a `before` that is not empty is shown behind them. The
 * houses must outlive the document. */
void report_motion_add_curves(Document *document, const Reported *run, const Reported *before);
