#include "house/walkers.h"

#include <string.h>

#include "base/digest.h"
#include "base/memory.h"
#include "base/parallel.h"
#include "house/walk.h"
#include "house/phase.h"
#include "house/world.h"

enum { CHUNK = 128 /* slots that one thread processes at once */ };

enum { LISTS_LIVE = 10 /* decisions, at most: facing directions are those at the time when the lists were built */ };

enum {
    MARK_CHAIR = 1,     /* the slot of a chair, or of a person who is held inside a wall: not moved here */
    MARK_OBSTACLES = 2, /* an obstacle may be touched */
    MARK_EXIT = 4,      /* an exit's line may be crossed */
};

static const uint32_t NOBODY = UINT32_MAX;

/* Kinds and laws -------------------------------------------------------------------------------------------------- */

static WalkerKind kind_of(const Profile *profile) {
    return (WalkerKind){.radius = profile->width / 2,
                        .reach = profile->space_reach,
                        .mass = profile->mass,
                        .per_response = 1 / profile->speed_response,
                        .acceleration = real_min(profile->acceleration, profile->push / profile->mass),
                        .walks = profile->driving == DRIVING_WALKER};
}

static WalkerLaw law_between(const Profile *a, const Profile *b) {
    WalkerLaw law = {.radii = (a->width + b->width) / 2,
                     .reach = real_max(a->space_reach, b->space_reach),
                     .space = contact_mean(&a->space, &b->space),
                     .contact = contact_mean(&a->contact, &b->contact)};
    law.range2 = (law.radii + law.reach) * (law.radii + law.reach);
    return law;
}

void walkers_init(Walkers *walkers, const World *world) {
    const House *house = world->house;
    size_t kinds = house->profile_count;
    *walkers = (Walkers){.kind_count = kinds, .doors = -1, .people = house->person_count};
    walkers->kinds = memory_zeroed(kinds, sizeof *walkers->kinds);
    walkers->laws = memory_zeroed(kinds * kinds, sizeof *walkers->laws);
    for (size_t a = 0; a < kinds; a++) {
        const Profile *profile = &house->profiles[a];
        walkers->kinds[a] = kind_of(profile);
        walkers->any |= walkers->kinds[a].walks;
        Body body = body_of(profile);
        walkers->widest = real_max(walkers->widest, body.swing + body.radius);
        for (size_t b = 0; b < kinds; b++) {
            walkers->laws[a * kinds + b] = law_between(profile, &house->profiles[b]);
            if (walkers->kinds[a].walks && house->profiles[b].driving == DRIVING_WALKER)
                walkers->range = real_max(walkers->range, sqrt(walkers->laws[a * kinds + b].range2));
        }
    }
    walkers->slot_of = memory_zeroed(walkers->people, sizeof *walkers->slot_of);
    walkers->old_slot_of = memory_zeroed(walkers->people, sizeof *walkers->old_slot_of);
    memset(walkers->slot_of, 0xff, walkers->people * sizeof *walkers->slot_of);
    if (walkers->any)
        walkers->walls = memory_zeroed(walkers->people, sizeof *walkers->walls);
    double side = real_max(walkers->range + WALKERS_SKIN, 0.5); /* m */
    cell_grid_shape(&walkers->cells, house->outline.box, side, walkers->people);
}

/* Memory ------------------------------------------------------------------------------------------------------------*/

/* Calls `each` for every array whose length is the number of slots, people or list entries. */
#define SLOT_ARRAYS(EACH)                                                                                              \
    EACH(at) EACH(velocity) EACH(next_at) EACH(next_velocity) EACH(wish) EACH(push) EACH(facing) EACH(kind) EACH(marks)

static void *copy_of(const void *from, size_t count, size_t size) {
    if (!from)
        return NULL;
    void *to = memory_zeroed(count, size);
    memcpy(to, from, count * size);
    return to;
}

