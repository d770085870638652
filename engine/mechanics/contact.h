/* The contact law: a normal and a tangential spring and dashpot behind a gap, limited by Coulomb friction.
 *
 *        gap > 0: nothing                    normal:      f_n = max(0, -k_n gap - c_n gap')         while gap < 0
 *    body )    ( body                        tangential:  f_t = -(k_t s + c_t u'),  |f_t| <= mu f_n
 *         |<-->|
 *          gap                               s the slip since touching, u' the sliding velocity
 *
 * Source: the distinct element method of Cundall and Strack (1979) as Miura, Takimoto and Kubodera use it. The contact
 * is released at zero force, not at zero gap: with a dashpot the spring has then not yet recovered, and the law never
 * pulls. Released at zero gap, a collision of damping ratio 0.35 has a restitution of 0.309 instead of 0.404.
 *
 * One law serves a body against a wall, a personal space against a wall (a larger outline and softer numbers), and a
 * beam's tip in its clearance. The geometry gives the gap, the law gives the force, and the caller adds the force to
 * its equations of motion.
 */
#pragma once

#include <math.h>

typedef struct ContactLaw {
    double normal_stiffness;     /* k_n, N/m */
    double normal_damping;       /* c_n, N s/m */
    double tangential_stiffness; /* k_t, N/m */
    double tangential_damping;   /* c_t, N s/m */
    double friction;             /* mu, 1 */
} ContactLaw;

/* Returns the normal force, N, at least 0, that pushes the two apart. `gap` (m) is negative when they overlap, and
 * `gap_rate` (m/s) is negative when they approach. */
static inline double contact_normal(const ContactLaw *law, double gap, double gap_rate) {
    if (gap >= 0)
        return 0;
    double force = -law->normal_stiffness * gap - law->normal_damping * gap_rate;
    return force > 0 ? force : 0;
}

/* Returns the tangential force, N, along the direction in which `sliding` (m/s, of the body relative to the other) is
 * positive; the force opposes the sliding. `*slip` (m) is the spring's length and is advanced by one step of `dt` s; at
 * the friction limit the length is reset so that the law gives the limited force. */
static inline double contact_tangential(const ContactLaw *law, double normal_force, double sliding, double dt,
                                        double *slip) {
    double carried = *slip + sliding * dt;
    double force = -(law->tangential_stiffness * carried + law->tangential_damping * sliding);
    double limit = law->friction * normal_force;
    if (fabs(force) > limit) {
        force = copysign(limit, force);
        carried = law->tangential_stiffness > 0
                      ? (-force - law->tangential_damping * sliding) / law->tangential_stiffness
                      : 0;
    }
    *slip = carried;
    return force;
}

/* Returns the law between two bodies with laws of their own: the mean of both. */
ContactLaw contact_mean(const ContactLaw *a, const ContactLaw *b);

/* Returns the longest stable step, s, of semi-implicit Euler for a mass `mass` (kg) held by `contacts` such springs and
 * dashpots at once: (2 / omega) (sqrt(1 + zeta^2) - zeta). Infinite without stiffness and damping. */
double contact_longest_step(const ContactLaw *law, double mass, double contacts);
