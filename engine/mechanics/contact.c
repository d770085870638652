#include "mechanics/contact.h"

#include <math.h>

double contact_tangential(const ContactLaw *law, double normal_force, double sliding, double dt, double *slip) {
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

/* Semi-implicit Euler on m x'' + c x' + k x = 0, with the damping force taken from the old velocity, is stable while
 * h^2 k/m + 2 h c/m < 4, that is h < (2 / omega) (sqrt(1 + zeta^2) - zeta). The tangential pair acts across the normal
 * one; the stiffer of the two decides. */
static double longest_step(double stiffness, double damping, double mass) {
    if (stiffness <= 0)
        return damping > 0 ? 2 * mass / damping : HUGE_VAL;
    double omega = sqrt(stiffness / mass), zeta = damping / (2 * sqrt(stiffness * mass));
    return 2 / omega * (sqrt(1 + zeta * zeta) - zeta);
}

double contact_longest_step(const ContactLaw *law, double mass, double contacts) {
    return fmin(longest_step(contacts * law->normal_stiffness, contacts * law->normal_damping, mass),
                longest_step(contacts * law->tangential_stiffness, contacts * law->tangential_damping, mass));
}