void walkers_copy(Walkers *to, const Walkers *from) {
    *to = *from;
    size_t pairs = from->first ? from->first[from->cells.count] : 0, kinds = from->kind_count;
    cell_grid_copy(&to->cells, &from->cells);
    to->kinds = copy_of(from->kinds, kinds, sizeof *to->kinds);
    to->laws = copy_of(from->laws, kinds * kinds, sizeof *to->laws);
#define COPY(array) to->array = copy_of(from->array, from->capacity, sizeof *to->array);
    SLOT_ARRAYS(COPY)
#undef COPY
    to->first = copy_of(from->first, from->capacity + 1, sizeof *to->first);
    to->other = copy_of(from->other, pairs, sizeof *to->other);
    to->slip = copy_of(from->slip, pairs, sizeof *to->slip);
    to->list_capacity = to->slip_capacity = pairs;
    to->old_first = memory_zeroed(from->capacity + 1, sizeof *to->old_first); /* only used while lists are built */
    to->old_who = memory_zeroed(from->capacity, sizeof *to->old_who);
    to->old_other = NULL;
    to->old_slip = NULL;
    to->old_list_capacity = to->old_slip_capacity = 0;
    to->slot_of = copy_of(from->slot_of, from->people, sizeof *to->slot_of);
    to->old_slot_of = copy_of(from->old_slot_of, from->people, sizeof *to->old_slot_of);
    to->walls = copy_of(from->walls, from->people, sizeof *to->walls);
    to->reports = NULL;
    to->report_capacity = 0;
}

void walkers_clear(Walkers *walkers) {
    cell_grid_clear(&walkers->cells);
    memory_free(walkers->kinds);
    memory_free(walkers->laws);
#define FREE(array) memory_free(walkers->array);
    SLOT_ARRAYS(FREE)
#undef FREE
    memory_free(walkers->first);
    memory_free(walkers->other);
    memory_free(walkers->slip);
    memory_free(walkers->old_first);
    memory_free(walkers->old_other);
    memory_free(walkers->old_who);
    memory_free(walkers->old_slip);
    memory_free(walkers->slot_of);
    memory_free(walkers->old_slot_of);
    memory_free(walkers->walls);
    memory_free(walkers->reports);
    *walkers = (Walkers){0};
}

/* Reserves slots. People only ever leave, so the first size is the largest. */
static void reserve_slots(Walkers *walkers, size_t count) {
    if (count <= walkers->capacity && walkers->first)
        return;
    walkers->capacity = count;
#define RESERVE(array)                                                                                                 \
    memory_free(walkers->array);                                                                                       \
    walkers->array = memory_zeroed(count, sizeof *walkers->array);
    SLOT_ARRAYS(RESERVE)
    RESERVE(old_who)
#undef RESERVE
    memory_free(walkers->first);
    memory_free(walkers->old_first);
    walkers->first = memory_zeroed(count + 1, sizeof *walkers->first);
    walkers->old_first = memory_zeroed(count + 1, sizeof *walkers->old_first);
}

/* Lists -------------------------------------------------------------------------------------------------------------*/

typedef struct Pass {
    World *world;
    bool senses;
} Pass;

static size_t chunk_count(const Walkers *walkers) {
    return (walkers->cells.count + CHUNK - 1) / CHUNK;
}

static uint32_t chunk_end(const Walkers *walkers, size_t chunk) {
    size_t end = (chunk + 1) * CHUNK;
    return (uint32_t)(end < walkers->cells.count ? end : walkers->cells.count);
}

static uint8_t marks_at(const World *world, Vec2 at, bool walks) {
    const Plan *plan = &world->house->plan;
    const ObstacleGrid *grid = &world->house->obstacles;
    if (!walks)
        return MARK_CHAIR;
    uint8_t marks = 0;
    double moves = WALKERS_SKIN; /* m, until the marks are rebuilt */
    for (int corner = 0; corner < 9 && !(marks & MARK_OBSTACLES); corner++) {
        size_t count;
        obstacle_grid_at(grid, vec2_add(at, vec2((corner % 3 - 1) * moves, (corner / 3 - 1) * moves)), &count);
        if (count)
            marks |= MARK_OBSTACLES;
    }
    for (size_t e = 0; e < plan->exit_count; e++)
        if (vec2_distance(at, vec2_nearest_on_segment(at, plan->exits[e].from, plan->exits[e].to)) < moves)
            marks |= MARK_EXIT;
    return marks;
}

