/* Tests the animation of falling furniture: from standing to lying in the stated time, ending with the picture of an
 * immediate fall; each shake starts from the house as it stood. */

#include "visual/house/furniture_fall.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#include "base/text.h"
#include "check.h"
#include "house/shake.h"
#include "laboratory/edit/editor.h"
#include "laboratory/house/session.h"
#include "plan/plan_geometry.h"

static const Laboratory *const kind = &house_laboratory;

static Furniture piece_to(int face) {
    return (Furniture){
        .id = "f1", .centre = {5, 5}, .size = {1, 0.4}, .angle = 30, .height = 1.8, .topples = face, .toppled = true};
}

/* The outline --------------------------------------------------------------------------------------------------- */

TEST(a_falling_piece_begins_as_it_stands_and_ends_as_it_lies) {
    for (int face = TOPPLE_FRONT; face <= TOPPLE_RIGHT; face++) {
        for (int lies = 0; lies < 2; lies++) {
            Vec2 corners[4], expected[4];
            Furniture piece = piece_to(face);
            furniture_fall_corners(&piece, lies, corners);
            piece.toppled = lies;
            plan_geometry_corners(&piece, expected);
            for (int i = 0; i < 4; i++)
                CHECK_NEAR(vec2_distance(corners[i], expected[i]), 0, 1e-12);
        }
        Furniture piece = piece_to(face);
        CHECK_NEAR(furniture_fall_height(&piece, 0), 1.8, 1e-12);
        CHECK_NEAR(furniture_fall_height(&piece, 1), face < TOPPLE_LEFT ? 0.4 : 1, 1e-12);
    }
}

static double area_of(const Furniture *piece, double share) {
    Vec2 corners[4];
    double area = 0;
    furniture_fall_corners(piece, share, corners);
    for (int i = 0; i < 4; i++)
        area += vec2_cross(corners[i], corners[(i + 1) % 4]) / 2;
    return area;
}

/* Returns the area covered after each of 60 hundredths of a second. */
TEST(it_covers_more_and_more_ever_faster_for_six_tenths_of_a_second) {
    for (int face = TOPPLE_FRONT; face <= TOPPLE_RIGHT; face++) {
        FurnitureFall fall = {.piece = piece_to(face)};
        double last = area_of(&fall.piece, 0), grown = 0;
        for (int i = 0; i < 60; i++) {
            CHECK(!furniture_fall_is_over(&fall));
            furniture_fall_move(&fall, 0.01 + 1e-12);
            double area = area_of(&fall.piece, furniture_fall_share(&fall));
            CHECK(area - last > grown - 1e-9);
            grown = area - last;
            last = area;
        }
        CHECK(furniture_fall_is_over(&fall));
        CHECK_NEAR(last, area_of(&fall.piece, 1), 1e-12);
    }
}

/* The slices of the body have its volume at any angle, and it stands on the edge that it turns about. */
TEST(a_leaning_piece_is_as_large_as_one_that_stands) {
    enum { CUTS = 2000 };
    for (int face = TOPPLE_FRONT; face <= TOPPLE_RIGHT; face++) {
        Furniture piece = piece_to(face);
        double expected = piece.height * (face < TOPPLE_LEFT ? piece.size.y : piece.size.x);
        for (double share = 0; share <= 1; share += 0.125) {
            double area = 0, high = furniture_fall_height(&piece, share), from, to;
            for (int i = 0; i < CUTS; i++) {
                furniture_fall_cut(&piece, share, high * (i + 0.5) / CUTS, &from, &to);
                CHECK(from < to && to <= piece.height * share + 1e-12);
                area += (to - from) * high / CUTS;
            }
            CHECK_NEAR(area, expected, 1e-3);
            furniture_fall_cut(&piece, share, 1e-9, &from, &to);
            CHECK(share == 1 || fabs(to) < 1e-6);
        }
    }
}

