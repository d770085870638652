/* What Gu and Dubowsky's paper (1995) says of its impact beam system beside what a beam file does: the runs that this
 * takes, and each claim with the paper's figure, ours, and whether they agree.
 *
 * The paper's pictures are lost, and of its text every digit 0 and every capital T: what is compared is what can still
 * be read, or was reconstructed (assets/beams/ibs.json says how). Misfits are part of it. */
#pragma once

#include "beam/response.h"
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
    PAPER_FREQUENCIES, /* peaks against the drive's frequency, from rest, up and down */
    PAPER_LENGTHS,     /* peaks against the beam's length, at 290 Hz */
    PAPER_MAP,         /* responses over frequency and clearance */
    PAPER_STUDIES,
} PaperStudy;

enum { PAPER_TYPES = 15 /* frequencies at which the type is told */ };

typedef struct Paper {
    const char *path;       /* of the beam file */
    Beam beam;              /* as the file gives it */
    Beam beams[PAPER_RUNS]; /* what is changed of it; their texts are the file's */
    Response responses[PAPER_RUNS];
    Experiment experiments[PAPER_STUDIES];
    Study studies[PAPER_STUDIES];
    double frequency[PAPER_TYPES]; /* Hz */
    Types types[PAPER_TYPES];
    Arena arena;
} Paper;

/* How it is made: threads, and how to stop it and tell how far it is. */
typedef struct PaperOptions {
    const char *path;
    const char *const *settings; /* (setting_count) of the command line */
    size_t setting_count;
    int jobs;
    const volatile sig_atomic_t *stop;
    void (*progress)(void *context, const char *what); /* what is begun; NULL: none */
    void *context;
} PaperOptions;

/* Makes all runs. False: faults, or it was stopped, and there is nothing to clear. */
bool paper_make(Paper *paper, const PaperOptions *options, Fault *fault);
void paper_clear(Paper *paper);

typedef enum PaperMet { PAPER_MET, PAPER_NOT_MET, PAPER_NOT_TOLD } PaperMet;

typedef struct PaperClaim {
    const char *id;    /* "chaos-peaks" */
    const char *place; /* where in the paper, "figure 2" */
    const char *claim; /* what is claimed */
    const char *paper; /* its figure, as it is read */
    const char *ours;
    PaperMet met;
    const char *rule; /* when it counts as met */
} PaperClaim;

enum { PAPER_CLAIMS = 10 };

/* The claims, whose texts live as long as the paper. */
void paper_claims(Paper *paper, PaperClaim claims[PAPER_CLAIMS]);

/* "met", "not met", "not told" */
const char *paper_met_name(PaperMet met);
