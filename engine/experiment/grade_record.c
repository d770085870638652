#include "experiment/grade_record.h"

#include <pthread.h>
#include <string.h>

#include "base/digest.h"
#include "base/text.h"
#include "inquiry/grade.h"

enum { SHELVES = 1024 /* lists by which known grades are found */ };

typedef struct Known Known;

/* The worst grade of a house. */
struct Known {
    uint64_t house; /* digest of what makes it another one */
    double letter;  /* NAN: nobody in it has a grade */
    char *place;    /* or NULL */
    Known *next;
};

struct GradeRecord {
    size_t few, index;
    pthread_mutex_t lock;
    Known *shelves[SHELVES];
};

Observable grade_record_describe(void) {
    return (Observable){"grade", "1", "worst grade of the ways out"};
}

GradeRecord *grade_record_create(size_t few, size_t usual) {
    GradeRecord *record = memory_zeroed(1, sizeof *record);
    record->few = few;
    record->index = usual;
    pthread_mutex_init(&record->lock, NULL);
    return record;
}

void grade_record_free(GradeRecord *record) {
    for (size_t s = 0; record && s < SHELVES; s++)
        for (Known *known = record->shelves[s], *next; known; known = next) {
            next = known->next;
            memory_free(known->place);
            memory_free(known);
        }
    if (record)
        pthread_mutex_destroy(&record->lock);
    memory_free(record);
}

/* True if the number has no effect on the room that a way has: how the motion is computed. When people start has one,
 * as exits close. */
static bool is_of_motion(const char *name) {
    return strcmp(name, "run.dt") == 0 || strcmp(name, "run.until") == 0;
}

static uint64_t digest_of(const House *house, const char *const *names, size_t name_count, const Trial *trial) {
    uint64_t digest = DIGEST_START;
    for (size_t n = 0; n < name_count; n++)
        digest = is_of_motion(names[n]) ? digest : digest_mix(digest, trial->at[n]);
    return house->plan.crowd_count ? digest_mix(digest, (double)trial->seed) : digest; /* crowds start by chance */
}

static const Known *find_known(GradeRecord *record, uint64_t house) {
    pthread_mutex_lock(&record->lock);
    const Known *known = record->shelves[house % SHELVES];
    while (known && known->house != house)
        known = known->next;
    pthread_mutex_unlock(&record->lock);
    return known;
}

static const Known *add_known(GradeRecord *record, Known own) {
    Known *known = memory_zeroed(1, sizeof *known);
    *known = own;
    pthread_mutex_lock(&record->lock);
    known->next = record->shelves[own.house % SHELVES];
    record->shelves[own.house % SHELVES] = known;
    pthread_mutex_unlock(&record->lock);
    return known;
}

/* Grades a house. Two threads may grade the same one at once, with the same result. Returns NULL if interrupted. */
static const Known *grade_house(GradeRecord *record, const House *house, const Observation *observation,
                                uint64_t digest, const Stop *stop) {
    Grade worst;
    if (!grade_answer_worst(&worst, house, observation, record->few, stop))
        return NULL;
    Known known = {.house = digest, .letter = worst.interrupted ? (double)NAN : worst.letter};
    if (worst.has_place && !worst.weak)
        known.place = text_copy(worst.what);
    return add_known(record, known);
}

bool grade_record_observe(GradeRecord *record, const House *house, const Observation *observation,
                          const char *const *names, size_t name_count, Trial *trial, const Stop *stop) {
    trial->observed[record->index] = (double)NAN;
    if (!observation->completed)
        return true;
    uint64_t digest = digest_of(house, names, name_count, trial);
    const Known *known = find_known(record, digest);
    if (!known)
        known = grade_house(record, house, observation, digest, stop);
    if (!known)
        return false;
    trial->observed[record->index] = known->letter;
    trial->note = known->place ? text_copy(known->place) : NULL;
    return true;
}
