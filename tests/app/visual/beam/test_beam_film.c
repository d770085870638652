/* Tests films of a beam: a picture shows the motion at its time, magnified as stated, regardless of earlier
 * pictures. */

#include "beam/beam_cycle.h"
#include "draw/caption.h"
#include "visual/beam/beam_film.h"
#include "visual/beam/beam_joint.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/text.h"
#include "check.h"
#include "draw/layout.h"
#include "oscillator.h"

/* A beam after a run, and a film of some of its cycles. */
typedef struct Shown {
    Beam beam;
    Rig rig;
    Response response;
    BeamRecord record;
    BeamScale scale;
    BeamFilm *film;
} Shown;

#define RATE 15000.0 /* 1/s */

static void show(Shown *shown, const char *setting, double first, double last) {
    *shown = (Shown){.beam = oscillator_beam("ibs", setting), .rig = oscillator_beam_rig("ibs", setting)};
    beam_cycle_respond(&shown->response, &shown->rig, &shown->beam, NULL, NULL);
    beam_record_make(&shown->record, &shown->rig, &shown->response);
    beam_record_sample(&shown->record, (BeamSpan){first, last, RATE});
    shown->scale = beam_scene_scale(&shown->beam, shown->record.reach, shown->record.tip_reach);
    shown->film = beam_film_create(&shown->beam, &shown->rig, &shown->response, &shown->record, 500);
}

static void hide(Shown *shown) {
    beam_film_destroy(shown->film);
    beam_record_clear(&shown->record);
    response_clear(&shown->response);
    rig_clear(&shown->rig);
    beam_free(&shown->beam);
}

/* Returns the `nth` primitive of a kind and a fill, or NULL. */
static const Primitive *find(const Scene *scene, PrimitiveKind kind, Role fill, size_t nth) {
    for (size_t i = 0; i < scene->count; i++)
        if (scene->primitives[i].kind == kind && scene->primitives[i].fill == fill && nth-- == 0)
            return &scene->primitives[i];
    return NULL;
}

static Box box_of(const Primitive *primitive) {
    Box box = box_empty();
    for (size_t i = 0; i < primitive->count; i++)
        box = box_include(box, primitive->points[i]);
    return box;
}

TEST(the_tip_stands_where_the_motion_has_it) {
    Shown shown;
    show(&shown, "drive.frequency=300", 0, 0.02);
    for (double time = 0; time < 0.02; time += 0.00037) {
        beam_film_show(shown.film, time);
        double deflection = motion_deflection(&shown.record.motion);
        for (size_t j = 0; j < BEAM_JOINTS; j++) {
            const Primitive *ball = find(beam_film_moving(shown.film), PRIMITIVE_DISC, ROLE_WALKER, j);
            CHECK_NEAR(ball->points[0].x, shown.scale.joint[j].middle.x, 0);
            CHECK_NEAR(ball->points[0].y, shown.scale.joint[j].factor * deflection, 1e-15);
        }
    }
    hide(&shown);
}

/* Hermite's cubics match the deflections and slopes of the nodes. */
TEST(the_beam_is_drawn_through_its_nodes) {
    Rig rig = oscillator_beam_rig("ibs", NULL);
    BeamShape shape = beam_shape_create(&rig);
    Motion motion = motion_create(&rig, 0);
    double state[128];
    oscillator_start(&rig, 2, state);
    motion_set_state(&motion, state);
    beam_shape_set(&shape, &motion);
    CHECK_NEAR(shape.deflection[shape.count - 1], motion_deflection(&motion), 1e-15);
    CHECK_NEAR(shape.place[shape.count - 1], rig.modes.place[rig.modes.freedoms / 2 - 1], 0);
    const double step = 1e-7;
    for (size_t node = 0; node < rig.modes.freedoms / 2; node++) {
        double place = rig.modes.place[node];
        CHECK_NEAR(beam_shape_at(&shape, place), shape.freedoms[2 * node], 1e-12);
        double slope = (beam_shape_at(&shape, place + step) - beam_shape_at(&shape, place - step)) / (2 * step);
        CHECK_NEAR(slope, shape.freedoms[2 * node + 1], 1e-6);
    }
    motion_destroy(&motion);
    beam_shape_destroy(&shape);
    rig_clear(&rig);
}

