/* The line at the foot of a plot, on plans written by hand and on beams and cranks whose sources are set here. */
#include "check.h"

#include <string.h>

#include "result/source_line.h"

TEST(a_plan_says_that_it_is_assumed_once) {
    Arena arena = {0};
    Plan plan = {.name = "Our flat", .note = "Measured in 2024."};
    CHECK(strcmp(source_line_house(&plan, &arena), "Our flat") == 0);
    plan.note = "An assumed plan.";
    CHECK(strcmp(source_line_house(&plan, &arena), "Our flat: assumed plan, not measured") == 0);
    plan.name = "Our flat (assumed)";
    CHECK(strcmp(source_line_house(&plan, &arena), "Our flat (assumed): not measured") == 0);
    plan.name = "";
    CHECK(strcmp(source_line_house(&plan, &arena), "house: assumed plan, not measured") == 0);
    arena_clear(&arena);
}

TEST(numbers_are_counted_by_where_they_come_from) {
    Arena arena = {0};
    Crank crank = {.name = "ssc"};
    for (size_t i = 0; i < CRANK_VALUES; i++)
        crank.provenance[i] = "assumed: steel";
    const char *all = source_line_crank(&crank, &arena);
    size_t numbers = 0;
    CHECK(sscanf(all, "ssc: all %zu numbers assumed", &numbers) == 1 && numbers > 30);
    crank.provenance[0] = "assumed: set for this run";
    crank.provenance[1] = "paper";
    char wanted[100];
    snprintf(wanted, sizeof wanted, "ssc: of %zu numbers 1 from the paper, 1 set for this run, %zu assumed", numbers,
             numbers - 2);
    CHECK(strcmp(source_line_crank(&crank, &arena), wanted) == 0);
    arena_clear(&arena);
}
