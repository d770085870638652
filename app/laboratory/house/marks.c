#include "laboratory/house/marks.h"

#include <math.h>
#include <stdlib.h>

#include "visual/house/people_scene.h"

enum { MARKS_MOST = 2000 };

#define NEW_CONTACT 0.1 /* s: a body that has been free for less is still touching */

static void add_mark(HouseSession *session, double time, TimelineMarkKind kind) {
    HouseTexts *texts = &session->texts;
    if (texts->mark_count == MARKS_MOST)
        return;
    texts->marks = memory_reserve(texts->marks, &texts->mark_capacity, texts->mark_count + 1, sizeof *texts->marks);
    texts->marks[texts->mark_count++] = (TimelineMark){time, kind};
}

static int compare_times(const void *a, const void *b) {
    double p = *(const double *)a, q = *(const double *)b;
    return (p > q) - (p < q);
}

/* Marks when half, 95 of 100 and all of a crowd are out, as its plot does. */
static void add_shares(HouseSession *session) {
    static const double shares[] = {0.5, 0.95, 1};
    const Observation *observation = session->observation;
    double *times = memory_zeroed(observation->person_count + 1, sizeof *times);
    size_t count = 0, all = 0;
    for (size_t i = 0; i < observation->person_count; i++) {
        all += observation->people[i].took_part;
        if (observation->people[i].completed)
            times[count++] = observation->people[i].time;
    }
    qsort(times, count, sizeof *times, compare_times);
    for (size_t s = 0; s < sizeof shares / sizeof *shares; s++) {
        size_t needed = (size_t)ceil(shares[s] * (double)all - 1e-9);
        if (needed > 0 && needed <= count)
            add_mark(session, times[needed - 1], TIMELINE_EXIT);
    }
    memory_free(times);
}

static int compare_marks(const void *a, const void *b) {
    const TimelineMark *p = a, *q = b;
    return p->time != q->time ? (p->time > q->time) - (p->time < q->time) : (int)p->kind - (int)q->kind;
}

void house_marks_make(HouseSession *session) {
    const Observation *observation = session->observation;
    bool crowd = session->runs[RUN_SHOWN]->house.person_count > PEOPLE_SCENE_INDIVIDUALS;
    session->texts.mark_count = 0;
    for (size_t i = 0; i < observation->person_count; i++) {
        const PersonObservation *person = &observation->people[i];
        const Trail *trail = &session->trails.trails[i];
        double touched = -HUGE_VAL;
        for (size_t r = 0; r < trail->count; r++) {
            const double *row = trail->rows[r];
            if (!(row[TRACE_BODY_FORCE] > 0))
                continue;
            if (row[TRACE_TIME] - touched > NEW_CONTACT)
                add_mark(session, row[TRACE_TIME], TIMELINE_CONTACT);
            touched = row[TRACE_TIME];
        }
        if (person->completed && !crowd)
            add_mark(session, person->time, TIMELINE_EXIT);
        if (person->reason == REASON_DIVERGED)
            add_mark(session, person->time, TIMELINE_ERROR);
    }
    if (crowd && session->whole)
        add_shares(session);
    for (size_t i = 1; i < session->runs[RUN_SHOWN]->wish.epoch_count; i++)
        add_mark(session, session->runs[RUN_SHOWN]->wish.epochs[i].time, TIMELINE_CHANGE);
    if (session->texts.mark_count > 1)
        qsort(session->texts.marks, session->texts.mark_count, sizeof *session->texts.marks, compare_marks);
}
