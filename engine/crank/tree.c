#include "crank/tree.h"

#include <math.h>
#include <string.h>

/* Places of the coordinates. */
enum { SLIDER, ALPHA, BETA, STRETCH, BASE /* all before the sines, with STRETCH */ };

static size_t first_sine(const Tree *tree) {
    return 3 + tree->axial;
}

static size_t first_support(const Tree *tree) {
    return tree->rod;
}

/* This file is where the time goes. Its functions are inlined with the usual numbers of modes as constants, so that
 * loops are unrolled; the order of the sums, and with it the bits, are those of other numbers. */
#define ALWAYS_INLINE inline __attribute__((always_inline))

/* Numbers of modes of the coupler. */
typedef struct Counts {
    size_t bending, axial;
} Counts;

static const Counts USUAL = {2, 1};

static inline bool is_usual(const Tree *tree) {
    return tree->bending == USUAL.bending && tree->axial == USUAL.axial;
}

/* Constants -------------------------------------------------------------------------------------------------------- */

static void set_rod(Tree *tree, const Crank *crank) {
    double outer = crank->diameter * crank->diameter, inner = crank->bore * crank->bore;
    double area = M_PI / 4 * (outer - inner),
           bending = crank->youngs_modulus * M_PI / 64 * (outer * outer - inner * inner);
    double length = crank->length;
    tree->length = length;
    tree->mass = crank->density * area * length;
    tree->axial_stiffness = crank->youngs_modulus * area / length;
    tree->axial_damping = 2 * crank->damping_ratio * sqrt(tree->axial_stiffness * (tree->mass / 3 + crank->end_mass));
    for (size_t i = 0; i < tree->bending; i++) {
        double n = (double)(i + 1), sign = i % 2 ? 1 : -1, wave = n * M_PI / length;
        tree->sine_stiffness[i] = bending * (wave * wave) * (wave * wave) * length / 2;
        tree->sine_damping[i] = 2 * crank->damping_ratio * sqrt(tree->sine_stiffness[i] * tree->mass / 2);
        tree->mean[i] = (1 - sign) / (n * M_PI);
        tree->lever[i] = -sign / (n * M_PI);
        tree->slope[i] = sign * wave;
        tree->shortening[i] = crank->shortening ? wave * wave * length / 2 : 0;
    }
}

static void set_support(Tree *tree, const Crank *crank) {
    const double stiffness[3] = {crank->support_stiffness_x, crank->support_stiffness_y, crank->support_stiffness_z};
    tree->support_mass = crank->support_mass;
    for (size_t i = 0; i < 3; i++) {
        tree->support_stiffness[i] = stiffness[i];
        tree->support_damping[i] = 2 * crank->support_damping_ratio * sqrt(stiffness[i] * crank->support_mass);
    }
}

Tree tree_of(const Crank *crank) {
    SineCosine tilt = real_sincos(crank->tilt * M_PI / 180);
    Tree tree = {
        .bending = (size_t)crank->modes,
        .axial = (size_t)crank->axial,
        .turns = crank->motor > 0,
        .end_mass = crank->end_mass,
        .slider_mass = crank->slider_mass,
        .slider_damping = crank->slider_damping,
        .universal_damping = crank->universal_damping,
        .radius = crank->radius,
        .axis = {0, crank->offset_y, crank->offset_z},
        .tilt_sine = tilt.sine,
        .tilt_cosine = tilt.cosine,
        .inertia = crank->inertia,
        .motor = crank->motor,
        .unbalance_weight = crank->unbalance * crank->gravity,
        .omega = 2 * M_PI * crank->frequency,
        .period = 1 / crank->frequency,
        .gravity = crank->gravity,
        .clearance = crank->clearance,
        .stiffness = crank->contact.normal_stiffness,
        .damping = crank->contact.normal_damping,
        .release = crank->release,
        .start = {crank->start_along, crank->start_across, crank->start_up},
        .start_velocity = crank->start_velocity,
        .friction = crank->contact.friction,
        .slip_speed = crank->slip_speed,
        .ball_radius = crank->ball_radius,
    };
    tree.rod = 3 + tree.axial + 2 * tree.bending;
    tree.coordinates = tree.rod + 3 + tree.turns;
    set_rod(&tree, crank);
    set_support(&tree, crank);
    return tree;
}

