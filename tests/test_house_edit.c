/* Editing a house at work: what is drawn by hand and what is typed are the same, every step is undone to the same
 * bytes, and what a house file may not say cannot be made. */

#include "laboratory/house_edit.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#include "check.h"
#include "house/draft.h"
#include "laboratory/house_live.h"

static const LiveKind *const kind = &house_live;
static const LiveEditor *const editor = &house_edit;

enum { LONGEST = 65536 };

#define REACH 0.05 /* m */

static void *open_live(const char *name) {
    char path[4096], profiles[4096];
    snprintf(path, sizeof path, "%s/houses/%s.json", check_source(), name ? name : "");
    snprintf(profiles, sizeof profiles, "%s/assets/profiles", check_source());
    Fault fault = {0};
    LiveOptions options = {.profiles = profiles, .driving = -1, .seed = 1, .jobs = 1};
    void *live = kind->open(name ? path : NULL, &options, &fault);
    for (size_t i = 0; i < fault.count; i++)
        printf("%s\n", fault.lines[i]);
    fault_clear(&fault);
    return live;
}

static LiveHand hand(double x, double y) {
    return (LiveHand){.at = {x, y}, .reach = REACH};
}

static void move_to(void *live, double x, double y) {
    LiveHand at = hand(x, y);
    editor->point(live, &at);
}

static void press(void *live, double x, double y) {
    LiveHand at = hand(x, y);
    editor->point(live, &at);
    editor->press(live, &at, false);
}

static void release(void *live, double x, double y) {
    LiveHand at = hand(x, y);
    editor->point(live, &at);
    editor->release(live, &at);
}

static void click(void *live, double x, double y) {
    press(live, x, y);
    release(live, x, y);
}

static void drag(void *live, double x, double y, double to_x, double to_y) {
    press(live, x, y);
    move_to(live, (x + to_x) / 2, (y + to_y) / 2);
    release(live, to_x, to_y);
}

/* Letters one by one; | is Enter, > is Tab, < is Backspace, ~ is Escape. */
static void keys(void *live, const char *text) {
    for (; *text; text++) {
        char letter[2] = {*text, 0};
        if (*text == '|')
            CHECK(editor->enter(live));
        else if (*text == '>')
            CHECK(editor->tab(live, 1));
        else if (*text == '<')
            CHECK(editor->back(live));
        else if (*text == '~')
            CHECK(editor->escape(live));
        else if (!editor->type(live, letter))
            CHECK_TEXT(letter, "a letter that is taken");
    }
}

/* Enough to tell one text from another. */
static char *keep_text(void *live) {
    char *copy = memory_allocate(strlen(editor->text(live)) + 1, 1);
    return strcpy(copy, editor->text(live));
}

static void choose(void *live, const char *group, const char *name) {
    size_t count;
    const LiveItem *items = editor->items(live, &count);
    for (size_t i = 0; i < count; i++)
        if (strcmp(items[i].name, name) == 0 && strcmp(items[i].group, group) == 0) {
            editor->choose(live, i);
            return;
        }
    CHECK_TEXT(name, "an item");
}

/* A four-room flat: 8 m by 6 m, walls that cross in the middle, doors between, somebody and a wardrobe. */
static void draw_by_hand(void *live) {
    editor->take(live, TOOL_WALL);
    click(live, 0.003, 0.004);
    click(live, 8.004, 0.02);
    click(live, 8.02, 6.004);
    click(live, 0.01, 5.99);
    click(live, 0.01, 0.01);
    click(live, 4.004, 0.01);
    click(live, 4.01, 6.01);
    click(live, 4.01, 6.01);
    drag(live, 0.01, 3.004, 8.01, 3.01);
    editor->escape(live);
    editor->take(live, TOOL_DOOR);
    click(live, 4.02, 1.5);
    click(live, 4.02, 4.503);
    click(live, 2.0, 3.02);
    click(live, 8.02, 1.5);
    editor->take(live, TOOL_EXIT);
    click(live, 8.02, 1.5);
    editor->take(live, TOOL_PERSON);
    choose(live, "", "manual-chair");
    click(live, 2.0, 4.5);
    editor->take(live, TOOL_FURNITURE);
    choose(live, "European", "wardrobe");
    click(live, 1.0, 5.5);
}

