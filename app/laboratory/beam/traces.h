/* The plots of a running beam over time: phase plane, Poincare map, force against time, spectrum.
 *
 * They are drawn in pages, as on an oscilloscope: a page is a stretch of cycles, counted from the last change of the
 * beam. All its contents are computed from the record, so a page always looks the same. If many cycles pass between
 * frames, a page covers more cycles, by a power of two, with less detail of each: the phase plane shows only one
 * cycle per stride, the force only its peaks. */
#pragma once

#include "plot/plot.h"
#include "laboratory/machine/curve.h"
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
    BEAM_TRACE_SERIES = 4,   /* capacity */
    BEAM_TRACE_GUIDES = 12,  /* capacity */
    BEAM_TRACE_SPECTRA = 64, /* cycles in a spectrum */
    BEAM_TRACE_WAVES = 64,   /* samples per cycle for a spectrum */
};

/* The contents of a page; if they change, the drawn page is void. */
typedef struct BeamPage {
    unsigned serial, version; /* of the part and of the tape */
    size_t stride;            /* number of cycles from one drawn cycle to the next */
    size_t number;            /* index of the page since the part began */
    bool cut;                 /* the page begins where the traces were cleared */
    size_t next;              /* the first cycle that is not yet in the curves */
} BeamPage;

typedef struct BeamTraces {
    Plot plots[BEAM_TRACES];
    PlotSeries series[BEAM_TRACES][BEAM_TRACE_SERIES];
    PlotGuide guides[BEAM_TRACES][BEAM_TRACE_GUIDES];
    const MachineCurve *curves[BEAM_TRACES][BEAM_TRACE_SERIES]; /* the curves behind the series */
    bool whole[BEAM_TRACES][BEAM_TRACE_SERIES];                 /* the series is drawn at every time */
    unsigned revisions[BEAM_TRACES];
    BeamPage pages[BEAM_TRACES];
    MachineCurve phase, section, points, force, spectrum, stored;
    BeamExtent seen;        /* extent of all cycles since the last clearing, for the axes */
    size_t seen_to;         /* cycle up to which `seen` is complete */
    Box plane;              /* box of the Poincare map's points */
    size_t cleared;         /* cycles before this one are no longer drawn */
    unsigned version;       /* version of the tape at the last update, */
    size_t last;            /* and its cycle */
    double shown, steps[2]; /* s, the displayed time; cycles between the last two pairs of frames */
    size_t strides[BEAM_TRACES];
    double waves[BEAM_TRACE_SPECTRA][BEAM_TRACE_WAVES]; /* m, deflections of the last cycles */
    size_t waves_of[BEAM_TRACE_SPECTRA];                /* cycle + 1 of each wave; 0: none */
    unsigned waves_serial;
    Arena arena; /* holds the names of guides */
} BeamTraces;

void beam_traces_open(BeamTraces *traces);
void beam_traces_close(BeamTraces *traces);

/* Extends the curves to a recorded time. */
void beam_traces_show(BeamTraces *traces, BeamTape *tape, double time);

/* Returns how many points of a series are drawn at a time. */
size_t beam_traces_until(const BeamTraces *traces, size_t plot, size_t series, double time);

/* Saves the phase plane at a time for comparison; a time below 0 removes the saved one. */
void beam_traces_store(BeamTraces *traces, double time);

/* Removes the drawn cycles before this one, and resets the extent of the axes. */
void beam_traces_forget(BeamTraces *traces, size_t cycle);
