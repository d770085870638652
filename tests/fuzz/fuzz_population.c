/* The input is a population file: read, and drawn from. */
#include "fuzz.h"
#include "plan/population.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    const char *path = fuzz_file(data, size);
    Population population = {0};
    Fault fault = {0};
    bool good = population_read(&population, path, &fault);
    fuzz_expect_faults(good, &fault, path);
    for (size_t k = 0; good && k < 20; k++) {
        Profile profile = {.width = 0.63, .length = 1.1};
        population_draw(&population, k, 1, &profile);
        fuzz_expect(profile.width >= 0.1 && profile.length <= 3, "a drawn number is in its range");
    }
    population_free(&population);
    return 0;
}
