/* Tests changes of a house in its session: each change gives the run of the changed house, invalid values change
 * nothing, and an edit while people move applies from there on. */

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/text.h"
#include "laboratory/edit/editor.h"
#include "check.h"
#include "running_house.h"

static const Laboratory *const laboratory = &house_laboratory;

TEST(a_parameter_makes_another_run_and_reset_the_first) {
    void *session = running_house_open("ube-techno-house", NULL, 0, NULL);
    running_house_finish(session, 0);
    uint64_t first = house_session_digest(session);
    CHECK(running_house_set(session, "door.d5.width", 0.85));
    CHECK(house_session_digest(session) == 0 && laboratory->runs(session).working);
    unsigned changed = running_house_finish(session, 3);
    CHECK((changed & (LABORATORY_VIEW | LABORATORY_TEXTS | LABORATORY_PLOTS | LABORATORY_PARAMETERS)) ==
          (LABORATORY_VIEW | LABORATORY_TEXTS | LABORATORY_PLOTS | LABORATORY_PARAMETERS));
    uint64_t second = house_session_digest(session);
    CHECK(second ==
          running_house_digest_of("ube-techno-house", (const char *[]){"door.d5.width=0.85", NULL}, NULL, -1));
    CHECK(second != first && strstr(laboratory->answer(session).detail, "before"));
    CHECK(running_house_parameter(session, "door.d5.width")->value == 0.85 &&
          running_house_parameter(session, "door.d5.width")->initial == 0.9);
    laboratory->reset(session);
    running_house_finish(session, 3);
    CHECK(house_session_digest(session) == first && running_house_parameter(session, "door.d5.width")->value == 0.9);
    laboratory->close(session);
}

/* Several dangerous points at one wall are one tight place, in the list as in the comparison. */
TEST(tight_places_are_counted_as_they_are_listed) {
    void *session = running_house_open("corner-1.20-0.80", NULL, 0, NULL);
    running_house_finish(session, 0);
    CHECK(running_house_set(session, "profile.manual-chair.body.width", 0.64));
    running_house_finish(session, 0);
    size_t count, listed = 0, compared = 0;
    const PanelRow *rows = laboratory->rows(session, &count);
    for (size_t i = 0; i < count; i++) {
        const SceneRow *row = &rows[i].row;
        listed += row->kind == ROW_DISC;
        if (strcmp(row->cells[0], "tight places") == 0) {
            compared++;
            CHECK_TEXT(row->cells[1], "1");
            CHECK_TEXT(row->cells[2], "1");
        }
    }
    CHECK(listed == 1 && compared == 1);
    laboratory->close(session);
}

TEST(a_bad_value_changes_nothing) {
    void *session = running_house_open("ube-techno-house", NULL, 0, NULL);
    running_house_finish(session, 0);
    uint64_t first = house_session_digest(session);
    CHECK(!running_house_set(session, "door.d5.width", 900));
    CHECK(!running_house_set(session, "door.d5.width", NAN));
    CHECK(!running_house_set(session, "run.reversals", 1.5));
    CHECK(!running_house_set(session, "door.d5.colour", 1));
    CHECK(house_session_digest(session) == first && running_house_parameter(session, "door.d5.width")->value == 0.9);
    laboratory->close(session);
}

TEST(a_house_that_would_be_bad_is_refused_at_once) {
    void *session = running_house_open("ube-techno-house", NULL, 0, NULL);
    double since;
    running_house_finish(session, 0);
    uint64_t first = house_session_digest(session);
    CHECK(!running_house_set(session, "door.d5.width", 9));
    size_t place;
    running_house_find_choice(session, "Route", "A", &place); /* its choice is the plan's, which is unchanged */
    CHECK(!laboratory->error(session, &since) && !(running_house_finish(session, 0) & LABORATORY_ERROR));
    CHECK(house_session_digest(session) == first && running_house_parameter(session, "door.d5.width")->value == 0.9);
    CHECK(running_house_set(session, "door.d5.width", 0.95));
    running_house_finish(session, 0);
    CHECK(house_session_digest(session) != first);
    laboratory->close(session);
}

