/* Tests the picture and the panel of a house in its session: a time looks the same whenever it is displayed, layers can
 * be hidden, and rows, marks and items lead to each other. */

#include <stdio.h>
#include <string.h>

#include "base/text.h"
#include "check.h"
#include "running_house.h"

static const Laboratory *const laboratory = &house_laboratory;

TEST(a_time_looks_the_same_whenever_it_is_shown) {
    static const double times[] = {3, 11.7, 0, 7.3, 11.7, 3, 7.3};
    void *session = running_house_open("ube-techno-house", NULL, 0, NULL);
    running_house_finish(session, 0);
    char *first[7];
    for (size_t i = 0; i < 7; i++)
        first[i] = running_house_picture_at(session, times[i]);
    CHECK(strcmp(first[0], first[5]) == 0 && strcmp(first[1], first[4]) == 0 && strcmp(first[3], first[6]) == 0);
    CHECK(strcmp(first[0], first[1]) != 0);
    for (size_t i = 0; i < 7; i++)
        memory_free(first[i]);
    CHECK(laboratory->show(session, 7.3) && laboratory->show(session, 7.4) && !laboratory->show(session, 7.2));
    laboratory->close(session);
}

TEST(a_moment_rests_until_something_changes) {
    void *session = running_house_open("ube-techno-house", NULL, 0, NULL);
    running_house_finish(session, 0);
    laboratory->show(session, 7.3);
    Text before = {0}, again = {0};
    running_house_add_scene(&before, laboratory->moving(session));
    CHECK(laboratory->is_unchanged(session, 7.3) && !laboratory->is_unchanged(session, 7.4));
    laboratory->show(session, 7.3);
    running_house_add_scene(&again, laboratory->moving(session));
    CHECK(strcmp(before.text, again.text) == 0 && laboratory->added(session)->count == 0);
    laboratory->set_layers(session, 0);
    CHECK(!laboratory->is_unchanged(session, 7.3));
    laboratory->show(session, 7.3);
    CHECK(laboratory->is_unchanged(session, 7.3) && running_house_set(session, "door.d5.width", 0.85));
    running_house_finish(session, 7.3);
    CHECK(!laboratory->is_unchanged(session, 7.3));
    memory_free(before.text);
    memory_free(again.text);
    laboratory->close(session);
}

/* The shown part of an unfinished run equals the same part of the finished one. */
TEST(a_time_looks_the_same_before_the_run_is_over) {
    void *session = running_house_open("two-chairs-corridor", (const char *[]){"run.dt=0.0001"}, 1, NULL);
    double begun = running_house_clock();
    while (running_house_clock() - begun < 60 && laboratory->span(session).end < 4) {
        laboratory->update(session, 0);
        running_house_rest();
    }
    CHECK(!laboratory->span(session).complete);
    char *growing = running_house_picture_at(session, 4);
    running_house_finish(session, 4);
    char *whole = running_house_picture_at(session, 4);
    CHECK_TEXT(growing, whole);
    memory_free(growing);
    memory_free(whole);
    laboratory->close(session);
}

static size_t count_of(const Scene *scene, PrimitiveKind of, Role edge) {
    size_t count = 0;
    for (size_t i = 0; i < scene->count; i++)
        count += scene->primitives[i].kind == of && scene->primitives[i].edge == edge;
    return count;
}

TEST(layers_can_be_hidden_and_shown) {
    void *session = running_house_open("corner-1.20-1.20", NULL, 0, NULL);
    running_house_finish(session, 4);
    laboratory->show(session, 4);
    CHECK(count_of(laboratory->added(session), PRIMITIVE_LINE, ROLE_LOCUS) > 0 && laboratory->still(session)->grid > 0);
    CHECK(count_of(laboratory->moving(session), PRIMITIVE_POLYGON, ROLE_RING) == 1);
    laboratory->set_layers(session, 0);
    CHECK(laboratory->update(session, 4) & LABORATORY_VIEW);
    CHECK(!laboratory->show(session, 4));
    CHECK(laboratory->added(session)->count == 0 && !(laboratory->still(session)->grid > 0));
    CHECK(count_of(laboratory->moving(session), PRIMITIVE_POLYGON, ROLE_RING) == 0);
    CHECK(count_of(laboratory->still(session), PRIMITIVE_DIMENSION, ROLE_TEXT) == 0);
    for (size_t i = 0; i < laboratory->layer_count; i++)
        if (strcmp(laboratory->layers[i], "widths") == 0)
            laboratory->set_layers(session, 1u << i);
    running_house_finish(session, 4);
    CHECK(count_of(laboratory->still(session), PRIMITIVE_DIMENSION, ROLE_TEXT) == 2); /* W1 and W2 */
    laboratory->close(session);
}

