/* Files of values with provenance, as those of a beam or a crank: one object per group of rows, each value either bare
 * or
 * {"value": .., "provenance": ..}, beside "format", "version", "name" and "note". Reading, settings of the command
 * line, writing and the schema all follow from the table. */
#pragma once

#include "base/parameters.h"
#include "base/provenance.h"
#include "base/text.h"

/* One kind of file. */
typedef struct ProvenanceFile {
    const char *what;   /* "beam" */
    const char *format; /* "clearance-beam" */
    const char *title;  /* of the schema */
    const ParameterTable *table;
    const char *const *groups; /* (group_count) a group whose rows all have fallbacks may be absent */
    size_t group_count;
    const char *sources; /* allowed beginnings of a provenance, as "paper|assumed" */
} ProvenanceFile;

/* The parts of an object that such a file describes. */
typedef struct ProvenanceTarget {
    void *object;            /* the struct that the table describes */
    const char **provenance; /* (rows of the table) */
    const char **name, **note;
    Arena *arena; /* owns the texts */
} ProvenanceTarget;

/* True if the "format" of the file is this one; false also for an unreadable file. */
bool provenance_file_is(const ProvenanceFile *kind, const char *path);

/* Reads name, note and all groups from the file's root into the target, whose rows are reset first. */
void provenance_file_read(const ProvenanceFile *kind, const ProvenanceTarget *target, const JsonNode *root,
                          Fault *fault);

/* Applies a NAME=VALUE of the command line; VALUE is a number or a choice. */
void provenance_file_set(const ProvenanceFile *kind, const ProvenanceTarget *target, const char *setting, Fault *fault);

/* Writes the file so that reading it gives the same object. Writes a temporary file in the same folder, then renames
 * it. Returns 0, or errno. */
int provenance_file_write(const ProvenanceFile *kind, const ProvenanceTarget *target, const char *path);

/* Returns the JSON Schema of such a file. New. */
json_t *provenance_file_schema(const ProvenanceFile *kind);
