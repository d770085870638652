/* Tests random sequences of all calls of the editor: no invalid house can result, and undo restores the first bytes. */

#include <stdio.h>
#include <stdlib.h>

#include "base/text.h"
#include "check.h"
#include "editing.h"

static const Laboratory *const laboratory = &house_laboratory;

static uint64_t state;

static double any(double low, double high) {
    state = state * 6364136223846793005u + 1442695040888963407u;
    return low + (high - low) * (double)(state >> 11) / 9007199254740992.0;
}

static Pointer any_pointer(void) {
    return (Pointer){.at = {any(-1, 8), any(-2, 4)},
                     .reach = any(0.01, 0.3),
                     .free = any(0, 1) < 0.1,
                     .straight = any(0, 1) < 0.1,
                     .more = any(0, 1) < 0.1};
}

static void act_at_random(void *session) {
    static const char *const letters[] = {"1", "2", ".", "-", "5", "c", "m", "0", "x", " "};
    Fault fault = {0};
    Pointer at = any_pointer();
    size_t count;
    switch ((int)any(0, 29)) {
    case 0:
        editor_set_tool(laboratory->editor(session), (EditTool)any(0, EDIT_TOOLS));
        break;
    case 1 ... 5:
        editor_point(laboratory->editor(session), &at);
        break;
    case 6 ... 8:
        editor_press(laboratory->editor(session), &at, any(0, 1) < 0.2);
        break;
    case 9 ... 11:
        editor_release(laboratory->editor(session), &at);
        break;
    case 12 ... 13:
        editor_type(laboratory->editor(session), letters[(int)any(0, 10)]);
        break;
    case 14:
        editor_enter(laboratory->editor(session));
        break;
    case 15:
        editor_tab(laboratory->editor(session), any(0, 1) < 0.5 ? 1 : -1);
        break;
    case 16:
        editor_back(laboratory->editor(session));
        break;
    case 17:
        if (any(0, 1) < 0.3)
            editor_escape(laboratory->editor(session));
        editor_focus_handle(laboratory->editor(session), (int)any(-2, 3));
        break;
    case 18:
        editor_nudge(laboratory->editor(session), vec2(any(-0.2, 0.2), any(-0.2, 0.2)), &fault);
        break;
    case 19:
        editor_turn(laboratory->editor(session), any(-90, 90), &fault);
        editor_topple(laboratory->editor(session), &fault);
        break;
    case 20:
        if (any(0, 1) < 0.3)
            editor_remove(laboratory->editor(session), &fault);
        else
            editor_split(laboratory->editor(session), &fault);
        break;
    case 21:
        if (any(0, 1) < 0.2)
            editor_duplicate(laboratory->editor(session), &fault);
        break;
    case 22:
        editor_undo(laboratory->editor(session));
        break;
    case 23:
        editor_redo(laboratory->editor(session));
        break;
    case 24:
        editor_items(laboratory->editor(session), &count);
        if (count)
            editor_choose_item(laboratory->editor(session), (size_t)any(0, (double)count));
        if (any(0, 1) < 0.02)
            editor_select_all(laboratory->editor(session));
        break;
    case 25:
        editor_gesture(laboratory->editor(session));
        editor_selection(laboratory->editor(session), &count);
        editor_texts(laboratory->editor(session), &count);
        break;
    case 26:
        laboratory->begin_number(session, "door.d1.width");
        break;
    case 27:
        laboratory->set(session, any(0, 1) < 0.5 ? "door.d1.width" : "furniture.f1.height", any(0.3, 3), &fault);
        break;
    case 28:
        laboratory->end_number(session);
        if (any(0, 1) < 0.1)
            laboratory->reset(session);
        break;
    }
    fault_clear(&fault);
}

static void check_reads(void *session) {
    Plan plan = {0};
    Fault fault = {0};
    CHECK(plan_read_text(&plan, "edited", editor_text(laboratory->editor(session)), NULL, 0, &fault));
    for (size_t i = 0; i < fault.count; i++)
        printf("%s\n", fault.lines[i]);
    plan_free(&plan);
    fault_clear(&fault);
}

TEST(any_calls_keep_the_plan_good_and_are_undone_to_the_first_bytes) {
    const char *seed = getenv("CLEARANCE_EDIT_SEED"), *calls = getenv("CLEARANCE_EDIT_CALLS");
    state = seed ? strtoull(seed, NULL, 10) : 7;
    void *session = editing_open_text(editing_small_house);
    char *before = editing_text(session);
    for (int i = 0, most = calls ? atoi(calls) : 10000; i < most; i++) {
        act_at_random(session);
        if (i % 100 == 0)
            check_reads(session);
    }
    editor_set_tool(laboratory->editor(session), TOOL_SELECT);
    while (editor_escape(laboratory->editor(session)))
        ;
    check_reads(session);
    while (editor_redo(laboratory->editor(session)))
        ;
    char *after = editing_text(session);
    while (editor_undo(laboratory->editor(session)))
        ;
    CHECK_TEXT(editor_text(laboratory->editor(session)), before);
    while (editor_redo(laboratory->editor(session)))
        ;
    CHECK_TEXT(editor_text(laboratory->editor(session)), after);
    memory_free(before);
    memory_free(after);
    laboratory->close(session);
}
