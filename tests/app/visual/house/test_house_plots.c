#include "check.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "case.h"
#include "visual/house/crowd_plots.h"
#include "visual/house/house_plots.h"
#include "visual/house/people_scene.h"

enum { TRACED = 5 /* plots of columns of the trace */ };

static const PlotChoice ALL = {{0, 1, 2, 3, 4}, TRACED};

TEST(words_choose_plots_in_their_order_each_once) {
    PlotChoice choice;
    char fault[PLOT_CHOICE_FAULT];
    CHECK(house_plots_choose(&choice, "phase,speed,phase", fault));
    CHECK(choice.count == 2);
    CHECK_TEXT(house_plots_name(choice.indices[0]), "phase");
    CHECK_TEXT(house_plots_name(choice.indices[1]), "speed");
    CHECK(house_plots_choose(&choice, "speed,clearance,force,ring,phase,out,flow", fault));
    CHECK(choice.count == HOUSE_PLOTS_KNOWN);
}

TEST(a_word_that_is_no_plot_is_named_with_those_that_are) {
    static const char *const wrong[][2] = {{"speed,sped", "sped"}, {"", ""}, {"speed,", ""}, {"Speed", "Speed"}};
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        PlotChoice choice = {{3}, 1};
        char fault[PLOT_CHOICE_FAULT], expected[PLOT_CHOICE_FAULT];
        CHECK(!house_plots_choose(&choice, wrong[i][0], fault));
        snprintf(expected, sizeof expected, "no plot \"%s\": plots are speed, clearance, force, ring, phase, out, flow",
                 wrong[i][1]);
        CHECK_TEXT(fault, expected);
        CHECK(choice.count == 1 && choice.indices[0] == 3);
    }
}

static const PlotSeries *find_series(const Plot *plot, const char *name) {
    for (size_t s = 0; s < plot->series_count; s++)
        if (plot->series[s].name && strcmp(plot->series[s].name, name) == 0)
            return &plot->series[s];
    return NULL;
}

TEST(each_route_has_its_line_as_on_the_plan_up_to_the_time_it_takes) {
    House house;
    case_house(&house, "ube-techno-house", -1, NULL);
    Observation observation = case_run(&house, 1);
    HousePlots plots = house_plots_make(&house, &observation, NULL, NULL, &ALL);
    for (size_t p = 0; p < plots.choice.count; p++) {
        const Plot *plot = &plots.plots[p];
        bool force = strcmp(house_plots_name(plots.choice.indices[p]), "force") == 0; /* no contacts */
        CHECK(plot->series_count == 4 && (force ? plot->note && strcmp(plot->note, "no contact") == 0 : !plot->note));
        for (size_t i = 0; i < house.person_count; i++) {
            const PlotSeries *series = find_series(plot, house.people[i].route->id);
            LocusLook look = people_scene_look(&house, i);
            CHECK(series && series->role == look.role && series->style == look.style);
            CHECK(series && series->count > 100);
            if (series && p < 4)
                CHECK_NEAR(plot_value(series, series->count - 1).x, observation.people[i].time, observation.sample);
        }
        CHECK_TEXT(plot->x.unit, p < 4 ? "s" : "m");
    }
    house_plots_free(&plots);
    observation_free(&observation);
    house_free(&house);
}

TEST(plots_show_the_columns_of_the_trace_and_live_without_it) {
    House house;
    case_house(&house, "bedroom-after-earthquake", -1, NULL);
    Observation observation = case_run(&house, 1);
    size_t last = observation.trace.rows - 1;
    double row[TRACE_COLUMNS];
    memcpy(row, trace_row(&observation.trace, last), sizeof row);
    HousePlots plots = house_plots_make(&house, &observation, NULL, NULL, &ALL);
    observation_free(&observation);
    static const size_t columns[TRACED][2] = {{TRACE_TIME, TRACE_SPEED},
                                              {TRACE_TIME, TRACE_CLEARANCE},
                                              {TRACE_TIME, TRACE_BODY_FORCE},
                                              {TRACE_TIME, TRACE_RING},
                                              {TRACE_OFFSET, TRACE_OFFSET_RATE}};
    for (size_t p = 0; p < TRACED; p++) {
        const PlotSeries *series = &plots.plots[p].series[0];
        CHECK(series->count == last + 1);
        CHECK_NEAR(plot_value(series, last).x, row[columns[p][0]], 0);
        CHECK_NEAR(plot_value(series, last).y, row[columns[p][1]], 0);
    }
    CHECK(plots.plots[2].series_count == plots.plots[1].series_count); /* the body's forces alone */
    house_plots_free(&plots);
    house_free(&house);
}

