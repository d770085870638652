#include "command/shake_words.h"

#include <inttypes.h>
#include <stdio.h>

#include "result/study_number.h"

enum { ROWS_MOST = 20 };

static void print_title(const ShakeFindings *findings, const char *file) {
    const Study *study = findings->study;
    printf(study->runs == 1 ? "%s: %zu shake from seed %" PRIu64 " on" : "%s: %zu shakes from seed %" PRIu64 " on",
           file, study->runs, study->seed);
    if (findings->shakes < study->runs)
        printf(", %zu of them simulated", findings->shakes);
    printf("\n");
}

static void print_answer(const ShakeFindings *findings) {
    Arena arena = {0};
    const Share *share = &findings->everybody;
    const char *times = shake_findings_times(findings, &arena);
    printf("%s", shake_findings_headline(findings, &arena));
    if (share->all)
        printf(": %.1f %%, with 95 %% confidence from %.1f to %.1f %%", 100 * share->value, 100 * share->low,
               100 * share->high);
    printf("%s%s\n", *times ? "; " : "", times);
    if (findings->caught.good)
        printf("in %zu of them something falls on somebody, who then does not get out\n", findings->caught.good);
    if (findings->elsewhere.good)
        printf("in %zu of them somebody is stopped by a wall, a door or other people\n", findings->elsewhere.good);
    arena_clear(&arena);
}

static void print_number(double number) {
    char word[STUDY_NUMBER];
    study_number_observed(number, word);
    printf(" %8s", word);
}

static void print_people(const ShakeFindings *findings) {
    printf("\n%-16s %-16s %9s %15s %8s %8s %8s %8s\n", "person", "profile", "out in", "95 % sure", "25 % s", "median s",
           "75 % s", "95 % s");
    for (size_t p = 0; p < findings->party_count && p < ROWS_MOST; p++) {
        const ShakeParty *party = &findings->parties[p];
        char sure[32];
        snprintf(sure, sizeof sure, "%.0f to %.0f %%", 100 * party->out.low, 100 * party->out.high);
        printf("%-16s %-16s %7.1f %% %15s", party->id, party->profile, 100 * party->out.value, sure);
        print_number(party->time.quarters[0]);
        print_number(party->time.median);
        print_number(party->time.quarters[1]);
        print_number(party->time.high);
        if (party->people > 1)
            printf("  all %zu of them; on average %.1f %% of them", party->people, 100 * party->members);
        printf("\n");
    }
    if (findings->party_count > ROWS_MOST)
        printf("and %zu more\n", findings->party_count - ROWS_MOST);
}

static void print_pieces(const ShakeFindings *findings) {
    if (!findings->piece_count || !findings->shakes)
        return;
    printf("\n%-28s %9s %15s %20s\n", "furniture", "falls in", "stops people in", "fell, not all out in");
    for (size_t p = 0; p < findings->piece_count && p < ROWS_MOST; p++) {
        const ShakePiece *piece = &findings->pieces[p];
        char name[96];
        outline_name(&findings->house->plan, OWNER_FURNITURE, (int)piece->index, name, sizeof name);
        printf("%-28s %7.1f %% %13.1f %% %20zu\n", name, 100 * (double)piece->toppled / (double)findings->shakes,
               100 * piece->stops.value, piece->with_loss);
    }
    if (findings->piece_count > ROWS_MOST)
        printf("and %zu more\n", findings->piece_count - ROWS_MOST);
}

static void print_faults(const ShakeFindings *findings) {
    const Study *study = findings->study;
    size_t faults = 0;
    const char *first = NULL;
    for (size_t t = 0; t < study->trial_count; t++) {
        faults += study->trials[t].fault != NULL;
        first = first ? first : study->trials[t].fault;
    }
    if (faults)
        printf(faults == 1 ? "\n%zu shake could not be simulated: %s\n"
                           : "\n%zu shakes could not be simulated; the first: %s\n",
               faults, first);
}

void shake_words_print(const ShakeFindings *findings, const char *file) {
    print_title(findings, file);
    if (!findings->toppling)
        printf("nothing in this house can fall: all shakes are alike\n");
    print_answer(findings);
    print_people(findings);
    print_pieces(findings);
    if (findings->worst)
        printf("\nfewest get out in the shake with seed %" PRIu64 "%s%s\n", findings->worst->seed,
               *findings->made_by ? ": clearance run HOUSE " : "", findings->made_by);
    print_faults(findings);
}
