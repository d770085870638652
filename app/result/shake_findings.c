#include "result/shake_findings.h"

#include <math.h>
#include <stdlib.h>

#include "base/stop.h"
#include "base/text.h"
#include "house/run.h"
#include "house/shake.h"
#include "experiment/house_experiment.h"

typedef struct Making {
    ShakeFindings *findings;
    const ShakeRecord *record;
} Making;

static bool is_made(const Trial *trial) {
    return trial->done && !trial->fault;
}

/* An observable of all shakes. */
typedef struct Shakes {
    const Study *study;
    size_t observable;
} Shakes;

/* Returns NAN for a shake that is not completed. */
static double observed_at(const void *of, size_t t) {
    const Shakes *shakes = of;
    const Trial *trial = study_nth(shakes->study, t);
    return is_made(trial) ? trial->observed[shakes->observable] : (double)NAN;
}

static size_t count_made(const Study *study) {
    size_t count = 0;
    for (size_t t = 0; t < study->trial_count; t++)
        count += is_made(study_nth(study, t));
    return count;
}

/* Returns how many of them exceed a limit; ignores those that are not numbers. */
static Share share_above(const Making *making, size_t observable, double limit) {
    const Shakes shakes = {making->findings->study, observable};
    size_t good = 0, all = 0;
    for (size_t t = 0; t < shakes.study->trial_count; t++) {
        double value = observed_at(&shakes, t);
        good += value > limit;
        all += !isnan(value);
    }
    return montecarlo_share(good, all);
}

static Distribution distribution(const Making *making, size_t observable) {
    const Shakes shakes = {making->findings->study, observable};
    return montecarlo_of(&(Numbers){observed_at, &shakes, shakes.study->trial_count});
}

static Vec2 middle_of(const Points *area) {
    Box box = box_empty();
    for (size_t i = 0; i < area->count; i++)
        box = box_include(box, area->at[i]);
    return vec2_scale(vec2_add(box.low, box.high), 0.5);
}

static ShakeParty party_of(const Plan *plan, size_t p) {
    if (p < plan->person_count)
        return (ShakeParty){
            .id = plan->people[p].id, .profile = plan->people[p].profile, .people = 1, .at = plan->people[p].at};
    const Crowd *crowd = &plan->crowds[p - plan->person_count];
    return (ShakeParty){
        .id = crowd->id, .profile = crowd->profile, .people = (size_t)crowd->count, .at = middle_of(&crowd->area)};
}

static void add_parties(const Making *making) {
    static const double ALL = 1 - 1e-9; /* 1, of the members */
    ShakeFindings *findings = making->findings;
    const ShakeRecord *record = making->record;
    findings->parties = arena_allocate(&findings->arena, record->party_count * sizeof *findings->parties);
    for (size_t p = 0; p < record->party_count; p++) {
        ShakeParty party = party_of(&findings->house->plan, p);
        party.out = share_above(making, record->out + p, ALL);
        party.members = distribution(making, record->out + p).mean;
        party.observable = record->time + p;
        party.time = distribution(making, party.observable);
        if (party.out.all)
            findings->parties[findings->party_count++] = party;
    }
}

static int compare_pieces(const void *a, const void *b) {
    const ShakePiece *p = a, *q = b;
    if (p->stops.good != q->stops.good)
        return p->stops.good > q->stops.good ? -1 : 1;
    if (p->with_loss != q->with_loss)
        return p->with_loss > q->with_loss ? -1 : 1;
    return p->index < q->index ? -1 : p->index > q->index;
}

static void add_pieces(const Making *making) {
    ShakeFindings *findings = making->findings;
    const Plan *plan = &findings->house->plan;
    const Study *study = findings->study;
    findings->pieces = arena_allocate(&findings->arena, plan->furniture_count * sizeof *findings->pieces);
    for (size_t f = 0; f < plan->furniture_count; f++) {
        ShakePiece piece = {.index = f, .stops = share_above(making, making->record->blocks + f, 0)};
        for (size_t t = 0; t < study->trial_count; t++) {
            const Trial *trial = study_nth(study, t);
            bool fell = is_made(trial) && trial->observed[making->record->toppled + f] > 0;
            piece.toppled += fell;
            piece.with_loss += fell && !(trial->observed[HOUSE_COMPLETED] > 0);
        }
        bool can = shake_can_topple(&plan->furniture[f]) && plan->furniture[f].probability > 0;
        findings->toppling += can;
        if (can || piece.stops.good)
            findings->pieces[findings->piece_count++] = piece;
    }
    qsort(findings->pieces, findings->piece_count, sizeof *findings->pieces, compare_pieces);
}

