/* The input is a house file: its people plan and move for some steps, and a copy of the world moves alike. */
#include <math.h>

#include "fuzz_house.h"
#include "house/step.h"
#include "house/world.h"

enum { STEPS = 200 };
static const double SPEED_MOST = 20; /* m/s, of people who were clear of everything at the start */

static bool all_clear(const World *world) {
    for (size_t i = 0; i < world->count; i++)
        if (!world->was_clear[i])
            return false;
    return true;
}

static void check_people(const World *world, bool clear) {
    for (size_t i = 0; i < world->count; i++) {
        fuzz_expect(fuzz_house_is_finite(world->centre[i]) && fuzz_house_is_finite(world->velocity[i]) &&
                        isfinite(world->heading[i]) && isfinite(world->turn[i]),
                    "a state is finite");
        fuzz_expect(fabs(vec2_length(world->axis[i]) - 1) < 1e-9, "a heading is a unit vector");
        if (world->phase[i] == PHASE_MOVING || world->phase[i] == PHASE_WAITING)
            fuzz_expect(world_holds(world, world->centre[i]), "a person who moves is in the house");
        if (clear)
            fuzz_expect(vec2_length(world->velocity[i]) < SPEED_MOST, "no person gains energy");
    }
    if (clear)
        fuzz_expect(world->wall_crossings == 0, "no person passes through a wall");
}

static void move(const House *house, const Journeys *journeys) {
    World world = world_create(house, journeys->of, NULL), other = {0};
    bool clear = all_clear(&world), diverged = false;
    for (int step = 0; step < STEPS && !diverged; step++) {
        size_t who = SIZE_MAX;
        if (step == STEPS / 2)
            other = world_copy(&world);
        diverged = step_world(&world, &who) == STEP_DIVERGED;
        fuzz_expect(diverged == (who != SIZE_MAX), "the person who diverges is named");
        fuzz_expect(!diverged || !clear, "a run diverges only if a person overlapped something at its start");
        check_people(&world, clear);
        if (step >= STEPS / 2) {
            fuzz_expect((step_world(&other, NULL) == STEP_DIVERGED) == diverged, "a copy moves alike");
            fuzz_expect(other.digest == world.digest, "a copy has the same bits");
        }
    }
    world_destroy(&world);
    if (other.block)
        world_destroy(&other);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    House house;
    if (!fuzz_house_read(&house, data, size))
        return 0;
    Stop stop = {0};
    Journeys journeys = fuzz_house_plan(&house, &stop);
    if (!stop.requested)
        move(&house, &journeys);
    journey_free_all(&journeys);
    house_free(&house);
    return 0;
}
