#include "command/study_types.h"

#include <stdio.h>
#include <string.h>

#include "command/answer.h"
#include "command/house_file.h"
#include "command/output.h"
#include "command/study_laboratory.h"
#include "command/types_answer.h"

/* Splits the list of names at its commas. */
static void split_names(StudyTypes *types, const char *list) {
    for (const char *at = list; *at && types->count <= TYPES_PARAMETERS_MOST;) {
        size_t length = strcspn(at, ",");
        char *name = arena_allocate(&types->arena, length + 1);
        types->names[types->count++] = memcpy(name, at, length);
        at += length + (at[length] == ',');
    }
}

bool study_types_open(StudyTypes *types, const Options *options, Fault *fault) {
    *types = (StudyTypes){.laboratory = NULL};
    types->laboratory = study_laboratory_open(&types->quick, options, fault);
    if (!types->laboratory)
        return false;
    types->both = types->laboratory->type_thoroughly != NULL;
    if (types->both && !study_laboratory_open(&types->thorough, options, fault)) {
        types->laboratory->close(&types->quick);
        return false;
    }
    if (types->both)
        types->laboratory->type_thoroughly(&types->thorough);
    split_names(types, options->types);
    return true;
}

void study_types_close(StudyTypes *types) {
    type_map_close(&types->map);
    if (types->both)
        types->laboratory->close(&types->thorough);
    types->laboratory->close(&types->quick);
    arena_clear(&types->arena);
}

static const Experiment *thorough_of(const StudyTypes *types) {
    return types->both ? &types->thorough : NULL;
}

bool study_types_of_runs(StudyTypes *types, Experiment *experiment, Fault *fault) {
    types->map = (TypeMap){
        .of = &types->quick, .thorough = thorough_of(types), .names = types->names, .name_count = types->count};
    return type_map_open(&types->map, experiment, fault);
}

static json_t *make_answer(const Types *types, const Experiment *experiment, const Options *options) {
    return json_pack("{s:s, s:s, s:s, s:s, s:o}", "kind", "types", "file", options->files[0], "of", experiment->kind,
                     "type", types_kind_name(types->kind), "types", types_answer_json(types, experiment, 0));
}

static bool write_answer(const json_t *answer, const Options *options) {
    char path[OUTPUT_PATH];
    snprintf(path, sizeof path, "%s/summary.json", options->out);
    int error = answer_write(answer, path);
    if (error)
        output_failed(path, error);
    return !error;
}

static void print_answer(const Types *types, const Experiment *experiment) {
    types_answer_print(types, experiment, 0);
    types_answer_print_parameters(types, experiment);
}

/* Prints and writes the answer. Returns the exit code. */
static int give_answer(const Types *types, const Experiment *experiment, const Options *options) {
    json_t *answer = make_answer(types, experiment, options);
    answer_mark_interrupted(answer, types->stopped);
    if (types->stopped)
        fprintf(stderr, "clearance: interrupted after %zu runs; what they decide is kept\n",
                types->runs + types->neighbour_runs);
    bool written = !options->out || write_answer(answer, options);
    if (options->json)
        answer_print(json_incref(answer));
    else
        print_answer(types, experiment);
    if (options->out && written && !options->json)
        printf("\ndata are in %s\n", options->out);
    json_decref(answer);
    if (!written)
        return EXIT_WRONG_INPUT;
    switch (types->kind) {
    case TYPES_I:
    case TYPES_II:
    case TYPES_III:
        return types->stopped ? EXIT_ANSWER_NO : EXIT_ANSWERED;
    case TYPES_UNRESOLVED:
    case TYPES_KIND_INTERRUPTED:
        break;
    }
    return EXIT_ANSWER_NO;
}

int study_types_answer(const Options *options) {
    StudyTypes asked;
    Types types;
    Fault fault = {0};
    if (!study_types_open(&asked, options, &fault))
        return house_file_report(&fault);
    bool good = output_directory(options->out) && types_answer_classify(&types, &asked.quick, thorough_of(&asked),
                                                                        asked.names, asked.count, options, &fault);
    int code = good ? give_answer(&types, &asked.quick, options) : house_file_report(&fault);
    study_types_close(&asked);
    return code;
}
