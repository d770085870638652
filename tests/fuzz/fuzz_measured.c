/* The input is a CSV file of measured points. */
#include <math.h>

#include "exchange/measured.h"
#include "fuzz.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    static const MeasuredKind kinds[] = {{"drive.frequency", NULL, "Hz"},
                                         {"peak_max", NULL, "N"},
                                         {"deflection", "displacement", "m"},
                                         {"time", "t", "s"}};
    const char *path = fuzz_file(data, size);
    Measured measured = {0};
    Fault fault = {0};
    bool good = measured_read(&measured, path, kinds, sizeof kinds / sizeof *kinds, &fault);
    fuzz_expect_faults(good, &fault, path);
    fuzz_expect(!good || (measured.column_count >= 2 && measured.count), "two columns of something were measured");
    for (size_t c = 0; c < measured.column_count; c++) {
        const double *values = measured_find(&measured, measured.columns[c].name);
        fuzz_expect(values == measured.columns[c].values, "a column is found by its name");
        for (size_t i = 0; i < measured.count; i++)
            fuzz_expect(isnan(values[i]) || isfinite(values[i]), "a number is one");
    }
    measured_free(&measured);
    return 0;
}
