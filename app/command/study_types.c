#include "command/study_types.h"

#include <stdio.h>
#include <string.h>

#include "command/answer.h"
#include "command/house_file.h"
#include "command/output.h"
#include "command/study_laboratory.h"
#include "command/types_answer.h"
#include "laboratory/beam_experiment.h"

/* The experiment, and the same told more thoroughly where there is such. */
typedef struct Pair {
    const StudyLaboratory *laboratory;
    Experiment quick, thorough;
    bool both;
} Pair;

static bool open_pair(Pair *pair, const Options *options, Fault *fault) {
    pair->laboratory = study_laboratory_open(&pair->quick, options, fault);
    pair->both = pair->laboratory && strcmp(pair->quick.kind, "beam") == 0;
    if (pair->both && !study_laboratory_open(&pair->thorough, options, fault)) {
        pair->laboratory->close(&pair->quick);
        return false;
    }
    if (pair->both)
        beam_experiment_be_thorough(&pair->thorough);
    return pair->laboratory;
}

static void close_pair(Pair *pair) {
    if (pair->both)
        pair->laboratory->close(&pair->thorough);
    pair->laboratory->close(&pair->quick);
}

/* The names of the list, parted by commas; returns how many. */
static size_t split_names(const Options *options, const char **names, Arena *arena) {
    size_t count = 0;
    for (const char *at = options->types; *at && count <= TYPES_PARAMETERS_MOST;) {
        size_t length = strcspn(at, ",");
        char *name = arena_allocate(arena, length + 1);
        names[count++] = memcpy(name, at, length);
        at += length + (at[length] == ',');
    }
    return count;
}

static json_t *make_answer(const Types *types, const Experiment *experiment, const Options *options) {
    return json_pack("{s:s, s:s, s:s, s:s, s:o}", "kind", "types", "file", options->files[0], "of", experiment->kind,
                     "type", types_kind_name(types->kind), "types", types_answer_json(types, experiment, NULL));
}

static bool write_answer(const json_t *answer, const Options *options) {
    char path[OUTPUT_PATH];
    snprintf(path, sizeof path, "%s/summary.json", options->out);
    int error = answer_write(answer, path);
    if (error)
        output_failed(path, error);
    return !error;
}

/* Prints and writes the answer; the exit code. */
static int give_answer(const Types *types, const Experiment *experiment, const Options *options) {
    json_t *answer = make_answer(types, experiment, options);
    bool written = !options->out || write_answer(answer, options);
    if (options->json)
        answer_print(json_incref(answer));
    else
        types_answer_print(types, experiment, NULL);
    if (options->out && written && !options->json)
        printf("\ndata are in %s\n", options->out);
    json_decref(answer);
    return !written ? EXIT_WRONG_INPUT : types->kind == TYPES_UNRESOLVED ? EXIT_ANSWER_NO : EXIT_ANSWERED;
}

int study_types_answer(const Options *options) {
    Pair pair = {0};
    Fault fault = {0};
    if (!open_pair(&pair, options, &fault))
        return house_file_report(&fault);
    Arena arena = {0};
    const char *names[TYPES_PARAMETERS_MOST + 1];
    size_t count = split_names(options, names, &arena);
    Types types;
    bool good =
        types_answer_tell(&types, &pair.quick, pair.both ? &pair.thorough : NULL, names, count, options, &fault);
    int code = good ? give_answer(&types, &pair.quick, options) : house_file_report(&fault);
    close_pair(&pair);
    arena_clear(&arena);
    return code;
}
