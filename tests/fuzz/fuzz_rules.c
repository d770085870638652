/* The input is a file of rules. */
#include "fuzz.h"
#include "rules/rule_set.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    const char *path = fuzz_file(data, size);
    RuleSets sets = {0};
    Fault fault = {0};
    bool good = rule_set_read(&sets, path, &fault);
    fuzz_expect_faults(good, &fault, path);
    fuzz_expect(sets.count == good, "a bad file adds no set");
    for (size_t r = 0; good && r < sets.sets[0].count; r++) {
        const Rule *rule = &sets.sets[0].rules[r];
        fuzz_expect((rule->least >= 0) != (rule->most >= 0), "a rule has one limit");
        fuzz_expect(*rule_set_what_name(rule->what) && *rule_set_status_name(rule->status), "its words are known");
    }
    rule_set_free_all(&sets);
    return 0;
}
