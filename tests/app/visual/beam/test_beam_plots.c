#include "beam/beam_cycle.h"
#include "check.h"

#include <string.h>
#include <unistd.h>

#include "scratch.h"
#include "visual/beam/beam_plots.h"

static const PlotChoice ALL = {{0, 1, 2, 3, 4, 5}, BEAM_PLOTS_KNOWN};

/* The shipped beam at another frequency. */
static void run_beam(Response *response, Beam *beam, const char *setting) {
    Rig rig;
    Fault fault = {0};
    *beam = (Beam){0};
    CHECK(beam_read(beam, scratch_source("assets/beams/ibs.json"), &setting, 1, &fault));
    CHECK(rig_build(&rig, beam, "beam", &fault));
    beam_cycle_respond(response, &rig, beam, NULL, NULL);
    rig_clear(&rig);
}

static const Plot *find_plot(const BeamPlots *plots, const char *name) {
    for (size_t i = 0; i < plots->choice.count; i++)
        if (strcmp(beam_plots_name(plots->choice.indices[i]), name) == 0)
            return &plots->plots[i];
    return NULL;
}

TEST(words_choose_plots_of_a_beam) {
    PlotChoice choice;
    char fault[PLOT_CHOICE_FAULT];
    CHECK(beam_plots_choose(&choice, BEAM_PLOTS_USUAL, fault) && choice.count == 3);
    CHECK(beam_plots_choose(&choice, BEAM_PLOTS_NAMES, fault) && choice.count == BEAM_PLOTS_KNOWN);
    CHECK(!beam_plots_choose(&choice, "speed", fault));
    CHECK_TEXT(fault, "no plot \"speed\": plots are phase, poincare, force, displacement, velocity, spectrum");
}

TEST(plots_show_the_trace_in_mm_and_ms_and_live_without_it) {
    Beam beam;
    Response response;
    run_beam(&response, &beam, "drive.frequency=300");
    size_t last = response.trace.rows - 1, shown = 8 * BEAM_SAMPLES;
    double row[4];
    memcpy(row, trace_row(&response.trace, last), sizeof row);
    BeamPlots plots = beam_plots_make(&response, &beam, NULL, &ALL);
    size_t analysed = response.analysed.count, end = RESPONSE_TRACE_CYCLES - 1;
    double deflection = response.section.deflection[end], velocity = response.section.velocity[end];
    response_clear(&response);
    const PlotSeries *force = &find_plot(&plots, "force")->series[0];
    CHECK(force->count == shown);
    CHECK_NEAR(plot_value(force, 0).x, 0, 0);
    CHECK_NEAR(plot_value(force, shown - 1).x, (8 - 1.0 / BEAM_SAMPLES) * 1000 / 300, 1e-9);
    CHECK_NEAR(plot_value(force, shown - 1).y, row[3], 0);
    const PlotSeries *tip = &find_plot(&plots, "phase")->series[0];
    CHECK_NEAR(plot_value(tip, tip->count - 1).x, 1000 * deflection, 1e-9); /* a cycle from its recorded state */
    CHECK_NEAR(plot_value(tip, tip->count - 1).y, velocity, 1e-9);
    CHECK(analysed >= BEAM_CYCLES_LEAST && find_plot(&plots, "poincare")->series[0].count == analysed);
    beam_plots_free(&plots);
    beam_free(&beam);
}

/* The force of the dashpot makes a corner where the tip touches: the line has a point there, and is fine elsewhere. */
TEST(the_line_of_the_phase_plane_has_its_corners_at_the_stops) {
    Beam beam;
    Response response;
    run_beam(&response, &beam, "drive.frequency=190");
    BeamPlots plots = beam_plots_make(&response, &beam, NULL, &ALL);
    const PlotSeries *tip = &find_plot(&plots, "phase")->series[0];
    size_t touches = 0;
    double farthest = 0;
    for (size_t i = 1; i < tip->count; i++) {
        Vec2 from = plot_value(tip, i - 1), to = plot_value(tip, i);
        touches += fabs(fabs(to.x) - 1000 * beam.clearance) < 1e-12;
        farthest = fmax(farthest, hypot((to.x - from.x) / 0.35, (to.y - from.y) / 2)); /* of the plot */
    }
    CHECK(touches >= 60 * 2);
    CHECK(farthest < 0.07); /* in 8 us after a touch; from sample to sample it was 0.16 */
    beam_plots_free(&plots);
    response_clear(&response);
    beam_free(&beam);
}

