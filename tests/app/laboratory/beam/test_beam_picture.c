/* Tests what a running beam displays: a time looks and sounds the same whenever it is displayed, and plots keep their
 * cycles. */

#include <math.h>
#include <string.h>

#include "check.h"
#include "running_beam.h"

TEST(a_time_looks_the_same_whenever_it_is_shown) {
    enum { TIMES = 12 };
    static const size_t order[TIMES] = {7, 0, 11, 3, 3, 9, 1, 10, 2, 8, 4, 6};
    void *session = running_beam_open("ibs", NULL, 0), *other = running_beam_open("ibs", NULL, 0);
    uint64_t pictures[TIMES], phases[TIMES];
    double period = 1 / 300., end = 50 * period;
    for (size_t i = 0; i < TIMES; i++) {
        double time = end * ((double)i + 0.37) / TIMES;
        running_beam_play(session, i ? end * ((double)i - 0.63) / TIMES : 0, time, period / 9);
        pictures[i] = running_beam_digest_picture(session);
        phases[i] = running_beam_digest_plot(session, "phase", time);
    }
    beam_laboratory.reach(other, end);
    for (size_t i = 0; i < TIMES; i++) {
        double time = end * ((double)order[i] + 0.37) / TIMES;
        for (int again = 0; again < 2; again++) {
            void *shown = again ? other : session;
            running_beam_show_at(shown, time + 1e-4);
            running_beam_show_at(shown, time); /* backwards: pages of single cycles */
            CHECK(running_beam_digest_picture(shown) == pictures[order[i]]);
            CHECK(running_beam_digest_plot(shown, "phase", time) == phases[order[i]]);
        }
    }
    beam_laboratory.close(session);
    beam_laboratory.close(other);
}

TEST(the_magnification_changes_seldom) {
    void *session = running_beam_open("ibs", NULL, 0);
    double period = 1 / 300.;
    int changes = 0;
    running_beam_play(session, 0, 20 * period, period / 4);
    for (double time = 20 * period; time < 200 * period; time += period / 4) {
        running_beam_show_at(session, time);
        changes += (beam_laboratory.update(session, time) & LABORATORY_VIEW) != 0;
    }
    CHECK(changes <= 3);
    beam_laboratory.close(session);
}

TEST(plots_at_speed_hold_more_cycles) {
    void *session = running_beam_open("ibs", NULL, 0);
    double period = 1 / 300., time = 0;
    size_t force = running_beam_find_plot("force");
    for (int i = 0; i < 300; i++, time += 11.4 * period)
        running_beam_show_at(session, time);
    LaboratoryPlot plot = beam_laboratory.plot(session, force);
    CHECK(plot.plot->x.high > 1000 * 1000 * period);
    CHECK(beam_laboratory.points_until(session, force, 0, time) > 0);
    unsigned before = plot.revision;
    for (int i = 0; i < 20; i++, time += 11.4 * period)
        running_beam_show_at(session, time);
    CHECK(beam_laboratory.plot(session, force).revision - before <= 1);
    beam_laboratory.close(session);
}

/* Jumps over more than the record holds, between beams with different modes, at the very beginning of the record. */
TEST(what_is_forgotten_is_not_looked_for) {
    const char *const settings[] = {"beam.modes=1"};
    void *session = running_beam_open("ibs", settings, 1);
    Fault fault = {0};
    double time = 0;
    for (int jump = 0; jump < 6; jump++) {
        time += (jump % 2 ? 30000 : 11000) / 300.;
        running_beam_show_at(session, time);
        beam_laboratory.update(session, time);
        RecordSpan span = beam_laboratory.span(session);
        for (int i = 0; i < 8; i++)
            running_beam_show_at(session, span.begin + (span.end - span.begin) * i / 7);
        running_beam_show_at(session, span.begin);
        CHECK(beam_laboratory.set(session, "beam.modes", 1 + jump % 3, &fault));
        time = beam_laboratory.span(session).end;
    }
    beam_laboratory.close(session);
}

TEST(layers_and_camera_make_another_picture) {
    void *session = running_beam_open("ibs", NULL, 0);
    running_beam_show_at(session, 0.01);
    beam_laboratory.update(session, 0.01);
    uint64_t whole = running_beam_digest_picture(session);
    size_t count = beam_laboratory.still(session)->count;
    beam_laboratory.set_layers(session, 0);
    CHECK(beam_laboratory.update(session, 0.01) & LABORATORY_VIEW);
    CHECK(beam_laboratory.still(session)->count < count);
    beam_laboratory.set_layers(session, 7);
    CHECK(running_beam_digest_picture(session) == whole);
    beam_laboratory.set_camera(session, (Camera){.zoom = 3});
    CHECK_NEAR(beam_laboratory.still(session)->camera.zoom, 3, 0);
    beam_laboratory.close(session);
}

TEST(what_is_kept_stays_and_what_is_cleared_is_gone) {
    void *session = running_beam_open("ibs", NULL, 0);
    size_t phase = running_beam_find_plot("phase"), points = running_beam_find_plot("poincare");
    running_beam_play(session, 0, 0.05, 1e-3);
    size_t drawn = beam_laboratory.points_until(session, phase, 1, 0.05);
    CHECK(beam_laboratory.points_until(session, phase, 0, 0.05) == 0);
    CHECK(beam_laboratory.points_until(session, points, 0, 0.05) == 16);
    beam_laboratory.save_run(session, 0.05);
    CHECK(beam_laboratory.points_until(session, phase, 0, 0) == drawn);
    CHECK(beam_laboratory.plot(session, phase).plot->series[0].role == ROLE_GHOST);
    beam_laboratory.clear_runs(session, 0.05);
    CHECK(beam_laboratory.points_until(session, phase, 0, 0.05) == 0);
    CHECK(beam_laboratory.points_until(session, phase, 1, 0.05) < drawn);
    CHECK(beam_laboratory.points_until(session, points, 0, 0.05) == 1);
    running_beam_show_at(session, 0.07);
    CHECK(beam_laboratory.points_until(session, points, 0, 0.07) == 7);
    beam_laboratory.close(session);
}

TEST(the_sound_is_the_velocity_of_the_tip) {
    enum { COUNT = 200 };
    void *session = running_beam_open("ibs", NULL, 0);
    float samples[COUNT], again[COUNT];
    running_beam_show_at(session, 0.5);
    CHECK(beam_laboratory.sound(session, 0.1, 0.12, samples, COUNT));
    float least = 0, most = 0;
    for (int i = 0; i < COUNT; i++) {
        least = fminf(least, samples[i]);
        most = fmaxf(most, samples[i]);
    }
    CHECK(least >= -1 && most <= 1 && most - least > 0.5f);
    CHECK(beam_laboratory.sound(session, 0.1, 0.12, again, COUNT));
    CHECK(memcmp(samples, again, sizeof samples) == 0);
    CHECK(!beam_laboratory.sound(session, 0.49, 1, samples, COUNT));
    beam_laboratory.close(session);
}
