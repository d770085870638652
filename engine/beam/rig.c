#include "beam/rig.h"

#include <math.h>

#include "base/memory.h"
#include "base/real.h"

/* Relative difference of lambda^2 and -omega^2 below which a steady part loses its digits: an undamped beam at
 * resonance, whose motion grows without bound. */
static const double RESONANCE = 1e-8;

/* Z' = lambda Z + drive F sin(omega t) + push R has the steady part
 * -(lambda sin + omega cos) drive F / (lambda^2 + omega^2) - push R / lambda; R is `rest`, 0 when free. */
static void make_steady(RigSteady *steady, const Regime *regime, const Rig *rig, double rest) {
    double omega = rig->omega;
    for (size_t j = 0; j < regime->blocks; j++) {
        double a = regime->lambda.re[j], b = regime->lambda.im[j];
        double re = a * a - b * b + omega * omega, im = 2 * a * b, size = re * re + im * im;
        if (size < RESONANCE * RESONANCE * (omega * omega) * (omega * omega))
            size = 0; /* marks a motion that diverges */
        double drive_re = rig->force * regime->drive.re[j], drive_im = rig->force * regime->drive.im[j];
        double part_re = -(drive_re * re + drive_im * im) / size, part_im = -(drive_im * re - drive_re * im) / size;
        steady->cosine.re[j] = omega * part_re;
        steady->cosine.im[j] = omega * part_im;
        steady->sine.re[j] = a * part_re - b * part_im;
        steady->sine.im[j] = a * part_im + b * part_re;
        double lambda_size = a * a + b * b;
        if (lambda_size > 0) {
            steady->rest.re[j] = -rest * (regime->push.re[j] * a + regime->push.im[j] * b) / lambda_size;
            steady->rest.im[j] = -rest * (regime->push.im[j] * a - regime->push.re[j] * b) / lambda_size;
        }
    }
    for (int row = 0; row < REGIME_ROWS; row++) {
        steady->row_sine[row] = regime_measure(regime->blocks, regime->row[row][0], steady->sine);
        steady->row_cosine[row] = regime_measure(regime->blocks, regime->row[row][0], steady->cosine);
        steady->row_rest[row] = regime_measure(regime->blocks, regime->row[row][0], steady->rest);
    }
}

static RigSteady steady_create(const Regime *regime) {
    return (RigSteady){.sine = regime_vector(regime->blocks),
                       .cosine = regime_vector(regime->blocks),
                       .rest = regime_vector(regime->blocks)};
}

static void steady_clear(RigSteady *steady) {
    memory_free(steady->sine.re);
    memory_free(steady->cosine.re);
    memory_free(steady->rest.re);
}

/* Computes C = w' v of each pair of blocks; for a block Z = a + i b, x = a Re v - b Im v. */
static void make_change(RigChange *change, const Regime *before, const Regime *after) {
    change->by_re = regime_vector(before->blocks * after->blocks);
    change->by_im = regime_vector(before->blocks * after->blocks);
    for (size_t j = 0; j < before->blocks; j++)
        for (size_t i = 0; i < before->states; i++) {
            double re = before->shape.re[i * before->blocks + j], im = before->shape.im[i * before->blocks + j];
            for (size_t l = 0; l < after->blocks; l++) {
                size_t at = j * after->blocks + l;
                change->by_re.re[at] += after->part.re[i * after->blocks + l] * re;
                change->by_re.im[at] += after->part.im[i * after->blocks + l] * re;
                change->by_im.re[at] -= after->part.re[i * after->blocks + l] * im;
                change->by_im.im[at] -= after->part.im[i * after->blocks + l] * im;
            }
        }
}

void rig_change_blocks(const RigChange *change, const Regime *before, const Regime *after, RegimeVector z,
                       RegimeVector changed) {
    size_t blocks = after->blocks;
    for (size_t l = 0; l < blocks; l += 2) {
        RegimeTwo re = {0}, im = {0};
        for (size_t j = 0; j < before->blocks; j++) {
            size_t at = j * blocks + l;
            re += *regime_two(change->by_re.re + at) * z.re[j] + *regime_two(change->by_im.re + at) * z.im[j];
            im += *regime_two(change->by_re.im + at) * z.re[j] + *regime_two(change->by_im.im + at) * z.im[j];
        }
        *regime_two(changed.re + l) = re;
        *regime_two(changed.im + l) = im;
    }
}

