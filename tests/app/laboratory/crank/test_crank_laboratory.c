/* Tests the running crank: its record is the motion computed without a window, a time always looks the same, changes
 * lead on, and invalid values change nothing. */

#include <math.h>
#include <string.h>
#include <time.h>

#include "base/digest.h"
#include "check.h"
#include "cranks.h"
#include "laboratory/crank/tape.h"
#include "laboratory/crank/crank_machine.h"
#include "laboratory/laboratory.h"
#include "laboratory/machine/map_cells.h"
#include "scratch.h"

static const Laboratory *const laboratory = &crank_laboratory;

static void *open_crank(const char *const *settings, size_t count) {
    Fault fault = {0};
    LaboratoryOptions options = {.settings = settings, .setting_count = count, .driving = -1, .jobs = 2};
    void *session = laboratory->open(scratch_source("assets/cranks/ssc.json"), &options, &fault);
    CHECK(session != NULL);
    check_say(&fault);
    return session;
}

static void show_at(void *session, double time) {
    while (laboratory->reach(session, time) <= time && !laboratory->span(session).complete) {
    }
    laboratory->show(session, fmin(time, laboratory->span(session).end));
}

static uint64_t digest_of(void *session) {
    uint64_t digest = DIGEST_START;
    const Scene *scenes[] = {laboratory->still(session), laboratory->moving(session)};
    for (size_t k = 0; k < 2; k++)
        for (size_t p = 0; p < scenes[k]->count; p++)
            for (size_t i = 0; i < scenes[k]->primitives[p].count; i++)
                digest = digest_pair(digest, scenes[k]->primitives[p].points[i]);
    return digest;
}

TEST(the_record_is_the_motion_to_the_bit) {
    enum { TURNS = 5 };
    Crank crank = cranks_read(NULL);
    Tree tree = tree_of(&crank);
    Turn turn = turn_create(&tree, TURN_QUICK);
    CrankTape tape;
    crank_tape_open(&tape, &crank);
    for (size_t i = 0; i < TURNS; i++) {
        double tip[2];
        CHECK(crank_tape_advance(&tape));
        turn.peak[0] = 0;
        turn_cycle(&turn);
        crank_cycle_tip(&turn, tip);
        CHECK_NEAR(crank_tape_return(&tape, i)->peak, turn.peak[0], 0);
        CHECK_NEAR(crank_tape_return(&tape, i + 1)->along, tip[0], 0);
        CHECK_NEAR(crank_tape_return(&tape, i + 1)->along_rate, tip[1], 0);
        CHECK(crank_tape_cycle(&tape, i)->row_count == CRANK_TAPE_ROWS);
    }
    CHECK_NEAR(tape.front_time, TURNS * tree.period, 1e-12);
    crank_tape_close(&tape);
    crank_free(&crank);
}

TEST(memory_is_limited_and_what_is_forgotten_is_not_looked_for) {
    Crank crank = cranks_read((const char *const[]){"joint.clearance=0", "coupler.modes=0", NULL});
    CrankTape tape;
    size_t row;
    crank_tape_open(&tape, &crank);
    for (size_t i = 0; i < CRANK_TAPE_CYCLES + 20; i++)
        CHECK(crank_tape_advance(&tape));
    CHECK(tape.first == 20 && tape.front == CRANK_TAPE_CYCLES + 20);
    CHECK(crank_tape_cycle_at(&tape, 0, &row) == 20 && row == 0);
    CHECK(crank_tape_cycle_at(&tape, 1e9, &row) == tape.front - 1);
    CHECK(crank_tape_first_return(&tape) == 0);
    crank_tape_change(&tape, &crank, 100);
    CHECK(tape.front == 100 && crank_tape_advance(&tape));
    CHECK(crank_tape_first_return(&tape) == 100 && tape.part_count == 2);
    crank_tape_close(&tape);
    crank_free(&crank);
}

TEST(a_motor_is_recorded_too) {
    Crank crank = cranks_read((const char *const[]){"drive.motor=0.05", NULL});
    CrankTape tape;
    crank_tape_open(&tape, &crank);
    for (size_t i = 0; i < 3; i++)
        CHECK(crank_tape_advance(&tape));
    const CrankTapeCycle *cycle = crank_tape_cycle(&tape, 2);
    CHECK(cycle->row_count > 0);
    CHECK_NEAR(crank_tape_row(cycle, cycle->row_count - 1)[CRANK_TAPE_ANGLE], 2 * M_PI, 0.01);
    crank_tape_close(&tape);
    crank_free(&crank);
}