TEST(points_until_a_time_are_those_at_or_before_it_also_where_time_is_no_axis) {
    House house;
    case_house(&house, "two-chairs-corridor", -1, NULL);
    Observation observation = case_run(&house, 1);
    HousePlots plots = house_plots_make(&house, &observation, NULL, NULL, &ALL);
    const PlotSeries *speed = &plots.plots[0].series[1];
    for (double time = -1; time < observation.time + 2; time += 0.37) {
        size_t expected = 0;
        while (expected < speed->count && plot_value(speed, expected).x <= time)
            expected++;
        for (size_t p = 0; p < TRACED; p++)
            CHECK(house_plots_until(&plots, p, 1, time) == expected);
    }
    CHECK(house_plots_until(&plots, 4, 0, plot_value(speed, 5).x) == 6);
    house_plots_free(&plots);
    observation_free(&observation);
    house_free(&house);
}

TEST(of_many_people_chairs_are_shown_first_and_it_is_said_of_how_many) {
    json_t *plan = case_corridor(3);
    House house;
    for (int i = 0; i < 7; i++)
        case_add_person(plan, "adult", 1.5 + i, i % 2 ? 0.9 : -0.9, 0);
    case_add_person(plan, "manual-chair", 10, 0, 0);
    case_add_person(plan, "manual-chair", 13, 0, 0);
    case_made(&house, plan, -1, NULL);
    Observation observation = case_run(&house, 1);
    HousePlots plots = house_plots_make(&house, &observation, NULL, NULL, &ALL);
    const Plot *plot = &plots.plots[0];
    CHECK(plot->series_count == PEOPLE_SCENE_INDIVIDUALS);
    CHECK_TEXT(plot->note, "6 of 9 people");
    CHECK_TEXT(plot->series[0].name, "H");
    CHECK_TEXT(plot->series[1].name, "I");
    CHECK_TEXT(plot->series[2].name, "A");
    CHECK_TEXT(plot->series[0].heading, "p8"); /* the files keep the ids */
    for (size_t a = 0; a < plot->series_count; a++)
        for (size_t b = 0; b < a; b++)
            CHECK(plot->series[a].role != plot->series[b].role || plot->series[a].width != plot->series[b].width);
    house_plots_free(&plots);
    observation_free(&observation);
    house_free(&house);
}

TEST(a_run_in_which_nobody_sets_off_says_so) {
    House house;
    case_house(&house, "flat-0.910-module", -1, NULL);
    Observation observation = case_run(&house, 1);
    HousePlots plots = house_plots_make(&house, &observation, NULL, NULL, &ALL);
    CHECK_TEXT(plots.plots[0].note, "nobody starts");
    house_plots_free(&plots);
    observation_free(&observation);
    house_free(&house);
}

static bool has_guide(const Plot *plot, const char *name, double at) {
    for (size_t g = 0; g < plot->guide_count; g++)
        if (plot->guides[g].name && strcmp(plot->guides[g].name, name) == 0 && plot->guides[g].at == at)
            return true;
    return false;
}

TEST(what_was_before_lies_below_dashed_and_has_one_name) {
    House now, before;
    case_house(&now, "two-chairs-corridor", -1, NULL);
    case_house(&before, "two-chairs-corridor", -1, (const char *[]){"run.clearance_warning=0.11", NULL});
    Observation first = case_run(&now, 1), second = case_run(&before, 1);
    HousePlots plots = house_plots_make(&now, &first, &before, &second, &ALL);
    const Plot *clearance = &plots.plots[1];
    CHECK(clearance->series_count == 4);
    CHECK_TEXT(clearance->series[0].name, "before");
    CHECK(!clearance->series[1].name);
    CHECK_TEXT(clearance->series[0].heading, "eastwards before");
    CHECK_TEXT(clearance->series[1].heading, "westwards before");
    for (int s = 0; s < 2; s++)
        CHECK(clearance->series[s].role == ROLE_GHOST && clearance->series[s].style == LINE_DASHED);
    CHECK(clearance->series[2].role != ROLE_GHOST && clearance->series[3].role != ROLE_GHOST);
    CHECK(has_guide(clearance, "danger below", now.plan.run.clearance_warning));
    CHECK(has_guide(&plots.plots[0], "free speed", now.people[0].speed));
    CHECK(!has_guide(&plots.plots[2], "danger above", now.plan.run.force_warning));
    house_plots_free(&plots);
    observation_free(&first);
    observation_free(&second);
    house_free(&now);
    house_free(&before);
}

