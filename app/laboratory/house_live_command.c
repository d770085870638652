/* The command line that makes what a window shows. */
#include "laboratory/house_live_parts.h"

enum { WORDS = 8 /* besides settings: the verb, the file, and three options with their values */ };

const char *const *house_live_command_words(HouseLive *live, size_t *count) {
    const HouseWish *wish = &live->wish;
    Arena *arena = &live->command_arena;
    arena_clear(arena);
    memory_free(live->command);
    const char **words = memory_allocate(WORDS + 2 * (wish->setting_count + live->values.count), sizeof *words);
    const char **changes = memory_allocate(live->values.count, sizeof *changes);
    size_t changed = house_live_value_settings(&live->values, changes, arena), used = 0;
    words[used++] = "run";
    words[used++] = wish->path;
    for (size_t i = 0; i < wish->setting_count + changed; i++) {
        words[used++] = "--set";
        words[used++] = i < wish->setting_count ? wish->settings[i] : changes[i - wish->setting_count];
    }
    if (wish->route) {
        words[used++] = "--route";
        words[used++] = wish->route;
    }
    if (wish->driving >= 0) {
        words[used++] = "--driving";
        words[used++] = profile_driving_name(wish->driving);
    }
    if (wish->seed != 1) {
        words[used++] = "--seed";
        words[used++] = text_in_arena(arena, "%llu", (unsigned long long)wish->seed);
    }
    memory_free(changes);
    live->command = words;
    *count = used;
    return words;
}