static void create_jumps(RigChange *change, const Regime *after) {
    change->sine = regime_vector(after->blocks);
    change->cosine = regime_vector(after->blocks);
    change->rest = regime_vector(after->blocks);
}

static void clear_jumps(RigChange *change) {
    memory_free(change->sine.re);
    memory_free(change->cosine.re);
    memory_free(change->rest.re);
}

static void subtract(size_t count, RegimeVector from, RegimeVector what) {
    for (size_t j = 0; j < count; j++) {
        from.re[j] -= what.re[j];
        from.im[j] -= what.im[j];
    }
}

/* Computes the steady part before the switch, in the blocks after it, minus the steady part after it. */
static void make_jumps(RigChange *change, const Regime *before, const RigSteady *steady_before, const Regime *after,
                       const RigSteady *steady_after) {
    rig_change_blocks(change, before, after, steady_before->sine, change->sine);
    rig_change_blocks(change, before, after, steady_before->cosine, change->cosine);
    rig_change_blocks(change, before, after, steady_before->rest, change->rest);
    subtract(after->blocks, change->sine, steady_after->sine);
    subtract(after->blocks, change->cosine, steady_after->cosine);
    subtract(after->blocks, change->rest, steady_after->rest);
}

/* Computes sine and cosine of an angle of at most 2 pi / RIG_CELLS. */
static void take_sine_cosine(double angle, double *sine, double *cosine) {
    double s = angle * angle, s2 = s * s, s4 = s2 * s2;
    *sine = angle * (((1 - s * (1. / 6)) + (1. / 120 - s * (1. / 5040)) * s2) +
                     ((1. / 362880 - s * (1. / 39916800)) + s2 * (1. / 6227020800)) * s4);
    *cosine = ((1 - s * (1. / 2)) + (1. / 24 - s * (1. / 720)) * s2) +
              ((1. / 40320 - s * (1. / 3628800)) + s2 * (1. / 479001600)) * s4;
}

void rig_turn_drive(const Rig *rig, double time, double *sine, double *cosine) {
    double by_sine = rig->cell_sine, by_cosine = rig->cell_cosine, before = *sine;
    if (time == 0)
        return;
    if (time != rig->cell)
        take_sine_cosine(rig->omega * time, &by_sine, &by_cosine);
    *sine = before * by_cosine + *cosine * by_sine;
    *cosine = *cosine * by_cosine - before * by_sine;
}

static void cut(Regime *regime, const Rig *rig) {
    double finest =
        fmax(regime_largest(regime), 2 * M_PI / (RIG_CELLS * rig->cell)); /* the table of the drive has no cuts */
    if (rig->shares_cells)
        regime->hop = (RegimeVector){NULL, NULL};
    regime_cut(regime, rig->cell, (size_t)ceil(finest * rig->cell / REGIME_PART));
}

/* Returns the length of the step after a switch: where a mode decays faster than in half a cell, a quarter of the
 * corresponding period. */
static double first_step(const Regime *regime, double cell) {
    double first = M_PI / (2 * regime_largest(regime));
    return first < cell / 2 ? first : cell;
}

/* Chooses the cell: a quarter of the shortest period of any mode, free or in contact, or a period of the drive /
 * RIG_CELLS, or, where a mode decays much faster, CUTS_MOST parts of its time scale. */
static void make_cells(Rig *rig) {
    enum { CUTS_MOST = 4096 };
    double fastest = fmax(regime_fastest(&rig->free), regime_fastest(&rig->contact));
    double largest = fmax(regime_largest(&rig->free), regime_largest(&rig->contact));
    rig->cell = fmin(fmin(M_PI / (2 * fastest), CUTS_MOST * REGIME_PART / largest), rig->period / RIG_CELLS);
    cut(&rig->free, rig);
    cut(&rig->contact, rig);
    rig->first_free = first_step(&rig->free, rig->cell);
    rig->first_contact = first_step(&rig->contact, rig->cell);
    rig->shares_cells = false;
}

