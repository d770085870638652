#include "laboratory/edit/shake.h"

#include <inttypes.h>
#include <stdio.h>
#include <string.h>

#include "base/memory.h"
#include "house/shake.h"
#include "laboratory/edit/gesture.h"
#include "laboratory/edit/select.h"

const EditShake *edit_shake_last(const Editor *edit) {
    uint64_t revision = draft_revision(edit->draft);
    for (size_t i = edit->shake_count; i-- > 0;)
        if (edit->shakes[i].revision == revision)
            return &edit->shakes[i];
    return NULL;
}

/* True if the piece fell in that shake. */
static bool fell(const EditShake *shake, const char *id) {
    for (size_t k = 0; k < shake->count; k++)
        if (strcmp(shake->ids[k], id) == 0)
            return true;
    return false;
}

/* Returns the furniture as before that shake (furniture_count). Release it with memory_free. */
static Furniture *furniture_before(const Plan *plan, const EditShake *shake) {
    Furniture *before = memory_zeroed(plan->furniture_count + 1, sizeof *before);
    for (size_t i = 0; i < plan->furniture_count; i++) {
        before[i] = plan->furniture[i];
        if (shake && fell(shake, before[i].id))
            before[i].toppled = false;
    }
    return before;
}

/* Stores which pieces have fallen in a shake of a house. */
static EditShake *store(Editor *edit, const Plan *plan, const bool *topples, uint64_t seed, uint64_t standing) {
    edit->shakes = memory_reserve(edit->shakes, &edit->shake_capacity, edit->shake_count + 1, sizeof *edit->shakes);
    EditShake *shake = &edit->shakes[edit->shake_count++];
    const char **ids = arena_allocate(&edit->shake_arena, (plan->furniture_count + 1) * sizeof *ids);
    *shake = (EditShake){.seed = seed, .standing = standing, .ids = ids};
    for (size_t i = 0; i < plan->furniture_count; i++)
        if (topples[i])
            ids[shake->count++] = arena_text(&edit->shake_arena, plan->furniture[i].id);
    return shake;
}

static void describe(Editor *edit, size_t fallen, size_t all) {
    snprintf(edit->shaken, sizeof edit->shaken, "Shake %" PRIu64 ": fallen pieces: %zu of %zu", edit->seed, fallen,
             all);
}

/* Makes one undo step from the present house to the seed's outcome for the house before the shakes. */
static bool make(Editor *edit, const Furniture *before, const bool *topples, Fault *fault) {
    const Plan *plan = draft_plan(edit->draft);
    edit_gesture_begin_step(edit, edit->shaken);
    for (size_t i = 0; i < plan->furniture_count; i++) {
        bool lies = before[i].toppled || topples[i];
        if (lies != plan->furniture[i].toppled)
            draft_set(edit->draft, plan->furniture[i].id, "toppled", json_boolean(lies));
    }
    return edit_gesture_end_step(edit, fault);
}

static bool can_anything_fall(const Plan *plan) {
    for (size_t i = 0; i < plan->furniture_count; i++)
        if (shake_can_topple(&plan->furniture[i]))
            return true;
    return false;
}

bool edit_shake_do(Editor *edit, Fault *fault) {
    Plan before = *draft_plan(edit->draft);
    const EditShake *last = edit_shake_last(edit);
    Furniture *furniture = furniture_before(&before, last);
    before.furniture = furniture;
    if (!can_anything_fall(&before)) {
        memory_free(furniture);
        fault_add(fault, "no standing piece of furniture can fall: choose the face to which a piece topples");
        return false;
    }
    uint64_t standing = last ? last->standing : draft_revision(edit->draft);
    bool *topples = memory_zeroed(before.furniture_count + 1, sizeof *topples);
    size_t count = 0;
    shake_draw(&before, ++edit->seed, topples);
    for (size_t i = 0; i < before.furniture_count; i++)
        count += topples[i];
    EditShake *shake = store(edit, &before, topples, edit->seed, standing);
    describe(edit, count, before.furniture_count);
    bool good = make(edit, furniture, topples, fault);
    shake->revision = draft_revision(edit->draft);
    edit->shake_count -= !good;
    if (good)
        edit->shook = true;
    memory_free(topples);
    memory_free(furniture);
    return good;
}

bool edit_shake_stand_up(Editor *edit, Fault *fault) {
    const EditShake *last = edit_shake_last(edit);
    if (!last || !last->count) {
        fault_add(fault, "nothing has fallen in an earthquake");
        return false;
    }
    edit_gesture_begin_step(edit, "Stand up what fell");
    for (size_t k = 0; k < last->count; k++)
        draft_set(edit->draft, last->ids[k], "toppled", json_false());
    return edit_gesture_end_step(edit, fault);
}

bool edit_shake_fix(Editor *edit, const char *id, Fault *fault) {
    const Plan *plan = draft_plan(edit->draft);
    size_t furniture;
    if (draft_find(edit->draft, id, &furniture) != DRAFT_FURNITURE) {
        fault_add(fault, "only furniture can be fixed to a wall");
        return false;
    }
    const EditShake *last = edit_shake_last(edit);
    bool *topples = memory_zeroed(plan->furniture_count + 1, sizeof *topples);
    for (size_t i = 0; last && i < plan->furniture_count; i++)
        topples[i] = i != furniture && fell(last, plan->furniture[i].id);
    EditShake *shake = last ? store(edit, plan, topples, last->seed, 0) : NULL;
    char name[EDIT_NAME], step[EDIT_NAME];
    edit_select_name(edit, id, name);
    snprintf(step, sizeof step, "Fix %.100s to the wall", name);
    edit_gesture_begin_step(edit, step);
    draft_set(edit->draft, id, "topples", json_string("no"));
    draft_set(edit->draft, id, "toppled", json_false());
    bool good = edit_gesture_end_step(edit, fault);
    if (shake && good)
        shake->revision = shake->standing = draft_revision(edit->draft);
    edit->shake_count -= shake && !good;
    memory_free(topples);
    return good;
}

void edit_shake_clear(Editor *edit) {
    memory_free(edit->shakes);
    arena_clear(&edit->shake_arena);
}