double tree_bending_frequency(const Tree *tree, size_t n) {
    return sqrt(tree->sine_stiffness[n] / (tree->mass / 2)) / (2 * M_PI);
}

double tree_support_frequency(const Tree *tree, size_t axis) {
    return sqrt(tree->support_stiffness[axis] / tree->support_mass) / (2 * M_PI);
}

/* Geometry --------------------------------------------------------------------------------------------------------- */

TreePin tree_pin(const Tree *tree, double theta, double theta_rate) {
    SineCosine turn = real_sincos(theta);
    double r = tree->radius;
    const double across[3] = {tree->tilt_sine, -tree->tilt_cosine, 0};
    TreePin pin;
    for (size_t i = 0; i < 3; i++) {
        double z = i == 2;
        pin.at[i] = tree->axis[i] + r * (turn.cosine * z + turn.sine * across[i]);
        pin.arm[i] = r * (turn.cosine * across[i] - turn.sine * z);
        pin.rate[i] = theta_rate * pin.arm[i];
    }
    return pin;
}

static void set_frame(TreePose *pose, double alpha, double beta, double alpha_rate, double beta_rate) {
    SineCosine a = real_sincos(alpha), b = real_sincos(beta);
    pose->alpha = a;
    pose->beta = b;
    memcpy(pose->along, (double[]){a.cosine * b.cosine, a.sine * b.cosine, -b.sine}, sizeof pose->along);
    memcpy(pose->across, (double[]){-a.sine, a.cosine, 0}, sizeof pose->across);
    memcpy(pose->up, (double[]){a.cosine * b.sine, a.sine * b.sine, b.cosine}, sizeof pose->up);
    memcpy(pose->turn, (double[]){-b.sine * alpha_rate, beta_rate, b.cosine * alpha_rate}, sizeof pose->turn);
}

/* The distance of the ball from the slider, which bending shortens. */
static ALWAYS_INLINE void set_span(const Tree *tree, Counts counts, TreePose *pose, const double *q,
                                   const double *rate) {
    size_t n = counts.bending, sines = BASE - 1 + counts.axial;
    const double *sine = q + sines, *sine_rate = rate + sines;
    pose->span = tree->length + (counts.axial ? q[STRETCH] : 0);
    pose->span_rate = counts.axial ? rate[STRETCH] : 0;
    pose->span_rest = 0;
    pose->end_turn[0] = pose->end_turn[1] = 0;
    for (size_t i = 0; i < n; i++) {
        pose->end_turn[0] -= tree->slope[i] * sine_rate[n + i];
        pose->end_turn[1] += tree->slope[i] * sine_rate[i];
    }
#pragma GCC unroll 12
    for (size_t i = 0; i < 2 * n; i++) {
        double shortening = tree->shortening[i < n ? i : i - n];
        pose->column[i] = -shortening * sine[i];
        pose->span += pose->column[i] * sine[i] / 2;
        pose->span_rate += pose->column[i] * sine_rate[i];
        pose->span_rest -= shortening * sine_rate[i] * sine_rate[i];
    }
}

