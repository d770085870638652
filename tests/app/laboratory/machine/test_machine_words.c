/* Tests the plain words for the motion of a machine: each has the term of the trade in brackets, and true numbers. */

#include <math.h>

#include "check.h"
#include "laboratory/beam/beam_machine.h"
#include "laboratory/crank/crank_machine.h"
#include "laboratory/machine/words.h"
#include "laboratory/shipped.h"

TEST(a_period_is_told_in_hits_and_in_the_term_of_the_trade) {
    Arena arena = {0};
    CHECK_TEXT(machine_words_periodic(&beam_machine, 1, true, &arena), "Every cycle alike");
    CHECK_TEXT(machine_words_periodic(&beam_machine, 2, true, &arena), "Two hits in turn");
    CHECK_TEXT(machine_words_periodic(&crank_machine, 3, true, &arena), "Three pushes in turn");
    CHECK_TEXT(machine_words_periodic(&beam_machine, 12, true, &arena), "12 hits in turn");
    CHECK_TEXT(machine_words_periodic(&beam_machine, 1, false, &arena), "Never touches");
    CHECK_TEXT(machine_words_repeat(&beam_machine, 1, &arena), "the same every cycle (period 1)");
    CHECK_TEXT(machine_words_repeat(&crank_machine, 2, &arena), "the same every two revolutions (period 2)");
    arena_clear(&arena);
}

TEST(a_quick_verdict_is_only_probable) {
    Arena arena = {0};
    MachineFacts facts = {.verdict = RESPONSE_CHAOTIC, .quick = true};
    CHECK_TEXT(machine_words_title(&beam_machine, &facts, &arena), "Probably chaotic");
    facts.quick = false;
    CHECK_TEXT(machine_words_title(&beam_machine, &facts, &arena), "Chaotic");
    CHECK_TEXT(machine_words_rhythm(&beam_machine, &facts, &arena), "never the same twice");
    facts = (MachineFacts){.verdict = RESPONSE_UNDETERMINED, .quick = true};
    CHECK_TEXT(machine_words_title(&beam_machine, &facts, &arena), "Undecided");
    facts = (MachineFacts){.verdict = RESPONSE_PERIODIC, .period = 2, .peaks = {.count = 20}};
    CHECK_TEXT(machine_words_title(&beam_machine, &facts, &arena), "Two hits in turn");
    CHECK_TEXT(machine_words_rhythm(&beam_machine, &facts, &arena), "the same every two cycles (period 2)");
    result_add(&facts.motion, (ResultRow){.key = "settled", .kind = RESULT_FLAG, .number = 0});
    result_end(&facts.motion);
    CHECK_TEXT(machine_words_title(&beam_machine, &facts, &arena), "Still settling");
    CHECK_TEXT(machine_words_rhythm(&beam_machine, &facts, &arena), "later the same every two cycles (period 2)");
    result_clear(&facts.motion);
    arena_clear(&arena);
}

TEST(hits_have_a_range_without_a_hyphen) {
    Arena arena = {0};
    CHECK_TEXT(machine_words_hits(&beam_machine, &(SectionPeaks){.min = 518.1, .max = 953.4, .count = 20}, &arena),
               "hardest hits 518 to 953 N");
    CHECK_TEXT(machine_words_hits(&crank_machine, &(SectionPeaks){.min = 51.1, .max = 51.2, .count = 20}, &arena),
               "hardest push 51 N");
    CHECK_TEXT(machine_words_hits(&beam_machine, &(SectionPeaks){.count = 0}, &arena), "");
    arena_clear(&arena);
}

TEST(the_drift_is_the_exponential_of_the_exponent) {
    Arena arena = {0};
    CHECK_NEAR(exp(0.95), 2.6, 0.02);
    CHECK_TEXT(machine_words_drift(&beam_machine, 0.95, &arena),
               "two almost equal starts drift 2.6 times apart each cycle (Lyapunov +0.95)");
    CHECK_TEXT(machine_words_drift(&crank_machine, 0.02, &arena),
               "two almost equal starts drift 1.02 times apart each revolution (Lyapunov +0.02)");
    CHECK_TEXT(machine_words_drift(&crank_machine, 5.3, &arena),
               "two almost equal starts drift 200 times apart each revolution (Lyapunov +5.30)");
    CHECK_TEXT(machine_words_drift(&beam_machine, -0.5, &arena),
               "two almost equal starts drift 0.607 times apart each cycle (Lyapunov \u22120.50)");
    arena_clear(&arena);
}

TEST(types_labels_and_names_are_plain_and_keep_their_terms) {
    Arena arena = {0};
    CHECK_TEXT(machine_words_type(TYPES_I), "safe (type I)");
    CHECK_TEXT(machine_words_type(TYPES_II), "steep: close tolerances (type II)");
    CHECK_TEXT(machine_words_type(TYPES_III), "do not run it here (type III)");
    ResultRow row = {.key = "lyapunov", .label = "largest exponent per cycle"};
    CHECK_TEXT(machine_words_label(&beam_machine, &row, &arena), "drift per cycle (Lyapunov exponent)");
    row = (ResultRow){.key = "frequency", .label = "drive frequency"};
    CHECK_TEXT(machine_words_label(&beam_machine, &row, &arena), "how fast it is shaken (excitation)");
    row = (ResultRow){.key = "grazes", .label = "grazing contacts"};
    CHECK_TEXT(machine_words_label(&beam_machine, &row, &arena), "grazing contacts");
    CHECK_TEXT(machine_words_value("-0.214", &arena), "\u22120.214");
    CHECK_TEXT(machine_words_value("- N", &arena), "- N");
    CHECK_TEXT(shipped_title("ibs"), "Impact beam (set B)");
    CHECK_TEXT(shipped_title("my beam"), "my beam");
    arena_clear(&arena);
}
