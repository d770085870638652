/* Tests the House laboratory: a run equals that of the command line regardless of display, selection and changes;
 * errors are reported and change nothing. */

#include "laboratory/house/session.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#include "case.h"
#include "check.h"
#include "house/run.h"
#include "laboratory/edit/editor.h"
#include "visual/house/silhouette.h"

static const Laboratory *const kind = &house_laboratory;

/* s, of all threads, that closing may take; more when every access is checked. */
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
static const double AT_ONCE = 15;
#else
static const double AT_ONCE = 1;
#endif

static double clock_of(clockid_t which) {
    struct timespec time;
    clock_gettime(which, &time);
    return (double)time.tv_sec + 1e-9 * (double)time.tv_nsec;
}

static double now(void) {
    return clock_of(CLOCK_MONOTONIC);
}

/* Closes the session without waiting for its work. */
static void close_at_once(void *live) {
    double begun = clock_of(CLOCK_PROCESS_CPUTIME_ID);
    kind->close(live);
    CHECK(clock_of(CLOCK_PROCESS_CPUTIME_ID) - begun < AT_ONCE);
}

static void *open_live(const char *name, const char *const *settings, size_t setting_count, const char *route) {
    char path[4096], profiles[4096];
    snprintf(path, sizeof path, "%s/houses/%s.json", check_source(), name);
    snprintf(profiles, sizeof profiles, "%s/assets/profiles", check_source());
    Fault fault = {0};
    LaboratoryOptions options = {.profiles = profiles,
                                 .settings = settings,
                                 .setting_count = setting_count,
                                 .route = route,
                                 .driving = -1,
                                 .seed = 1,
                                 .jobs = 2};
    void *live = kind->open(path, &options, &fault);
    check_say(&fault);
    return live;
}

static void rest(void) {
    nanosleep(&(struct timespec){.tv_nsec = 2000000}, NULL);
}

static size_t find_choice(void *live, const char *name, const char *word, size_t *place) {
    size_t count;
    const PanelChoice *all = kind->choices(live, &count);
    for (size_t c = 0; c < count; c++)
        for (size_t w = 0; strcmp(all[c].name, name) == 0 && w < all[c].count; w++)
            if (strcmp(all[c].options[w], word) == 0) {
                *place = w;
                return c;
            }
    CHECK(!"the choice is there");
    return 0;
}

static void choose(void *live, const char *name, const char *word) {
    size_t place = 0, choice = find_choice(live, name, word, &place);
    kind->choose(live, choice, place);
    size_t count;
    CHECK(kind->choices(live, &count)[choice].chosen == place);
}

/* Waits until no work remains; returns all change flags. */
static unsigned settle(void *live, double time) {
    unsigned changed = 0;
    double begun = now();
    do {
        changed |= kind->update(live, time);
        rest();
    } while ((!kind->span(live).complete || kind->answer(live).stale || kind->answer(live).doing) &&
             now() - begun < 120);
    changed |= kind->update(live, time);
    CHECK(kind->span(live).complete && !kind->answer(live).stale);
    return changed;
}

static uint64_t digest_of(const char *name, const char *const *settings, const char *route, int driving) {
    House house;
    case_house(&house, name, driving, settings);
    Observation observation;
    run_house(&observation, &house,
              &(RunOptions){.route = route ? plan_find_route(&house.plan, route) : SIZE_MAX, .jobs = 1});
    uint64_t digest = observation.digest;
    observation_free(&observation);
    house_free(&house);
    return digest;
}

static bool set(void *live, const char *name, double value) {
    Fault fault = {0};
    bool good = kind->set(live, name, value, &fault);
    for (size_t i = 0; i < fault.count; i++)
        printf("%s\n", fault.lines[i]);
    CHECK(good == !fault.total);
    fault_clear(&fault);
    return good;
}

static const PanelParameter *parameter(void *live, const char *name) {
    size_t count;
    const PanelParameter *all = kind->parameters(live, &count);
    for (size_t i = 0; i < count; i++)
        if (strcmp(all[i].name, name) == 0)
            return &all[i];
    return NULL;
}

