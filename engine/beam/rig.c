#include "beam/rig.h"

#include <math.h>
#include <string.h>

#include "base/memory.h"

/* Z' = lambda Z + drive F sin(omega t) + push R has the steady part
 * -(lambda sin + omega cos) drive F / (lambda^2 + omega^2) - push R / lambda. */
static void make_steady(RigSteady *steady, const Regime *regime, const Rig *rig) {
    double omega = rig->omega, rest = rig->stiffness * rig->clearance;
    for (size_t j = 0; j < regime->blocks; j++) {
        double a = regime->lambda.re[j], b = regime->lambda.im[j];
        double re = a * a - b * b + omega * omega, im = 2 * a * b, size = re * re + im * im;
        double drive_re = rig->force * regime->drive.re[j], drive_im = rig->force * regime->drive.im[j];
        double part_re = -(drive_re * re + drive_im * im) / size, part_im = -(drive_im * re - drive_re * im) / size;
        steady->cosine.re[j] = omega * part_re;
        steady->cosine.im[j] = omega * part_im;
        steady->sine.re[j] = a * part_re - b * part_im;
        steady->sine.im[j] = a * part_im + b * part_re;
        double lambda_size = a * a + b * b;
        steady->rest.re[j] = -rest * (regime->push.re[j] * a + regime->push.im[j] * b) / lambda_size;
        steady->rest.im[j] = -rest * (regime->push.im[j] * a - regime->push.re[j] * b) / lambda_size;
    }
    for (int row = 0; row < REGIME_ROWS; row++) {
        steady->row_sine[row] = regime_measure(regime->blocks, regime->row[row][0], steady->sine);
        steady->row_cosine[row] = regime_measure(regime->blocks, regime->row[row][0], steady->cosine);
        steady->row_rest[row] = regime_measure(regime->blocks, regime->row[row][0], steady->rest);
    }
}

static RigSteady steady_create(const Regime *regime) {
    return (RigSteady){.sine = regime_vector(regime->states),
                       .cosine = regime_vector(regime->states),
                       .rest = regime_vector(regime->states),
                       .hop = regime_vector(regime->states)};
}

static void steady_clear(RigSteady *steady) {
    memory_free(steady->sine.re);
    memory_free(steady->cosine.re);
    memory_free(steady->rest.re);
    memory_free(steady->hop.re);
}

void rig_drive(Rig *rig, double frequency, double force) {
    rig->omega = 2 * M_PI * frequency;
    rig->period = 1 / frequency;
    rig->force = force;
    make_steady(&rig->steady_free, &rig->free, rig);
    make_steady(&rig->steady_contact, &rig->contact, rig);
}

/* A quarter of the shortest period of any mode, free or in contact. */
static double longest_cell(const Rig *rig) {
    double fastest = 0;
    for (size_t j = 0; j < rig->free.blocks; j++)
        fastest = fmax(fastest, fabs(rig->free.lambda.im[j]));
    for (size_t j = 0; j < rig->contact.blocks; j++)
        fastest = fmax(fastest, fabs(rig->contact.lambda.im[j]));
    return fastest > 0 ? M_PI / (2 * fastest) : HUGE_VAL;
}

bool rig_of_modes(Rig *rig, Modes *modes, const Beam *beam) {
    *rig = (Rig){.modes = *modes,
                 .clearance = beam->clearance,
                 .stiffness = beam->contact.normal_stiffness,
                 .damping = beam->contact.normal_damping,
                 .release = beam->release};
    *modes = (Modes){0};
    bool good = regime_build(&rig->free, &rig->modes, &beam->contact, false) &&
                regime_build(&rig->contact, &rig->modes, &beam->contact, true);
    if (!good) {
        rig_clear(rig);
        return false;
    }
    rig->steady_free = steady_create(&rig->free);
    rig->steady_contact = steady_create(&rig->contact);
    rig->cell = fmin(longest_cell(rig), 1 / (16 * beam->frequency));
    regime_propagator(&rig->free, rig->cell, rig->steady_free.hop);
    regime_propagator(&rig->contact, rig->cell, rig->steady_contact.hop);
    rig_drive(rig, beam->frequency, beam->force);
    return true;
}

bool rig_build(Rig *rig, const Beam *beam, const char *place, Fault *fault) {
    Modes modes;
    if (!modes_of_beam(&modes, beam)) {
        fault_add(fault,
                  "%s: the beam has no natural modes that can be told apart: its stiffnesses are too far apart, "
                  "or next to nothing holds it",
                  place);
        return false;
    }
    if (rig_of_modes(rig, &modes, beam))
        return true;
    fault_add(fault,
              "%s: the contact has no eigenvalues that can be told apart: joint.stiffness or joint.damping is "
              "too far from the beam's",
              place);
    return false;
}

void rig_clear(Rig *rig) {
    modes_clear(&rig->modes);
    regime_clear(&rig->free);
    regime_clear(&rig->contact);
    steady_clear(&rig->steady_free);
    steady_clear(&rig->steady_contact);
    *rig = (Rig){0};
}

static RigSteady share_steady(const RigSteady *shared, const Regime *regime) {
    RigSteady own = steady_create(regime);
    memcpy(own.hop.re, shared->hop.re, regime->blocks * sizeof(double));
    memcpy(own.hop.im, shared->hop.im, regime->blocks * sizeof(double));
    return own;
}

Rig rig_share(const Rig *rig, double frequency, double force, double clearance) {
    Rig own = *rig;
    own.clearance = clearance;
    own.steady_free = share_steady(&rig->steady_free, &rig->free);
    own.steady_contact = share_steady(&rig->steady_contact, &rig->contact);
    rig_drive(&own, frequency, force);
    return own;
}

void rig_clear_shared(Rig *rig) {
    steady_clear(&rig->steady_free);
    steady_clear(&rig->steady_contact);
    *rig = (Rig){0};
}

double rig_free_amplitude(const Rig *rig) {
    return hypot(rig->steady_free.row_sine[REGIME_TIP], rig->steady_free.row_cosine[REGIME_TIP]);
}
