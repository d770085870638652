#include "result/panel.h"

#include <string.h>

#include "result/headline.h"

/* Returns the value as other outputs have it, but long times in minutes and seconds. */
static const char *value_of(const ResultRow *row, Arena *arena) {
    const char *value = result_value_and_unit(row, arena);
    bool timed = row->kind == RESULT_NUMBER && !row->text && row->unit && strcmp(row->unit, "s") == 0;
    double seconds = row->number * (row->factor != 0 ? row->factor : 1);
    return value && timed && seconds >= HEADLINE_LONG ? headline_duration(seconds, arena) : value;
}

bool result_panel_row(SceneRow *line, const ResultRow *row, Arena *arena) {
    const char *value = row->label ? value_of(row, arena) : NULL;
    *line = (SceneRow){.kind = ROW_PLAIN, .role = row->role, .cells = {row->label, value}};
    return value;
}

bool result_panel_pair(SceneRow *line, const ResultRow *before, const ResultRow *now, Arena *arena) {
    const char *first = value_of(before, arena), *second = value_of(now, arena);
    *line = (SceneRow){
        .kind = ROW_PLAIN, .role = now->role, .cells = {now->label, first ? first : "-", second ? second : "-"}};
    return now->label && (first || second);
}