static void add_scene(Text *text, const Scene *scene) {
    for (size_t i = 0; i < scene->count; i++) {
        const Primitive *primitive = &scene->primitives[i];
        text_format(text, "%d %d %d %.9f %.9f", primitive->kind, primitive->fill, primitive->edge, primitive->radius,
                    primitive->begun);
        for (size_t p = 0; p < primitive->count; p++)
            text_format(text, " %.9f,%.9f", primitive->points[p].x, primitive->points[p].y);
        text_format(text, " %s\n", primitive->text);
    }
}

/* Returns the input of a painter as text: the whole static and moving layers. */
static char *picture_at(void *live, double time) {
    kind->update(live, time);
    kind->set_camera(live, (Camera){.zoom = 1}); /* everything is added again */
    kind->update(live, time);
    CHECK(!kind->show(live, time));
    Text text = {0};
    add_scene(&text, kind->added(live));
    add_scene(&text, kind->moving(live));
    return text.text;
}

TEST(a_run_in_the_window_is_the_one_of_the_command_line) {
    static const char *const names[] = {"ube-techno-house", "two-chairs-corridor", "corner-1.20-1.20"};
    for (size_t n = 0; n < sizeof names / sizeof *names; n++) {
        void *live = open_live(names[n], NULL, 0, NULL);
        CHECK(house_session_digest(live) == 0);
        for (int i = 0; i < 50; i++) { /* regardless of what is shown meanwhile */
            kind->update(live, 0.3 * i);
            double end = kind->span(live).end;
            kind->show(live, end * (i % 7) / 7);
            kind->pick(live, vec2(1, 1), end, (Item){0, 0});
            rest();
        }
        CHECK(settle(live, 1) | LABORATORY_VIEW);
        CHECK(house_session_digest(live) == digest_of(names[n], NULL, NULL, -1));
        CHECK(kind->answer(live).role == ROLE_TEXT);
        kind->close(live);
    }
}

TEST(options_of_the_opening_are_kept) {
    void *live = open_live("ube-techno-house", (const char *[]){"door.d7.width=0.8"}, 1, "C");
    settle(live, 0);
    CHECK(house_session_digest(live) ==
          digest_of("ube-techno-house", (const char *[]){"door.d7.width=0.8", NULL}, "C", -1));
    CHECK(set(live, "run.patience", 10));
    settle(live, 0);
    size_t count;
    const char *const *words = kind->command(live, &count);
    CHECK(count == 8 && strcmp(words[0], "run") == 0);
    CHECK_TEXT(words[3], "door.d7.width=0.8");
    CHECK_TEXT(words[5], "run.patience=10");
    CHECK_TEXT(words[7], "C");
    kind->close(live);
    CHECK(!open_live("ube-techno-house", NULL, 0, "Z"));
    CHECK(!open_live("no-such-house", NULL, 0, NULL));
    CHECK(!open_live("ube-techno-house", (const char *[]){"door.d77.width=0.8"}, 1, NULL));
}

TEST(a_parameter_makes_another_run_and_reset_the_first) {
    void *live = open_live("ube-techno-house", NULL, 0, NULL);
    settle(live, 0);
    uint64_t first = house_session_digest(live);
    CHECK(set(live, "door.d5.width", 0.85));
    CHECK(house_session_digest(live) == 0 && kind->answer(live).stale);
    unsigned changed = settle(live, 3);
    CHECK((changed & (LABORATORY_VIEW | LABORATORY_TEXTS | LABORATORY_PLOTS | LABORATORY_PARAMETERS)) ==
          (LABORATORY_VIEW | LABORATORY_TEXTS | LABORATORY_PLOTS | LABORATORY_PARAMETERS));
    uint64_t second = house_session_digest(live);
    CHECK(second == digest_of("ube-techno-house", (const char *[]){"door.d5.width=0.85", NULL}, NULL, -1));
    CHECK(second != first && strstr(kind->answer(live).detail, "before"));
    CHECK(parameter(live, "door.d5.width")->value == 0.85 && parameter(live, "door.d5.width")->initial == 0.9);
    kind->reset(live);
    settle(live, 3);
    CHECK(house_session_digest(live) == first && parameter(live, "door.d5.width")->value == 0.9);
    kind->close(live);
}

