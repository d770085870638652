#include "window/messages.h"

#include <math.h>

#include "check.h"

TEST(what_is_said_is_kept_in_order_and_the_oldest_goes) {
    static Messages messages;
    CHECK(messages_count(&messages) == 0 && !messages_last(&messages));
    for (int i = 1; i <= MESSAGES_MOST + 7; i++)
        messages_add(&messages, MESSAGE_NOTE, i, "line %d", i);
    CHECK(messages_count(&messages) == MESSAGES_MOST);
    CHECK_TEXT(messages_at(&messages, 0)->text, "line 8");
    CHECK(messages_at(&messages, 0)->number == 8);
    CHECK_TEXT(messages_last(&messages)->text, "line 207");
    CHECK_NEAR(messages_last(&messages)->time, MESSAGES_MOST + 7, 0);
    messages_clear(&messages);
    CHECK(messages_count(&messages) == 0);
}

TEST(a_fault_gives_its_lines_and_the_same_is_not_said_twice) {
    static Messages messages;
    Fault fault = {0};
    fault_add(&fault, "a.json:1:1: broken");
    fault_add(&fault, "a.json:2:1: more so");
    messages_add_fault(&messages, &fault, NAN);
    CHECK(fault.count == 0 && messages_count(&messages) == 2);
    CHECK(messages_last(&messages)->kind == MESSAGE_FAULT);
    messages_add(&messages, MESSAGE_FAULT, NAN, "a.json:2:1: more so");
    CHECK(messages_count(&messages) == 2);
    messages_add(&messages, MESSAGE_NOTE, NAN, "a.json:2:1: more so");
    messages_add(&messages, MESSAGE_NOTE, 1, "a.json:2:1: more so");
    CHECK(messages_count(&messages) == 4);
    messages_add(&messages, MESSAGE_NOTE, 1, "two\nlines");
    CHECK_TEXT(messages_last(&messages)->text, "two lines");
    messages_clear(&messages);
}

TEST(faults_wait_for_one_another) {
    static Messages messages;
    size_t count;
    messages_add(&messages, MESSAGE_FAULT, NAN, "first");
    messages_add(&messages, MESSAGE_NOTE, NAN, "note");
    messages_add(&messages, MESSAGE_FAULT, NAN, "second");
    const Message *shown = messages_fault(&messages, 0, &count);
    CHECK_TEXT(shown->text, "first");
    CHECK(count == 2);
    shown = messages_fault(&messages, shown->number, &count);
    CHECK_TEXT(shown->text, "second");
    CHECK(count == 1);
    CHECK(!messages_fault(&messages, shown->number, &count) && !count);
    messages_clear(&messages);
}