TEST(a_time_looks_the_same_whenever_it_is_shown) {
    enum { TIMES = 6 };
    static const size_t order[TIMES] = {4, 0, 5, 2, 2, 1};
    void *session = open_crank(NULL, 0);
    uint64_t pictures[TIMES];
    double end = 4 * 60 / 700.;
    for (size_t i = 0; i < TIMES; i++) {
        show_at(session, end * ((double)i + 0.37) / TIMES);
        pictures[i] = digest_of(session);
    }
    for (size_t i = 0; i < TIMES; i++) {
        show_at(session, end * ((double)order[i] + 0.37) / TIMES);
        CHECK(digest_of(session) == pictures[order[i]]);
    }
    laboratory->close(session);
}

TEST(a_change_leads_on_and_the_record_before_stays) {
    void *session = open_crank(NULL, 0);
    Fault fault = {0};
    size_t count;
    show_at(session, 0.1);
    uint64_t before = digest_of(session);
    show_at(session, 0.2);
    CHECK(laboratory->set(session, "drive.frequency", 10, &fault));
    show_at(session, 0.5);
    const TimelineMark *marks = laboratory->marks(session, &count);
    CHECK(count == 1 && marks[0].kind == TIMELINE_CHANGE);
    CHECK_NEAR(marks[0].time, 3 * 60 / 700., 1e-9);
    show_at(session, 0.1);
    CHECK(digest_of(session) == before);
    CHECK(laboratory->set(session, "coupler.modes", 1, &fault)); /* the state cannot be carried on */
    show_at(session, 0.5);
    CHECK(laboratory->span(session).end > 0.5);
    laboratory->restart(session);
    CHECK(laboratory->span(session).begin == 0 && laboratory->span(session).end < 0.2);
    laboratory->close(session);
}

TEST(a_bad_value_is_a_fault_and_changes_nothing) {
    static const struct {
        const char *name;
        double value;
    } bad[] = {{"drive.frequency", 1e9}, {"drive.frequency", NAN}, {"coupler.length", 0.01}, {"coupler.modes", 2.5},
               {"coupler.modes", 60},    {"joint.release", 2},     {"no.such", 1},           {"slider.mass", -1}};
    void *session = open_crank(NULL, 0);
    size_t count;
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        Fault fault = {0};
        CHECK(!laboratory->set(session, bad[i].name, bad[i].value, &fault));
        CHECK(fault.count >= 1);
        fault_clear(&fault);
    }
    laboratory->command(session, &count);
    CHECK(count == 2);
    laboratory->close(session);
}

TEST(every_number_can_be_set_to_the_ends_of_its_slider_or_says_why_not) {
    void *session = open_crank(NULL, 0);
    size_t count;
    const PanelParameter *parameters = laboratory->parameters(session, &count);
    for (size_t i = 0; i < count; i++) {
        CHECK(parameters[i].low < parameters[i].high);
        CHECK(parameters[i].initial >= parameters[i].low && parameters[i].initial <= parameters[i].high);
        CHECK(*parameters[i].group);
        const double values[] = {parameters[i].low, parameters[i].high, parameters[i].initial};
        for (int v = 0; v < 3; v++) {
            Fault fault = {0};
            CHECK(laboratory->set(session, parameters[i].name, values[v], &fault) || fault.count > 0);
            fault_clear(&fault);
        }
    }
    laboratory->close(session);
}

TEST(presets_layers_sights_and_the_command) {
    void *session = open_crank(NULL, 0);
    size_t count;
    CHECK(laboratory->presets(session, &count) && count == 3);
    laboratory->apply_preset(session, 1);
    const char *const *words = laboratory->command(session, &count);
    CHECK(count == 6);
    CHECK_TEXT(words[3], "drive.frequency=10");
    CHECK_TEXT(words[5], "joint.clearance=0.0001");
    show_at(session, 0.3);
    laboratory->update(session, 0.3);
    size_t whole = laboratory->still(session)->count;
    laboratory->set_layers(session, 0);
    CHECK(laboratory->update(session, 0.3) & LABORATORY_VIEW);
    CHECK(laboratory->still(session)->count < whole);
    laboratory->set_layers(session, laboratory->layers_at_first);
    uint64_t side = digest_of(session);
    laboratory->choose(session, 2, 1);
    CHECK(digest_of(session) != side);
    laboratory->choose(session, 2, 0);
    CHECK(digest_of(session) == side);
    laboratory->close(session);
}

