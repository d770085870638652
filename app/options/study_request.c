#include "options/study_request.h"

#include <ctype.h>
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Returns the NAME before the first =, and the rest after it; NULL if there is none. */
static const char *take_name(const char *words, const char **rest, Arena *arena) {
    const char *equals = strchr(words, '=');
    if (!equals || equals == words)
        return NULL;
    size_t length = (size_t)(equals - words);
    char *name = arena_allocate(arena, length + 1);
    memcpy(name, words, length);
    *rest = equals + 1;
    return name;
}

/* Reads a number that is followed by `end`. */
static bool take_number(const char **words, char end, double *number) {
    char *after;
    *number = strtod(*words, &after);
    bool good = after != *words && *after == end;
    *words = good && end ? after + 1 : after;
    return good;
}

static bool take_steps(const char *words, size_t *steps) {
    char *after;
    errno = 0;
    unsigned long long number = strtoull(words, &after, 10);
    *steps = (size_t)number;
    return isdigit((unsigned char)*words) && !*after && !errno;
}

bool study_request_vary(StudyRequest *request, const char *words, Arena *arena) {
    StudyAxis axis;
    if (request->axis_count == STUDY_AXES_MOST || !(axis.name = take_name(words, &words, arena)) ||
        !take_number(&words, ':', &axis.from) || !take_number(&words, ':', &axis.to) || !take_steps(words, &axis.steps))
        return false;
    request->axes[request->axis_count++] = axis;
    return true;
}

bool study_request_spread(StudyRequest *request, const char *words, Arena *arena) {
    StudySpread spread;
    if (request->spread_count == STUDY_SPREADS_MOST || !(spread.name = take_name(words, &words, arena)) ||
        !take_number(&words, 0, &spread.share))
        return false;
    request->spreads[request->spread_count++] = spread;
    return true;
}

bool study_request_sweep(StudyRequest *request, const char *words) {
    for (request->pass_count = 0; request->pass_count < STUDY_PASSES;) {
        size_t length = strcspn(words, ",");
        StudyPass pass = STUDY_RESET;
        while (pass < STUDY_PASSES &&
               (strlen(study_pass_name(pass)) != length || memcmp(study_pass_name(pass), words, length) != 0))
            pass++;
        if (pass == STUDY_PASSES)
            return false;
        request->passes[request->pass_count++] = pass;
        if (!words[length])
            return true;
        words += length + 1;
    }
    return false;
}

/* Reads a whole number that is followed by `end`. */
static bool take_whole(const char **words, char end, size_t *number) {
    char *after;
    errno = 0;
    unsigned long long value = strtoull(*words, &after, 10);
    bool good = isdigit((unsigned char)**words) && *after == end && !errno;
    *words = good && end ? after + 1 : after;
    *number = (size_t)value;
    return good;
}

static bool take_variable(const char *name, size_t *number) {
    const char *value = name ? getenv(name) : NULL;
    return value && take_whole(&value, 0, number);
}

/* How a scheduler numbers the tasks of an array. */
typedef struct ArrayVariables {
    const char *task, *count, *first, *last; /* names; the last two may be NULL */
    size_t from;                             /* number of the first task where `first` is not set */
} ArrayVariables;

/* Takes the task's number in its array. An array with gaps is one that repeats some tasks of a larger one. */
static bool take_array(StudyRequest *request, const ArrayVariables *variables) {
    size_t task, count, first, last;
    if (!take_variable(variables->task, &task) || !take_variable(variables->count, &count))
        return false;
    if (!take_variable(variables->first, &first))
        first = variables->from;
    if (take_variable(variables->last, &last) && last != first + count - 1)
        return false;
    if (first > 1 || task < first || task - first >= count || count > STUDY_SHARDS_MOST)
        return false;
    request->shard = (StudyShard){task - first + 1, count};
    snprintf(request->shard_named, sizeof request->shard_named, "%s and %s", variables->task, variables->count);
    return true;
}

bool study_request_shard(StudyRequest *request, const char *words) {
    static const ArrayVariables arrays[] = {
        {"SLURM_ARRAY_TASK_ID", "SLURM_ARRAY_TASK_COUNT", "SLURM_ARRAY_TASK_MIN", "SLURM_ARRAY_TASK_MAX", 1},
        {"SGE_TASK_ID", "SGE_TASK_LAST", "SGE_TASK_FIRST", NULL, 1},
        {"OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_SIZE", NULL, NULL, 0}};
    for (size_t a = 0; !words && a < sizeof arrays / sizeof *arrays; a++)
        if (take_array(request, &arrays[a]))
            return true;
    StudyShard *shard = &request->shard;
    return words && take_whole(&words, '/', &shard->number) && take_whole(&words, 0, &shard->count) &&
           shard->number >= 1 && shard->number <= shard->count && shard->count <= STUDY_SHARDS_MOST;
}
