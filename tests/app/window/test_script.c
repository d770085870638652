#include "window/script.h"

#include <math.h>
#include <string.h>
#include <unistd.h>

#include "check.h"
#include "scratch.h"

static void read_bad(const char *path, Fault *fault) {
    Script script = {.path = "before", .at = 7};
    CHECK(!script_read(&script, path, fault));
    CHECK(script.at == 7 && script.count == 0);
    CHECK_TEXT(script.path, "before");
}

TEST(a_bad_script_gives_exactly_its_faults_and_leaves_its_target_as_it_was) {
    scratch_check_faults("tests/data/bad/scripts", read_bad);
}

TEST(a_script_that_is_not_there_is_a_fault) {
    Fault fault = {0};
    read_bad("nowhere.script", &fault);
    CHECK(fault.count == 1);
    CHECK_TEXT(fault.lines[0], "nowhere.script:1:1: cannot be read: No such file or directory");
    fault_clear(&fault);
}

static void read_draft(Script *script, const char *text) {
    char path[SCRATCH_PATH];
    Fault fault = {0};
    scratch_write(path, text);
    *script = (Script){.count = 0};
    CHECK(script_read(script, path, &fault));
    unlink(path);
}

TEST(commands_come_in_order_with_their_words_and_numbers) {
    Script script;
    read_draft(&script, "# a lesson\n"
                        "key Ctrl+M\r\n"
                        "\ttype ' 2.5 \\' \\\\ \\n# '   # not the quoted one\n"
                        "\n"
                        "click 10 20.5 double\n"
                        "click 1 2\n"
                        "drag 1 2 3 4\n"
                        "until answered\n"
                        "until idle 3\n"
                        "set door.d1.width 0.8\n"
                        "set door.d1.state closed\n"
                        "expect answer.title 'Out in 3 s'\n"
                        "expect time 3 1e-3\n"
                        "laboratory beam\n"
                        "quit");
    static const ScriptKind kinds[] = {SCRIPT_KEY,    SCRIPT_TYPE,       SCRIPT_CLICK, SCRIPT_CLICK, SCRIPT_DRAG,
                                       SCRIPT_UNTIL,  SCRIPT_UNTIL,      SCRIPT_SET,   SCRIPT_SET,   SCRIPT_EXPECT,
                                       SCRIPT_EXPECT, SCRIPT_LABORATORY, SCRIPT_QUIT};
    enum { KINDS = sizeof kinds / sizeof *kinds };
    const ScriptCommand *commands[KINDS];
    for (size_t i = 0; i < KINDS; i++) {
        commands[i] = script_next(&script);
        CHECK(commands[i] && commands[i]->kind == kinds[i]);
    }
    CHECK(!script_next(&script));
    CHECK(commands[0]->line == 2 && commands[12]->line == 15);
    CHECK_TEXT(commands[0]->words[0], "Ctrl+M");
    CHECK_TEXT(commands[1]->words[0], " 2.5 \" \\ \n# ");
    CHECK(commands[2]->choice == SCRIPT_DOUBLE && commands[3]->choice == SCRIPT_LEFT);
    CHECK_NEAR(commands[2]->numbers[1], 20.5, 0);
    CHECK_NEAR(commands[4]->numbers[3], 4, 0);
    CHECK(commands[5]->choice == SCRIPT_ANSWERED && commands[6]->choice == SCRIPT_IDLE);
    CHECK_NEAR(commands[5]->numbers[0], SCRIPT_PATIENCE, 0);
    CHECK_NEAR(commands[6]->numbers[0], 3, 0);
    CHECK_NEAR(commands[7]->numbers[0], 0.8, 0);
    CHECK(isnan(commands[8]->numbers[0]));
    CHECK_TEXT(commands[8]->words[1], "closed");
    CHECK_NEAR(commands[10]->numbers[0], 3, 0);
    CHECK_NEAR(commands[10]->numbers[1], 1e-3, 0);
    CHECK(commands[11]->choice == 1);
    script_free(&script);
}

/* Returns the error of an expectation on the state, "" if it holds. */
static void expect(const char *command, const char *says) {
    Script script;
    Fault fault = {0};
    read_draft(&script, command);
    json_t *state = json_pack("{s:{s:s}, s:[{s:f}], s:b, s:n, s:{s:f}}", "answer", "title", "Out in 3 s", "people",
                              "time", 12.34, "playing", 1, "trouble", "parameters", "door.d1.width", 0.8);
    bool good = script_expect(&script, script_next(&script), state, &fault);
    CHECK(good == !*says && fault.count == (size_t)!good);
    const char *told = fault.count ? strstr(fault.lines[0], ": expect: ") : NULL;
    CHECK_TEXT(told ? told + strlen(": expect: ") : "", says);
    fault_clear(&fault);
    json_decref(state);
    script_free(&script);
}

TEST(what_is_expected_is_compared_with_the_state) {
    expect("expect answer.title 'Out in 3 s'", "");
    expect("expect answer.title Out", "answer.title is \"Out in 3 s\", expected Out");
    expect("expect people.0.time 12.3 0.05", "");
    expect("expect people.0.time 12.3 0.01", "people.0.time is 12.34, expected 12.3 within 0.01");
    expect("expect people.0.time late", "people.0.time is 12.34, expected late");
    expect("expect people.1.time 1", "the state has no \"people.1.time\"");
    expect("expect people.x.time 1", "the state has no \"people.x.time\"");
    expect("expect playing true", "");
    expect("expect playing 1", "playing is true, expected 1");
    expect("expect trouble null", "");
    expect("expect parameters.door.d1.width 0.8", "");
    expect("expect answer 1", "answer is {\"title\": \"Out in 3 s\"}, expected 1");
}