/* Returns the faces of the upper and the lower stop in the magnifier. */
static void faces(const Shown *shown, double *upper, double *lower) {
    const Scene *moving = beam_film_moving(shown->film);
    *upper = HUGE_VAL;
    *lower = -HUGE_VAL;
    for (size_t nth = 0;; nth++) {
        const Primitive *stop = find(moving, PRIMITIVE_POLYGON, ROLE_WALL, nth);
        if (!stop)
            break;
        Box box = box_of(stop);
        if (box.high.x < shown->scale.joint[1].middle.x)
            continue;
        if (box.low.y > 0)
            *upper = box.low.y;
        else
            *lower = box.high.y;
    }
}

TEST(a_stop_is_where_the_clearance_says_or_where_the_tip_has_pressed_it) {
    Shown shown;
    show(&shown, "drive.frequency=300", 0, 0.02);
    const BeamJoint *joint = &shown.scale.joint[1];
    size_t pressed = 0, apart = 0;
    for (double time = 0; time < 0.02; time += 0.00011) {
        beam_film_show(shown.film, time);
        double deflection = motion_deflection(&shown.record.motion), upper, lower;
        faces(&shown, &upper, &lower);
        CHECK_NEAR(upper, joint->ball + joint->factor * fmax(shown.beam.clearance, deflection), 1e-12);
        CHECK_NEAR(-lower, joint->ball + joint->factor * fmax(shown.beam.clearance, -deflection), 1e-12);
        bool burst = find(beam_film_moving(shown.film), PRIMITIVE_POLYGON, ROLE_DANGER_MIDDLE, 0);
        CHECK(burst == (motion_force(&shown.record.motion) != 0));
        pressed += burst;
        apart += !burst;
    }
    CHECK(pressed > 20 && apart > 20);
    hide(&shown);
}

/* Returns the arrows of impacts in the magnifier, as long as their forces. */
TEST(an_arrow_is_as_long_as_its_force) {
    Shown shown;
    show(&shown, "drive.frequency=300", 0, 0.02);
    double first = NAN;
    for (double time = 0; time < 0.02; time += 0.00029) {
        beam_film_show(shown.film, time);
        const Primitive *arrow = find(beam_film_moving(shown.film), PRIMITIVE_POLYGON, ROLE_DANGER_MIDDLE, 3);
        if (!arrow)
            continue;
        CHECK(arrow->count == 7);
        Box box = box_of(arrow);
        double each = box_height(box) / fabs(motion_force(&shown.record.motion));
        first = isfinite(first) ? first : each;
        CHECK_NEAR(each, first, 1e-9 * first);
    }
    CHECK(isfinite(first));
    hide(&shown);
}

/* Returns the whole input of a painter as text. */
static void list_scene(Text *text, const Scene *scene) {
    char line[160];
    for (size_t i = 0; i < scene->count; i++) {
        const Primitive *primitive = &scene->primitives[i];
        snprintf(line, sizeof line, "%d %d %zu %s\n", primitive->kind, primitive->fill, primitive->count,
                 primitive->text);
        text_add(text, line);
        for (size_t p = 0; p < primitive->count; p++) {
            snprintf(line, sizeof line, "%a %a\n", primitive->points[p].x, primitive->points[p].y);
            text_add(text, line);
        }
    }
    text_add(text, scene->clock);
}

