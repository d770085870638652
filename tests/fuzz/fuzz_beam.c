/* The input is a beam file: it is read, and its modes are computed. */
#include <math.h>

#include "beam/modes.h"
#include "fuzz.h"

/* Larger models take too long for fuzzing. */
enum { ELEMENTS_MOST = 40 };

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    const char *path = fuzz_file(data, size);
    Beam beam = {0};
    Fault fault = {0};
    bool good = beam_read(&beam, path, NULL, 0, &fault);
    fuzz_expect_faults(good, &fault, path);
    fuzz_expect(!good || beam_is_file(path), "what is read as a beam is one");
    for (size_t i = 0; good && i < beam_table()->count; i++)
        fuzz_expect(beam.provenance[i], "a number has its provenance");
    Modes modes;
    if (good && beam.elements <= ELEMENTS_MOST && modes_of_beam(&modes, &beam)) {
        for (size_t i = 0; i < modes.count; i++)
            fuzz_expect(isfinite(modes.tip[i]) && modes.frequency[i] >= modes.frequency[i ? i - 1 : 0],
                        "natural frequencies rise");
        modes_clear(&modes);
    }
    beam_free(&beam);
    return 0;
}
