#include "laboratory/house/history.h"

/* Keeps the first epochs and appends one. */
static void replace(HouseHistory *history, size_t kept, HouseEpoch last) {
    Arena arena = {0};
    HouseEpoch *epochs = arena_allocate(&arena, (kept + 1) * sizeof *epochs);
    for (size_t i = 0; i < kept; i++) {
        epochs[i] = history->at[i];
        epochs[i].text = arena_text(&arena, epochs[i].text);
    }
    last.text = arena_text(&arena, last.text);
    epochs[kept] = last;
    arena_clear(&history->arena);
    *history = (HouseHistory){epochs, kept + 1, arena};
}

void house_history_begin(HouseHistory *history, const char *text, uint64_t revision) {
    replace(history, 0, (HouseEpoch){0, text, revision});
}

void house_history_change(HouseHistory *history, double time, const char *text, uint64_t revision) {
    if (history->at[history->count - 1].revision == revision)
        return;
    size_t kept = history->count;
    while (kept > 1 && history->at[kept - 1].time >= time)
        kept--;
    if (history->at[kept - 1].revision == revision)
        history->count = kept; /* an edit that was undone at the time at which it was made */
    else
        replace(history, kept, (HouseEpoch){time, text, revision});
}

const HouseEpoch *house_history_copy(const HouseEpoch *epochs, size_t count, Arena *arena) {
    HouseEpoch *copy = arena_allocate(arena, count * sizeof *copy);
    for (size_t i = 0; i < count; i++) {
        copy[i] = epochs[i];
        copy[i].text = arena_text(arena, epochs[i].text);
    }
    return copy;
}

bool house_history_same(const HouseEpoch *a, size_t a_count, const HouseEpoch *b, size_t b_count) {
    bool same = a_count == b_count;
    for (size_t i = 0; same && i < a_count; i++)
        same = a[i].time == b[i].time && a[i].revision == b[i].revision;
    return same;
}

void house_history_clear(HouseHistory *history) {
    arena_clear(&history->arena);
    *history = (HouseHistory){0};
}