/* Reports an error that appears only when the house is built: a step longer than the springs allow. */
TEST(a_house_that_becomes_bad_keeps_the_last_good_one) {
    void *session = running_house_open("ube-techno-house", NULL, 0, NULL);
    double since;
    running_house_finish(session, 0);
    uint64_t first = house_session_digest(session);
    CHECK(!laboratory->error(session, &since));
    CHECK(running_house_set(session, "run.dt", 0.03));
    unsigned changed = running_house_finish(session, 0);
    CHECK(changed & LABORATORY_ERROR && changed & LABORATORY_PARAMETERS);
    CHECK(laboratory->error(session, &since) && isnan(since));
    CHECK(house_session_digest(session) == first && running_house_parameter(session, "run.dt")->value == 0.001);
    CHECK(running_house_set(session, "door.d5.width", 0.95));
    running_house_finish(session, 0);
    CHECK(!laboratory->error(session, &since) && house_session_digest(session) != first);
    laboratory->close(session);
}

TEST(what_is_chosen_while_the_house_is_read_has_its_numbers_to_come_back_to) {
    void *session = running_house_open("ube-techno-house", NULL, 0, NULL);
    CHECK(!laboratory->save_run(session, 0));
    usleep(20000); /* the first run begins */
    running_house_choose(session, "Route", "B");
    running_house_finish(session, 0);
    double since;
    CHECK(running_house_set(session, "run.dt", 0.03));
    running_house_finish(session, 0);
    CHECK(laboratory->error(session, &since));
    size_t count;
    const PanelParameter *parameters = laboratory->parameters(session, &count);
    for (size_t i = 0; i < count; i++)
        CHECK(parameters[i].value == parameters[i].initial);
    CHECK(laboratory->save_run(session, 0));
    laboratory->close(session);
}

/* The part before an edit stays visible; later times show the edited house, and the answer concerns that house
 * alone. */
TEST(an_edit_on_the_way_goes_on_from_there) {
    void *session = running_house_open("ube-techno-house", NULL, 0, NULL);
    running_house_finish(session, 0);
    Vec2 early[LABORATORY_OUTLINE_MOST], late[LABORATORY_OUTLINE_MOST], again[LABORATORY_OUTLINE_MOST];
    Item person = {HOUSE_PERSON, 0};
    size_t points = laboratory->outline(session, person, 3, early);
    CHECK(points && laboratory->outline(session, person, 7, late) == points);
    running_house_choose(session, "Edits", "while it runs");
    laboratory->update(session, 5);
    CHECK(running_house_set(session, "profile.manual-chair.drive.free_speed", 0.4));
    running_house_finish(session, 5);
    CHECK(strstr(laboratory->note(session), "the plan changed at 5.0 s"));
    CHECK(strstr(laboratory->answer(session).detail, "after the change at 5.0 s"));
    CHECK(laboratory->outline(session, person, 3, again) == points &&
          memcmp(again, early, points * sizeof *again) == 0);
    CHECK(laboratory->outline(session, person, 7, again) == points && memcmp(again, late, points * sizeof *again) != 0);
    size_t count, changes = 0;
    const TimelineMark *marks = laboratory->marks(session, &count);
    for (size_t i = 0; i < count; i++)
        changes += marks[i].kind == TIMELINE_CHANGE && marks[i].time == 5;
    CHECK(changes == 1);
    uint64_t mixed = house_session_digest(session);
    laboratory->restart(session);
    running_house_finish(session, 0);
    CHECK(!strstr(laboratory->note(session), "changed"));
    CHECK(!strstr(laboratory->answer(session).detail, "change"));
    CHECK(house_session_digest(session) != mixed);
    CHECK(house_session_digest(session) ==
          running_house_digest_of("ube-techno-house",
                                  (const char *[]){"profile.manual-chair.drive.free_speed=0.4", NULL}, NULL, -1));
    laboratory->close(session);
}

/* True if all parts show the same run. */
static bool is_one_run(LaboratoryRuns runs) {
    return runs.answer && runs.answer == runs.picture && runs.answer == runs.rows && runs.answer == runs.plots;
}