TEST(a_bad_value_changes_nothing) {
    void *live = open_live("ube-techno-house", NULL, 0, NULL);
    settle(live, 0);
    uint64_t first = house_session_digest(live);
    CHECK(!set(live, "door.d5.width", 900));
    CHECK(!set(live, "door.d5.width", NAN));
    CHECK(!set(live, "run.reversals", 1.5));
    CHECK(!set(live, "door.d5.colour", 1));
    CHECK(house_session_digest(live) == first && parameter(live, "door.d5.width")->value == 0.9);
    kind->close(live);
}

TEST(a_house_that_would_be_bad_is_refused_at_once) {
    void *live = open_live("ube-techno-house", NULL, 0, NULL);
    double since;
    settle(live, 0);
    uint64_t first = house_session_digest(live);
    CHECK(!set(live, "door.d5.width", 9));
    size_t place;
    find_choice(live, "Route", "A", &place); /* its choice is the plan's, which is unchanged */
    CHECK(!kind->error(live, &since) && !(settle(live, 0) & LABORATORY_ERROR));
    CHECK(house_session_digest(live) == first && parameter(live, "door.d5.width")->value == 0.9);
    CHECK(set(live, "door.d5.width", 0.95));
    settle(live, 0);
    CHECK(house_session_digest(live) != first);
    kind->close(live);
}

/* Reports an error that appears only when the house is built: a step longer than the springs allow. */
TEST(a_house_that_becomes_bad_keeps_the_last_good_one) {
    void *live = open_live("ube-techno-house", NULL, 0, NULL);
    double since;
    settle(live, 0);
    uint64_t first = house_session_digest(live);
    CHECK(!kind->error(live, &since));
    CHECK(set(live, "run.dt", 0.03));
    unsigned changed = settle(live, 0);
    CHECK(changed & LABORATORY_ERROR && changed & LABORATORY_PARAMETERS);
    CHECK(kind->error(live, &since) && isnan(since));
    CHECK(house_session_digest(live) == first && parameter(live, "run.dt")->value == 0.001);
    CHECK(set(live, "door.d5.width", 0.95));
    settle(live, 0);
    CHECK(!kind->error(live, &since) && house_session_digest(live) != first);
    kind->close(live);
}

TEST(what_is_chosen_while_the_house_is_read_has_its_numbers_to_come_back_to) {
    void *live = open_live("ube-techno-house", NULL, 0, NULL);
    CHECK(!kind->save_run(live, 0));
    usleep(20000); /* the first run begins */
    choose(live, "Route", "B");
    settle(live, 0);
    double since;
    CHECK(set(live, "run.dt", 0.03));
    settle(live, 0);
    CHECK(kind->error(live, &since));
    size_t count;
    const PanelParameter *parameters = kind->parameters(live, &count);
    for (size_t i = 0; i < count; i++)
        CHECK(parameters[i].value == parameters[i].initial);
    CHECK(kind->save_run(live, 0));
    kind->close(live);
}

/* The part before an edit stays visible; later times show the edited house, and the answer concerns that house
 * alone. */
TEST(an_edit_on_the_way_goes_on_from_there) {
    void *live = open_live("ube-techno-house", NULL, 0, NULL);
    settle(live, 0);
    Vec2 early[LABORATORY_OUTLINE_MOST], late[LABORATORY_OUTLINE_MOST], again[LABORATORY_OUTLINE_MOST];
    Item person = {HOUSE_PERSON, 0};
    size_t points = kind->outline(live, person, 3, early);
    CHECK(points && kind->outline(live, person, 7, late) == points);
    kind->update(live, 5);
    CHECK(set(live, "profile.manual-chair.drive.free_speed", 0.4));
    settle(live, 5);
    CHECK(strstr(kind->note(live), "mixed: plan changed at 5.0 s"));
    CHECK(kind->outline(live, person, 3, again) == points && memcmp(again, early, points * sizeof *again) == 0);
    CHECK(kind->outline(live, person, 7, again) == points && memcmp(again, late, points * sizeof *again) != 0);
    size_t count, changes = 0;
    const TimelineMark *ticks = kind->marks(live, &count);
    for (size_t i = 0; i < count; i++)
        changes += ticks[i].kind == TIMELINE_CHANGE && ticks[i].time == 5;
    CHECK(changes == 1);
    uint64_t mixed = house_session_digest(live);
    const char *title = strdup(kind->answer(live).title);
    kind->restart(live);
    settle(live, 0);
    CHECK(!strstr(kind->note(live), "mixed"));
    CHECK_TEXT(kind->answer(live).title, title);
    CHECK(house_session_digest(live) != mixed);
    CHECK(house_session_digest(live) ==
          digest_of("ube-techno-house", (const char *[]){"profile.manual-chair.drive.free_speed=0.4", NULL}, NULL, -1));
    free((char *)title);
    kind->close(live);
}

