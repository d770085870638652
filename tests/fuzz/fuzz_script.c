/* The input is a script for the window. */
#include <math.h>

#include "fuzz.h"
#include "window/script.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    const char *path = fuzz_file(data, size);
    Script script = {.count = 0};
    Fault fault = {0};
    bool good = script_read(&script, path, &fault);
    fuzz_expect_faults(good, &fault, path);
    int line = 0;
    json_t *state = json_pack("{s:[i, {s:s}], s:b}", "a", 1, "b", "c", "d", 1);
    for (const ScriptCommand *command; (command = script_next(&script));) {
        fuzz_expect(command->line > line, "a line has one command");
        line = command->line;
        for (int i = 0; i < SCRIPT_NUMBERS; i++)
            fuzz_expect(!isinf(command->numbers[i]), "a number is one");
        if (command->kind == SCRIPT_EXPECT) {
            bool holds = script_expect(&script, command, state, &fault);
            fuzz_expect_faults(holds, &fault, path);
        }
    }
    json_decref(state);
    script_free(&script);
    return 0;
}
