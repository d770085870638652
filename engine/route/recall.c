#include "route/recall.h"

#include <pthread.h>
#include <stdint.h>
#include <string.h>

#include "base/memory.h"
#include "route/fields.h"

/* While a piece of furniture is dragged, most chairs never come near it: their searches read the same distances, the
 * same faces and the same times to the exit as before. So an answer is kept together with all that was read for it:
 *
 *     distances  by tiles of the grid; what is more than `enough` does not matter: the chair is at its free speed
 *     faces      by bucket, those in the box around all places from which the body looked, as far as it looked
 *     times      by tiles of the grid, to each goal
 *
 * It is the answer to another question if all of these are the same, to the bit, in the other house: a search is a
 * function of what it reads. What else it depends on, the start, the body, the profile, exits, doors and walls, is the
 * key, compared whole. The times are recomputed for each house, which takes a small part of the time of a search. */

typedef struct Bytes {
    unsigned char *at; /* (count) */
    size_t count, capacity;
} Bytes;

/* Tiles of a grid and their values. */
typedef struct Tiles {
    int *tiles; /* (count) */
    size_t count;
    float *values; /* (value_count) of all tiles, row by row */
    size_t value_count;
} Tiles;

/* The faces of a bucket in a box. */
typedef struct Faces {
    int bucket;
    Box box;          /* m */
    int first, count; /* in the kept faces, in the bucket's order */
} Faces;

typedef struct Kept {
    Bytes key;
    Tiles distances;
    Tiles *times; /* (goal_count) */
    size_t goal_count;
    Faces *buckets; /* (bucket_count) */
    size_t bucket_count;
    int *faces; /* (face_count) indices of kept ends */
    size_t face_count;
    Vec2 (*ends)[2]; /* (end_count) m, of all faces */
    size_t end_count;
    float enough; /* m */
    RecallAnswer answer;
    size_t *pins;
    size_t bytes;
    int users;     /* threads that compare it just now */
    uint64_t used; /* counted in questions and answers */
} Kept;

struct Recall {
    pthread_mutex_t lock;
    Kept **all; /* (count) */
    size_t count, capacity, bytes;
    uint64_t uses;
    size_t found;
};

Recall *recall_create(void) {
    Recall *recall = memory_zeroed(1, sizeof *recall);
    pthread_mutex_init(&recall->lock, NULL);
    return recall;
}

static void kept_free(Kept *kept) {
    for (size_t g = 0; g < kept->goal_count; g++) {
        memory_free(kept->times[g].tiles);
        memory_free(kept->times[g].values);
    }
    memory_free(kept->times);
    memory_free(kept->distances.tiles);
    memory_free(kept->distances.values);
    memory_free(kept->key.at);
    memory_free(kept->buckets);
    memory_free(kept->faces);
    memory_free(kept->ends);
    memory_free(kept->pins);
    search_track_clear(&kept->answer.track);
    memory_free(kept);
}

void recall_destroy(Recall *recall) {
    for (size_t i = 0; i < recall->count; i++)
        kept_free(recall->all[i]);
    memory_free(recall->all);
    pthread_mutex_destroy(&recall->lock);
    memory_free(recall);
}

/* The key -------------------------------------------------------------------------------------------------------- */

static void add_bytes(Bytes *bytes, const void *from, size_t count) {
    bytes->at = memory_reserve(bytes->at, &bytes->capacity, bytes->count + count, 1);
    memcpy(bytes->at + bytes->count, from, count);
    bytes->count += count;
}

static void add_number(Bytes *bytes, double number) {
    add_bytes(bytes, &number, sizeof number);
}

static void add_vector(Bytes *bytes, Vec2 vector) {
    add_number(bytes, vector.x);
    add_number(bytes, vector.y);
}