/* True if the displayed run changes its plan at a time, as the note says it. */
static bool is_mixed_at(void *live, const char *time) {
    Text text = {0};
    text_format(&text, "plan changed at %s s", time);
    bool mixed = strstr(kind->note(live), text.text);
    memory_free(text.text);
    return mixed;
}

TEST(a_reset_while_a_number_is_dragged_changes_nothing_if_nothing_was_changed_before) {
    void *live = open_live("ube-techno-house", NULL, 0, NULL);
    settle(live, 0);
    kind->update(live, 4);
    CHECK(set(live, "door.d5.width", 0.97));
    settle(live, 4);
    CHECK(is_mixed_at(live, "4.0"));
    kind->update(live, 6);
    CHECK(editor_undo(kind->editor(live)));
    settle(live, 6);
    CHECK(is_mixed_at(live, "6.0"));
    kind->reset(live); /* the draft is as in the file: the changes on the way stay */
    settle(live, 6);
    CHECK(is_mixed_at(live, "6.0"));
    uint64_t mixed = house_session_digest(live);
    double width = parameter(live, "door.d5.width")->value;
    kind->begin_number(live, "door.d5.width");
    CHECK(set(live, "door.d5.width", 0.96));
    kind->reset(live);
    settle(live, 6);
    CHECK(is_mixed_at(live, "6.0"));
    CHECK(house_session_digest(live) == mixed);
    CHECK_NEAR(parameter(live, "door.d5.width")->value, width, 0);
    kind->close(live);
}

TEST(a_number_counts_from_the_time_at_which_it_was_put_down) {
    void *live = open_live("ube-techno-house", NULL, 0, NULL);
    settle(live, 0);
    kind->update(live, 4);
    kind->begin_number(live, "door.d5.width");
    CHECK(set(live, "door.d5.width", 0.97));
    kind->end_number(live);
    editor_set_tool(kind->editor(live), TOOL_PERSON);
    CHECK(editor_enter(kind->editor(live))); /* a gesture begins at once */
    kind->update(live, 4);
    kind->update(live, 7);
    CHECK(editor_escape(kind->editor(live)));
    settle(live, 7);
    CHECK(is_mixed_at(live, "4.0"));
    kind->close(live);
}

TEST(a_number_that_is_only_touched_does_not_restart_the_run) {
    void *live = open_live("hall-10000", (const char *[]){"crowd.people.count=2000", "run.sample=0.1"}, 2, NULL);
    for (double begun = now(); now() - begun < 200 && (kind->answer(live).stale || kind->span(live).end == 0); rest())
        kind->update(live, 0);
    CHECK(!kind->answer(live).stale && !kind->span(live).complete);
    size_t count;
    const PanelParameter *all = kind->parameters(live, &count);
    CHECK(count > 0);
    kind->begin_number(live, all[0].name);
    kind->end_number(live);
    CHECK(!kind->answer(live).stale);
    close_at_once(live);
}

