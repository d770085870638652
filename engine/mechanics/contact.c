#include "mechanics/contact.h"

ContactLaw contact_mean(const ContactLaw *a, const ContactLaw *b) {
    return (ContactLaw){(a->normal_stiffness + b->normal_stiffness) / 2, (a->normal_damping + b->normal_damping) / 2,
                        (a->tangential_stiffness + b->tangential_stiffness) / 2,
                        (a->tangential_damping + b->tangential_damping) / 2, (a->friction + b->friction) / 2};
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
