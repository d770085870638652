/* Tests the table of options: complete, without duplicates, readable at 100 columns, exact at the limits of its
 * ranges. */

#include "options/option.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "check.h"
#include "options/help.h"

TEST(every_option_is_taken_by_a_verb_that_exists) {
    for (size_t o = 0; o < option_count; o++)
        CHECK(option_rows[o].verbs > 0 && option_rows[o].verbs < 1 << VERBS);
}

TEST(no_verb_has_two_options_of_one_name) {
    for (VerbId verb = 0; verb < VERBS; verb++) {
        const char *names[OPTIONS_MOST];
        size_t count = option_names(verb, names);
        for (size_t i = 0; i < count; i++)
            for (size_t k = 0; k < i; k++)
                CHECK(strcmp(names[i], names[k]) != 0);
    }
}

TEST(an_option_has_a_field_or_a_reader_and_only_a_flag_has_no_placeholder) {
    for (size_t o = 0; o < option_count; o++) {
        const Option *option = &option_rows[o];
        bool by_reader = option->kind == OPTION_NAME || option->kind == OPTION_READ || option->kind == OPTION_MAYBE;
        CHECK(!by_reader == (option->size > 0));
        CHECK(by_reader == (option->read != NULL));
        CHECK((option->kind == OPTION_FLAG) == (option->argument == NULL));
        CHECK(option->offset + option->size <= sizeof(Options));
        CHECK(option->group < OPTION_GROUPS && *option->help);
        CHECK(option->kind != OPTION_CHOICE || (option->words && option->size == sizeof(int)));
        CHECK(option->kind != OPTION_WHOLE || option->size == sizeof(int) || option->size == sizeof(uint64_t));
        CHECK(option->kind != OPTION_NUMBER || option->size == sizeof(double));
    }
}

/* Reads a value as the command line does; true if the option accepts the value. */
static bool takes(const Option *option, const char *value) {
    char *arguments[] = {"clearance"};
    Options options;
    options_begin(&options, 1, arguments);
    bool good = option_take(option, &options, value);
    CHECK(options_given(&options, option->name) == good);
    options_end(&options);
    return good;
}

static bool takes_number(const Option *option, double number) {
    char word[64];
    if (option->kind == OPTION_WHOLE && number >= 9.2e18)
        snprintf(word, sizeof word, "%s", number > 9.3e18 ? "9223372036854775808" : "9223372036854775807");
    else
        snprintf(word, sizeof word, option->kind == OPTION_WHOLE ? "%.0f" : "%.17g", number);
    return takes(option, word);
}

TEST(a_number_is_taken_at_both_ends_of_its_range_and_not_beyond) {
    for (size_t o = 0; o < option_count; o++) {
        const Option *option = &option_rows[o];
        if (option->kind != OPTION_WHOLE && option->kind != OPTION_NUMBER)
            continue;
        bool whole = option->kind == OPTION_WHOLE;
        CHECK(option->low < option->high);
        CHECK(takes_number(option, option->low));
        CHECK(takes_number(option, option->high));
        CHECK(!takes_number(option, whole ? option->low - 1 : nextafter(option->low, -HUGE_VAL)));
        CHECK(!takes_number(option, !whole                ? nextafter(option->high, HUGE_VAL)
                                    : option->high > 9e18 ? 9.4e18
                                                          : option->high + 1));
        CHECK(!takes(option, "") && !takes(option, "1x") && !takes(option, "nan") && !takes(option, "many"));
    }
}

TEST(a_choice_takes_its_words_in_their_order_and_no_other) {
    for (size_t o = 0; o < option_count; o++) {
        const Option *option = &option_rows[o];
        if (option->kind != OPTION_CHOICE)
            continue;
        char *arguments[] = {"clearance"};
        Options options;
        options_begin(&options, 1, arguments);
        const char *words[OPTION_WORDS];
        size_t count = option_words(option, words, &options.arena);
        CHECK(count > 1);
        for (size_t w = 0; w < count; w++) {
            CHECK(option_take(option, &options, words[w]));
            CHECK(*(int *)((char *)&options + option->offset) == (int)w);
        }
        CHECK(!option_take(option, &options, "") && !option_take(option, &options, "neither"));
        options_end(&options);
    }
}

TEST(a_flag_takes_no_value_and_a_text_takes_any_but_none) {
    for (size_t o = 0; o < option_count; o++) {
        const Option *option = &option_rows[o];
        if (option->kind == OPTION_FLAG)
            CHECK(takes(option, NULL) && !takes(option, "") && !takes(option, "1"));
        else
            CHECK(!takes(option, NULL));
        if (option->kind == OPTION_TEXT || option->kind == OPTION_FILE || option->kind == OPTION_FOLDER)
            CHECK(takes(option, "x") && !takes(option, ""));
    }
}

/* Returns the length of the longest line in characters; all printed characters are single-width. */
static size_t longest_line(const char *text) {
    size_t longest = 0, length = 0;
    for (const char *at = text; *at; at++) {
        length = *at == '\n' ? 0 : length + (((unsigned char)*at & 0xc0) != 0x80);
        longest = length > longest ? length : longest;
    }
    return longest;
}

TEST(no_line_of_help_is_longer_than_100_columns) {
    for (VerbId verb = 0; verb < VERBS; verb++) {
        Text text = {0};
        help_add_verb(&text, verb);
        CHECK(longest_line(text.text) <= HELP_COLUMNS);
        memory_free(text.text);
    }
    Text whole = {0}, all = {0};
    help_add(&whole);
    help_add_options(&all);
    CHECK(longest_line(whole.text) <= HELP_COLUMNS);
    CHECK(longest_line(all.text) <= HELP_COLUMNS);
    memory_free(whole.text);
    memory_free(all.text);
}

TEST(the_help_of_a_verb_names_each_of_its_options_once) {
    for (VerbId verb = 0; verb < VERBS; verb++) {
        Text text = {0};
        help_add_verb(&text, verb);
        const char *names[OPTIONS_MOST];
        size_t count = option_names(verb, names);
        for (size_t i = 0; i < count; i++) {
            char start[40];
            snprintf(start, sizeof start, "\n  %s", names[i]);
            size_t found = 0;
            for (const char *at = text.text; (at = strstr(at, start)); at += strlen(start))
                found += at[strlen(start)] == ' ' || at[strlen(start)] == '\n';
            CHECK_NEAR((double)found, 1, 0);
        }
        memory_free(text.text);
    }
}

TEST(words_wrap_between_words_and_keep_their_indent) {
    Text text = {0};
    help_add_wrapped(&text, "one two", 4);
    CHECK_TEXT(text.text, "one two\n");
    text.used = 0;
    help_add_wrapped(&text, "aaaaaaaaaaaaaaaaaaaa bbbbbbbbbbbbbbbbbbb c", 60);
    CHECK_TEXT(text.text,
               "aaaaaaaaaaaaaaaaaaaa bbbbbbbbbbbbbbbbbbb\n                                                   "
               "         c\n");
    memory_free(text.text);
}