/* Prints the settings that leave the furniture as it lies after that shake. */
static const char *made_by(const Making *making, const Trial *trial, Arena *arena) {
    const Plan *plan = &making->findings->house->plan;
    bool *topples = arena_allocate(arena, plan->furniture_count * sizeof *topples);
    const char **settings = arena_allocate(arena, plan->furniture_count * sizeof *settings);
    for (size_t f = 0; f < plan->furniture_count; f++)
        topples[f] = trial->observed[making->record->toppled + f] > 0;
    size_t count = trial->observed[making->record->caught] > 0 ? 0 : shake_settings(plan, topples, settings, arena);
    const char *text = "";
    for (size_t s = 0; s < count; s++)
        text = text_in_arena(arena, "%s%s--set %s", text, s ? " " : "", settings[s]);
    return text;
}

static void find_worst(const Making *making) {
    ShakeFindings *findings = making->findings;
    for (size_t t = 0; t < findings->study->trial_count; t++) {
        const Trial *trial = study_nth(findings->study, t);
        double least = findings->worst ? findings->worst->observed[HOUSE_NOT_OUT] : 0;
        if (is_made(trial) && trial->observed[HOUSE_NOT_OUT] > least)
            findings->worst = trial;
    }
    findings->made_by = findings->worst ? made_by(making, findings->worst, &findings->arena) : "";
}

ShakeFindings shake_findings_make(const Study *study) {
    ShakeFindings findings = {
        .study = study, .house = house_experiment_house(study->experiment), .calm_time = (double)NAN};
    Making making = {&findings, house_experiment_shake(study->experiment)};
    findings.shakes = count_made(study);
    findings.all_out = share_above(&making, HOUSE_COMPLETED, 0);
    findings.caught = share_above(&making, making.record->caught, 0);
    findings.elsewhere = share_above(&making, making.record->elsewhere, 0);
    findings.time = distribution(&making, HOUSE_TIME);
    add_parties(&making);
    add_pieces(&making);
    find_worst(&making);
    return findings;
}

void shake_findings_free(ShakeFindings *findings) {
    arena_clear(&findings->arena);
    *findings = (ShakeFindings){0};
}

void shake_findings_run_calm(ShakeFindings *findings, size_t route, int jobs, const Stop *stop) {
    Observation observation;
    run_house(&observation, findings->house, &(RunOptions){.route = route, .jobs = jobs, .stop = stop});
    if (observation.interrupted) {
        findings->calm = SHAKE_CALM_INTERRUPTED;
    } else {
        findings->calm = observation.completed ? SHAKE_CALM_OUT : SHAKE_CALM_NOT_OUT;
        findings->calm_time = observation.time;
    }
    observation_free(&observation);
}

const char *shake_findings_headline(const ShakeFindings *findings, Arena *arena) {
    const Share *share = &findings->all_out;
    bool single = findings->party_count == 1 && findings->parties[0].people == 1, always = share->good == share->all;
    const char *id = single ? findings->parties[0].id : "";
    if (!findings->shakes)
        return "No shake was simulated";
    if (single && always)
        return text_in_arena(arena, share->all == 1 ? "%s is out in %zu shake" : "%s is out in all %zu shakes", id,
                             share->all);
    if (single)
        return text_in_arena(arena, "%s is out in %zu of %zu shakes", id, share->good, share->all);
    if (always)
        return text_in_arena(
            arena, share->all == 1 ? "All people are out in %zu shake" : "All people are out in all %zu shakes",
            share->all);
    return text_in_arena(arena, "All people are out in %zu of %zu shakes", share->good, share->all);
}

const char *shake_findings_times(const ShakeFindings *findings, Arena *arena) {
    const Distribution *time = &findings->time;
    bool out = findings->calm == SHAKE_CALM_OUT, known = out || findings->calm == SHAKE_CALM_NOT_OUT;
    if (!time->count && !known)
        return "";
    if (!time->count)
        return out ? text_in_arena(arena, "without a shake %.1f s", findings->calm_time)
                   : "without a shake not all people are out either";
    if (!known)
        return text_in_arena(arena, "half of them within %.1f s, 95 %% within %.1f s", time->median, time->high);
    return out ? text_in_arena(arena, "half of them within %.1f s, 95 %% within %.1f s; without a shake %.1f s",
                               time->median, time->high, findings->calm_time)
               : text_in_arena(
                     arena, "half of them within %.1f s, 95 %% within %.1f s; without a shake not all people are out",
                     time->median, time->high);
}