static void add_plan(Bytes *key, const Plan *plan) {
    add_number(key, (double)plan->wall_count);
    for (size_t w = 0; w < plan->wall_count; w++) {
        const Wall *wall = &plan->walls[w];
        add_number(key, wall->thickness);
        add_number(key, (double)wall->points.count);
        for (size_t i = 0; i < wall->points.count; i++)
            add_vector(key, wall->points.at[i]);
    }
    add_number(key, (double)plan->door_count);
    for (size_t d = 0; d < plan->door_count; d++) {
        const Door *door = &plan->doors[d];
        const double numbers[] = {door->segment,
                                  door->at,
                                  door->width,
                                  door->kind,
                                  door->state,
                                  door->hinge,
                                  door->swing,
                                  door->opening_time,
                                  door->leaf,
                                  door->rest,
                                  (double)door->wall_index};
        add_bytes(key, numbers, sizeof numbers);
    }
    add_number(key, (double)plan->exit_count);
    for (size_t e = 0; e < plan->exit_count; e++) {
        const Exit *exit = &plan->exits[e];
        add_vector(key, exit->from);
        add_vector(key, exit->to);
        add_number(key, exit->opens);
        add_number(key, exit->closes);
    }
}

static Bytes make_key(const RecallQuestion *question) {
    const RouteQuery *query = question->query;
    const FreeSpace *space = query->space;
    const Profile *profile = query->profile;
    Bytes key = {0};
    const double numbers[] = {question->body->half_length,
                              question->body->half_width,
                              question->body->ahead,
                              question->radius,
                              question->depth,
                              question->coarsely,
                              query->any,
                              query->whether,
                              query->rolls,
                              query->most_reversals,
                              query->at.x,
                              query->at.y,
                              query->heading,
                              space->origin.x,
                              space->origin.y,
                              space->cell,
                              space->nx,
                              space->ny,
                              space->bucket,
                              space->bucket_nx,
                              space->bucket_ny,
                              (double)question->goal_count};
    add_bytes(&key, numbers, sizeof numbers);
    for (size_t g = 0; g < question->goal_count; g++) {
        const Goal *goal = &question->goals[g];
        const double of_goal[] = {goal->at.x,         goal->at.y, goal->radius,
                                  (double)goal->exit, goal->time, goal->opens_before};
        add_bytes(&key, of_goal, sizeof of_goal);
    }
    const char *begin = (const char *)&profile->driving, *end = (const char *)profile->provenance;
    add_bytes(&key, begin, (size_t)(end - begin));
    add_plan(&key, query->plan);
    return key;
}

/* Comparing ------------------------------------------------------------------------------------------------------ */

/* Returns the points in a tile of a grid of nx by ny, with those next to it above and to the right. */
static void tile_points(int tile, int tile_nx, int nx, int ny, int low[2], int high[2]) {
    low[0] = tile % tile_nx * READS_TILE;
    low[1] = tile / tile_nx * READS_TILE;
    high[0] = low[0] + READS_TILE < nx ? low[0] + READS_TILE + 1 : nx;
    high[1] = low[1] + READS_TILE < ny ? low[1] + READS_TILE + 1 : ny;
}

/* True if values are the same in the tiles, or at least `enough` both before and now. */
static bool same_tiles(const Tiles *tiles, const float *values, const FreeSpace *space, float enough) {
    int tile_nx = (space->nx + READS_TILE - 1) / READS_TILE;
    size_t used = 0;
    for (size_t t = 0; t < tiles->count; t++) {
        int low[2], high[2];
        tile_points(tiles->tiles[t], tile_nx, space->nx, space->ny, low, high);
        size_t across = (size_t)(high[0] - low[0]);
        for (int j = low[1]; j < high[1]; j++, used += across) {
            const float *before = tiles->values + used, *now = values + (size_t)j * (size_t)space->nx + (size_t)low[0];
            if (memcmp(before, now, across * sizeof *now) == 0)
                continue;
            for (size_t i = 0; i < across; i++)
                if (memcmp(before + i, now + i, sizeof *now) != 0 && !(before[i] >= enough && now[i] >= enough))
                    return false;
        }
    }
    return true;
}

