/* The input is a CSV file of observed loci. */
#include "exchange/observed.h"
#include "fuzz.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    const char *path = fuzz_file(data, size);
    ObservedLoci loci = {0};
    Fault fault = {0};
    bool good = observed_read(&loci, path, &fault);
    fuzz_expect_faults(good, &fault, path);
    fuzz_expect(!good || loci.count, "somebody was observed");
    for (size_t i = 0; i < loci.count; i++) {
        const Locus *locus = &loci.loci[i].locus;
        fuzz_expect(locus->count >= 2, "a locus has two places");
        for (size_t p = 0; p < locus->count; p++) {
            fuzz_expect(isfinite(locus->points[p].x + locus->points[p].y), "a place is somewhere");
            fuzz_expect(!p || locus->times[p] > locus->times[p - 1], "time goes on");
        }
        LocusDistance apart = locus_distance(locus, &loci.loci[0].locus);
        fuzz_expect(apart.mean <= apart.largest + 1e-6, "a mean is at most the largest");
        fuzz_expect(i || apart.largest < 1e-6, "a locus is not apart from itself");
    }
    observed_free(&loci);
    return 0;
}
