/* The plots of a running crank over time: phase plane, section, force, error of the slider, spectrum.
 *
 * They are drawn in pages, as on an oscilloscope: a page is a stretch of revolutions, counted from the last change of
 * the crank. All its contents come from the record, so a page always looks the same. */
#pragma once

#include "laboratory/crank/tape.h"
#include "laboratory/machine/curve.h"
#include "plot/plot.h"

typedef enum CrankTrace {
    CRANK_TRACE_PHASE,
    CRANK_TRACE_POINCARE, /* along the coupler, with the velocity */
    CRANK_TRACE_ACROSS,   /* across it */
    CRANK_TRACE_FORCE,
    CRANK_TRACE_SLIDER,
    CRANK_TRACE_SPECTRUM,
    CRANK_TRACES,
} CrankTrace;

enum {
    CRANK_TRACE_SERIES = 3,  /* capacity */
    CRANK_TRACE_GUIDES = 40, /* capacity */
};

/* The contents of a page; if they change, the drawn page is void. */
typedef struct CrankPage {
    unsigned serial, version; /* of the part and of the tape */
    size_t number;            /* index of the page since the part began */
    bool cut;                 /* the page begins where the traces were cleared */
    size_t next;              /* the first revolution that is not yet in the curves */
} CrankPage;

typedef struct CrankTraces {
    Plot plots[CRANK_TRACES];
    PlotSeries series[CRANK_TRACES][CRANK_TRACE_SERIES];
    PlotGuide guides[CRANK_TRACES][CRANK_TRACE_GUIDES];
    MachineCurve curves[CRANK_TRACES][CRANK_TRACE_SERIES];
    bool whole[CRANK_TRACES][CRANK_TRACE_SERIES]; /* the series is drawn at every time */
    unsigned revisions[CRANK_TRACES];
    CrankPage pages[CRANK_TRACES];
    size_t cleared; /* revolutions before this one are no longer drawn */
    Arena arena;    /* holds the names of guides */
} CrankTraces;

void crank_traces_open(CrankTraces *traces);
void crank_traces_close(CrankTraces *traces);

/* Extends the curves to a recorded time. */
void crank_traces_show(CrankTraces *traces, const CrankTape *tape, double time);

/* Returns how many points of a series are drawn at a time. */
size_t crank_traces_until(const CrankTraces *traces, size_t plot, size_t series, double time);

/* Saves the phase plane at a time for comparison; a time below 0 removes the saved one. */
void crank_traces_store(CrankTraces *traces, double time);

/* Removes the drawn revolutions before this one, and resets the axes. */
void crank_traces_forget(CrankTraces *traces, size_t cycle);