static bool same_ends(const Vec2 *ends, const Face *face) {
    const Vec2 now[2] = {face->a, face->b};
    return memcmp(ends, now, sizeof now) == 0;
}

/* True if the same faces of each bucket are in its box, in the same order. */
static bool same_faces(const Kept *kept, const FreeSpace *space) {
    for (size_t b = 0; b < kept->bucket_count; b++) {
        const Faces *faces = &kept->buckets[b];
        int end = space->bucket_starts[faces->bucket + 1], count = 0;
        for (int k = space->bucket_starts[faces->bucket]; k < end; k++) {
            const Face *face = &space->outline->faces[space->bucket_faces[k]];
            if (!reads_may_meet(faces->box, face->a, face->b))
                continue;
            if (count == faces->count || !same_ends(kept->ends[kept->faces[faces->first + count]], face))
                return false;
            count++;
        }
        if (count < faces->count)
            return false;
    }
    return true;
}

static void know_tile(const Field *field, int tile) {
    const FreeSpace *space = field->ground->space;
    int low[2], high[2];
    tile_points(tile, (space->nx + READS_TILE - 1) / READS_TILE, space->nx, space->ny, low, high);
    field_know(field, low[0], low[1], high[0], high[1]);
}

static bool same_times(const Kept *kept, const RecallQuestion *question) {
    const RouteQuery *query = question->query;
    FieldKey key = {query->plan, query->space, query->profile, question->radius, .stop = query->stop};
    bool same = true;
    for (size_t g = 0; g < question->goal_count && same; g++) {
        if (!kept->times[g].count)
            continue;
        key.goal = question->goals[g];
        const Field *field = fields_acquire(query->fields, &key);
        for (size_t t = 0; t < kept->times[g].count; t++)
            know_tile(field, kept->times[g].tiles[t]);
        same = same_tiles(&kept->times[g], field->time, query->space, HUGE_VALF);
        fields_release(query->fields, field);
    }
    return same;
}

/* Returns the face with the kept ends that decided, or -1. */
static int face_now(const Kept *kept, const FreeSpace *space) {
    int face = kept->answer.tightest.face;
    for (size_t f = 0; face >= 0 && f < space->outline->face_count; f++)
        if (same_ends(kept->ends[face], &space->outline->faces[f]))
            return (int)f;
    return -1;
}

static void copy_track(SearchTrack *to, const SearchTrack *from) {
    *to = *from;
    to->capacity = 0;
    to->poses = memory_reserve(NULL, &to->capacity, from->count, sizeof *to->poses);
    if (from->count)
        memcpy(to->poses, from->poses, from->count * sizeof *to->poses);
}

static void give(const Kept *kept, const RecallQuestion *question, RecallAnswer *answer) {
    *answer = (RecallAnswer){kept->answer.decided, {0}, answer->pins, kept->answer.tightest, kept->answer.has_tightest};
    copy_track(&answer->track, &kept->answer.track);
    if (answer->has_tightest) {
        answer->tightest.face = face_now(kept, question->query->space);
        fit_find_face(question->query->space, question->body, &answer->tightest);
    }
    memcpy(answer->pins, kept->pins, question->goal_count * sizeof *answer->pins);
}

bool recall_find(Recall *recall, const RecallQuestion *question, RecallAnswer *answer) {
    Bytes key = make_key(question);
    pthread_mutex_lock(&recall->lock);
    Kept **alike = memory_zeroed(recall->count, sizeof(Kept *));
    size_t count = 0;
    for (size_t i = recall->count; i-- > 0;) { /* the latest first */
        Kept *kept = recall->all[i];
        if (kept->key.count != key.count || memcmp(kept->key.at, key.at, key.count) != 0)
            continue;
        kept->users++;
        alike[count++] = kept;
    }
    pthread_mutex_unlock(&recall->lock);
    const FreeSpace *space = question->query->space;
    Kept *found = NULL;
    for (size_t i = 0; i < count && !found; i++)
        if (same_faces(alike[i], space) && same_tiles(&alike[i]->distances, space->distance, space, alike[i]->enough) &&
            same_times(alike[i], question))
            found = alike[i];
    if (found)
        give(found, question, answer);
    pthread_mutex_lock(&recall->lock);
    for (size_t i = 0; i < count; i++)
        alike[i]->users--;
    if (found) {
        found->used = ++recall->uses;
        recall->found++;
    }
    pthread_mutex_unlock(&recall->lock);
    memory_free(alike);
    memory_free(key.at);
    return found;
}

