#include "laboratory/house/crew.h"

#include "base/digest.h"
#include "house/run.h"
#include "laboratory/shipped_population.h"
#include "result/drivers.h"
#include "visual/house/drivers_band.h"
#include "visual/house/drivers_scene.h"

enum { FEW = 10, USUAL = 100 };

size_t crew_size(int step, const Plan *plan) {
    size_t all = plan->drivers.count ? (size_t)plan->drivers.count : USUAL;
    return step == CREW_STEPS - 1 ? all : all < FEW ? all : FEW;
}

uint64_t crew_digest(const Drivers *drivers) {
    uint64_t digest = DIGEST_START;
    for (size_t r = 0; r < drivers->count * drivers->person_count; r++) {
        const DriverRun *run = &drivers->runs[r];
        const double numbers[] = {run->varies, run->completed, run->time, run->contacts, run->impact, run->energy};
        digest = digest_bytes(digest, numbers, sizeof numbers);
    }
    return digest;
}

/* Draws what the drivers do, and says it. */
static void show(Crew *crew, const House *house, const Drivers *drivers, const Trace *nominal) {
    crew->count = drivers->count;
    crew->digest = crew_digest(drivers);
    crew->person_count = drivers->person_count;
    drivers_band_add(&crew->scene, drivers, nominal);
    drivers_scene_add(&crew->scene, house, drivers);
    crew->said = memory_zeroed(drivers->person_count, sizeof *crew->said);
    for (size_t i = 0; i < drivers->person_count; i++)
        crew->said[i] = result_drivers_brief(house, drivers, i, &crew->scene.arena);
}

bool crew_make(Crew *crew, int step, const House *house, size_t route, int jobs, const Stop *stop, Fault *fault) {
    Population population = {0};
    *crew = (Crew){0};
    if (!shipped_population_read(&population, &house->plan.drivers, house->plan.path, fault))
        return false;
    Observation nominal = {0};
    Drivers drivers = {0};
    run_house(&nominal, house, &(RunOptions){.route = route, .jobs = jobs, .stop = stop, .brief = true});
    if (!nominal.interrupted)
        drivers_run(&drivers, house, &population, crew_size(step, &house->plan), route, jobs, stop);
    bool done = !nominal.interrupted && !drivers.interrupted;
    if (done)
        show(crew, house, &drivers, &nominal.trace);
    drivers_free(&drivers);
    observation_free(&nominal);
    population_free(&population);
    return done;
}

void crew_clear(Crew *crew) {
    scene_clear(&crew->scene);
    memory_free(crew->said);
    *crew = (Crew){0};
}
