/* Compares the claims of Gu and Dubowsky's paper (1995) about its impact beam system with a beam file: runs the
 * simulations and lists each claim with the paper's figure, our figure, and whether they agree.
 *
 * The paper's pictures are lost, and from its text every digit 0 and every capital T: the comparison uses what is
 * legible or reconstructed (assets/beams/ibs.json says how). Disagreements are listed, too. */
#pragma once

#include "base/stop.h"
#include "beam/beam_cycle.h"
#include "experiment/beam_follow.h"
#include "study/study.h"
#include "study/types.h"

/* The single runs. */
typedef enum PaperRun {
    PAPER_PERIODIC, /* 190 Hz, figure 2 */
    PAPER_CHAOTIC,  /* 300 Hz, figures 3 to 6 */
    PAPER_NOMINAL,  /* 290 Hz */
    PAPER_LONGER,   /* 290 Hz, the beam 1 % longer */
    PAPER_RUNS,
} PaperRun;

/* The studies. */
typedef enum PaperStudy {
    PAPER_FREQUENCIES, /* peaks against frequency, from rest, up and down */
    PAPER_LENGTHS,     /* peaks against beam length, at 290 Hz */
    PAPER_MAP,         /* responses over frequency and clearance */
    PAPER_STUDIES,
} PaperStudy;

/* The plane of figure 9: frequencies from 110 Hz on, and shares of the clearance, where types are told. */
enum { PAPER_PLANE_FREQUENCIES = 11, PAPER_PLANE_CLEARANCES = 4 };

enum { PAPER_TYPES = 15 /* classified frequencies */, PAPER_LENGTH_TYPES = 13 /* and lengths, at 290 Hz */ };

typedef struct Paper {
    const char *path;       /* path of the beam file */
    Beam beam;              /* as in the file */
    Beam beams[PAPER_RUNS]; /* variants; their texts belong to the file's beam */
    Response responses[PAPER_RUNS];
    Experiment experiments[PAPER_STUDIES];
    Study studies[PAPER_STUDIES];
    double frequency[PAPER_TYPES]; /* Hz */
    Types types[PAPER_TYPES];
    double length[PAPER_LENGTH_TYPES]; /* m */
    Types length_types[PAPER_LENGTH_TYPES];
    double plane_frequency[PAPER_PLANE_FREQUENCIES], plane_clearance[PAPER_PLANE_CLEARANCES]; /* Hz, m */
    TypesKind plane[PAPER_PLANE_CLEARANCES][PAPER_PLANE_FREQUENCIES];                         /* by quick runs */
    PaperRun followed; /* the first run of the map's beam that is on a stable orbit; PAPER_RUNS: none */
    BeamFollow follow; /* of that orbit over the map: its folds and flips */
    Arena arena;
} Paper;

/* Options: threads, interruption and progress. */
typedef struct PaperOptions {
    const char *path;
    const char *const *settings; /* (setting_count) from the command line */
    size_t setting_count;
    int jobs;
    const Stop *stop;
    void (*progress)(void *context, const char *what); /* reports the next step; NULL: none */
    void *context;
} PaperOptions;

typedef enum PaperAnswer {
    PAPER_MADE, /* paper_clear releases it; otherwise there is nothing to clear */
    PAPER_FAULTY,
    PAPER_INTERRUPTED,
} PaperAnswer;

/* Runs all simulations. */
PaperAnswer paper_make(Paper *paper, const PaperOptions *options, Fault *fault);
void paper_clear(Paper *paper);

typedef enum PaperMet { PAPER_MET, PAPER_NOT_MET, PAPER_NOT_TOLD } PaperMet;

typedef struct PaperClaim {
    const char *id;    /* "chaos-peaks" */
    const char *place; /* place in the paper, "figure 2" */
    const char *claim; /* the claim as a sentence */
    const char *paper; /* the paper's figure, as legible */
    const char *ours;
    PaperMet met;
    const char *rule; /* condition for agreement */
} PaperClaim;

enum { PAPER_CLAIMS = 13 };

/* Fills the claims, whose texts live as long as the paper. */
void paper_claims(Paper *paper, PaperClaim claims[PAPER_CLAIMS]);

/* "met", "not met", "not told" */
const char *paper_met_name(PaperMet met);