/* Keeping -------------------------------------------------------------------------------------------------------- */

void recall_watch(RecallWatch *watch, const RecallQuestion *question) {
    const FreeSpace *space = question->query->space;
    *watch = (RecallWatch){.space = *space};
    watch->reads = reads_begin(space->nx, space->ny, (size_t)space->bucket_nx * (size_t)space->bucket_ny);
    watch->space.reads = &watch->reads;
    watch->times = memory_zeroed(question->goal_count, sizeof *watch->times);
    for (size_t g = 0; g < question->goal_count; g++)
        watch->times[g] = reads_begin(space->nx, space->ny, 0);
}

static void keep_tiles(Tiles *tiles, const Reads *reads, const float *values, const FreeSpace *space) {
    size_t all = (size_t)reads->tile_nx * (size_t)reads->tile_ny, capacity = 0, value_capacity = 0;
    for (size_t t = 0; t < all; t++) {
        if (!reads->tiles[t])
            continue;
        tiles->tiles = memory_reserve(tiles->tiles, &capacity, tiles->count + 1, sizeof *tiles->tiles);
        tiles->tiles[tiles->count++] = (int)t;
        int low[2], high[2];
        tile_points((int)t, reads->tile_nx, space->nx, space->ny, low, high);
        size_t across = (size_t)(high[0] - low[0]);
        for (int j = low[1]; j < high[1]; j++, tiles->value_count += across) {
            tiles->values = memory_reserve(tiles->values, &value_capacity, tiles->value_count + across, sizeof *values);
            memcpy(tiles->values + tiles->value_count, values + (size_t)j * (size_t)space->nx + (size_t)low[0],
                   across * sizeof *values);
        }
    }
}

static void keep_faces(Kept *kept, const Reads *reads, const FreeSpace *space) {
    const Outline *outline = space->outline;
    size_t bucket_capacity = 0, capacity = 0;
    for (size_t b = 0; b < reads->list_count; b++) {
        Box box = reads->boxes[b];
        if (!(box.low.x <= box.high.x))
            continue;
        Faces faces = {.bucket = (int)b, .box = box, .first = (int)kept->face_count};
        for (int k = space->bucket_starts[b]; k < space->bucket_starts[b + 1]; k++) {
            int face = space->bucket_faces[k];
            if (!reads_may_meet(box, outline->faces[face].a, outline->faces[face].b))
                continue;
            kept->faces = memory_reserve(kept->faces, &capacity, kept->face_count + 1, sizeof *kept->faces);
            kept->faces[kept->face_count++] = face;
            faces.count++;
        }
        kept->buckets = memory_reserve(kept->buckets, &bucket_capacity, kept->bucket_count + 1, sizeof *kept->buckets);
        kept->buckets[kept->bucket_count++] = faces;
    }
    kept->end_count = outline->face_count;
    kept->ends = memory_zeroed(kept->end_count, sizeof *kept->ends);
    for (size_t f = 0; f < kept->end_count; f++) {
        kept->ends[f][0] = outline->faces[f].a;
        kept->ends[f][1] = outline->faces[f].b;
    }
}

/* Returns a distance, m, from which on a chair drives at its free speed, at most as far as distances are exact. */
static double enough_for(const Profile *profile) {
    const double step = 0.05; /* m */
    double enough = step;
    while (enough < FREESPACE_FARTHEST && field_speed(profile, enough) < field_speed(profile, FREESPACE_FARTHEST))
        enough += step;
    return fmin(enough + step, FREESPACE_FARTHEST);
}

