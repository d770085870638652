#include "laboratory/edit/shake.h"

#include <inttypes.h>
#include <stdio.h>
#include <string.h>

#include "base/memory.h"
#include "house/shake.h"
#include "laboratory/edit/gesture.h"

/* Returns the shake whose outcome is the present draft, also after undoing; NULL: none. */
static const EditShake *last_shake(const Editor *edit) {
    uint64_t revision = draft_revision(edit->draft);
    for (size_t i = edit->shake_count; i-- > 0;)
        if (edit->shakes[i].revision == revision)
            return &edit->shakes[i];
    return NULL;
}

/* Returns the furniture as before that shake (furniture_count). Release it with memory_free. */
static Furniture *furniture_before(const Plan *plan, const EditShake *shake) {
    Furniture *before = memory_zeroed(plan->furniture_count + 1, sizeof *before);
    for (size_t i = 0; i < plan->furniture_count; i++) {
        before[i] = plan->furniture[i];
        for (size_t k = 0; shake && k < shake->count; k++)
            if (strcmp(shake->ids[k], before[i].id) == 0)
                before[i].toppled = false;
    }
    return before;
}

/* Stores which pieces have fallen. */
static EditShake *store(Editor *edit, const Plan *plan, const bool *topples, size_t count) {
    edit->shakes = memory_reserve(edit->shakes, &edit->shake_capacity, edit->shake_count + 1, sizeof *edit->shakes);
    EditShake *shake = &edit->shakes[edit->shake_count++];
    const char **ids = arena_allocate(&edit->shake_arena, (count + 1) * sizeof *ids);
    *shake = (EditShake){.ids = ids};
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
    Furniture *furniture = furniture_before(&before, last_shake(edit));
    before.furniture = furniture;
    if (!can_anything_fall(&before)) {
        memory_free(furniture);
        fault_add(fault, "no standing piece of furniture can fall: choose the face to which a piece topples");
        return false;
    }
    bool *topples = memory_zeroed(before.furniture_count + 1, sizeof *topples);
    size_t count = 0;
    shake_draw(&before, ++edit->seed, topples);
    for (size_t i = 0; i < before.furniture_count; i++)
        count += topples[i];
    EditShake *shake = store(edit, &before, topples, count);
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

void edit_shake_clear(Editor *edit) {
    memory_free(edit->shakes);
    arena_clear(&edit->shake_arena);
}
