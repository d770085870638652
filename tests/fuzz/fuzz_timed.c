/* The input is a table of measured times. */
#include "exchange/timed.h"
#include "fuzz.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    const char *path = fuzz_file(data, size);
    Timed timed = {0};
    Fault fault = {0};
    bool good = timed_read(&timed, path, &fault);
    fuzz_expect_faults(good, &fault, path);
    fuzz_expect(good == (timed.count > 0), "a good table has runs");
    for (size_t i = 0; i < timed.count; i++)
        fuzz_expect(*timed.runs[i].route && timed.runs[i].time > 0, "a run has a route and a time");
    timed_free(&timed);
    return 0;
}
