/* The same drivers through the same house with one part of the driving law left out at a time: what each part is worth.
 *
 * Every variant is a set of settings that --set takes as well, so that each row of the table can be made again by
 * `run --drivers`. Driver k has the same body, strength, speed, start and errors of steering in every variant
 * (population.h), so that differences are paired.
 */
#pragma once

#include "base/stop.h"
#include "experiment/drivers.h"
#include "house/house.h"
#include "house/observation.h"

typedef enum AblationVariant {
    ABLATION_WHOLE,
    ABLATION_NO_RING,
    ABLATION_RING_PUSHES,
    ABLATION_NO_WANDER,
    ABLATION_NO_HANDS,
    ABLATION_STRONG,
    ABLATION_PAPER,
    ABLATION_PAPER_NO_F4,
    ABLATION_PAPER_NO_LATERAL,
    ABLATIONS
} AblationVariant;

enum { ABLATION_SETTINGS = 2 };

typedef struct AblationRow {
    const char *name;                        /* "ring off" */
    const char *meaning;                     /* what is left out, or put in its place */
    const char *settings[ABLATION_SETTINGS]; /* NAME=VALUE; "%s" stands for the profile of the population */
    int driving;                             /* Driving of all people, or -1: as in their profiles */
} AblationRow;

/* (ABLATIONS) */
extern const AblationRow ablation_rows[];

typedef struct Ablation {
    House house;                /* of the whole law */
    Drivers drivers[ABLATIONS]; /* runs of the same people and drivers */
    Observation nominal;        /* of the nominal driver by the whole law */
    bool interrupted;           /* True: some of the variants are missing */
} Ablation;

/* Reads a house (house_read) and runs drivers 1 to count through each variant. Returns false after an error of the
 * house. ablation_free releases the result. */
bool ablation_run(Ablation *ablation, const char *path, const HouseOptions *options, const Population *population,
                  size_t count, int jobs, const Stop *stop, Fault *fault);
void ablation_free(Ablation *ablation);
