/* Each line of the input is the NAME=VALUE of a --set, applied to a shipped house and its profile. */
#include <string.h>

#include "base/memory.h"
#include "fuzz.h"
#include "plan/plan.h"
#include "plan/profile.h"

enum { MOST_SETTINGS = 64 };

/* As house_read does. */
static void set_profile(const Plan *plan) {
    static const char name[] = "profile.manual-chair.";
    Profile profile = {0};
    Fault fault = {0};
    fuzz_expect(profile_read(&profile, fuzz_source("assets/profiles/manual-chair.json"), &fault), "a profile is read");
    for (size_t i = 0; i < plan->override_count; i++) {
        const Override *override = &plan->overrides[i];
        if (strncmp(override->name, name, strlen(name)) == 0) {
            bool good = profile_set(&profile, override->name + strlen(name), override->value, override->place, &fault);
            fuzz_expect_faults(good, &fault, "--set ");
        }
    }
    bool fits = profile_check(&profile, plan->run.dt, "place", &fault);
    fuzz_expect_faults(fits, &fault, "place: ");
    profile_free(&profile);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    char *text = memory_zeroed(size + 1, 1);
    const char *settings[MOST_SETTINGS];
    size_t count = 0;
    if (size)
        memcpy(text, data, size);
    for (char *line = text; *line && count < MOST_SETTINGS;) {
        char *end = line + strcspn(line, "\n");
        settings[count++] = line;
        line = end + (*end == '\n');
        *end = 0;
    }
    Plan plan = {0};
    Fault fault = {0};
    bool good = plan_read(&plan, fuzz_source("houses/closed-door.json"), settings, count, &fault);
    fuzz_expect_faults(good, &fault, "");
    if (good)
        set_profile(&plan);
    plan_free(&plan);
    memory_free(text);
    return 0;
}