static void load_chunk(void *context, size_t chunk) {
    World *world = context;
    Walkers *walkers = &world->walkers;
    for (uint32_t s = (uint32_t)(chunk * CHUNK), end = chunk_end(walkers, chunk); s < end; s++) {
        uint32_t i = walkers->cells.who[s];
        walkers->at[s] = walkers->next_at[s] = world->centre[i];
        walkers->velocity[s] = walkers->next_velocity[s] = world->velocity[i];
        walkers->wish[s] = world->walk[i].wish;
        walkers->push[s] = vec2(0, 0);
        walkers->facing[s] = world->axis[i];
        walkers->kind[s] = (uint16_t)(world->house->people[i].profile - world->house->profiles);
        walkers->marks[s] =
            marks_at(world, walkers->at[s], walkers->kinds[walkers->kind[s]].walks && world->was_clear[i]);
        walkers->slot_of[i] = s;
    }
}

/* Lists the nearby, visible walkers; `list` NULL: only counts them. */
static uint32_t list_near(const World *world, uint32_t s, uint32_t *list) {
    const Walkers *walkers = &world->walkers;
    uint32_t found = 0;
    if (walkers->marks[s] & MARK_CHAIR)
        return 0;
    Vec2 at = walkers->at[s];
    const WalkerLaw *laws = walkers->laws + walkers->kind[s] * walkers->kind_count;
    CellRange range = cell_grid_around(&walkers->cells, at, walkers->range + WALKERS_SKIN);
    for (int y = range.y0; y <= range.y1; y++) {
        uint32_t end;
        for (uint32_t o = cell_grid_row(&walkers->cells, &range, y, &end); o < end; o++) {
            const WalkerLaw *law = &laws[walkers->kind[o]];
            double near = law->radii + law->reach + WALKERS_SKIN;
            Vec2 from = vec2_sub(walkers->at[o], at);
            if (vec2_dot(from, from) >= near * near || o == s || (walkers->marks[o] & MARK_CHAIR))
                continue;
            bool rising = walkers->cells.who[s] < walkers->cells.who[o]; /* both ask the same question */
            if (!freespace_sees(&world->house->space, rising ? at : walkers->at[o], rising ? walkers->at[o] : at))
                continue;
            if (list)
                list[found] = o;
            found++;
        }
    }
    return found;
}

static void count_chunk(void *context, size_t chunk) {
    World *world = context;
    Walkers *walkers = &world->walkers;
    for (uint32_t s = (uint32_t)(chunk * CHUNK), end = chunk_end(walkers, chunk); s < end; s++)
        walkers->first[s + 1] = list_near(world, s, NULL);
}

/* Copies the springs between slot `s` and its neighbours from the previous lists. */
static void take_over_slips(Walkers *walkers, uint32_t s) {
    uint32_t before = walkers->old_slot_of[walkers->cells.who[s]];
    for (uint32_t k = walkers->first[s]; k < walkers->first[s + 1]; k++) {
        uint32_t other = walkers->cells.who[walkers->other[k]];
        walkers->slip[k] = (WalkerSlip){0, 0};
        for (uint32_t o = before == NOBODY ? 0 : walkers->old_first[before];
             before != NOBODY && o < walkers->old_first[before + 1]; o++)
            if (walkers->old_who[walkers->old_other[o]] == other) {
                walkers->slip[k] = walkers->old_slip[o];
                break;
            }
    }
}

static void fill_chunk(void *context, size_t chunk) {
    World *world = context;
    Walkers *walkers = &world->walkers;
    if (!walkers->other)
        return; /* no person is near another one */
    for (uint32_t s = (uint32_t)(chunk * CHUNK), end = chunk_end(walkers, chunk); s < end; s++) {
        list_near(world, s, walkers->other + walkers->first[s]);
        take_over_slips(walkers, s);
    }
}

#define SWAP(type, a, b)                                                                                               \
    do {                                                                                                               \
        type swapped = a;                                                                                              \
        a = b;                                                                                                         \
        b = swapped;                                                                                                   \
    } while (0)