TreePose tree_pose(const Tree *tree, double time, const double *state) {
    const double *q = state, *rate = state + tree->coordinates;
    const double *u = q + first_support(tree), *u_rate = rate + first_support(tree);
    TreePose pose;
    pose.theta = tree->turns ? q[tree->coordinates - 1] : tree->omega * time;
    pose.theta_rate = tree->turns ? rate[tree->coordinates - 1] : tree->omega;
    pose.pin = tree_pin(tree, pose.theta, pose.theta_rate);
    set_frame(&pose, q[ALPHA], q[BETA], rate[ALPHA], rate[BETA]);
    if (is_usual(tree))
        set_span(tree, USUAL, &pose, q, rate);
    else
        set_span(tree, (Counts){tree->bending, tree->axial}, &pose, q, rate);
    double level = pose.span * pose.turn[2], rise = -pose.span * pose.turn[1];
    for (size_t i = 0; i < 3; i++) {
        pose.apart[i] = pose.span * pose.along[i] - pose.pin.at[i] - u[i];
        pose.apart_rate[i] =
            pose.span_rate * pose.along[i] + level * pose.across[i] + rise * pose.up[i] - pose.pin.rate[i] - u_rate[i];
    }
    pose.apart[0] += q[SLIDER];
    pose.apart_rate[0] += rate[SLIDER];
    return pose;
}