TEST(ghosts_are_seen_moving) {
    void *session = running_house_open("ube-techno-house", NULL, 0, NULL);
    running_house_finish(session, 0);
    running_house_choose(session, "Compare with", "miura");
    running_house_finish(session, 5);
    laboratory->show(session, 5);
    CHECK(count_of(laboratory->still(session), PRIMITIVE_LINE, ROLE_GHOST) == 4 &&
          count_of(laboratory->moving(session), PRIMITIVE_POLYGON, ROLE_GHOST) == 4);
    laboratory->save_run(session, 5);
    CHECK(running_house_set(session, "person.p-a.delay", 2));
    running_house_finish(session, 5);
    laboratory->show(session, 5);
    CHECK(count_of(laboratory->moving(session), PRIMITIVE_POLYGON, ROLE_GHOST) == 4);
    size_t count, compared = 0;
    const PanelRow *rows = laboratory->rows(session, &count);
    for (size_t i = 0; i < count; i++)
        compared += strncmp(rows[i].row.cells[0], "Compare", 7) == 0;
    CHECK(compared == 1);
    laboratory->clear_runs(session, 5);
    running_house_finish(session, 5);
    laboratory->show(session, 5);
    CHECK(count_of(laboratory->still(session), PRIMITIVE_LINE, ROLE_GHOST) == 0 &&
          count_of(laboratory->moving(session), PRIMITIVE_POLYGON, ROLE_GHOST) == 0);
    laboratory->close(session);
}

/* The panel -------------------------------------------------------------------------------------------------------- */

TEST(a_row_of_a_dangerous_point_leads_there) {
    void *session = running_house_open("ube-techno-house", NULL, 0, NULL);
    running_house_finish(session, 0);
    size_t count, hazards = 0;
    const PanelRow *rows = laboratory->rows(session, &count);
    Item first = {0, 0};
    for (size_t i = 0; i < count; i++)
        if (rows[i].item.kind == HOUSE_HAZARD) {
            CHECK(rows[i].time >= 0 && rows[i].time < laboratory->span(session).end);
            first = hazards++ ? first : rows[i].item;
        }
    CHECK(hazards > 0);
    laboratory->select(session, first);
    CHECK(laboratory->update(session, 0) & LABORATORY_TEXTS);
    CHECK(strstr(laboratory->rows(session, &count)[0].row.cells[0], "Tight place 1"));
    laboratory->close(session);
}

TEST(where_somebody_is_stopped_is_the_place_that_is_shown) {
    const char *settings[] = {"door.d1.width=0.6"};
    void *session = running_house_open("closed-door", settings, 1, NULL);
    running_house_finish(session, 0);
    size_t count, first = 0;
    const PanelRow *rows = laboratory->rows(session, &count);
    while (first < count && !rows[first].place.kind)
        first++;
    CHECK(first < count && rows[first].place.kind == HOUSE_STOP);
    laboratory->select(session, rows[first < count ? first : 0].place);
    CHECK(laboratory->update(session, 0) & LABORATORY_TEXTS);
    CHECK_TEXT(laboratory->rows(session, &count)[0].row.cells[0], "A stops at room door");
    Vec2 outline[LABORATORY_OUTLINE_MOST];
    CHECK(laboratory->outline(session, laboratory->selected(session), 0, outline) > 0);
    laboratory->close(session);
}