TEST(the_newest_change_wins) {
    void *live = open_live("ube-techno-house", NULL, 0, NULL);
    settle(live, 0);
    for (int i = 0; i <= 20; i++) {
        CHECK(set(live, "door.d5.width", 0.8 + 0.01 * i));
        kind->update(live, 0);
        if (i % 5 == 0)
            rest();
    }
    CHECK(set(live, "door.d5.width", 0.97));
    settle(live, 0);
    CHECK(house_session_digest(live) ==
          digest_of("ube-techno-house", (const char *[]){"door.d5.width=0.97", NULL}, NULL, -1));
    kind->close(live);
}

TEST(a_time_looks_the_same_whenever_it_is_shown) {
    static const double times[] = {3, 11.7, 0, 7.3, 11.7, 3, 7.3};
    void *live = open_live("ube-techno-house", NULL, 0, NULL);
    settle(live, 0);
    char *first[7];
    for (size_t i = 0; i < 7; i++)
        first[i] = picture_at(live, times[i]);
    CHECK(strcmp(first[0], first[5]) == 0 && strcmp(first[1], first[4]) == 0 && strcmp(first[3], first[6]) == 0);
    CHECK(strcmp(first[0], first[1]) != 0);
    for (size_t i = 0; i < 7; i++)
        memory_free(first[i]);
    CHECK(kind->show(live, 7.3) && kind->show(live, 7.4) && !kind->show(live, 7.2));
    kind->close(live);
}

TEST(a_moment_rests_until_something_changes) {
    void *live = open_live("ube-techno-house", NULL, 0, NULL);
    settle(live, 0);
    kind->show(live, 7.3);
    Text before = {0}, again = {0};
    add_scene(&before, kind->moving(live));
    CHECK(kind->is_unchanged(live, 7.3) && !kind->is_unchanged(live, 7.4));
    kind->show(live, 7.3);
    add_scene(&again, kind->moving(live));
    CHECK(strcmp(before.text, again.text) == 0 && kind->added(live)->count == 0);
    kind->set_layers(live, 0);
    CHECK(!kind->is_unchanged(live, 7.3));
    kind->show(live, 7.3);
    CHECK(kind->is_unchanged(live, 7.3) && set(live, "door.d5.width", 0.85));
    settle(live, 7.3);
    CHECK(!kind->is_unchanged(live, 7.3));
    memory_free(before.text);
    memory_free(again.text);
    kind->close(live);
}

/* The shown part of an unfinished run equals the same part of the finished one. */
TEST(a_time_looks_the_same_before_the_run_is_over) {
    void *live = open_live("two-chairs-corridor", (const char *[]){"run.dt=0.0001"}, 1, NULL);
    double begun = now();
    while (now() - begun < 60 && kind->span(live).end < 4) {
        kind->update(live, 0);
        rest();
    }
    CHECK(!kind->span(live).complete);
    char *growing = picture_at(live, 4);
    settle(live, 4);
    char *whole = picture_at(live, 4);
    CHECK_TEXT(growing, whole);
    memory_free(growing);
    memory_free(whole);
    kind->close(live);
}

static size_t count_of(const Scene *scene, PrimitiveKind of, Role edge) {
    size_t count = 0;
    for (size_t i = 0; i < scene->count; i++)
        count += scene->primitives[i].kind == of && scene->primitives[i].edge == edge;
    return count;
}

TEST(layers_can_be_hidden_and_shown) {
    void *live = open_live("corner-1.20-1.20", NULL, 0, NULL);
    settle(live, 4);
    kind->show(live, 4);
    CHECK(count_of(kind->added(live), PRIMITIVE_LINE, ROLE_LOCUS) > 0 && kind->still(live)->grid > 0);
    CHECK(count_of(kind->moving(live), PRIMITIVE_POLYGON, ROLE_RING) == 1);
    kind->set_layers(live, 0);
    CHECK(kind->update(live, 4) & LABORATORY_VIEW);
    CHECK(!kind->show(live, 4));
    CHECK(kind->added(live)->count == 0 && !(kind->still(live)->grid > 0));
    CHECK(count_of(kind->moving(live), PRIMITIVE_POLYGON, ROLE_RING) == 0);
    CHECK(count_of(kind->still(live), PRIMITIVE_DIMENSION, ROLE_TEXT) == 0);
    for (size_t i = 0; i < kind->layer_count; i++)
        if (strcmp(kind->layers[i], "widths") == 0)
            kind->set_layers(live, 1u << i);
    settle(live, 4);
    CHECK(count_of(kind->still(live), PRIMITIVE_DIMENSION, ROLE_TEXT) == 2); /* W1 and W2 */
    kind->close(live);
}