void rig_drive(Rig *rig, double frequency, double force) {
    rig->omega = 2 * M_PI * frequency;
    rig->period = 1 / frequency;
    rig->force = force;
    if (!(rig->cell > 0 && rig->cell <= rig->period / RIG_CELLS))
        make_cells(rig);
    take_sine_cosine(rig->omega * rig->cell, &rig->cell_sine, &rig->cell_cosine);
    make_steady(&rig->steady_free, &rig->free, rig, 0);
    make_steady(&rig->steady_contact, &rig->contact, rig, rig->stiffness * rig->clearance);
    make_jumps(&rig->touch, &rig->free, &rig->steady_free, &rig->contact, &rig->steady_contact);
    make_jumps(&rig->leave, &rig->contact, &rig->steady_contact, &rig->free, &rig->steady_free);
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
    make_change(&rig->touch, &rig->free, &rig->contact);
    make_change(&rig->leave, &rig->contact, &rig->free);
    create_jumps(&rig->touch, &rig->contact);
    create_jumps(&rig->leave, &rig->free);
    rig_drive(rig, beam->frequency, beam->force);
    return true;
}

static bool build(Rig *rig, const Beam *beam, const Modes *like, const char *place, Fault *fault) {
    Modes modes;
    if (!modes_of_beam(&modes, beam)) {
        fault_add(fault,
                  "%s: the beam has no distinct natural modes: its stiffnesses differ too much, "
                  "or its support is too soft",
                  place);
        return false;
    }
    if (like)
        modes_align(&modes, like);
    if (!rig_of_modes(rig, &modes, beam)) {
        fault_add(fault,
                  "%s: the contact has no distinct eigenvalues: joint.stiffness or joint.damping is "
                  "too far from the beam's",
                  place);
        return false;
    }
    if (rig->period / rig->cell <= RIG_CELLS_MOST)
        return true;
    fault_add(fault,
              "%s: the fastest vibration is %.0e times as fast as the drive, must be at most %.0e times: "
              "raise drive.frequency or reduce beam.modes",
              place, rig->period / rig->cell / 4, RIG_CELLS_MOST / 4);
    rig_clear(rig);
    return false;
}

bool rig_build(Rig *rig, const Beam *beam, const char *place, Fault *fault) {
    return build(rig, beam, NULL, place, fault);
}

bool rig_build_like(Rig *rig, const Beam *beam, const Rig *like, const char *place, Fault *fault) {
    return build(rig, beam, &like->modes, place, fault);
}

void rig_clear(Rig *rig) {
    modes_clear(&rig->modes);
    regime_clear(&rig->free);
    regime_clear(&rig->contact);
    rig->shares_cells = true;
    memory_free(rig->touch.by_re.re);
    memory_free(rig->touch.by_im.re);
    memory_free(rig->leave.by_re.re);
    memory_free(rig->leave.by_im.re);
    rig_clear_shared(rig);
}

Rig rig_share(const Rig *rig, double frequency, double force, double clearance) {
    Rig own = *rig;
    own.clearance = clearance;
    own.shares_cells = true;
    own.steady_free = steady_create(&own.free);
    own.steady_contact = steady_create(&own.contact);
    create_jumps(&own.touch, &own.contact);
    create_jumps(&own.leave, &own.free);
    rig_drive(&own, frequency, force);
    return own;
}

void rig_clear_shared(Rig *rig) {
    if (!rig->shares_cells) {
        memory_free(rig->free.hop.re);
        memory_free(rig->contact.hop.re);
    }
    steady_clear(&rig->steady_free);
    steady_clear(&rig->steady_contact);
    clear_jumps(&rig->touch);
    clear_jumps(&rig->leave);
    *rig = (Rig){0};
}

double rig_free_amplitude(const Rig *rig) {
    return real_hypot(rig->steady_free.row_sine[REGIME_TIP], rig->steady_free.row_cosine[REGIME_TIP]);
}

double rig_rest_deflection(const Rig *rig) {
    return RIG_REST * (rig->clearance + rig_free_amplitude(rig));
}

double rig_rest_state(const Rig *rig) {
    const Modes *modes = &rig->modes;
    double squares = 0; /* the tip's deflection per coordinate of a state */
    for (size_t i = 0; i < modes->count; i++)
        squares += modes->tip[i] * modes->tip[i] / (modes->frequency[i] * modes->frequency[i]);
    return squares > 0 ? rig_rest_deflection(rig) / sqrt(squares) : 0;
}
