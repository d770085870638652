/* Tests lessons: shipped ones, bad ones, differences of plans, numbers in texts, and goals. */

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "check.h"
#include "lesson/attempt.h"
#include "lesson/difference.h"
#include "lesson/language.h"
#include "lesson/names.h"
#include "lesson/words.h"
#include "scratch.h"

static void read_bad(const char *path, Fault *fault) {
    Lesson lesson = {.title = "untouched"};
    CHECK(!lesson_read(&lesson, path, fault));
    CHECK_TEXT(lesson.title, "untouched");
}

TEST(a_bad_lesson_gives_exactly_its_faults_and_is_left_as_it_was) {
    scratch_check_faults("tests/data/bad/lessons", read_bad);
}

TEST(every_shipped_lesson_is_read_and_asks_before_it_shows) {
    size_t count;
    char **paths = scratch_list("assets/lessons", &count);
    size_t lessons = 0;
    for (size_t i = 0; i < count; i++) {
        Lesson lesson = {.path = NULL};
        Fault fault = {0};
        if (!strstr(paths[i], ".json"))
            continue;
        lessons++;
        CHECK(lesson_read(&lesson, scratch_source(paths[i]), &fault));
        check_say(&fault);
        size_t predicts = lesson.step_count, observes = lesson.step_count;
        for (size_t s = lesson.step_count; s-- > 0;) {
            predicts = lesson.steps[s].kind == LESSON_PREDICT ? s : predicts;
            observes = lesson.steps[s].kind == LESSON_OBSERVE ? s : observes;
            CHECK(lesson.steps[s].minutes > 0); /* their sum is checked by the reader */
        }
        CHECK(predicts < observes);
        CHECK(lesson.before.count && lesson.mistakes.count);
        lesson_free(&lesson);
    }
    CHECK(lessons >= 8);
    scratch_free_list(paths, count);
}

static Plan plan_with(const char *setting) {
    Plan plan = {0};
    Fault fault = {0};
    CHECK(plan_read(&plan, scratch_source("houses/flat-0.910-module.json"), &setting, setting ? 1 : 0, &fault));
    check_say(&fault);
    return plan;
}

TEST(differences_count_what_was_changed) {
    Plan before = plan_with(NULL), wider = plan_with("door.d3.width=0.83"), narrower = plan_with("door.d3.width=0.70");
    Plan slid = plan_with("door.d3.at=0.5"), led = plan_with("person.p1.heading=90");
    CHECK_NEAR(difference_value("change.count", &before, &before), 0, 0);
    CHECK_NEAR(difference_value("change.doors_wider", &before, &wider), 0.08, 1e-12);
    CHECK_NEAR(difference_value("change.doors", &before, &wider), 1, 0);
    CHECK_NEAR(difference_value("change.not_doors", &before, &wider), 0, 0);
    CHECK_NEAR(difference_value("change.doors_wider", &before, &narrower), 0, 0);
    CHECK_NEAR(difference_value("change.not_doors", &before, &slid), 1, 0);
    CHECK_NEAR(difference_value("change.not_doors", &before, &led), 1, 0);
    CHECK_NEAR(difference_value("change.not_furniture", &before, &wider), 1, 0);
    CHECK(!difference_unit("change.nothing"));
    plan_free(&before);
    plan_free(&wider);
    plan_free(&narrower);
    plan_free(&slid);
    plan_free(&led);
}

TEST(numbers_stand_in_texts_once_they_are_known) {
    LessonNumber numbers[] = {{.name = "wide", .digits = 1, .condition = {.unit = "s"}}};
    Lesson lesson = {.numbers = numbers, .number_count = 1};
    Arena arena = {0};
    CHECK_TEXT(words_fill(&lesson, "out in {wide}.", &arena), "out in (being worked out).");
    condition_judge(&numbers[0].condition, 18.66);
    CHECK_TEXT(words_fill(&lesson, "out in {wide}.", &arena), "out in 18.7 s.");
    CHECK_TEXT(words_unknown(&lesson, "{wide} {narrow}", &arena), "narrow");
    CHECK(!words_unknown(&lesson, "a { and {wide}", &arena) || words_has_number("a { and {wide}"));
    arena_clear(&arena);
}

TEST(what_is_locked_is_found_by_the_name_of_a_setting) {
    const char *lists[] = {"walls", "people"}, *numbers[] = {"drive.frequency"};
    Lesson house = {.laboratory = LESSON_HOUSE, .lock = {lists, 2}};
    Lesson beam = {.laboratory = LESSON_BEAM, .lock = {numbers, 1}};
    CHECK_TEXT(names_locked(&house, "person.p1.heading=90"), "people");
    CHECK_TEXT(names_locked(&house, "wall.w1.thickness"), "walls");
    CHECK(!names_locked(&house, "door.d3.width=0.9") && !names_locked(&house, "run.until=1"));
    CHECK_TEXT(names_locked(&beam, "drive.frequency=100"), "drive.frequency");
    CHECK(!names_locked(&beam, "drive.force=100") && !names_locked(&beam, "drive=1"));
}

static void note_known(void *context, size_t known) {
    size_t *last = context;
    CHECK(known == *last + 1);
    *last = known;
}

