#include <math.h>

#include "beam/beam.h"
#include "beam/modes.h"
#include "check.h"
#include "oscillator.h"
#include "scratch.h"

/* A beam of length, bending stiffness and mass per length 1: omega = (beta L)^2. */
static void unit_beam(ElementMesh *mesh, size_t elements) {
    element_build(mesh, 1, 1, 1, elements, NULL, 0);
}

/* Removes a freedom from the mesh, which clamps it. */
static void hold(ElementMesh *mesh, size_t freedom) {
    double *const matrices[] = {mesh->mass, mesh->stiffness, mesh->damping};
    for (size_t m = 0; m < 3; m++) {
        size_t at = 0;
        for (size_t i = 0; i < mesh->freedoms * mesh->freedoms; i++)
            if (i / mesh->freedoms != freedom && i % mesh->freedoms != freedom)
                matrices[m][at++] = matrices[m][i];
    }
    mesh->freedoms--;
}

/* Returns all modes of the mesh without reduction. */
static Modes all_modes(const ElementMesh *mesh) {
    Modes modes;
    CHECK(modes_reduce(&modes, mesh, NULL, 0, mesh->freedoms, mesh->freedoms));
    return modes;
}

TEST(a_cantilever_and_a_pinned_beam_have_their_natural_frequencies) {
    static const double cantilever[] = {1.8751040687, 4.6940911330, 7.8547574382};
    static const double pinned[] = {3.9266023120, 7.0685827456, 10.2101761228};
    for (int is_pinned = 0; is_pinned < 2; is_pinned++) {
        ElementMesh mesh;
        unit_beam(&mesh, 40);
        hold(&mesh, 0);
        if (!is_pinned)
            hold(&mesh, 0);
        Modes modes = all_modes(&mesh);
        for (int i = 0; i < 3; i++) { /* including the known error of the elements */
            double expected = is_pinned ? pinned[i] : cantilever[i], off = pow(expected / 40, 4) / 1440;
            CHECK_NEAR(sqrt(modes.frequency[i + is_pinned] / (1 + off)), expected, 1e-8 * expected);
        }
        if (is_pinned)
            CHECK_NEAR(modes.frequency[0], 0, 1e-2);
        modes_clear(&modes);
        element_clear(&mesh);
    }
}

/* Checks the error (beta L / N)^4 / 1440 on a pinned-free beam's third frequency, low enough that higher orders are
 * negligible. */
TEST(the_error_of_a_frequency_falls_as_the_fourth_power_of_the_element) {
    const double exact = 10.2101761228;
    for (size_t elements = 8; elements <= 32; elements *= 2) {
        ElementMesh mesh;
        unit_beam(&mesh, elements);
        hold(&mesh, 0);
        Modes modes = all_modes(&mesh);
        double error = modes.frequency[3] / (exact * exact) - 1;
        double expected = pow(exact / (double)elements, 4) / 1440;
        CHECK_NEAR(error / expected, 1, 0.12);
        modes_clear(&modes);
        element_clear(&mesh);
    }
}

/* k (1 + cos L cosh L) + L (cos L sinh L - sin L cosh L) = 0 with k = k_r l / EI, L = beta l. */
TEST(a_flexure_pivot_has_the_frequencies_of_its_equation) {
    for (double k = 0.1; k < 1000; k *= 10) {
        ElementMesh mesh;
        unit_beam(&mesh, 100);
        element_add_spring(&mesh, 1, k);
        hold(&mesh, 0);
        Modes modes = all_modes(&mesh);
        for (int i = 0; i < 3; i++) {
            double l = sqrt(modes.frequency[i]);
            double free_end = 1 + cos(l) * cosh(l), pin = cos(l) * sinh(l) - sin(l) * cosh(l);
            CHECK_NEAR((k * free_end + l * pin) / (cosh(l) * (k + l)), 0, 2e-6);
        }
        modes_clear(&modes);
        element_clear(&mesh);
    }
}

