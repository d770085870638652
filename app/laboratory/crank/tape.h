/* The record of a running slider crank: its motion from its start, revolution by revolution, through all changes. Of
 * the last CRANK_TAPE_CYCLES revolutions every CRANK_TAPE_ROWS-th part of the drive's period is stored, so that any
 * time of them can be displayed again with the same bits; of older ones the return to the section, up to
 * CRANK_TAPE_RETURNS.
 *
 * A change takes place at the end of a revolution, and the later record is discarded; what the state has beside the
 * ideal mechanism's is carried on, if the coupler has as many modes. */
#pragma once

#include "crank/crank_cycle.h"

enum {
    CRANK_TAPE_CYCLES = 300,
    CRANK_TAPE_RETURNS = 20000,
    CRANK_TAPE_ROWS = 1440, /* per period of the drive */
    CRANK_TAPE_PARTS = 65,  /* at most: the oldest part is forgotten when there are more changes */
};

/* What is stored of a moment, beside the coordinates. */
typedef enum CrankTapeColumn {
    CRANK_TAPE_ALONG, /* m, of the ball in its socket */
    CRANK_TAPE_ALONG_RATE,
    CRANK_TAPE_ACROSS,
    CRANK_TAPE_UP,
    CRANK_TAPE_FORCE,       /* N */
    CRANK_TAPE_ANGLE,       /* rad */
    CRANK_TAPE_SLIDER_OFF,  /* m, of the slider beside the ideal one */
    CRANK_TAPE_SLIDER_RATE, /* m/s, of the slider */
    CRANK_TAPE_COLUMNS,     /* then the coordinates of the tree */
} CrankTapeColumn;

/* The motion at the beginning of a revolution, and the largest force in it. */
typedef struct CrankReturn {
    double begin;             /* s */
    double along, along_rate; /* m, m/s, of the ball */
    double across, up;        /* m */
    double peak;              /* N */
} CrankReturn;

typedef struct CrankTapeCycle {
    float *rows; /* (row_count x width) */
    size_t row_count, row_capacity, width;
    double reach;                  /* m, largest displacement of coupler and support */
    double reach_room, force_room; /* m, N: what a picture should have room for; it changes seldom, and in steps */
    Turn begin;                    /* the motion at the beginning */
} CrankTapeCycle;

/* The stretch from one change of the crank to the next. */
typedef struct CrankPart {
    size_t first; /* first revolution of the part */
    double begin; /* s */
    Crank crank;  /* the texts belong to the first crank */
    Tree tree;
    unsigned serial; /* unique among all parts that the tape has or had */
} CrankPart;

typedef struct CrankTape {
    CrankPart *parts[CRANK_TAPE_PARTS]; /* (part_count) */
    size_t part_count;
    CrankPart *next;        /* the part that begins at the front; NULL: the last part continues */
    CrankTapeCycle *cycles; /* (CRANK_TAPE_CYCLES + 1) a ring; the front's has only its beginning */
    CrankReturn *returns;   /* (CRANK_TAPE_RETURNS + 1) a ring */
    size_t first, front;    /* revolutions: `first` up to but excluding `front` are recorded */
    double front_time;      /* s, beginning of the front's revolution */
    Turn turn;              /* the motion at the front */
    CycleStatus status;     /* not CYCLE_GOOD: the record has ended */
    unsigned version;       /* changes when recorded revolutions are discarded from the end, or all of them */
    unsigned part_serial;   /* the serial that was assigned last */
} CrankTape;

/* Opens a tape of a crank at its start, with an empty record; the crank's texts must outlive the tape. */
void crank_tape_open(CrankTape *tape, const Crank *crank);
void crank_tape_close(CrankTape *tape);

/* Continues with another, valid crank at the end of a revolution, or from its start at the beginning. */
void crank_tape_change(CrankTape *tape, const Crank *crank, size_t cycle);
void crank_tape_restart(CrankTape *tape, const Crank *crank);

/* Records one more revolution. False: it cannot be followed; tape->status gives the reason. */
bool crank_tape_advance(CrankTape *tape);

/* Return the part of a revolution, the revolution, the first one whose return is stored, a return (also the front's),
 * and the revolution at a time with the row in it. */
const CrankPart *crank_tape_part(const CrankTape *tape, size_t cycle);
const CrankTapeCycle *crank_tape_cycle(const CrankTape *tape, size_t cycle);
size_t crank_tape_first_return(const CrankTape *tape);
const CrankReturn *crank_tape_return(const CrankTape *tape, size_t cycle);
size_t crank_tape_cycle_at(const CrankTape *tape, double time, size_t *row);

static inline const float *crank_tape_row(const CrankTapeCycle *cycle, size_t row) {
    return cycle->rows + row * cycle->width;
}