TEST(a_piece_that_is_stood_up_halfway_goes_back_from_there) {
    FurnitureFall fall = {.piece = piece_to(TOPPLE_FRONT)};
    furniture_fall_move(&fall, 0.3);
    double there = furniture_fall_share(&fall);
    fall.piece.toppled = false;
    furniture_fall_move(&fall, 0);
    CHECK_NEAR(furniture_fall_share(&fall), there, 0);
    furniture_fall_move(&fall, 0.1);
    CHECK(furniture_fall_share(&fall) < there && !furniture_fall_is_over(&fall));
    furniture_fall_move(&fall, INFINITY);
    CHECK(furniture_fall_is_over(&fall) && furniture_fall_share(&fall) == 0);
}

TEST(pieces_of_a_shake_begin_one_after_the_other_by_seed_and_id) {
    double sum = 0;
    for (int seed = 0; seed < 200; seed++) {
        double delay = furniture_fall_delay((uint64_t)seed, "f1");
        CHECK(delay >= 0 && delay <= FURNITURE_FALL_SPREAD);
        CHECK_NEAR(delay, furniture_fall_delay((uint64_t)seed, "f1"), 0);
        CHECK(fabs(delay - furniture_fall_delay((uint64_t)seed, "f2")) > 0);
        sum += delay;
    }
    CHECK_NEAR(sum / 200, FURNITURE_FALL_SPREAD / 2, 0.04);
    FurnitureFall late = {.piece = piece_to(TOPPLE_BACK), .delay = 0.25};
    furniture_fall_move(&late, 0.2);
    CHECK(furniture_fall_share(&late) == 0);
    furniture_fall_move(&late, 0.35);
    CHECK_NEAR(furniture_fall_share(&late), 0.25, 1e-12); /* 0.3 s of 0.6 */
}

/* A house --------------------------------------------------------------------------------------------------------- */

#define PIECE(id, x, y, more)                                                                                          \
    "{'id': '" id "', 'name': 'shelf', 'centre': [" x ", " y "], 'size': [0.8, 0.4], 'height': 1.5, " more "}"

static const char furnished[] =
    "{'format': 'clearance-house', 'version': 1, 'walls': [{'id': 'w1', 'points': [[0, 0], [9, 0], [9, "
    "6], [0, 6], [0, "
    "0]]}], 'doors': [{'id': 'd1', 'wall': 'w1', 'segment': 1, 'at': 3, 'width': 1}], 'furniture': "
    "[" PIECE("a", "1", "5.7", "'topples': 'front'") ", " PIECE("b", "2.5", "5.7", "'topples': 'front'") ", " PIECE(
        "c", "4", "5.7",
        "'topples': 'front'") ", " PIECE("d", "1", "0.3",
                                         "'topples': 'back'") ", " PIECE("e", "2.5", "0.3",
                                                                         "'topples': 'back', 'toppled': "
                                                                         "true") ", " PIECE("f", "4", "0.3",
                                                                                            "'topples': "
                                                                                            "'no'") "], "
                                                                                                    "'exi"
                                                                                                    "ts':"
                                                                                                    " [{'"
                                                                                                    "id':"
                                                                                                    " '"
                                                                                                    "e1',"
                                                                                                    " '"
                                                                                                    "from"
                                                                                                    "': "
                                                                                                    "[9."
                                                                                                    "5, "
                                                                                                    "2.5]"
                                                                                                    ", "
                                                                                                    "'to'"
                                                                                                    ": "
                                                                                                    "[9."
                                                                                                    "5, "
                                                                                                    "3.5]"
                                                                                                    "}], "
                                                                                                    "'peo"
                                                                                                    "ple'"
                                                                                                    ": "
                                                                                                    "[{'"
                                                                                                    "id':"
                                                                                                    " '"
                                                                                                    "p1',"
                                                                                                    " '"
                                                                                                    "prof"
                                                                                                    "ile'"
                                                                                                    ": "
                                                                                                    "'adu"
                                                                                                    "lt',"
                                                                                                    " "
                                                                                                    "'at'"
                                                                                                    ": "
                                                                                                    "[7, "
                                                                                                    "3]}]"
                                                                                                    "}";

