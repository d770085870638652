#include "cranks.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"

enum { SETTINGS_MOST = 32, POINTS = 20 /* of the quadrature */ };

Crank cranks_read(const char *const *settings) {
    char path[1000];
    size_t count = 0;
    Crank crank = {0};
    Fault fault = {0};
    while (settings && settings[count])
        count++;
    snprintf(path, sizeof path, "%s/assets/cranks/ssc.json", check_source());
    if (!crank_read(&crank, path, settings, count, &fault)) {
        check_say(&fault);
        exit(1);
    }
    return crank;
}

Tree cranks_tree(const char *settings) {
    char text[500];
    const char *list[SETTINGS_MOST + 1] = {0};
    size_t count = 0;
    snprintf(text, sizeof text, "%s", settings);
    for (char *rest = text, *one; (one = strsep(&rest, ",")) && count < SETTINGS_MOST;)
        list[count++] = one;
    Crank crank = cranks_read(*settings ? list : NULL);
    Tree tree = tree_of(&crank);
    crank_free(&crank);
    return tree;
}

/* Gauss and Legendre's points and weights on 0..1, by Newton's iteration on the polynomial. */
static void gauss(double points[POINTS], double weights[POINTS]) {
    for (int i = 0; i < POINTS; i++) {
        double x = cos(M_PI * (i + 0.75) / (POINTS + 0.5)), slope = 0;
        for (int k = 0; k < 20; k++) {
            double p = 1, before = 0;
            for (int n = 0; n < POINTS; n++) {
                double next = ((2 * n + 1) * x * p - n * before) / (n + 1);
                before = p;
                p = next;
            }
            slope = POINTS * (x * p - before) / (x * x - 1);
            x -= p / slope;
        }
        points[i] = (1 - x) / 2;
        weights[i] = 1 / ((1 - x * x) * slope * slope);
    }
}

/* A point of the rod and its velocity, in the world. */
static void rod_point(const Tree *tree, const double *state, double part, double *at, double *rate) {
    size_t n = tree->bending, first = 3 + tree->axial;
    const double *q = state, *v = state + tree->coordinates;
    double xi = part * tree->length, ca = cos(q[1]), sa = sin(q[1]), cb = cos(q[2]), sb = sin(q[2]);
    const double r[3][3] = {{ca * cb, -sa, ca * sb}, {sa * cb, ca, sa * sb}, {-sb, 0, cb}};
    const double w[3] = {-sb * v[1], v[2], cb * v[1]};
    double rho[3] = {xi + part * (tree->axial ? q[3] : 0), 0, 0}, own[3] = {part * (tree->axial ? v[3] : 0), 0, 0};
    for (size_t i = 0; i < n; i++) {
        double shape = sin((double)(i + 1) * M_PI * part);
        rho[1] += shape * q[first + i], rho[2] += shape * q[first + n + i];
        own[1] += shape * v[first + i], own[2] += shape * v[first + n + i];
    }
    own[0] += w[1] * rho[2] - w[2] * rho[1];
    own[1] += w[2] * rho[0] - w[0] * rho[2];
    own[2] += w[0] * rho[1] - w[1] * rho[0];
    for (size_t i = 0; i < 3; i++) {
        at[i] = (i == 0) * q[0] + r[i][0] * rho[0] + r[i][1] * rho[1] + r[i][2] * rho[2];
        rate[i] = (i == 0) * v[0] + r[i][0] * own[0] + r[i][1] * own[1] + r[i][2] * own[2];
    }
}

/* The ball and its velocity: the rod's end, drawn in by bending. */
static void ball_point(const Tree *tree, const double *state, double *at, double *rate) {
    size_t n = tree->bending, first = 3 + tree->axial;
    const double *q = state, *v = state + tree->coordinates;
    rod_point(tree, state, 1, at, rate);
    double drawn = 0, drawn_rate = 0;
    for (size_t i = 0; i < 2 * n; i++) {
        drawn -= tree->shortening[i % n] / 2 * q[first + i] * q[first + i];
        drawn_rate -= tree->shortening[i % n] * q[first + i] * v[first + i];
    }
    double ca = cos(q[1]), sa = sin(q[1]), cb = cos(q[2]), sb = sin(q[2]);
    const double e[3] = {ca * cb, sa * cb, -sb};
    const double e_rate[3] = {-sa * cb * v[1] - ca * sb * v[2], ca * cb * v[1] - sa * sb * v[2], -cb * v[2]};
    for (size_t i = 0; i < 3; i++) {
        at[i] += drawn * e[i];
        rate[i] += drawn_rate * e[i] + drawn * e_rate[i];
    }
}

static double square(const double *x) {
    return x[0] * x[0] + x[1] * x[1] + x[2] * x[2];
}

double cranks_kinetic_energy(const Tree *tree, const double *state) {
    double points[POINTS], weights[POINTS], at[3], rate[3];
    const double *v = state + tree->coordinates;
    double energy = tree->slider_mass / 2 * v[0] * v[0] + tree->support_mass / 2 * square(v + tree->rod);
    gauss(points, weights);
    for (int i = 0; i < POINTS; i++) {
        rod_point(tree, state, points[i], at, rate);
        energy += tree->mass / 2 * weights[i] * square(rate);
    }
    ball_point(tree, state, at, rate);
    return energy + tree->end_mass / 2 * square(rate);
}

double cranks_energy(const Tree *tree, const double *state) {
    double points[POINTS], weights[POINTS], at[3], rate[3], energy = cranks_kinetic_energy(tree, state);
    size_t n = tree->bending, first = 3 + tree->axial;
    gauss(points, weights);
    for (int i = 0; i < POINTS; i++) {
        rod_point(tree, state, points[i], at, rate);
        energy += tree->mass * weights[i] * tree->gravity * at[2];
    }
    ball_point(tree, state, at, rate);
    energy += tree->end_mass * tree->gravity * at[2];
    for (size_t i = 0; i < 2 * n; i++)
        energy += tree->sine_stiffness[i % n] / 2 * state[first + i] * state[first + i];
    if (tree->axial)
        energy += tree->axial_stiffness / 2 * state[3] * state[3];
    for (size_t i = 0; i < 3; i++)
        energy += tree->support_stiffness[i] / 2 * state[tree->rod + i] * state[tree->rod + i];
    return energy;
}

double cranks_whole_energy(const Tree *tree, const double *state, BallPlace place) {
    TreePose pose = tree_pose(tree, 0, state);
    double inside = place == BALL_CONTACT ? ball_read(tree, &pose).distance - tree->clearance : 0;
    double turns = state[2 * tree->coordinates - 1];
    return cranks_energy(tree, state) + tree->inertia / 2 * turns * turns + tree->stiffness / 2 * inside * inside;
}
