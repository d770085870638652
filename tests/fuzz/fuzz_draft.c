/* The input is a row of edits, undos and redos of a shipped house, one after another. Undoing and redoing restore the
 * same text, and the text is a house file that is read as the same plan. */
#include <string.h>

#include "base/memory.h"
#include "fuzz.h"
#include "plan/draft.h"
#include "plan/draft_file.h"

enum { TEXTS_MOST = 300, TEXT_LARGEST = 1 << 20, NAMES_MOST = 16 };

static const char *const houses[] = {"houses/flat-0.910-module.json", "houses/ube-techno-house.json",
                                     "houses/closed-door.json", "houses/bedroom-after-earthquake.json"};

static const char *const members[NAMES_MOST] = {"id", "points",  "thickness", "centre", "size",    "heading",
                                                "at", "width",   "state",     "wall",   "segment", "from",
                                                "to", "profile", "route",     "toppled"};

static const double numbers[] = {0, 1, 2, -1, 0.5, 0.1, 0.9, 90, -45, 1e-9, 1e-3, 1e5, 1e300, 3, 0.835, 1.237, 360, 12};

typedef struct Row {
    const uint8_t *data;
    size_t size;
} Row;

static size_t take(Row *row, size_t below) {
    return fuzz_take(&row->data, &row->size) % below;
}

static double number(Row *row) {
    double value = numbers[take(row, sizeof numbers / sizeof *numbers)];
    return value + (double)take(row, 256) / 256;
}

static json_t *some_value(Row *row) {
    switch (take(row, 6)) {
    case 0:
        return NULL;
    case 1:
        return json_string(members[take(row, NAMES_MOST)]);
    case 2:
        return json_boolean(take(row, 2));
    case 3:
        return json_pack("[f,f]", number(row), number(row));
    case 4:
        return json_pack("[[f,f],[f,f]]", number(row), number(row), number(row), number(row));
    default:
        return json_real(number(row));
    }
}

/* Returns an element of the draft, or NULL; `id` (may be NULL) receives its id. */
static json_t *some_element(const Draft *draft, Row *row, char id[64]) {
    DraftList list = (DraftList)take(row, DRAFT_LISTS);
    size_t count = draft_count(draft, list);
    json_t *element = count ? draft_at(draft, list, take(row, count)) : NULL;
    const char *name = element ? json_string_value(json_object_get(element, "id")) : NULL;
    strncpy(id, name ? name : "nobody", 63);
    return element;
}

static void edit(Draft *draft, Row *row) {
    char id[64] = "", other[64] = "";
    Fault fault = {0};
    json_t *element = some_element(draft, row, id);
    switch (take(row, 8)) {
    case 0:
        draft_remove(draft, id);
        break;
    case 1:
        if (element)
            draft_add(draft, draft_find(draft, id, &(size_t){0}) % DRAFT_LISTS, json_deep_copy(element));
        break;
    case 2:
        some_element(draft, row, other);
        draft_rename(draft, id, take(row, 2) ? other : members[take(row, NAMES_MOST)], &fault);
        break;
    case 3:
        draft_set_house(draft, take(row, 2) ? "name" : "note", some_value(row));
        break;
    case 4:
        draft_set_point(draft, id, members[take(row, NAMES_MOST)], vec2(number(row), number(row)));
        break;
    case 5:
        draft_set_number(draft, id, members[take(row, NAMES_MOST)], number(row));
        break;
    default:
        draft_set(draft, id, members[take(row, NAMES_MOST)], some_value(row));
    }
    fault_clear(&fault);
}

/* The texts of the plan before the first step and after each step that can be undone or redone. */
typedef struct History {
    char *texts[TEXTS_MOST];
    size_t done, count; /* the plan is texts[done]; count of texts */
} History;

static char *copy(const char *text) {
    return strcpy(memory_zeroed(strlen(text) + 1, 1), text);
}

static void keep(History *history, const char *text) {
    while (history->count > history->done + 1)
        memory_free(history->texts[--history->count]);
    history->texts[history->count++] = copy(text);
    history->done = history->count - 1;
}

static void check_text(Draft *draft, const History *history, const char *what) {
    fuzz_expect(strcmp(draft_text(draft), history->texts[history->done]) == 0, what);
}

static void check_reading(Draft *draft) {
    Plan plan = {0};
    Fault fault = {0};
    const char *text = draft_text(draft);
    bool good = plan_read_text(&plan, "/house.json", text, NULL, 0, &fault);
    fuzz_expect_faults(good, &fault, "");
    fuzz_expect(good, "the text of a draft is a house");
    Draft *again = draft_of_plan(&plan);
    fuzz_expect(strcmp(draft_text(again), text) == 0, "a draft survives writing");
    draft_destroy(again);
}

/* Makes one step of a few edits. */
static void step(Draft *draft, History *history, Row *row) {
    Fault fault = {0};
    size_t before = draft_step_count(draft);
    draft_begin(draft, "Edit");
    for (size_t edits = 1 + take(row, 3); edits > 0; edits--)
        edit(draft, row);
    if (take(row, 4) == 0) {
        fuzz_expect_faults(draft_try(draft, &fault), &fault, "");
        draft_rewind(draft);
        edit(draft, row);
    }
    if (take(row, 8) == 0) {
        draft_cancel(draft);
        check_text(draft, history, "a cancelled step leaves the plan as it was");
        return;
    }
    bool good = draft_end(draft, &fault);
    fuzz_expect_faults(good, &fault, "");
    if (!good || draft_step_count(draft) == before)
        check_text(draft, history, "an invalid or empty step leaves the plan as it was");
    else
        keep(history, draft_text(draft));
}

static void undo(Draft *draft, History *history) {
    bool possible = draft_undo_name(draft);
    fuzz_expect(possible == (history->done > 0), "each step can be undone");
    fuzz_expect(draft_undo(draft) == possible, "a step with a name can be undone");
    history->done -= possible;
    check_text(draft, history, "undoing restores the same text");
}

static void redo(Draft *draft, History *history) {
    bool possible = draft_redo_name(draft);
    fuzz_expect(possible == (history->done + 1 < history->count), "each undone step can be redone");
    fuzz_expect(draft_redo(draft) == possible, "a step with a name can be redone");
    history->done += possible;
    check_text(draft, history, "redoing restores the same text");
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    Row row = {data, size};
    Fault fault = {0};
    const char *name = houses[take(&row, sizeof houses / sizeof *houses)];
    Draft *draft = draft_file_read(fuzz_source(name), NULL, 0, &fault);
    fuzz_expect(draft, "a shipped house is read");
    History history = {.count = 0};
    keep(&history, draft_text(draft));
    while (row.size && history.count < TEXTS_MOST) {
        size_t what = take(&row, 8);
        if (what == 0)
            undo(draft, &history);
        else if (what == 1)
            redo(draft, &history);
        else
            step(draft, &history, &row);
    }
    check_reading(draft);
    while (history.done > 0)
        undo(draft, &history);
    fuzz_expect(!draft_file_is_changed(draft), "a draft whose steps are undone is as its file");
    while (history.done + 1 < history.count)
        redo(draft, &history);
    for (size_t i = 0; i < history.count; i++)
        memory_free(history.texts[i]);
    draft_destroy(draft);
    return 0;
}
