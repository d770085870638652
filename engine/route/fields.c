#include "route/fields.h"

#include <pthread.h>
#include <stdint.h>

#include "base/memory.h"

typedef struct Shared {
    FieldKey key;
    Ground ground;
    Field field;
    bool ready;    /* built */
    int users;     /* acquired and not yet released */
    uint64_t used; /* time of the last acquisition, counted in acquisitions */
} Shared;

typedef struct Framed {
    const Plan *plan;
    int sense;
    RouteFrame frame;
    bool ready; /* built, or found to be impossible */
    bool good;
} Framed;

struct Fields {
    pthread_mutex_t lock;
    pthread_cond_t built; /* a field or a frame */
    Framed **frames;      /* (frame_count) */
    size_t frame_count, frame_capacity;
    Shared **all; /* (count) */
    size_t count, capacity;
    uint64_t takings;
};

Fields *fields_create(void) {
    Fields *fields = memory_zeroed(1, sizeof *fields);
    pthread_mutex_init(&fields->lock, NULL);
    pthread_cond_init(&fields->built, NULL);
    return fields;
}

static void shared_free(Shared *shared) {
    field_clear(&shared->field);
    field_ground_clear(&shared->ground);
    memory_free(shared);
}

void fields_destroy(Fields *fields) {
    for (size_t i = 0; i < fields->count; i++)
        shared_free(fields->all[i]);
    memory_free(fields->all);
    for (size_t i = 0; i < fields->frame_count; i++) {
        if (fields->frames[i]->good)
            frame_free(&fields->frames[i]->frame);
        memory_free(fields->frames[i]);
    }
    memory_free(fields->frames);
    pthread_cond_destroy(&fields->built);
    pthread_mutex_destroy(&fields->lock);
    memory_free(fields);
}

/* True if two goals across exits have the same usable exits, at any time. */
static bool same_goal(const Goal *one, const Goal *other, const Plan *plan) {
    if (one->radius > 0 || other->radius > 0)
        return vec2_distance(one->at, other->at) <= 0 && !(one->radius < other->radius || one->radius > other->radius);
    for (size_t e = 0; e < plan->exit_count; e++)
        if (field_exit_usable(one, plan, e) != field_exit_usable(other, plan, e))
            return false;
    return true;
}

static bool same_bars(const FieldBars *one, const FieldBars *other) {
    bool same = one->count == other->count;
    for (size_t b = 0; b < one->count && same; b++)
        same = vec2_distance(one->all[b].at, other->all[b].at) <= 0 &&
               !(one->all[b].radius < other->all[b].radius || one->all[b].radius > other->all[b].radius);
    return same;
}

static bool same_key(const FieldKey *one, const FieldKey *other) {
    return one->plan == other->plan && one->space == other->space && one->profile == other->profile &&
           !(one->radius < other->radius || one->radius > other->radius) && one->exact == other->exact &&
           one->stop == other->stop && same_bars(&one->bars, &other->bars) &&
           same_goal(&one->goal, &other->goal, one->plan);
}

static size_t field_bytes(const FieldKey *key) {
    return (size_t)key->space->nx * (size_t)key->space->ny * 2 * sizeof(float);
}

/* Drops unused fields, the longest unused first, until `bytes` more have room, if possible. */
static void make_room(Fields *fields, size_t bytes) {
    size_t held = bytes;
    for (size_t i = 0; i < fields->count; i++)
        held += field_bytes(&fields->all[i]->key);
    while (held > FIELDS_MOST_BYTES) {
        size_t oldest = fields->count;
        for (size_t i = 0; i < fields->count; i++)
            if (!fields->all[i]->users && (oldest == fields->count || fields->all[i]->used < fields->all[oldest]->used))
                oldest = i;
        if (oldest == fields->count)
            return;
        held -= field_bytes(&fields->all[oldest]->key);
        shared_free(fields->all[oldest]);
        fields->all[oldest] = fields->all[--fields->count];
    }
}

static Shared *find(const Fields *fields, const FieldKey *key) {
    for (size_t i = 0; i < fields->count; i++)
        if (same_key(&fields->all[i]->key, key))
            return fields->all[i];
    return NULL;
}

static void build(Shared *shared) {
    const FieldKey *key = &shared->key;
    if (key->exact)
        field_ground_init_exact(&shared->ground, key->plan, key->space, key->profile, key->radius);
    else
        field_ground_init(&shared->ground, key->plan, key->space, key->profile, key->radius);
    shared->ground.stop = key->stop;
    field_ground_bar(&shared->ground, &key->bars);
    field_init(&shared->field, &shared->ground, &key->goal);
}

const Field *fields_acquire(Fields *fields, const FieldKey *key) {
    pthread_mutex_lock(&fields->lock);
    Shared *shared = find(fields, key);
    bool new = !shared;
    if (new) {
        make_room(fields, field_bytes(key));
        shared = memory_zeroed(1, sizeof *shared);
        shared->key = *key;
        fields->all = memory_reserve(fields->all, &fields->capacity, fields->count + 1, sizeof(Shared *));
        fields->all[fields->count++] = shared;
    }
    shared->users++;
    shared->used = ++fields->takings;
    if (new) { /* other threads continue meanwhile, except threads that need the same field */
        pthread_mutex_unlock(&fields->lock);
        build(shared);
        pthread_mutex_lock(&fields->lock);
        shared->ready = true;
        pthread_cond_broadcast(&fields->built);
    }
    while (!shared->ready)
        pthread_cond_wait(&fields->built, &fields->lock);
    pthread_mutex_unlock(&fields->lock);
    return &shared->field;
}

void fields_release(Fields *fields, const Field *field) {
    pthread_mutex_lock(&fields->lock);
    for (size_t i = 0; i < fields->count; i++)
        if (&fields->all[i]->field == field)
            fields->all[i]->users--;
    pthread_mutex_unlock(&fields->lock);
}

static Framed *find_frame(const Fields *fields, const Plan *plan, int sense) {
    for (size_t i = 0; i < fields->frame_count; i++)
        if (fields->frames[i]->plan == plan && fields->frames[i]->sense == sense)
            return fields->frames[i];
    return NULL;
}

const RouteFrame *fields_frame(Fields *fields, const Plan *plan, int sense) {
    pthread_mutex_lock(&fields->lock);
    Framed *framed = find_frame(fields, plan, sense);
    if (!framed) {
        framed = memory_zeroed(1, sizeof *framed);
        framed->plan = plan;
        framed->sense = sense;
        fields->frames =
            memory_reserve(fields->frames, &fields->frame_capacity, fields->frame_count + 1, sizeof(Framed *));
        fields->frames[fields->frame_count++] = framed;
        pthread_mutex_unlock(&fields->lock);
        bool good = frame_build(&framed->frame, plan, sense);
        pthread_mutex_lock(&fields->lock);
        framed->good = good;
        framed->ready = true;
        pthread_cond_broadcast(&fields->built);
    }
    while (!framed->ready)
        pthread_cond_wait(&fields->built, &fields->lock);
    pthread_mutex_unlock(&fields->lock);
    return framed->good ? &framed->frame : NULL;
}