static void type_all(void *live) {
    editor->take(live, TOOL_WALL);
    keys(live, "|0>0|8>0|6>90|800cm>180|2400mm+3.6m>-90|");
    keys(live, "|4>0|6>90|~");
    keys(live, "|0>3|8|~");
    editor->take(live, TOOL_DOOR);
    keys(live, "|4>1.5|");
    keys(live, "|4>4.5|");
    keys(live, "|2>3|");
    keys(live, "|8>1.5|");
    editor->take(live, TOOL_EXIT);
    keys(live, "|8>1.1|0.8>90|");
    editor->take(live, TOOL_PERSON);
    choose(live, "", "manual-chair");
    keys(live, "|2>4.5|");
    editor->take(live, TOOL_FURNITURE);
    choose(live, "European", "wardrobe");
    keys(live, "|1>5,64|");
}

TEST(a_flat_drawn_by_hand_and_one_that_is_typed_are_the_same) {
    void *by_hand = open_live(NULL), *typed = open_live(NULL);
    draw_by_hand(by_hand);
    type_all(typed);
    CHECK_TEXT(editor->text(typed), editor->text(by_hand));
    kind->close(by_hand);
    kind->close(typed);
}

TEST(a_flat_is_undone_to_the_empty_plan_and_redone_to_the_same_bytes) {
    void *live = open_live(NULL);
    char *empty = keep_text(live);
    draw_by_hand(live);
    char *drawn = keep_text(live);
    size_t steps = editor->edits(live), undone = 0, redone = 0;
    while (editor->undo(live))
        undone++;
    CHECK_NEAR((double)undone, (double)steps, 0);
    CHECK_TEXT(editor->text(live), empty);
    CHECK(!editor->undo_name(live));
    while (editor->redo(live))
        redone++;
    CHECK_NEAR((double)redone, (double)steps, 0);
    CHECK_TEXT(editor->text(live), drawn);
    memory_free(empty);
    memory_free(drawn);
    kind->close(live);
}

/* Handles --------------------------------------------------------------------------------------------------------- */

/* A room of 4 m by 3 m with a door, an exit across it, a person on a route, a wardrobe and the room's outline. */
static const char small_house[] =
    "{\"format\": \"clearance-house\", \"version\": 1, \"walls\": [{\"id\": \"w1\", \"points\": [[0, 0], [4, 0], [4, "
    "3], [0, 3], [0, 0]]}, {\"id\": \"w2\", \"points\": [[4, 3], [7, 3]]}], \"doors\": [{\"id\": \"d1\", \"wall\": "
    "\"w1\", \"at\": 2, \"width\": 0.9, \"kind\": \"hinged\"}], \"furniture\": [{\"id\": \"f1\", \"name\": "
    "\"wardrobe\", \"centre\": [1, 2.6], \"size\": [1, 0.6], \"height\": 1.8, \"topples\": \"front\"}], \"rooms\": "
    "[{\"id\": \"r1\", \"name\": \"hall\", \"outline\": [[0.06, 0.06], [3.94, 0.06], [3.94, 2.94], [0.06, 2.94]]}], "
    "\"exits\": [{\"id\": \"e1\", \"from\": [1.5, -1], \"to\": [2.5, -1]}], \"people\": [{\"id\": \"p1\", "
    "\"profile\": \"adult\", \"at\": [3, 1.5]}], \"routes\": [{\"id\": \"A\", \"people\": [\"p1\"], \"via\": [[2, "
    "1]], \"exit\": \"e1\"}]}";

static void *open_text(const char *text) {
    char path[] = "/tmp/clearance-edit-XXXXXX";
    char profiles[4096];
    int file = mkstemp(path);
    FILE *stream = fdopen(file, "w");
    fputs(text, stream);
    fclose(stream);
    snprintf(profiles, sizeof profiles, "%s/assets/profiles", check_source());
    Fault fault = {0};
    LiveOptions options = {.profiles = profiles, .driving = -1, .seed = 1, .jobs = 1};
    void *live = kind->open(path, &options, &fault);
    for (size_t i = 0; i < fault.count; i++)
        printf("%s\n", fault.lines[i]);
    fault_clear(&fault);
    unlink(path);
    for (int i = 0; i < 2000 && !kind->span(live).complete; i++) {
        kind->update(live, 0);
        nanosleep(&(struct timespec){.tv_nsec = 2000000}, NULL);
    }
    return live;
}

typedef struct Held {
    const char *what;   /* is clicked on to select it */
    Vec2 at, from, to;  /* m: where it is selected, its handle, and where that goes */
    const char *member; /* of the text, that is there then */
} Held;

