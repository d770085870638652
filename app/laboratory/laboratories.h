/* The table of laboratories. To add one, write its Laboratory (laboratory.h) and add a row to the table in
 * laboratories.c: tabs, keys, the gallery, lists of files, settings, scripts and exports follow from the rows. */
#pragma once

#include "laboratory/laboratory.h"
#include "laboratory/thumbnail.h"

typedef struct LaboratoryRow {
    const Laboratory *laboratory;
    const char *help;  /* a sentence */
    const char *key;   /* key that displays the laboratory: "F2" */
    size_t folder;     /* folder of the shipped files: offset of the path in Shipped */
    const char *file;  /* file in that folder that is opened by default */
    const char *plots; /* all plots of `--plots`: "speed,clearance" */

    /* Reads a file's name, line and picture without a run. False: faults give the reasons, and the thumbnail is
     * empty. */
    bool (*read_thumbnail)(Thumbnail *thumbnail, const char *path, Fault *fault);
} LaboratoryRow;

extern const LaboratoryRow laboratories[]; /* (laboratories_count) in the order of their tabs */
extern const size_t laboratories_count;