static void *open_house(void) {
    char path[CHECK_PATH], profiles[4096], text[sizeof furnished];
    check_temporary(path, "fall-XXXXXX");
    for (size_t i = 0; i < sizeof furnished; i++)
        text[i] = furnished[i] == '\'' ? '"' : furnished[i];
    FILE *stream = fdopen(mkstemp(path), "w");
    fputs(text, stream);
    fclose(stream);
    snprintf(profiles, sizeof profiles, "%s/assets/profiles", check_source());
    Fault fault = {0};
    void *live =
        kind->open(path, &(LaboratoryOptions){.profiles = profiles, .driving = -1, .seed = 1, .jobs = 1}, &fault);
    for (size_t i = 0; i < fault.count; i++)
        printf("%s\n", fault.lines[i]);
    fault_clear(&fault);
    unlink(path);
    return live;
}

/* Waits until the answer is that of the house. */
static void settle(void *live) {
    for (int i = 0; i < 20000; i++) {
        kind->update(live, 0);
        if (kind->span(live).complete && !kind->answer(live).stale && !kind->answer(live).doing)
            break;
        nanosleep(&(struct timespec){.tv_nsec = 2000000}, NULL);
    }
    kind->update(live, 0);
    CHECK(kind->span(live).complete && !kind->answer(live).stale);
}

static void add_scene(Text *text, const Scene *scene) {
    for (size_t i = 0; i < scene->count; i++) {
        const Primitive *one = &scene->primitives[i];
        text_format(text, "%d %d %d %g %d %g", one->kind, one->fill, one->edge, one->height, one->hatched,
                    one->keep_clear);
        for (size_t k = 0; k < one->count; k++)
            text_format(text, " %.9g,%.9g", one->points[k].x, one->points[k].y);
        text_format(text, " %s\n", one->kind == PRIMITIVE_LABEL ? one->text : "");
    }
}

/* Returns the painter's input at the beginning. */
static char *picture_of(void *live) {
    Text text = {0};
    kind->show(live, 0);
    add_scene(&text, kind->still(live));
    text_add(&text, "moving\n");
    add_scene(&text, kind->moving(live));
    return text.text;
}

static void topple(void *live, Vec2 at) {
    Fault fault = {0};
    Item none = {0};
    kind->select(live, kind->pick(live, at, 0, none));
    CHECK(editor_topple(kind->editor(live), &fault));
    for (size_t i = 0; i < fault.count; i++)
        printf("%s\n", fault.lines[i]);
    fault_clear(&fault);
}

static void check_same_picture(void *live, const char *expected, bool same) {
    char *picture = picture_of(live);
    CHECK((strcmp(picture, expected) == 0) == same);
    memory_free(picture);
}

TEST(what_has_fallen_is_the_picture_that_it_is_where_nothing_moves) {
    void *moved = open_house(), *still = open_house();
    settle(moved);
    settle(still);
    char *before = picture_of(still);
    check_same_picture(moved, before, true);
    kind->animate(moved, 0);
    topple(moved, vec2(1, 5.7));
    topple(still, vec2(1, 5.7));
    settle(moved);
    settle(still);
    char *after = picture_of(still);
    CHECK(!kind->animation(still));
    CHECK_TEXT(kind->animation(moved), "");
    check_same_picture(moved, after, false);
    CHECK(!kind->is_unchanged(moved, 0) && kind->is_unchanged(still, 0));
    kind->animate(moved, 0.3);
    kind->update(moved, 0);
    check_same_picture(moved, after, false);
    kind->animate(moved, 0.31);
    CHECK(!kind->animation(moved));
    CHECK(kind->update(moved, 0) & LABORATORY_VIEW);
    check_same_picture(moved, after, true);
    CHECK(kind->is_unchanged(moved, 0));
    CHECK(editor_undo(kind->editor(moved)));
    settle(moved);
    CHECK(kind->animation(moved));
    check_same_picture(moved, before, false);
    kind->animate(moved, 1);
    kind->update(moved, 0);
    check_same_picture(moved, before, true);
    memory_free(before);
    memory_free(after);
    kind->close(moved);
    kind->close(still);
}