static void make_lists(World *world) {
    Walkers *walkers = &world->walkers;
    reserve_slots(walkers, world->present_count);
    if (walkers->cells.count)
        memcpy(walkers->old_who, walkers->cells.who, walkers->cells.count * sizeof *walkers->old_who);
    SWAP(uint32_t *, walkers->slot_of, walkers->old_slot_of);
    SWAP(uint32_t *, walkers->first, walkers->old_first);
    SWAP(uint32_t *, walkers->other, walkers->old_other);
    SWAP(WalkerSlip *, walkers->slip, walkers->old_slip);
    SWAP(size_t, walkers->list_capacity, walkers->old_list_capacity);
    SWAP(size_t, walkers->slip_capacity, walkers->old_slip_capacity);
    memset(walkers->slot_of, 0xff, walkers->people * sizeof *walkers->slot_of);
    cell_grid_sort(&walkers->cells, world->present, world->present_count, world->centre);
    size_t chunks = chunk_count(walkers);
    parallel_team_for(world->team, chunks, load_chunk, world);
    walkers->first[0] = 0;
    parallel_team_for(world->team, chunks, count_chunk, world);
    for (size_t s = 0; s < walkers->cells.count; s++)
        walkers->first[s + 1] += walkers->first[s];
    size_t pairs = walkers->first[walkers->cells.count];
    walkers->other = memory_reserve(walkers->other, &walkers->list_capacity, pairs, sizeof *walkers->other);
    walkers->slip = memory_reserve(walkers->slip, &walkers->slip_capacity, pairs, sizeof *walkers->slip);
    parallel_team_for(world->team, chunks, fill_chunk, world);
    walkers->travelled = 0;
    walkers->made = world->clock.step;
    walkers->doors = world->door_changes;
    walkers->departures = world->departures;
}

bool walkers_update(World *world) {
    Walkers *walkers = &world->walkers;
    bool hold = walkers->doors == world->door_changes && walkers->departures == world->departures &&
                2 * walkers->travelled <= WALKERS_SKIN &&
                world->clock.step < walkers->made + LISTS_LIVE * world->decision_steps;
    if (!hold)
        make_lists(world);
    return !hold;
}

/* Forces ------------------------------------------------------------------------------------------------------------*/

/* Returns the direction from one walker to another. Two walkers at one point are pushed apart along x, in opposite
 * directions. */
static inline Vec2 direction_from(Vec2 from, double distance, bool lower) {
    if (distance > 0)
        return vec2_scale(from, 1 / distance);
    return vec2(lower ? -1 : 1, 0);
}

/* Returns F1: the force of the walkers near slot `s`. */
static inline __attribute__((always_inline)) Vec2 force_of_walkers(Walkers *walkers, uint32_t s, double dt,
                                                                   Sense *sense) {
    const Vec2 at = walkers->at[s], velocity = walkers->velocity[s];
    const WalkerLaw *laws = walkers->laws + walkers->kind[s] * walkers->kind_count;
    Vec2 force = walkers->push[s];
    for (uint32_t k = walkers->first[s], end = walkers->first[s + 1]; k < end; k++) {
        uint32_t o = walkers->other[k];
        const WalkerLaw *law = &laws[walkers->kind[o]];
        Vec2 from = vec2_sub(at, walkers->at[o]);
        double square = vec2_dot(from, from);
        WalkerSlip *slip = &walkers->slip[k];
        if (square >= law->range2) {
            *slip = (WalkerSlip){0, 0};
            continue;
        }
        double distance = sqrt(square), gap = distance - law->radii;
        Vec2 normal = direction_from(from, distance, s < o);
        Vec2 moving = vec2_sub(velocity, walkers->velocity[o]);
        double rate = vec2_dot(moving, normal), sliding = vec2_dot(moving, vec2_left(normal));
        double push = contact_normal(&law->space, gap - law->reach, rate), body = 0, along = 0;
        if (push > 0)
            along = contact_tangential(&law->space, push, sliding, dt, &slip->ring);
        else
            slip->ring = 0;
        if (gap < 0) {
            body = contact_normal(&law->contact, gap, rate);
            if (body > 0)
                along += contact_tangential(&law->contact, body, sliding, dt, &slip->body);
        }
        if (body <= 0)
            slip->body = 0;
        if (sense)
            world_feel(sense, gap, law->reach, body, push,
                       vec2_along(at, -walkers->kinds[walkers->kind[s]].radius, normal), (int)walkers->cells.who[o]);
        force = vec2_along(vec2_along(force, push + body, normal), along, vec2_left(normal));
    }
    return force;
}

/* The obstacles near a place, prepared for gaps. */
typedef struct Beside {
    const NeighbourFace *faces[GAPS_MOST];
    const NeighbourCorner *corners[GAPS_MOST];
    size_t face_count, corner_count;
} Beside;

