/* Tests changes of a running beam: the motion continues through them, the record before them stays, and invalid values
 * change nothing. */

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "check.h"
#include "running_beam.h"

TEST(a_change_while_it_runs_leads_into_chaos_and_the_record_before_stays) {
    const char *const settings[] = {"drive.frequency=190"};
    void *session = running_beam_open("ibs", settings, 1);
    Fault fault = {0};
    double change = 150 / 190.;
    running_beam_play(session, 0, change, 1 / 190.);
    beam_laboratory.update(session, change);
    CHECK_TEXT(beam_laboratory.answer(session).title, "Every cycle alike");
    running_beam_show_at(session, change / 2);
    uint64_t before = running_beam_digest_picture(session);
    running_beam_show_at(session, change);
    CHECK(beam_laboratory.set(session, "drive.frequency", 300, &fault));
    running_beam_play(session, change, change + 1, 1 / 100.);
    beam_laboratory.update(session, change + 1);
    CHECK_TEXT(beam_laboratory.answer(session).title, "No rhythm so far");
    size_t count;
    const TimelineMark *marks = beam_laboratory.marks(session, &count);
    CHECK(count == 1 && marks[0].kind == TIMELINE_CHANGE);
    CHECK(marks[0].time > change && marks[0].time <= change + 1 / 190. + 1e-12);
    running_beam_show_at(session, change / 2);
    CHECK(running_beam_digest_picture(session) == before);
    beam_laboratory.close(session);
}

TEST(a_change_of_what_was_goes_on_from_there) {
    void *session = running_beam_open("ibs", NULL, 0);
    Fault fault = {0};
    running_beam_show_at(session, 0.2);
    running_beam_show_at(session, 0.1);
    CHECK(beam_laboratory.set(session, "joint.clearance", 0.2e-3, &fault));
    CHECK(beam_laboratory.span(session).end < 0.1 + 1 / 300. + 1e-9);
    running_beam_show_at(session, 0.2);
    CHECK(beam_laboratory.span(session).end >= 0.2);
    beam_laboratory.close(session);
}

TEST(a_bad_value_is_a_fault_and_changes_nothing) {
    static const struct {
        const char *name;
        double value;
    } bad[] = {{"drive.frequency", 1e9}, {"drive.frequency", NAN}, {"drive.frequency", -1}, {"beam.modes", 2.5},
               {"beam.modes", 60},       {"joint.release", 2},     {"pivot.position", 5},   {"shaker.position", 1e-5},
               {"no.such", 1},           {"drive.force", HUGE_VAL}};
    void *session = running_beam_open("ibs", NULL, 0);
    running_beam_show_at(session, 0.05);
    uint64_t before = running_beam_digest_picture(session);
    size_t count, words;
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        Fault fault = {0};
        CHECK(!beam_laboratory.set(session, bad[i].name, bad[i].value, &fault));
        CHECK(fault.count >= 1);
        fault_clear(&fault);
    }
    const PanelParameter *parameters = beam_laboratory.parameters(session, &count);
    for (size_t i = 0; i < count; i++)
        CHECK_NEAR(parameters[i].value, parameters[i].initial, 0);
    beam_laboratory.command(session, &words);
    CHECK(words == 2);
    running_beam_show_at(session, 0.07);
    running_beam_show_at(session, 0.05);
    CHECK(running_beam_digest_picture(session) == before);
    beam_laboratory.marks(session, &count);
    CHECK(count == 0);
    beam_laboratory.close(session);
}

TEST(every_number_can_be_set_to_the_ends_of_its_slider) {
    void *session = running_beam_open("ibs", NULL, 0);
    size_t count;
    const PanelParameter *parameters = beam_laboratory.parameters(session, &count);
    for (size_t i = 0; i < count; i++) {
        CHECK(parameters[i].low < parameters[i].high);
        CHECK(parameters[i].low >= parameters[i].row->low || parameters[i].row->kind == PARAMETER_CHOICE);
        CHECK(parameters[i].initial >= parameters[i].low && parameters[i].initial <= parameters[i].high);
        const double values[] = {parameters[i].low, parameters[i].high, parameters[i].initial};
        for (int v = 0; v < 3; v++) {
            Fault fault = {0};
            if (!beam_laboratory.set(session, parameters[i].name, values[v], &fault))
                printf("%s = %g: %s\n", parameters[i].name, values[v], fault.lines[0]);
            fault_clear(&fault);
        }
    }
    beam_laboratory.close(session);
}