static const Held handles[] = {
    {"a wall's end", {5.5, 3}, {7, 3}, {7, 4}, "[[4, 3], [7, 4]]"},
    {"a corner of two walls", {5.5, 3}, {4, 3}, {4.5, 3}, "[[0, 0], [4, 0], [4.5, 3], [0, 3], [0, 0]]"},
    {"a piece of a wall", {5.5, 3}, {5.5, 3}, {5.5, 3.5}, "[[4, 3.5], [7, 3.5]]"},
    {"a closed wall's first point",
     {3.5, 0},
     {0, 0},
     {-0.5, -0.5},
     "[[-0.5, -0.5], [4, 0], [4, 3], [0, 3], [-0.5, -0.5]]"},
    {"a door's middle", {2, 0}, {2, 0}, {2.5, 0}, "\"at\": 2.5, \"width\": 0.9"},
    {"a door to another wall", {2, 0}, {2, 0}, {5.5, 3.02}, "\"wall\": \"w2\", \"at\": 1.5"},
    {"a door's edge", {2, 0}, {2.45, 0}, {2.6, 0}, "\"at\": 2.075, \"width\": 1.05"},
    {"a door's other edge", {2, 0}, {1.55, 0}, {1.6, 0}, "\"at\": 2.025, \"width\": 0.85"},
    {"a piece's middle", {1, 2.6}, {1, 2.6}, {2, 1.5}, "\"centre\": [2, 1.5]"},
    {"a piece's corner", {1, 2.6}, {1.5, 2.3}, {1.7, 2.2}, "\"centre\": [1.1, 2.55], \"size\": [1.2, 0.7]"},
    {"a piece's turn", {1, 2.6}, {1, 1.85}, {2, 2.6}, "\"angle\": 90"},
    {"an exit's end", {2, -1}, {2.5, -1}, {3, -1}, "\"to\": [3, -1]"},
    {"an exit's middle", {2, -1}, {2, -1}, {2, -1.5}, "\"from\": [1.5, -1.5], \"to\": [2.5, -1.5]"},
    {"a person", {3, 1.5}, {3, 1.5}, {3, 1}, "\"at\": [3, 1]"},
    {"a person's heading", {3, 1.5}, {3.9, 1.5}, {3, 2.4}, "\"heading\": 90"},
    {"a route's point", {3, 1.5}, {2, 1}, {1, 1}, "\"via\": [[1, 1]]"},
    {"a room's corner", {2.5, 2}, {3.94, 2.94}, {3.5, 2.5}, "[3.5, 2.5]"},
};

TEST(a_handle_that_is_clicked_twice_does_what_dragging_does) {
    for (size_t i = 0; i < sizeof handles / sizeof *handles; i++) {
        const Held *held = &handles[i];
        void *dragged = open_text(small_house), *clicked = open_text(small_house);
        char *before = keep_text(dragged);
        click(dragged, held->at.x, held->at.y);
        drag(dragged, held->from.x, held->from.y, held->to.x, held->to.y);
        click(clicked, held->at.x, held->at.y);
        click(clicked, held->from.x, held->from.y);
        CHECK(editor->gesture(clicked)->active);
        move_to(clicked, held->to.x, held->to.y);
        click(clicked, held->to.x, held->to.y);
        CHECK(!editor->gesture(clicked)->active);
        CHECK_TEXT(editor->text(clicked), editor->text(dragged));
        if (!strstr(editor->text(dragged), held->member)) {
            CHECK_TEXT(held->what, "as expected");
            printf("%s\n%s", editor->undo_name(dragged) ? editor->undo_name(dragged) : "nothing done",
                   editor->text(dragged));
        }
        CHECK(editor->undo(dragged) && !editor->undo(dragged));
        CHECK_TEXT(editor->text(dragged), before);
        memory_free(before);
        kind->close(dragged);
        kind->close(clicked);
    }
}

TEST(escape_leaves_exactly_what_was_before) {
    void *live = open_text(small_house);
    char *before = keep_text(live);
    for (size_t i = 0; i < sizeof handles / sizeof *handles; i++) {
        const Held *held = &handles[i];
        click(live, held->at.x, held->at.y);
        press(live, held->from.x, held->from.y);
        move_to(live, held->to.x, held->to.y);
        CHECK(editor->gesture(live)->active);
        CHECK(strcmp(editor->text(live), before) != 0);
        CHECK(editor->escape(live));
        release(live, held->to.x, held->to.y);
        CHECK_TEXT(editor->text(live), before);
        CHECK(!editor->undo_name(live));
    }
    memory_free(before);
    kind->close(live);
}