/* A ratio whose two runs differ only in the order of their settings, or in one that is overridden, is exactly 1. */
TEST(numbers_come_one_by_one_and_a_later_setting_replaces_an_earlier_one) {
    LessonNumber numbers[] = {
        {.name = "a", .set = "", .than = "", .condition = {.measure_name = "door.d3.width", .unit = "m"}},
        {.name = "b",
         .set = "door.d3.width=0.9 door.d1.width=0.8 door.d3.width=0.83",
         .than = "",
         .condition = {.measure_name = "door.d3.width", .unit = "m"}},
        {.name = "c",
         .set = "door.d1.width=0.8 door.d3.width=0.9",
         .than = "door.d1.width=0.95 door.d3.width=0.83",
         .condition = {.measure_name = "door.d3.width", .unit = "1"}}};
    Lesson lesson = {.file = scratch_source("houses/flat-0.910-module.json"),
                     .set = "door.d3.width=0.7",
                     .numbers = numbers,
                     .number_count = 3};
    char profiles[4096], file[4096];
    snprintf(file, sizeof file, "%s", lesson.file);
    lesson.file = file;
    snprintf(profiles, sizeof profiles, "%s", scratch_source("assets/profiles"));
    for (size_t n = 0; n < 3; n++) {
        numbers[n].condition.low = -HUGE_VAL;
        numbers[n].condition.high = HUGE_VAL;
    }
    size_t known = 0;
    AttemptState state = {.profiles = profiles, .jobs = 1, .note = note_known, .context = &known};
    Fault fault = {0};
    CHECK(attempt_numbers(&lesson, &state, &fault));
    check_say(&fault);
    CHECK(known == 3);
    CHECK_NEAR(numbers[0].condition.value, 0.7, 0);
    CHECK_NEAR(numbers[1].condition.value, 0.83, 0);
    CHECK_NEAR(numbers[2].condition.value, 0.9 / 0.83, 1e-15);
}

TEST(a_goal_can_ask_what_a_person_has_chosen_or_selected) {
    LessonGoal goals[] = {
        {.condition = {.measure_name = "answer", .unit = "1", .low = 2, .high = 2}, .than = "", .is = ""},
        {.condition = {.measure_name = "selected", .unit = "1", .low = 1, .high = 1}, .than = "", .is = "door d3"}};
    LessonStep step = {.goals = goals, .goal_count = 2};
    Lesson lesson = {.file = "nothing is run"};
    AttemptState state = {.person = {.answer = 2}};
    Fault fault = {0};
    CHECK(attempt_goal(&lesson, &step, &state, &fault));
    CHECK(goals[0].condition.verdict == VERDICT_PASSED && goals[1].condition.verdict == VERDICT_FAILED);
    state.person = (PersonState){.answer = NAN, .selected = "door d3"};
    CHECK(attempt_goal(&lesson, &step, &state, &fault));
    CHECK(goals[0].condition.verdict == VERDICT_FAILED && goals[1].condition.verdict == VERDICT_PASSED);
    check_say(&fault);
}

static void check_language(const char *locale, const char *title, const char *option) {
    Lesson lesson = {.path = NULL};
    Fault fault = {0};
    char path[SCRATCH_PATH], text[8192];
    snprintf(text, sizeof text,
             "{'format': 'clearance-lesson', 'version': 1, 'laboratory': 'house', 'level': 'all', 'file': '%s',"
             " 'title': {'en': 'Corner', 'de': 'Ecke', 'ja': '角'}, 'script': 's', 'teacher': {'before': []},"
             " 'steps': [{'kind': 'predict', 'ask': 'Is it?', 'truth': 1,"
             "            'options': ['yes', {'ja': 'いいえ', 'en': 'no'}]}]}",
             scratch_source("houses/straight-corridor.json"));
    scratch_write(path, text);
    setenv("LC_ALL", locale, 1);
    CHECK(lesson_read(&lesson, path, &fault));
    unlink(path);
    check_say(&fault);
    CHECK_TEXT(lesson.title, title);
    CHECK_TEXT(lesson.steps[0].options.at[1], option);
    CHECK_TEXT(lesson.steps[0].ask, "Is it?");
    lesson_free(&lesson);
}

TEST(a_lesson_speaks_the_language_of_the_system_or_english) {
    check_language("ja_JP.UTF-8", "角", "いいえ");
    check_language("ja", "角", "いいえ");
    check_language("C.UTF-8", "Corner", "no");
    check_language("POSIX", "Corner", "no");
    check_language("de_DE.UTF-8", "Ecke", "no");
    check_language("jav_ID", "Corner", "no");
    setenv("LC_ALL", "", 1);
    setenv("LC_MESSAGES", "", 1);
    setenv("LANG", "de", 1);
    CHECK_TEXT(language_wanted(), "de");
    unsetenv("LANG");
    CHECK_TEXT(language_wanted(), "en");
    setenv("LC_ALL", "C.UTF-8", 1);
}

LONG_TEST(a_goal_holds_where_all_its_conditions_hold) {
    Lesson lesson = {.path = NULL};
    Fault fault = {0};
    char profiles[4096];
    snprintf(profiles, sizeof profiles, "%s", scratch_source("assets/profiles"));
    CHECK(lesson_read(&lesson, scratch_source("assets/lessons/legal-no-way.json"), &fault));
    const char *settings[] = {"door.d1.width=0.88", "door.d3.width=0.85"};
    AttemptState state = {.profiles = profiles, .jobs = 1, .settings = settings, .setting_count = 1};
    LessonStep *task = &lesson.steps[3];
    CHECK(attempt_goal(&lesson, task, &state, &fault));
    CHECK(task->goals[0].condition.verdict == VERDICT_FAILED);
    state.settings = &settings[1];
    CHECK(attempt_goal(&lesson, task, &state, &fault));
    for (size_t g = 0; g < task->goal_count; g++)
        CHECK(task->goals[g].condition.verdict == VERDICT_PASSED);
    Stop stop = {0};
    stop_request(&stop);
    state.stop = &stop;
    CHECK(!attempt_goal(&lesson, task, &state, &fault));
    CHECK(!fault.total);
    check_say(&fault);
    lesson_free(&lesson);
}