/* 1 + cos L cosh L + m L (cos L sinh L - sin L cosh L) = 0 with m the tip's mass by the beam's, L = beta l. */
TEST(a_cantilever_with_a_mass_at_its_tip_has_the_frequencies_of_its_equation) {
    for (double m = 0.01; m < 20; m *= 10) {
        ElementMesh mesh;
        unit_beam(&mesh, 40);
        element_add_mass(&mesh, mesh.freedoms - 2, m);
        hold(&mesh, 0);
        hold(&mesh, 0);
        Modes modes = all_modes(&mesh);
        for (int i = 0; i < 3; i++) {
            double off = pow(sqrt(modes.frequency[i]) / 40, 4) / 1440; /* the known error of the elements */
            double l = sqrt(modes.frequency[i] / (1 + off));
            double free_end = 1 + cos(l) * cosh(l), mass = cos(l) * sinh(l) - sin(l) * cosh(l);
            CHECK_NEAR((free_end + m * l * mass) / (cosh(l) * (1 + m * l)), 0, 2e-6);
        }
        modes_clear(&modes);
        element_clear(&mesh);
    }
}

/* Rayleigh: the first frequency of the shipped beam falls with a mass at its tip, by the mode's own share. */
TEST(a_mass_at_the_tip_of_the_shipped_beam_lowers_its_frequencies) {
    Beam beam = {0};
    Fault fault = {0};
    Modes bare, loaded;
    CHECK(beam_read(&beam, scratch_source("assets/beams/ibs.json"), NULL, 0, &fault));
    CHECK(beam.tip_mass == 0 && modes_of_beam(&bare, &beam));
    beam.tip_mass = 1e-5;
    CHECK(modes_of_beam(&loaded, &beam));
    for (size_t i = 0; i < 4; i++) {
        double expected = -beam.tip_mass * bare.tip[i] * bare.tip[i] / 2;
        CHECK_NEAR((loaded.frequency[i] / bare.frequency[i] - 1) / expected, 1, 1e-2);
    }
    modes_clear(&bare);
    modes_clear(&loaded);
    beam_free(&beam);
}

TEST(stations_are_nodes_and_what_hangs_on_them_counts_once) {
    ElementMesh mesh;
    element_build(&mesh, 2, 1, 1, 7, (double[]){1.3, 0.31, 1.3, 0, 2}, 5);
    CHECK(mesh.freedoms == 2 * mesh.nodes && mesh.nodes >= 8);
    CHECK_NEAR(mesh.place[element_deflection(&mesh, 0.31) / 2], 0.31, 0);
    CHECK_NEAR(mesh.place[element_deflection(&mesh, 1.3) / 2], 1.3, 0);
    for (size_t i = 1; i < mesh.nodes; i++)
        CHECK(mesh.place[i] > mesh.place[i - 1] && mesh.place[i] - mesh.place[i - 1] <= 2.0 / 7 + 1e-9);
    double moved = 0; /* of a rigid motion by 1: the whole mass */
    element_add_mass(&mesh, element_deflection(&mesh, 1.3), 0.5);
    for (size_t i = 0; i < mesh.nodes; i++)
        for (size_t j = 0; j < mesh.nodes; j++)
            moved += mesh.mass[2 * i * mesh.freedoms + 2 * j];
    CHECK_NEAR(moved, 2.5, 1e-12);
    element_clear(&mesh);
}

static Beam shipped(int elements, int modes) {
    Beam beam = {0};
    Fault fault = {0};
    CHECK(beam_read(&beam, scratch_source("assets/beams/ibs.json"), NULL, 0, &fault));
    beam.elements = elements;
    beam.modes = modes;
    return beam;
}

TEST(craig_and_bampton_converge_from_above_and_all_modes_are_the_elements_own) {
    ElementMesh mesh;
    unit_beam(&mesh, 20);
    element_add_spring(&mesh, 0, 1e6);
    element_add_spring(&mesh, 1, 3);
    element_add_spring(&mesh, 20, 50);
    element_add_mass(&mesh, 20, 0.2);
    Modes whole = all_modes(&mesh);
    const size_t boundary[] = {40, 1, 0, 20};
    double before[4] = {HUGE_VAL, HUGE_VAL, HUGE_VAL, HUGE_VAL};
    for (size_t fixed = 0; fixed <= mesh.freedoms; fixed += 2) {
        Modes modes;
        CHECK(modes_reduce(&modes, &mesh, boundary, 4, fixed, mesh.freedoms));
        for (int i = 0; i < 4; i++) {
            CHECK(modes.frequency[i] >= whole.frequency[i] * (1 - 1e-9));
            CHECK(modes.frequency[i] <= before[i] * (1 + 1e-9));
            before[i] = modes.frequency[i];
        }
        if (fixed + 4 >= mesh.freedoms)
            for (size_t i = 0; i < mesh.freedoms; i++)
                CHECK_NEAR(modes.frequency[i] / whole.frequency[i], 1, 1e-10);
        modes_clear(&modes);
    }
    modes_clear(&whole);
    element_clear(&mesh);
}