TEST(a_row_of_a_dangerous_point_leads_there) {
    void *live = open_live("ube-techno-house", NULL, 0, NULL);
    settle(live, 0);
    size_t count, hazards = 0;
    const PanelRow *rows = kind->rows(live, &count);
    Item first = {0, 0};
    for (size_t i = 0; i < count; i++)
        if (rows[i].item.kind == HOUSE_HAZARD) {
            CHECK(rows[i].time >= 0 && rows[i].time < kind->span(live).end);
            first = hazards++ ? first : rows[i].item;
        }
    CHECK(hazards > 0);
    kind->select(live, first);
    CHECK(kind->update(live, 0) & LABORATORY_TEXTS);
    CHECK(strstr(kind->rows(live, &count)[0].row.cells[0], "Dangerous point 1"));
    kind->close(live);
}

TEST(where_somebody_is_stopped_is_the_place_that_is_shown) {
    const char *settings[] = {"door.d1.width=0.6"};
    void *live = open_live("closed-door", settings, 1, NULL);
    settle(live, 0);
    size_t count, first = 0;
    const PanelRow *rows = kind->rows(live, &count);
    while (first < count && !rows[first].place.kind)
        first++;
    CHECK(first < count && rows[first].place.kind == HOUSE_STOP);
    kind->select(live, rows[first < count ? first : 0].place);
    CHECK(kind->update(live, 0) & LABORATORY_TEXTS);
    CHECK_TEXT(kind->rows(live, &count)[0].row.cells[0], "P1 stops at door d1");
    Vec2 outline[LABORATORY_OUTLINE_MOST];
    CHECK(kind->outline(live, kind->selected(live), 0, outline) > 0);
    kind->close(live);
}

TEST(what_is_pointed_at_is_found) {
    void *live = open_live("ube-techno-house", NULL, 0, NULL);
    settle(live, 0);
    Item none = {0, 0};
    Item door = kind->pick(live, vec2(7.86, 4.095), 0, none);
    CHECK_TEXT(kind->item_name(live, door), "door d5");
    CHECK_TEXT(kind->item_name(live, kind->pick(live, vec2(2.6, 4.7775), 0, none)), "person p-a");
    CHECK_TEXT(kind->item_name(live, kind->pick(live, vec2(10, 0), 0, none)), "wall w1");
    CHECK_TEXT(kind->item_name(live, kind->pick(live, vec2(1.45, 1.85), 0, none)), "dining table (dining-table)");
    CHECK_TEXT(kind->item_name(live, kind->pick(live, vec2(11.05, 4.9), 0, none)), "exit porch");
    CHECK(kind->pick(live, vec2(50, 50), 0, none).kind == HOUSE_NOTHING);
    Item below = kind->pick(live, vec2(7.86, 4.095), 0, door);
    CHECK_TEXT(kind->item_name(live, below), "wall w2");
    CHECK(item_same(kind->pick(live, vec2(7.86, 4.095), 0, below), door));
    Vec2 points[LABORATORY_OUTLINE_MOST];
    for (int step = -1; step <= 1; step += 2) {
        Item thing = kind->next(live, none, step), first = thing;
        size_t count = 0;
        do {
            CHECK(*kind->item_name(live, thing));
            CHECK(kind->outline(live, thing, 0, points) >= 4);
            kind->select(live, thing);
            CHECK(item_same(kind->selected(live), thing));
            kind->update(live, 0);
            thing = kind->next(live, thing, step);
        } while (!item_same(thing, first) && ++count < 1000);
        CHECK(count > 40 && count < 100);
    }
    kind->select(live, door);
    CHECK(kind->update(live, 0) & LABORATORY_PARAMETERS);
    size_t count, rows;
    CHECK_TEXT(kind->parameters(live, &count)[0].name, "door.d5.width");
    CHECK_TEXT(kind->rows(live, &rows)[0].row.cells[0], "Door d5");
    kind->close(live);
}

