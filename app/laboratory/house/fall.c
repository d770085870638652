#include "laboratory/house/fall.h"

#include <inttypes.h>
#include <stdio.h>
#include <string.h>

#include "laboratory/house/picture.h"

/* Pieces ---------------------------------------------------------------------------------------------------------- */

static FurnitureFall *find(HouseFall *falls, const char *id) {
    for (size_t i = 0; i < falls->count; i++)
        if (strcmp(falls->pieces[i].piece.id, id) == 0)
            return &falls->pieces[i];
    return NULL;
}

/* Gives a fall the present piece, with the fall's own copy of the id. */
static void set_piece(FurnitureFall *fall, const Furniture *piece) {
    const char *id = fall->piece.id;
    fall->piece = *piece;
    fall->piece.id = id;
    fall->piece.name = "";
}

/* Begins the fall of a piece from standing or lying, unless the piece is falling already. */
static FurnitureFall *begin(HouseFall *falls, const Furniture *piece, bool lay) {
    FurnitureFall *fall = find(falls, piece->id);
    if (!fall) {
        falls->pieces = memory_reserve(falls->pieces, &falls->capacity, falls->count + 1, sizeof *falls->pieces);
        fall = &falls->pieces[falls->count++];
        *fall = (FurnitureFall){.piece = {.id = arena_text(&falls->arena, piece->id)}, .way = lay};
    }
    set_piece(fall, piece);
    fall->delay = 0;
    return fall;
}

static bool all_rest(const HouseFall *falls) {
    for (size_t i = 0; i < falls->count; i++)
        if (!furniture_fall_is_over(&falls->pieces[i]))
            return false;
    return true;
}

static void forget(HouseFall *falls) {
    falls->count = 0;
    *falls->text = 0;
    arena_clear(&falls->arena);
}

/* Steps of editing ------------------------------------------------------------------------------------------------ */

static const Furniture *find_piece(const Furniture *pieces, size_t count, const char *id) {
    for (size_t i = 0; i < count; i++)
        if (strcmp(pieces[i].id, id) == 0)
            return &pieces[i];
    return NULL;
}

/* Returns the plan's i-th piece as it was last seen, most often at the same index of the list. NULL: the piece is
 * new. */
static const Furniture *find_seen(const HouseFall *falls, const Plan *plan, size_t i) {
    const char *id = plan->furniture[i].id;
    bool same = i < falls->seen_count && strcmp(falls->seen[i].id, id) == 0;
    return same ? &falls->seen[i] : find_piece(falls->seen, falls->seen_count, id);
}

static void note(HouseFall *falls, const Draft *draft) {
    const Plan *plan = draft_plan(draft);
    arena_clear(&falls->seen_arena);
    falls->seen = memory_reserve(falls->seen, &falls->seen_capacity, plan->furniture_count + 1, sizeof *falls->seen);
    falls->seen_count = plan->furniture_count;
    for (size_t i = 0; i < plan->furniture_count; i++) {
        falls->seen[i] = plan->furniture[i];
        falls->seen[i].id = arena_text(&falls->seen_arena, plan->furniture[i].id);
    }
    falls->revision = draft_revision(draft);
    falls->noted = true;
}

static bool same_place(const Furniture *a, const Furniture *b) {
    return a->centre.x == b->centre.x && a->centre.y == b->centre.y && a->size.x == b->size.x &&
           a->size.y == b->size.y && a->angle == b->angle && a->height == b->height && a->topples == b->topples;
}

/* Begins the fall of each piece that was toppled or stood up since the plan was last seen. */
static bool begin_changed(HouseFall *falls, const Plan *plan) {
    bool any = false;
    for (size_t i = 0; i < plan->furniture_count; i++) {
        const Furniture *piece = &plan->furniture[i];
        const Furniture *seen = find_seen(falls, plan, i);
        if (!seen || seen->toppled == piece->toppled || !same_place(seen, piece))
            continue;
        begin(falls, piece, seen->toppled);
        *falls->text = 0;
        any = true;
    }
    return any;
}