TEST(a_house_without_people_has_empty_plots_and_a_record_with_its_columns) {
    House house;
    case_made(&house, case_corridor(2), -1, NULL);
    Observation observation = case_run(&house, 1);
    CHECK(observation.trace.width == TRACE_COLUMNS && observation.trace.rows == 0);
    HousePlots plots = house_plots_make(&house, &observation, NULL, NULL, &ALL);
    for (size_t p = 0; p < plots.choice.count; p++) {
        CHECK(plots.plots[p].series_count == 0);
        CHECK_TEXT(plots.plots[p].x.unit, p < 4 ? "s" : "m");
        CHECK_TEXT(plots.plots[p].note, "nobody starts");
    }
    house_plots_free(&plots);
    observation_free(&observation);
    house_free(&house);
}

TEST(the_people_out_are_counted_at_their_times_and_by_their_exits) {
    static const PlotChoice crowd = {{5, 6}, 2};
    House house;
    case_house(&house, "two-chairs-corridor", -1, NULL);
    Observation observation = case_run(&house, 1);
    HousePlots plots = house_plots_make(&house, &observation, NULL, NULL, &crowd);
    const PlotSeries *out = &plots.plots[0].series[0];
    double first = fmin(observation.people[0].time, observation.people[1].time);
    CHECK_NEAR(plot_value(out, out->count - 1).y, 2, 0);
    for (size_t i = 0; i < out->count; i++)
        CHECK(plot_value(out, i).y <= (plot_value(out, i).x < first              ? 0
                                       : plot_value(out, i).x < observation.time ? 1
                                                                                 : 2));
    double people = 0;
    for (size_t e = 0; e < plots.plots[1].series_count; e++) {
        const PlotSeries *flow = &plots.plots[1].series[e];
        double step = plot_value(flow, 1).x - plot_value(flow, 0).x;
        for (size_t i = 0; i < flow->count; i++)
            people += step * plot_value(flow, i).y;
    }
    CHECK(people <= 2 && people >= 0);
    size_t before = house_plots_until(&plots, 0, 0, first / 2);
    CHECK(before > 0 && before < out->count && plot_value(out, before - 1).y == 0);
    house_plots_free(&plots);
    observation_free(&observation);
    house_free(&house);
}

/* The curve has a point at most a sample before any time, also while nobody leaves. */
TEST(people_out_go_on_with_the_clock_while_nobody_leaves) {
    enum { PEOPLE = 3 };
    PersonObservation people[PEOPLE] = {{.took_part = true, .completed = true, .time = 1},
                                        {.took_part = true, .completed = true, .time = 100},
                                        {.took_part = true, .time = 400}};
    Observation observation = {.people = people, .person_count = PEOPLE, .time = 400};
    House house = {.person_count = PEOPLE};
    Plot plot = {.title = NULL};
    Arena arena = {0};
    crowd_plots_out(&plot, &house, &observation, NULL, NULL, &arena);
    const PlotSeries *series = &plot.series[0];
    CHECK(plot.series_count == 1 && series->count > 300);
    for (size_t i = 0; i < series->count; i++) {
        Vec2 value = plot_value(series, i), before = i ? plot_value(series, i - 1) : value;
        CHECK(value.x - before.x >= 0 && value.x - before.x <= 1.001);
        CHECK(value.y >= (value.x > 1) + (value.x > 100) && value.y <= (value.x >= 1) + (value.x >= 100));
    }
    CHECK(plot_value(series, series->count - 1).x == 400);
    arena_clear(&arena);
}
