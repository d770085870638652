/* The input is a profile file: read, and checked against several steps. */
#include "fuzz.h"
#include "plan/profile.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    const char *path = fuzz_file(data, size);
    Profile profile = {0};
    Fault fault = {0};
    bool good = profile_read(&profile, path, &fault);
    fuzz_expect_faults(good, &fault, path);
    for (double dt = 1e-6; good && dt <= 0.1; dt *= 10) {
        bool fits = profile_check(&profile, dt, "profile p", &fault);
        fuzz_expect_faults(fits, &fault, "profile p: ");
    }
    if (good)
        for (size_t i = 0; i < profile_table()->count; i++)
            fuzz_expect(profile.provenance[i] || !profile_row_matters(i, profile.driving),
                        "a number has its provenance");
    profile_free(&profile);
    return 0;
}
