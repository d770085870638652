#include <math.h>

#include "base/memory.h"
#include "base/random.h"
#include "check.h"
#include "cycle/response.h"
#include "planar_map.h"

/* Half-lives ---------------------------------------------------------------------------------------------------------
 */

/* Half of the tabled quantiles of chi-squared with 2, 10 and 40 degrees. */
TEST(quantiles_of_the_gamma_distribution_are_those_of_tables) {
    CHECK_NEAR(half_life_gamma(1, 0.95), 5.99146 / 2, 1e-5);
    CHECK_NEAR(half_life_gamma(5, 0.025), 3.24697 / 2, 1e-5);
    CHECK_NEAR(half_life_gamma(5, 0.975), 20.48318 / 2, 1e-5);
    CHECK_NEAR(half_life_gamma(20, 0.025), 24.43304 / 2, 1e-5);
}

/* Motions that leave at a known rate and are watched for a limited time. */
TEST(the_interval_of_a_half_life_holds_the_true_one_in_about_95_of_100) {
    enum { TRIALS = 1000, LANES = 64 };
    const double rate = 1 / 1500., most = 2000;
    Random random = random_seed(7, 0);
    int inside = 0;
    for (int trial = 0; trial < TRIALS; trial++) {
        double risk = 0;
        size_t settled = 0;
        for (int lane = 0; lane < LANES; lane++) {
            double leaves = -log(1 - random_uniform(&random)) / rate;
            settled += leaves < most;
            risk += fmin(leaves, most);
        }
        HalfLife half = half_life_tell(settled, risk);
        inside += half.low <= log(2) / rate && log(2) / rate <= half.high;
    }
    CHECK(inside >= 930 && inside <= 985);
}

TEST(without_one_that_settles_the_half_life_has_a_lower_bound_only) {
    HalfLife half = half_life_tell(0, 64. * 20000);
    CHECK(isinf(half.value) && isinf(half.high));
    CHECK_NEAR(half.low, log(2) * 64 * 20000 / 2.99573, 10);
}

/* With 59 starts one of a share of 5 % is seen with 95 %. */
TEST(unseen_basins_are_below_three_by_the_starts) {
    CHECK_NEAR(half_life_unseen(300), 3. / 300, 1e-4);
    CHECK_NEAR(half_life_starts(0.05), 59, 0);
}

/* Extremes -----------------------------------------------------------------------------------------------------------
 */

/* The largest of a million of exponentially distributed numbers is about ln 1e6, of uniform ones about 1. */
TEST(the_largest_of_a_million_is_extrapolated_from_thousands) {
    enum { LISTS = 32, EACH = 2000 };
    double *peak = memory_zeroed(LISTS * EACH, sizeof *peak);
    size_t used[LISTS];
    Random random = random_seed(3, 0);
    for (size_t i = 0; i < LISTS * EACH; i++)
        peak[i] = -log(1 - random_uniform(&random));
    for (size_t i = 0; i < LISTS; i++)
        used[i] = EACH;
    Extreme extreme = extreme_estimate(peak, LISTS, EACH, used, 1e6);
    CHECK(extreme.known && extreme.low < log(1e6) && extreme.high > log(1e6));
    CHECK_NEAR(extreme.shape, 0, 0.1);
    for (size_t i = 0; i < LISTS * EACH; i++)
        peak[i] = random_uniform(&random);
    extreme = extreme_estimate(peak, LISTS, EACH, used, 1e6);
    CHECK(extreme.known && fabs(extreme.level - 1) < 3e-3 && fabs(extreme.end - 1) < 3e-3);
    CHECK_NEAR(extreme.shape, -1, 0.1);
    memory_free(peak);
}

/* Shapes -------------------------------------------------------------------------------------------------------------
 */

static Response respond(const PlanarMap *map, double x, double y) {
    Response response;
    response_run(&response, planar_map_cycle(map), 500, 100, (double[]){x, y}, NULL);
    return response;
}

TEST(a_ring_is_gone_round_at_its_rotation_number) {
    const double golden = (3 - sqrt(5)) / 2, numbers[] = {golden, 0.2};
    PlanarMap map = {planar_map_ring, numbers, 0};
    Response response = respond(&map, 0.5, 0.1);
    CHECK(response.verdict == RESPONSE_QUASI_PERIODIC && response.bands == 1);
    CHECK_NEAR(response.rotation.value, golden, 1e-9);
    CHECK_NEAR(response.exponent.value, 0, 1e-3);
    CHECK_NEAR(response.second.value, log(1 - 2 * 0.2), 1e-3);
    response_clear(&response);
}

/* Two bands join into one at r = 3.6786, four into two at 3.5926 (Misiurewicz points). */
TEST(bands_of_chaos_are_counted) {
    static const double r[] = {3.58, 3.62, 3.7, 4};
    static const size_t bands[] = {4, 2, 1, 1};
    for (int i = 0; i < 4; i++) {
        Response response = respond(&(PlanarMap){planar_map_logistic, &r[i], 0}, 0.3, 0.3);
        CHECK(response.verdict == RESPONSE_CHAOTIC && response.bands == bands[i]);
        CHECK(response_is_quick(&response));
        response_clear(&response);
    }
}

/* Survival -----------------------------------------------------------------------------------------------------------
 */

static const SurvivalTask few = {32, 3000, 2, NULL};

TEST(chaos_that_lasts_is_confirmed_with_any_number_of_threads) {
    const double r = 4;
    PlanarMap map = {planar_map_logistic, &r, 0};
    Response response = respond(&map, 0.3, 0.3);
    response_confirm(&response, planar_map_cycle(&map), &few);
    CHECK(response.verdict == RESPONSE_CHAOTIC && response.survival.settled == 0 && !response_is_quick(&response));
    CHECK(response.survival.largest > 0.9999 && response.survival.largest <= 1);
    CHECK(response.survival.within[0].reached == 32 && response.survival.within[0].median < 20);
    SurvivalTask alone = few;
    alone.jobs = 1;
    Survival again = survival_run(planar_map_cycle(&map), &response.analysed, &alone);
    CHECK(again.largest == response.survival.largest && again.extreme.level == response.survival.extreme.level);
    response_clear(&response);
}

/* In the window of period 3, states of chaos beyond it settle. */
TEST(lanes_on_a_transient_settle_on_its_orbit) {
    const double chaos = 3.87, stable = 3.84;
    PlanarMap map = {planar_map_logistic, &stable, 0};
    Response before = respond(&(PlanarMap){planar_map_logistic, &chaos, 0}, 0.3, 0.3);
    CHECK(before.verdict == RESPONSE_CHAOTIC);
    Survival survival = survival_run(planar_map_cycle(&map), &before.analysed, &few);
    CHECK(survival.settled == 32 && survival.attractor_count == 1 && survival.attractors[0].period == 3);
    CHECK(survival.attractors[0].lanes == 32 && survival.attractors[0].largest < 1);
    response_clear(&before);
}

TEST(an_interrupted_confirmation_leaves_the_quick_verdict) {
    const double r = 4;
    Stop stop = {0};
    PlanarMap map = {planar_map_logistic, &r, 0};
    Response response = respond(&map, 0.3, 0.3);
    stop_request(&stop);
    response_confirm(&response, planar_map_cycle(&map), &(SurvivalTask){32, 3000, 2, &stop});
    CHECK(response.verdict == RESPONSE_CHAOTIC && response_is_quick(&response));
    response_clear(&response);
}