TEST(plots_show_what_was_recorded_until_then) {
    void *session = open_crank(NULL, 0);
    double period = 60 / 700.;
    show_at(session, 4.5 * period);
    for (size_t p = 0; p + 1 < laboratory->plot_count(session); p++) {
        LaboratoryPlot plot = laboratory->plot(session, p);
        for (size_t s = 0; s < plot.plot->series_count; s++) {
            size_t now = laboratory->points_until(session, p, s, 4.5 * period);
            CHECK(now <= plot.plot->series[s].count);
            CHECK(laboratory->points_until(session, p, s, 4.1 * period) <= now);
        }
    }
    CHECK(laboratory->points_until(session, 1, 0, 4.5 * period) == 5);
    laboratory->clear_runs(session, 4.5 * period);
    CHECK(laboratory->points_until(session, 1, 0, 4.5 * period) == 1);
    laboratory->close(session);
}

TEST(the_sound_is_the_velocity_of_the_slider) {
    enum { COUNT = 200 };
    void *session = open_crank(NULL, 0);
    float samples[COUNT], least = 0, most = 0;
    show_at(session, 0.5);
    CHECK(laboratory->sound(session, 0.1, 0.2, samples, COUNT));
    for (int i = 0; i < COUNT; i++) {
        least = fminf(least, samples[i]);
        most = fmaxf(most, samples[i]);
    }
    CHECK(least >= -1 && most <= 1 && most - least > 0.5f);
    CHECK(!laboratory->sound(session, 0.4, 9, samples, COUNT));
    laboratory->close(session);
}

TEST(a_map_goes_from_coarse_to_fine_and_has_each_cell_once) {
    bool seen[MACHINE_MAP_CELLS] = {false};
    size_t cells = machine_map_cells_count(&crank_machine), columns = crank_machine.map[0].steps;
    CHECK(cells == 117 && cells <= MACHINE_MAP_CELLS);
    for (size_t nth = 0; nth < cells; nth++) {
        size_t cell = machine_map_cells_nth(&crank_machine, nth);
        CHECK(cell < cells && !seen[cell]);
        seen[cell] = true;
        CHECK(nth >= 12 || (cell % columns % 4 == 0 && cell / columns % 4 == 0));
    }
    CHECK_NEAR(machine_map_cells_value(&crank_machine, 0, 0) * 60, 300, 1e-9);
    CHECK_NEAR(machine_map_cells_value(&crank_machine, 0, cells - 1) * 60, 1500, 1e-9);
    CHECK_NEAR(machine_map_cells_value(&crank_machine, 1, columns - 1), 0.02e-3, 1e-15);
    CHECK_NEAR(machine_map_cells_value(&crank_machine, 1, cells - 1), 0.5e-3, 1e-15);
}

/* 500 rpm with 0.02 mm and 700 rpm with 0.26 mm: the presets of types I and III, or nearly so. */
TEST(cells_of_a_map_have_the_types_of_the_presets) {
    Crank crank = cranks_read((const char *const[]){"run.transient_cycles=30", NULL});
    Machine machine = {.crank = crank};
    size_t columns = crank_machine.map[0].steps;
    CHECK(machine_map_cells_type(&crank_machine, &machine, 2, 2, NULL) == TYPES_I);
    TypesKind third = machine_map_cells_type(&crank_machine, &machine, 4 * columns + 4, 1, NULL);
    CHECK(third == TYPES_III);
    CHECK(machine_map_cells_type(&crank_machine, &machine, 4 * columns + 4, 2, NULL) == third);
    crank_free(&crank);
}

/* The map is computed only while it is in the window, and then replaces nothing that a click changed. */
LONG_TEST(the_map_is_computed_while_it_is_shown) {
    enum { LOOKS = 30000 /* every 10 ms: the machine may be busy */ };
    void *session =
        open_crank((const char *const[]){"run.transient_cycles=1", "run.cycles=10", "joint.clearance=0"}, 3);
    size_t map = laboratory->plot_count(session) - 1;
    CHECK_TEXT(laboratory->plot(session, map).name, "map");
    CHECK_TEXT(laboratory->plot(session, map).cursor_y_parameter, "joint.clearance");
    CHECK_NEAR(laboratory->plot(session, map).cursor, 700, 1e-9);
    CHECK_NEAR(laboratory->plot(session, map).cursor_y, 0, 1e-12);
    laboratory->note_plots(session, "phase,map");
    const double *cells = laboratory->plot(session, map).plot->raster->values;
    size_t filled = 0;
    for (int i = 0; i < LOOKS && filled < 2; i++) {
        laboratory->update(session, 0);
        nanosleep(&(struct timespec){0, 10000000}, NULL);
        filled = 0;
        for (size_t c = 0; c < MACHINE_MAP_CELLS; c++)
            filled += !isnan(cells[c]);
    }
    CHECK(filled >= 2 && !isnan(cells[0]));
    laboratory->close(session);
}
