/* Tests the runs of the House laboratory: a run equals that of the command line regardless of what is displayed, long
 * runs are displayed from their beginning, and errors are reported. */

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/file_write.h"
#include "base/text.h"
#include "check.h"
#include "running_house.h"

static const Laboratory *const laboratory = &house_laboratory;

TEST(a_run_in_the_window_is_the_one_of_the_command_line) {
    static const char *const names[] = {"ube-techno-house", "two-chairs-corridor", "corner-1.20-1.20"};
    for (size_t n = 0; n < sizeof names / sizeof *names; n++) {
        void *session = running_house_open(names[n], NULL, 0, NULL);
        CHECK(house_session_digest(session) == 0);
        for (int i = 0; i < 50; i++) { /* regardless of what is shown meanwhile */
            laboratory->update(session, 0.3 * i);
            double end = laboratory->span(session).end;
            laboratory->show(session, end * (i % 7) / 7);
            laboratory->pick(session, vec2(1, 1), end, (Item){0, 0});
            running_house_rest();
        }
        CHECK(running_house_finish(session, 1) | LABORATORY_VIEW);
        CHECK(house_session_digest(session) == running_house_digest_of(names[n], NULL, NULL, -1));
        CHECK(laboratory->answer(session).role == ROLE_TEXT);
        laboratory->close(session);
    }
}

TEST(options_of_the_opening_are_kept) {
    void *session = running_house_open("ube-techno-house", (const char *[]){"door.d7.width=0.8"}, 1, "C");
    running_house_finish(session, 0);
    CHECK(house_session_digest(session) ==
          running_house_digest_of("ube-techno-house", (const char *[]){"door.d7.width=0.8", NULL}, "C", -1));
    CHECK(running_house_set(session, "run.patience", 10));
    running_house_finish(session, 0);
    size_t count;
    const char *const *words = laboratory->command(session, &count);
    CHECK(count == 8 && strcmp(words[0], "run") == 0);
    CHECK_TEXT(words[3], "door.d7.width=0.8");
    CHECK_TEXT(words[5], "run.patience=10");
    CHECK_TEXT(words[7], "C");
    laboratory->close(session);
    CHECK(!running_house_open("ube-techno-house", NULL, 0, "Z"));
    CHECK(!running_house_open("no-such-house", NULL, 0, NULL));
    CHECK(!running_house_open("ube-techno-house", (const char *[]){"door.d77.width=0.8"}, 1, NULL));
}

TEST(routes_and_ways_of_driving_can_be_chosen) {
    void *session = running_house_open("ube-techno-house", NULL, 0, NULL);
    running_house_finish(session, 0);
    running_house_choose(session, "Driving", "miura");
    running_house_finish(session, 0);
    CHECK(house_session_digest(session) == running_house_digest_of("ube-techno-house", NULL, NULL, DRIVING_MIURA));
    running_house_choose(session, "Route", "B");
    running_house_finish(session, 0);
    CHECK(house_session_digest(session) == running_house_digest_of("ube-techno-house", NULL, "B", DRIVING_MIURA));
    running_house_choose(session, "Driving", "as in the file");
    running_house_choose(session, "Route", "all people");
    running_house_finish(session, 0);
    CHECK(house_session_digest(session) == running_house_digest_of("ube-techno-house", NULL, NULL, -1));
    laboratory->close(session);
}

/* A long run is visible from its beginning. */
TEST(what_is_recorded_can_be_seen_while_more_is_computed) {
    void *session =
        running_house_open("hall-10000", (const char *[]){"crowd.people.count=500", "run.sample=0.1"}, 2, NULL);
    double begun = running_house_clock(), end = 0;
    bool grew = false;
    while (running_house_clock() - begun < 200 && end < 3) {
        laboratory->update(session, end);
        RecordSpan span = laboratory->span(session);
        CHECK(span.end >= end && !span.complete);
        grew = grew || (end > 0 && span.end > end);
        end = span.end;
        laboratory->show(session, end);
        running_house_rest();
    }
    CHECK(grew && laboratory->moving(session)->count > 0 && house_session_digest(session) == 0);
    CHECK(strstr(laboratory->answer(session).doing, "computed") && laboratory->plot_count(session) == 7);
    running_house_close_at_once(session);
}

TEST(closing_does_not_wait) {
    for (int i = 0; i < 10; i++) {
        void *session = running_house_open(i % 2 ? "shopping-centre" : "flat-0.910-module", NULL, 0, NULL);
        for (int k = 0; k < i * i; k++) {
            laboratory->update(session, 0);
            running_house_rest();
        }
        running_house_close_at_once(session);
    }
}

/* Opens a house with these members besides its walls; the file is deleted afterwards, but the house stays open. */
static void *open_made(const char *path, const char *members) {
    Text text = {0};
    text_format(&text,
                "{\"format\": \"clearance-house\", \"version\": 1, \"walls\": [{\"id\": \"w1\", \"points\": [[0, 0], "
                "[9, 0]]}]%s}",
                members);
    CHECK(file_write_bytes(path, text.text, text.used) == 0);
    memory_free(text.text);
    char profiles[4096];
    snprintf(profiles, sizeof profiles, "%s/assets/profiles", check_source());
    Fault fault = {0};
    void *session =
        laboratory->open(path, &(LaboratoryOptions){.profiles = profiles, .driving = -1, .seed = 1, .jobs = 1}, &fault);
    CHECK(session && !fault.total);
    return session;
}

TEST(a_house_that_cannot_be_run_says_why) {
    char path[CHECK_PATH];
    check_temporary(path, "live-XXXXXX");
    close(mkstemp(path));
    void *session = open_made(path, ", \"people\": [{\"id\": \"p1\", \"profile\": \"nobody\", \"at\": [1, 1]}]");
    unsigned changed = running_house_finish(session, 0);
    double since;
    CHECK(changed & LABORATORY_ERROR && strstr(laboratory->error(session, &since), "nobody"));
    CHECK(laboratory->answer(session).role == ROLE_ERROR && house_session_digest(session) == 0);
    size_t count;
    laboratory->parameters(session, &count);
    CHECK(count == 0 && !running_house_set(session, "wall.w1.thickness", 0.2));
    CHECK(!laboratory->show(session, 0) && laboratory->plot_count(session) == 0);
    CHECK(laboratory->still(session)->count > 0); /* the plan alone */
    CHECK(laboratory->next(session, (Item){0, 0}, 1).kind == HOUSE_NOTHING);
    laboratory->close(session);
    session = open_made(path, "");
    running_house_finish(session, 0);
    CHECK_TEXT(laboratory->answer(session).title, "No exit yet");
    CHECK(!laboratory->show(session, 0) && laboratory->still(session)->count > 0 && laboratory->span(session).end == 0);
    CHECK(running_house_set(session, "wall.w1.thickness", 0.3));
    running_house_finish(session, 0);
    CHECK(!laboratory->error(session, &since));
    laboratory->close(session);
    unlink(path);
}

/* A person who does not leave, and numbers with which a run fails. */
TEST(what_went_wrong_is_told) {
    void *session = running_house_open("corner-0.78-0.78", NULL, 0, NULL);
    running_house_finish(session, 0);
    CHECK(laboratory->answer(session).role == ROLE_ERROR && strstr(laboratory->answer(session).title, "annot pass"));
    laboratory->close(session);
    session = running_house_open("corner-0.90-0.90",
                                 (const char *[]){"profile.manual-chair.contact.normal_damping=100000"}, 1, NULL);
    running_house_finish(session, 0);
    double since;
    CHECK(strstr(laboratory->error(session, &since), "the step dt"));
    laboratory->close(session);
}