TEST(the_same_time_shows_the_same_whatever_was_shown_before) {
    Shown shown;
    show(&shown, "drive.frequency=300", 0, 0.02);
    Text first = {0}, again = {0};
    CHECK(beam_film_show(shown.film, 0.0123));
    list_scene(&first, beam_film_moving(shown.film));
    CHECK(beam_film_show(shown.film, 0.2));
    CHECK(!beam_film_show(shown.film, 0.0004));
    CHECK(beam_film_show(shown.film, 0.0123));
    list_scene(&again, beam_film_moving(shown.film));
    CHECK_TEXT(again.text, first.text);
    memory_free(first.text);
    memory_free(again.text);
    hide(&shown);
}

/* At each picture's time the lines end at the motion's state, in chaos, too. */
TEST(the_last_point_of_the_phase_plane_is_the_state) {
    Shown shown;
    show(&shown, "drive.frequency=300", 0.05, 0.07);
    const Plot *plots = beam_film_plots(shown.film);
    for (int picture = 0; picture <= 300; picture++) {
        double time = fmin(0.05 + picture / RATE, 0.07);
        beam_film_show(shown.film, time);
        size_t count = beam_film_until(shown.film, 0, 0, time);
        Vec2 phase = plot_value(&plots[0].series[0], count - 1), force = plot_value(&plots[1].series[0], count - 1);
        CHECK_NEAR(phase.x, 1000 * motion_deflection(&shown.record.motion), 1e-9);
        CHECK_NEAR(phase.y, motion_velocity(&shown.record.motion), 1e-7);
        CHECK_NEAR(force.x, 1000 * time, 1e-12);
        CHECK_NEAR(force.y, motion_force(&shown.record.motion), 1e-5);
    }
    CHECK(beam_film_until(shown.film, 0, 1, 0.05) == 1); /* 0.05 s are 15 cycles */
    CHECK(beam_film_until(shown.film, 0, 1, 0.07) == 7);
    hide(&shown);
}

/* The film shows the recorded motion: its samples equal the trace over 100 chaotic cycles. */
TEST(the_film_follows_the_run_that_the_answer_rests_on) {
    Shown shown;
    show(&shown, "drive.frequency=300", 0, 0.02);
    const Trace *trace = &shown.response.trace;
    CHECK(shown.record.cycles == 100 && trace->rows == 100 * BEAM_SAMPLES);
    for (size_t row = 0; row < trace->rows; row += 97) {
        const double *values = trace_row(trace, row);
        beam_record_seek(&shown.record, values[0]);
        CHECK_NEAR(motion_deflection(&shown.record.motion), values[1], 1e-12);
        CHECK_NEAR(motion_velocity(&shown.record.motion), values[2], 1e-7);
    }
    CHECK_NEAR(shown.record.largest, shown.response.peaks.max, 1e-6);
    beam_record_seek(&shown.record, shown.record.hardest);
    CHECK(fabs(motion_force(&shown.record.motion)) > 0.99 * shown.record.largest);
    hide(&shown);
}

/* Impacts follow one another, and the last one is labelled on its side. */
TEST(impacts_are_told_apart) {
    Shown shown;
    show(&shown, "drive.frequency=190", 0, 0.02);
    CHECK(shown.record.impact_count > 100);
    double end = 0;
    for (size_t i = 0; i < shown.record.impact_count; i++) {
        const BeamImpact *impact = &shown.record.impacts[i];
        CHECK(impact->begin >= end && impact->end > impact->begin && impact->peak > 0);
        if (isfinite(impact->end))
            CHECK(beam_record_last_impact(&shown.record, impact->end, impact->side) == impact);
        end = impact->end;
    }
    CHECK(!beam_record_last_impact(&shown.record, shown.record.impacts[0].begin, 1));
    hide(&shown);
}