/* Headline, picture, rows and plots change from one run to the other in one update, and nobody moves in between. */
TEST(an_edit_on_the_way_shows_one_run_at_any_time) {
    void *session = running_house_open("ube-techno-house", NULL, 0, NULL);
    running_house_finish(session, 0);
    laboratory->update(session, 5);
    laboratory->show(session, 5);
    LaboratoryRuns before = laboratory->runs(session);
    CHECK(is_one_run(before) && !before.working);
    CHECK(running_house_set(session, "door.d5.width", 0.97));
    unsigned changes = 0;
    double time = 5, begun = running_house_clock();
    do {
        unsigned now = laboratory->update(session, time);
        if (now & LABORATORY_RESTART)
            time = 0;
        changes |= now;
        laboratory->show(session, time);
        LaboratoryRuns runs = laboratory->runs(session);
        CHECK(is_one_run(runs));
        CHECK(!runs.working || laboratory->span(session).end <= time);
        CHECK(runs.working || !laboratory->answer(session).stale);
        size_t marks;
        laboratory->marks(session, &marks);
        CHECK(!laboratory->answer(session).stale || !marks);
        running_house_rest();
    } while ((laboratory->runs(session).working || laboratory->answer(session).doing) &&
             running_house_clock() - begun < 200);
    CHECK(changes & LABORATORY_RESTART && time == 0);
    CHECK(laboratory->runs(session).answer != before.answer && is_one_run(laboratory->runs(session)));
    CHECK(!*laboratory->note(session) || !strstr(laboratory->note(session), "changed"));
    laboratory->close(session);
}

TEST(what_is_given_up_leaves_the_plan_and_the_run_before) {
    void *session = running_house_open("ube-techno-house", NULL, 0, NULL);
    running_house_finish(session, 0);
    LaboratoryRuns before = laboratory->runs(session);
    double width = running_house_parameter(session, "door.d5.width")->value;
    CHECK(running_house_set(session, "door.d5.width", 0.97));
    CHECK(laboratory->runs(session).working);
    laboratory->stop(session);
    CHECK_NEAR(running_house_parameter(session, "door.d5.width")->value, width, 0); /* the panel shows it at once */
    running_house_finish(session, 0);
    CHECK(laboratory->runs(session).answer == before.answer);
    CHECK_NEAR(running_house_parameter(session, "door.d5.width")->value, width, 0);
    laboratory->close(session);
}

TEST(a_number_that_is_undone_before_its_run_is_shown_is_the_old_one_again) {
    void *session = running_house_open("ube-techno-house", NULL, 0, NULL);
    running_house_finish(session, 0);
    double width = running_house_parameter(session, "door.d5.width")->value;
    CHECK(running_house_set(session, "door.d5.width", 0.97));
    CHECK(editor_undo(laboratory->editor(session)));
    running_house_finish(session, 0);
    CHECK_NEAR(running_house_parameter(session, "door.d5.width")->value, width, 0);
    laboratory->close(session);
}

/* True if the displayed run changes its plan at a time, as the note says it. */
static bool is_mixed_at(void *session, const char *time) {
    Text text = {0};
    text_format(&text, "plan changed at %s s", time);
    bool mixed = strstr(laboratory->note(session), text.text);
    memory_free(text.text);
    return mixed;
}

TEST(a_reset_while_a_number_is_dragged_changes_nothing_if_nothing_was_changed_before) {
    void *session = running_house_open("ube-techno-house", NULL, 0, NULL);
    running_house_finish(session, 0);
    running_house_choose(session, "Edits", "while it runs");
    laboratory->update(session, 4);
    CHECK(running_house_set(session, "door.d5.width", 0.97));
    running_house_finish(session, 4);
    CHECK(is_mixed_at(session, "4.0"));
    laboratory->update(session, 6);
    CHECK(editor_undo(laboratory->editor(session)));
    running_house_finish(session, 6);
    CHECK(is_mixed_at(session, "6.0"));
    laboratory->reset(session); /* the draft is as in the file: the changes on the way stay */
    running_house_finish(session, 6);
    CHECK(is_mixed_at(session, "6.0"));
    uint64_t mixed = house_session_digest(session);
    double width = running_house_parameter(session, "door.d5.width")->value;
    laboratory->begin_number(session, "door.d5.width");
    CHECK(running_house_set(session, "door.d5.width", 0.96));
    laboratory->reset(session);
    running_house_finish(session, 6);
    CHECK(is_mixed_at(session, "6.0"));
    CHECK(house_session_digest(session) == mixed);
    CHECK_NEAR(running_house_parameter(session, "door.d5.width")->value, width, 0);
    laboratory->close(session);
}

