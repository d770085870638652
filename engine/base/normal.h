/* The standard normal distribution. */
#pragma once

/* Returns the z below which a normal number lies with this probability, 0 < share < 1: the rational approximation of
 * Acklam (2003), relative error below 1.2e-9. */
double normal_quantile(double share);