/* Collects at most GAPS_MOST features of a kind, which only an impossible plan exceeds within a disc's reach. */
static void look_beside(Beside *beside, const World *world, Vec2 at, double reach) {
    const ObstacleGrid *grid = &world->house->obstacles;
    size_t count;
    const uint32_t *items = obstacle_grid_at(grid, at, &count);
    beside->face_count = beside->corner_count = 0;
    for (size_t k = 0; k < count; k++) {
        uint32_t item = items[k];
        if (!obstacle_grid_has(grid, item, world->door_open))
            continue;
        if (item < grid->face_count) {
            const NeighbourFace *face = &grid->faces[item];
            double distance = vec2_dot(face->normal, at) - face->offset, along = vec2_dot(vec2_left(face->normal), at);
            if (distance < reach && distance > -reach && along >= face->begin - reach && along <= face->end + reach &&
                beside->face_count < GAPS_MOST)
                beside->faces[beside->face_count++] = face;
        } else {
            const NeighbourCorner *corner = &grid->corners[item - grid->face_count];
            Vec2 from = vec2_sub(at, corner->at);
            if (vec2_dot(from, from) < reach * reach && beside->corner_count < GAPS_MOST)
                beside->corners[beside->corner_count++] = corner;
        }
    }
}

/* Returns F2: the force of the obstacles near slot `s`. */
static Vec2 force_of_obstacles(World *world, uint32_t s, uint32_t i, const Beside *beside, double dt, Sense *sense) {
    Walkers *walkers = &world->walkers;
    const WalkerKind *kind = &walkers->kinds[walkers->kind[s]];
    const WalkerLaw *law = &walkers->laws[walkers->kind[s] * (walkers->kind_count + 1)];
    WallSlips *slips = &walkers->walls[i], kept = {0};
    Vec2 at = walkers->at[s], velocity = walkers->velocity[s], force = {0, 0};
    int held[WALKERS_WALLS];
    size_t held_count = 0;
    for (int k = 0; k < slips->count; k++)
        if (slips->slip[k].touches)
            held[held_count++] = slips->slip[k].key;
    Gap gaps[GAPS_MOST];
    size_t count = gap_of_disc(gaps, at, kind->radius, kind->reach, beside->faces, beside->face_count, beside->corners,
                               beside->corner_count, held, held_count);
    for (size_t g = 0; g < count; g++) {
        const Gap *gap = &gaps[g];
        const Slip *before = gap_find_slip(slips->slip, slips->count, gap->key);
        Slip slip = before ? *before : (Slip){.key = gap->key};
        double rate = vec2_dot(velocity, gap->normal), sliding = vec2_dot(velocity, vec2_left(gap->normal));
        double soft, hard;
        Vec2 ring = gap_force(&law->space, gap, gap->gap - kind->reach, rate, sliding, dt, &slip.ring, &soft);
        Vec2 body = gap_force(&law->contact, gap, gap->gap, rate, sliding, dt, &slip.body, &hard);
        slip.touches = gap->gap < 0;
        if (kept.count < WALKERS_WALLS)
            kept.slip[kept.count++] = slip;
        force = vec2_add(force, vec2_add(ring, body));
        if (sense)
            world_feel(sense, gap->gap, kind->reach, hard, soft, vec2_add(at, gap->arm), -1);
    }
    *slips = kept;
    return force;
}

/* Motion ------------------------------------------------------------------------------------------------------------*/

/* Counts the faces through which the body's middle has entered a wall. */
static int crossed_faces(const Beside *beside, Vec2 before, Vec2 after) {
    int crossed = 0;
    for (size_t f = 0; f < beside->face_count; f++)
        crossed += neighbour_list_crosses(beside->faces[f], before, after);
    return crossed;
}

/* Returns F3: towards the wanted velocity, limited by a_0 and the push. */
static inline Vec2 effort(const WalkerKind *kind, Vec2 wish, Vec2 velocity) {
    Vec2 wanted = vec2_scale(vec2_sub(wish, velocity), kind->per_response);
    double square = vec2_dot(wanted, wanted);
    if (square > kind->acceleration * kind->acceleration)
        wanted = vec2_scale(wanted, kind->acceleration / sqrt(square));
    return wanted;
}

