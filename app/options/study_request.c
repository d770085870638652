#include "options/study_request.h"

#include <ctype.h>
#include <errno.h>
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
