#include <math.h>

#include "base/memory.h"
#include "check.h"
#include "cycle/response.h"
#include "planar_map.h"

static Response respond(const PlanarMap *map, int transient, double x, double y) {
    Response response;
    response_run(&response, planar_map_cycle(map), transient, 100, (double[]){x, y}, NULL);
    return response;
}

/* The fixed points of r x (1 - x) are 0 and 1 - 1/r, with the derivatives r and 2 - r. */
TEST(a_map_s_fixed_points_and_their_multipliers_are_found) {
    const double r = 2.7;
    PlanarMap map = {planar_map_logistic, &r, 0};
    Orbit orbit;
    CHECK(orbit_find(&orbit, planar_map_cycle(&map), (double[]){0.6, 0.6}, 1, NULL) == ORBIT_GOOD);
    CHECK_NEAR(orbit.point[0], 1 - 1 / r, 1e-12);
    CHECK_NEAR(orbit.multiplier_re[0], 2 - r, 1e-10);
    CHECK(orbit.leaving == ORBIT_FLIP && orbit_is_stable(&orbit));
    orbit_clear(&orbit);
    CHECK(orbit_find(&orbit, planar_map_cycle(&map), (double[]){1e-7, 1e-7}, 1, NULL) == ORBIT_GOOD);
    CHECK_NEAR(orbit.point[0], 0, 1e-12);
    CHECK_NEAR(orbit.multiplier_re[0], r, 1e-10);
    CHECK(orbit.leaving == ORBIT_FOLD && !orbit_is_stable(&orbit));
    orbit_clear(&orbit);
}

TEST(a_spiral_s_multipliers_are_its_factor_and_turn) {
    const double numbers[] = {0.1, 0.8};
    PlanarMap map = {planar_map_spiral, numbers, 0};
    Orbit orbit;
    CHECK(orbit_find(&orbit, planar_map_cycle(&map), (double[]){1e-7, 0}, 1, NULL) == ORBIT_GOOD);
    CHECK_NEAR(orbit.largest, 0.8, 1e-12);
    CHECK_NEAR(atan2(fabs(orbit.multiplier_im[0]), orbit.multiplier_re[0]), 2 * M_PI * 0.1, 1e-12);
    CHECK(orbit.leaving == ORBIT_NEIMARK);
    orbit_clear(&orbit);
}

/* Henon's attractor with a = 1.4, b = 0.3 has the largest exponent 0.4192; that of the logistic map is ln 2 at r = 4.
 */
TEST(the_exponents_of_known_chaos_come_out) {
    const double henon[] = {1.4, 0.3}, r = 4;
    Response response = respond(&(PlanarMap){planar_map_henon, henon, 0}, 100, 0.1, 0.1);
    CHECK(response.verdict == RESPONSE_CHAOTIC);
    CHECK_NEAR(response.exponent.value, 0.4192, 4 * response.exponent.error);
    response_clear(&response);
    response = respond(&(PlanarMap){planar_map_logistic, &r, 0}, 100, 0.2, 0.2);
    CHECK(response.verdict == RESPONSE_CHAOTIC);
    CHECK_NEAR(response.exponent.value, log(2), 4 * response.exponent.error);
    response_clear(&response);
}

TEST(a_window_of_period_three_is_certified) {
    const double r = 3.835;
    Response response = respond(&(PlanarMap){planar_map_logistic, &r, 0}, 1000, 0.2, 0.2);
    CHECK(response.verdict == RESPONSE_PERIODIC && response.orbit.period == 3 && response.settled);
    response_clear(&response);
}

TEST(a_motion_that_leaves_every_bound_is_said_to_diverge) {
    const double r = 4.5;
    Response response = respond(&(PlanarMap){planar_map_logistic, &r, 1e9}, 100, 0.2, 0.2);
    CHECK(response.verdict == RESPONSE_DIVERGED);
    response_clear(&response);
}

TEST(a_trace_has_the_kind_s_columns_and_as_many_rows_as_samples) {
    const double r = 2.7;
    Response response = respond(&(PlanarMap){planar_map_logistic, &r, 0}, 100, 0.2, 0.2);
    CHECK(response.trace.width == 2 && response.trace.rows == 100);
    CHECK_NEAR(trace_row(&response.trace, 42)[0], 42, 0);
    CHECK_NEAR(trace_row(&response.trace, 42)[1], 1 - 1 / r, 1e-9);
    response_clear(&response);
}