static inline __attribute__((always_inline)) void step_walker(World *world, WalkerReport *report, uint32_t s,
                                                              bool senses) {
    Walkers *walkers = &world->walkers;
    uint32_t i = walkers->cells.who[s];
    const WalkerKind *kind = &walkers->kinds[walkers->kind[s]];
    double dt = world->clock.dt;
    if (world->phase[i] == PHASE_MOVING && (world->clock.step + i) % world->decision_steps == 0) {
        walk_decide(world, i, s);
        walkers->wish[s] = world->walk[i].wish;
    }
    Sense *sense = senses ? &world->sense[i] : NULL;
    Vec2 force = force_of_walkers(walkers, s, dt, sense);
    Beside beside; /* count reset without clearing: this is the inner loop */
    beside.face_count = beside.corner_count = 0;
    if (walkers->marks[s] & MARK_OBSTACLES) {
        look_beside(&beside, world, walkers->at[s], world->house->obstacles.reach);
        if (beside.face_count + beside.corner_count > 0)
            force = vec2_add(force, force_of_obstacles(world, s, i, &beside, dt, sense));
    }
    Vec2 driven = effort(kind, walkers->wish[s], walkers->velocity[s]);
    Vec2 velocity = vec2_along(vec2_along(walkers->velocity[s], dt, driven), dt / kind->mass, force);
    Vec2 before = walkers->at[s], after = vec2_along(before, dt, velocity);
    if (!world_holds(world, after)) { /* diverged: back to the last good state */
        report->diverged = report->diverged == NOBODY ? i : report->diverged;
        after = before;
        velocity = vec2(0, 0);
    }
    if (walkers->marks[s] & MARK_EXIT)
        phase_hold(world, before, &after, &velocity);
    walkers->next_at[s] = world->centre[i] = after;
    walkers->next_velocity[s] = world->velocity[i] = velocity;
    if (beside.face_count)
        report->crossings += crossed_faces(&beside, before, after);
    if ((walkers->marks[s] & MARK_EXIT) && world->phase[i] == PHASE_MOVING)
        report->departures += phase_leave(world, i, before, after);
    report->fastest2 = real_max(report->fastest2, vec2_dot(velocity, velocity));
    report->digest += digest_pair(digest_pair(0, after), velocity);
}

static void step_chunk(void *context, size_t chunk) {
    Pass *pass = context;
    Walkers *walkers = &pass->world->walkers;
    WalkerReport report = {.diverged = NOBODY};
    uint32_t begin = (uint32_t)(chunk * CHUNK), end = chunk_end(walkers, chunk);
    if (pass->senses) {
        for (uint32_t s = begin; s < end; s++)
            if (!(walkers->marks[s] & MARK_CHAIR))
                step_walker(pass->world, &report, s, true);
    } else {
        for (uint32_t s = begin; s < end; s++)
            if (!(walkers->marks[s] & MARK_CHAIR))
                step_walker(pass->world, &report, s, false);
    }
    walkers->reports[chunk] = report;
}

uint64_t walkers_step(World *world, bool senses, size_t *diverged) {
    Walkers *walkers = &world->walkers;
    Pass pass = {world, senses};
    size_t chunks = chunk_count(walkers);
    uint64_t digest = 0;
    double fastest2 = 0;
    if (!walkers->any)
        return 0;
    walkers->reports = memory_reserve(walkers->reports, &walkers->report_capacity, chunks, sizeof *walkers->reports);
    parallel_team_for(world->team, chunks, step_chunk, &pass);
    for (size_t c = 0; c < chunks; c++) {
        const WalkerReport *report = &walkers->reports[c];
        fastest2 = real_max(fastest2, report->fastest2);
        digest += report->digest;
        world->departures += report->departures;
        world->wall_crossings += report->crossings;
        if (report->diverged != NOBODY && *diverged == SIZE_MAX)
            *diverged = report->diverged;
    }
    walkers->travelled += sqrt(fastest2) * world->clock.dt;
    SWAP(Vec2 *, walkers->at, walkers->next_at);
    SWAP(Vec2 *, walkers->velocity, walkers->next_velocity);
    return digest;
}

void walkers_sync_chairs(World *world) {
    Walkers *walkers = &world->walkers;
    double fastest2 = 0;
    for (size_t r = 0; r < world->rider_count; r++) {
        size_t i = world->riders[r];
        uint32_t s = walkers->slot_of[i];
        if (s == NOBODY)
            continue;
        walkers->at[s] = world->centre[i];
        walkers->velocity[s] = world->velocity[i];
        fastest2 = real_max(fastest2, vec2_dot(world->velocity[i], world->velocity[i]));
    }
    walkers->travelled += sqrt(fastest2) * world->clock.dt;
}
