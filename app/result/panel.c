#include "result/panel.h"

bool result_panel_row(SceneRow *line, const ResultRow *row, Arena *arena) {
    const char *value = row->label ? result_value_and_unit(row, arena) : NULL;
    *line = (SceneRow){.kind = ROW_PLAIN, .role = row->role, .cells = {row->label, value}};
    return value;
}

bool result_panel_pair(SceneRow *line, const ResultRow *before, const ResultRow *now, Arena *arena) {
    const char *first = result_value_and_unit(before, arena), *second = result_value_and_unit(now, arena);
    *line = (SceneRow){
        .kind = ROW_PLAIN, .role = now->role, .cells = {now->label, first ? first : "-", second ? second : "-"}};
    return now->label && (first || second);
}
