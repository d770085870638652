#include <stdio.h>
#include <string.h>

#include "beam/beam.h"
#include "command/answer.h"
#include "command/command.h"
#include "crank/crank.h"
#include "plan/plan.h"
#include "plan/profile.h"
#include "rules/rule_set.h"

int command_schema(const Options *options) {
    const char *kind = options->files[0];
    if (strcmp(kind, "house") == 0) {
        answer_print(plan_schema());
    } else if (strcmp(kind, "profile") == 0) {
        answer_print(profile_schema());
    } else if (strcmp(kind, "beam") == 0) {
        answer_print(beam_schema());
    } else if (strcmp(kind, "crank") == 0) {
        answer_print(crank_schema());
    } else if (strcmp(kind, "rules") == 0) {
        answer_print(rule_set_schema());
    } else {
        fprintf(stderr, "clearance: there are schemas of house, profile, beam, crank and rules, not of \"%s\"\n", kind);
        return EXIT_WRONG_INPUT;
    }
    return EXIT_ANSWERED;
}
