#include "check.h"

#include <math.h>
#include <string.h>

#include "plot/plot_ticks.h"

typedef struct Range {
    double low, high;
    int most;
} Range;

static const Range ranges[] = {{0, 1, 4},
                               {0, 18.4, 6},
                               {-0.3, 0.7, 5},
                               {-7, -2, 3},
                               {1e-9, 3.7e-9, 5},
                               {-2e12, 5.5e12, 6},
                               {0.31, 0.32, 2},
                               {0, 0, 5},
                               {42, 42, 5},
                               {-42, -42, 5},
                               {1e12, 1e12, 4},
                               {1e-9, 1e-9, 4},
                               {NAN, 1, 5},
                               {0, NAN, 5},
                               {-INFINITY, 3, 5},
                               {2, INFINITY, 5},
                               {INFINITY, -INFINITY, 5},
                               {1e9, 1e9 + 1e-3, 5},
                               {0, 1e300, 5},
                               {5e-324, 1e-320, 5},
                               {0, 1, 1},
                               {0, 100, 40},
                               {99.9999, 100.1, 7},
                               {3, 1, 5}};

static bool is_round(const PlotTicks *ticks) {
    return ticks->multiple == 1 || ticks->multiple == 2 || ticks->multiple == 5 ||
           (ticks->multiple == 4 && ticks->count <= 3);
}

TEST(ticks_are_few_round_increasing_and_within_their_axis) {
    for (size_t i = 0; i < sizeof ranges / sizeof *ranges; i++)
        for (int widened = 0; widened <= 1; widened++) {
            PlotTicks ticks = plot_ticks_make(ranges[i].low, ranges[i].high, ranges[i].most, widened);
            double slack = 1e-6 * (ticks.high - ticks.low);
            CHECK(is_round(&ticks));
            CHECK(isfinite(ticks.low) && isfinite(ticks.high) && ticks.low < ticks.high);
            CHECK(ticks.count <= (ranges[i].most > 3 ? ranges[i].most : 3) && ticks.count >= 2);
            for (int t = 0; t < ticks.count; t++) {
                double at = plot_ticks_at(&ticks, t);
                CHECK(at >= ticks.low - slack && at <= ticks.high + slack);
                CHECK(t == 0 || at > plot_ticks_at(&ticks, t - 1));
            }
        }
}

TEST(no_axis_has_a_single_tick) {
    for (int low = -400; low < 400; low += 7)
        for (int span = 1; span < 400; span = span * 5 / 4 + 1)
            for (int most = 1; most < 6; most++)
                for (int widened = 0; widened <= 1; widened++) {
                    int largest = most > 3 ? most : 3;
                    PlotTicks ticks = plot_ticks_make(low / 100.0, (low + span) / 100.0, most, widened);
                    CHECK(ticks.count >= 2 && ticks.count <= largest);
                    ticks =
                        plot_ticks_make_logarithmic(pow(10, low / 100.0), pow(10, (low + span) / 100.0), most, widened);
                    CHECK(ticks.count >= 2 && ticks.count <= largest);
                    for (int t = 0; t < ticks.count; t++) {
                        double part = plot_ticks_part(&ticks, plot_ticks_at(&ticks, t));
                        CHECK(part > -1e-6 && part < 1 + 1e-6);
                    }
                }
}

TEST(widened_axes_cover_what_they_show_and_no_more_than_a_step_beyond) {
    for (size_t i = 0; i < sizeof ranges / sizeof *ranges; i++) {
        double low = ranges[i].low, high = ranges[i].high;
        if (!(high > low) || !isfinite(low) || !isfinite(high) || high > 1e100 || high < 1e-100 ||
            high - low < 1e-6 * fabs(high))
            continue;
        PlotTicks ticks = plot_ticks_make(low, high, ranges[i].most, true);
        double step = ticks.multiple * pow(10, ticks.exponent), slack = 1e-8 * step;
        CHECK(ticks.low <= low + slack && ticks.high >= high - slack);
        CHECK(ticks.low > low - step && ticks.high < high + step);
    }
}

TEST(one_value_is_shown_from_nought_on) {
    PlotTicks above = plot_ticks_make(42, 42, 5, true), below = plot_ticks_make(-42, -42, 5, true);
    CHECK_NEAR(above.low, 0, 0);
    CHECK(above.high >= 42 && above.high <= 50);
    CHECK_NEAR(below.high, 0, 0);
    CHECK_NEAR(below.low, -above.high, 0);
}

