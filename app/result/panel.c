#include "result/panel.h"

#include <math.h>
#include <string.h>

#include "base/text.h"
#include "result/headline.h"
#include "result/tight.h"

static bool has_unit(const ResultRow *row, const char *unit) {
    return row->kind == RESULT_NUMBER && !row->text && !row->significant && row->unit && strcmp(row->unit, unit) == 0;
}

/* Rounds a length so that what is needed and what is there keep their order. */
static double in_centimetres(const ResultRow *row, double length) {
    const double centimetres = 100, slack = 1e-6; /* 1/m; cm, so that whole centimetres are preserved */
    const char *key = row->key ? row->key : "";
    if (strcmp(key, "blocked_at.needs") == 0 || strcmp(key, "blocked_at.skid") == 0)
        return ceil(length * centimetres - slack) / centimetres;
    return strcmp(key, "blocked_at.has") == 0 ? floor(length * centimetres + slack) / centimetres : length;
}

/* Returns the value as other outputs have it, but times with one digit or in minutes and seconds, gaps in cm, and other
 * lengths with two digits. */
static const char *value_of(const ResultRow *row, Arena *arena) {
    const char *value = result_value_and_unit(row, arena);
    double number = row->number * (row->factor != 0 ? row->factor : 1);
    if (!value)
        return NULL;
    if (row->gap && row->text)
        return text_in_arena(arena, "over %s", tight_to_spare(row->read, arena));
    if (has_unit(row, "s"))
        return headline_duration(number, arena);
    if (has_unit(row, "m") && row->gap)
        return tight_to_spare(number, arena);
    return has_unit(row, "m") ? text_in_arena(arena, "%.2f m", in_centimetres(row, number)) : value;
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