static double dot(const double *a, const double *b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* Equations of motion ---------------------------------------------------------------------------------------------- */

/* Integrals over the rod's mass; a letter with _rate is its derivative. */
typedef struct Moments {
    double s[3], s_rate[3];              /* of rho */
    double h[3], h_rate[3];              /* of rho xi / L */
    double i11, i12, i13, i22, i23, i33; /* of rho rho^T */
    double d[3][3];                      /* of rho_i rho_j' */
} Moments;

static ALWAYS_INLINE Moments moments_of(const Tree *tree, Counts counts, const double *q, const double *rate) {
    size_t n = counts.bending;
    const double *eta = q + BASE - 1 + counts.axial, *zeta = eta + n;
    const double *eta_rate = rate + BASE - 1 + counts.axial, *zeta_rate = eta_rate + n;
    double m = tree->mass, ml = m * tree->length;
    double sigma = 1 + (counts.axial ? q[STRETCH] / tree->length : 0);
    double sigma_rate = counts.axial ? rate[STRETCH] / tree->length : 0;
    double s2 = 0, s3 = 0, s2r = 0, s3r = 0, h2 = 0, h3 = 0, h2r = 0, h3r = 0;
    double ee = 0, ez = 0, zz = 0, eer = 0, ezr = 0, zer = 0, zzr = 0;
    for (size_t i = 0; i < n; i++) {
        s2 += tree->mean[i] * eta[i], s3 += tree->mean[i] * zeta[i];
        s2r += tree->mean[i] * eta_rate[i], s3r += tree->mean[i] * zeta_rate[i];
        h2 += tree->lever[i] * eta[i], h3 += tree->lever[i] * zeta[i];
        h2r += tree->lever[i] * eta_rate[i], h3r += tree->lever[i] * zeta_rate[i];
        ee += eta[i] * eta[i], ez += eta[i] * zeta[i], zz += zeta[i] * zeta[i];
        eer += eta[i] * eta_rate[i], ezr += eta[i] * zeta_rate[i];
        zer += zeta[i] * eta_rate[i], zzr += zeta[i] * zeta_rate[i];
    }
    return (Moments){
        .s = {ml * sigma / 2, m * s2, m * s3},
        .s_rate = {ml * sigma_rate / 2, m * s2r, m * s3r},
        .h = {ml * sigma / 3, m * h2, m * h3},
        .h_rate = {ml * sigma_rate / 3, m * h2r, m * h3r},
        .i11 = ml * tree->length * sigma * sigma / 3,
        .i12 = sigma * ml * h2,
        .i13 = sigma * ml * h3,
        .i22 = m / 2 * ee,
        .i23 = m / 2 * ez,
        .i33 = m / 2 * zz,
        .d = {{ml * tree->length * sigma * sigma_rate / 3, sigma * ml * h2r, sigma * ml * h3r},
              {sigma_rate * ml * h2, m / 2 * eer, m / 2 * ezr},
              {sigma_rate * ml * h3, m / 2 * zer, m / 2 * zzr}},
    };
}

/* What turns an acceleration's part without second derivatives: acc = w rho + 2 turn x rho' + g. */
typedef struct Bias {
    double w[3][3];
    double turn[3];
    double g[3]; /* m/s2, gravity as an acceleration, in the rod's frame */
} Bias;

static ALWAYS_INLINE Bias bias_of(const Tree *tree, const TreePose *pose, double alpha_rate, double beta_rate) {
    const double *w = pose->turn;
    double g1 = -alpha_rate * beta_rate * pose->beta.cosine, g3 = -alpha_rate * beta_rate * pose->beta.sine;
    double square = dot(w, w);
    return (Bias){
        .w = {{w[0] * w[0] - square, w[0] * w[1] - g3, w[0] * w[2]},
              {w[1] * w[0] + g3, w[1] * w[1] - square, w[1] * w[2] - g1},
              {w[2] * w[0], w[2] * w[1] + g1, w[2] * w[2] - square}},
        .turn = {w[0], w[1], w[2]},
        .g = {-pose->beta.sine * tree->gravity, 0, pose->beta.cosine * tree->gravity},
    };
}

/* Returns the component of w x + 2 turn x x_rate. */
static ALWAYS_INLINE double bias_row(const Bias *bias, size_t row, const double *x, const double *rate) {
    size_t next = (row + 1) % 3, last = (row + 2) % 3;
    return dot(bias->w[row], x) + 2 * (bias->turn[next] * rate[last] - bias->turn[last] * rate[next]);
}

/* The equations of slider and rod: a mass matrix of the first coordinates (lower half), of these with the sines, and a
 * diagonal of the sines, all without the end mass; and the right side. */
typedef struct Equations {
    double base[BASE][BASE], couple[BASE][TREE_SINES];
    double base_force[BASE], sine_force[TREE_SINES];
} Equations;

/* Sets the equations of slider and rod without the end mass. */
static ALWAYS_INLINE void rod_equations(const Tree *tree, Counts counts, const TreePose *pose, const Bias *bias,
                                        const double *q, const double *rate, Equations *equations) {
    size_t n = counts.bending, sines = BASE - 1 + counts.axial;
    const double *eta = q + sines, *zeta = eta + n, *eta_rate = rate + sines, *zeta_rate = eta_rate + n;
    Moments o = moments_of(tree, counts, q, rate);
    double m = tree->mass, ml = m * tree->length;
    double x1 = pose->along[0], x2 = pose->across[0], x3 = pose->up[0], z1 = -pose->beta.sine, z3 = pose->beta.cosine;
    double(*matrix)[BASE] = equations->base;

    matrix[SLIDER][SLIDER] = tree->slider_mass + m;
    matrix[ALPHA][SLIDER] = -x1 * z3 * o.s[1] + x2 * (z3 * o.s[0] - z1 * o.s[2]) + x3 * z1 * o.s[1];
    matrix[BETA][SLIDER] = x1 * o.s[2] - x3 * o.s[0];
    matrix[ALPHA][ALPHA] = z3 * z3 * (o.i11 + o.i22) - 2 * z1 * z3 * o.i13 + z1 * z1 * (o.i22 + o.i33);
    matrix[BETA][ALPHA] = -z3 * o.i23 - z1 * o.i12;
    matrix[BETA][BETA] = o.i11 + o.i33;

    double force[3], q12, q21, q23, q32, q31, q13;
    for (size_t i = 0; i < 3; i++)
        force[i] = bias_row(bias, i, o.s, o.s_rate) + m * bias->g[i];
    const double i1[3] = {o.i11, o.i12, o.i13}, i2[3] = {o.i12, o.i22, o.i23}, i3[3] = {o.i13, o.i23, o.i33};
    q12 = bias_row(bias, 1, i1, o.d[0]) + o.s[0] * bias->g[1];
    q13 = bias_row(bias, 2, i1, o.d[0]) + o.s[0] * bias->g[2];
    q21 = bias_row(bias, 0, i2, o.d[1]) + o.s[1] * bias->g[0];
    q23 = bias_row(bias, 2, i2, o.d[1]) + o.s[1] * bias->g[2];
    q31 = bias_row(bias, 0, i3, o.d[2]) + o.s[2] * bias->g[0];
    q32 = bias_row(bias, 1, i3, o.d[2]) + o.s[2] * bias->g[1];
    equations->base_force[SLIDER] =
        -(x1 * force[0] + x2 * force[1] + x3 * force[2] + tree->slider_damping * rate[SLIDER]);
    equations->base_force[ALPHA] = -(z3 * (q12 - q21) + z1 * (q23 - q32) + tree->universal_damping * rate[ALPHA]);
    equations->base_force[BETA] = -(q31 - q13 + tree->universal_damping * rate[BETA]);

    if (counts.axial) {
        matrix[STRETCH][SLIDER] = x1 * m / 2;
        matrix[STRETCH][ALPHA] = -z3 * o.h[1];
        matrix[STRETCH][BETA] = o.h[2];
        matrix[STRETCH][STRETCH] = m / 3;
        equations->base_force[STRETCH] = -(bias_row(bias, 0, o.h, o.h_rate) + bias->g[0] * m / 2 +
                                           tree->axial_stiffness * q[STRETCH] + tree->axial_damping * rate[STRETCH]);
    }
    double sigma = 1 + (counts.axial ? q[STRETCH] / tree->length : 0);
    double sigma_rate = counts.axial ? rate[STRETCH] / tree->length : 0;
    for (size_t i = 0; i < n; i++) {
        double p[3] = {sigma * ml * tree->lever[i], m / 2 * eta[i], m / 2 * zeta[i]};
        double p_rate[3] = {sigma_rate * ml * tree->lever[i], m / 2 * eta_rate[i], m / 2 * zeta_rate[i]};
        equations->couple[SLIDER][i] = x2 * m * tree->mean[i];
        equations->couple[SLIDER][n + i] = x3 * m * tree->mean[i];
        equations->couple[ALPHA][i] = z3 * p[0] - z1 * p[2];
        equations->couple[ALPHA][n + i] = z1 * p[1];
        equations->couple[BETA][i] = 0;
        equations->couple[BETA][n + i] = -p[0];
        equations->sine_force[i] = -(bias_row(bias, 1, p, p_rate) + bias->g[1] * m * tree->mean[i] +
                                     tree->sine_stiffness[i] * eta[i] + tree->sine_damping[i] * eta_rate[i]);
        equations->sine_force[n + i] = -(bias_row(bias, 2, p, p_rate) + bias->g[2] * m * tree->mean[i] +
                                         tree->sine_stiffness[i] * zeta[i] + tree->sine_damping[i] * zeta_rate[i]);
    }
}

/* The ball's acceleration without second derivatives, in the rod's frame; gravity is not in it. */
static ALWAYS_INLINE void ball_bias(const TreePose *pose, const Bias *bias, double *acceleration) {
    const double at[3] = {pose->span, 0, 0}, rate[3] = {pose->span_rate, 0, 0};
    for (size_t i = 0; i < 3; i++)
        acceleration[i] = bias_row(bias, i, at, rate);
    acceleration[0] += pose->span_rest;
}

/* Adds the end mass, except to the sines' own block, and a force and a moment on the ball, in the rod's frame. The
 * ball moves with the first coordinates by columns (x1, x2, x3), (0, cos beta l, 0), (0, 0, -l) and (1, 0, 0), with the
 * sines along the rod alone. */
static ALWAYS_INLINE void add_ball(const Tree *tree, Counts counts, const TreePose *pose, const double *push,
                                   const double *moment, Equations *equations) {
    double x1 = pose->along[0], x2 = pose->across[0], x3 = pose->up[0], mass = tree->end_mass;
    double level = pose->beta.cosine * pose->span, rise = -pose->span;
    double(*matrix)[BASE] = equations->base;
    size_t n = counts.bending;
    matrix[SLIDER][SLIDER] += mass;
    matrix[ALPHA][SLIDER] += mass * (x2 * level);
    matrix[ALPHA][ALPHA] += mass * (level * level);
    matrix[BETA][SLIDER] += mass * (x3 * rise);
    matrix[BETA][BETA] += mass * (rise * rise);
    equations->base_force[SLIDER] += x1 * push[0] + x2 * push[1] + x3 * push[2];
    equations->base_force[ALPHA] += level * push[1] + pose->beta.cosine * moment[2] - pose->beta.sine * moment[0];
    equations->base_force[BETA] += rise * push[2] + moment[1];
    if (counts.axial) {
        matrix[STRETCH][SLIDER] += mass * x1;
        matrix[STRETCH][STRETCH] += mass;
        equations->base_force[STRETCH] += push[0];
    }
    for (size_t i = 0; i < n; i++) {
        equations->sine_force[i] += tree->slope[i] * moment[2];
        equations->sine_force[n + i] -= tree->slope[i] * moment[1];
    }
    for (size_t i = 0; i < 2 * n; i++) {
        equations->couple[SLIDER][i] += mass * (x1 * pose->column[i]);
        if (counts.axial)
            equations->couple[STRETCH][i] = mass * pose->column[i];
        equations->sine_force[i] += pose->column[i] * push[0];
    }
}

/* Solves the symmetric positive definite system of `n` rows whose lower half is given, by L D L^T; `x` is the right
 * side, then the solution. */
static ALWAYS_INLINE void solve_base(double matrix[BASE][BASE], double *x, size_t n) {
    double inverse[BASE];
#pragma GCC unroll 4
    for (size_t j = 0; j < n; j++) {
        double *row = matrix[j], diagonal = row[j];
#pragma GCC unroll 4
        for (size_t k = 0; k < j; k++) {
            double sum = row[k];
#pragma GCC unroll 4
            for (size_t l = 0; l < k; l++)
                sum -= row[l] * matrix[k][l];
            row[k] = sum;
        }
#pragma GCC unroll 4
        for (size_t k = 0; k < j; k++) {
            double part = row[k] * inverse[k];
            diagonal -= part * row[k];
            row[k] = part;
            x[j] -= part * x[k];
        }
        inverse[j] = 1 / diagonal;
    }
#pragma GCC unroll 4
    for (size_t j = n; j-- > 0;) {
        x[j] *= inverse[j];
#pragma GCC unroll 4
        for (size_t k = j + 1; k < n; k++)
            x[j] -= matrix[k][j] * x[k];
    }
}

/* Returns the sum of a[i] b[i] of `count` numbers. */
static ALWAYS_INLINE double product(const double *a, const double *b, size_t count) {
    double sum = 0;
#pragma GCC unroll 12
    for (size_t i = 0; i < count; i++)
        sum += a[i] * b[i];
    return sum;
}

/* Solves for the accelerations of the first coordinates, then of the sines. The sines' block is a diagonal of m / 2 and
 * the end mass times c c^T, c the ball's column, whose inverse is (1 - kappa c c^T) 2 / m with kappa = m_B / (m / 2 +
 * m_B c c): they are eliminated in closed form, and four rows are left at most. */
static ALWAYS_INLINE void solve(const Tree *tree, Counts counts, const TreePose *pose, Equations *equations,
                                double *acceleration) {
    size_t n = 2 * counts.bending, rows = BASE - 1 + counts.axial;
    const double *column = pose->column;
    double per = 2 / tree->mass, along[BASE];
    double factor = tree->end_mass / (tree->mass / 2 + tree->end_mass * product(column, column, n));
    double force_along = product(column, equations->sine_force, n);
#pragma GCC unroll 4
    for (size_t i = 0; i < rows; i++) {
        along[i] = product(equations->couple[i], column, n);
#pragma GCC unroll 4
        for (size_t j = 0; j <= i; j++)
            equations->base[i][j] -=
                per * (product(equations->couple[i], equations->couple[j], n) - factor * (along[i] * along[j]));
        acceleration[i] = equations->base_force[i] - per * (product(equations->couple[i], equations->sine_force, n) -
                                                            factor * (along[i] * force_along));
    }
    solve_base(equations->base, acceleration, rows);
    double *sine = acceleration + rows;
#pragma GCC unroll 12
    for (size_t i = 0; i < n; i++) {
        sine[i] = equations->sine_force[i];
#pragma GCC unroll 4
        for (size_t j = 0; j < rows; j++)
            sine[i] -= equations->couple[j][i] * acceleration[j];
    }
    double rest = factor * product(column, sine, n);
#pragma GCC unroll 12
    for (size_t i = 0; i < n; i++)
        sine[i] = per * (sine[i] - rest * column[i]);
}

/* The bearing block and, with a motor, the crank. */
static void add_support(const Tree *tree, const TreePose *pose, const double *q, const double *rate,
                        const double *force, const double *moment, double *acceleration) {
    size_t first = first_support(tree);
    for (size_t i = 0; i < 3; i++)
        acceleration[first + i] =
            (-force[i] - tree->support_stiffness[i] * q[first + i] - tree->support_damping[i] * rate[first + i]) /
            tree->support_mass;
    if (tree->turns)
        acceleration[first + 3] =
            (tree->motor * (tree->omega - pose->theta_rate) + tree->unbalance_weight * real_sin(pose->theta) -
             dot(force, pose->pin.arm) - tree->tilt_cosine * moment[0] - tree->tilt_sine * moment[1]) /
            tree->inertia;
}

/* Computes the accelerations of slider and rod. */
static ALWAYS_INLINE void rod_accelerations(const Tree *tree, Counts counts, const TreePose *pose, const double *q,
                                            const double *rate, const double *force, const double *moment,
                                            double *acceleration) {
    Equations equations;
    Bias bias = bias_of(tree, pose, rate[ALPHA], rate[BETA]);
    double ball[3], push[3] = {dot(force, pose->along), dot(force, pose->across), dot(force, pose->up)};
    const double twist[3] = {dot(moment, pose->along), dot(moment, pose->across), dot(moment, pose->up)};
    ball_bias(pose, &bias, ball);
    for (size_t i = 0; i < 3; i++)
        push[i] -= tree->end_mass * (ball[i] + bias.g[i]);
    rod_equations(tree, counts, pose, &bias, q, rate, &equations);
    add_ball(tree, counts, pose, push, twist, &equations);
    solve(tree, counts, pose, &equations, acceleration);
}

void tree_rates(const Tree *tree, const TreePose *pose, const double *state, const double *force, const double *moment,
                double *rates) {
    size_t n = tree->coordinates;
    const double *q = state, *rate = state + n;
    double *acceleration = rates + n;
    if (is_usual(tree))
        rod_accelerations(tree, USUAL, pose, q, rate, force, moment, acceleration);
    else
        rod_accelerations(tree, (Counts){tree->bending, tree->axial}, pose, q, rate, force, moment, acceleration);
    add_support(tree, pose, q, rate, force, moment, acceleration);
    memcpy(rates, rate, n * sizeof *rates);
}

void tree_apart_acceleration(const Tree *tree, const TreePose *pose, const double *rates, double *acceleration) {
    size_t n = tree->coordinates;
    const double *rate = rates, *second = rates + n;
    double own[3], slide = second[SLIDER];
    Bias bias = bias_of(tree, pose, rate[ALPHA], rate[BETA]);
    ball_bias(pose, &bias, own);
    own[0] += pose->along[0] * slide + (tree->axial ? second[STRETCH] : 0) +
              product(pose->column, second + first_sine(tree), 2 * tree->bending);
    own[1] += pose->across[0] * slide + pose->beta.cosine * pose->span * second[ALPHA];
    own[2] += pose->up[0] * slide - pose->span * second[BETA];
    double theta_second = tree->turns ? second[n - 1] : 0, square = pose->theta_rate * pose->theta_rate;
    for (size_t i = 0; i < 3; i++)
        acceleration[i] = own[0] * pose->along[i] + own[1] * pose->across[i] + own[2] * pose->up[i] -
                          theta_second * pose->pin.arm[i] + square * (pose->pin.at[i] - tree->axis[i]) -
                          second[first_support(tree) + i];
}

/* The rigid mechanism ---------------------------------------------------------------------------------------------- */

double tree_ideal_slider(const Tree *tree, double theta) {
    TreePin pin = tree_pin(tree, theta, 0);
    return pin.at[0] + sqrt(tree->length * tree->length - pin.at[1] * pin.at[1] - pin.at[2] * pin.at[2]);
}

void tree_ideal(const Tree *tree, double theta, double theta_rate, double *state) {
    size_t n = tree->coordinates;
    double *rate = state + n, length = tree->length, along[3], along_rate[3];
    memset(state, 0, 2 * n * sizeof *state);
    TreePin pin = tree_pin(tree, theta, theta_rate);
    double s = tree_ideal_slider(tree, theta);
    double s_rate = pin.rate[0] - (pin.at[1] * pin.rate[1] + pin.at[2] * pin.rate[2]) / (s - pin.at[0]);
    for (size_t i = 0; i < 3; i++) {
        along[i] = (pin.at[i] - (i == 0 ? s : 0)) / length;
        along_rate[i] = (pin.rate[i] - (i == 0 ? s_rate : 0)) / length;
    }
    double level = along[0] * along[0] + along[1] * along[1];
    state[SLIDER] = s;
    state[ALPHA] = real_atan2(along[1], along[0]);
    state[BETA] = -real_asin(along[2]);
    rate[SLIDER] = s_rate;
    rate[ALPHA] = (along[0] * along_rate[1] - along[1] * along_rate[0]) / level;
    rate[BETA] = -along_rate[2] / sqrt(level);
    if (tree->turns) {
        state[n - 1] = theta;
        rate[n - 1] = theta_rate;
    }
}

/* Turns the rod and moves the slider so that the ball is at the start's place of its socket: Newton's iteration on
 * three numbers, exact after a few steps, since the ball's place is nearly linear in them. */
static void move_ball(const Tree *tree, double *state) {
    enum { ITERATIONS = 8 };
    TreePose ideal = tree_pose(tree, 0, state);
    for (int i = 0; i < ITERATIONS; i++) {
        TreePose pose = tree_pose(tree, 0, state);
        double missing[3], local[3];
        for (size_t k = 0; k < 3; k++)
            missing[k] = tree->start[0] * ideal.along[k] + tree->start[1] * ideal.across[k] +
                         tree->start[2] * ideal.up[k] - pose.apart[k];
        local[0] = dot(missing, pose.along), local[1] = dot(missing, pose.across), local[2] = dot(missing, pose.up);
        double slide = local[0] / pose.along[0];
        state[SLIDER] += slide;
        state[ALPHA] += (local[1] - slide * pose.across[0]) / (pose.span * pose.beta.cosine);
        state[BETA] -= (local[2] - slide * pose.up[0]) / pose.span;
    }
}

void tree_start(const Tree *tree, double *state) {
    tree_ideal(tree, 0, tree->omega, state);
    if (dot(tree->start, tree->start) > 0)
        move_ball(tree, state);
    state[tree->coordinates + SLIDER] += tree->start_velocity;
}
