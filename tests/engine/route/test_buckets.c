/* Tests that every point which is put into the buckets comes out once, and none before a point of an earlier bucket,
 * also while others are put in. */
#include "check.h"

#include "base/random.h"
#include "route/buckets.h"

enum { POINTS = 20000, AT_FIRST = 50 };

#define WIDTH 0.013f /* s */
#define SPAN 0.9     /* s */

TEST(points_come_in_the_order_of_their_buckets) {
    Buckets buckets = buckets_make((double)WIDTH, SPAN);
    Random random = random_seed(1, 0);
    float *times = memory_zeroed(POINTS, sizeof *times), now = 0;
    bool *taken = memory_zeroed(POINTS, sizeof *taken);
    int put = 0, count = 0;
    for (; put < AT_FIRST; put++)
        buckets_put(&buckets, put, times[put] = (float)(SPAN * random_uniform(&random)));
    for (size_t number = 0; buckets.held > 0; number++) {
        BucketEntry entry;
        while (buckets_take(&buckets, number, &entry)) {
            float time = times[entry.point];
            CHECK(!taken[entry.point] && entry.time <= time && entry.time >= time);
            CHECK(buckets_number(&buckets, time) == number && time > now - WIDTH);
            taken[entry.point] = true;
            now = time;
            count++;
            for (int more = 0; more < 2 && put < POINTS; more++, put++)
                buckets_put(&buckets, put, times[put] = time + (float)(SPAN * random_uniform(&random)));
        }
    }
    CHECK(count == POINTS);
    memory_free(times);
    memory_free(taken);
    buckets_clear(&buckets);
}

TEST(a_time_before_the_first_is_in_the_first_bucket) {
    Buckets buckets = buckets_make(0.1, 1);
    CHECK(buckets_number(&buckets, -3) == 0 && buckets_number(&buckets, 0.05f) == 0);
    CHECK(buckets_number(&buckets, 0.25f) == 2);
    buckets_clear(&buckets);
}