/* Moves falling pieces to their edited places, and forgets removed pieces. */
static bool update_moved(HouseFall *falls, const Plan *plan) {
    size_t kept = 0, count = falls->count;
    for (size_t i = 0; i < count; i++) {
        const Furniture *piece = find_piece(plan->furniture, plan->furniture_count, falls->pieces[i].piece.id);
        if (!piece)
            continue;
        set_piece(&falls->pieces[i], piece);
        falls->pieces[kept++] = falls->pieces[i];
    }
    falls->count = kept;
    return kept < count;
}

/* True if the drawn house is the draft. */
static bool is_drawn(const HouseSession *session) {
    const HouseRun *run = session->runs[RUN_EARLY] ? session->runs[RUN_EARLY] : session->runs[RUN_SHOWN];
    return run && house_run_revision(run) == draft_revision(session->draft);
}

void house_fall_update(HouseSession *session) {
    HouseFall *falls = &session->fall;
    bool other = false;
    if (!falls->noted || falls->revision != draft_revision(session->draft)) {
        other = update_moved(falls, draft_plan(session->draft));
        other |= falls->wanted && falls->noted && begin_changed(falls, draft_plan(session->draft));
        note(falls, session->draft);
    }
    if (falls->count && all_rest(falls) && is_drawn(session)) {
        forget(falls);
        other = true;
    }
    if (other)
        house_picture_void_film(session);
}

/* Shortens all delays so that the first waiting fall begins at once. */
static void hurry(HouseFall *falls) {
    double least = FURNITURE_FALL_SPREAD;
    for (size_t i = 0; i < falls->count; i++)
        if (!furniture_fall_is_over(&falls->pieces[i]))
            least = fmin(least, falls->pieces[i].delay);
    for (size_t i = 0; i < falls->count; i++)
        falls->pieces[i].delay = fmax(0, falls->pieces[i].delay - least);
}

void house_fall_shake(HouseSession *session, uint64_t seed, const char *const *ids, size_t count) {
    HouseFall *falls = &session->fall;
    const Plan *plan = draft_plan(session->draft);
    if (!falls->wanted)
        return;
    update_moved(falls, plan);
    for (size_t i = 0; i < plan->furniture_count; i++) {
        const Furniture *piece = &plan->furniture[i];
        const Furniture *seen = find_seen(falls, plan, i);
        bool drops = text_is_among(piece->id, ids, count), stands_up = seen && seen->toppled && !piece->toppled;
        if (!drops && !stands_up && !find(falls, piece->id))
            continue;
        FurnitureFall *fall = begin(falls, piece, false);
        fall->way = drops ? 0 : piece->toppled;
        fall->delay = drops ? furniture_fall_delay(seed, piece->id) : 0;
    }
    hurry(falls);
    snprintf(falls->text, sizeof falls->text, "shaking (seed %" PRIu64 ")", seed);
    note(falls, session->draft);
    house_picture_void_film(session);
}

/* Display --------------------------------------------------------------------------------------------------------- */

void house_fall_advance(HouseSession *session, double seconds) {
    HouseFall *falls = &session->fall;
    falls->wanted = true;
    for (size_t i = 0; i < falls->count; i++)
        furniture_fall_move(&falls->pieces[i], seconds);
}

const char *house_fall_text(const HouseSession *session) {
    return all_rest(&session->fall) ? NULL : session->fall.text;
}

size_t house_fall_count(const HouseSession *session, double time) {
    return time >= session->history.at[session->history.count - 1].time ? session->fall.count : 0;
}

const FurnitureFall *house_fall_find(HouseSession *session, const char *id) {
    return session->fall.drawn ? find(&session->fall, id) : NULL;
}

void house_fall_clear(HouseSession *session) {
    HouseFall *falls = &session->fall;
    memory_free(falls->pieces);
    memory_free(falls->seen);
    arena_clear(&falls->arena);
    arena_clear(&falls->seen_arena);
    *falls = (HouseFall){0};
}