/* The fall starts at once, before the new run is complete; a piece deleted during its fall is gone. */
TEST(a_piece_that_is_removed_while_it_falls_is_gone) {
    void *live = open_house();
    Fault fault = {0};
    settle(live);
    kind->animate(live, 0);
    topple(live, vec2(1, 5.7));
    kind->update(live, 0);
    CHECK(kind->animation(live));
    kind->animate(live, 0.2);
    CHECK(editor_remove(kind->editor(live), &fault));
    kind->update(live, 0);
    CHECK(!kind->animation(live));
    settle(live);
    char *gone = picture_of(live);
    CHECK(editor_undo(kind->editor(live)) && editor_undo(kind->editor(live)));
    settle(live);
    kind->animate(live, 1);
    CHECK(editor_redo(kind->editor(live)) && editor_redo(kind->editor(live)));
    settle(live);
    check_same_picture(live, gone, true);
    memory_free(gone);
    kind->close(live);
}

static unsigned any_below(unsigned limit) {
    static uint64_t state = 5;
    state = state * 6364136223846793005u + 1442695040888963407u;
    return (unsigned)(state >> 40) % limit;
}

/* An action that starts or ends an animation. */
static void act_at_random(void *live, unsigned action, double y) {
    static const double places[] = {1, 2.5, 4};
    Fault fault = {0};
    kind->select(live, kind->pick(live, vec2(places[action % 3], y), 0, (Item){0}));
    switch (action / 3) {
    case 0:
        editor_topple(kind->editor(live), &fault);
        break;
    case 1:
        editor_shake(kind->editor(live), &fault);
        break;
    case 2:
        editor_undo(kind->editor(live));
        break;
    case 3:
        editor_redo(kind->editor(live));
        break;
    case 4:
        editor_nudge(kind->editor(live), vec2(0.01, 0), &fault);
        break;
    default:
        editor_remove(kind->editor(live), &fault);
        editor_undo(kind->editor(live));
    }
    fault_clear(&fault);
}

TEST(whatever_is_done_in_whatever_haste_it_rests_as_where_nothing_moves) {
    void *moved = open_house(), *still = open_house();
    settle(moved);
    settle(still);
    kind->animate(moved, 0);
    for (int i = 0; i < 20; i++) {
        for (int k = 0; k < 6; k++) {
            unsigned action = any_below(18);
            double y = any_below(2) ? 5.7 : 0.3;
            act_at_random(moved, action, y);
            act_at_random(still, action, y);
            for (unsigned n = any_below(4); n-- > 0;) {
                kind->animate(moved, 0.01 * any_below(20));
                kind->update(moved, 0);
                kind->show(moved, 0);
            }
            kind->update(moved, 0);
            kind->update(still, 0);
            settle(moved); /* picking follows the picture */
            settle(still);
        }
        kind->animate(moved, 2);
        settle(moved);
        CHECK_TEXT(editor_text(kind->editor(moved)), editor_text(kind->editor(still)));
        char *expected = picture_of(still);
        check_same_picture(moved, expected, true);
        memory_free(expected);
    }
    kind->close(moved);
    kind->close(still);
}

/* Shakes ---------------------------------------------------------------------------------------------------------- */

/* "abce": pieces that lie. */
static void lying(void *live, char *ids) {
    Plan plan = {0};
    Fault fault = {0};
    CHECK(plan_read_text(&plan, "", editor_text(kind->editor(live)), NULL, 0, &fault));
    for (size_t i = 0; i < plan.furniture_count; i++)
        if (plan.furniture[i].toppled)
            *ids++ = *plan.furniture[i].id;
    *ids = 0;
    plan_free(&plan);
}