TEST(what_cannot_be_followed_ends_the_record_until_it_is_changed) {
    void *session = running_beam_open("ibs", NULL, 0);
    Fault fault = {0};
    running_beam_show_at(session, 0.1);
    uint64_t before = running_beam_digest_picture(session);
    CHECK(beam_laboratory.set(session, "drive.frequency", 1, &fault)); /* rattling through a slow cycle */
    CHECK(beam_laboratory.set(session, "joint.clearance", 1e-6, &fault));
    CHECK(beam_laboratory.set(session, "joint.damping", 0, &fault));
    CHECK(beam_laboratory.set(session, "beam.damping_ratio", 0, &fault));
    running_beam_show_at(session, 10);
    RecordSpan span = beam_laboratory.span(session);
    double time;
    size_t count;
    CHECK(span.complete && !span.endless);
    CHECK(beam_laboratory.update(session, span.end) & LABORATORY_ERROR);
    const char *trouble = beam_laboratory.error(session, &time);
    CHECK(trouble && strstr(trouble, "switches more than"));
    CHECK_NEAR(time, span.end, 0);
    CHECK_TEXT(beam_laboratory.answer(session).title, "Chatter");
    CHECK(beam_laboratory.marks(session, &count)[0].kind == TIMELINE_ERROR || count > 0);
    running_beam_show_at(session, 0.1);
    CHECK(running_beam_digest_picture(session) == before);
    running_beam_show_at(session, span.end);
    beam_laboratory.reset(session);
    CHECK(!beam_laboratory.error(session, &time));
    running_beam_show_at(session, span.end + 0.1);
    CHECK(beam_laboratory.span(session).end > span.end + 0.1);
    beam_laboratory.close(session);
}

TEST(run_again_begins_from_rest) {
    void *session = running_beam_open("ibs", NULL, 0);
    Fault fault = {0};
    running_beam_show_at(session, 0.03);
    uint64_t before = running_beam_digest_picture(session);
    running_beam_show_at(session, 0.5);
    beam_laboratory.restart(session);
    CHECK(beam_laboratory.span(session).end < 0.01);
    running_beam_show_at(session, 0.03);
    CHECK(running_beam_digest_picture(session) == before);
    CHECK(beam_laboratory.set(session, "drive.force", 100, &fault));
    running_beam_show_at(session, 0.2);
    CHECK(beam_laboratory.set(session, "drive.force", 225, &fault));
    beam_laboratory.restart(session);
    running_beam_show_at(session, 0.03);
    CHECK(running_beam_digest_picture(session) == before);
    beam_laboratory.close(session);
}

TEST(the_command_makes_what_is_shown) {
    const char *const settings[] = {"drive.frequency=245"};
    void *session = running_beam_open("ibs", settings, 1);
    Fault fault = {0};
    size_t count;
    CHECK(beam_laboratory.set(session, "joint.clearance", 0.1e-3, &fault));
    CHECK(beam_laboratory.set(session, "joint.release", 1, &fault));
    const char *const *words = beam_laboratory.command(session, &count);
    CHECK(count == 8);
    CHECK_TEXT(words[0], "run");
    CHECK_TEXT(words[3], "drive.frequency=245");
    CHECK_TEXT(words[5], "joint.clearance=0.0001");
    CHECK_TEXT(words[7], "joint.release=gap");
    beam_laboratory.apply_preset(session, 1);
    words = beam_laboratory.command(session, &count);
    CHECK(count == 4);
    CHECK_TEXT(words[3], "drive.frequency=190");
    beam_laboratory.close(session);
}