TEST(factors_are_round_and_what_they_magnify_stays_in_the_picture) {
    static const char *const settings[] = {"drive.frequency=300", "joint.clearance=0",      "beam.thickness=0.05",
                                           "drive.force=1",       "joint.clearance=0.0005", "beam.length=0.3"};
    for (size_t s = 0; s < sizeof settings / sizeof *settings; s++) {
        Shown shown;
        show(&shown, settings[s], 0, 0.02);
        const Scene *still = beam_film_still(shown.film);
        for (int j = 0; j < BEAM_JOINTS; j++) {
            double factor = shown.scale.joint[j].factor;
            double digits = factor / pow(10, floor(log10(factor)));
            CHECK_NEAR(2 * digits, round(2 * digits), 1e-9);
        }
        for (double time = 0; time < 0.02; time += 0.00023) {
            beam_film_show(shown.film, time);
            for (size_t j = 0; j < BEAM_JOINTS; j++) {
                const Primitive *ball = find(beam_film_moving(shown.film), PRIMITIVE_DISC, ROLE_WALKER, j);
                CHECK(box_holds(still->box, vec2(ball->points[0].x, ball->points[0].y + ball->radius)));
                CHECK(box_holds(still->box, vec2(ball->points[0].x, ball->points[0].y - ball->radius)));
            }
        }
        hide(&shown);
    }
}

TEST(a_cycle_takes_about_one_and_a_half_seconds) {
    CHECK_NEAR(beam_film_slow(300), 500, 0);
    CHECK_NEAR(beam_film_slow(190), 200, 0);
    CHECK_NEAR(beam_film_slow(1), 2, 0);
    CHECK_NEAR(beam_film_slow(50000), 100000, 0);
}

TEST(the_answer_stands_above_the_picture) {
    Shown shown;
    show(&shown, "drive.frequency=300", 0, 0.02);
    const Scene *still = beam_film_still(shown.film);
    char title[80];
    const SectionPeaks *peaks = &shown.response.peaks;
    snprintf(title, sizeof title, "Chaotic: %.0f to %.0f N at 300 Hz", peaks->min, peaks->max);
    CHECK_TEXT(still->title, title);
    CHECK(strstr(still->name, "deflection \u00d7 40, in the loupe \u00d7 150"));
    CHECK(strstr(still->note, "500 times slower") && strstr(still->note, "identified, not published"));
    hide(&shown);
    show(&shown, "drive.force=1", 0, 0.02);
    CHECK(strstr(beam_film_still(shown.film)->title, "No contact"));
    CHECK(shown.record.impact_count == 0);
    hide(&shown);
}

static bool overlap(Box a, Box b) {
    return a.low.x < b.high.x && b.low.x < a.high.x && a.low.y < b.high.y && b.low.y < a.high.y;
}

/* The plots stand below the beam, and no text overlaps other text or the page's edge at any time. */
TEST(words_keep_apart) {
    static const Vec2 pages[] = {{1280, 720}, {1280, 800}, {1280, 2275}, {2560, 720}};
    Shown shown;
    show(&shown, "drive.frequency=300", 0, 0.02);
    for (size_t p = 0; p < sizeof pages / sizeof *pages; p++) {
        Layout still, moving = {0};
        layout_make(&still, beam_film_still(shown.film), pages[p]);
        Box page = {{0, 0}, pages[p]};
        for (int i = 0; i < BEAM_FILM_PLOTS; i++) {
            CHECK(box_height(still.panels[i]) > 250 && still.panels[i].low.y > still.plan.high.y);
            CHECK(box_holds(page, still.panels[i].low) && box_holds(page, still.panels[i].high));
        }
        for (double time = 0; time < 0.02; time += 0.0007) {
            beam_film_show(shown.film, time);
            layout_make_over(&moving, &still, beam_film_moving(shown.film));
            size_t count = still.caption_count + moving.caption_count;
            for (size_t a = 0; a < count; a++)
                for (size_t b = 0; b <= a; b++) {
                    const Caption *one =
                        a < still.caption_count ? &still.captions[a] : &moving.captions[a - still.caption_count];
                    const Caption *two =
                        b < still.caption_count ? &still.captions[b] : &moving.captions[b - still.caption_count];
                    Box box = caption_box(one);
                    CHECK(box_holds(page, box.low) && box_holds(page, box.high));
                    CHECK(a == b || !overlap(box, caption_box(two)));
                    if (a != b && overlap(box, caption_box(two)))
                        printf("\"%s\" lies on \"%s\"\n", one->text, two->text);
                }
        }
        layout_clear(&still);
        layout_clear(&moving);
    }
    hide(&shown);
}