TEST(ticks_rise_and_tell_of_exits) {
    void *live = open_live("ube-techno-house", NULL, 0, NULL);
    settle(live, 0);
    size_t count, exits = 0;
    const TimelineMark *ticks = kind->marks(live, &count);
    for (size_t i = 0; i < count; i++) {
        CHECK(i == 0 || ticks[i].time >= ticks[i - 1].time);
        CHECK(ticks[i].time >= 0 && ticks[i].time <= kind->span(live).end);
        exits += ticks[i].kind == TIMELINE_EXIT;
    }
    CHECK(exits == 4);
    kind->close(live);
}

TEST(numbers_of_the_moment_follow_the_time) {
    void *live = open_live("two-chairs-corridor", NULL, 0, NULL);
    settle(live, 0);
    kind->select(live, (Item){HOUSE_PERSON, 0});
    kind->update(live, 0);
    size_t count;
    char first[64] = "";
    const PanelRow *rows = kind->rows(live, &count);
    for (size_t i = 0; i < count; i++)
        if (strcmp(rows[i].row.cells[0], "speed now") == 0)
            snprintf(first, sizeof first, "%s", rows[i].row.cells[1]);
    CHECK_TEXT(first, "0.00 m/s");
    unsigned changed = 0;
    for (int i = 0; i < 300 && !(changed & LABORATORY_TEXTS); i++) {
        changed = kind->update(live, 5);
        rest();
    }
    CHECK(changed & LABORATORY_TEXTS);
    rows = kind->rows(live, &count);
    for (size_t i = 0; i < count; i++)
        if (strcmp(rows[i].row.cells[0], "speed now") == 0)
            CHECK(strcmp(rows[i].row.cells[1], first) != 0);
    CHECK(kind->plot_count(live) == 5);
    LaboratoryPlot speed = kind->plot(live, 0);
    CHECK(speed.plot->series_count == 1 && kind->points_until(live, 0, 0, 5) < speed.plot->series[0].count);
    kind->close(live);
}

TEST(routes_and_ways_of_driving_can_be_chosen) {
    void *live = open_live("ube-techno-house", NULL, 0, NULL);
    settle(live, 0);
    choose(live, "Driving", "miura");
    settle(live, 0);
    CHECK(house_session_digest(live) == digest_of("ube-techno-house", NULL, NULL, DRIVING_MIURA));
    choose(live, "Route", "B");
    settle(live, 0);
    CHECK(house_session_digest(live) == digest_of("ube-techno-house", NULL, "B", DRIVING_MIURA));
    choose(live, "Driving", "as in the file");
    choose(live, "Route", "everybody");
    settle(live, 0);
    CHECK(house_session_digest(live) == digest_of("ube-techno-house", NULL, NULL, -1));
    kind->close(live);
}

TEST(ghosts_are_seen_moving) {
    void *live = open_live("ube-techno-house", NULL, 0, NULL);
    settle(live, 0);
    choose(live, "Ghost", "miura");
    settle(live, 5);
    kind->show(live, 5);
    CHECK(count_of(kind->still(live), PRIMITIVE_LINE, ROLE_GHOST) == 4 &&
          count_of(kind->moving(live), PRIMITIVE_POLYGON, ROLE_GHOST) == 4);
    kind->save_run(live, 5);
    CHECK(set(live, "person.p-a.delay", 2));
    settle(live, 5);
    kind->show(live, 5);
    CHECK(count_of(kind->moving(live), PRIMITIVE_POLYGON, ROLE_GHOST) == 4);
    size_t count, compared = 0;
    const PanelRow *rows = kind->rows(live, &count);
    for (size_t i = 0; i < count; i++)
        compared += strncmp(rows[i].row.cells[0], "Compare", 7) == 0;
    CHECK(compared == 1);
    kind->clear_runs(live, 5);
    settle(live, 5);
    kind->show(live, 5);
    CHECK(count_of(kind->still(live), PRIMITIVE_LINE, ROLE_GHOST) == 0 &&
          count_of(kind->moving(live), PRIMITIVE_POLYGON, ROLE_GHOST) == 0);
    kind->close(live);
}

