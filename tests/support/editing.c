#include "editing.h"

#include <stdio.h>
#include <stdlib.h>
#include <time.h>
#include <unistd.h>

#include "base/text.h"
#include "check.h"

static const Laboratory *const laboratory = &house_laboratory;

void *editing_open(const char *name) {
    char path[4096], profiles[4096];
    snprintf(path, sizeof path, "%s/houses/%s.json", check_source(), name ? name : "");
    snprintf(profiles, sizeof profiles, "%s/assets/profiles", check_source());
    Fault fault = {0};
    LaboratoryOptions options = {.profiles = profiles, .driving = -1, .seed = 1, .jobs = 1};
    void *session = laboratory->open(name ? path : NULL, &options, &fault);
    check_say(&fault);
    return session;
}

Pointer editing_pointer(double x, double y) {
    return (Pointer){.at = {x, y}, .reach = EDITING_REACH};
}

void editing_move(void *session, double x, double y) {
    Pointer at = editing_pointer(x, y);
    editor_point(laboratory->editor(session), &at);
}

void editing_press(void *session, double x, double y) {
    Pointer at = editing_pointer(x, y);
    editor_point(laboratory->editor(session), &at);
    editor_press(laboratory->editor(session), &at, false);
}

void editing_release(void *session, double x, double y) {
    Pointer at = editing_pointer(x, y);
    editor_point(laboratory->editor(session), &at);
    editor_release(laboratory->editor(session), &at);
}

void editing_click(void *session, double x, double y) {
    editing_press(session, x, y);
    editing_release(session, x, y);
}

void editing_drag(void *session, double x, double y, double to_x, double to_y) {
    editing_press(session, x, y);
    editing_move(session, (x + to_x) / 2, (y + to_y) / 2);
    editing_release(session, to_x, to_y);
}

/* Types characters one by one; | is Enter, > is Tab, < is Backspace, ~ is Escape. */
void editing_keys(void *session, const char *text) {
    for (; *text; text++) {
        char letter[2] = {*text, 0};
        if (*text == '|')
            CHECK(editor_enter(laboratory->editor(session)));
        else if (*text == '>')
            CHECK(editor_tab(laboratory->editor(session), 1));
        else if (*text == '<')
            CHECK(editor_back(laboratory->editor(session)));
        else if (*text == '~')
            CHECK(editor_escape(laboratory->editor(session)));
        else if (!editor_type(laboratory->editor(session), letter))
            CHECK_TEXT(letter, "a letter that is taken");
    }
}

char *editing_text(void *session) {
    return text_copy(editor_text(laboratory->editor(session)));
}

/* Checks that undo restored the stored text, and releases it. */
void editing_undo_all(void *session, char *before) {
    while (editor_undo(laboratory->editor(session)))
        ;
    CHECK_TEXT(editor_text(laboratory->editor(session)), before);
    memory_free(before);
    laboratory->close(session);
}

/* A room of 4 m by 3 m with a door, an exit across it, a person on a route, a wardrobe and the room's outline. */
const char editing_small_house[] =
    "{\"format\": \"clearance-house\", \"version\": 1, \"walls\": [{\"id\": \"w1\", \"points\": [[0, 0], [4, 0], [4, "
    "3], [0, 3], [0, 0]]}, {\"id\": \"w2\", \"points\": [[4, 3], [7, 3]]}], \"doors\": [{\"id\": \"d1\", \"wall\": "
    "\"w1\", \"at\": 2, \"width\": 0.9, \"kind\": \"hinged\"}], \"furniture\": [{\"id\": \"f1\", \"name\": "
    "\"wardrobe\", \"centre\": [1, 2.6], \"size\": [1, 0.6], \"height\": 1.8, \"topples\": \"front\"}], \"rooms\": "
    "[{\"id\": \"r1\", \"name\": \"hall\", \"outline\": [[0.06, 0.06], [3.94, 0.06], [3.94, 2.94], [0.06, 2.94]]}], "
    "\"exits\": [{\"id\": \"e1\", \"from\": [1.5, -1], \"to\": [2.5, -1]}], \"people\": [{\"id\": \"p1\", "
    "\"profile\": \"adult\", \"at\": [3, 1.5]}], \"routes\": [{\"id\": \"A\", \"people\": [\"p1\"], \"via\": [[2, "
    "1]], \"exit\": \"e1\"}]}";

void *editing_open_text(const char *text) {
    char path[CHECK_PATH];
    check_temporary(path, "edit-XXXXXX");
    char profiles[4096];
    int file = mkstemp(path);
    FILE *stream = fdopen(file, "w");
    fputs(text, stream);
    fclose(stream);
    snprintf(profiles, sizeof profiles, "%s/assets/profiles", check_source());
    Fault fault = {0};
    LaboratoryOptions options = {.profiles = profiles, .driving = -1, .seed = 1, .jobs = 1};
    void *session = laboratory->open(path, &options, &fault);
    check_say(&fault);
    unlink(path);
    while (!laboratory->span(session).complete) {
        laboratory->update(session, 0);
        nanosleep(&(struct timespec){.tv_nsec = 2000000}, NULL);
    }
    return session;
}

bool editing_set(void *session, const char *name, double value) {
    Fault fault = {0};
    bool good = laboratory->set(session, name, value, &fault);
    CHECK(good == !fault.count);
    fault_clear(&fault);
    return good;
}

bool editing_succeeds(bool good, Fault *fault) {
    check_say(fault);
    return good;
}
