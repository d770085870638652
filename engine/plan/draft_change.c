#include "plan/draft_change.h"

#include "base/text.h"

static void put(Draft *draft, const DraftChange *change, json_t *before, json_t *after) {
    json_t *list = change->list < DRAFT_LISTS ? draft->lists[change->list] : NULL;
    if (!list && after)
        json_object_set(draft->head, change->member, after);
    else if (!list)
        json_object_del(draft->head, change->member);
    else if (before && after)
        json_array_set(list, change->index, after);
    else if (after)
        json_array_insert(list, change->index, after);
    else
        json_array_remove(list, change->index);
}

static void apply(Draft *draft, const DraftChange *change) {
    put(draft, change, change->before, change->after);
}

static void take_back(Draft *draft, const DraftChange *change) {
    put(draft, change, change->after, change->before);
}

void draft_change_make(Draft *draft, DraftList list, size_t index, const char *member, json_t *before, json_t *after) {
    DraftStep *step = &draft->open;
    step->changes = memory_reserve(step->changes, &step->capacity, step->count + 1, sizeof *step->changes);
    DraftChange *made = &step->changes[step->count++];
    *made = (DraftChange){list, index, member ? text_copy(member) : NULL, json_incref(before), after};
    apply(draft, made);
}

void draft_change_element(Draft *draft, DraftList list, size_t index, json_t *after) {
    draft_change_make(draft, list, index, NULL, json_array_get(draft->lists[list], index), after);
}

void draft_change_redo(Draft *draft, const DraftStep *step) {
    for (size_t i = 0; i < step->count; i++)
        apply(draft, &step->changes[i]);
}

void draft_change_undo(Draft *draft, const DraftStep *step) {
    for (size_t i = step->count; i > 0; i--)
        take_back(draft, &step->changes[i - 1]);
}

void draft_change_forget(DraftStep *step) {
    for (; step->count; step->count--) {
        DraftChange *last = &step->changes[step->count - 1];
        json_decref(last->before);
        json_decref(last->after);
        memory_free(last->member);
    }
}

void draft_change_clear(DraftStep *step) {
    draft_change_forget(step);
    memory_free(step->changes);
    memory_free(step->name);
    *step = (DraftStep){0};
}