/* Returns the pieces that lie after the shake of a seed, starting from the file's house. */
static void drawn(uint64_t seed, char *ids) {
    static const char *const names[] = {"a", "b", "c", "d"};
    Furniture pieces[4];
    bool topples[4];
    for (size_t i = 0; i < 4; i++)
        pieces[i] = (Furniture){.id = names[i], .topples = TOPPLE_FRONT, .probability = 0.5};
    shake_draw(&(Plan){.furniture = pieces, .furniture_count = 4}, seed, topples);
    for (size_t i = 0; i < 4; i++)
        if (topples[i])
            *ids++ = *names[i];
    *ids++ = 'e';
    *ids = 0;
}

static void shake(void *live) {
    Fault fault = {0};
    CHECK(editor_shake(kind->editor(live), &fault) && !fault.count);
    fault_clear(&fault);
}

TEST(each_shake_is_of_the_house_as_it_stood_before_the_last_one) {
    void *live = open_house();
    char now[16], expected[16], words[64];
    for (uint64_t seed = 1; seed <= 30; seed++) {
        shake(live);
        lying(live, now);
        drawn(seed, expected);
        CHECK_TEXT(now, expected);
        size_t fell = strlen(expected) - 1;
        snprintf(words, sizeof words, "Shake %d: fallen pieces: %zu of 6", (int)seed, fell);
        CHECK_TEXT(editor_shake_result(kind->editor(live)), words);
    }
    while (editor_undo(kind->editor(live)))
        continue;
    lying(live, now);
    CHECK_TEXT(now, "e");
    kind->close(live);
}

TEST(a_shake_is_a_step_and_after_another_edit_what_lies_stays) {
    void *live = open_house();
    char first[16], second[16], now[16];
    shake(live);
    lying(live, first);
    shake(live);
    lying(live, second);
    CHECK(strcmp(first, second) != 0);
    CHECK(editor_undo(kind->editor(live)));
    lying(live, now);
    CHECK_TEXT(now, first);
    CHECK(editor_redo(kind->editor(live)));
    lying(live, now);
    CHECK_TEXT(now, second);
    settle(live);
    topple(live, vec2(2.5, 0.3)); /* e is raised */
    shake(live);
    lying(live, now);
    for (const char *id = second; *id; id++)
        CHECK(*id == 'e' || strchr(now, *id));
    kind->close(live);
}

TEST(a_shake_lasts_about_a_second_and_says_its_seed) {
    void *live = open_house();
    settle(live);
    kind->animate(live, 0);
    char expected[16];
    for (uint64_t seed = 1; seed <= 6; seed++) {
        char words[64];
        shake(live);
        drawn(seed, expected);
        bool falls = strlen(expected) > 1;
        snprintf(words, sizeof words, "shaking (seed %d)", (int)seed);
        if (falls)
            CHECK_TEXT(kind->animation(live), words);
        else
            CHECK(!kind->animation(live));
        kind->animate(live, 0.59);
        CHECK(!falls || kind->animation(live));
        kind->animate(live, FURNITURE_FALL_SPREAD + 0.02);
        CHECK(!kind->animation(live));
        settle(live);
    }
    kind->close(live);
}

TEST(where_nothing_can_fall_a_shake_says_so) {
    void *live = open_house();
    Fault fault = {0};
    for (const char *id = "abcd"; *id; id++) {
        char name[64];
        snprintf(name, sizeof name, "furniture.%c.topples", *id);
        settle(live);
        CHECK(kind->set(live, name, TOPPLE_NO, &fault));
    }
    CHECK(!editor_shake(kind->editor(live), &fault) && fault.count == 1 && strstr(fault.lines[0], "can fall"));
    fault_clear(&fault);
    kind->close(live);
}