static size_t bytes_of(const Kept *kept) {
    size_t bytes = sizeof *kept + kept->key.capacity + kept->distances.value_count * sizeof(float) +
                   kept->bucket_count * sizeof(Faces) + kept->face_count * sizeof(int) +
                   kept->end_count * sizeof *kept->ends + kept->answer.track.count * sizeof(Pose);
    for (size_t g = 0; g < kept->goal_count; g++)
        bytes += kept->times[g].value_count * sizeof(float);
    return bytes;
}

/* Forgets what was not used for longest until `bytes` more have room, as far as nobody compares it. */
static void make_room(Recall *recall, size_t bytes) {
    while (recall->bytes + bytes > RECALL_MOST_BYTES) {
        size_t oldest = recall->count;
        for (size_t i = 0; i < recall->count; i++)
            if (!recall->all[i]->users && (oldest == recall->count || recall->all[i]->used < recall->all[oldest]->used))
                oldest = i;
        if (oldest == recall->count)
            return;
        recall->bytes -= recall->all[oldest]->bytes;
        kept_free(recall->all[oldest]);
        recall->count--;
        memmove(recall->all + oldest, recall->all + oldest + 1, (recall->count - oldest) * sizeof(Kept *));
    }
}

static Kept *make_kept(const RecallQuestion *question, const RecallWatch *watch, const RecallAnswer *answer) {
    const RouteQuery *query = question->query;
    Kept *kept = memory_zeroed(1, sizeof *kept);
    kept->key = make_key(question);
    kept->goal_count = question->goal_count;
    keep_tiles(&kept->distances, &watch->reads, query->space->distance, query->space);
    keep_faces(kept, &watch->reads, query->space);
    kept->enough = (float)enough_for(query->profile);
    kept->times = memory_zeroed(kept->goal_count, sizeof *kept->times);
    FieldKey key = {query->plan, query->space, query->profile, question->radius, .stop = query->stop};
    for (size_t g = 0; g < kept->goal_count; g++) {
        key.goal = question->goals[g];
        const Field *field = fields_acquire(query->fields, &key);
        for (size_t t = 0; t < (size_t)watch->times[g].tile_nx * (size_t)watch->times[g].tile_ny; t++)
            if (watch->times[g].tiles[t])
                know_tile(field, (int)t);
        keep_tiles(&kept->times[g], &watch->times[g], field->time, query->space);
        fields_release(query->fields, field);
    }
    kept->answer = *answer;
    copy_track(&kept->answer.track, &answer->track);
    kept->pins = memory_zeroed(kept->goal_count, sizeof *kept->pins);
    memcpy(kept->pins, answer->pins, kept->goal_count * sizeof *kept->pins);
    kept->answer.pins = kept->pins;
    kept->bytes = bytes_of(kept);
    return kept;
}

void recall_keep(Recall *recall, const RecallQuestion *question, RecallWatch *watch, const RecallAnswer *answer) {
    Kept *kept = answer && !watch->reads.beyond ? make_kept(question, watch, answer) : NULL;
    reads_free(&watch->reads);
    for (size_t g = 0; g < question->goal_count; g++)
        reads_free(&watch->times[g]);
    memory_free(watch->times);
    if (!kept)
        return;
    pthread_mutex_lock(&recall->lock);
    make_room(recall, kept->bytes);
    kept->used = ++recall->uses;
    if (recall->bytes + kept->bytes <= RECALL_MOST_BYTES) {
        recall->all = memory_reserve(recall->all, &recall->capacity, recall->count + 1, sizeof(Kept *));
        recall->all[recall->count++] = kept;
        recall->bytes += kept->bytes;
        kept = NULL;
    }
    pthread_mutex_unlock(&recall->lock);
    if (kept)
        kept_free(kept);
}

size_t recall_found(Recall *recall) {
    pthread_mutex_lock(&recall->lock);
    size_t found = recall->found;
    pthread_mutex_unlock(&recall->lock);
    return found;
}