/* During a drag the answers are those of plans that nobody left. */
TEST(what_a_gesture_passes_through_is_no_run_before) {
    void *session = running_house_open("ube-techno-house", NULL, 0, NULL);
    running_house_finish(session, 0);
    laboratory->begin_number(session, "door.d5.width");
    CHECK(running_house_set(session, "door.d5.width", 0.80));
    running_house_finish(session, 0);
    laboratory->clear_runs(session, 0);
    CHECK(running_house_set(session, "door.d5.width", 0.97));
    laboratory->end_number(session);
    running_house_finish(session, 0);
    CHECK(!strstr(laboratory->answer(session).detail, "before"));
    CHECK(running_house_set(session, "door.d5.width", 0.85));
    running_house_finish(session, 0);
    CHECK(strstr(laboratory->answer(session).detail, "before") != NULL);
    laboratory->close(session);
}

TEST(a_number_counts_from_the_time_at_which_it_was_put_down) {
    void *session = running_house_open("ube-techno-house", NULL, 0, NULL);
    running_house_finish(session, 0);
    running_house_choose(session, "Edits", "while it runs");
    laboratory->update(session, 4);
    laboratory->begin_number(session, "door.d5.width");
    CHECK(running_house_set(session, "door.d5.width", 0.97));
    laboratory->end_number(session);
    editor_set_tool(laboratory->editor(session), TOOL_PERSON);
    CHECK(editor_enter(laboratory->editor(session))); /* a gesture begins at once */
    laboratory->update(session, 4);
    laboratory->update(session, 7);
    CHECK(editor_escape(laboratory->editor(session)));
    running_house_finish(session, 7);
    CHECK(is_mixed_at(session, "4.0"));
    laboratory->close(session);
}

TEST(a_number_that_is_only_touched_does_not_restart_the_run) {
    void *session =
        running_house_open("hall-10000", (const char *[]){"crowd.people.count=2000", "run.sample=0.1"}, 2, NULL);
    for (double begun = running_house_clock();
         running_house_clock() - begun < 200 &&
         (laboratory->answer(session).stale || laboratory->span(session).end == 0);
         running_house_rest())
        laboratory->update(session, 0);
    CHECK(!laboratory->answer(session).stale && !laboratory->span(session).complete);
    size_t count;
    const PanelParameter *all = laboratory->parameters(session, &count);
    CHECK(count > 0);
    laboratory->begin_number(session, all[0].name);
    laboratory->end_number(session);
    CHECK(!laboratory->answer(session).stale);
    running_house_close_at_once(session);
}

TEST(the_newest_change_wins) {
    void *session = running_house_open("ube-techno-house", NULL, 0, NULL);
    running_house_finish(session, 0);
    for (int i = 0; i <= 20; i++) {
        CHECK(running_house_set(session, "door.d5.width", 0.8 + 0.01 * i));
        laboratory->update(session, 0);
        if (i % 5 == 0)
            running_house_rest();
    }
    CHECK(running_house_set(session, "door.d5.width", 0.97));
    running_house_finish(session, 0);
    CHECK(house_session_digest(session) ==
          running_house_digest_of("ube-techno-house", (const char *[]){"door.d5.width=0.97", NULL}, NULL, -1));
    laboratory->close(session);
}

/* The panel and the outline follow at once, before a run of the changed house is there. */
TEST(a_moved_piece_has_its_place_at_once) {
    void *session = running_house_open("ube-techno-house", NULL, 0, NULL);
    running_house_finish(session, 0);
    Item sofa = {0, 0};
    for (Item item = laboratory->next(session, sofa, 1); !sofa.kind; item = laboratory->next(session, item, 1))
        if (strcmp(laboratory->item_name(session, item), "sofa") == 0)
            sofa = item;
    laboratory->select(session, sofa);
    laboratory->update(session, 0);
    double before = running_house_parameter(session, "furniture.sofa.centre.x")->value;
    Vec2 old[LABORATORY_OUTLINE_MOST], now[LABORATORY_OUTLINE_MOST];
    CHECK(laboratory->outline(session, sofa, 0, old) == 4);
    Fault fault = {0};
    CHECK(editor_nudge(laboratory->editor(session), vec2(0.25, 0), &fault));
    laboratory->update(session, 0);
    CHECK(laboratory->runs(session).working);
    CHECK_NEAR(running_house_parameter(session, "furniture.sofa.centre.x")->value, before + 0.25, 1e-9);
    CHECK(laboratory->outline(session, sofa, 0, now) == 4);
    CHECK_NEAR(now[0].x, old[0].x + 0.25, 1e-9);
    fault_clear(&fault);
    running_house_finish(session, 0);
    CHECK_NEAR(running_house_parameter(session, "furniture.sofa.centre.x")->value, before + 0.25, 1e-9);
    laboratory->close(session);
}