TEST(the_shipped_beam_has_the_modes_it_was_identified_by) {
    static const double expected[] = {53.9, 419.5, 1378};
    Beam beam = shipped(20, 12);
    Modes modes;
    CHECK(modes_of_beam(&modes, &beam));
    for (int i = 0; i < 3; i++)
        CHECK_NEAR(modes.frequency[i] / (2 * M_PI), expected[i], 0.001 * expected[i]);
    modes_clear(&modes);
    beam_free(&beam);
}

TEST(modes_and_elements_converge) {
    Beam beam = shipped(20, 12), fine_beam = shipped(100, 60);
    Modes modes, fine;
    CHECK(modes_of_beam(&modes, &beam) && modes_of_beam(&fine, &fine_beam));
    for (int i = 0; i < 6; i++)
        CHECK_NEAR(modes.frequency[i] / fine.frequency[i], 1, 1e-3);
    CHECK_NEAR(modes.tip_compliance / fine.tip_compliance, 1, 1e-8);
    modes_clear(&modes);
    modes_clear(&fine);
    beam_free(&beam);
    beam_free(&fine_beam);
}

/* The shaker is as near to the tip as allowed: its short element costs the others little precision. */
static Modes shipped_modes(const char *name, const char *setting) {
    Beam beam = oscillator_beam(name, setting);
    Modes modes;
    CHECK(modes_of_beam(&modes, &beam));
    beam_free(&beam);
    return modes;
}

/* The shipped beams say so of their 20 elements. */
TEST(nine_modes_of_the_shipped_beams_are_exact_to_a_thousandth_and_twelve_to_four_thousandths) {
    static const char *const names[] = {"ibs", "ibs-r"};
    for (int n = 0; n < 2; n++) {
        Modes shipped = shipped_modes(names[n], NULL), fine = shipped_modes(names[n], "beam.elements=120");
        CHECK(shipped.count == 12 && fine.count == 12);
        for (size_t i = 0; i < 12; i++) {
            double off = shipped.frequency[i] / fine.frequency[i] - 1;
            CHECK(off > -1e-9 && off < (i < 9 ? 1e-3 : 4.1e-3));
            CHECK(i < 9 || off > 1.8e-3);
        }
        modes_clear(&shipped);
        modes_clear(&fine);
    }
}

TEST(a_shaker_close_to_the_tip_leaves_the_modes_what_they_are) {
    Beam beam = shipped(20, 12), fine_beam = shipped(200, 12);
    beam.shaker_position = fine_beam.shaker_position = beam.length * (1 - 1.01e-3);
    Modes modes, fine;
    CHECK(modes_of_beam(&modes, &beam) && modes_of_beam(&fine, &fine_beam));
    for (int i = 0; i < 6; i++)
        CHECK_NEAR(modes.frequency[i] / fine.frequency[i], 1, 1e-3);
    modes_clear(&modes);
    modes_clear(&fine);
    beam_free(&beam);
    beam_free(&fine_beam);
}

TEST(twelve_modes_leave_less_than_a_hundredth_of_the_contacts_compliance_and_four_do_not) {
    for (int count = 4; count <= 12; count += 8) {
        Beam beam = shipped(20, count);
        Modes modes;
        CHECK(modes_of_beam(&modes, &beam));
        CHECK(modes.residual > 0);
        CHECK((modes.residual * beam.contact.normal_stiffness < MODES_RESIDUAL_MOST) == (count == 12));
        modes_clear(&modes);
        beam_free(&beam);
    }
}

TEST(a_dashpot_damps_every_mode_by_where_it_stands) {
    Beam beam = shipped(20, 6);
    beam.shaker_damping = 30;
    Modes modes;
    CHECK(modes_of_beam(&modes, &beam));
    for (size_t i = 0; i < modes.count; i++)
        for (size_t j = 0; j < modes.count; j++)
            CHECK_NEAR(modes.damping[i * modes.count + j],
                       30 * modes.shaker[i] * modes.shaker[j] +
                           (i == j ? 2 * beam.damping_ratio * modes.frequency[i] : 0),
                       1e-9 * modes.frequency[modes.count - 1]);
    modes_clear(&modes);
    beam_free(&beam);
}