TEST(what_is_pointed_at_is_found) {
    void *session = running_house_open("ube-techno-house", NULL, 0, NULL);
    running_house_finish(session, 0);
    Item none = {0, 0};
    Item door = laboratory->pick(session, vec2(7.86, 4.095), 0, none);
    CHECK_TEXT(laboratory->item_name(session, door), "bedroom 1 door");
    CHECK_TEXT(laboratory->item_name(session, laboratory->pick(session, vec2(2.6, 4.7775), 0, none)), "A, wheelchair");
    Item wall = laboratory->pick(session, vec2(10, 0), 0, none);
    CHECK_TEXT(laboratory->item_name(session, wall), "wall"); /* round the house */
    CHECK_TEXT(laboratory->item_key(session, wall), "wall w1");
    CHECK_TEXT(laboratory->name_at(session, wall, vec2(10, 0)), "lower wall of bedroom 1");
    CHECK_TEXT(laboratory->item_name(session, laboratory->pick(session, vec2(1.45, 1.85), 0, none)), "dining table");
    CHECK_TEXT(laboratory->item_name(session, laboratory->pick(session, vec2(11.05, 4.9), 0, none)), "exit porch");
    CHECK(laboratory->pick(session, vec2(50, 50), 0, none).kind == HOUSE_NOTHING);
    Item below = laboratory->pick(session, vec2(7.86, 4.095), 0, door);
    CHECK_TEXT(laboratory->item_key(session, below), "wall w2");
    CHECK_TEXT(laboratory->item_name(session, below), "wall"); /* along several rooms */
    CHECK_TEXT(laboratory->name_at(session, below, vec2(7.86, 4.095)), "wall between corridor and bedroom 1");
    CHECK(item_same(laboratory->pick(session, vec2(7.86, 4.095), 0, below), door));
    Vec2 points[LABORATORY_OUTLINE_MOST];
    for (int step = -1; step <= 1; step += 2) {
        Item item = laboratory->next(session, none, step), first = item;
        size_t count = 0;
        do {
            CHECK(*laboratory->item_name(session, item));
            CHECK(laboratory->outline(session, item, 0, points) >= 4);
            laboratory->select(session, item);
            CHECK(item_same(laboratory->selected(session), item));
            laboratory->update(session, 0);
            item = laboratory->next(session, item, step);
        } while (!item_same(item, first) && ++count < 1000);
        CHECK(count > 40 && count < 100);
    }
    laboratory->select(session, door);
    CHECK(laboratory->update(session, 0) & LABORATORY_PARAMETERS);
    size_t count, rows;
    CHECK_TEXT(laboratory->parameters(session, &count)[0].name, "door.d5.width");
    CHECK_TEXT(laboratory->rows(session, &rows)[0].row.cells[0], "Bedroom 1 door");
    laboratory->close(session);
}

TEST(ticks_rise_and_tell_of_exits) {
    void *session = running_house_open("ube-techno-house", NULL, 0, NULL);
    running_house_finish(session, 0);
    size_t count, exits = 0;
    const TimelineMark *marks = laboratory->marks(session, &count);
    for (size_t i = 0; i < count; i++) {
        CHECK(i == 0 || marks[i].time >= marks[i - 1].time);
        CHECK(marks[i].time >= 0 && marks[i].time <= laboratory->span(session).end);
        exits += marks[i].kind == TIMELINE_EXIT;
    }
    CHECK(exits == 4);
    laboratory->close(session);
}

TEST(numbers_of_the_moment_follow_the_time) {
    void *session = running_house_open("two-chairs-corridor", NULL, 0, NULL);
    running_house_finish(session, 0);
    laboratory->select(session, (Item){HOUSE_PERSON, 0});
    laboratory->update(session, 0);
    size_t count;
    char first[64] = "";
    const PanelRow *rows = laboratory->rows(session, &count);
    for (size_t i = 0; i < count; i++)
        if (strcmp(rows[i].row.cells[0], "speed now") == 0)
            snprintf(first, sizeof first, "%s", rows[i].row.cells[1]);
    CHECK_TEXT(first, "0.00 m/s");
    unsigned changed = 0;
    while (!(changed & LABORATORY_TEXTS)) {
        changed = laboratory->update(session, 5);
        running_house_rest();
    }
    rows = laboratory->rows(session, &count);
    for (size_t i = 0; i < count; i++)
        if (strcmp(rows[i].row.cells[0], "speed now") == 0)
            CHECK(strcmp(rows[i].row.cells[1], first) != 0);
    CHECK(laboratory->plot_count(session) == 7);
    LaboratoryPlot speed = laboratory->plot(session, 0);
    CHECK(speed.plot->series_count == 1 && laboratory->points_until(session, 0, 0, 5) < speed.plot->series[0].count);
    laboratory->close(session);
}
