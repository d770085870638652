/* The input is a crank file: it is read, and some steps of its motion are taken. */
#include <math.h>

#include "crank/turn.h"
#include "fuzz.h"

enum { STEPS = 40 };

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    const char *path = fuzz_file(data, size);
    Crank crank = {0};
    Fault fault = {0};
    bool good = crank_read(&crank, path, NULL, 0, &fault);
    fuzz_expect_faults(good, &fault, path);
    fuzz_expect(!good || crank_is_file(path), "what is read as a crank is one");
    for (size_t i = 0; good && i < crank_table()->count; i++)
        fuzz_expect(crank.provenance[i], "a number has its provenance");
    if (good) {
        Tree tree = tree_of(&crank);
        Turn turn = turn_create(&tree, TURN_QUICK);
        for (int i = 0; i < STEPS && turn.status == CYCLE_GOOD; i++)
            fuzz_expect(turn_step(&turn, HUGE_VAL) >= 0, "time goes on");
        fuzz_expect(turn.status != CYCLE_GOOD || isfinite(turn.state[0]), "a good turn is finite");
    }
    crank_free(&crank);
    return 0;
}
