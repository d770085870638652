#include "laboratory/house/rows.h"

#include <math.h>

PanelRow *house_rows_add(HouseSession *session, RowKind kind, const char *first) {
    HouseTexts *texts = &session->texts;
    texts->rows = memory_reserve(texts->rows, &texts->row_capacity, texts->row_count + 1, sizeof *texts->rows);
    PanelRow *row = &texts->rows[texts->row_count++];
    *row = (PanelRow){.row = {.kind = kind, .role = ROLE_TEXT, .cells = {first}}, .time = NAN};
    return row;
}
