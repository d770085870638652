/* Tests random numbers, texts, memory and threads. */

#include <math.h>
#include <stdint.h>

#include "base/fault.h"
#include "base/memory.h"
#include "base/order.h"
#include "base/parallel.h"
#include "base/random.h"
#include "base/text.h"
#include "base/visible.h"
#include "base/vec2.h"
#include "check.h"

TEST(the_same_seed_gives_the_same_numbers_and_another_stream_others) {
    Random a = random_seed(1, 2), b = random_seed(1, 2), c = random_seed(1, 3);
    int same = 0;
    for (int i = 0; i < 1000; i++) {
        uint64_t x = random_bits(&a);
        CHECK(x == random_bits(&b));
        same += x == random_bits(&c);
    }
    CHECK(same == 0);
}

TEST(uniform_and_normal_numbers_have_their_moments) {
    enum { DRAWS = 200000 };
    Random random = random_seed(7, 1);
    double sum = 0, square = 0, mean = 0, variance = 0;
    for (int i = 0; i < DRAWS; i++) {
        double u = random_uniform(&random), n = random_normal(&random, 0.69, 0.35);
        CHECK(u >= 0 && u < 1);
        sum += u;
        square += u * u;
        mean += n;
        variance += (n - 0.69) * (n - 0.69);
    }
    CHECK_NEAR(sum / DRAWS, 0.5, 0.003);
    CHECK_NEAR(square / DRAWS, 1.0 / 3, 0.003);
    CHECK_NEAR(mean / DRAWS, 0.69, 0.004);
    CHECK_NEAR(sqrt(variance / DRAWS), 0.35, 0.004);
}

TEST(numbers_have_one_rising_order_whatever_they_are) {
    const double rising[] = {-INFINITY, -1, -0.0, 0, 5e-324, 1, INFINITY, NAN};
    enum { COUNT = sizeof rising / sizeof *rising };
    for (int i = 0; i < COUNT; i++)
        for (int k = 0; k < COUNT; k++)
            CHECK(order_rising(&rising[i], &rising[k]) == (i > k) - (i < k));
}

TEST(the_nearest_word_is_what_was_meant) {
    static const char *const words[] = {"width", "wall", "kind", "state"};
    CHECK_TEXT(text_nearest("wdith", words, 4), "width");
    CHECK_TEXT(text_nearest("Kind", words, 4), "kind");
    CHECK(text_nearest("completely different", words, 4) == NULL);
}

TEST(a_fault_stays_one_line_of_plain_text) {
    Fault fault = {0};
    fault_add(&fault, "a\nb\x1b[31m%s", "\tc");
    CHECK_TEXT(fault.lines[0], "a\\u000ab\\u001b[31m\\u0009c");
    for (int i = 0; i < 2 * FAULT_MOST; i++)
        fault_add(&fault, "%d", i);
    CHECK(fault.count == FAULT_MOST);
    fault_clear(&fault);
    CHECK(fault.count == 0);
}

TEST(a_fault_stays_utf_8_whatever_it_quotes_and_wherever_that_is_cut) {
    static const char *const lines[][2] = {
        {"caf\xc3\xa9 \xe6\x97\xa5\xe6\x9c\xac \xf0\x9f\x8f\xa0",
         "caf\xc3\xa9 \xe6\x97\xa5\xe6\x9c\xac \xf0\x9f\x8f\xa0"},
        {"caf\xe9", "caf\\xe9"},
        {"\xe6\x97\xa5\xe6\x9c", "\xe6\x97\xa5\\xe6\\x9c"},
        {"\x80 \xff \xc0\xaf \xc1\xbf", "\\x80 \\xff \\xc0\\xaf \\xc1\\xbf"},
        {"\xed\xa0\x80 \xf4\x90\x80\x80", "\\xed\\xa0\\x80 \\xf4\\x90\\x80\\x80"},
        {"\xf4\x8f\xbf\xbf \xed\x9f\xbf\xe2\x82", "\xf4\x8f\xbf\xbf \xed\x9f\xbf\\xe2\\x82"},
        {"\x1b\x07\x7f\xc2\x9b\xe2\x80\xae", "\\u001b\\u0007\\u007f\\u009b\\u202e"},
    };
    Fault fault = {0};
    for (size_t i = 0; i < sizeof lines / sizeof *lines; i++) {
        fault_add(&fault, "%s", lines[i][0]);
        CHECK_TEXT(fault.lines[i], lines[i][1]);
        char *again = visible_line(fault.lines[i]);
        CHECK_TEXT(again, lines[i][1]);
        memory_free(again);
    }
    fault_clear(&fault);
}

TEST(a_long_name_is_cut_between_characters) {
    CHECK(text_fitting("caf\xc3\xa9", 9) == 5);
    CHECK(text_fitting("caf\xc3\xa9", 5) == 5);
    CHECK(text_fitting("caf\xc3\xa9", 4) == 3);
    CHECK(text_fitting("\xe6\x97\xa5\xe6\x9c\xac", 5) == 3);
    CHECK(text_fitting("\xe6\x97\xa5", 2) == 0);
    CHECK(text_fitting("", 2) == 0);
}

TEST(memory_that_grows_keeps_what_it_held_and_is_zero_beyond) {
    size_t capacity = 0;
    int *numbers = NULL;
    for (int i = 0; i < 1000; i++) {
        numbers = memory_reserve(numbers, &capacity, (size_t)i + 1, sizeof *numbers);
        CHECK(numbers[i] == 0);
        numbers[i] = i + 1;
    }
    for (int i = 0; i < 1000; i++)
        CHECK(numbers[i] == i + 1);
    memory_free(numbers);
}

static void count_up(void *context, size_t i) {
    int *counts = context;
    counts[i]++;
}

TEST(every_piece_of_work_is_done_once) {
    enum { PIECES = 1000 };
    for (int jobs = 1; jobs <= 8; jobs *= 2) {
        int counts[PIECES] = {0};
        parallel_for(jobs, PIECES, count_up, counts);
        for (int i = 0; i < PIECES; i++)
            CHECK(counts[i] == 1);
    }
}

TEST(angles_are_brought_into_one_turn) {
    for (double angle = -30; angle < 30; angle += 0.01) {
        double wrapped = vec2_wrap_angle(angle);
        CHECK(wrapped > -M_PI && wrapped <= M_PI);
        CHECK_NEAR(cos(wrapped), cos(angle), 1e-12);
        CHECK_NEAR(sin(wrapped), sin(angle), 1e-12);
    }
}
