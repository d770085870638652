/* The plots of a running beam that come with its time: phase plane, Poincare map, force against time, spectrum.
 *
 * They are drawn in pages, as on an oscilloscope: a page is a stretch of cycles, counted from the last change of the
 * beam, and everything in it is followed from the record, so that it is the same whenever it is shown. Where many
 * cycles pass from picture to picture, a page holds more of them, a power of two, and less of each: the phase plane
 * only every so manyeth cycle, the force only its peaks. */
#pragma once

#include "plot/plot.h"
#include "laboratory/beam/curve.h"
#include "laboratory/beam/tape.h"
#include "mechanics/spectrum.h"

typedef enum BeamTrace {
    BEAM_TRACE_PHASE,
    BEAM_TRACE_POINCARE,
    BEAM_TRACE_FORCE,
    BEAM_TRACE_SPECTRUM,
    BEAM_TRACES,
} BeamTrace;

enum {
    BEAM_TRACE_SERIES = 4,   /* room */
    BEAM_TRACE_GUIDES = 12,  /* room */
    BEAM_TRACE_SPECTRA = 64, /* cycles of which a spectrum is */
    BEAM_TRACE_WAVES = 64,   /* samples of each of them */
};

/* The contents of a page; if they change, the drawn page is void. */
typedef struct BeamPage {
    unsigned serial, version; /* of part and tape */
    size_t stride;            /* from one cycle that is drawn to the next */
    size_t number;            /* of the page since the part began */
    bool cut;                 /* it begins where the traces were cleared */
    size_t next;              /* the first cycle that is not in the curves yet */
} BeamPage;

typedef struct BeamTraces {
    Plot plots[BEAM_TRACES];
    PlotSeries series[BEAM_TRACES][BEAM_TRACE_SERIES];
    PlotGuide guides[BEAM_TRACES][BEAM_TRACE_GUIDES];
    const BeamCurve *curves[BEAM_TRACES][BEAM_TRACE_SERIES]; /* of the series */
    bool whole[BEAM_TRACES][BEAM_TRACE_SERIES];              /* drawn at every time */
    unsigned revisions[BEAM_TRACES];
    BeamPage pages[BEAM_TRACES];
    BeamCurve phase, section, points, force, spectrum, kept;
    BeamExtent seen;        /* in all cycles since the last clearing: how far the axes go */
    size_t seen_to;         /* cycle */
    Box plane;              /* that the points lie in */
    size_t cleared;         /* what was drawn of cycles before this one is forgotten */
    unsigned version;       /* of the tape, when shown last, */
    size_t last;            /* and the cycle */
    double shown, steps[2]; /* s, the time that was shown last; cycles between the last two pairs of pictures */
    size_t strides[BEAM_TRACES];
    double waves[BEAM_TRACE_SPECTRA][BEAM_TRACE_WAVES]; /* m, deflections of the last cycles */
    size_t waves_of[BEAM_TRACE_SPECTRA];                /* cycle + 1; 0: none */
    unsigned waves_serial;
    Arena arena; /* names of guides */
} BeamTraces;

void beam_traces_open(BeamTraces *traces);
void beam_traces_close(BeamTraces *traces);

/* Makes the curves reach a recorded time. */
void beam_traces_show(BeamTraces *traces, BeamTape *tape, double time);

/* Returns how many points of a series are drawn at a time. */
size_t beam_traces_until(const BeamTraces *traces, size_t plot, size_t series, double time);

/* The phase plane as it is at a time, or nothing (a time below 0), stays as "before". */
void beam_traces_keep(BeamTraces *traces, double time);

/* Forgets the drawn cycles before this one, and the extent of the axes. */
void beam_traces_forget(BeamTraces *traces, size_t cycle);