/* A long run is visible from its beginning. */
TEST(what_is_recorded_can_be_seen_while_more_is_computed) {
    void *live = open_live("hall-10000", (const char *[]){"crowd.people.count=2000", "run.sample=0.1"}, 2, NULL);
    double begun = now(), end = 0;
    bool grew = false;
    while (now() - begun < 200 && end < 3) {
        kind->update(live, end);
        RecordSpan span = kind->span(live);
        CHECK(span.end >= end && !span.complete);
        grew = grew || (end > 0 && span.end > end);
        end = span.end;
        kind->show(live, end);
        rest();
    }
    CHECK(grew && kind->moving(live)->count > 0 && house_session_digest(live) == 0);
    CHECK(strstr(kind->answer(live).doing, "computed") && kind->plot_count(live) == 5);
    close_at_once(live);
}

TEST(closing_does_not_wait) {
    for (int i = 0; i < 10; i++) {
        void *live = open_live(i % 2 ? "shopping-centre" : "flat-0.910-module", NULL, 0, NULL);
        for (int k = 0; k < i * i; k++) {
            kind->update(live, 0);
            rest();
        }
        close_at_once(live);
    }
}

/* Opens a house with these members besides its walls; the file is deleted afterwards, but the house stays open. */
static void *open_made(const char *path, const char *members) {
    Text text = {0};
    text_format(&text,
                "{\"format\": \"clearance-house\", \"version\": 1, \"walls\": [{\"id\": \"w1\", \"points\": [[0, 0], "
                "[9, 0]]}]%s}",
                members);
    CHECK(text_write_file(path, text.text, text.used) == 0);
    memory_free(text.text);
    char profiles[4096];
    snprintf(profiles, sizeof profiles, "%s/assets/profiles", check_source());
    Fault fault = {0};
    void *live =
        kind->open(path, &(LaboratoryOptions){.profiles = profiles, .driving = -1, .seed = 1, .jobs = 1}, &fault);
    CHECK(live && !fault.total);
    return live;
}

TEST(a_house_that_cannot_be_run_says_why) {
    char path[] = "/tmp/clearance-live-XXXXXX";
    close(mkstemp(path));
    void *live = open_made(path, ", \"people\": [{\"id\": \"p1\", \"profile\": \"nobody\", \"at\": [1, 1]}]");
    unsigned changed = settle(live, 0);
    double since;
    CHECK(changed & LABORATORY_ERROR && strstr(kind->error(live, &since), "nobody"));
    CHECK(kind->answer(live).role == ROLE_ERROR && house_session_digest(live) == 0);
    size_t count;
    kind->parameters(live, &count);
    CHECK(count == 0 && !set(live, "wall.w1.thickness", 0.2));
    CHECK(!kind->show(live, 0) && kind->still(live)->count == 0 && kind->plot_count(live) == 0);
    CHECK(kind->next(live, (Item){0, 0}, 1).kind == HOUSE_NOTHING);
    kind->close(live);
    live = open_made(path, "");
    settle(live, 0);
    CHECK_TEXT(kind->answer(live).title, "The house has no people");
    CHECK(!kind->show(live, 0) && kind->still(live)->count > 0 && kind->span(live).end == 0);
    CHECK(set(live, "wall.w1.thickness", 0.3));
    settle(live, 0);
    CHECK(!kind->error(live, &since));
    kind->close(live);
    unlink(path);
}

/* A person who does not leave, and numbers with which a run fails. */
TEST(what_went_wrong_is_told) {
    void *live = open_live("corner-0.78-0.78", NULL, 0, NULL);
    settle(live, 0);
    CHECK(kind->answer(live).role == ROLE_ERROR && strstr(kind->answer(live).title, "annot pass"));
    kind->close(live);
    live =
        open_live("corner-0.90-0.90", (const char *[]){"profile.manual-chair.contact.normal_damping=100000"}, 1, NULL);
    settle(live, 0);
    double since;
    CHECK(strstr(kind->error(live, &since), "the step dt"));
    kind->close(live);
}