TEST(labels_say_exactly_where_their_ticks_are) {
    static const struct {
        Range range;
        const char *labels; /* of all ticks */
        const char *title;
    } cases[] = {{{0, 1, 6}, "0 0.2 0.4 0.6 0.8 1.0", "force, N"},
                 {{-1, 1, 3}, "\u22121 0 1", "force, N"},
                 {{0, 30000, 4}, "0 10\u2009000 20\u2009000 30\u2009000", "force, N"},
                 {{0, 9000, 4}, "0 5000", "force, N"},
                 {{0, 3e6, 4}, "0 1 2 3", "force, 10\u2076 N"},
                 {{1.5e5, 2.5e5, 3}, "150 200 250", "force, 10\u00B3 N"},
                 {{0, 2e-9, 3}, "0 1 2", "force, 10\u207B\u2079 N"},
                 {{-4e12, 0, 3}, "\u22124 \u22122 0", "force, 10\u00B9\u00B2 N"},
                 {{0.05, 0.06, 3}, "0.050 0.055 0.060", "force, N"}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        PlotTicks ticks = plot_ticks_make(cases[i].range.low, cases[i].range.high, cases[i].range.most, false);
        char all[512] = "", title[PLOT_TICKS_TITLE];
        for (int t = 0; t < ticks.count; t++) {
            char label[PLOT_TICKS_LABEL];
            plot_ticks_label(&ticks, t, label);
            strcat(strcat(all, t ? " " : ""), label);
        }
        CHECK_TEXT(all, cases[i].labels);
        plot_ticks_title(&ticks, "force", "N", title);
        CHECK_TEXT(title, cases[i].title);
    }
}

TEST(the_power_in_the_title_does_not_depend_on_the_number_of_ticks) {
    static const double highs[] = {60000, 99999, 100000, 5e-4, 9.99e-4, 7e8};
    for (size_t i = 0; i < sizeof highs / sizeof *highs; i++)
        for (int most = 2; most < 12; most++)
            CHECK(plot_ticks_make(0, highs[i], most, true).power == plot_ticks_make(0, highs[i], 20, true).power);
}

TEST(a_pure_number_has_no_unit) {
    PlotTicks plain = plot_ticks_make(0, 1, 5, true), large = plot_ticks_make(0, 1e6, 5, true);
    char title[PLOT_TICKS_TITLE];
    plot_ticks_title(&plain, "ratio", "1", title);
    CHECK_TEXT(title, "ratio");
    plot_ticks_title(&large, "count", NULL, title);
    CHECK_TEXT(title, "count, 10\u2076");
    plot_ticks_title(&plain, NULL, "m", title);
    CHECK_TEXT(title, "m");
}

TEST(logarithmic_ticks_are_powers_of_ten_or_one_two_and_five_of_them) {
    static const struct {
        double low, high;
        int most;
        bool widened;
        const char *labels;
    } cases[] = {{1, 1000, 6, true, "1 10 100 1000"},
                 {0.02, 7, 12, true, "0.02 0.05 0.1 0.2 0.5 1 2 5 10"},
                 {1e-6, 1, 4, false, "10\u207B\u2076 10\u207B\u2074 10\u207B\u00B2 10\u2070"},
                 {3, 400, 8, false, "5 10 20 50 100 200"},
                 {-1, NAN, 5, true, "0.1 0.2 0.5 1"},
                 {7, 7, 5, true, "5 10"}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        PlotTicks ticks = plot_ticks_make_logarithmic(cases[i].low, cases[i].high, cases[i].most, cases[i].widened);
        char all[512] = "";
        for (int t = 0; t < ticks.count; t++) {
            char label[PLOT_TICKS_LABEL];
            plot_ticks_label(&ticks, t, label);
            strcat(strcat(all, t ? " " : ""), label);
            double part = plot_ticks_part(&ticks, plot_ticks_at(&ticks, t));
            CHECK(part > -1e-9 && part < 1 + 1e-9);
        }
        CHECK_TEXT(all, cases[i].labels);
        CHECK(ticks.low < ticks.high);
    }
}

TEST(equal_ratios_are_equally_far_apart_on_a_logarithmic_axis) {
    PlotTicks ticks = plot_ticks_make_logarithmic(1e-3, 1e3, 7, true);
    CHECK_NEAR(plot_ticks_part(&ticks, 1), 0.5, 1e-12);
    CHECK_NEAR(plot_ticks_part(&ticks, 20) - plot_ticks_part(&ticks, 2), 1.0 / 6, 1e-12);
    CHECK(plot_ticks_part(&ticks, 0) < -1e9 && plot_ticks_part(&ticks, -1) < -1e9);
}