/* Returns the part of the page that a part of the drawing covers. */
static Box on_page(const Layout *layout, Box box) {
    return box_include(box_around(layout_point(layout, box.low), 0), layout_point(layout, box.high));
}

/* In the window, from the smallest size with the largest letters to Full HD: no text lies across the edge of the loupe
 * or on the mount of a stop, and the force of a touch is told at every touch. */
TEST(texts_of_the_loupe_lie_inside_or_outside) {
    static const Vec2 pages[] = {{512, 181}, {640, 117}, {640, 225}, {976, 206}, {976, 544}, {1250, 400}};
    for (int frequency = 190; frequency <= 300; frequency += 110) {
        Shown shown;
        show(&shown, frequency == 190 ? "drive.frequency=190" : "drive.frequency=300", 0, 0.02);
        Scene scene = {.bare = true, .unscaled = true, .box = beam_scene_box(&shown.scale, true)};
        beam_scene_magnified(&scene, &shown.scale);
        beam_scene_still(&scene, &shown.beam, &shown.scale);
        const BeamJoint *joint = &shown.scale.joint[1];
        Box loupe = box_of(find(&scene, PRIMITIVE_POLYGON, ROLE_PAPER, 0));
        double ground = BEAM_JOINT_GROUND * shown.scale.length, half = 1.3 * joint->half;
        for (size_t p = 0; p < sizeof pages / sizeof *pages; p++) {
            Layout still, moving = {0};
            layout_make(&still, &scene, pages[p]);
            size_t touches = 0, told = 0, gaps = 0, magnified = 0;
            for (double time = 0; time < 0.02; time += 0.0002) {
                beam_film_show(shown.film, time);
                layout_make_over(&moving, &still, beam_film_moving(shown.film));
                touches += find(beam_film_moving(shown.film), PRIMITIVE_LABEL, ROLE_DANGER_MIDDLE, 0) != NULL;
                for (size_t i = 0; i < still.caption_count + moving.caption_count; i++) {
                    const Caption *caption =
                        i < still.caption_count ? &still.captions[i] : &moving.captions[i - still.caption_count];
                    Box box = caption_box(caption), edge = on_page(&still, loupe);
                    bool inside = box_holds(edge, box.low) && box_holds(edge, box.high),
                         good = inside || !overlap(box, edge);
                    told += caption->shape == LABEL_TAG;
                    gaps += strncmp(caption->text, "0.127", 5) == 0;
                    magnified += strstr(caption->text, "magnified") || strstr(caption->text, "loupe \u00d7");
                    for (int side = -1; side <= 1; side += 2) {
                        Vec2 foot = vec2(joint->middle.x, joint->middle.y + side * joint->ground);
                        Box mount = {{foot.x - half, fmin(foot.y, foot.y + side * ground)},
                                     {foot.x + half, fmax(foot.y, foot.y + side * ground)}};
                        good &= !overlap(box, on_page(&still, mount));
                    }
                    CHECK(good);
                    if (!good)
                        printf("%g x %g, %g s: \"%s\" lies on an edge\n", pages[p].x, pages[p].y, time, caption->text);
                }
            }
            CHECK(told == touches);
            CHECK((gaps > 0 || p == 1) && magnified > 0);
            layout_clear(&still);
            layout_clear(&moving);
        }
        scene_clear(&scene);
        hide(&shown);
    }
}
