#include "fuzz_house.h"

#include <math.h>
#include <signal.h>
#include <string.h>
#include <sys/time.h>

#include "base/memory.h"

enum { PEOPLE_MOST = 12, WALLS_MOST = 200, WORK_MOST = 500000 /* us */ };
static const double CELLS_MOST = 1e5; /* 1, of the grid */

static Stop *planning; /* the planning that is to end */

static void end_planning(int number) {
    (void)number;
    stop_request(planning);
}

static void extend(Box *box, Vec2 at, double margin) {
    box->low = vec2(fmin(box->low.x, at.x - margin), fmin(box->low.y, at.y - margin));
    box->high = vec2(fmax(box->high.x, at.x + margin), fmax(box->high.y, at.y + margin));
}

/* True if planning this house takes little memory and time. */
static bool is_small(const Plan *plan) {
    size_t people = plan->person_count, points = 0;
    Box box = {{INFINITY, INFINITY}, {-INFINITY, -INFINITY}};
    for (size_t c = 0; c < plan->crowd_count; c++)
        people += (size_t)plan->crowds[c].count;
    for (size_t w = 0; w < plan->wall_count; w++)
        for (size_t p = 0; p < plan->walls[w].points.count; p++, points++)
            extend(&box, plan->walls[w].points.at[p], plan->walls[w].thickness);
    for (size_t f = 0; f < plan->furniture_count; f++)
        extend(&box, plan->furniture[f].centre, vec2_length(plan->furniture[f].size));
    for (size_t p = 0; p < plan->person_count; p++)
        extend(&box, plan->people[p].at, 0);
    Vec2 size = vec2_sub(box.high, box.low);
    double cell = plan->run.cell, more = 2 * FREESPACE_MARGIN;
    return people > 0 && people <= PEOPLE_MOST && points <= WALLS_MOST && plan->furniture_count <= WALLS_MOST &&
           (size.x + more) * (size.y + more) / (cell * cell) < CELLS_MOST;
}

bool fuzz_house_read(House *house, const uint8_t *data, size_t size) {
    Plan plan = {0};
    Fault fault = {0};
    char *text = memory_zeroed(size + 1, 1);
    if (size)
        memcpy(text, data, size);
    bool good = plan_read_text(&plan, "/house.json", text, NULL, 0, &fault);
    fault_clear(&fault);
    good = good && is_small(&plan);
    plan_free(&plan);
    *house = (House){.seed = 0};
    if (good) {
        HouseOptions options = {.profiles = fuzz_source("assets/profiles"), .seed = 1, .driving = -1};
        good = house_read_text(house, "/house.json", text, &options, &fault);
        fuzz_expect_faults(good, &fault, "");
    }
    memory_free(text);
    return good;
}

Journeys fuzz_house_plan(const House *house, Stop *stop) {
    struct itimerval limit = {.it_value = {0, WORK_MOST}}, none = {.it_value = {0, 0}};
    planning = stop;
    signal(SIGVTALRM, end_planning);
    setitimer(ITIMER_VIRTUAL, &limit, NULL);
    Journeys journeys = journey_plan_all(house, NULL, 1, stop);
    setitimer(ITIMER_VIRTUAL, &none, NULL);
    return journeys;
}

bool fuzz_house_is_finite(Vec2 at) {
    return isfinite(at.x) && isfinite(at.y);
}
