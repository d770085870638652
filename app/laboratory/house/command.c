/* The command line that makes what a window shows. */
#include <string.h>

#include "plan/draft_file.h"
#include "laboratory/house/session_parts.h"

enum { WORDS = 8 /* besides settings: the verb, the file, and three options with their values */ };

/* Is the draft what its file has, with the numbers changed that have been changed? Not a thing added, moved by hand or
 * taken away. */
static bool is_file_with(const HouseSession *live, const char *const *settings, size_t count) {
    const char *path = draft_file_path(live->draft);
    Fault none = {0};
    Plan plan = {0};
    bool same = path && plan_read(&plan, path, settings, count, &none);
    char *text = same ? plan_text(&plan) : NULL;
    same = text && strcmp(text, draft_text(live->draft)) == 0;
    memory_free(text);
    plan_free(&plan);
    fault_clear(&none);
    return same;
}

/* The settings that make the draft of its file: those it was opened with, and what was changed since; (count). */
static const char **make_settings(HouseSession *live, size_t *count) {
    const LaboratoryOptions *given = &live->given;
    const char **settings = memory_zeroed(given->setting_count + live->values.count + 1, sizeof *settings);
    *count = given->setting_count;
    for (size_t i = 0; i < given->setting_count; i++)
        settings[i] = given->settings[i];
    *count += house_value_settings(&live->values, settings + *count, &live->command_arena);
    return settings;
}

const char *const *house_command_words(HouseSession *live, size_t *count) {
    const HouseWish *wish = &live->wish;
    Arena *arena = &live->command_arena;
    arena_clear(arena);
    memory_free(live->command);
    size_t setting_count, used = 0;
    const char **settings = make_settings(live, &setting_count);
    const char **words = memory_zeroed(WORDS + 2 * setting_count, sizeof *words);
    bool whole = is_file_with(live, NULL, 0), made = !whole && is_file_with(live, settings, setting_count);
    words[used++] = "run";
    words[used++] = whole || made ? draft_file_path(live->draft) : "";
    for (size_t i = 0; made && i < setting_count; i++) {
        words[used++] = "--set";
        words[used++] = settings[i];
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
    memory_free(settings);
    live->command = words;
    *count = used;
    return words;
}