TEST(the_phase_plane_has_the_clearance_s_edges_and_the_section_s_points) {
    Beam beam;
    Response response;
    run_beam(&response, &beam, "drive.frequency=190");
    BeamPlots plots = beam_plots_make(&response, &beam, NULL, &ALL);
    const Plot *phase = find_plot(&plots, "phase");
    bool edges[2] = {false, false};
    for (size_t g = 0; g < phase->guide_count; g++)
        for (int side = 0; side < 2; side++)
            edges[side] = edges[side] || (!phase->guides[g].band && phase->guides[g].upright &&
                                          phase->guides[g].at == (side ? -1000 : 1000) * beam.clearance);
    CHECK(edges[0] && edges[1]);
    const PlotSeries *section = &phase->series[1];
    size_t last = response.section.count - 2; /* the section is sampled at the ends of cycles */
    CHECK(section->count == 60);
    CHECK_NEAR(plot_value(section, section->count - 1).x, 1000 * response.section.deflection[last], 1e-9);
    CHECK_NEAR(plot_value(section, section->count - 1).y, response.section.velocity[last], 1e-9);
    beam_plots_free(&plots);
    response_clear(&response);
    beam_free(&beam);
}

TEST(without_contact_the_spectrum_has_the_free_amplitude_at_the_drive_alone) {
    Beam beam;
    Response response;
    Rig rig;
    Fault fault = {0};
    run_beam(&response, &beam, "drive.force=0.5");
    CHECK(rig_build(&rig, &beam, "beam", &fault));
    BeamPlots plots = beam_plots_make(&response, &beam, NULL, &ALL);
    const PlotSeries *lines = &find_plot(&plots, "spectrum")->series[0];
    CHECK(response.peaks.count == 0);
    size_t most = 0;
    for (size_t i = 0; i < lines->count; i++)
        most = plot_value(lines, i).y > plot_value(lines, most).y ? i : most;
    CHECK_NEAR(plot_value(lines, most).x, beam.frequency, 1e-6);
    CHECK_NEAR(plot_value(lines, most).y, 1000 * rig_free_amplitude(&rig), 1e-6 * 1000 * rig_free_amplitude(&rig));
    CHECK(strstr(find_plot(&plots, "force")->title, "no contact"));
    beam_plots_free(&plots);
    rig_clear(&rig);
    response_clear(&response);
    beam_free(&beam);
}

TEST(measured_points_lie_over_the_plots_that_have_both_their_quantities) {
    Beam beam;
    Response response;
    Measured measured = {0};
    Fault fault = {0};
    char path[SCRATCH_PATH];
    size_t count;
    const MeasuredKind *kinds = beam_plots_kinds(&count);
    scratch_write(path, "deflection [mm],velocity [m/s]\n0.1,-0.5\n");
    CHECK(measured_read(&measured, path, kinds, count, &fault));
    unlink(path);
    run_beam(&response, &beam, "drive.frequency=190");
    BeamPlots plots = beam_plots_make(&response, &beam, &measured, &ALL);
    static const char *const with[] = {"phase", "poincare"};
    for (int i = 0; i < 2; i++) {
        const Plot *plot = find_plot(&plots, with[i]);
        const PlotSeries *last = &plot->series[plot->series_count - 1];
        CHECK(last->open && last->count == 1);
        CHECK_TEXT(last->name, "measured");
        CHECK_NEAR(plot_value(last, 0).x, 0.1, 1e-12);
        CHECK_NEAR(plot_value(last, 0).y, -0.5, 0);
    }
    CHECK(find_plot(&plots, "force")->series_count == 1);
    beam_plots_free(&plots);
    measured_free(&measured);
    response_clear(&response);
    beam_free(&beam);
}
