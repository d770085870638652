#include "crank/ball.h"

#include <math.h>
#include <string.h>

static double dot(const double *a, const double *b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void cross(const double *a, const double *b, double *product) {
    product[0] = a[1] * b[2] - a[2] * b[1];
    product[1] = a[2] * b[0] - a[0] * b[2];
    product[2] = a[0] * b[1] - a[1] * b[0];
}

BallReading ball_read_vector(const Tree *tree, const double *apart, const double *apart_rate) {
    BallReading reading = {.distance = sqrt(dot(apart, apart))};
    reading.rate = reading.distance > 0 ? dot(apart, apart_rate) / reading.distance : sqrt(dot(apart_rate, apart_rate));
    reading.push = tree->stiffness * (reading.distance - tree->clearance) + tree->damping * reading.rate;
    if (tree->clearance <= 0) {
        double sum = 0;
        for (size_t i = 0; i < 3; i++) {
            double part = tree->stiffness * apart[i] + tree->damping * apart_rate[i];
            sum += part * part;
        }
        reading.push = sqrt(sum);
    }
    return reading;
}

BallReading ball_read(const Tree *tree, const TreePose *pose) {
    return ball_read_vector(tree, pose->apart, pose->apart_rate);
}

/* Adds friction, for a normal force at the direction `n`. */
static void add_friction(const Tree *tree, const TreePose *pose, double normal, const double *n, double *force,
                         double *moment) {
    const double axis[3] = {tree->tilt_cosine, tree->tilt_sine, 0};
    double spin[3], roll[3], slip[3], along = dot(pose->apart_rate, n), square = tree->slip_speed * tree->slip_speed;
    const double turn[3] = {pose->turn[0], pose->turn[1] + pose->end_turn[0], pose->turn[2] + pose->end_turn[1]};
    for (size_t i = 0; i < 3; i++)
        spin[i] =
            turn[0] * pose->along[i] + turn[1] * pose->across[i] + turn[2] * pose->up[i] - pose->theta_rate * axis[i];
    cross(spin, n, roll);
    for (size_t i = 0; i < 3; i++)
        slip[i] = pose->apart_rate[i] - along * n[i] + tree->ball_radius * roll[i];
    double factor = -tree->friction * normal / sqrt(dot(slip, slip) + square);
    const double arm[3] = {tree->ball_radius * n[0], tree->ball_radius * n[1], tree->ball_radius * n[2]};
    const double drag[3] = {factor * slip[0], factor * slip[1], factor * slip[2]};
    for (size_t i = 0; i < 3; i++)
        force[i] += drag[i];
    cross(arm, drag, moment);
}

void ball_push(const Tree *tree, const TreePose *pose, BallPlace place, double *force, double *moment) {
    memset(force, 0, 3 * sizeof *force);
    memset(moment, 0, 3 * sizeof *moment);
    if (tree->clearance <= 0) {
        for (size_t i = 0; i < 3; i++)
            force[i] = -(tree->stiffness * pose->apart[i] + tree->damping * pose->apart_rate[i]);
        return;
    }
    if (place != BALL_CONTACT)
        return;
    BallReading reading = ball_read(tree, pose);
    double n[3];
    for (size_t i = 0; i < 3; i++) {
        n[i] = pose->apart[i] / reading.distance;
        force[i] = -reading.push * n[i];
    }
    if (tree->friction > 0)
        add_friction(tree, pose, reading.push, n, force, moment);
}

BallPlace ball_place(const Tree *tree, const BallReading *reading) {
    if (tree->clearance <= 0)
        return BALL_CONTACT;
    if (reading->distance < tree->clearance)
        return BALL_OPEN;
    if (tree->release == CRANK_RELEASE_GAP || tree->damping <= 0 || reading->push >= 0)
        return BALL_CONTACT;
    return BALL_LEAVING;
}
